//! What an equation has of each sphere before the impact, one by one: a sum that comes to the right number by chance is
//! neither law.

use super::added_up::terms;
use super::changed::Change;
use super::pair::Inputs;
use crate::expr::Expr;
use crate::mark::working::examine::context;
use crate::mark::working::numbers::{Context, Spread, constant, constants};
use crate::mark::working::prepared::Prepared;

/// The numbers that stand in an equation without an unknown, brackets multiplied out and all on its left side, at every
/// point; nothing where they cannot be told from each other.
#[derive(Clone, Default)]
pub(in crate::mark::working) struct Apiece(Option<Vec<Vec<Spread>>>);

impl Apiece {
    pub(in crate::mark::working) fn of((left, right): &(Expr, Expr), prepared: &Prepared) -> Apiece {
        let at = |point| {
            let context = context(prepared, point);
            let negated = |numbers: Vec<Spread>| numbers.into_iter().map(|number| -number).collect();
            if let Some(numbers) = of_quotient(left, right, &context) {
                return Some(numbers);
            }
            if let Some(numbers) = of_quotient(right, left, &context) {
                return Some(negated(numbers));
            }
            let right = constants(right, &context)?.into_iter().map(|number| -number);
            Some(constants(left, &context)?.into_iter().chain(right).collect())
        };
        Apiece((0..prepared.points.count).map(at).collect())
    }

    /// May they be what this change of a law has of each sphere, `factors` being what the equation is multiplied by at every
    /// point? Two numbers are right one by one; and one that is what it should be for one sphere is not the other as well.
    pub(in crate::mark::working) fn may_be(&self, change: &Change, inputs: &[Inputs], factors: &[Spread]) -> bool {
        let Some(numbers) = &self.0 else { return true };
        numbers.iter().zip(inputs).zip(factors).all(|((numbers, at), factor)| {
            let is = |number: Spread, own: f64| is_near(number, factor.times(-own), change.tolerance);
            match (numbers.as_slice(), change.before_of_each(at)) {
                ([one, other], Some([a, b])) if a != 0.0 && b != 0.0 => {
                    is(*one, a) && is(*other, b) || is(*one, b) && is(*other, a)
                }
                ([_, _], Some(_)) => at.along.contains(&0.0),
                ([one], Some([a, b])) if a != 0.0 && b != 0.0 && !change.departures.is_empty() => {
                    !change.unchanged_of_each(at).is_some_and(|each| each.iter().any(|own| is(*one, *own)))
                }
                _ => true,
            }
        })
    }

    /// Are they the momentum of each sphere before the impact, or the one number that it comes to?
    pub(super) fn may_be_momentum(&self, inputs: &[Inputs], factors: &[Spread]) -> bool {
        let Some(numbers) = &self.0 else { return true };
        numbers.iter().zip(inputs).zip(factors).all(|((numbers, at), factor)| {
            let [a, b] = [0, 1].map(|place| at.masses[place] * at.along[place]);
            let is = |number: Spread, own: f64| is_near(number, factor.times(-own), 0.0);
            match numbers.as_slice() {
                [one, other] => is(*one, a) && is(*other, b) || is(*one, b) && is(*other, a),
                numbers => numbers.len() < 2,
            }
        })
    }
}

/// What a number that is set equal to a quotient has of each sphere, the other way round: in `0.5 = (y - x)/(4 - 2)` half of 4 and
/// half of -2, in twos.
fn of_quotient(number: &Expr, quotient: &Expr, context: &Context) -> Option<Vec<Spread>> {
    let Expr::Quotient(above, below) = quotient else { return None };
    let is_open = constant(above, context).is_none() && constants(above, context)?.is_empty();
    let (number, whole) = (constant(number, context)?, constant(below, context)?);
    let each = terms(below, context).filter(|each| is_open && each.len() > 1)?;
    each.into_iter().map(|term| (number * term).over(whole)).collect()
}

/// Are they one number, but for such a part of it?
fn is_near(one: Spread, other: Spread, tolerance: f64) -> bool {
    let size = one.middle().abs().max(other.middle().abs());
    let difference = one - other;
    let slack = tolerance * size;
    Spread { low: difference.low - slack, high: difference.high + slack }.may_be_nought(size)
}
