//! What follows from the values that the student found.

use super::examine::{Examined, Value, value};
use super::numbers::{Spread, sizes};
use super::prepared::{Prepared, complete};
use super::theirs::{Theirs, is_nearly_right};
use crate::expr::Expr;
use crate::mark::key::KeyedQuestion;
use crate::mechanics::{Axis, Datum, Derivation, Known, Moment, Quantity, Sphere};

/// What is given and the student's own values, to go on from, at every point.
///
/// A value that would make the rest trivial is not followed: nought where nothing is nought, but for one component of a vector,
/// and a coefficient of restitution that is none.
fn start(prepared: &Prepared, theirs: &Theirs) -> Vec<Known<f64>> {
    let mut at_points = prepared.given.clone();
    let is_beside_another = |quantity: &Quantity| {
        let other = match quantity {
            Quantity::Velocity(sphere, moment, Axis::X) => Quantity::Velocity(*sphere, *moment, Axis::Y),
            Quantity::Velocity(sphere, moment, Axis::Y) => Quantity::Velocity(*sphere, *moment, Axis::X),
            _ => return false,
        };
        theirs.values.get(&other).is_some_and(|(values, _)| values.iter().all(|value| *value != 0.0))
    };
    for (quantity, (values, _)) in &theirs.values {
        let right = sizes(&prepared.known, *quantity);
        let trivial = match quantity {
            Quantity::Restitution => values.iter().any(|value| !(0.0..=1.0).contains(value)),
            quantity if is_beside_another(quantity) => false,
            _ => right
                .is_some_and(|right| right.iter().zip(values).any(|(right, own)| *own == 0.0 && right.abs() > 1e-9)),
        };
        if !trivial {
            for (known, value) in at_points.iter_mut().zip(values) {
                known.0.insert(*quantity, Datum::Number(*value));
            }
        }
    }
    for sphere in Sphere::BOTH {
        resolve(prepared, theirs, sphere, &mut at_points);
        let energies = energies_by_speed(prepared, theirs, sphere);
        for (known, [after, lost]) in at_points.iter_mut().zip(energies.into_iter().flatten()) {
            known.0.insert(Quantity::KineticEnergy(sphere, Moment::After), Datum::Number(after));
            known.0.insert(Quantity::SphereEnergyLost(sphere), Datum::Number(lost));
            known.0.insert(Quantity::SphereEnergyGained(sphere), Datum::Number(-lost));
        }
    }
    at_points
}

/// Adds what a wrong vector of the student's own for the velocity after the impact has along the line of centres and across
/// it, unless that was said as well.
fn resolve(prepared: &Prepared, theirs: &Theirs, sphere: Sphere, at_points: &mut [Known<f64>]) {
    let of = |axis| Quantity::Velocity(sphere, Moment::After, axis);
    let own = |axis| theirs.values.get(&of(axis)).map(|(values, _)| values);
    let line = |axis| sizes(&prepared.known, Quantity::Line(axis));
    let (Some(x), Some(y), None) = (own(Axis::X), own(Axis::Y), own(Axis::N)) else { return };
    let (Some(along_i), Some(along_j)) = (line(Axis::X), line(Axis::Y)) else { return };
    let is_right = |axis| {
        let near = |(own, right): (&f64, &f64)| is_nearly_right(*own, *right);
        own(axis).zip(sizes(&prepared.known, of(axis))).is_some_and(|(own, right)| own.iter().zip(&right).all(near))
    };
    if is_right(Axis::X) && is_right(Axis::Y) {
        return;
    }
    for (point, known) in at_points.iter_mut().enumerate() {
        let (x, y, i, j) = (x[point], y[point], along_i[point], along_j[point]);
        known.0.insert(of(Axis::N), Datum::Number(x * i + y * j));
        known.0.insert(of(Axis::T), Datum::Number(y * i - x * j));
    }
}

