//! What each slip by itself makes of the answers of a question: whether it shows, and in which figures.
//!
//! [`Mistakes`](super::Mistakes) looks up what a student wrote; here nobody has written anything yet, and the question
//! is whether its numbers would let a slip be seen.

use crate::mechanics::{Axis, Carried, Datum, Known, Quantity, Road, Slip};
use crate::number::Value;

use super::last_step::has_a_sense;
use super::sample::Sample;
use super::sampled;
use super::table::value;

/// An answer in figures: each component at each of the fixed points of the letters, of an angle the degrees. Without a
/// sign where the sign is no part of the answer, and of a direction the unit vector.
pub type Figures = Vec<f64>;

/// What came of a slip on one road to the answers.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The slip, by its place in [`Slip::all`].
    pub slip: usize,
    /// Each answer as it then comes out; none where that has no value.
    pub answers: Vec<Option<Figures>>,
}

/// The right answers, and what every slip that changes anything on the way makes of them.
#[derive(Clone, Debug)]
pub struct Shown {
    /// Each answer as it is.
    pub right: Vec<Option<Figures>>,
    /// The slips that change a value somewhere, on every road.
    pub outcomes: Vec<Outcome>,
}

/// Makes every slip of every law once, from what a scene gives. `None` if a value does not exist at the points.
pub fn shown(given: &Known<Value>, answers: &[Vec<Quantity>]) -> Option<Shown> {
    Some(carried_out(&sampled(given)?, answers))
}

/// The slips that would change something if no number happened to equal another: every number that is not nought is
/// moved a little, each by another part. What is nought stays so; who strikes a sphere at rest cannot forget its velocity.
pub fn acting(given: &Known<Value>, answers: &[Vec<Quantity>]) -> Vec<usize> {
    let Some(mut moved) = sampled(given) else { return Vec::new() };
    let mut part = 1.0;
    for (quantity, datum) in &mut moved.0 {
        if matches!(quantity, Quantity::Line(_) | Quantity::Tangent(_)) {
            continue;
        }
        part += 0.037;
        match datum {
            Datum::Number(number) => *number = number.map(|number| number * part),
            Datum::Direction { y, .. } => *y = y.map(|y| y * part),
            Datum::Equation(_) => {}
        }
    }
    let mut slips: Vec<usize> = carried_out(&moved, answers).outcomes.iter().map(|outcome| outcome.slip).collect();
    slips.sort_unstable();
    slips.dedup();
    slips
}

fn carried_out(given: &Known<Sample>, answers: &[Vec<Quantity>]) -> Shown {
    let asked: Vec<Quantity> = answers.iter().flatten().copied().collect();
    let mut roads: Vec<Carried<Sample>> = Vec::new();
    for road in Road::ALL {
        let carried = Carried::on(road, given, &asked);
        if roads.iter().all(|other| other.derivation() != carried.derivation()) {
            roads.push(carried);
        }
    }
    let all = |known: &Known<Sample>| answers.iter().map(|answer| figures(answer, known)).collect::<Vec<_>>();
    let right = all(roads[0].known());
    let mut outcomes = Vec::new();
    for (slip, owned) in Slip::all().iter().enumerate() {
        for road in &mut roads {
            let found = road.again(&[*owned], &[], |carried, trace| {
                let steps = &carried.derivation().steps;
                let acts = steps.iter().flat_map(|step| &step.gives).any(|given| carried.is_changed(*given, trace));
                acts.then(|| all(carried.known()))
            });
            // A slip that leads to a dead end, as a sphere brought to rest that should have a direction, shows as well.
            let found = found.unwrap_or_else(|| Some(vec![None; answers.len()]));
            outcomes.extend(found.map(|answers| Outcome { slip, answers }));
        }
    }
    Shown { right, outcomes }
}

/// An answer in what is known.
fn figures(answer: &[Quantity], known: &Known<Sample>) -> Option<Figures> {
    let found: Option<Vec<Sample>> = answer.iter().map(|quantity| value(known.0.get(quantity)?)).collect();
    let mut found = found.filter(|values| !values.is_empty() && values.iter().all(|value| value.is_finite()))?;
    match answer {
        [Quantity::Line(Axis::X) | Quantity::Tangent(Axis::X), _] => {
            let size = found[0].with(found[1], f64::hypot);
            let turned = found[0].with(found[1], |x, y| if x < 0.0 || (x == 0.0 && y < 0.0) { -1.0 } else { 1.0 });
            for component in &mut found {
                *component = component.with(size, |own, size| own / size).with(turned, |own, sign| own * sign);
            }
        }
        [one] if !has_a_sense(*one) => found[0] = found[0].map(f64::abs),
        _ => {}
    }
    Some(found.into_iter().flat_map(|value| value.0).collect())
}
