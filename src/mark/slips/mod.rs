//! Why an answer is wrong: the derivation evaluated again with the slips that students make.
//!
//! [`Mistakes`] are worked out once for a question: every slip of every law by itself, pairs of slips, the slips of the
//! calculator and those of the last line, each with the value that it leads to. An answer is then looked up among them,
//! by the figures that the student wrote, and all [`Cause`]s that lead there are named, the likeliest first.

mod calculator;
mod cause;
mod last_step;
mod rounding;
mod sample;
mod table;
#[cfg(test)]
mod tests;
mod written;

pub use cause::{Cause, StepMarks};
pub use rounding::{EARLY_ROUNDING, EarlyRounding, early_rounding};


use crate::expr::Expr;
use crate::mark::reading::{Form, Said};
use crate::mechanics::{Carried, Datum, Known, Law, Quantity, Road, Slip, Steps, Trace};
use crate::number::{Letter, Value};

use last_step::LastStep;
use sample::Sample;
use table::{Answer, Values};
use written::Written;

/// The most pairs of slips that are tried.
const MOST_PAIRS: usize = 200;

/// Two values that differ by less than this part are one value.
const SAME: f64 = 1e-9;

/// What leads to a value.
#[derive(Clone, Copy, Debug)]
enum Origin {
    /// Slips of laws, one or two, by their places among all.
    Slips(usize, Option<usize>),
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
}

/// A slip by itself, as it was found on a road.
struct Single {
    slip: usize,
    road: usize,
    slipped: Steps,
    /// Does it change the answer of that place?
    changes: u64,
}

impl Mistakes {
    /// Works out what each slip leads to, for answers that are one quantity each, or the components of a vector.
    ///
    /// `given` is what the scene gives, as `pose` has it, with its unknowns found; `letters` are those of the question.
    pub fn of(given: &Known<Value>, answers: &[Vec<Quantity>], letters: &[Letter]) -> Mistakes {
        let mut mistakes =
            Mistakes { roads: Vec::new(), ways: Vec::new(), answers: Vec::new(), letters: letters.to_vec() };
        let Some(given) = sampled(given) else { return mistakes };
        let mut asked: Vec<Quantity> = answers.iter().flatten().copied().collect();
        asked.extend(answers.iter().flatten().flat_map(|quantity| last_step::taken_for(*quantity)).map(|(q, _)| q));
        asked.sort();
        asked.dedup();
        for road in Road::ALL {
            let carried = Carried::on(road, &given, &asked);
            if mistakes.roads.iter().all(|other| other.derivation() != carried.derivation()) {
                mistakes.roads.push(carried);
            }
        }
        let known = mistakes.roads[0].known();
        mistakes.answers = answers.iter().filter_map(|answer| Answer::of(answer, known)).collect();
        let singles = mistakes.add_singles();
        mistakes.add_calculator();
        mistakes.add_last_steps();
        mistakes.add_pairs(&singles);
        for answer in &mut mistakes.answers {
            answer.sort();
        }
        mistakes
    }

    /// Everything that leads to what a student wrote, the likeliest first: single slips in the order of their places,
    /// then pairs. Nothing for an answer that is right at the figures it has.
    pub fn causes(&self, answer: &[Quantity], said: &Said) -> Vec<Cause> {
        let Some(answer) = self.answers.iter().find(|known| known.asked == answer) else { return Vec::new() };
        let Some(written) = self.written(answer, said) else { return Vec::new() };
        let mut ways: Vec<&Way> = answer.matching(&written).map(|way| &self.ways[way]).collect();
        ways.sort_by_key(|way| way.rank());
        ways.dedup_by_key(|way| way.rank());
        ways.into_iter().map(|way| way.cause(&self.roads[way.road])).collect()
    }

