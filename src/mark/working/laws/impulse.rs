//! The impulse on a particle by itself: it is known where a line has it as the mass times the change of velocity.
//!
//! One of the impulse and the two velocities is to be found. A line is an equation of vectors in it, or two lines are its
//! components along i and j: the mass belongs to both velocities, and an equation without it is none. Signs are condoned
//! for the method.

use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Value, Working, context};
use crate::mark::working::numbers::{Linear, Spread, Sum, any_within, difference, is_composite, is_vector, sizes};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// What is known of the particle along one axis, at every point.
struct Along {
    /// Is it the impulse that is to be found?
    is_impulse: bool,
    /// What is to be found: the impulse, or one of the velocities.
    sought: Vec<f64>,
    /// How much of what is sought stands in a line with the mass of the law: one of an impulse, a mass of a velocity.
    weight: Vec<f64>,
    /// The other two terms of the law.
    others: [Vec<f64>; 2],
}

/// How a line agrees with the law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Agrees {
    ButForSigns,
    Fully,
}

impl Working<'_> {
    /// A mark for the impulse on a particle as its change of momentum.
    pub(super) fn impulse_of_particle(&self, code: Code) -> Option<Evidence> {
        let axes = [Axis::X, Axis::Y].map(|axis| self.along(axis));
        let [Some(x), Some(y)] = &axes else { return None };
        let role = "the impulse as a change of momentum";
        let mut method = None;
        // Components may be on lines of their own.
        let mut seen: [Option<Agrees>; 2] = [None, None];
        for (place, studied) in self.lines.iter().enumerate() {
            let Some(reading) = &studied.reading else { continue };
            let by_values = self.members(studied).filter_map(|(member, values)| {
                let is_right = is_vector(values, &x.sought, &y.sought, 1.0) || self.has_squares(&member.expr, x, y);
                match is_right && !self.is_denied_by_line(studied, member) {
                    true => Some(Agrees::Fully),
                    false => is_worked(&member.expr).then(|| sought_but_for_signs(values, x, y)).flatten(),
                }
            });
            let by_equations = reading.equations.iter().filter_map(|equation| self.of_vectors(equation, x, y));
            let mut best = by_values.chain(by_equations).max();
            for (axis, along) in [x, y].into_iter().enumerate() {
                let of_axis = reading.equations.iter().filter_map(|equation| self.of_components(equation, along)).max();
                seen[axis] = seen[axis].max(of_axis);
            }
            if let [Some(one), Some(other)] = seen {
                best = best.max(Some(one.min(other)));
            }
            match best {
                Some(Agrees::Fully) => return Some(Evidence::given(place, role)),
                Some(Agrees::ButForSigns) => method = method.or(Some(place)),
                None => {}
            }
        }
        let evidence = Evidence::given(method?, role);
        match code.is_accuracy() {
            false => Some(evidence),
            true => {
                let feedback = "a sign or a number in it is wrong".to_owned();
                Some(Evidence { given: false, note: Some("sign-error"), feedback, ..evidence })
            }
        }
    }

    /// The momentum of a sphere before an impact with a wall taken from that after it, as vectors. A method mark may go on
    /// from a velocity of the student's own.
    pub(super) fn change_in_vectors(&self, role: &'static str, code: Code) -> Option<Evidence> {
        let [Some(x), Some(y)] = [Axis::X, Axis::Y].map(|axis| self.along(axis)) else { return None };
        let changes = |along: &Along| -> Vec<f64> {
            along.others[1].iter().zip(&along.others[0]).map(|(after, before)| after - before).collect()
        };
        let right = [changes(&x), changes(&y)];
        let own = if code.is_accuracy() { None } else { self.own_change(Sphere::A) };
        let is_change = |values: &[Value]| {
            let is = |[x, y]: &[Vec<f64>; 2]| [1.0, -1.0].into_iter().any(|sign| is_vector(values, x, y, sign));
            is(&right) || own.as_ref().is_some_and(is)
        };
        let line = self.lines.iter().position(|studied| {
            self.members(studied).any(|(member, values)| is_worked(&member.expr) && is_change(values))
        })?;
        Some(Evidence::given(line, role))
    }

    fn along(&self, axis: Axis) -> Option<Along> {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let mass = known(Quantity::Mass(Sphere::A))?;
        let velocity = |moment| Quantity::Velocity(Sphere::A, moment, axis);
        let momentum = |moment| {
            let velocities = known(velocity(moment))?;
            Some(velocities.iter().zip(&mass).map(|(velocity, mass)| velocity * mass).collect::<Vec<f64>>())
        };
        let [before, after] = [momentum(Moment::Before)?, momentum(Moment::After)?];
        let impulse: Vec<f64> = after.iter().zip(&before).map(|(after, before)| after - before).collect();
        let is_given = |quantity| self.prepared.given[0].0.contains_key(&quantity);
        let is_impulse = !is_given(Quantity::GivenImpulse(axis));
        let of_after = [velocity(Moment::After), Quantity::GivenDirection(Sphere::A, Moment::After)];
        let (sought, weight, others) = match of_after.into_iter().any(is_given) {
            _ if is_impulse => (impulse, vec![1.0; mass.len()], [before, after]),
            false => (known(velocity(Moment::After))?, mass, [impulse, before]),
            true => (known(velocity(Moment::Before))?, mass, [impulse, after]),
        };
        Some(Along { is_impulse, sought, weight, others })
    }

    /// An equation of vectors in what is sought.
    fn of_vectors(&self, (left, right): &(Expr, Expr), x: &Along, y: &Along) -> Option<Agrees> {
        let at = |point| match difference(left, right, &context(self.prepared, point))? {
            Sum::Vector(along_i, along_j) => {
                let is_total =
                    x.is_impulse && x.is_total(along_i.constant, point) && y.is_total(along_j.constant, point);
                Some(x.of(&along_i, point)?.min(y.of(&along_j, point)?)).filter(|_| !is_total)
            }
            Sum::Number(_) => None,
        };
        let found = self.at_every_point(&at)?;
        (found == Agrees::Fully || is_worked(left) || is_worked(right)).then_some(found)
    }

    /// An equation of components in what is sought; of a number alone it is not known how it was found.
    fn of_components(&self, (left, right): &(Expr, Expr), along: &Along) -> Option<Agrees> {
        let at = |point| match difference(left, right, &context(self.prepared, point))? {
            Sum::Number(linear) => along.of(&linear, point),
            Sum::Vector(..) => None,
        };
        if !is_composite(left) && !is_composite(right) {
            return None;
        }
        self.at_every_point(&at)
    }

    /// The letters that equations up to a line have for the components of the velocity that is sought, along i and along j:
    /// `m(x + 1) = -4, m(y - 2) = 4`.
    pub(super) fn letters_of_components(&self, place: usize) -> Option<[String; 2]> {
        let letter_along = |axis| {
            let along = self.along(axis).filter(|along| !along.is_impulse)?;
            let readings = self.lines[..=place].iter().filter_map(|studied| studied.reading.as_ref());
            let mut equations = readings.flat_map(|reading| &reading.equations);
            equations.find_map(|equation @ (left, right)| {
                self.of_components(equation, &along)?;
                match difference(left, right, &context(self.prepared, 0))? {
                    Sum::Number(linear) => linear.unknowns.first().map(|(letter, _)| letter.clone()),
                    Sum::Vector(..) => None,
                }
            })
        };
        let [x, y] = [letter_along(Axis::X)?, letter_along(Axis::Y)?];
        (x != y).then_some([x, y])
    }

    fn at_every_point(&self, at: &dyn Fn(usize) -> Option<Agrees>) -> Option<Agrees> {
        (0..self.prepared.points.count).map(at).collect::<Option<Vec<_>>>()?.into_iter().min()
    }

    /// `(2 + 2/m)² + (2 + 4/m)²`, `(2m + 2)² + (2m + 4)²`: the components of the velocity that is sought, or of its momentum,
    /// squared.
    fn has_squares(&self, expr: &Expr, x: &Along, y: &Along) -> bool {
        // A vector of impulse has a size too, but that comes after it is found.
        let is_squared = |component: Vec<f64>| {
            any_within(expr, &|inner| match inner {
                Expr::Power(base, exponent) if **exponent == Expr::integer(2) => {
                    self.is_one_of(base, std::slice::from_ref(&component))
                }
                _ => false,
            })
        };
        let momentum = |along: &Along| along.sought.iter().zip(&along.weight).map(|(v, m)| m * v).collect();
        let are_squared = |of: &dyn Fn(&Along) -> Vec<f64>| is_squared(of(x)) && is_squared(of(y));
        !x.is_impulse && (are_squared(&|along| along.sought.clone()) || are_squared(&momentum))
    }
}

