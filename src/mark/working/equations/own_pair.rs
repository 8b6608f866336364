//! The student's own two equations: which line each of them is, what that earns, and what both come to.
//!
//! The best line for each law counts, so that a wrong one put right costs nothing. It is another thing to have it right,
//! to write it out once more wrongly, and to go on from that: then the second is the student's equation.

use super::apiece::Apiece;
use super::conventions::Convention;
use super::departure::Departure;
use super::misread::numbers;
use super::offered::differences;
use super::pair::{BOTH, Matched};
use crate::bank::Code;
use crate::mark::working::evidence::Evidence as Shown;
use crate::mark::working::examine::{Studied, Value, Working};
use crate::mark::working::numbers::{Linear, common_root};
use crate::mechanics::{Law, Quantity};

/// A value is what an equation leads to if it is within such a part of it: students round.
const NEAR: f64 = 0.006;

impl Working<'_> {
    /// A mark for one of the two equations.
    pub(in crate::mark::working) fn pair_equation(&self, law: Law, code: Code) -> Option<Shown> {
        let equation = BOTH.into_iter().find(|equation| law.gives(*equation))?;
        let (line, best) = self.best(equation)?;
        let again = || self.gone_on_from_instead(equation, line).filter(|_| best.departures.is_empty());
        // The method has been seen all the same.
        let (line, best) = if code.is_accuracy() { again().unwrap_or((line, best)) } else { (line, best) };
        let given = if code.is_accuracy() { best.departures.is_empty() } else { best.is_method() };
        let lost = |departure: &&Departure| code.is_accuracy() || !departure.is_condoned();
        let reason = best.departures.iter().find(lost);
        let note = if given { None } else { reason.map(|departure| departure.tag()) };
        let feedback = match (given, reason) {
            (false, Some(departure)) => departure.sentence().to_owned(),
            (true, _) if !best.departures.is_empty() => {
                let condoned: Vec<&str> = best.departures.iter().map(|departure| departure.sentence()).collect();
                format!("condoned here: {}", condoned.join("; "))
            }
            _ => String::new(),
        };
        Some(Shown { line, given, note, feedback, role: law.name().to_owned() })
    }

    /// The line that is best for one of the equations.
    fn best(&self, equation: Quantity) -> Option<(usize, &Matched)> {
        let own = self.lines.iter().enumerate().filter_map(|(line, studied)| Some((line, matched(studied, equation)?)));
        own.min_by_key(|(_, matched)| matched.weight())
    }

    /// A line further on that has the same equation wrongly, written out as fully as there and no step that only
    /// gathers its terms, where what follows comes of it and not of the right one.
    fn gone_on_from_instead(&self, equation: Quantity, right: usize) -> Option<(usize, &Matched)> {
        let convention = self.convention.as_ref()?;
        let other = BOTH.into_iter().find(|other| *other != equation)?;
        let (other_line, _) = self.best(other)?;
        let beside = self.linear_of(other_line, other)?;
        let instead = self.common(convention, &self.linear_of(right, equation)?, &beside)?;
        let later = self.lines.iter().enumerate().skip(right + 1);
        let all = later.filter_map(|(line, studied)| Some((line, studied, matched(studied, equation)?)));
        // What has the other equation put into it is a step.
        let mut all = all.filter(|(_, studied, own)| own.departures.is_empty() || studied.matched.len() == 1);
        // Put right once more, it is right.
        let (line, _, wrong) =
            all.try_fold(None, |_, found| (!found.2.departures.is_empty()).then_some(Some(found)))??;
        let is_whole = count(&self.lines[line]) >= count(&self.lines[right]);
        let own = self.common(convention, &self.linear_of(line, equation)?, &beside).filter(|_| is_whole)?;
        let follows = |studied: &Studied| {
            let members = studied.reading.iter().flat_map(|reading| &reading.members);
            members.zip(&studied.values).any(|(member, values)| {
                let is_it = |letter: &String| member.letter.as_ref() == Some(letter);
                let Some((place, values)) = convention.letters.iter().position(is_it).zip(values.as_ref()) else {
                    return false;
                };
                let are = |roots: &[Vec<f64>; 2]| {
                    let pairs = values.iter().zip(&roots[place]);
                    pairs.into_iter().all(|(value, root)| is_near(*value, convention.signs[place] * root))
                };
                are(&own) && !are(&instead)
            })
        };
        self.lines.iter().skip(line + 1).any(follows).then_some((line, wrong))
    }

    /// What the student's own two equations come to: the components along the line of centres, from A to B, at every point.
    pub(in crate::mark::working) fn own_solution(&self) -> Option<[Vec<f64>; 2]> {
        let convention = self.convention.as_ref()?;
        let [momentum, restitution] = BOTH.map(|equation| self.linear_of(self.best(equation)?.0, equation));
        self.common(convention, &momentum?, &restitution?)
    }

    /// Left minus right of the equation of a line that is this one of the two.
    fn linear_of(&self, line: usize, equation: Quantity) -> Option<Vec<Linear>> {
        let (convention, laws) = (self.convention.as_ref()?, self.prepared.laws.as_ref()?);
        let is_it = |linear: &Vec<Linear>| {
            let another = || laws.with_another_restitution(linear, convention);
            let either = laws.either(linear, &Apiece::default(), convention, false).into_iter();
            either.chain(another()).any(|matched| matched.equation == equation)
        };
        let equations = self.lines[line].reading.iter().flat_map(|reading| &reading.equations);
        equations.filter_map(|own| differences(own, self.prepared)).find(is_it)
    }

    /// What two equations come to, as `own_solution` has it.
    fn common(&self, convention: &Convention, one: &[Linear], other: &[Linear]) -> Option<[Vec<f64>; 2]> {
        let numbers = |linear: &Linear| {
            let [v, w, constant] = linear.in_numbers([&convention.letters[0], &convention.letters[1]]);
            [v * convention.signs[0], w * convention.signs[1], constant]
        };
        let each = one.iter().zip(other).map(|(one, other)| common_root(numbers(one), numbers(other)));
        let each: Vec<[f64; 2]> = each.collect::<Option<_>>()?;
        let of = |place: usize| each.iter().map(|solution| solution[place]).collect::<Vec<f64>>();
        (each.len() == self.prepared.points.count).then(|| [of(0), of(1)])
    }
}

fn matched(studied: &Studied, equation: Quantity) -> Option<&Matched> {
    studied.matched.iter().find(|matched| matched.equation == equation)
}

/// How many numbers stand in the equations of a line.
fn count(studied: &Studied) -> usize {
    let equations = studied.reading.iter().flat_map(|reading| &reading.equations);
    equations.map(|(left, right)| numbers(left).len() + numbers(right).len()).sum()
}

fn is_near(value: Value, root: f64) -> bool {
    match value {
        Value::Number(spread) => (spread.middle() - root).abs() <= NEAR * root.abs(),
        Value::Vector(..) => false,
    }
}
