//! Notations: how words and formulas are printed in a format, and how its plain words are escaped.

use std::io::{self, Write};

use serde::Deserialize;
use tera::EscapeFn;

use super::plain_text::{BAR, BREAK, TIE};
use crate::diagram::{Diagram, svg, tikz};
use crate::expr::{Expr, Piece, Relation, Text, print};
use crate::unit::Unit;

/// The notation in which a format has its formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Notation {
    /// Words and formulas of LaTeX; a formula by itself is without dollars, to stand in mathematics.
    Latex,
    /// HTML with MathML; a formula by itself is a `math` element.
    Html,
    /// Plain text with Unicode signs.
    Unicode,
}

impl Notation {
    /// Words with formulas in them.
    pub(super) fn text(self, text: &Text) -> String {
        match self {
            Notation::Latex => print::text_latex(&text.clone().without_widow()),
            Notation::Html => print::text_html(&text.clone().without_widow()),
            Notation::Unicode => text.0.iter().map(|piece| self.piece(piece)).collect(),
        }
    }

    /// A formula by itself.
    pub(super) fn formula(self, formula: &Expr) -> String {
        match self {
            Notation::Latex => print::latex(formula),
            Notation::Html => print::mathml_inline(formula),
            Notation::Unicode => tied(print::unicode(formula)),
        }
    }

    /// A value by itself with its unit.
    pub(super) fn measured(self, value: &Expr, unit: Unit) -> String {
        match self {
            Notation::Latex => print::latex_quantity(value, unit),
            Notation::Html => print::text_html(&Text(vec![Piece::Quantity(value.clone(), unit)])),
            Notation::Unicode => tied(print::text_unicode(&Text(vec![Piece::Quantity(value.clone(), unit)]))),
        }
    }

    /// A piece of plain text: lines end between its words and not within its formulas.
    fn piece(self, piece: &Piece) -> String {
        match piece {
            Piece::Words(words) => plain(words),
            Piece::Italic(pieces) => pieces.iter().map(|piece| self.piece(piece)).collect(),
            Piece::Formula(_) | Piece::Quantity(..) => tied(print::text_unicode(&Text(vec![piece.clone()]))),
            Piece::Display(formula) => format!("{BREAK}    {}{BREAK}", self.formula(formula)),
        }
    }

    /// A picture: drawn where the notation can draw, else in words.
    pub(super) fn diagram(self, diagram: &Diagram) -> String {
        match self {
            Notation::Latex => tikz(&diagram.drawing),
            Notation::Html => svg(diagram),
            Notation::Unicode => plain(&diagram.words),
        }
    }

    /// The sign of a relation, where its two sides stand in columns of their own.
    pub(super) fn relation(self, relation: Relation) -> &'static str {
        let (latex, unicode) = match relation {
            Relation::Equal => ("=", "="),
            Relation::NotEqual => (r"\ne", "≠"),
            Relation::Less => ("<", "<"),
            Relation::LessOrEqual => (r"\le", "≤"),
            Relation::Greater => (">", ">"),
            Relation::GreaterOrEqual => (r"\ge", "≥"),
            Relation::Implies => (r"\Rightarrow", "⇒"),
            Relation::Approximately => (r"\approx", "≈"),
        };
        match (self, relation) {
            (Notation::Latex, _) => latex,
            (Notation::Html, Relation::Less) => "&lt;",
            (Notation::Html, Relation::Greater) => "&gt;",
            (Notation::Html | Notation::Unicode, _) => unicode,
        }
    }

    /// What makes plain words harmless: titles, names of schools and students, whatever they contain.
    pub(super) fn escape(self) -> EscapeFn {
        match self {
            Notation::Latex => escape_latex,
            Notation::Html => escape_html,
            Notation::Unicode => escape_unicode,
        }
    }
}

fn escape_latex(words: &str, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(print::words_latex(words).as_bytes())
}

fn escape_html(words: &str, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(print::words_html(words).as_bytes())
}

fn escape_unicode(words: &str, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(plain(words).as_bytes())
}

/// Words for plain text; the signs that part its columns and lines are left to templates.
fn plain(words: &str) -> String {
    print::words_unicode(words).replace(BAR, "|").replace(BREAK, " ")
}

fn tied(formula: String) -> String {
    formula.replace(' ', &TIE.to_string())
}
