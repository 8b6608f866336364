//! Words with formulas in them, printed for LaTeX, HTML and a terminal.

use super::latex::{latex, latex_row};
use super::layout::quantity;
use super::mathml::{math, mathml_block, mathml_inline};
use super::unicode::{unicode, unicode_row};
use super::words::{words_html, words_latex, words_unicode};
use crate::expr::{Piece, Text};

/// The text in LaTeX.
///
/// ```
/// use carom::expr::{Expr, Piece, Text, print};
/// use carom::unit::Unit;
/// let text = Text(vec![
///     Piece::Words("mass ".into()),
///     Piece::Quantity(Expr::integer(2), Unit::Kilogram),
/// ]);
/// assert_eq!(print::text_latex(&text), r"mass $2\,\mathrm{kg}$");
/// ```
pub fn text_latex(text: &Text) -> String {
    text.0.iter().map(latex_piece).collect()
}

fn latex_piece(piece: &Piece) -> String {
    match piece {
        Piece::Words(words) => words_latex(words),
        Piece::Italic(pieces) => {
            format!(r"\textit{{{}}}", pieces.iter().map(latex_piece).collect::<String>())
        }
        Piece::Formula(expr) => format!("${}$", latex(expr)),
        Piece::Quantity(expr, unit) => format!("${}$", latex_row(&quantity(expr, *unit))),
        Piece::Display(expr) => format!(r"\[{}\]", latex(expr)),
    }
}

/// The text in HTML.
pub fn text_html(text: &Text) -> String {
    html_pieces(&text.0)
}

/// The pieces; a formula and the stop or comma after it are kept on one line, where browsers would part them.
fn html_pieces(pieces: &[Piece]) -> String {
    let mut out = String::new();
    let mut stop = "";
    for (place, piece) in pieces.iter().enumerate() {
        let printed = match piece {
            Piece::Words(words) => words_html(words.strip_prefix(stop).unwrap_or(words)),
            _ => html_piece(piece),
        };
        stop = match (piece, pieces.get(place + 1)) {
            (Piece::Formula(_) | Piece::Quantity(..), Some(Piece::Words(words))) => stop_of(words),
            _ => "",
        };
        match stop {
            "" => out.push_str(&printed),
            _ => out.push_str(&format!(r#"<span class="kept">{printed}{stop}</span>"#)),
        }
    }
    out
}

/// The stop, comma or closing bracket that words begin with.
fn stop_of(words: &str) -> &str {
    let end = words.find(|letter| !".,;:?!)".contains(letter)).unwrap_or(words.len());
    &words[..end]
}

fn html_piece(piece: &Piece) -> String {
    match piece {
        Piece::Words(words) => words_html(words),
        Piece::Italic(pieces) => format!("<em>{}</em>", html_pieces(pieces)),
        Piece::Formula(expr) => mathml_inline(expr),
        Piece::Quantity(expr, unit) => math("", &quantity(expr, *unit)),
        Piece::Display(expr) => mathml_block(expr),
    }
}

/// The text on a terminal.
pub fn text_unicode(text: &Text) -> String {
    text.0.iter().map(unicode_piece).collect()
}

fn unicode_piece(piece: &Piece) -> String {
    match piece {
        Piece::Words(words) => words_unicode(words),
        Piece::Italic(pieces) => pieces.iter().map(unicode_piece).collect(),
        Piece::Formula(expr) => unicode(expr),
        Piece::Quantity(expr, unit) => unicode_row(&quantity(expr, *unit)),
        Piece::Display(expr) => format!("\n\n    {}\n\n", unicode(expr)),
    }
}
