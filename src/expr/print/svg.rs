//! Words with formulas in them, for the `text` elements of a picture: on one line, letters in italics.

use super::layout::{Row, layout, quantity};
use super::letter::{Letter, Symbol};
use super::unicode::{Hand, on_one_line, relation_sign};
use super::words::words_html;
use crate::expr::{Piece, Relation, Text};

/// The text as the contents of a `text` element.
///
/// ```
/// use carom::expr::{Text, Expr, Piece, print};
/// let label = Text(vec![Piece::Formula(Expr::product([Expr::integer(2), Expr::name("u")]))]);
/// assert_eq!(print::text_svg(&label), r#"2<tspan class="italic" font-style="italic">u</tspan>"#);
/// ```
pub fn text_svg(text: &Text) -> String {
    text.0.iter().map(piece).collect()
}

fn piece(piece: &Piece) -> String {
    match piece {
        Piece::Words(words) => words_html(words),
        Piece::Italic(inner) => span(ITALIC, &inner.iter().map(self::piece).collect::<String>()),
        Piece::Formula(expr) | Piece::Display(expr) => row(&layout(expr)),
        Piece::Quantity(expr, unit) => row(&quantity(expr, *unit)),
    }
}

fn row(row: &Row) -> String {
    on_one_line(row, PICTURE)
}

const PICTURE: Hand = Hand { letter, bold: |letter| span(BOLD, &letter.to_string()), relation };

/// The class for a style sheet, and the same by itself where there is none.
const ITALIC: &str = r#"class="italic" font-style="italic""#;
const BOLD: &str = r#"class="bold" font-weight="bold""#;

fn span(attributes: &str, contents: &str) -> String {
    format!("<tspan {attributes}>{contents}</tspan>")
}

fn letter(letter: &Letter) -> String {
    let base = symbol(&letter.base);
    match &letter.subscript {
        None => base,
        // The shift counts in ems of its own size, and holds until it is taken back.
        Some(below) => {
            let lowered = symbol(below);
            format!(r#"{base}<tspan dy="0.3em" font-size="70%">{lowered}</tspan><tspan dy="-0.21em">&#8203;</tspan>"#)
        }
    }
}

fn symbol(symbol: &Symbol) -> String {
    match symbol {
        Symbol::Greek(name, character) if name.starts_with(|c: char| c.is_ascii_uppercase()) => character.to_string(),
        Symbol::Greek(_, character) => span(ITALIC, &character.to_string()),
        Symbol::Vector(letter) => span(BOLD, &letter.to_string()),
        Symbol::Italic(text) if text.chars().all(|c| c.is_ascii_digit()) => text.clone(),
        Symbol::Italic(text) => span(ITALIC, &words_html(text)),
        Symbol::Upright(text) => words_html(text),
    }
}

fn relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "&lt;",
        Relation::Greater => "&gt;",
        other => relation_sign(other),
    }
}