    /// The wrong values of an answer, each with the tags of what leads to it: of a vector its components; of an angle so
    /// many degrees. Where letters remain, with every speed, mass and length one.
    pub fn values(&self, answer: &[Quantity]) -> Vec<(Vec<&'static str>, Vec<f64>)> {
        let Some(answer) = self.answers.iter().find(|known| known.asked == answer) else { return Vec::new() };
        let row = |(values, way): (&Values, usize)| {
            let values = values.iter().map(|value| value.0[0]).collect();
            (self.ways[way].tags(), values)
        };
        answer.rows().map(row).collect()
    }

    /// The value as it was written, in the unit of the answer.
    fn written(&self, answer: &Answer, said: &Said) -> Option<Vec<Written>> {
        let letters = &self.letters;
        let number = |expr: &Expr| Written::of(expr, letters);
        let found = match &said.form {
            Form::Value(expr) if answer.is_angle() => {
                let radians = said.unit.as_ref().is_some_and(|unit| !unit.degrees && unit.dimension == [0, 0, 0, 1]);
                return Some(vec![Written::degrees(expr, letters, radians)?]);
            }
            Form::Value(expr) => vec![number(expr)?],
            Form::Percentage(expr) => vec![number(expr)?.times(0.01)],
            Form::Ratio(above, below) => vec![number(&above.clone().over(below.clone()))?],
            Form::Vector(x, y, _) => vec![number(x)?, number(y)?],
            Form::Gradient(expr) if answer.is_line() => vec![number(&Expr::integer(1))?, number(expr)?],
            Form::AtRest if !answer.is_angle() => vec![number(&Expr::integer(0))?; answer.asked.len()],
            _ => return None,
        };
        let scale = said.unit.as_ref().and_then(|unit| number(&unit.scale)).map_or(1.0, |scale| scale.value.0[0]);
        Some(found.into_iter().map(|written| written.times(scale)).collect())
    }

    fn add(&mut self, way: Way, found: impl Iterator<Item = (usize, Values)>) {
        let number = self.ways.len();
        let mut is_used = false;
        for (answer, values) in found {
            self.answers[answer].add(values, number);
            is_used = true;
        }
        if is_used {
            self.ways.push(way);
        }
    }

    /// Carries out a road again, and what comes of each answer.
    fn again(
        &mut self,
        road: usize,
        slips: &[&str],
        other: &[(Quantity, Datum<Sample>)],
    ) -> Option<(Trace, Vec<Option<Values>>)> {
        let answers = &self.answers;
        self.roads[road].again(slips, other, |known, trace| {
            (trace, answers.iter().map(|answer| answer.values_in(known)).collect())
        })
    }

