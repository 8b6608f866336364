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
    on_one_line(row, TERMINAL)
}

/// How letters are set where a formula stands on one line.
#[derive(Clone, Copy)]
pub(super) struct Hand {
    /// A letter, perhaps with a subscript.
    pub letter: fn(&Letter) -> String,
    /// A unit vector.
    pub bold: fn(char) -> String,
    /// A relation.
    pub relation: fn(Relation) -> &'static str,
}

const TERMINAL: Hand = Hand { letter: written, bold: |letter| letter.to_string(), relation: relation_sign };

/// A row in one line of characters.
pub(super) fn on_one_line(row: &Row, hand: Hand) -> String {
    let mut out = String::new();
    for (place, item) in row.iter().enumerate() {
        let before = place.checked_sub(1).map(|place| &row[place]);
        let after = row.get(place + 1);
        match item {
            _ if is_bracketed_on_one_line(row, place) => out.push_str(&format!("({})", linear(item, hand))),
            Item::Call(..) if before == Some(&Item::Beside) => {
                out.push(' ');
                out.push_str(&linear(item, hand));
            }
            Item::Root(_) if after == Some(&Item::Beside) => {
                out.push_str(&linear(item, hand));
                if matches!(row.get(place + 2), Some(Item::Letter(_) | Item::Bold(_) | Item::Power(..))) {
                    out.push(' ');
                }
            }
            _ => out.push_str(&linear(item, hand)),
        }
    }
    out
}

/// Does a fraction at a place of a row need brackets on one line? `a/b c` would read as `a/(b c)`.
pub(super) fn is_bracketed_on_one_line(row: &[Item], place: usize) -> bool {
    let binds = |after: &Item| matches!(after, Item::Beside | Item::Gap | Item::Times | Item::Degree | Item::Unit(_));
    matches!(row[place], Item::Fraction(..))
        && (row[..place].last() == Some(&Item::Beside) || row.get(place + 1).is_some_and(binds))
}

fn linear(item: &Item, hand: Hand) -> String {
    match item {
        Item::Digits(digits) => digits.clone(),
        Item::Letter(letter) => (hand.letter)(letter),
        Item::Bold(letter) => (hand.bold)(*letter),
        Item::Degree => "°".to_owned(),
        Item::Negation => "−".to_owned(),
        Item::Plus => " + ".to_owned(),
        Item::Minus => " − ".to_owned(),
        Item::Times => " × ".to_owned(),
        Item::Beside => String::new(),
        Item::Gap => " ".to_owned(),
        Item::Relation(relation) => format!(" {} ", (hand.relation)(*relation)),
        Item::Fraction(top, bottom) => {
            let top = if is_product(top) { on_one_line(top, hand) } else { closed(top, hand) };
            format!("{top}/{}", closed(bottom, hand))
        }
        // The bar of the root cannot be drawn, so `√x²` would be read in two ways.
        Item::Root(inner) if matches!(inner[..], [Item::Power(..)] | [_, Item::Degree]) => {
            format!("√({})", on_one_line(inner, hand))
        }
        Item::Root(inner) => format!("√{}", closed(inner, hand)),
        Item::Power(base, exponent) => {
            let above = on_one_line(exponent, hand);
            match superscript(&above) {
                Some(raised) => format!("{}{raised}", on_one_line(base, hand)),
                None => format!("{}^{}", on_one_line(base, hand), closed(exponent, hand)),
            }
        }
        Item::Brackets(inner) => format!("({})", on_one_line(inner, hand)),
        Item::Bars(inner) => format!("|{}|", on_one_line(inner, hand)),
        Item::Call(function, power, argument) => {
            let raised = power.as_deref().and_then(superscript).unwrap_or_default();
            let argument = match &argument[..] {
                [Item::Fraction(..)] => format!("({})", on_one_line(argument, hand)),
                _ => on_one_line(argument, hand),
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
fn closed(row: &Row, hand: Hand) -> String {
    let single =
        matches!(row[..], [Item::Digits(_) | Item::Letter(_) | Item::Bold(_) | Item::Brackets(_) | Item::Bars(_)])
            || matches!(row[..], [Item::Root(_) | Item::Power(..)])
            || matches!(row[..], [_, Item::Degree]);
    if single { on_one_line(row, hand) } else { format!("({})", on_one_line(row, hand)) }
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

pub(super) fn name(function: Function) -> &'static str {
    match function {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        Function::Atan => "arctan",
        other => other.name(),
    }
}

pub(super) fn relation_sign(relation: Relation) -> &'static str {
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
