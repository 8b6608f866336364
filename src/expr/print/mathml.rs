//! Formulas in presentation MathML, within the MathML Core that browsers draw themselves.

use std::fmt::Write;

use super::extent::width_on_page;
use super::layout::{Formula, Item, Row, is_tall};
use super::letter::{Letter, Symbol};
use super::unit::unit_mathml;
use super::words::write_words_html;
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
    let mut out = String::with_capacity(super::ROOM);
    write_mathml(&Formula::of(expr).row(), &mut out);
    out
}

/// The formula within a line of words.
pub fn mathml_inline(expr: &Expr) -> String {
    let mut out = String::with_capacity(super::ROOM);
    write_math(&Formula::of(expr).row(), &mut out);
    out
}

/// The formula on a line of its own. The line may end before any sign: there are no words around to follow it.
pub fn mathml_block(expr: &Expr) -> String {
    let mut out = String::with_capacity(super::ROOM);
    write_block(&Formula::of(expr).row(), &mut out);
    out
}

/// A row of this many items or fewer stays on one line among words.
const SHORT: usize = 5;

/// Adds the `math` element of a row among words.
pub(super) fn write_math(row: &[Item], out: &mut String) {
    let stays = row.len() <= SHORT;
    write_pieces("", row.chunk_by(|_, next| stays || !begins_line(next)), out);
}

