//! Words with formulas in them, printed for LaTeX, HTML and a terminal.

use super::ROOM;
use super::latex::write_latex;
use super::layout::{Formula, Row};
use super::mathml::{write_block, write_math};
use super::unicode::{unicode, unicode_row};
use super::words::{words_unicode, write_words_html, write_words_latex};
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
    let mut out = String::with_capacity(ROOM);
    text.0.iter().for_each(|piece| write_latex_piece(piece, &mut out));
    out
}

fn write_latex_piece(piece: &Piece, out: &mut String) {
    let enclose = |open: &str, row: Row, close: &str, out: &mut String| {
        out.push_str(open);
        write_latex(&row, out);
        out.push_str(close);
    };
    match piece {
        Piece::Words(words) => write_words_latex(words, out),
        Piece::Italic(pieces) => {
            out.push_str(r"\textit{");
            pieces.iter().for_each(|piece| write_latex_piece(piece, out));
            out.push('}');
        }
        Piece::Formula(expr) => enclose("$", Formula::of(expr).row(), "$", out),
        Piece::Quantity(expr, unit) => enclose("$", Formula::of(expr).quantity(*unit), "$", out),
        Piece::Display(expr) => enclose(r"\[", Formula::of(expr).row(), r"\]", out),
    }
}

/// The text in HTML.
pub fn text_html(text: &Text) -> String {
    let mut out = String::with_capacity(ROOM);
    write_html_pieces(&text.0, &mut out);
    out
}

/// Adds the pieces; a formula and the stop or comma after it are kept on one line, where browsers would part them.
fn write_html_pieces(pieces: &[Piece], out: &mut String) {
    let mut stop = "";
    for (place, piece) in pieces.iter().enumerate() {
        let before = std::mem::take(&mut stop);
        stop = match (piece, pieces.get(place + 1)) {
            (Piece::Formula(_) | Piece::Quantity(..), Some(Piece::Words(words))) => stop_of(words),
            _ => "",
        };
        out.push_str(if stop.is_empty() { "" } else { r#"<span class="kept">"# });
        match piece {
            Piece::Words(words) => write_words_html(words.strip_prefix(before).unwrap_or(words), out),
            _ => write_html_piece(piece, out),
        }
        if !stop.is_empty() {
            out.extend([stop, "</span>"]);
        }
    }
}

/// The stop, comma or closing bracket that words begin with.
fn stop_of(words: &str) -> &str {
    let rest = words.trim_start_matches(['.', ',', ';', ':', '?', '!', ')']);
    &words[..words.len() - rest.len()]
}

fn write_html_piece(piece: &Piece, out: &mut String) {
    match piece {
        Piece::Words(words) => write_words_html(words, out),
        Piece::Italic(pieces) => {
            out.push_str("<em>");
            write_html_pieces(pieces, out);
            out.push_str("</em>");
        }
        Piece::Formula(expr) => write_math(&Formula::of(expr).row(), out),
        Piece::Quantity(expr, unit) => write_math(&Formula::of(expr).quantity(*unit), out),
        Piece::Display(expr) => write_block(&Formula::of(expr).row(), out),
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
        Piece::Quantity(expr, unit) => unicode_row(&Formula::of(expr).quantity(*unit)),
        Piece::Display(expr) => format!("\n\n    {}\n\n", unicode(expr)),
    }
}