/// The energy of a sphere after the impact and what it has lost, at every point, where the student has a wrong speed for it
/// and no wrong component from which that comes.
fn energies_by_speed(prepared: &Prepared, theirs: &Theirs, sphere: Sphere) -> Option<Vec<[f64; 2]>> {
    let right = |quantity| sizes(&prepared.known, quantity);
    let own_if_wrong = |quantity: Quantity| {
        let (own, _) = theirs.values.get(&quantity)?;
        let near = |(own, right): (&f64, &f64)| is_nearly_right(own.abs(), right.abs());
        (!own.iter().zip(&right(quantity)?).all(near)).then_some(own)
    };
    let speeds = own_if_wrong(Quantity::Speed(sphere, Moment::After))?;
    let mut components =
        [Axis::N, Axis::T, Axis::X, Axis::Y].into_iter().map(|axis| Quantity::Velocity(sphere, Moment::After, axis));
    if components.any(|component| own_if_wrong(component).is_some()) {
        return None;
    }
    let (masses, before) = (right(Quantity::Mass(sphere))?, right(Quantity::Speed(sphere, Moment::Before))?);
    let each = speeds.iter().zip(masses).zip(before);
    Some(each.map(|((own, mass), before)| [own * own, before * before - own * own].map(|it| mass * it / 2.0)).collect())
}

/// Everything that follows from what is given and from the student's own values.
pub(super) fn follow(prepared: &Prepared, theirs: &Theirs) -> Vec<Known<f64>> {
    if theirs.values.is_empty() {
        return prepared.known.clone();
    }
    start(prepared, theirs).iter().map(complete).collect()
}

/// What follows for one quantity at every point.
pub(super) fn follow_to(prepared: &Prepared, theirs: &Theirs, quantity: Quantity) -> Option<Vec<f64>> {
    let mut start = start(prepared, theirs);
    start.iter_mut().for_each(|known| drop(Derivation::carry_out(known, &[quantity])));
    sizes(&start, quantity)
}

/// By no more than this part of it do figures that were dropped move what follows, or nothing can be said.
const NEAR: f64 = 0.05;

/// The most values of the student's own that are taken as rounded at once.
const MOST_ROUNDED: usize = 4;

/// What may follow for a quantity where the student's own decimals are what they were before they were rounded: who writes
/// 3.05 and goes on with what the calculator holds has something from 3.045 to 3.055. Only where nothing is a letter.
fn follow_unrounded(prepared: &Prepared, theirs: &Theirs, quantity: Quantity) -> Option<Spread> {
    let width = |written: &Expr| rounded(written, prepared);
    let own = theirs.values.iter().filter_map(|(quantity, (_, written))| Some((*quantity, width(written)?)));
    let own: Vec<(Quantity, Spread)> = own.take(MOST_ROUNDED).collect();
    let mut found: Option<Spread> = None;
    for corner in 0..1_u32 << own.len() {
        let mut theirs = theirs.clone();
        for (place, (quantity, spread)) in own.iter().enumerate() {
            let end = if corner >> place & 1 == 0 { spread.low } else { spread.high };
            if let Some((values, _)) = theirs.values.get_mut(quantity) {
                *values = vec![end];
            }
        }
        let [end] = follow_to(prepared, &theirs, quantity)?.as_slice().try_into().ok()?;
        let (low, high) = found.map_or((end, end), |found| (found.low.min(end), found.high.max(end)));
        found = Some(Spread::of(low, high)?);
    }
    found
}

/// What a decimal was before it was rounded; nothing of what is exact, or has too few figures to be taken as rounded.
fn rounded(written: &Expr, prepared: &Prepared) -> Option<Spread> {
    match value(written, prepared, &prepared.names)?.as_slice() {
        [Value::Number(spread)] if spread.low < spread.high => Some(*spread),
        _ => None,
    }
}

impl Examined {
    /// The size nearest to an answer that follows for a quantity from the student's own values as they may have been
    /// before they were rounded; `as_written` is what follows from them as they stand. Nothing for an answer far from that.
    pub(crate) fn followed_unrounded(
        &self,
        question: &KeyedQuestion,
        (quantity, as_written): (Quantity, f64),
        answer: &Expr,
    ) -> Option<f64> {
        let prepared = question.prepared();
        let answer = rounded(answer, prepared)?.middle().abs();
        if (answer - as_written.abs()).abs() > NEAR * answer {
            return None;
        }
        let Spread { low, high } = follow_unrounded(prepared, &self.theirs, quantity)?;
        let (least, greatest) = (low.abs().min(high.abs()), low.abs().max(high.abs()));
        (low * high > 0.0).then(|| answer.clamp(least, greatest))
    }
}
