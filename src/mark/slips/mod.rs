//! Why an answer is wrong: the derivation evaluated again with the slips that students make.
//!
//! [`Mistakes`] are worked out once for a question (`ways.rs`): every slip of every law by itself, pairs of slips, the slips
//! of the calculator and those of the last line, each with the value that it leads to. An answer is then looked up among them,
//! by the figures that the student wrote, and all [`Cause`]s that lead there are named, the likeliest first.

mod asked;
mod backwards;
mod calculator;
mod cause;
mod evaluated;
mod last_step;
mod listed;
mod rounding;
mod sample;
mod shown;
mod table;
#[cfg(test)]
mod tests;

mod vector_steps;
mod ways;
mod written;

pub use asked::Asked;
pub use cause::{Cause, StepMarks};
pub use listed::{Listed, all};
pub use rounding::{EARLY_ROUNDING, EarlyRounding, early_rounding};
pub use shown::{Answers, Outcome, acting, shown};

use crate::expr::Expr;
use crate::mark::reading::{Form, ReferenceLine, Said};
use crate::mechanics::{Carried, Quantity, Steps, Trace};
use crate::number::Letter;

use backwards::Backwards;
pub(super) use last_step::{ANOTHER_ANSWER, OTHER_SPHERE};
use last_step::{FACTOR_OF_TEN, LastStep};
use sample::Sample;
use table::{Answer, Values};
use written::Written;

/// The tag where the working has all that is needed and no known mistake explains the answer.
pub const ARITHMETIC: &str = "arithmetic";

/// Two values that differ by less than this part are one value.
const SAME: f64 = 1e-9;

/// What leads to a value.
#[derive(Clone, Copy, Debug)]
enum Origin {
    /// Slips of laws, one or two, by their places among all.
    Slips(usize, Option<usize>),
    /// A slip at one impact of several, with how many impacts come before it.
    SlipAt(usize, u8),
    /// A slip of the calculator.
    Calculator(usize),
    /// A mistake in the last line.
    LastStep(LastStep),
}

/// A way to a wrong value: what leads there, on which road, and what becomes of the steps.
#[derive(Clone, Copy, Debug)]
struct Way {
    origin: Origin,
    road: usize,
    trace: Trace,
    /// The steps whose method is lost.
    lost: Steps,
}

/// The wrong values that slips lead to in a question.
#[derive(Clone, Debug)]
pub struct Mistakes {
    roads: Vec<Carried<Sample>>,
    ways: Vec<Way>,
    answers: Vec<Answer>,
    letters: Vec<Letter>,
    backwards: Option<Backwards>,
}

impl Mistakes {
    /// Everything that leads to what a student wrote, the likeliest first: single slips in the order of their places,
    /// then pairs. Nothing for an answer that is right at the figures it has.
    pub fn causes(&self, asked: &Asked, said: &Said) -> Vec<Cause> {
        if *asked == Asked::Ends {
            return self.causes_of_ends(said);
        }
        let of_angle = matches!(&said.unit, Some(unit) if unit.degrees).then(|| angle_of(asked.quantities())).flatten();
        let asked = of_angle.map_or_else(|| asked.clone(), Asked::Quantities);
        let Some(answer) = self.answers.iter().find(|known| known.asked == asked) else { return Vec::new() };
        let Some(written) = self.written(answer, said) else { return Vec::new() };
        self.behind(self.ways_to(answer, &written))
    }

    /// The ways that lead to what was written. A decimal point stands elsewhere only in figures, and two mistakes together
    /// come near whatever has but two figures: they must lead there exactly.
    fn ways_to(&self, answer: &Answer, written: &[Written]) -> Vec<usize> {
        let is_in_figures = written.iter().all(|written| written.is_in_figures);
        let moves_point = |way: &usize| matches!(self.ways[*way].origin, Origin::LastStep(FACTOR_OF_TEN));
        let mut ways: Vec<usize> = answer.matching(written).filter(|way| is_in_figures || !moves_point(way)).collect();
        if written.iter().any(Written::is_rough) {
            let exact: Vec<Written> = written.iter().map(|written| written.exactly()).collect();
            let exactly: Vec<usize> = answer.matching(&exact).collect();
            ways.retain(|way| self.ways[*way].is_single() || exactly.contains(way));
        }
        ways
    }

