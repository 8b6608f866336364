//! Momentum as a vector, where a collision is given backwards.

use super::by_components::{AlongAxis, momentum_by_components, signs};
use super::compare::is_vector;
use super::evidence::Evidence;
use super::examine::{Studied, Working, context};
use super::impulse::Agrees;
use super::linear::{Linear, Sum, difference};
use super::pair::Departure;
use super::points::sizes;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::award::Ground;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// A right velocity in a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stated {
    Found,
    /// The student's own equations lead elsewhere.
    Denied,
}

impl Working<'_> {
    /// Momentum as a vector: an equation with the velocity that is to be found, or what it leads to.
    pub(super) fn vector_momentum(&self, code: Code) -> Option<Evidence> {
        let unknown = Sphere::BOTH.into_iter().find(|sphere| {
            !self.prepared.given[0].0.contains_key(&Quantity::Velocity(*sphere, Moment::After, Axis::X))
        })?;
        let right = |axis| sizes(&self.prepared.known, Quantity::Velocity(unknown, Moment::After, axis));
        let (x, y) = right(Axis::X).zip(right(Axis::Y))?;
        let found = |place: usize| Some(Evidence::given(place, "momentum as a vector"));
        let lost = |place: usize, note: &'static str, feedback: &str| {
            found(place).map(|found| Evidence {
                given: false,
                note: Some(note),
                feedback: feedback.to_owned(),
                ..found
            })
        };
        // The velocity itself, or a multiple of it, is what the equation leads to, if it is not another one.
        let stated: Vec<_> = self.lines.iter().map(|studied| self.states_velocity(studied, &x, &y)).collect();
        let equations = |place: usize| self.lines[place].reading.iter().flat_map(|reading| &reading.equations);
        let leads = stated.iter().enumerate().position(|(place, stated)| match stated {
            Some(stated) => *stated == Stated::Found,
            None => equations(place).any(|equation| self.solves_to(equation, &x, &y)),
        });
        if let Some(place) = leads {
            return found(place);
        }
        let denied = stated.iter().position(|stated| *stated == Some(Stated::Denied));
        let last = |[one, other]: &[AlongAxis; 2]| one.place.max(other.place);
        let by_components = momentum_by_components(&self.lines, self.prepared);
        let by_components = by_components.filter(|both| Some(last(both)) != denied);
        if let Some(both) = by_components.as_ref().filter(|both| both.iter().all(|one| one.agrees == Agrees::Fully)) {
            return found(last(both));
        }
        let is_method = |place| equations(place).any(|equation| self.is_momentum_of_vectors(equation));
        let method = (0..self.lines.len()).find(|place| stated[*place].is_none() && is_method(*place));
        match (method.or(by_components.as_ref().map(last)), code.is_accuracy()) {
            (Some(place), false) => found(place),
            (Some(place), true) => lost(place, Departure::Sign.tag(), "a sign or a number in it is wrong"),
            (None, _) => {
                let feedback = "the velocity is right, but your equation leads to another";
                lost(denied?, Ground::Contradicted.tag(), feedback)
            }
        }
    }

    /// Is the velocity that is to be found in a line, and do the student's own equations deny it?
    fn states_velocity(&self, studied: &Studied, x: &[f64], y: &[f64]) -> Option<Stated> {
        let mut velocity = self.members(studied).filter(|(_, values)| is_vector(values, x, y, 1.0)).peekable();
        velocity.peek()?;
        let is_denied = velocity.all(|(member, _)| self.is_denied_by_equations(member));
        Some(if is_denied { Stated::Denied } else { Stated::Found })
    }

    /// Is the equation true when the unknown is this vector?
    fn solves_to(&self, (left, right): &(Expr, Expr), x: &[f64], y: &[f64]) -> bool {
        (0..self.prepared.points.count).all(|point| {
            let context = context(self.prepared, point);
            let Some(Sum::Vector(along_i, along_j)) = difference(left, right, &context) else {
                return false;
            };
            let [(name, number)] = along_i.unknowns.as_slice() else { return false };
            let holds = |linear: &Linear, value: f64| {
                let total = linear.before(name).times(value) + linear.constant;
                total.may_be_nought(linear.size.max((number.middle() * value).abs()))
            };
            holds(&along_i, x[point]) && holds(&along_j, y[point])
        })
    }

    /// Is it such an equation but for signs: the right mass before the unknown, and all three known momenta?
    fn is_momentum_of_vectors(&self, (left, right): &(Expr, Expr)) -> bool {
        let context = context(self.prepared, 0);
        let Some(Sum::Vector(along_i, along_j)) = difference(left, right, &context) else {
            return false;
        };
        Sphere::BOTH.into_iter().any(|unknown| {
            let fits = |axis, linear| signs(linear, unknown, axis, self.prepared, 0);
            let (one, two) = (fits(Axis::X, &along_i), fits(Axis::Y, &along_j));
            one.iter().any(|signs| two.contains(signs))
        })
    }
}
