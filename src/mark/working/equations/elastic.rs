//! In an elastic impact no energy is lost, and that may stand in place of restitution.

use super::convention::is_value;
use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Working, context};
use crate::mark::working::numbers::{Context, constant, sizes};
use crate::mechanics::{Axis, Law, Moment, Quantity, Sphere};

/// What both letters are tried for: an equation that agrees with another at so many places is that equation, for it has no
/// other terms than their squares.
const TRIED: [[f64; 2]; 4] = [[1.3, 2.9], [-0.7, 1.1], [2.3, -1.9], [0.4, 0.6]];

impl Working<'_> {
    /// Where e is 1, a line that sets the energy after the impact equal to that before it.
    pub(in crate::mark::working) fn energy_kept(&self, law: Law) -> Option<Evidence> {
        let e = sizes(&self.prepared.known, Quantity::Restitution)?;
        if !law.gives(Quantity::RestitutionEquation) || e.iter().any(|e| *e != 1.0) {
            return None;
        }
        let line = self.lines.iter().position(|studied| {
            let equations = studied.reading.iter().flat_map(|reading| &reading.equations);
            equations.filter(|equation| !is_value(equation)).any(|equation| self.says_energy_is_kept(equation))
        })?;
        Some(Evidence::given(line, law.name()))
    }

    /// Is left less right a multiple of the energy after the impact less that before it, whatever the letters are?
    fn says_energy_is_kept(&self, (left, right): &(Expr, Expr)) -> bool {
        let Some(convention) = &self.convention else { return false };
        let at = |of: &dyn Fn(Sphere) -> Quantity| {
            let [a, b] = Sphere::BOTH.map(|sphere| sizes(&self.prepared.known, of(sphere)));
            a.zip(b)
        };
        let masses = at(&Quantity::Mass);
        let before = at(&|sphere| Quantity::Velocity(sphere, Moment::Before, Axis::N));
        let Some((masses, before)) = masses.zip(before) else { return false };
        (0..self.prepared.points.count).all(|point| {
            let energy = |[v, w]: [f64; 2]| {
                masses.0[point] * (v * v - before.0[point].powi(2))
                    + masses.1[point] * (w * w - before.1[point].powi(2))
            };
            let multiple = |tried: [f64; 2]| {
                let mut names = self.prepared.names.clone();
                let count = self.prepared.points.count;
                names.extend(
                    convention.letters.iter().zip(tried).map(|(letter, size)| (letter.clone(), vec![size; count])),
                );
                let context = Context { given: &names, ..context(self.prepared, point) };
                let difference = constant(left, &context)?.middle() - constant(right, &context)?.middle();
                Some(difference / energy(tried))
            };
            let Some(multiples) = TRIED.into_iter().map(multiple).collect::<Option<Vec<f64>>>() else { return false };
            let first = multiples[0];
            first.is_finite()
                && first != 0.0
                && multiples.iter().all(|other| (other - first).abs() < 1e-6 * first.abs())
        })
    }
}
