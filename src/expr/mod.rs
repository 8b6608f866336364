//! One expression language for bank formulas, constraints, scenes and answers, and its printers.
//!
//! Text is read into an [`Expr`]; an `Expr` is evaluated into an exact value; every printed formula
//! is made from an `Expr` by one of the printers. Nothing else in carom makes LaTeX or MathML.

mod beside_angle;
mod circle;
mod evaluate;
mod fault;
mod nearly;
pub mod print;
mod read;
mod term;
mod text;
mod tree;
mod turn;
mod walk;
mod written;
#[cfg(test)]
mod written_tests;

use beside_angle::beside_an_angle;
pub use evaluate::{Meaning, Names, degrees, evaluate, holds, number};
pub use fault::Fault;
pub(crate) use read::bare_in_degrees;
pub use read::{Angles, Markup, read, read_as_written, read_markup, read_range};
pub use text::{Piece, Text};
pub use tree::{Expr, Function, Name, Relation, Span};
pub use turn::Turn;
pub use written::{in_degrees, ratio, written, written_angle};
