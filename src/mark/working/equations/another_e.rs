//! Restitution that is right but for its coefficient: a number that is not the one given, or that of another impact.

use super::conventions::Convention;
use super::departure::Departure;
use super::pair::{Laws, Matched};
use crate::mark::working::numbers::Linear;
use crate::mechanics::Quantity;

impl Laws {
    /// The same laws beside other impacts with these coefficients of restitution.
    pub(in crate::mark::working) fn beside(mut self, restitutions: &[Vec<f64>]) -> Laws {
        let is_another = |of: &&Vec<f64>| of.iter().zip(&self.inputs).any(|(other, own)| (other - own.e).abs() > 1e-9);
        self.restitutions = restitutions.iter().filter(is_another).cloned().collect();
        self
    }

    /// Restitution with a number in place of e that could be one: misread, and otherwise right.
    pub(in crate::mark::working) fn with_another_restitution(
        &self,
        line: &[Linear],
        convention: &Convention,
    ) -> Option<Matched> {
        self.another_restitution(line, convention).map(|_| another_restitution())
    }

    /// The same with the coefficient of another impact, in a number that was worked out with it too: `w - v = 6`.
    pub(super) fn with_restitution_of_another(&self, line: &[Linear], convention: &Convention) -> Option<Matched> {
        let factors = self.factors_of_approach(line, convention)?;
        let is = |of: &Vec<f64>| factors.iter().zip(of).all(|(factor, own)| (factor - own).abs() < 1e-6);
        self.restitutions.iter().any(is).then(another_restitution)
    }

    /// That number.
    pub(super) fn another_restitution(&self, line: &[Linear], convention: &Convention) -> Option<f64> {
        let factors = self.factors_of_approach(line, convention)?;
        let first = *factors.first()?;
        let is_one = factors.iter().all(|factor| (factor - first).abs() < 1e-6);
        (is_one && (0.01..0.99).contains(&first)).then_some(first)
    }

    /// What stands before the speed of approach at every point, where the other side is the speed of separation.
    fn factors_of_approach(&self, line: &[Linear], convention: &Convention) -> Option<Vec<f64>> {
        let factors = self.inputs.iter().zip(line).map(|(at, line)| {
            let is_of_both = line.unknowns.iter().all(|(name, _)| convention.letters.contains(name));
            let [v, w] = [0, 1].map(|place| line.before(&convention.letters[place]).middle() * convention.signs[place]);
            let is_difference = (v + w).abs() <= 1e-9 * w.abs() && w != 0.0;
            (is_of_both && is_difference).then(|| -line.constant.middle() / (w * (at.along[0] - at.along[1])))
        });
        factors.collect()
    }
}

fn another_restitution() -> Matched {
    Matched::with(Quantity::RestitutionEquation, Departure::AnotherRestitution)
}