impl Along {
    /// An equation with what is sought as its one unknown, at a point.
    fn of(&self, linear: &Linear, point: usize) -> Option<Agrees> {
        let [(_, number)] = linear.unknowns.as_slice() else { return None };
        let size = linear.size.max((number.middle() * self.sought[point]).abs());
        if (number.times(self.sought[point]) + linear.constant).may_be_nought(size) {
            return Some(Agrees::Fully);
        }
        let scale = number.middle() / self.weight[point];
        self.is_sum_of_others(linear.constant, scale, point).then_some(Agrees::ButForSigns)
    }

    /// Is it the other two terms added up, and not their difference?
    fn is_total(&self, value: Spread, point: usize) -> bool {
        let [one, other] = [&self.others[0], &self.others[1]].map(|term| term[point]);
        let is_one_of = |sums: [f64; 2]| sums.into_iter().any(|sum| value.may_be(sum));
        is_one_of([one + other, -one - other]) && !is_one_of([one - other, other - one])
    }

    /// Is it the sum of the other two terms, whatever their signs?
    fn is_sum_of_others(&self, value: Spread, scale: f64, point: usize) -> bool {
        let [one, other] = [&self.others[0], &self.others[1]].map(|term| scale * term[point]);
        [one + other, one - other, -one + other, -one - other].into_iter().any(|sum| value.may_be(sum))
    }
}

