//! What the last line can make of a vector: components of other directions, and one of them with the other sign.

use super::last_step::{AXIS_ASSUMED, LastStep, NOT_RECOMBINED, NOTHING_TURNED_BACK, ONE_SIGN};
use super::sample::Sample;
use super::table::Values;
use crate::mechanics::{Axis, Known, Moment, Quantity, Sphere};

/// The wrong vectors of an answer in i and j, each with its mistake.
pub(super) fn vector_steps(asked: &[Quantity], truth: &Values, known: &Known<Sample>) -> Vec<(Values, LastStep)> {
    let ([x, _], [i, j]) = (asked, truth.as_slice()) else { return Vec::new() };
    let turned = |value: &Sample| value.map(|value| -value);
    let mut found = Vec::new();
    if let Quantity::Velocity(sphere, Moment::After, Axis::X) = x.of_its_impact() {
        let number = |quantity: Quantity| quantity.in_impact(x.impact()).and_then(|quantity| known.number(quantity));
        let velocity = |moment, axis| number(Quantity::Velocity(sphere, moment, axis));
        let is_slanting = [Axis::X, Axis::Y].into_iter().all(|axis| is_plain(number(Quantity::Line(axis))));
        if let Some((n, t)) = velocity(Moment::After, Axis::N).zip(velocity(Moment::After, Axis::T))
            && is_slanting
        {
            for [one, other] in [[n, t], [t, n]] {
                for [one, other] in signed(one, other) {
                    found.push((vec![one, other], NOT_RECOMBINED));
                }
            }
        }
        let e = number(Quantity::Restitution).filter(|_| is_at_wall(known, *x));
        let line = [Axis::X, Axis::Y].map(|axis| number(Quantity::Line(axis)));
        if let (Some(e), [Some(x), Some(y)], Some(n), Some(t)) =
            (e, line, velocity(Moment::Before, Axis::N), velocity(Moment::Before, Axis::T))
        {
            found.push((vec![x * n - y * (e * t), y * n + x * (e * t)], NOTHING_TURNED_BACK));
        }
        let e = e.filter(|_| is_slanting);
        if let (Some(e), Some(i), Some(j)) = (e, velocity(Moment::Before, Axis::X), velocity(Moment::Before, Axis::Y)) {
            found.push((vec![i, turned(&(e * j))], AXIS_ASSUMED));
            found.push((vec![turned(&(e * i)), j], AXIS_ASSUMED));
        }
    }
    found.push((vec![turned(i), *j], ONE_SIGN));
    found.push((vec![*i, turned(j)], ONE_SIGN));
    found
}

/// Two numbers with each choice of signs.
fn signed(one: Sample, other: Sample) -> [[Sample; 2]; 4] {
    let [minus_one, minus_other] = [one, other].map(|value| value.map(|value| -value));
    [[one, other], [one, minus_other], [minus_one, other], [minus_one, minus_other]]
}

/// Is it known, and not nought?
fn is_plain(number: Option<Sample>) -> bool {
    number.is_some_and(|number| number.0.iter().all(|value| value.abs() > 1e-9))
}

/// Is it a wall that the sphere strikes there?
fn is_at_wall(known: &Known<Sample>, asked: Quantity) -> bool {
    let mass = Quantity::Mass(Sphere::B).in_impact(asked.impact());
    mass.is_none_or(|mass| !known.0.contains_key(&mass))
}
