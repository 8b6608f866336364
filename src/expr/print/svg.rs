//! Words with formulas in them, for the `text` elements of a picture: on one line, letters in italics.

use super::ROOM;
use super::layout::Formula;
use super::letter::{Letter, Symbol};
use super::unicode::{Hand, relation_sign, write_on_one_line};
use super::words::write_words_html;
use crate::expr::{Piece, Relation, Text};

/// The text as the contents of a `text` element.
///
/// ```
/// use carom::expr::{Text, Expr, Piece, print};
/// let label = Text(vec![Piece::Formula(Expr::product([Expr::integer(2), Expr::name("u")]))]);
/// assert_eq!(print::text_svg(&label), r#"2<tspan class="italic" font-style="italic">u</tspan>"#);
/// ```
pub fn text_svg(text: &Text) -> String {
    let mut out = String::with_capacity(ROOM);
    text.0.iter().for_each(|piece| write_piece(piece, &mut out));
    out
}

fn write_piece(piece: &Piece, out: &mut String) {
    match piece {
        Piece::Words(words) => write_words_html(words, out),
        Piece::Italic(inner) => span(ITALIC, out, |out| inner.iter().for_each(|piece| write_piece(piece, out))),
        Piece::Formula(expr) | Piece::Display(expr) => write_on_one_line(&Formula::of(expr).row(), PICTURE, out),
        Piece::Quantity(expr, unit) => write_on_one_line(&Formula::of(expr).quantity(*unit), PICTURE, out),
    }
}

const PICTURE: Hand =
    Hand { letter: write_letter, bold: |letter, out| span(BOLD, out, |out| out.push(letter)), relation };

/// The class for a style sheet, and the same by itself where there is none.
const ITALIC: &str = r#"<tspan class="italic" font-style="italic">"#;
/// Fonts of words lack Greek letters, and what stands in for one is seldom as light: a style sheet has them from a font of
/// mathematics.
const GREEK: &str = r#"<tspan class="greek" font-style="italic">"#;
const BOLD: &str = r#"<tspan class="bold" font-weight="bold">"#;
/// The shift counts in ems of its own size, and holds until it is taken back.
const LOWERED: &str = r#"<tspan dy="0.3em" font-size="70%">"#;
const TAKEN_BACK: &str = r#"<tspan dy="-0.21em">&#8203;</tspan>"#;

/// Adds letters that are set in another way.
fn span(tag: &str, out: &mut String, write: impl FnOnce(&mut String)) {
    out.push_str(tag);
    write(out);
    out.push_str("</tspan>");
}

fn write_letter(letter: &Letter, out: &mut String) {
    write_symbol(&letter.base, out);
    if let Some(below) = &letter.subscript {
        span(LOWERED, out, |out| write_symbol(below, out));
        out.push_str(TAKEN_BACK);
    }
}

fn write_symbol(symbol: &Symbol, out: &mut String) {
    match symbol {
        Symbol::Greek(name, character) if name.starts_with(|c: char| c.is_ascii_uppercase()) => out.push(*character),
        Symbol::Greek(_, character) => span(GREEK, out, |out| out.push(*character)),
        Symbol::Vector(letter) => span(BOLD, out, |out| out.push(*letter)),
        Symbol::Italic(text) if text.chars().all(|c| c.is_ascii_digit()) => out.push_str(text),
        Symbol::Italic(text) => span(ITALIC, out, |out| write_words_html(text, out)),
        Symbol::Upright(text) => write_words_html(text, out),
    }
}

fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "&lt;",
        Relation::Greater => "&gt;",
        other => relation_sign(other),
    }
}
