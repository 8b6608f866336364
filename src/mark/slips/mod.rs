//! Why an answer is wrong: the derivation evaluated again with the slips that students make.
//!
//! [`Mistakes`] are worked out once for a question: every slip of every law by itself, pairs of slips, the slips of the
//! calculator and those of the last line, each with the value that it leads to. An answer is then looked up among them,
//! by the figures that the student wrote, and all [`Cause`]s that lead there are named, the likeliest first.

mod asked;
mod backwards;
mod calculator;
mod cause;
mod last_step;
mod listed;
mod rounding;
mod sample;
mod shown;
mod table;
#[cfg(test)]
mod tests;
mod written;

pub use asked::Asked;
pub use cause::{Cause, StepMarks};
pub use listed::{Listed, all};
pub use rounding::{EARLY_ROUNDING, EarlyRounding, early_rounding};
pub use shown::{Answers, Outcome, acting, shown};

use crate::expr::Expr;
use crate::mark::reading::{Form, ReferenceLine, Said};
use crate::mechanics::{Carried, Datum, Known, MadeSlip, Quantity, Road, Slip, Sought, Steps, Trace};
use crate::number::{Letter, Value};

use backwards::{Backwards, Landed};
use last_step::{FACTOR_OF_TEN, LastStep};
use sample::Sample;
use table::{Answer, Values};
use written::Written;

/// The tag where the working has all that is needed and no known mistake explains the answer.
pub const ARITHMETIC: &str = "arithmetic";

/// The most pairs of slips that are tried.
const MOST_PAIRS: usize = 200;

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

/// A slip by itself at every impact, as it was found on a road.
struct Single {
    slip: usize,
    road: usize,
    slipped: Steps,
    /// Does it change the answer of that place?
    changes: u64,
}

