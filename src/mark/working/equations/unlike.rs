//! Lines that are meant for momentum and are further from it than any mistake that has a name: how much of it is right.

use super::conventions::Convention;
use super::offered::differences;
use super::pair::Laws;
use super::shown_e::shows_e;
use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::working::examine::{Studied, Working};
use crate::mark::working::numbers::Linear;
use crate::mechanics::Quantity;

/// The masses of both spheres stand where they should, and the total before is another.
const AFTER_ALONE: &str = "momentum: what there is before the impact is not its total along the line of centres";
const NEITHER: &str =
    "this is not momentum along the line of centres: every term is the mass of a sphere times its own velocity";

impl Working<'_> {
    /// Says of the first line with both velocities after the impact, where none is momentum and this is neither law, however
    /// changed, what of momentum it has. Of what leads to a printed result in another way a person is told.
    pub(in crate::mark::working) fn tell_unlike_momentum(&mut self) {
        let is_momentum =
            |studied: &Studied| studied.matched.iter().any(|one| one.equation == Quantity::MomentumEquation);
        let is_told = self.lines.iter().any(|studied| is_momentum(studied) || studied.role.contains("momentum"));
        let is_shown = || self.part.blanks.iter().any(|blank| blank.model.kind == Kind::Shown);
        if is_told || !self.question.scene.then.is_empty() || is_shown() {
            return;
        }
        let told = |(place, studied): (usize, &Studied)| Some((place, self.unlike_momentum(studied)?));
        if let Some((place, role)) = self.lines.iter().enumerate().find_map(told) {
            role.clone_into(&mut self.lines[place].role);
        }
    }

    fn unlike_momentum(&self, studied: &Studied) -> Option<&'static str> {
        let reading = studied.reading.as_ref().filter(|_| studied.role.is_empty())?;
        let (laws, convention) = (self.prepared.laws.as_ref()?, self.convention.as_ref()?);
        let has_e = |(left, right): &&(Expr, Expr)| [left, right].iter().any(|side| shows_e(side, self.prepared));
        let mut equations = reading.equations.iter().filter(|equation| !has_e(equation));
        equations.find_map(|equation| laws.unlike_momentum(&differences(equation, self.prepared)?, convention))
    }
}

impl Laws {
    /// What a line with both unknowns, all on one side, has of momentum, whichever way is positive. Where its numbers before
    /// the unknowns are alike it may as well be restitution, and what is true of the velocities is no law written wrongly.
    fn unlike_momentum(&self, line: &[Linear], convention: &Convention) -> Option<&'static str> {
        let [x, y] = &convention.letters;
        let numbers = |linear: &Linear| {
            let [p, q, r] = linear.in_numbers([x, y]);
            (linear.unknowns.len() == 2 && p != 0.0 && q != 0.0).then_some([p, q, r].map(f64::abs))
        };
        let own: Vec<[f64; 3]> = line.iter().map(numbers).collect::<Option<_>>()?;
        let is_true = self.after.as_ref().is_some_and(|after| {
            own.iter().zip(after).all(|([p, q, r], [v, w])| {
                let [v, w] = [p * v, q * w];
                is_about((v + w).abs(), *r) || is_about((v - w).abs(), *r)
            })
        });
        let are_alike = own.iter().all(|[p, q, _]| is_about(*p, *q));
        let has_masses =
            own.iter().zip(&self.inputs).all(|([p, q, _], at)| is_about(p * at.masses[1], q * at.masses[0]));
        match has_masses {
            _ if are_alike || is_true => None,
            true => Some(AFTER_ALONE),
            false => Some(NEITHER),
        }
    }
}

/// Are they one number, but for what was rounded?
fn is_about(one: f64, other: f64) -> bool {
    /// As a part of the greater.
    const ROUNDED: f64 = 0.005;
    (one - other).abs() <= ROUNDED * one.abs().max(other.abs())
}

#[cfg(test)]
mod tests {
    use super::{AFTER_ALONE, NEITHER};
    use crate::mark::shipped_key;
    use crate::mark::working::{Theirs, examine};

    #[test]
    fn a_line_that_is_far_from_momentum_is_told_what_of_it_is_right() {
        // 2 kg and 3 kg, towards each other with 5 m/s and 1 m/s: 10 - 3 = 2v + 3w.
        let key = shipped_key("direct/velocities-after-impact", 1);
        let question = &key.papers[0].questions[0];
        let role = |line: &str| {
            let lines = examine(question, &question.parts[0], &[line.to_owned()], &Theirs::default()).lines;
            lines[0].role.clone()
        };
        let said = |role: &str| question.said_of_impact(role);
        for (line, told) in [
            ("2*5 + 3*7 = 2v + 3w", said(AFTER_ALONE)),
            ("2*5 + 1 = 3v - w", said(NEITHER)),
            // What may be restitution, what is true, and momentum with a mistake that has a name.
            ("5 + 2 = v - w", String::new()),
            ("4v + w = 4.2", String::new()),
            ("2*5 + 3 = 2v + 3w", "momentum: a sign is wrong: keep one positive direction for every term".to_owned()),
        ] {
            assert_eq!(role(line), told, "{line}");
        }
    }
}
