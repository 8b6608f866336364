//! Marks of collisions that are given backwards, in vectors: momentum as a vector, the line of centres from an impulse,
//! components along it, and e from those.

use super::compare::{any_within, is_composite, is_parallel, is_vector};
use super::evidence::Evidence;
use super::examine::{Value, Working};
use super::points::sizes;
use super::spread::Spread;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mechanics::{Axis, Law, Moment, Quantity, Sphere};

impl Working<'_> {
    /// Momentum as a vector: an equation with the velocity that is to be found.
    pub(super) fn vector_momentum(&self, code: Code) -> Option<Evidence> {
        let unknown = Sphere::BOTH.into_iter().find(|sphere| {
            !self.prepared.given[0].0.contains_key(&Quantity::Velocity(*sphere, Moment::After, Axis::X))
        })?;
        let right = |axis| sizes(&self.prepared.known, Quantity::Velocity(unknown, Moment::After, axis));
        let (x, y) = right(Axis::X).zip(right(Axis::Y))?;
        let mut method = None;
        for (place, studied) in self.lines.iter().enumerate() {
            let Some(reading) = &studied.reading else { continue };
            // The velocity itself, or a multiple of it, is what the equation leads to.
            let is_velocity = self.members(studied).any(|(_, values)| is_vector(values, &x, &y, 1.0));
            if is_velocity || reading.equations.iter().any(|equation| self.solves_to(equation, &x, &y)) {
                return Some(Evidence::given(place, "momentum as a vector"));
            }
            let is_method = reading.equations.iter().any(|equation| self.is_momentum_of_vectors(equation));
            if is_method && method.is_none() {
                method = Some(place);
            }
        }
        let place = method?;
        let feedback = "a sign or a number in it is wrong".to_owned();
        match code.is_accuracy() {
            false => Some(Evidence::given(place, "momentum as a vector")),
            true => Some(Evidence {
                given: false,
                note: Some("sign-error"),
                feedback,
                ..Evidence::given(place, "momentum as a vector")
            }),
        }
    }

    /// Is the equation true when the unknown is this vector?
    fn solves_to(&self, (left, right): &(Expr, Expr), x: &[f64], y: &[f64]) -> bool {
        (0..self.prepared.points.count).all(|point| {
            let context = super::examine::context(self.prepared, point);
            let Some(super::linear::Sum::Vector(along_i, along_j)) = super::linear::difference(left, right, &context)
            else {
                return false;
            };
            let [(name, number)] = along_i.unknowns.as_slice() else { return false };
            let holds = |linear: &super::linear::Linear, value: f64| {
                let total = linear.before(name).times(value) + linear.constant;
                total.may_be_nought(linear.size.max((number.middle() * value).abs()))
            };
            holds(&along_i, x[point]) && holds(&along_j, y[point])
        })
    }

    /// Is it such an equation but for signs: the right mass before the unknown, and all three known momenta?
    fn is_momentum_of_vectors(&self, (left, right): &(Expr, Expr)) -> bool {
        let context = super::examine::context(self.prepared, 0);
        let Some(super::linear::Sum::Vector(along_i, along_j)) = super::linear::difference(left, right, &context)
        else {
            return false;
        };
        let [(_, number)] = along_i.unknowns.as_slice() else { return false };
        let known = &self.prepared.known[0..1];
        let at = |quantity| sizes(known, quantity).map(|sizes| sizes[0]);
        let momentum =
            |sphere, moment, axis| Some(at(Quantity::Mass(sphere))? * at(Quantity::Velocity(sphere, moment, axis))?);
        Sphere::BOTH.into_iter().any(|unknown| {
            let (Some(mass), other) = (at(Quantity::Mass(unknown)), unknown.other()) else { return false };
            let scale = number.middle() / mass;
            let fits = |axis: Axis, constant: Spread| -> Option<Vec<[f64; 3]>> {
                let terms = [
                    momentum(Sphere::A, Moment::Before, axis)?,
                    momentum(Sphere::B, Moment::Before, axis)?,
                    momentum(other, Moment::After, axis)?,
                ];
                let signs = (0..8).map(|bits| [0, 1, 2].map(|bit| if bits >> bit & 1 == 1 { -1.0 } else { 1.0 }));
                let sum =
                    |signs: &[f64; 3]| signs.iter().zip(&terms).map(|(sign, term)| sign * term * scale).sum::<f64>();
                Some(signs.filter(|signs| constant.may_be(sum(signs))).collect())
            };
            let (Some(one), Some(two)) = (fits(Axis::X, along_i.constant), fits(Axis::Y, along_j.constant)) else {
                return false;
            };
            one.iter().any(|signs| two.contains(signs))
        })
    }

    /// A change of momentum or of velocity, which is along the line of centres.
    pub(super) fn along_impulse(&self, law: Law) -> Option<Evidence> {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let (x, y) = line(Axis::X).zip(line(Axis::Y))?;
        let place = self
            .lines
            .iter()
            .position(|studied| self.members(studied).any(|(_, values)| is_parallel(values, &x, &y)))?;
        Some(Evidence::given(place, law.name()))
    }

    /// Components along the line of centres; a factor that all have in common does not matter.
    pub(super) fn resolved(&self, code: Code) -> Option<Evidence> {
        let quantities = Sphere::BOTH.into_iter().flat_map(|sphere| {
            [Moment::Before, Moment::After].map(|moment| Quantity::Velocity(sphere, moment, Axis::N))
        });
        let right: Vec<Vec<f64>> = quantities
            .filter_map(|quantity| sizes(&self.prepared.known, quantity))
            .filter(|sizes| sizes.iter().any(|size| size.abs() > 1e-9))
            .collect();
        let mut best: Option<(usize, usize)> = None;
        for scale in self.scales() {
            let seen = |right: &Vec<f64>| {
                self.lines.iter().position(|studied| {
                    let Some(reading) = &studied.reading else { return false };
                    let formulas = reading.members.iter().flat_map(|member| parts_of(&member.expr));
                    let scaled: Vec<f64> = right.iter().map(|right| right * scale).collect();
                    formulas.into_iter().any(|expr| self.is_one_of(expr, std::slice::from_ref(&scaled)))
                })
            };
            let places: Vec<usize> = right.iter().filter_map(seen).collect();
            if places.len() > best.map_or(0, |(count, _)| count) {
                best = Some((places.len(), places.into_iter().max().unwrap_or(0)));
            }
        }
        let (count, place) = best?;
        let enough = if code.is_accuracy() { count == right.len() } else { count >= 2.min(right.len()) };
        enough.then(|| Evidence::given(place, "components along the line of centres"))
    }

    /// By how much a student's vector along the line of centres may be longer than the unit vector.
    fn scales(&self) -> Vec<f64> {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let Some((x, y)) = line(Axis::X).zip(line(Axis::Y)) else { return vec![1.0] };
        let mut scales = vec![1.0];
        for studied in &self.lines {
            for (_, values) in self.members(studied).filter(|(_, values)| is_parallel(values, &x, &y)) {
                if let Some(Value::Vector(x, y)) = values.first() {
                    scales.push(x.middle().hypot(y.middle()));
                }
            }
        }
        let smallest = [x[0], y[0]].into_iter().map(f64::abs).filter(|size| *size > 1e-9).fold(f64::INFINITY, f64::min);
        // The shortest with whole components is what students use.
        scales.extend((1..=6).map(|whole| f64::from(whole) / smallest));
        scales
    }

    /// e as a quotient of two differences of components, whatever their signs.
    pub(super) fn restitution_from_components(&self) -> Option<Evidence> {
        let at =
            |sphere, moment| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, Axis::N)).map(|s| s[0]);
        let [a, b] = Sphere::BOTH.map(|sphere| at(sphere, Moment::Before));
        let [x, y] = Sphere::BOTH.map(|sphere| at(sphere, Moment::After));
        let (a, b, x, y) = (a?, b?, x?, y?);
        let scales = self.scales();
        let is = |expr: &Expr, sizes: [f64; 2], scale: f64| {
            let candidates: Vec<Vec<f64>> = sizes.iter().map(|size| vec![size * scale]).collect();
            self.is_one_of(expr, &candidates)
        };
        // Where e is given, two numbers are e as it stands in the question.
        let is_given = self.prepared.given[0].0.contains_key(&Quantity::Restitution);
        let is_quotient = |expr: &Expr| match expr {
            Expr::Quotient(above, below) if is_given && !is_composite(above) && !is_composite(below) => false,
            Expr::Quotient(above, below) => {
                let mut scales = scales.iter();
                scales.any(|scale| is(above, [y - x, y + x], *scale) && is(below, [a - b, a + b], *scale))
            }
            _ => false,
        };
        let line = self.lines.iter().position(|studied| {
            let Some(reading) = &studied.reading else { return false };
            reading.members.iter().any(|member| any_within(&member.expr, &is_quotient))
        })?;
        Some(Evidence::given(line, "a quotient of differences of components"))
    }
}

/// The formula and all that is added up in it.
fn parts_of(expr: &Expr) -> Vec<&Expr> {
    let mut all = vec![expr];
    match expr {
        Expr::Sum(_) | Expr::Quotient(..) | Expr::Negative(_) => {
            all.extend(expr.children().into_iter().flat_map(parts_of));
        }
        _ => {}
    }
    all
}
