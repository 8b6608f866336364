//! Figures that come to the right number by chance: sums of masses, and of numbers that could be squares.

use super::compare::{any_within, is_composite};
use super::points::sizes;
use crate::expr::{Expr, Function};
use crate::mark::working::examine::Working;
use crate::mark::working::laws::are_bare;
use crate::mark::working::lines::Member;
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Axis, Quantity, Sphere};

impl Working<'_> {
    /// Is it worked out from more than the masses? Their sum is nothing that a law gives.
    pub(in crate::mark::working) fn is_worked_out(&self, expr: &Expr) -> bool {
        is_composite(expr) && !self.is_sum_of_masses(expr)
    }

    /// Is it called something? Figures before an equals sign are no name.
    pub(in crate::mark::working) fn is_called(&self, member: &Member) -> bool {
        member.label.as_ref().is_some_and(|label| label.contains(char::is_alphabetic))
    }

    /// Is nothing in it but masses, added or taken off?
    fn is_sum_of_masses(&self, expr: &Expr) -> bool {
        let masses = Sphere::BOTH.map(|sphere| sizes(&self.prepared.known, Quantity::Mass(sphere)));
        let masses: Vec<Vec<f64>> = masses.into_iter().flatten().collect();
        let is_mass = |term: &Expr| !is_composite(term) && self.is_one_of(term, &masses);
        matches!(expr, Expr::Sum(terms) if terms.iter().all(|term| match term {
            Expr::Negative(taken) => is_mass(taken),
            term => is_mass(term),
        }))
    }

    /// Are two numbers components of a sphere? They could be anything: that along the line of centres must be right, or what a
    /// line says of a letter.
    pub(in crate::mark::working) fn are_known_components(&self, across: &Expr, along: &Expr, sphere: Sphere) -> bool {
        let is = |expr: &Expr, sizes: &[Vec<f64>]| {
            self.is_one_of(expr, sizes) || self.is_near_one_of(expr, sizes) || self.rounds_one_of(expr, sizes)
        };
        let members = self.lines.iter().flat_map(|studied| self.members(studied));
        let of_letters = members.filter(|(member, _)| member.letter.is_some() && !member.is_given);
        let said = of_letters.filter_map(|(_, values)| numbers(values));
        let known = self.sizes_of(sphere, Axis::N).into_iter().chain(self.rebound_with_sine_for_cosine()).chain(said);
        let known: Vec<Vec<f64>> = known.collect();
        is(across, &self.sizes_of(sphere, Axis::T)) && is(along, &known)
    }

    /// `speed = 9 + 4`: numbers that are added up are squares only where a root is taken, or a square is what they are called.
    pub(in crate::mark::working) fn is_without_root(&self, member: &Member) -> bool {
        let is_bare = matches!(&member.expr, Expr::Sum(terms) if are_bare(terms));
        let is_square = |label: &String| label.contains(['²', '^']) || label.to_lowercase().contains("square");
        if !is_bare || member.label.as_ref().is_some_and(is_square) {
            return false;
        }
        let root = self.values_of(&Expr::call(Function::Sqrt, member.expr.clone()));
        let roots = Vec::from_iter(root.and_then(|root| numbers(&root)));
        let mut all = self.lines.iter().flat_map(|studied| self.members(studied));
        !all.any(|(other, _)| self.is_near_one_of(&other.expr, &roots))
    }

    /// Is there a sum of two squares that were worked out, both of them right, and one that of this component: `√(4 + 3.7)`?
    pub(in crate::mark::working) fn has_sum_of_squares(&self, expr: &Expr, sphere: Sphere, across: &[f64]) -> bool {
        let square = vec![across.iter().map(|size| size * size).collect::<Vec<f64>>()];
        let has_own = |terms: &[Expr]| {
            terms.iter().any(|term| self.is_one_of(term, &square) || self.is_near_one_of(term, &square))
        };
        any_within(expr, &|inner| {
            matches!(inner, Expr::Sum(terms) if are_bare(terms) && has_own(terms))
                && self.is_pythagoras(inner, Some(sphere))
        })
    }
}

/// Is it `6 - 4`? A component across the line of centres is no sum of numbers.
pub(in crate::mark::working) fn is_sum_of_figures(expr: &Expr) -> bool {
    let is_figure = |term: &Expr| match term {
        Expr::Negative(taken) => matches!(**taken, Expr::Number(_) | Expr::Decimal(_)),
        term => matches!(term, Expr::Number(_) | Expr::Decimal(_)),
    };
    matches!(expr, Expr::Sum(terms) if terms.iter().all(is_figure))
}
