//! An equation of a student that may be momentum or restitution, and what it may be.

use super::apiece::Apiece;
use super::conventions::Convention;
use super::critical::{Critical, has_nought_term};
use super::departure::Departure;
use super::pair::{Laws, Matched};
use super::shown_e::shows_e;
use super::substituted::is_impulse;
use super::told_apart::Found;
use crate::expr::Expr;
use crate::mark::working::examine::context;
use crate::mark::working::numbers::{Context, Linear, Spread, Sum, any_within, difference, figures, sizes, sum};
use crate::mark::working::prepared::Prepared;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// An equation that may be one of the two.
pub(super) struct Offered {
    /// The place of its line, and which of the readings of that.
    pub(super) place: usize,
    pub(super) which: usize,
    /// Left minus right at every point.
    pub(super) linear: Vec<Linear>,
    /// What it has of each sphere before the impact.
    apiece: Apiece,
    /// The same with decimals of two figures taken as rounded, where it has such.
    rough: Option<Vec<Linear>>,
    /// Does the speed of approach stand in it?
    shows_approach: bool,
    /// Does e?
    shows_e: bool,
    /// Does every term have the g of a weight?
    has_weights: bool,
    /// Does a mass stand in it by its letter?
    shows_mass: bool,
    /// Does it say nothing but that the two unknowns are equal?
    says_equal: bool,
    /// Does a nought stand for one of its terms?
    has_nought: bool,
}

impl Offered {
    pub(in crate::mark::working) fn of(
        place: usize,
        which: usize,
        equation: &(Expr, Expr),
        prepared: &Prepared,
    ) -> Option<Offered> {
        let as_it_stands = differences(equation, prepared);
        let has_weights = as_it_stands.is_none();
        let linear = as_it_stands.or_else(|| without_weights(equation, prepared))?;
        let (shows_approach, says_equal) = (shows_approach(equation, prepared), says_equal(equation, &linear[0]));
        let shows_e = [&equation.0, &equation.1].iter().any(|side| shows_e(side, prepared));
        let rough = roughly(equation, &linear, prepared);
        let apiece = if has_weights { Apiece::default() } else { Apiece::of(equation, prepared) };
        let mut names = [&equation.0, &equation.1].into_iter().flat_map(|side| side.names());
        let shows_mass = names.any(|name| matches!(name.text.split('_').next(), Some("m" | "M")));
        Some(Offered {
            place,
            which,
            linear,
            apiece,
            rough,
            shows_approach,
            shows_e,
            says_equal,
            has_weights,
            shows_mass,
            has_nought: has_nought_term(equation),
        })
    }

    /// The same equation with something eliminated.
    pub(in crate::mark::working) fn with(&self, linear: Vec<Linear>) -> Offered {
        Offered { linear, apiece: Apiece::default(), rough: None, shows_approach: false, says_equal: false, ..*self }
    }

    /// Are its unknowns velocities, one or two of them?
    pub(super) fn is_of_velocities(&self) -> bool {
        let unknowns = &self.linear[0].unknowns;
        (1..=2).contains(&unknowns.len()) && unknowns.iter().all(|(name, _)| may_be_velocity(name))
    }

    /// The laws of the critical case of an inequality, if it is one of them.
    pub(super) fn critical<'l>(
        &self,
        critical: Option<&'l Critical>,
        convention: &Convention,
        noughts: &[(usize, String)],
    ) -> Option<&'l Laws> {
        critical?.laws_for((&self.linear[0], self.place, self.has_nought), convention, noughts)
    }

    /// All that it may be in this convention, as the equation of this number.
    pub(super) fn found(&self, number: usize, laws: &Laws, convention: &Convention) -> Vec<Found> {
        let (matched, alone) = match laws.moving_on_together(&self.linear, &self.apiece, convention) {
            Some(both) => (both.to_vec(), None),
            None => (self.matched(laws, convention), Some(number)),
        };
        matched.into_iter().map(|matched| Found { alone, ..self.found_as(matched) }).collect()
    }

    pub(super) fn found_as(&self, matched: Matched) -> Found {
        let has_needless_mass = self.shows_mass && matched.equation == Quantity::RestitutionEquation;
        Found { place: self.place, which: self.which, alone: None, matched, has_needless_mass }
    }

    /// What it may be in this convention: one of the laws as it stands, or each of them with the least change.
    pub(super) fn matched(&self, laws: &Laws, convention: &Convention) -> Vec<Matched> {
        let mut either = laws.either(&self.linear, &self.apiece, convention, self.shows_e);
        // An approach that comes to nought by a wrong sign is restitution; no approach at all is not.
        if self.says_equal && !either.is_empty() {
            return vec![laws.one_velocity()];
        }
        if let Some(exact) = either.iter().find(|one| one.departures.is_empty() && !self.has_weights) {
            return vec![exact.clone()];
        }
        if self.has_weights {
            either.retain(|one| one.equation == Quantity::MomentumEquation);
            either.iter_mut().for_each(|one| one.departures.push(Departure::WeightsForMasses));
        }
        // A number alone may be anything: e is another only where it stands with the speed of approach, and e itself does not.
        let is_another = self.shows_approach && !self.shows_e;
        let another = laws.with_another_restitution(&self.linear, convention).filter(|_| is_another);
        let another = another.or_else(|| laws.with_restitution_of_another(&self.linear, convention));
        // Two figures of a number are few, and show what it was.
        let rough =
            self.rough.iter().flat_map(|rough| laws.either(rough, &Apiece::default(), convention, self.shows_e));
        let rough = rough.filter(|one| one.departures.is_empty() || one.departures == [Departure::Sign]);
        let rough =
            rough.map(|one| Matched { departures: [one.departures, vec![Departure::Inaccurate]].concat(), ..one });
        for other in another.into_iter().chain(rough) {
            let is_nearer = |one: &Matched| one.equation == other.equation && one.weight() <= other.weight();
            if !either.iter().any(is_nearer) {
                either.retain(|one| one.equation != other.equation);
                either.push(other);
            }
        }
        either.sort_by_key(Matched::weight);
        either
    }
}

