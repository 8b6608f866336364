//! The impulse on one sphere, known by the shape of its formula: `m(v - u)`, `mv - mu`, or `v - u` where m is 1.
//!
//! The mass and the components along the line of centres must be those of one sphere. Signs are condoned.

use crate::expr::Expr;
use crate::mark::working::examine::Working;
use crate::mark::working::numbers::{any_within, sizes};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

impl Working<'_> {
    /// `m(v - u)` for one of the spheres: its own mass, and its own components along the line of centres. A mass of 1 is
    /// seen only where the difference is called something.
    pub(super) fn is_change_of_momentum(&self, expr: &Expr, is_called: bool) -> bool {
        if let Expr::Negative(inner) = expr {
            return self.is_change_of_momentum(inner, is_called);
        }
        let own = |quantity| sizes(&self.prepared.known, quantity);
        Sphere::BOTH.into_iter().any(|sphere| {
            let before = own(Quantity::Velocity(sphere, Moment::Before, Axis::N));
            let (Some(mass), Some(before)) = (own(Quantity::Mass(sphere)), before) else { return false };
            let (before, after) = ([before], self.sizes_of(sphere, Axis::N));
            let is_mass = |expr: &Expr| self.is_one_of(expr, std::slice::from_ref(&mass));
            if let Some((common, change)) = factored(expr)
                && is_mass(&common)
            {
                return self.are_both(change, &before, &after);
            }
            // A mass of 1 that is written with one of them is a number like any other.
            let is_one = is_called && mass.iter().all(|mass| *mass == 1.0);
            let has_mass = |term: &&Expr| match unsigned(term) {
                Expr::Product(_) => !self.question.letters.is_empty() && self.has_mass(term, &mass),
                _ => is_one,
            };
            let momenta = |velocities: &[Vec<f64>]| -> Vec<Vec<f64>> {
                let times = |sizes: &Vec<f64>| sizes.iter().zip(&mass).map(|(size, mass)| size * mass).collect();
                velocities.iter().map(times).collect()
            };
            two(expr).is_some_and(|terms| {
                terms.iter().all(has_mass) && self.are_both(terms, &momenta(&before), &momenta(&after))
            })
        })
    }

    /// Does a mass stand in a formula: by itself, or as factors beside each other, `6m` in `6m × 4u`?
    pub(super) fn has_mass(&self, expr: &Expr, mass: &[f64]) -> bool {
        let is_mass = |expr: &Expr| self.is_one_of(expr, &[mass.to_vec()]);
        let is_run = |factors: &[Expr]| is_mass(&Expr::Product(factors.to_vec()));
        any_within(expr, &|inner| match inner {
            Expr::Product(factors) => (2..factors.len()).any(|length| factors.windows(length).any(is_run)),
            other => is_mass(other),
        })
    }

    /// Is one of two terms what there was before, and the other what there is after? Two figures are enough to see which.
    fn are_both(&self, [one, other]: [&Expr; 2], before: &[Vec<f64>], after: &[Vec<f64>]) -> bool {
        let is = |expr: &Expr, sizes: &[Vec<f64>]| self.is_one_of(expr, sizes) || self.is_near_one_of(expr, sizes);
        is(one, before) && is(other, after) || is(other, before) && is(one, after)
    }
}

fn unsigned(term: &Expr) -> &Expr {
    if let Expr::Negative(inner) = term { inner } else { term }
}

/// The terms of a sum of two.
pub(super) fn two(expr: &Expr) -> Option<[&Expr; 2]> {
    match expr {
        Expr::Sum(terms) => <&[Expr; 2]>::try_from(terms.as_slice()).ok().map(|terms| terms.each_ref()),
        _ => None,
    }
}

/// `m(v - u)`, `6m(v - u)` or `2 × 6 - 2 × 3`: the mass, and what it multiplies.
fn factored(expr: &Expr) -> Option<(Expr, [&Expr; 2])> {
    fn factors(expr: &Expr) -> Option<[&Expr; 2]> {
        match expr {
            Expr::Product(factors) => <&[Expr; 2]>::try_from(factors.as_slice()).ok().map(|both| both.each_ref()),
            Expr::Negative(inner) => factors(inner),
            _ => None,
        }
    }
    match two(expr) {
        Some(terms) => {
            let [one, other] = terms.map(factors);
            let ([mass, before], [same, after]) = (one?, other?);
            (mass == same).then(|| (mass.clone(), [before, after]))
        }
        None => {
            let Expr::Product(all) = expr else { return None };
            let at = all.iter().position(|factor| two(factor).is_some())?;
            let mut mass = all.clone();
            mass.remove(at);
            Some((if mass.len() == 1 { mass.remove(0) } else { Expr::Product(mass) }, two(&all[at])?))
        }
    }
}