    /// The same of the values that a letter can have: what leads to an end of them that is none.
    fn causes_of_ends(&self, said: &Said) -> Vec<Cause> {
        let Some(backwards) = &self.backwards else { return Vec::new() };
        let answers = || self.answers.iter().filter(|known| known.asked == Asked::Ends);
        let ends = written::ends(said, backwards.letter, &self.letters);
        let wrong = ends.into_iter().filter(|end| !answers().any(|answer| answer.is_written(&[*end])));
        self.behind(wrong.flat_map(|end| answers().flat_map(move |answer| self.ways_to(answer, &[end]))).collect())
    }

    /// The causes that ways are, each once.
    fn behind(&self, ways: Vec<usize>) -> Vec<Cause> {
        let mut ways: Vec<&Way> = ways.into_iter().map(|way| &self.ways[way]).collect();
        ways.sort_by_key(|way| (way.rank(), matches!(way.origin, Origin::SlipAt(..))));
        ways.dedup_by_key(|way| way.rank());
        ways.into_iter().map(|way| way.cause(&self.roads[way.road])).collect()
    }

    /// May an answer come of rounding on the way, where no values on the way are shown? Most wrong ones are too far off.
    pub(crate) fn may_be_rounded(&self, asked: Quantity, said: &Said) -> bool {
        let right = self.roads.first().and_then(|road| road.known().0.get(&asked));
        rounding::may_be_rounded(right, &self.letters, asked, said)
    }

    /// The wrong values of an answer, each with the tags of what leads to it: of a vector its components; of an angle so
    /// many degrees. Where letters remain, with every speed, mass and length one.
    pub fn values(&self, asked: &Asked) -> Vec<(Vec<&'static str>, Vec<f64>)> {
        let row = |(values, way): (&Values, usize)| {
            let values = values.iter().map(|value| value.0[0]).collect();
            (self.ways[way].tags(), values)
        };
        self.answers.iter().filter(|known| known.asked == *asked).flat_map(Answer::rows).map(row).collect()
    }

    /// The value as it was written, in the unit of the answer.
    fn written(&self, answer: &Answer, said: &Said) -> Option<Vec<Written>> {
        let letters = &self.letters;
        let number = |expr: &Expr| Written::of(expr, letters);
        let found = match &said.form {
            Form::Value(expr) if answer.is_angle() => {
                let radians = said.unit.as_ref().is_some_and(|unit| !unit.degrees && unit.dimension == [0, 0, 0, 1]);
                let degrees = Written::degrees(expr, letters, radians)?;
                return Some(vec![match said.reference {
                    Some(ReferenceLine::CommonTangent) if answer.is_to_line() => degrees.less_from(90.0),
                    Some(ReferenceLine::FromBToA) if answer.is_to_line() => degrees.less_from(180.0),
                    _ => degrees,
                }]);
            }
            Form::Value(expr) => vec![number(expr)?],
            Form::Percentage(expr) => vec![number(expr)?.times(0.01)],
            Form::Ratio(above, below) => vec![number(&above.clone().over(below.clone()))?],
            Form::Vector(x, y, _) => vec![number(x)?, number(y)?],
            Form::Gradient(expr) if answer.is_line() => vec![number(&Expr::integer(1))?, number(expr)?],
            Form::AtRest if !answer.is_angle() => vec![number(&Expr::integer(0))?; answer.quantities().len().max(1)],
            _ => return None,
        };
        let scale = said.unit.as_ref().and_then(|unit| number(&unit.scale)).map_or(1.0, |scale| scale.value.0[0]);
        Some(found.into_iter().map(|written| written.times(scale)).collect())
    }
}

/// The angle, where its tangent is asked: a student may give it in place of the tangent.
fn angle_of(answer: &[Quantity]) -> Option<Vec<Quantity>> {
    let [tangent] = answer else { return None };
    let angle = match tangent.of_its_impact() {
        Quantity::TanDeflection(sphere) => Quantity::Deflection(sphere),
        Quantity::TanToLine(sphere, moment) => Quantity::AngleToLine(sphere, moment),
        _ => return None,
    };
    Some(vec![angle.in_impact(tangent.impact())?])
}

/// What an expression comes to at the first of the points: to see whether two students wrote the same wrong value.
pub(super) fn value_at_first_point(expr: &Expr, letters: &[Letter]) -> Option<f64> {
    Written::of(expr, letters).map(|written| written.value.0[0])
}
