//! Formulas on one line of a terminal: `16√3/9`, `tan²θ`, `v₁ ≤ 2u`.

use super::layout::{Formula, Item, Row};
use super::letter::{Letter, Symbol};
use super::unit::unit_unicode;
use super::words::write_words_unicode;
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
    unicode_row(&Formula::of(expr).row())
}

pub(super) fn unicode_row(row: &Row) -> String {
    on_one_line(row, TERMINAL)
}

/// How letters are set where a formula stands on one line.
#[derive(Clone, Copy)]
pub(super) struct Hand {
    /// Adds a letter, perhaps with a subscript.
    pub letter: fn(&Letter, &mut String),
    /// Adds a unit vector.
    pub bold: fn(char, &mut String),
    /// A relation.
    pub relation: fn(Relation) -> &'static str,
}

const TERMINAL: Hand = Hand { letter: write_letter, bold: |letter, out| out.push(letter), relation: relation_sign };

fn on_one_line(row: &Row, hand: Hand) -> String {
    let mut out = String::new();
    write_on_one_line(row, hand, &mut out);
    out
}

/// Adds a row in one line of characters.
pub(super) fn write_on_one_line(row: &Row, hand: Hand, out: &mut String) {
    for (place, item) in row.iter().enumerate() {
        let before = place.checked_sub(1).map(|place| &row[place]);
        let after = row.get(place + 1);
        let is_bracketed = is_bracketed_on_one_line(row, place);
        if is_bracketed {
            out.push('(');
        } else if matches!(item, Item::Call(..)) && before == Some(&Item::Beside) {
            out.push(' ');
        }
        write_item(item, hand, out);
        if is_bracketed {
            out.push(')');
        } else if matches!(item, Item::Root(_))
            && after == Some(&Item::Beside)
            && matches!(row.get(place + 2), Some(Item::Letter(_) | Item::Bold(_) | Item::Power(..)))
        {
            out.push(' ');
        }
    }
}

/// Does a fraction at a place of a row need brackets on one line? `a/b c` would read as `a/(b c)`.
pub(super) fn is_bracketed_on_one_line(row: &[Item], place: usize) -> bool {
    let binds = |after: &Item| matches!(after, Item::Beside | Item::Gap | Item::Times | Item::Degree | Item::Unit(_));
    matches!(row[place], Item::Fraction(..))
        && (row[..place].last() == Some(&Item::Beside) || row.get(place + 1).is_some_and(binds))
}

/// Adds a row between what opens it and what closes it.
fn enclose(open: &str, row: &Row, close: &str, hand: Hand, out: &mut String) {
    out.push_str(open);
    write_on_one_line(row, hand, out);
    out.push_str(close);
}

fn write_item(item: &Item, hand: Hand, out: &mut String) {
    match item {
        Item::Digits(digits) => out.push_str(digits),
        Item::Letter(letter) => (hand.letter)(letter, out),
        Item::Bold(letter) => (hand.bold)(*letter, out),
        Item::Degree => out.push('°'),
        Item::Negation => out.push('−'),
        Item::Plus => out.push_str(" + "),
        Item::Minus => out.push_str(" − "),
        Item::Times => out.push_str(" × "),
        Item::Beside => {}
        Item::Gap => out.push(' '),
        Item::Relation(relation) => out.extend([" ", (hand.relation)(*relation), " "]),
        Item::Fraction(top, bottom) => {
            if is_product(top) {
                write_on_one_line(top, hand, out)
            } else {
                write_closed(top, hand, out)
            }
            out.push('/');
            write_closed(bottom, hand, out);
        }
        // The bar of the root cannot be drawn, so `√x²` would be read in two ways.
        Item::Root(inner) if matches!(inner[..], [Item::Power(..)] | [_, Item::Degree]) => {
            enclose("√(", inner, ")", hand, out);
        }
        Item::Root(inner) => {
            out.push('√');
            write_closed(inner, hand, out);
        }
        Item::Power(base, exponent) => {
            write_on_one_line(base, hand, out);
            // Printed once: a tower of powers printed twice at each storey would take for ever.
            let above = on_one_line(exponent, hand);
            match superscript(&above) {
                Some(raised) => out.push_str(&raised),
                None if is_single(exponent) => out.extend(["^", &above]),
                None => out.extend(["^(", &above, ")"]),
            }
        }
        Item::Brackets(inner) => enclose("(", inner, ")", hand, out),
        Item::Bars(inner) => enclose("|", inner, "|", hand, out),
        Item::Call(function, power, argument) => {
            let raised = power.as_deref().and_then(superscript).unwrap_or_default();
            out.extend([name(*function), &raised]);
            let begin = out.len();
            match &argument[..] {
                [Item::Fraction(..)] => enclose("(", argument, ")", hand, out),
                _ => write_on_one_line(argument, hand, out),
            }
            let written = &out[begin..];
            if !written.starts_with('(') && (raised.is_empty() || written.starts_with(|c: char| c.is_ascii_digit())) {
                out.insert(begin, ' ');
            }
        }
        Item::Unit(unit) => out.push_str(unit_unicode(*unit)),
    }
}

/// Factors side by side need no brackets above a stroke: `16√3/9`.
fn is_product(row: &Row) -> bool {
    !row.iter().any(|item| matches!(item, Item::Plus | Item::Minus | Item::Relation(_) | Item::Negation))
        && !matches!(row[..], [Item::Fraction(..)])
}

/// Adds the row, in brackets unless it is one thing.
fn write_closed(row: &Row, hand: Hand, out: &mut String) {
    if is_single(row) { write_on_one_line(row, hand, out) } else { enclose("(", row, ")", hand, out) }
}

/// Is it one thing, that needs no brackets?
fn is_single(row: &Row) -> bool {
    matches!(row[..], [Item::Digits(_) | Item::Letter(_) | Item::Bold(_) | Item::Brackets(_) | Item::Bars(_)])
        || matches!(row[..], [Item::Root(_) | Item::Power(..)])
        || matches!(row[..], [_, Item::Degree])
}

/// The text raised; `None` where there are no such signs, and of a nought alone, which is how degrees are often typed.
fn superscript(text: &str) -> Option<String> {
    if text == "0" {
        return None;
    }
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

fn write_letter(letter: &Letter, out: &mut String) {
    let write = |symbol: &Symbol, out: &mut String| match symbol {
        Symbol::Greek(_, character) | Symbol::Vector(character) => out.push(*character),
        Symbol::Italic(text) | Symbol::Upright(text) => write_words_unicode(text, out),
    };
    write(&letter.base, out);
    let Some(below) = &letter.subscript else { return };
    let lowered = if let Symbol::Italic(text) = below { subscript(text) } else { None };
    match lowered {
        Some(lowered) => out.push_str(&lowered),
        None => {
            out.push('_');
            write(below, out);
        }
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