impl Mistakes {
    /// Works out what each slip leads to, for answers that are one quantity each, the components of a vector, or what is
    /// found backwards.
    ///
    /// `given` is what the scene gives, as `pose` has it, with its unknowns found; `letters` are those of the question, and
    /// `sought` is what its unknown was found from.
    pub fn of(given: &Known<Value>, answers: &[Asked], letters: &[Letter], sought: Option<&Sought>) -> Mistakes {
        let mut mistakes = Mistakes {
            roads: Vec::new(),
            ways: Vec::new(),
            answers: Vec::new(),
            letters: letters.to_vec(),
            backwards: None,
        };
        let Some(given) = sampled(given) else { return mistakes };
        let quantities = || answers.iter().map(Asked::quantities);
        let mut asked: Vec<Quantity> = quantities().flatten().copied().collect();
        asked.extend(quantities().filter_map(angle_of).flatten());
        asked.extend(quantities().flatten().flat_map(|quantity| last_step::taken_for(*quantity)).map(|(q, _)| q));
        asked.extend(sought.iter().flat_map(|sought| &sought.asked));
        asked.sort();
        asked.dedup();
        mistakes.roads = roads(&given, &asked);
        mistakes.backwards = sought.and_then(|sought| Backwards::of(sought, &mut mistakes.roads[0]));
        let known = mistakes.roads[0].known();
        let angles = quantities().filter_map(angle_of);
        let all = quantities().map(<[Quantity]>::to_vec).chain(angles);
        let mut found: Vec<Answer> = all.filter_map(|answer| Answer::of(&answer, known)).collect();
        if let Some(backwards) = &mistakes.backwards {
            for asked in answers.iter().filter(|asked| asked.quantities().is_empty()) {
                let each = (0..backwards.count()).map(|place| Answer::of_letter(asked, backwards, place));
                found.extend(each.filter(|_| backwards.is_range == (*asked == Asked::Ends)));
            }
        }
        mistakes.answers = found;
        let singles = mistakes.add_singles();
        mistakes.add_calculator();
        mistakes.add_last_steps();
        mistakes.add_pairs(&singles);
        mistakes
    }

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
    /// come near whatever has but two figures.
    fn ways_to(&self, answer: &Answer, written: &[Written]) -> Vec<usize> {
        let is_in_figures = written.iter().all(|written| written.is_in_figures);
        let moves_point = |way: &usize| matches!(self.ways[*way].origin, Origin::LastStep(FACTOR_OF_TEN));
        let is_rough = written.iter().any(Written::is_rough);
        let exact: Vec<Written> = written.iter().map(|written| written.exactly()).collect();
        let is_likely = |way: &usize| {
            !is_rough || self.ways[*way].is_single() || answer.matching(&exact).any(|exact| exact == *way)
        };
        answer.matching(written).filter(|way| (is_in_figures || !moves_point(way)) && is_likely(way)).collect()
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

    /// Carries out a road again; the wrong values that come of it, each with the place of its answer.
    fn again(
        &mut self,
        road: usize,
        slips: &[MadeSlip],
        other: &[(Quantity, Datum<Sample>)],
    ) -> (Trace, Vec<(usize, Values)>) {
        self.roads[road].again(slips, other, look_for_wrong(&self.answers))
    }

    /// The same of what is found backwards, and of the other answers where it has come out otherwise.
    fn again_backwards(
        &mut self,
        road: usize,
        slips: &[MadeSlip],
        other: &[(Quantity, Datum<Sample>)],
    ) -> Vec<(usize, Values)> {
        let (Some(backwards), answers) = (&self.backwards, &self.answers) else { return Vec::new() };
        let road = &mut self.roads[road];
        let mut wrong = Vec::new();
        for place in 0..backwards.count() {
            let Some(Landed { number, .. }) = backwards.found(place, road, slips, other) else { continue };
            if number.is_near(backwards.right(place).number, SAME) {
                continue;
            }
            let of_letter = answers.iter().enumerate();
            let of_letter = of_letter.filter(|(_, answer)| answer.quantities().is_empty() && answer.place == place);
            wrong.extend(of_letter.map(|(at, _)| (at, vec![backwards.in_figures(number)])));
            if !backwards.is_range {
                let other: Vec<_> = backwards.given_at(number).into_iter().chain(other.iter().cloned()).collect();
                wrong.extend(road.again(slips, &other, look_for_wrong(answers)).1);
            }
        }
        wrong
    }

    fn add_singles(&mut self) -> Vec<Single> {
        let mut singles = Vec::new();
        for (slip, owned) in Slip::all().iter().enumerate() {
            let mut is_found_again = false;
            let everywhere = [MadeSlip::everywhere(*owned)];
            for road in 0..self.roads.len() {
                let (trace, mut wrong) = self.again(road, &everywhere, &[]);
                // What is found backwards costs ten times as much, and hardly ever depends on the road.
                if !trace.slipped.is_empty() && !std::mem::replace(&mut is_found_again, true) {
                    wrong.extend(self.again_backwards(road, &everywhere, &[]));
                }
                if trace.slipped.is_empty() || wrong.is_empty() {
                    continue;
                }
                let changes = wrong.iter().fold(0, |changes, (answer, _)| changes | 1_u64.wrapping_shl(*answer as u32));
                singles.push(Single { slip, road, slipped: trace.slipped, changes });
                self.add_slip(slip, None, road, trace, wrong);
            }
            // Who makes it at one impact of several need not make it at the others.
            for road in 0..self.roads.len() {
                let impacts = self.roads[road].impacts_of(*owned);
                for impact in impacts.iter().filter(|_| impacts.len() > 1) {
                    let (trace, wrong) = self.again(road, &[MadeSlip::at(*owned, *impact)], &[]);
                    if !trace.slipped.is_empty() {
                        self.add_slip(slip, Some(*impact), road, trace, wrong);
                    }
                }
            }
        }
        singles
    }

    /// Adds what a slip by itself leads to, made at every impact or at one, where it does not lead there already.
    fn add_slip(
        &mut self,
        slip: usize,
        impact: Option<u8>,
        road: usize,
        trace: Trace,
        mut wrong: Vec<(usize, Values)>,
    ) {
        let lost = if Slip::all()[slip].1.condoned { Steps::default() } else { trace.slipped };
        let is_same = |way: &Way| match way.origin {
            Origin::Slips(other, None) | Origin::SlipAt(other, _) => other == slip,
            _ => false,
        };
        wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| is_same(&self.ways[way])));
        let origin = impact.map_or(Origin::Slips(slip, None), |impact| Origin::SlipAt(slip, impact));
        self.add(Way { origin, road, trace, lost }, wrong.into_iter());
    }

    fn add_calculator(&mut self) {
        for (place, slip) in calculator::SLIPS.iter().enumerate() {
            let is_same = |way: &Way| matches!(way.origin, Origin::Calculator(other) if other == place);
            for road in 0..self.roads.len() {
                for entered in calculator::entered(slip, self.roads[road].known(), &self.letters) {
                    let (trace, mut wrong) = self.again(road, &[], &entered);
                    if road == 0 {
                        wrong.extend(self.again_backwards(road, &[], &entered));
                    }
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
                let way =
                    Way { origin: Origin::LastStep(step), road: 0, trace: Trace::default(), lost: Steps::default() };
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
                if one.road == two.road && apart && one.changes & two.changes != 0 {
                    pairs.push((one, two));
                }
            }
        }
        pairs.sort_by_key(|(one, two)| (one.slip + two.slip, one.slip, one.road));
        pairs.dedup_by_key(|(one, two)| (one.slip, two.slip));
        for (one, two) in pairs.into_iter().take(MOST_PAIRS) {
            let slips = [one, two].map(|single| MadeSlip::everywhere(all[single.slip]));
            let (trace, mut wrong) = self.again(one.road, &slips, &[]);
            if self.backwards.as_ref().is_some_and(Backwards::is_quick) {
                wrong.extend(self.again_backwards(one.road, &slips, &[]));
            }
            wrong.retain(|(answer, values)| !self.answers[*answer].has(values, |way| self.ways[way].is_single()));
            let lost = [one, two].into_iter().filter(|single| !all[single.slip].1.condoned);
            let lost = lost.fold(Steps::default(), |lost, single| lost.and(single.slipped));
            let way = Way { origin: Origin::Slips(one.slip, Some(two.slip)), road: one.road, trace, lost };
            self.add(way, wrong.into_iter());
        }
    }
}

