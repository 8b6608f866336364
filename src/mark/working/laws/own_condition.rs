//! What is given of the motion after an impact, set on what the student has found: a wrong velocity does not make the
//! condition on it another.

use super::condition::oriented;
use crate::expr::{Expr, Function, Relation};
use crate::mark::enclosure::about;
use crate::mark::reading::Form;
use crate::mark::working::equations::differences;
use crate::mark::working::examine::{Working, context};
use crate::mark::working::numbers::{Context, Linear, Sum, difference, sum};
use crate::mark::working::theirs::{is_of_velocity, numbers};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Range;

impl Working<'_> {
    /// Velocities that the lines up to one leave alone in an equation, with what that makes them at every point:
    /// `x = 3/f`, `9x = 38.4 - 42f`, `72 = 21v + 96/e`. What is said last stands first.
    pub(super) fn left_alone(&self, place: usize) -> Vec<(String, Vec<f64>)> {
        let readings = self.lines[..=place].iter().rev().filter_map(|studied| studied.reading.as_ref());
        let alone = readings.flat_map(|reading| reading.equations.iter().rev()).filter_map(|equation| {
            let linear = differences(equation, self.prepared)?;
            let [(name, _)] = linear.first()?.unknowns.as_slice() else { return None };
            let is_theirs = |name: &String| is_of_velocity(name) || self.is_unknown(name);
            let name = Some(name.clone()).filter(|name| is_theirs(name) && !name.contains(' '))?;
            let value = |linear: &Linear| {
                let is_it = matches!(linear.unknowns.as_slice(), [(own, _)] if *own == name);
                is_it
                    .then(|| -linear.constant.middle() / linear.before(&name).middle())
                    .filter(|value| value.is_finite())
            };
            Some((name.clone(), linear.iter().map(value).collect::<Option<Vec<f64>>>()?))
        });
        alone.collect()
    }

    /// What the student has for one side of the question's inequality, in the letter that is sought: of a velocity after
    /// the first impact by its own letter, of a later one by any other.
    pub(super) fn own_side(&self, side: &Expr, place: usize) -> Vec<Vec<f64>> {
        let Expr::Name(name) = side else { return Vec::new() };
        let Ok(quantity) = name.text.parse::<Quantity>() else { return Vec::new() };
        let Some(convention) = &self.convention else { return Vec::new() };
        let own = |(letter, values): (String, Vec<f64>)| {
            let known = convention.letters.iter().position(|known| *known == letter);
            let sign = match (known, self.prepared.along(quantity)) {
                (Some(at), Quantity::Velocity(sphere, Moment::After, Axis::N)) if Sphere::BOTH[at] == sphere => {
                    convention.signs[at]
                }
                (None, _) if quantity.impact() > 0 => 1.0,
                _ => return None,
            };
            let varies = values.iter().any(|value| (value - values[0]).abs() > 1e-9 * value.abs());
            varies.then(|| values.iter().map(|value| sign * value).collect())
        };
        self.left_alone(place).into_iter().filter_map(own).collect()
    }

    /// Does an equation set what is given on what the student has found for it, though that is wrong?
    pub(super) fn is_set_on_own(&self, (left, right): &(Expr, Expr), place: usize) -> bool {
        self.is_own_tangent(left, right, place)
            || self.is_own_tangent(right, left, place)
            || self.is_own_turn(left, Relation::Equal, right, place)
            || self.is_own_greatest(left, right, place)
    }

    /// `e/2 = 4/3` after `tan β = e/2`, or that itself: the tangent that is given of the angle with the wall, as a formula in
    /// the letter that is sought.
    fn is_own_tangent(&self, given: &Expr, own: &Expr, place: usize) -> bool {
        let Some(condition) = self.question.scene.conditions.first() else { return false };
        let is_tangent = matches!(&condition.left, Expr::Name(name)
            if matches!(name.text.parse(), Ok(Quantity::TanToWall(_, Moment::After))));
        if !is_tangent || !self.has_sought(own) || self.is_sought(own) {
            return false;
        }
        let is_of_angle = |name: &str| {
            let mut letters = self.question.letters.iter();
            letters.any(|letter| letter.name() == name && letter.range() == Range::Acute)
        };
        match given {
            Expr::Call(Function::Tan, angle) => matches!(&**angle, Expr::Name(name) if is_of_angle(&name.text)),
            given => {
                let right = self.values_of(&condition.right).and_then(|values| numbers(&values));
                right.is_some_and(|right| self.is_one_of(given, &[right])) && self.was_stated(own, place)
            }
        }
    }

    /// Does a line before this one come to the same?
    fn was_stated(&self, expr: &Expr, place: usize) -> bool {
        let Some(values) = self.values_of(expr).and_then(|values| numbers(&values)) else { return false };
        let mut members = self.lines[..place].iter().flat_map(|studied| self.members(studied));
        members.any(|(_, own)| {
            let own = numbers(own);
            own.is_some_and(|own| own.iter().zip(&values).all(|(one, other)| (one - other).abs() <= 1e-9 * one.abs()))
        })
    }

    /// `80 - 20e = 0`, `80 - 20e < 0` after `4√5` and `2√5e`: with a wall, the scalar product of the velocities before and
    /// after that have the student's own components, or tangents that say the same. A sign of it may be wrong.
    pub(super) fn is_own_turn(&self, left: &Expr, relation: Relation, right: &Expr, place: usize) -> bool {
        if self.demanded_turn() != Some(relation) {
            return false;
        }
        if !self.has_sought(left) && !self.has_sought(right) || self.is_sought(left) || self.is_sought(right) {
            return false;
        }
        let is_equation = relation == Relation::Equal;
        let greater = if is_equation { Relation::Greater } else { relation };
        let Some(excess) = self.excess(left, greater, right) else { return false };
        let stated: Vec<&Expr> = self.lines[..place]
            .iter()
            .flat_map(|studied| self.members(studied))
            .map(|(member, _)| &member.expr)
            .collect();
        let (into, along): (Vec<&Expr>, Vec<&Expr>) = stated.into_iter().partition(|expr| self.has_sought(expr));
        let sizes = |expr: &Expr| self.values_of(expr).and_then(|values| numbers(&values));
        let sought = |name: &str| self.question.scene.unknowns.iter().any(|letter| letter.name() == name);
        // The component that the wall turns round was the same but for the letter.
        let as_before = |after: &Expr| after.substitute(&|name| sought(name).then(|| Expr::integer(1)));
        let into: Vec<_> = into.into_iter().filter_map(|after| sizes(&as_before(after)).zip(sizes(after))).collect();
        let along: Vec<_> = along.into_iter().filter_map(sizes).collect();
        let is_it = |sign: f64, along: &[f64], before: &[f64], after: &[f64]| {
            let dots = along.iter().zip(before.iter().zip(after)).map(|(along, (b, a))| along * along + sign * b * a);
            let dots: Vec<f64> = dots.map(|dot| oriented(dot, greater).unwrap_or(dot)).collect();
            let turned: Vec<f64> = dots.iter().map(|dot| -dot).collect();
            self.is_positive_multiple(&excess, &dots) || is_equation && self.is_positive_multiple(&excess, &turned)
        };
        into.iter().any(|(before, after)| {
            along.iter().any(|along| [1.0, -1.0].iter().any(|sign| is_it(*sign, along, before, after)))
        })
    }

    /// `k > 4/15` after `(k + 1)v = 5ku - 4u/3`, where v > 0 is demanded: a bound of the letter that is sought, at which the
    /// student's own velocity changes its sense as it should.
    pub(super) fn is_own_bound(&self, form: &Form, place: usize) -> bool {
        let Form::Equation(Expr::Relation(left, relation, right)) = form else { return false };
        let scene = &self.question.scene;
        let (Some(condition), [sought]) = (scene.conditions.first(), scene.unknowns.as_slice()) else { return false };
        let is_of_velocity = condition.is_inequality() && condition.right.is_zero() && scene.then.is_empty();
        let Some(convention) = self.convention.as_ref().filter(|_| is_of_velocity) else { return false };
        let along = match &condition.left {
            Expr::Name(name) => name.text.parse::<Quantity>().map(|quantity| self.prepared.along(quantity)),
            _ => return false,
        };
        let Ok(Quantity::Velocity(of, Moment::After, Axis::N)) = along else { return false };
        let (letter, sign) = (&convention.letters[of as usize], convention.signs[of as usize]);
        let (bound, is_least) = match (self.is_sought(left), self.is_sought(right)) {
            (true, false) => (right, oriented(1.0, *relation)),
            (false, true) => (left, oriented(-1.0, *relation)),
            _ => return false,
        };
        let Some((bound, is_least)) = about(bound, &[]).zip(is_least) else { return false };
        // By how much the velocity is on the side that is demanded, where the letter is so much.
        let excess = |(left, right): &(Expr, Expr), at: f64| {
            let points = self.prepared.points.with(&[(*sought, vec![Some(at); self.prepared.points.count])], 0);
            match difference(left, right, &Context { points: &points, ..context(self.prepared, 0) })? {
                Sum::Number(linear) if matches!(linear.unknowns.as_slice(), [(own, _)] if own == letter) => {
                    let velocity = -linear.constant.middle() / linear.before(letter).middle();
                    oriented(sign * velocity, condition.relation)
                }
                _ => None,
            }
        };
        let changes = |equation: &(Expr, Expr)| {
            let [below, above] = [bound / NEAR, bound * NEAR].map(|at| excess(equation, at));
            below.zip(above).is_some_and(|(below, above)| below * above < 0.0 && (above > 0.0) == (is_least > 0.0))
        };
        let readings = self.lines[..place].iter().filter_map(|studied| studied.reading.as_ref());
        readings.flat_map(|reading| &reading.equations).any(changes)
    }

    /// Does an equation hold where the tangent that was stated before is greatest or least: `3(1 + 4t²) - 3t(8t) = 0`?
    fn is_own_greatest(&self, left: &Expr, right: &Expr, place: usize) -> bool {
        let scene = &self.question.scene;
        let (Some(Quantity::TanDeflection(_)), [sought]) = (scene.maximise, scene.unknowns.as_slice()) else {
            return false;
        };
        if !self.has_sought(left) && !self.has_sought(right) {
            return false;
        }
        let at = |tangent: f64, evaluate: &dyn Fn(&Context) -> Option<Sum>| {
            let points = self.prepared.points.with(&[(*sought, vec![Some(tangent); self.prepared.points.count])], 0);
            match evaluate(&Context { points: &points, ..context(self.prepared, 0) })? {
                Sum::Number(linear) if linear.is_number() => Some(linear.constant.middle()),
                _ => None,
            }
        };
        let holds_near = |tangent: f64| {
            let excess = |tangent| at(tangent, &|context| difference(left, right, context));
            let sides = [tangent / NEAR, tangent * NEAR].map(excess);
            matches!(sides, [Some(before), Some(after)] if before * after < 0.0)
        };
        let readings = self.lines[..=place].iter().filter_map(|studied| studied.reading.as_ref());
        let stated = readings
            .flat_map(|reading| &reading.equations)
            .filter(|(name, formula)| matches!(name, Expr::Call(Function::Tan, _)) && self.has_sought(formula));
        stated
            .filter_map(|(_, formula)| greatest(&|tangent| at(tangent, &|context| sum(formula, context))))
            .any(holds_near)
    }

    /// Is it the letter that is sought, alone?
    pub(in crate::mark::working) fn is_sought(&self, expr: &Expr) -> bool {
        matches!(expr, Expr::Name(_)) && self.has_sought(expr)
    }
}

/// How far round a place an equation is looked at to see whether it holds there: figures are rounded.
const NEAR: f64 = 1.004;

/// Where between nought and a right angle something is greatest, by the tangent of the angle; nowhere if that is an end.
fn greatest(size: &dyn Fn(f64) -> Option<f64>) -> Option<f64> {
    const STEP: f64 = 1.15;
    const FROM: f64 = 0.02;
    const STEPS: i32 = 60;
    let tangents: Vec<f64> = (0..STEPS).map(|step| FROM * STEP.powi(step)).collect();
    let sizes: Vec<f64> = tangents.iter().map(|tangent| size(*tangent)).collect::<Option<_>>()?;
    let (best, _) = sizes.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1))?;
    if best == 0 || best + 1 == tangents.len() {
        return None;
    }
    let (mut low, mut high) = (tangents[best - 1], tangents[best + 1]);
    while high / low > 1.0 + 1e-6 {
        let (one, other) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if size(one)? < size(other)? { low = one } else { high = other }
    }
    Some((low + high) / 2.0)
}
