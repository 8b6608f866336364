//! The critical case of an inequality: a velocity is taken to be nought, and the two laws are written without its term.
//!
//! Where *A* is to be turned back, `for v = 0: 10 = 3w, w = 5e` are both laws as they stand there; what is left is on which side of
//! the value the range lies.

use super::convention::is_value;
use super::conventions::Convention;
use super::pair::Laws;
use crate::expr::Expr;
use crate::mark::working::examine::Studied;
use crate::mark::working::numbers::Linear;
use crate::mark::working::prepared::Prepared;
use crate::mechanics::{Axis, Moment, Quantity, Scene, Sphere};

/// The laws where the velocity that an inequality compares with nought is nought.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct Critical {
    of: Sphere,
    laws: Laws,
}

impl Critical {
    /// The critical case of a question, if its condition is the sign of a velocity along the line of centres after the impact.
    pub(in crate::mark::working) fn of(scene: &Scene, prepared: &Prepared) -> Option<Critical> {
        let condition = scene.conditions.first().filter(|condition| condition.is_inequality())?;
        let Expr::Name(name) = &condition.left else { return None };
        let quantity = prepared.along(name.text.parse().ok()?);
        let Quantity::Velocity(of, Moment::After, Axis::N) = quantity else { return None };
        let laws = prepared.laws.as_ref().filter(|_| condition.right.is_zero())?;
        Some(Critical { of, laws: laws.with_at_rest(of) })
    }

    /// The laws for an equation, if it is of the other velocity alone and this one is nought there: a line up to this one has said
    /// so, or a nought stands for its term.
    pub(super) fn laws_for(
        &self,
        (line, place, has_nought): (&Linear, usize, bool),
        convention: &Convention,
        noughts: &[(usize, String)],
    ) -> Option<&Laws> {
        let [this, other] = [self.of, self.of.other()].map(|sphere| &convention.letters[sphere as usize]);
        let is_of_other = matches!(line.unknowns.as_slice(), [(name, _)] if name == other);
        let is_nought = || noughts.iter().any(|(said, letter)| *said <= place && letter == this);
        (is_of_other && (has_nought || is_nought())).then_some(&self.laws)
    }
}

/// The letters that lines say are nought, with the places of the lines.
pub(super) fn noughts(lines: &[Studied]) -> Vec<(usize, String)> {
    let readings = lines.iter().enumerate().flat_map(|(place, studied)| {
        studied.line.readings.iter().flat_map(|reading| &reading.equations).map(move |equation| (place, equation))
    });
    let said = |(place, equation): (usize, &(Expr, Expr))| match equation {
        (Expr::Name(name), nought) | (nought, Expr::Name(name)) if is_value(equation) && nought.is_zero() => {
            Some((place, name.text.clone()))
        }
        _ => None,
    };
    readings.filter_map(said).collect()
}

/// Is one of the terms of an equation a nought as it stands: `10 = 0 + 3w`, `w - 0 = 5e`, `2(0) + 3w`?
pub(super) fn has_nought_term((left, right): &(Expr, Expr)) -> bool {
    fn is_nought(expr: &Expr) -> bool {
        match expr {
            Expr::Negative(inner) => is_nought(inner),
            Expr::Product(factors) => factors.iter().any(is_nought),
            other => other.is_zero(),
        }
    }
    [left, right].into_iter().any(|side| matches!(side, Expr::Sum(terms) if terms.iter().any(is_nought)))
}
