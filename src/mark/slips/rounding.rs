//! Figures dropped on the way: the derivation evaluated again from the rounded values that a student shows.
//!
//! `v = 3.1` means 3.05 to 3.15. The intervals are pushed through the derivation; a last answer that lies inside what
//! comes out is right but for the rounding.

use crate::expr::Expr;
use crate::mark::reading::{Form, Said};
use crate::mechanics::{Carried, Datum, Known, Quantity, Road};
use crate::number::{Fraction, Interval, Letter, Range, Value};

use super::calculator::{rounded, to_figures};
use super::sample::{Sample, sampled};
use super::table::value;
use super::written::Written;

/// The tag of the note.
pub const EARLY_ROUNDING: &str = "early-rounding";

/// The precision of the intervals.
const BITS: usize = 96;

/// An answer is near enough for early rounding if it is off by less than this part.
const NEAR: f64 = 0.01;

/// An answer that is right but for rounding on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EarlyRounding {
    /// To how many significant figures everything was rounded, where that was found without the working.
    pub figures: Option<u32>,
    /// What a teacher would say.
    pub sentence: &'static str,
}

/// Is a wrong decimal what rounding on the way leads to?
///
/// `shown` are the values that the student shows on the way, as they were written. With none, it is tried whether an
/// answer less than one hundredth off comes of rounding everything to two figures, or to three. Letters may be speeds,
/// masses and lengths alone: then the decimals are those of their multiples.
pub fn early_rounding(
    given: &Known<Value>,
    letters: &[Letter],
    asked: Quantity,
    shown: &[(Quantity, Expr)],
    said: &Said,
) -> Option<EarlyRounding> {
    let Form::Value(last) = &said.form else { return None };
    if letters.iter().any(|letter| letter.range() != Range::Positive) {
        return None;
    }
    let last = read(asked, last, letters)?;
    let given_samples = sampled(given)?;
    let truth = Carried::on(Road::Shortest, &given_samples, &[asked]);
    let right = value(truth.known().0.get(&asked)?)?;
    // What looks cut off may have been rounded, after a value on the way was.
    let is_cut_off = last.is_cut_off(right) && !shown.is_empty();
    if last.is_right(right, false) && !is_cut_off {
        return None;
    }
    if !shown.is_empty() {
        let range = if is_cut_off { last.rounded_range() } else { last.range() };
        let found = from_shown(given, &given_samples, letters, asked, shown, range)?;
        return found.then_some(EarlyRounding {
            figures: None,
            sentence: "The method is right; a value that was rounded on the way spoilt the last figures. Keep all the figures until the last line.",
        });
    }
    let off = off(last, right);
    let figures = [2, 3]
        .into_iter()
        .find(|figures| off < NEAR && comes_of_rounding(&given_samples, letters, asked, last, *figures))?;
    Some(EarlyRounding {
        figures: Some(figures as u32),
        sentence: "This is what rounding on the way leads to: keep all the figures until the last line.",
    })
}

/// Is an answer so near the right one that it may come of rounding on the way, where no values on the way are shown? It
/// spares most wrong answers the derivation.
pub(super) fn may_be_rounded(right: Option<&Datum<Sample>>, letters: &[Letter], asked: Quantity, said: &Said) -> bool {
    let Form::Value(last) = &said.form else { return false };
    let both = read(asked, last, letters).zip(right.and_then(value));
    both.is_none_or(|(last, right)| off(last, right) < 1.01 * NEAR)
}

/// By which part of it an answer is off.
fn off(last: Written, right: Sample) -> f64 {
    last.value.with(right, |last, right| (last.abs() - right.abs()).abs() / right.abs()).0[0]
}

/// A value as it was written; an angle in degrees.
fn read(quantity: Quantity, expr: &Expr, letters: &[Letter]) -> Option<Written> {
    if quantity.is_angle() { Written::degrees(expr, letters, false) } else { Written::of(expr, letters) }
}