/// The equation without the g of weights, where every term has it: `4g × 4 cos 30° = 4gv + 2gw`.
fn without_weights((left, right): &(Expr, Expr), prepared: &Prepared) -> Option<Vec<Linear>> {
    let is_weight = |name: &str| name == "g" && prepared.points.letter(name, 0).is_none();
    if ![left, right].iter().flat_map(|side| side.names()).any(|name| is_weight(&name.text)) {
        return None;
    }
    let with = |g: i64| {
        let put = |side: &Expr| side.substitute(&|name| is_weight(name).then(|| Expr::integer(g)));
        differences(&(put(left), put(right)), prepared)
    };
    let (one, two) = (with(1)?, with(2)?);
    let is_twice = |(one, two): (&Linear, &Linear)| {
        let rest = one.clone().times(Spread::exactly(-2.0)).plus(two);
        rest.is_number() && rest.constant.middle().abs() < 1e-9 * two.size
    };
    one.iter().zip(&two).all(is_twice).then_some(one)
}

/// The same with decimals of two figures taken as rounded, but for those before the unknowns: nobody rounds a mass.
fn roughly(equation: &(Expr, Expr), linear: &[Linear], prepared: &Prepared) -> Option<Vec<Linear>> {
    let is_rough = |inner: &Expr| matches!(inner, Expr::Decimal(text) if figures(text) == 2);
    if !any_within(&equation.0, &is_rough) && !any_within(&equation.1, &is_rough) {
        return None;
    }
    let rough = differences_from(equation, prepared, 2)?;
    let constant = |(linear, rough): (&Linear, Linear)| Linear { constant: rough.constant, ..linear.clone() };
    Some(linear.iter().zip(rough).map(constant).collect())
}

/// May a letter stand for a velocity? Not an angle's, nor that of an impulse or an energy: `δ = β - α` is no law.
pub(super) fn may_be_velocity(name: &str) -> bool {
    let is_greek = name.len() > 3 && !name.contains(['_', ' ']);
    !is_greek && !is_impulse(name) && !matches!(name, "phi" | "E")
}

/// Is it `v = w` or `w - v = 0`, with nothing of the approach in it?
fn says_equal((left, right): &(Expr, Expr), linear: &Linear) -> bool {
    let [(one, v), (other, w)] = linear.unknowns.as_slice() else { return false };
    let is_bare = |expr: &Expr| {
        let names = expr.names();
        *expr == Expr::integer(0)
            || (!any_within(expr, &|inner| matches!(inner, Expr::Number(_) | Expr::Decimal(_)))
                && names.iter().all(|name| name.text == *one || name.text == *other))
    };
    is_bare(left) && is_bare(right) && (v.middle() + w.middle()).abs() < 1e-9
}

/// Does the speed of approach stand in the equation: as a number, a product, or a factor of one?
fn shows_approach((left, right): &(Expr, Expr), prepared: &Prepared) -> bool {
    let along = |sphere| sizes(&prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::N));
    let Some((a, b)) = along(Sphere::A).zip(along(Sphere::B)) else { return false };
    let is_approach = |expr: &Expr| {
        let values = prepared.sizes_of(expr);
        values.is_some_and(|values| {
            values
                .iter()
                .zip(a.iter().zip(&b))
                .all(|(value, (a, b))| (value.abs() - (a - b).abs()).abs() < 0.005 * value.abs())
        })
    };
    let has_factors = |factors: &[Expr]| {
        (1..1_usize << factors.len().min(6)).any(|chosen| {
            let some = factors.iter().enumerate().filter(|(place, _)| chosen >> place & 1 == 1);
            is_approach(&Expr::Product(some.map(|(_, factor)| factor.clone()).collect()))
        })
    };
    let is = |inner: &Expr| match inner {
        Expr::Product(factors) => has_factors(factors),
        other => is_approach(other),
    };
    // With the velocities below a line it is the wrong way up.
    let is_sum = |side: &Expr| sum(side, &context(prepared, 0)).is_some();
    is_sum(left) && is_sum(right) && (within_above(left, &is) || within_above(right, &is))
}

/// Is it so of a part of the formula? What is below a number is no part: `1/4` is e where the approach is 4.
fn within_above(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expr)
        || match expr {
            Expr::Quotient(above, _) if above.names().is_empty() => within_above(above, is),
            other => other.children().into_iter().any(|child| within_above(child, is)),
        }
}

/// Left minus right of an equation at every point; of a vector the component along the line of centres.
pub(in crate::mark::working) fn differences(equation: &(Expr, Expr), prepared: &Prepared) -> Option<Vec<Linear>> {
    differences_from(equation, prepared, context(prepared, 0).rounded_from)
}

/// The same where decimals count as rounded from so many significant figures.
fn differences_from((left, right): &(Expr, Expr), prepared: &Prepared, rounded_from: usize) -> Option<Vec<Linear>> {
    let at = |point| match difference(left, right, &Context { rounded_from, ..context(prepared, point) })? {
        Sum::Number(linear) => Some(linear),
        Sum::Vector(x, y) => {
            let line = |axis| prepared.known[point].number(Quantity::Line(axis)).map(Spread::exactly);
            Some(x.times(line(Axis::X)?).plus(&y.times(line(Axis::Y)?)))
        }
    };
    (0..prepared.points.count).map(at).collect()
}
