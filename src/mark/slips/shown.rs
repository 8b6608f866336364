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

/// The answers of a question in figures, each where it has a value.
pub type Answers = Vec<Option<Figures>>;

/// A slip that changes a value somewhere on the way to the answers.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The slip, by its place in [`Slip::all`].
    pub slip: usize,
    /// The answers as they then come out, on the first road where they differ from the right ones; none if on no road.
    pub shown: Option<Answers>,
}

/// Makes every slip of every law once, from what a scene gives. Which answers differ, first those with a slip and then the
/// right ones, is for the caller to say. Nothing if a value does not exist at the points.
pub fn shown(
    given: &Known<Value>,
    answers: &[Vec<Quantity>],
    differ: &dyn Fn(&Answers, &Answers) -> bool,
) -> Option<Vec<Outcome>> {
    Some(carried_out(&sampled(given)?, answers, differ))
}

/// The slips that would change something if no number happened to equal another: every number that is not nought is
/// moved a little, each by another part. What is nought stays so; who strikes a sphere at rest cannot forget its velocity.
pub fn acting(given: &Known<Value>, answers: &[Vec<Quantity>]) -> Vec<usize> {
    let Some(mut moved) = sampled(given) else { return Vec::new() };
    let mut part = 1.0; // so little in all that who goes on does not turn back
    for (quantity, datum) in &mut moved.0 {
        if matches!(quantity, Quantity::Line(_) | Quantity::Tangent(_)) {
            continue;
        }
        part += 0.001;
        match datum {
            Datum::Number(number) => *number = number.map(|number| number * part),
            Datum::Direction { y, .. } => *y = y.map(|y| y * part),
            Datum::Equation(_) => {}
        }
    }
    carried_out(&moved, answers, &|_, _| true).iter().map(|outcome| outcome.slip).collect()
}

fn carried_out(
    given: &Known<Sample>,
    answers: &[Vec<Quantity>],
    differ: &dyn Fn(&Answers, &Answers) -> bool,
) -> Vec<Outcome> {
    let asked: Vec<Quantity> = answers.iter().flatten().copied().collect();
    let mut roads: Vec<Carried<Sample>> = Vec::new();
    for road in Road::ALL {
        let carried = Carried::on(road, given, &asked);
        if roads.iter().all(|other| other.derivation() != carried.derivation()) {
            roads.push(carried);
        }
    }
    let all = |known: &Known<Sample>| answers.iter().map(|answer| figures(answer, known)).collect::<Answers>();
    let right = all(roads[0].known());
    let mut outcomes = Vec::new();
    for (slip, owned) in Slip::all().iter().enumerate() {
        let mut acts = false;
        let shown = roads.iter_mut().filter(|road| road.has_law_of(*owned)).find_map(|road| {
            let found = road.again(&[*owned], &[], |carried, trace| {
                carried.is_anything_changed(trace).then(|| all(carried.known()))
            });
            acts |= found.is_some();
            found.filter(|found| differ(found, &right))
        });
        if acts {
            outcomes.push(Outcome { slip, shown });
        }
    }
    outcomes
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
