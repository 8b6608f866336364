//! Components along a line of centres that is the student's own, and wrong: the method is the same as along the right one.

use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working};
use crate::mark::working::lines::{Member, says_along};
use crate::mark::working::numbers::{any_within, is_composite, is_parallel, sizes};
use crate::mechanics::{Axis, Law, Moment, Quantity, Sphere};

/// The components along a line of A and of B before an impact, and of both after it, at every point.
type Along = [[Vec<f64>; 2]; 2];

impl Working<'_> {
    /// The velocities resolved along the student's own line: two components at least, each worked out.
    pub(super) fn resolved_along_own_line(&self) -> Option<Evidence> {
        let of_line = |(place, along): &(usize, Along)| {
            let mut sizes: Vec<&Vec<f64>> = Vec::new();
            for size in along.iter().flatten() {
                let is_alike = |other: &&&Vec<f64>| are_of_one_size(other, size);
                if size.iter().all(|size| size.abs() > 1e-9) && !sizes.iter().any(|other| is_alike(&other)) {
                    sizes.push(size);
                }
            }
            let line_of = |size: &&Vec<f64>| {
                let has_it = |studied: &Studied| {
                    let is = |member: &Member| {
                        is_worked_out(studied, member) && self.is_one_of(&member.expr, std::slice::from_ref(*size))
                    };
                    self.members(studied).any(|(member, _)| is(member))
                };
                self.lines.iter().skip(*place).position(has_it).map(|after| place + after)
            };
            let places: Vec<usize> = sizes.iter().filter_map(line_of).collect();
            places.iter().max().copied().filter(|_| places.len() > 1)
        };
        let line = self.along_own_lines().iter().find_map(of_line)?;
        Some(Evidence::followed(line, "components along the line of centres"))
    }

    /// *e* as a quotient of two differences of such components, whatever their signs.
    pub(super) fn restitution_along_own_line(&self, law: Law) -> Option<Evidence> {
        let of_line = |(place, [[a, b], [x, y]]): &(usize, Along)| {
            let both = |one: &Vec<f64>, other: &Vec<f64>| {
                [1.0, -1.0].map(|sign| one.iter().zip(other).map(|(one, other)| one + sign * other).collect())
            };
            let [above, below]: [[Vec<f64>; 2]; 2] = [both(x, y), both(a, b)];
            let is_quotient = |inner: &Expr| match inner {
                Expr::Quotient(over, under) => self.is_one_of(over, &above) && self.is_one_of(under, &below),
                _ => false,
            };
            let shows =
                |studied: &Studied| self.members(studied).any(|(member, _)| any_within(&member.expr, &is_quotient));
            self.lines.iter().skip(*place).position(shows).map(|after| place + after)
        };
        let line = self.along_own_lines().iter().find_map(of_line)?;
        Some(Evidence::followed(line, law.name()))
    }

    /// The components along each vector that the student takes for the line of centres though it is not, and along the unit
    /// vector that way, with the place of its line.
    fn along_own_lines(&self) -> Vec<(usize, Along)> {
        let right = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let Some((x, y)) = right(Axis::X).zip(right(Axis::Y)).filter(|_| self.is_in_vectors()) else {
            return Vec::new();
        };
        let taken = |(place, studied): (usize, &Studied)| {
            let typed = &studied.line.typed;
            let vectors: Vec<&Vec<Value>> = self.vectors_in(studied).collect();
            let last = *vectors.last()?;
            // What is along the line of centres, and worked out wrongly.
            let is_slip = vectors.iter().any(|values| is_parallel(values, &x, &y));
            let is_meant = is_slip || says_along(typed) || typed.contains("parallel") || typed.starts_with("loc");
            (is_meant && !is_parallel(last, &x, &y)).then(|| (place, last.clone()))
        };
        let own = self.lines.iter().enumerate().filter_map(taken);
        own.flat_map(|(place, line)| {
            [false, true]
                .map(|is_unit| self.components_along(&line, is_unit))
                .into_iter()
                .flatten()
                .map(move |along| (place, along))
        })
        .collect()
    }

    fn components_along(&self, line: &[Value], is_unit: bool) -> Option<Along> {
        let component = |sphere, moment| -> Option<Vec<f64>> {
            let velocity = |axis| {
                let quantity = Quantity::Velocity(sphere, moment, axis);
                let own = self.theirs.values.get(&quantity).map(|(values, _)| values.clone());
                own.or_else(|| sizes(&self.prepared.known, quantity))
            };
            let (x, y) = velocity(Axis::X).zip(velocity(Axis::Y))?;
            let at = |(line, (x, y)): (&Value, (&f64, &f64))| match line {
                Value::Vector(along_i, along_j) => {
                    let (i, j) = (along_i.middle(), along_j.middle());
                    Some((x * i + y * j) / if is_unit { i.hypot(j) } else { 1.0 })
                }
                Value::Number(_) => None,
            };
            line.iter().zip(x.iter().zip(&y)).map(at).collect()
        };
        let both = |moment| Some([component(Sphere::A, moment)?, component(Sphere::B, moment)?]);
        Some([both(Moment::Before)?, both(Moment::After)?])
    }
}

/// `6 - 8`, or what the product of two vectors is said to be: `(2i + 5j).(2i - j) = -1`.
fn is_worked_out(studied: &Studied, member: &Member) -> bool {
    let typed: String = studied.line.typed.chars().filter(|sign| !sign.is_whitespace()).collect();
    is_composite(&member.expr) || [").(", ")·(", ")•(", ")⋅("].iter().any(|dot| typed.contains(dot))
}

fn are_of_one_size(one: &[f64], other: &[f64]) -> bool {
    one.iter().zip(other).all(|(one, other)| (one.abs() - other.abs()).abs() < 1e-9)
}