/// Does the last answer lie in what the shown values lead to? `None` if one of them is not the right one, rounded.
fn from_shown(
    given: &Known<Value>,
    samples: &Known<Sample>,
    letters: &[Letter],
    asked: Quantity,
    shown: &[(Quantity, Expr)],
    last: Option<(f64, f64)>,
) -> Option<bool> {
    let quantities: Vec<Quantity> = shown.iter().map(|(quantity, _)| *quantity).chain([asked]).collect();
    let mut entered = Vec::new();
    // The first road on which least is missing; nearly always that is the first of all, and nothing is.
    let mut truth: Option<Carried<Sample>> = None;
    for road in Road::ALL {
        let carried = Carried::on(road, samples, &quantities);
        if truth.as_ref().is_none_or(|best| carried.missing().len() < best.missing().len()) {
            truth = Some(carried);
        }
        if truth.as_ref().is_some_and(|best| best.missing().is_empty()) {
            break;
        }
    }
    let truth = truth?;
    let truth = truth.known();
    for (quantity, expr) in shown {
        let written = read(*quantity, expr, letters)?;
        // What is no number on the way, an angle, is an answer by itself.
        let Datum::Number(right) = truth.0.get(quantity)? else { continue };
        // What is a little off has been rounded on the way to it.
        let little_off = || written.range().filter(|_| off(written, *right) < NEAR);
        let (low, high) = written.range_around(*right).or_else(little_off)?;
        // What is exactly right has not been rounded: 3 is no 2.5 to 3.5.
        let is_exact = written.is_exactly(*right);
        let (low, high) = if is_exact { ((low + high) / 2.0, (low + high) / 2.0) } else { (low, high) };
        entered.push((*quantity, Datum::Number(interval(low).hull(&interval(high)))));
    }
    let said = last.map(|(low, high)| interval(low).hull(&interval(high)))?;
    let given = enclosed(given)?;
    let lies_inside = |road: Road| {
        let mut carried = Carried::on(road, &given, &[asked]);
        let used = |quantity: &Quantity| carried.derivation().steps.iter().any(|step| step.needs.contains(quantity));
        let entered: Vec<(Quantity, Datum<Interval>)> =
            entered.iter().filter(|(quantity, _)| used(quantity)).cloned().collect();
        let found = carried.again(&[], &entered, |carried, _| measure(carried.known(), asked));
        found.is_some_and(|found| found.overlaps(&said) || found.overlaps(&-said.clone()))
    };
    Some(Road::ALL.into_iter().any(lies_inside))
}

/// The number, or the angle in degrees.
fn measure(known: &Known<Interval>, asked: Quantity) -> Option<Interval> {
    match known.0.get(&asked)? {
        Datum::Number(number) => Some(number.clone()),
        Datum::Direction { y, x } => {
            (Interval::atan2(y, x)? * Interval::integer(180, BITS)).checked_div(&Interval::pi(BITS))
        }
        Datum::Equation(_) => None,
    }
}

/// A narrow interval around a float.
fn interval(value: f64) -> Interval {
    let millionths = 1e9;
    Interval::from_fraction(&Fraction::new((value * millionths).round() as i64, millionths as i64), BITS)
}

/// All that is given, enclosed, with one for each letter.
fn enclosed(given: &Known<Value>) -> Option<Known<Interval>> {
    let one = |value: &Value| value.enclose(BITS, &|_| Some(Interval::integer(1, BITS)));
    let mut known = Known::default();
    for (quantity, datum) in given.0.iter() {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(one(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: one(y)?, x: one(x)? },
            Datum::Equation(_) => continue,
        };
        known.0.insert(*quantity, datum);
    }
    Some(known)
}

/// Does the last answer come out if all components, or everything that is worked out, is rounded to so many figures?
fn comes_of_rounding(given: &Known<Sample>, letters: &[Letter], asked: Quantity, last: Written, figures: i32) -> bool {
    let is_it = |known: &Known<Sample>| {
        let found = known.0.get(&asked).and_then(value);
        found.is_some_and(|found| last.is_right(found, false))
    };
    [Road::Shortest, Road::BySpeeds].into_iter().any(|road| {
        let mut carried = Carried::on(road, given, &[asked]);
        let entered = rounded(carried.known(), letters, figures);
        let of_components = carried.again(&[], &entered, |carried, _| is_it(carried.known()));
        of_components || rounding_each(&carried, given, asked, figures).is_some_and(|known| is_it(&known))
    })
}

/// The derivation with the outcome of each step rounded before the next.
fn rounding_each(
    carried: &Carried<Sample>,
    given: &Known<Sample>,
    asked: Quantity,
    figures: i32,
) -> Option<Known<Sample>> {
    let mut known = given.clone();
    for step in &carried.derivation().steps {
        for (quantity, datum) in step.gives.iter().zip(step.evaluate(&known)?) {
            let datum = match datum {
                Datum::Number(number) if *quantity != asked => {
                    Datum::Number(number.map(|value| to_figures(value, figures)))
                }
                other => other,
            };
            known.0.insert_new(*quantity, datum);
        }
    }
    Some(known)
}
