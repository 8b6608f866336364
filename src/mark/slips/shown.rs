//! What each slip by itself makes of the answers of a question: whether it shows, and in which figures.
//!
//! [`Mistakes`](super::Mistakes) looks up what a student wrote; here nobody has written anything yet, and the question
//! is whether its numbers would let a slip be seen.

use smallvec::SmallVec;

use crate::mechanics::{Axis, Carried, Datum, Known, MadeSlip, Quantity, Slip, Sought, Trace};
use crate::number::Value;

use super::asked::Asked;
use super::backwards::{Backwards, Landed};
use super::last_step::has_a_sense;
use super::sample::{POINTS, Sample, sampled};
use super::table::value;
use super::ways::roads;

/// An answer in figures: each component at each of the fixed points of the letters, or at one where there are none; of an
/// angle the degrees. Without a sign where the sign is no part of the answer, and of a direction the unit vector. Of a range
/// each end, with plus or minus one for the side of it on which the range lies.
pub type Figures = SmallVec<[f64; 2 * POINTS]>;

/// The answers of a question in figures, each where it has a value.
pub type Answers = Vec<Option<Figures>>;

/// As a rule no more slips than these change anything.
const MANY: usize = 16;

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
    answers: &[Asked],
    sought: Option<&Sought>,
    differ: &dyn Fn(&Answers, &Answers) -> bool,
) -> Option<Vec<Outcome>> {
    Some(match is_of_numbers(given, sought) {
        true => carried_out::<1>(&sampled(given)?, answers, sought, differ),
        false => carried_out::<POINTS>(&sampled(given)?, answers, sought, differ),
    })
}

/// Is nothing open, so that one point is as good as all? Where something is greatest each point tries a number of its own.
fn is_of_numbers(given: &Known<Value>, sought: Option<&Sought>) -> bool {
    let is_number = |(_, datum): (&Quantity, &Datum<Value>)| match datum {
        Datum::Number(value) => value.is_constant(),
        Datum::Direction { y, x } => y.is_constant() && x.is_constant(),
        Datum::Equation(_) => true,
    };
    let is_of_its_letter = |sought: &Sought| {
        let is_of_a_slope = sought.places.iter().any(|(_, vanishing)| vanishing.is_slope());
        sought.letters.iter().all(|letter| *letter == sought.letter) && !is_of_a_slope
    };
    given.0.iter().all(is_number) && sought.is_none_or(is_of_its_letter)
}

/// The slips that would change something if no number happened to equal another: every number that is not nought is
/// moved a little, each by another part. What is nought stays so; who strikes a sphere at rest cannot forget its velocity.
pub fn acting(given: &Known<Value>, answers: &[Asked], sought: Option<&Sought>) -> Vec<usize> {
    let Some(mut moved) = sampled::<POINTS>(given) else { return Vec::new() };
    let mut part = 1.0; // so little in all that who goes on does not turn back
    for (quantity, datum) in moved.0.values_mut() {
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
    carried_out(&moved, answers, sought, &|_, _| true).iter().map(|outcome| outcome.slip).collect()
}

fn carried_out<const N: usize>(
    given: &Known<Sample<N>>,
    answers: &[Asked],
    sought: Option<&Sought>,
    differ: &dyn Fn(&Answers, &Answers) -> bool,
) -> Vec<Outcome> {
    let asked = answers.iter().map(Asked::quantities).chain(sought.map(|sought| sought.asked.as_slice()));
    let mut roads = roads(given, &asked.collect::<Vec<_>>().concat());
    let backwards = sought.and_then(|sought| Backwards::of(sought, &mut roads[0]));
    let backwards = backwards.as_ref();
    let all = |known: &Known<Sample<N>>, found: &[Option<Landed<N>>]| {
        answers.iter().map(|asked| figures(asked, known, backwards, found)).collect::<Answers>()
    };
    let places = || backwards.into_iter().flat_map(|backwards| (0..backwards.count()).map(move |at| (backwards, at)));
    let found: Vec<Option<Landed<N>>> = places().map(|(backwards, at)| Some(backwards.right(at))).collect();
    let right = all(roads[0].known(), &found);
    let unchanged = |right: &Option<Figures>| right.as_deref().map(Figures::from_slice);
    let changed = |carried: &Carried<Sample<N>>, trace: Trace| -> Answers {
        let one = |(asked, right): (&Asked, &Option<Figures>)| {
            let is_changed = asked.quantities().iter().any(|quantity| carried.is_changed(*quantity, trace));
            if is_changed { figures(asked, carried.known(), None, &[]) } else { unchanged(right) }
        };
        answers.iter().zip(&right).map(one).collect()
    };
    let mut outcomes = Vec::with_capacity(MANY);
    for (slip, owned) in Slip::all().iter().enumerate() {
        let mut acts = false;
        let shown = roads.iter_mut().filter(|road| road.has_law_of(owned.1)).find_map(|road| {
            let made = [MadeSlip::everywhere(*owned)];
            let looked = road.again(&made, &[], |carried, trace| {
                // What is found backwards is not known yet.
                carried.is_anything_changed(trace).then(|| backwards.is_none().then(|| changed(carried, trace)))
            });
            acts |= looked.is_some();
            let outcome = looked?.unwrap_or_else(|| {
                // Who has found another letter goes on with that.
                let found: Vec<Option<Landed<N>>> =
                    places().map(|(backwards, at)| backwards.found(at, road, &made, &[])).collect();
                let given = match (backwards, found.as_slice()) {
                    (Some(backwards), [Some(own)]) if !backwards.is_range => backwards.given_at(own.number),
                    _ => Vec::new(),
                };
                road.again(&made, &given, |carried, _| all(carried.known(), &found))
            });
            Some(outcome).filter(|outcome| differ(outcome, &right))
        });
        if acts {
            outcomes.push(Outcome { slip, shown });
        }
    }
    outcomes
}

/// An answer in what is known.
fn figures<const N: usize>(
    asked: &Asked,
    known: &Known<Sample<N>>,
    backwards: Option<&Backwards<N>>,
    found: &[Option<Landed<N>>],
) -> Option<Figures> {
    let Asked::Quantities(answer) = asked else {
        let backwards = backwards?;
        let side = |landed: Landed<N>| (*asked == Asked::Ends).then_some(landed.side);
        let figures = |landed: Landed<N>| [Some(backwards.in_figures(landed.number)), side(landed)];
        let found: Option<Vec<Landed<N>>> = found.iter().copied().collect();
        return Some(found?.into_iter().flat_map(figures).flatten().flat_map(|sample| sample.0).collect());
    };
    // Who has not found the letter cannot go on.
    if backwards.is_some_and(|backwards| !backwards.is_range) && found.iter().any(Option::is_none) {
        return None;
    }
    let mut found: SmallVec<[Sample<N>; 2]> = SmallVec::new();
    for quantity in answer {
        found.push(value(known.0.get(quantity)?).filter(|value| value.is_finite())?);
    }
    if found.is_empty() {
        return None;
    }
    match answer.as_slice() {
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
    let mut figures = Figures::new();
    found.iter().for_each(|value| figures.extend_from_slice(&value.0));
    Some(figures)
}
