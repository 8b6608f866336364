//! Momentum as a vector, where a collision is given backwards.

use super::by_components::{AlongAxis, momentum_by_components, signs};
use super::impulse::Agrees;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::award::Ground;
use crate::mark::working::equations::Departure;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working, context};
use crate::mark::working::numbers::{Context, Linear, Spread, Sum, difference, is_vector, sizes};
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
        let is_open = |quantity| !self.prepared.given[0].0.contains_key(&quantity);
        let unknown =
            Sphere::BOTH.into_iter().find(|sphere| is_open(Quantity::Velocity(*sphere, Moment::After, Axis::X)));
        let Some(unknown) = unknown else {
            let sphere = Sphere::BOTH.into_iter().find(|sphere| is_open(Quantity::Mass(*sphere)))?;
            return self.momentum_for_mass(sphere, code);
        };
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

    /// Momentum as a vector where all four velocities are given, and the mass of this sphere is to be found.
    fn momentum_for_mass(&self, sphere: Sphere, code: Code) -> Option<Evidence> {
        // What the mass is, is not known here, whatever it is called.
        let of_it = format!("m_{}", sphere.name());
        let index = if sphere == Sphere::A { "m_1" } else { "m_2" };
        let is_other = |(name, _): &&(String, Vec<f64>)| *name != of_it && name != index;
        let names: Vec<(String, Vec<f64>)> = self.prepared.names.iter().filter(is_other).cloned().collect();
        let context = Context { given: &names, ..context(self.prepared, 0) };
        let known = |quantity| sizes(&self.prepared.known, quantity).map(|sizes| sizes[0]);
        let mass = known(Quantity::Mass(sphere.other()))?;
        let axes = [Axis::X, Axis::Y].map(|axis| {
            let at = |sphere, moment| known(Quantity::Velocity(sphere, moment, axis));
            let [own, other] =
                [sphere, sphere.other()].map(|sphere| [at(sphere, Moment::Before), at(sphere, Moment::After)]);
            Some(([own[0]?, own[1]?], [mass * other[0]?, mass * other[1]?]))
        });
        let [Some(along_i), Some(along_j)] = axes else { return None };
        // The signs of what is before and after the impact, of either sphere.
        let fits = |linear: &Linear, (own, other): ([f64; 2], [f64; 2]), signs: [f64; 3]| {
            let one = |[before, after]: [f64; 2], sign: f64| before + sign * after;
            let (number, constant) = (one(own, signs[0]), signs[2] * one(other, signs[1]));
            let before = linear.unknowns.first().map_or(Spread::exactly(0.0), |(_, number)| *number);
            linear.unknowns.len() <= 1 && before.may_be(number) && linear.constant.may_be(constant)
        };
        let signs: Vec<[f64; 3]> =
            (0..8).map(|bits| [0, 1, 2].map(|bit| if bits >> bit & 1 == 1 { -1.0 } else { 1.0 })).collect();
        let agrees = |(left, right): &(Expr, Expr)| {
            let turned = |linear: &Linear| linear.clone().times(Spread::exactly(-1.0));
            let is = |linear: &Linear, axis, signs: &[f64; 3]| {
                fits(linear, axis, *signs) || fits(&turned(linear), axis, *signs)
            };
            let own = match difference(left, right, &context)? {
                Sum::Vector(x, y) => signs.iter().find(|signs| is(&x, along_i, signs) && is(&y, along_j, signs)),
                // One of its components is enough for one unknown.
                Sum::Number(linear) if linear.is_number() => None,
                Sum::Number(linear) => {
                    signs.iter().find(|signs| is(&linear, along_i, signs) || is(&linear, along_j, signs))
                }
            }?;
            Some(*own == [-1.0, -1.0, 1.0])
        };
        let all = self.lines.iter().enumerate().flat_map(|(place, studied)| {
            let equations = studied.reading.iter().flat_map(|reading| &reading.equations);
            equations.filter_map(move |equation| Some((place, agrees(equation)?)))
        });
        let all: Vec<(usize, bool)> = all.collect();
        let (place, is_right) = all.iter().find(|(_, is_right)| *is_right).or(all.first())?;
        let found = Evidence::given(*place, "momentum as a vector");
        let feedback = "a sign or a number in it is wrong".to_owned();
        match *is_right || !code.is_accuracy() {
            true => Some(found),
            false => Some(Evidence { given: false, note: Some(Departure::Sign.tag()), feedback, ..found }),
        }
    }
}
