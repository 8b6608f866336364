//! The letters by which the working calls what it finds: the usual one, or another where the scene has that letter itself.

use super::Show;
use crate::expr::Expr;

/// The usual letter of each thing, and what stands for it where that is taken. β and δ are none of them: a question has
/// letters of its own for those angles, which the paper puts in their place.
const NAMES: &[[&str; 3]] =
    &[["I", "J", "Q"], ["L", "D", "W"], ["f", "F", "k"], ["s", "S", "d"], ["alpha", "phi", "theta"]];

impl Show<'_> {
    /// Does a letter of this name occur in the scene?
    pub(super) fn taken(&self, name: &str) -> bool {
        self.scene.letters.iter().any(|letter| letter.name() == name)
    }

    /// The letter for what is usually called so.
    pub fn letter(&self, usual: &'static str) -> &'static str {
        let names = NAMES.iter().find(|names| names[0] == usual);
        names.and_then(|names| names.iter().find(|name| !self.taken(name))).copied().unwrap_or(usual)
    }

    /// The same as an expression.
    pub fn name(&self, usual: &'static str) -> Expr {
        Expr::name(self.letter(usual))
    }

    /// The vector whose magnitude is usually called so.
    pub fn vector_name(&self, usual: &'static str) -> Expr {
        Expr::name(format!("vector.{}", self.letter(usual)))
    }

    /// The name of the angle between the path of A and the line of centres.
    pub fn contact_angle(&self) -> &'static str {
        self.letter("alpha")
    }
}