/// Adds the `math` element of a row on a line of its own.
pub(super) fn write_block(row: &[Item], out: &mut String) {
    write_pieces(r#" display="block""#, row.chunk_by(|_, next| !begins_line(next)), out);
}

/// May a line begin with it? As on paper, it begins with the sign.
fn begins_line(item: &Item) -> bool {
    matches!(item, Item::Relation(_) | Item::Plus | Item::Minus | Item::Times)
}

/// A piece of this width or less, in ems of its letters, fits any page. One in large print on a phone has little more.
const NARROW: f64 = 7.0;

/// Adds the `math` element of a row in pieces, each of which stays on one line.
///
/// Browsers break no formula by themselves. Of several pieces each is an `mrow`, and the formula is said to be long, so
/// that a style sheet can let piece follow piece as words do. If a piece may be too wide even then, the formula says how
/// wide, for letters that are small enough.
fn write_pieces<'r>(attributes: &str, pieces: impl Iterator<Item = &'r [Item<'r>]> + Clone, out: &mut String) {
    let is_long = pieces.clone().nth(1).is_some();
    out.extend(["<math", attributes, if is_long { r#" class="long""# } else { "" }]);
    let width = pieces.clone().map(width_on_page).fold(0.0, f64::max);
    if width > NARROW {
        let _ = write!(out, r#" style="--ems: {width:.1}""#);
    }
    out.push('>');
    for piece in pieces {
        if is_long { write_piece(piece, out) } else { write_mathml(piece, out) }
    }
    out.push_str("</math>");
}

/// Adds a piece of a longer row: a sign that comes first in its `mrow` is still one between two terms.
fn write_piece(row: &[Item], out: &mut String) {
    let (sign, rest) = match row {
        [Item::Plus, rest @ ..] => (r#"<mo form="infix">+</mo>"#, rest),
        [Item::Minus, rest @ ..] => (r#"<mo form="infix">−</mo>"#, rest),
        _ => ("", row),
    };
    out.extend(["<mrow>", sign]);
    enclose("", rest, "</mrow>", out);
}

fn write_mathml(row: &[Item], out: &mut String) {
    for (place, item) in row.iter().enumerate() {
        let after_factor = place > 0 && row[place - 1] == Item::Beside;
        if after_factor && matches!(item, Item::Call(..)) {
            out.push_str(THIN_SPACE);
        }
        write_item(item, out);
    }
}

/// Adds a row between the tags of an element.
fn enclose(open: &str, row: &[Item], close: &str, out: &mut String) {
    out.push_str(open);
    write_mathml(row, out);
    out.push_str(close);
}

/// Adds a row as the one child that a fraction, root or power takes.
fn one(row: &Row, out: &mut String) {
    match &row[..] {
        [Item::Unit(_)] => enclose("<mrow>", row, "</mrow>", out),
        [item] => write_item(item, out),
        _ => enclose("<mrow>", row, "</mrow>", out),
    }
}

fn write_item(item: &Item, out: &mut String) {
    match item {
        Item::Digits(digits) => {
            out.push_str("<mn>");
            write_words_html(digits, out);
            out.push_str("</mn>");
        }
        Item::Letter(letter) => match &letter.subscript {
            Some(below) => {
                out.push_str("<msub>");
                symbol(&letter.base, out);
                symbol(below, out);
                out.push_str("</msub>");
            }
            None => symbol(&letter.base, out),
        },
        // MathML Core knows no bold type; these are the bold letters of Unicode.
        Item::Bold('i') => bold('𝐢', out),
        Item::Bold('j') => bold('𝐣', out),
        Item::Bold(_) => bold('𝟎', out),
        Item::Degree => out.push_str(r#"<mi mathvariant="normal">°</mi>"#),
        Item::Negation => out.push_str(r#"<mo form="prefix">−</mo>"#),
        Item::Plus => out.push_str("<mo>+</mo>"),
        Item::Minus => out.push_str("<mo>−</mo>"),
        Item::Times => out.push_str("<mo>×</mo>"),
        Item::Beside => out.push_str(INVISIBLE_TIMES),
        Item::Gap => out.extend([INVISIBLE_TIMES, THIN_SPACE]),
        Item::Relation(relation) => out.extend(["<mo>", relation_sign(*relation), "</mo>"]),
        Item::Fraction(top, bottom) => {
            out.push_str("<mfrac>");
            one(top, out);
            one(bottom, out);
            out.push_str("</mfrac>");
        }
        Item::Root(inner) => enclose("<msqrt>", inner, "</msqrt>", out),
        Item::Power(base, exponent) => write_power(base, exponent, out),
        Item::Brackets(inner) => fenced("(", inner, ")", out),
        Item::Bars(inner) => fenced("|", inner, "|", out),
        Item::Call(function, power, argument) => {
            out.push_str("<mrow>");
            match power {
                Some(digits) => out.extend(["<msup><mi>", name(*function), "</mi><mn>", digits, "</mn></msup>"]),
                None => out.extend(["<mi>", name(*function), "</mi>"]),
            }
            out.push_str(APPLY);
            if !matches!(argument[..], [Item::Brackets(_)]) {
                out.push_str(THIN_SPACE);
            }
            one(argument, out);
            out.push_str("</mrow>");
        }
        Item::Unit(unit) => out.push_str(unit_mathml(*unit)),
    }
}

fn write_power(base: &Row, exponent: &Row, out: &mut String) {
    match &base[..] {
        [Item::Letter(Letter { base, subscript: Some(below) })] => {
            out.push_str("<msubsup>");
            symbol(base, out);
            symbol(below, out);
            one(exponent, out);
            out.push_str("</msubsup>");
        }
        _ => {
            out.push_str("<msup>");
            one(base, out);
            one(exponent, out);
            out.push_str("</msup>");
        }
    }
}

fn bold(letter: char, out: &mut String) {
    out.push_str(r#"<mi class="vector">"#);
    out.push(letter);
    out.push_str("</mi>");
}

fn fenced(open: &str, inner: &Row, close: &str, out: &mut String) {
    let stretchy = if is_tall(inner) { "true" } else { "false" };
    out.extend([r#"<mrow><mo form="prefix" stretchy=""#, stretchy, r#"">"#, open, "</mo>"]);
    write_mathml(inner, out);
    out.extend([r#"<mo form="postfix" stretchy=""#, stretchy, r#"">"#, close, "</mo></mrow>"]);
}

fn symbol(symbol: &Symbol, out: &mut String) {
    let italic = |letter: char, out: &mut String| {
        out.push_str("<mi>");
        out.push(letter);
        out.push_str("</mi>");
    };
    match symbol {
        Symbol::Vector(letter) => bold(bold_letter(*letter), out),
        Symbol::Italic(text) if text.chars().all(|c| c.is_ascii_digit()) => out.extend(["<mn>", text, "</mn>"]),
        Symbol::Italic(text) if text.len() > 1 => {
            // Each letter by itself, for a longer `mi` would stand upright.
            out.push_str("<mrow>");
            text.chars().for_each(|letter| italic(letter, out));
            out.push_str("</mrow>");
        }
        Symbol::Italic(text) => out.extend(["<mi>", text, "</mi>"]),
        Symbol::Greek(name, character) if name.starts_with(|c: char| c.is_ascii_uppercase()) => {
            out.push_str(r#"<mi mathvariant="normal">"#);
            out.push(*character);
            out.push_str("</mi>");
        }
        Symbol::Greek(_, character) => italic(*character, out),
        Symbol::Upright(text) => {
            out.push_str(r#"<mi mathvariant="normal">"#);
            write_words_html(text, out);
            out.push_str("</mi>");
        }
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
