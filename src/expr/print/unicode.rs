//! Formulas on one line of a terminal: `16√3/9`, `tan²θ`, `v₁ ≤ 2u`.

use super::layout::{Item, Row, layout};
use super::letter::{Letter, Symbol};
use super::unit::unit_unicode;
use super::words::words_unicode;
use crate::expr::{Expr, Function, Relation};

/// The formula in one line of characters.
///
/// ```
/// use carom::expr::{Expr, Function, print};
/// let root = Expr::call(Function::Sqrt, Expr::integer(3));
/// let size = Expr::product([Expr::integer(16), root]).over(Expr::integer(9));
/// assert_eq!(print::unicode(&size), "16√3/9");
/// ```
pub fn unicode(expr: &Expr) -> String {
    unicode_row(&layout(expr))
}

pub(super) fn unicode_row(row: &Row) -> String {
    let mut out = String::new();
    for (place, item) in row.iter().enumerate() {
        let before = place.checked_sub(1).map(|place| &row[place]);
        let after = row.get(place + 1);
        match item {
            // `a/b c` on one line would read as `a/(b c)`.
            Item::Fraction(..) if before == Some(&Item::Beside) || binds(after) => {
                out.push_str(&format!("({})", linear(item)));
            }
            Item::Call(..) if before == Some(&Item::Beside) => {
                out.push(' ');
                out.push_str(&linear(item));
            }
            Item::Root(_) if after == Some(&Item::Beside) => {
                out.push_str(&linear(item));
                if matches!(row.get(place + 2), Some(Item::Letter(_) | Item::Bold(_) | Item::Power(..))) {
                    out.push(' ');
                }
            }
            _ => out.push_str(&linear(item)),
        }
    }
    out
}

/// Does the sign after an item tie it to what follows?
fn binds(after: Option<&Item>) -> bool {
    matches!(after, Some(Item::Beside | Item::Gap | Item::Times | Item::Degree | Item::Unit(_)))
}

fn linear(item: &Item) -> String {
    match item {
        Item::Digits(digits) => digits.clone(),
        Item::Letter(letter) => written(letter),
        Item::Bold(letter) => letter.to_string(),
        Item::Degree => "°".to_owned(),
        Item::Negation => "−".to_owned(),
        Item::Plus => " + ".to_owned(),
        Item::Minus => " − ".to_owned(),
        Item::Times => " × ".to_owned(),
        Item::Beside => String::new(),
        Item::Gap => " ".to_owned(),
        Item::Relation(relation) => format!(" {} ", relation_sign(*relation)),
        Item::Fraction(top, bottom) => {
            let top = if is_product(top) { unicode_row(top) } else { closed(top) };
            format!("{top}/{}", closed(bottom))
        }
        // The bar of the root cannot be drawn, so `√x²` would be read in two ways.
        Item::Root(inner) if matches!(inner[..], [Item::Power(..)] | [_, Item::Degree]) => {
            format!("√({})", unicode_row(inner))
        }
        Item::Root(inner) => format!("√{}", closed(inner)),
        Item::Power(base, exponent) => {
            let above = unicode_row(exponent);
            match superscript(&above) {
                Some(raised) => format!("{}{raised}", unicode_row(base)),
                None => format!("{}^{}", unicode_row(base), closed(exponent)),
            }
        }
        Item::Brackets(inner) => format!("({})", unicode_row(inner)),
        Item::Bars(inner) => format!("|{}|", unicode_row(inner)),
        Item::Call(function, power, argument) => {
            let raised = power.as_deref().and_then(superscript).unwrap_or_default();
            let argument = match &argument[..] {
                [Item::Fraction(..)] => format!("({})", unicode_row(argument)),
                _ => unicode_row(argument),
            };
            let apart =
                !argument.starts_with('(') && (raised.is_empty() || argument.starts_with(|c: char| c.is_ascii_digit()));
            format!("{}{raised}{}{argument}", name(*function), if apart { " " } else { "" })
        }
        Item::Unit(unit) => unit_unicode(*unit).to_owned(),
    }
}

/// Factors side by side need no brackets above a stroke: `16√3/9`.
fn is_product(row: &Row) -> bool {
    !row.iter().any(|item| matches!(item, Item::Plus | Item::Minus | Item::Relation(_) | Item::Negation))
        && !matches!(row[..], [Item::Fraction(..)])
}

/// The row, in brackets unless it is one thing.
fn closed(row: &Row) -> String {
    let single =
        matches!(row[..], [Item::Digits(_) | Item::Letter(_) | Item::Bold(_) | Item::Brackets(_) | Item::Bars(_)])
            || matches!(row[..], [Item::Root(_) | Item::Power(..)])
            || matches!(row[..], [_, Item::Degree]);
    if single { unicode_row(row) } else { format!("({})", unicode_row(row)) }
}

fn superscript(text: &str) -> Option<String> {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    text.chars()
        .map(|c| match c {
            '−' => Some('⁻'),
            'n' => Some('ⁿ'),
            _ => c.to_digit(10).map(|digit| RAISED[digit as usize]),
        })
        .collect()
}

fn subscript(text: &str) -> Option<String> {
    const LOWERED: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    text.chars().map(|c| c.to_digit(10).map(|digit| LOWERED[digit as usize])).collect()
}

fn written(letter: &Letter) -> String {
    let on_line = |symbol: &Symbol| match symbol {
        Symbol::Greek(_, character) | Symbol::Vector(character) => character.to_string(),
        Symbol::Italic(text) | Symbol::Upright(text) => words_unicode(text),
    };
    let base = on_line(&letter.base);
    match letter.subscript.as_ref().map(on_line) {
        None => base,
        Some(below) => match subscript(&below) {
            Some(lowered) => format!("{base}{lowered}"),
            None => format!("{base}_{below}"),
        },
    }
}

fn name(function: Function) -> &'static str {
    match function {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        Function::Atan => "arctan",
        other => other.name(),
    }
}

fn relation_sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "≠",
        Relation::Less => "<",
        Relation::LessOrEqual => "≤",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => "≥",
        Relation::Implies => "⇒",
        Relation::Approximately => "≈",
    }
}