    fn add_singles(&mut self) -> Vec<Single> {
        let mut singles = Vec::new();
        for (slip, (_, known)) in Slip::all().iter().enumerate() {
            for road in 0..self.roads.len() {
                let Some((trace, values)) = self.again(road, &[known.tag], &[]) else { continue };
                let mut wrong = self.wrong(values);
                if trace.slipped.is_empty() || wrong.is_empty() {
                    continue;
                }
                let changes = wrong.iter().fold(0, |changes, (answer, _)| changes | 1_u64.wrapping_shl(*answer as u32));
                singles.push(Single { slip, road, slipped: trace.slipped, changes });
                let lost = if known.condoned { Steps::default() } else { trace.slipped };
                let is_same = |way: &Way| matches!(way.origin, Origin::Slips(other, None) if other == slip);
                wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| is_same(&self.ways[way])));
                self.add(Way { origin: Origin::Slips(slip, None), road, trace, lost }, wrong.into_iter());
            }
        }
        singles
    }

    /// Those values that are not the right ones.
    fn wrong(&self, values: Vec<Option<Values>>) -> Vec<(usize, Values)> {
        let there = values.into_iter().enumerate().filter_map(|(answer, values)| Some((answer, values?)));
        there.filter(|(answer, values)| !self.answers[*answer].is_right(values)).collect()
    }

    fn add_calculator(&mut self) {
        for (place, slip) in calculator::SLIPS.iter().enumerate() {
            let is_same = |way: &Way| matches!(way.origin, Origin::Calculator(other) if other == place);
            for road in 0..self.roads.len() {
                for entered in calculator::entered(slip, self.roads[road].known(), &self.letters) {
                    let Some((trace, values)) = self.again(road, &[], &entered) else { continue };
                    let mut wrong = self.wrong(values);
                    wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| is_same(&self.ways[way])));
                    let way = Way { origin: Origin::Calculator(place), road, trace, lost: Steps::default() };
                    self.add(way, wrong.into_iter());
                }
            }
        }
    }

    fn add_last_steps(&mut self) {
        for answer in 0..self.answers.len() {
            for (values, step) in self.answers[answer].last_steps(self.roads[0].known(), &self.answers) {
                let way = Way {
                    origin: Origin::LastStep(step),
                    road: 0,
                    trace: Trace::default(),
                    lost: Steps::default(),
                };
                self.add(way, std::iter::once((answer, values)));
            }
        }
    }

    /// Pairs of slips of different laws that both change an answer, likely ones first.
    fn add_pairs(&mut self, singles: &[Single]) {
        let all = Slip::all();
        let mut pairs: Vec<(&Single, &Single)> = Vec::new();
        for (place, one) in singles.iter().enumerate() {
            for two in &singles[place + 1..] {
                let same_law = all[one.slip].0 == all[two.slip].0;
                let apart = !same_law && !one.slipped.meets(two.slipped);
                let tried = pairs.iter().any(|(a, b)| (a.slip, b.slip) == (one.slip, two.slip));
                if one.road == two.road && apart && one.changes & two.changes != 0 && !tried {
                    pairs.push((one, two));
                }
            }
        }
        pairs.sort_by_key(|(one, two)| one.slip + two.slip);
        for (one, two) in pairs.into_iter().take(MOST_PAIRS) {
            let (first, second) = (all[one.slip].1, all[two.slip].1);
            let Some((trace, values)) = self.again(one.road, &[first.tag, second.tag], &[]) else { continue };
            let mut wrong = self.wrong(values);
            wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| self.ways[way].is_single()));
            let lost = [(first, one), (second, two)].into_iter().filter(|(slip, _)| !slip.condoned);
            let lost = lost.fold(Steps::default(), |lost, (_, single)| lost.and(single.slipped));
            let way = Way { origin: Origin::Slips(one.slip, Some(two.slip)), road: one.road, trace, lost };
            self.add(way, wrong.into_iter());
        }
    }
}

/// All that is given, at the points; `None` if a value does not exist there.
fn sampled(given: &Known<Value>) -> Option<Known<Sample>> {
    let mut known = Known::default();
    for (quantity, datum) in &given.0 {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(Sample::of(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: Sample::of(y)?, x: Sample::of(x)? },
            Datum::Equation(_) => continue,
        };
        known.0.insert(*quantity, datum);
    }
    Some(known)
}

/// A mistake as the documentation lists it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Listed {
    /// The tag.
    pub tag: &'static str,
    /// The law that owns it, if one does.
    pub law: Option<Law>,
    /// What the student did.
    pub did: &'static str,
    /// What a teacher would say.
    pub sentence: &'static str,
}

/// Every mistake that is recognised: those of laws and of the calculator in the order of their places, then those of the
/// last line.
pub fn all() -> Vec<Listed> {
    let of_laws = Slip::all().iter().map(|(law, slip)| (Some(*law), slip));
    let mut slips: Vec<(Option<Law>, &Slip)> = of_laws.map(|(law, slip)| (law, *slip)).collect();
    slips.extend(calculator::SLIPS.iter().map(|slip| (None, slip)));
    slips.sort_by_key(|(_, slip)| slip.place);
    let listed = |(law, slip): (Option<Law>, &Slip)| Listed { tag: slip.tag, law, did: slip.did, sentence: slip.sentence };
    let last = last_step::ALL.iter().map(|step| Listed {
        tag: step.tag,
        law: None,
        did: step.did,
        sentence: step.sentence,
    });
    slips.into_iter().map(listed).chain(last).collect()
}
