//! The words of a bank question with formulas in them.
//!
//! | written | printed |
//! |---|---|
//! | `{2u cos(alpha)}` | a formula |
//! | `{mA kg}`, `{[p, q] m/s}`, `{30 deg}` | a quantity with its unit |
//! | `{display: e = 1/2}` | a formula on a line of its own |
//! | `*A*` | the letter of a sphere or angle |
//! | `_In this question_` | italic words |
//! | `{{` and `}}` | braces |
//!
//! A blank line ends a paragraph. Angles are in degrees, and decimals stay as they were written.

use super::parser::{Angles, Decimals, read_with};
use crate::expr::{Expr, Fault, Name, Piece, Span, Text};
use crate::unit::Unit;

/// The paragraphs of a marked-up text.
pub type Markup = Vec<Text>;

/// Reads words with formulas in them; spans count bytes from the start of `text`.
///
/// ```
/// use carom::expr::{print, read_markup};
/// let stem = read_markup("Sphere *A* has mass {2 kg}.").unwrap();
/// assert_eq!(print::text_latex(&stem[0]), r"Sphere $A$ has mass $2\,\mathrm{kg}$.");
/// ```
pub fn read_markup(text: &str) -> Result<Markup, Fault> {
    let mut found = Vec::new();
    let (mut start, mut at) = (None, 0);
    for line in text.split_inclusive('\n') {
        match (line.trim().is_empty(), start) {
            (true, Some(from)) => {
                found.push(paragraph(text, from, at)?);
                start = None;
            }
            (false, None) => start = Some(at),
            _ => {}
        }
        at += line.len();
    }
    if let Some(from) = start {
        found.push(paragraph(text, from, at)?);
    }
    Ok(found)
}

fn paragraph(text: &str, from: usize, to: usize) -> Result<Text, Fault> {
    let end = from + text[from..to].trim_end().len();
    let start = end - text[from..end].trim_start().len();
    Ok(Text(Reader { text, at: start, end, pieces: Vec::new(), italic: false }.pieces()?))
}

/// A walk over the bytes from `at` up to `end`.
struct Reader<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    pieces: Vec<Piece>,
    /// Within italic words, where an underscore opens nothing.
    italic: bool,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..self.end]
    }

    fn pieces(mut self) -> Result<Vec<Piece>, Fault> {
        while let Some(first) = self.rest().chars().next() {
            let braces = self.rest().get(..2);
            match first {
                '{' | '}' if matches!(braces, Some("{{" | "}}")) => {
                    self.word(first);
                    self.at += 2;
                }
                '{' => self.braces()?,
                '}' => {
                    let span = Span { start: self.at, end: self.at + 1 };
                    return Err(Fault::new("`}` closes nothing", span, "no `{` stands open")
                        .try_this("write `}}` for a brace that is printed"));
                }
                '*' if self.starred() => {}
                '_' if !self.italic && self.underlined()? => {}
                _ => {
                    self.word(if first.is_whitespace() && first != '\u{a0}' { ' ' } else { first });
                    self.at += first.len_utf8();
                }
            }
        }
        Ok(self.pieces)
    }

    /// Adds a character to the words; one space stands for many.
    fn word(&mut self, c: char) {
        match self.pieces.last_mut() {
            Some(Piece::Words(words)) if c == ' ' && words.ends_with(' ') => {}
            Some(Piece::Words(words)) => words.push(c),
            _ => self.pieces.push(Piece::Words(c.into())),
        }
    }

    /// A formula or quantity in braces.
    fn braces(&mut self) -> Result<(), Fault> {
        let open = self.at;
        let Some(length) = self.rest().find('}') else {
            let span = Span { start: open, end: open + 1 };
            return Err(Fault::new("`{` is never closed", span, "its `}` is missing")
                .try_this("write `{{` for a brace that is printed"));
        };
        let inside = &self.text[open + 1..open + length];
        if inside.contains('{') {
            // `{\frac{1}{2}}` is closed, and no formula.
            if inside.contains('\\') {
                expression(inside, open + 1)?;
            }
            // The `}` belongs to another formula.
            let span = Span { start: open, end: open + 1 };
            return Err(Fault::new("`{` is never closed", span, "its `}` is missing")
                .try_this("write a `}` where the formula ends"));
        }
        self.at = open + length + 1;
        let piece = match inside.trim_start().strip_prefix("display:") {
            Some(formula) => Piece::Display(expression(formula, open + 1 + inside.len() - formula.len())?),
            None => match with_unit(inside) {
                Some((size, unit)) => Piece::Quantity(expression(size, open + 1)?, unit),
                None => Piece::Formula(expression(inside, open + 1)?),
            },
        };
        self.pieces.push(piece);
        Ok(())
    }

    /// `*A*`; any other asterisk is only an asterisk.
    fn starred(&mut self) -> bool {
        let Some((name, _)) = self.rest()[1..].split_once('*') else { return false };
        let fits = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if fits {
            let span = Span { start: self.at + 1, end: self.at + 1 + name.len() };
            self.pieces.push(Piece::Formula(Expr::Name(Name { text: name.to_owned(), span })));
            self.at = span.end + 1;
        }
        fits
    }

    /// `_italic words_`, where the underscores stand at the outer edges of words.
    fn underlined(&mut self) -> Result<bool, Fault> {
        let inside_word = self.text[..self.at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let rest = &self.rest()[1..];
        if inside_word || rest.starts_with(|c: char| c.is_whitespace() || c == '_') {
            return Ok(false);
        }
        let mut depth = 0;
        for (place, c) in rest.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                '_' if depth == 0
                    && !rest[..place].ends_with(char::is_whitespace)
                    && !rest[place + 1..].starts_with(|c: char| c.is_alphanumeric() || c == '_') =>
                {
                    let start = self.at + 1;
                    let inner =
                        Reader { text: self.text, at: start, end: start + place, pieces: Vec::new(), italic: true };
                    self.pieces.push(Piece::Italic(inner.pieces()?));
                    self.at = start + place + 1;
                    return Ok(true);
                }
                _ => {}
            }
        }
        Ok(false)
    }
}

/// The text before the unit and the unit, if space and a unit end the text.
fn with_unit(inside: &str) -> Option<(&str, Unit)> {
    let inside = inside.trim_end();
    Unit::ALL.into_iter().filter(|unit| *unit != Unit::None).find_map(|unit| {
        let before = inside.strip_suffix(unit.plain())?;
        let size = before.trim_end();
        // In `{k * m}` the letter is a mass and not a metre.
        let operand_missing =
            size.is_empty() || size.ends_with(['+', '-', '*', '/', '^', '(', '[', ',', '=', '<', '>']);
        (before.len() > size.len() && !operand_missing).then_some((size, unit))
    })
}

/// Reads an expression that begins at `start` of the whole text.
fn expression(text: &str, start: usize) -> Result<Expr, Fault> {
    match read_with(text, Angles::Degrees, Decimals::AsWritten) {
        Ok(expr) => Ok(expr.moved(start)),
        Err(fault) => Err(fault.shifted(start)),
    }
}