/// Is it what is sought, worked out from the two others, but for signs?
fn sought_but_for_signs(values: &[Value], x: &Along, y: &Along) -> Option<Agrees> {
    let is_sum =
        |along: &Along, value: Spread, point: usize| along.is_sum_of_others(value, 1.0 / along.weight[point], point);
    let fits = values.iter().enumerate().all(|(point, value)| match value {
        Value::Vector(i, j) => is_sum(x, *i, point) && is_sum(y, *j, point),
        Value::Number(_) => false,
    });
    // Momenta that are added up are no change of momentum.
    let is_total = values.iter().enumerate().all(|(point, value)| match value {
        Value::Vector(i, j) => x.is_total(*i, point) && y.is_total(*j, point),
        Value::Number(_) => false,
    });
    (fits && !(x.is_impulse && is_total)).then_some(Agrees::ButForSigns)
}

/// Is it more than a vector as it stands?
pub(in crate::mark::working) fn is_worked(expr: &Expr) -> bool {
    match expr {
        Expr::Vector(x, y) => is_composite(x) || is_composite(y),
        Expr::Negative(inner) => is_worked(inner),
        Expr::Sum(terms) => match terms.as_slice() {
            // `-8i + 6j`
            [one, other] => ![one, other].into_iter().all(is_component),
            _ => true,
        },
        other => !is_component(other) && is_composite(other),
    }
}

/// Is it `6j`, `-j` or `(8/3)i`?
fn is_component(expr: &Expr) -> bool {
    match expr {
        Expr::Negative(inner) => is_component(inner),
        Expr::Name(name) => matches!(name.text.as_str(), "i" | "j"),
        Expr::Product(factors) => {
            factors.last().is_some_and(is_component) && factors[..factors.len() - 1].iter().all(is_plain_number)
        }
        Expr::Quotient(above, below) => is_component(above) && is_plain_number(below),
        _ => false,
    }
}

fn is_plain_number(expr: &Expr) -> bool {
    match expr {
        Expr::Negative(inner) => is_plain_number(inner),
        Expr::Quotient(above, below) => is_plain_number(above) && is_plain_number(below),
        other => !is_composite(other),
    }
}
