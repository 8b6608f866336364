//! Formulas in presentation MathML, within the MathML Core that browsers draw themselves.

use super::layout::{Item, Row, is_tall, layout};
use super::letter::{Letter, Symbol};
use super::unit::unit_mathml;
use super::words::words_html;
use crate::expr::{Expr, Function, Relation};

const THIN_SPACE: &str = r#"<mspace width="0.1667em"/>"#;
const INVISIBLE_TIMES: &str = "<mo>&#x2062;</mo>";
const APPLY: &str = "<mo>&#x2061;</mo>";

/// The elements of the formula, without the `<math>` around them.
///
/// ```
/// use carom::expr::{Expr, print};
/// let half = Expr::integer(1).over(Expr::integer(2));
/// assert_eq!(print::mathml(&half), "<mfrac><mn>1</mn><mn>2</mn></mfrac>");
/// ```
pub fn mathml(expr: &Expr) -> String {
    mathml_row(&layout(expr))
}

/// The formula within a line of words.
pub fn mathml_inline(expr: &Expr) -> String {
    math("", &layout(expr))
}

/// The formula on a line of its own.
pub fn mathml_block(expr: &Expr) -> String {
    math(r#" display="block""#, &layout(expr))
}

/// A row of this many items or fewer stays on one line.
const SHORT: usize = 5;

/// The `math` element of a row.
///
/// A longer row comes in pieces, each an `mrow`, and is said to be long: browsers break no formula by themselves, but a
/// style sheet can let piece follow piece as words do. As on paper, a line begins with the sign.
pub(super) fn math(attributes: &str, row: &[Item]) -> String {
    let begins = |item: &Item| matches!(item, Item::Relation(_) | Item::Plus | Item::Minus | Item::Times);
    let starts: Vec<usize> = (1..row.len()).filter(|&place| begins(&row[place])).collect();
    if row.len() <= SHORT || starts.is_empty() {
        return format!("<math{attributes}>{}</math>", mathml_row(row));
    }
    let ends = starts.iter().copied().chain([row.len()]);
    let pieces = [0].into_iter().chain(starts.iter().copied()).zip(ends);
    let pieces: String = pieces.map(|(start, end)| format!("<mrow>{}</mrow>", piece(&row[start..end]))).collect();
    format!(r#"<math{attributes} class="long">{pieces}</math>"#)
}

/// A piece of a longer row: a sign that comes first in its `mrow` is still one between two terms.
fn piece(row: &[Item]) -> String {
    match row {
        [Item::Plus, rest @ ..] => format!(r#"<mo form="infix">+</mo>{}"#, mathml_row(rest)),
        [Item::Minus, rest @ ..] => format!(r#"<mo form="infix">−</mo>{}"#, mathml_row(rest)),
        _ => mathml_row(row),
    }
}

pub(super) fn mathml_row(row: &[Item]) -> String {
    let mut out = String::new();
    for (place, item) in row.iter().enumerate() {
        let after_factor = place > 0 && row[place - 1] == Item::Beside;
        if after_factor && matches!(item, Item::Call(..)) {
            out.push_str(THIN_SPACE);
        }
        out.push_str(&element(item));
    }
    out
}

/// A row as the one child that a fraction, root or power takes.
fn one(row: &Row) -> String {
    match &row[..] {
        [Item::Unit(_)] => format!("<mrow>{}</mrow>", mathml_row(row)),
        [item] => element(item),
        _ => format!("<mrow>{}</mrow>", mathml_row(row)),
    }
}

fn element(item: &Item) -> String {
    match item {
        Item::Digits(digits) => format!("<mn>{}</mn>", words_html(digits)),
        Item::Letter(letter) => match &letter.subscript {
            Some(below) => format!("<msub>{}{}</msub>", symbol(&letter.base), symbol(below)),
            None => symbol(&letter.base),
        },
        // MathML Core knows no bold type; these are the bold letters of Unicode.
        Item::Bold('i') => bold('𝐢'),
        Item::Bold('j') => bold('𝐣'),
        Item::Bold(_) => bold('𝟎'),
        Item::Degree => r#"<mi mathvariant="normal">°</mi>"#.to_owned(),
        Item::Negation => r#"<mo form="prefix">−</mo>"#.to_owned(),
        Item::Plus => "<mo>+</mo>".to_owned(),
        Item::Minus => "<mo>−</mo>".to_owned(),
        Item::Times => "<mo>×</mo>".to_owned(),
        Item::Beside => INVISIBLE_TIMES.to_owned(),
        Item::Gap => format!("{INVISIBLE_TIMES}{THIN_SPACE}"),
        Item::Relation(relation) => format!("<mo>{}</mo>", relation_sign(*relation)),
        Item::Fraction(top, bottom) => format!("<mfrac>{}{}</mfrac>", one(top), one(bottom)),
        Item::Root(inner) => format!("<msqrt>{}</msqrt>", mathml_row(inner)),
        Item::Power(base, exponent) => match &base[..] {
            [Item::Letter(Letter { base, subscript: Some(below) })] => {
                format!("<msubsup>{}{}{}</msubsup>", symbol(base), symbol(below), one(exponent))
            }
            _ => format!("<msup>{}{}</msup>", one(base), one(exponent)),
        },
        Item::Brackets(inner) => fenced("(", inner, ")"),
        Item::Bars(inner) => fenced("|", inner, "|"),
        Item::Call(function, power, argument) => {
            let name = format!("<mi>{}</mi>", name(*function));
            let name = match power {
                Some(digits) => format!("<msup>{name}<mn>{digits}</mn></msup>"),
                None => name,
            };
            let space = if matches!(argument[..], [Item::Brackets(_)]) { "" } else { THIN_SPACE };
            format!("<mrow>{name}{APPLY}{space}{}</mrow>", one(argument))
        }
        Item::Unit(unit) => unit_mathml(*unit),
    }
}

fn bold(letter: char) -> String {
    format!(r#"<mi class="vector">{letter}</mi>"#)
}

fn fenced(open: &str, inner: &Row, close: &str) -> String {
    let stretchy = is_tall(inner);
    format!(
        r#"<mrow><mo form="prefix" stretchy="{stretchy}">{open}</mo>{}<mo form="postfix" stretchy="{stretchy}">{close}</mo></mrow>"#,
        mathml_row(inner)
    )
}

fn symbol(symbol: &Symbol) -> String {
    match symbol {
        Symbol::Vector(letter) => bold(bold_letter(*letter)),
        Symbol::Italic(text) if text.chars().all(|c| c.is_ascii_digit()) => format!("<mn>{text}</mn>"),
        Symbol::Italic(text) if text.len() > 1 => {
            // Each letter by itself, for a longer `mi` would stand upright.
            let letters: String = text.chars().map(|c| format!("<mi>{c}</mi>")).collect();
            format!("<mrow>{letters}</mrow>")
        }
        Symbol::Italic(text) => format!("<mi>{text}</mi>"),
        Symbol::Greek(name, character) if name.starts_with(|c: char| c.is_ascii_uppercase()) => {
            format!(r#"<mi mathvariant="normal">{character}</mi>"#)
        }
        Symbol::Greek(_, character) => format!("<mi>{character}</mi>"),
        Symbol::Upright(text) => format!(r#"<mi mathvariant="normal">{}</mi>"#, words_html(text)),
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
        Relation::Less => "&lt;",
        Relation::LessOrEqual => "≤",
        Relation::Greater => "&gt;",
        Relation::GreaterOrEqual => "≥",
        Relation::Implies => "⇒",
        Relation::Approximately => "≈",
    }
}

/// The bold letter of Unicode, which has both alphabets in order.
fn bold_letter(letter: char) -> char {
    let from = |first: char, bold: u32| char::from_u32(bold + (u32::from(letter) - u32::from(first)));
    match letter {
        'a'..='z' => from('a', 0x1d41a).unwrap_or(letter),
        'A'..='Z' => from('A', 0x1d400).unwrap_or(letter),
        _ => letter,
    }
}