/// The derivation of what is asked on each road, each that is none of the others.
fn roads(given: &Known<Sample>, asked: &[Quantity]) -> Vec<Carried<Sample>> {
    let mut roads: Vec<Carried<Sample>> = Vec::new();
    for road in Road::ALL {
        let carried = Carried::on(road, given, asked);
        if roads.iter().all(|other| other.derivation() != carried.derivation()) {
            roads.push(carried);
        }
    }
    roads
}

/// The wrong values of the answers that a derivation has changed, each with the place of its answer.
fn look_for_wrong(answers: &[Answer]) -> impl Fn(&Carried<Sample>, Trace) -> (Trace, Vec<(usize, Values)>) {
    |carried, trace| {
        let is_changed = |answer: &Answer| answer.quantities().iter().any(|asked| carried.is_changed(*asked, trace));
        let changed = answers.iter().enumerate().filter(|(_, answer)| is_changed(answer));
        let values = changed.filter_map(|(place, answer)| Some((place, answer.values_in(carried.known())?)));
        (trace, values.filter(|(place, values)| !answers[*place].is_right(values)).collect())
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

/// All that is given, at the points; `None` if a value does not exist there.
fn sampled(given: &Known<Value>) -> Option<Known<Sample>> {
    let mut known = Known::default();
    for (quantity, datum) in given.0.iter() {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(Sample::of(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: Sample::of(y)?, x: Sample::of(x)? },
            Datum::Equation(_) => continue,
        };
        known.0.insert(*quantity, datum);
    }
    Some(known)
}

/// What an expression comes to at the first of the points: to see whether two students wrote the same wrong value.
pub(super) fn value_at_first_point(expr: &Expr, letters: &[Letter]) -> Option<f64> {
    Written::of(expr, letters).map(|written| written.value.0[0])
}
