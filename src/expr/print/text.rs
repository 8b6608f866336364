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
    text.0.iter().map(html_piece).collect()
}

fn html_piece(piece: &Piece) -> String {
    match piece {
        Piece::Words(words) => words_html(words),
        Piece::Italic(pieces) => format!("<em>{}</em>", pieces.iter().map(html_piece).collect::<String>()),
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
