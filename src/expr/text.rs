//! Words with formulas in them, before it is decided on what they are printed.

use super::Expr;
use crate::unit::Unit;

/// A run of words, formulas and quantities.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text(pub Vec<Piece>);

/// A piece of a [`Text`].
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// Plain words; printers escape them.
    Words(String),
    /// Words in italics, such as the lead-in `[In this question …]`.
    Italic(Vec<Piece>),
    /// A formula within the line.
    Formula(Expr),
    /// A number or vector with its unit: `4 kg`, `(4i - j) m s^-1`, `30°`.
    Quantity(Expr, Unit),
    /// A formula on a line of its own, as the result of a 'show that'.
    Display(Expr),
}

impl Text {
    /// Words alone.
    pub fn words(text: impl Into<String>) -> Text {
        Text(vec![Piece::Words(text.into())])
    }

    /// Is there nothing in it?
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
