//! Answers followed through: right for the values that the student found before.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;

use super::memory::Judged;
use crate::answer::{Accept, Kind};
use crate::bank::{Code, Find};
use crate::expr::{Expr, Text, written};
use crate::mark::award::{Ground, MarkedAnswer};
use crate::mark::judging::{Judgement, Model, Note, Verdict, judge};
use crate::mark::key::{KeyedBlank, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading};
use crate::mark::working::{Examined, has_these_sizes};
use crate::mechanics::{Axis, Datum, Derivation, Known, Line, Moment, Quantity, Show, Sphere};
use crate::number::{Fraction, Places, Value, round};
use crate::paper::WorkingLine;

/// An answer that is right for what the student had found before.
pub(super) struct Followed {
    pub(super) judgement: Judgement,
    /// Does the scheme have a mark for it? Else it only shows the method.
    pub(super) is_marked: bool,
}

/// For each blank the verdict against what follows from the student's own values.
pub(super) fn answers(
    question: &KeyedQuestion,
    part: &KeyedPart,
    answers: &[MarkedAnswer],
    judged: &[Rc<Judged>],
    examined: &Examined,
) -> Vec<Option<Followed>> {
    let is_wrong_before = examined.theirs.wrong(question).next().is_some();
    let each = part.blanks.iter().zip(answers).zip(judged);
    each.map(|((blank, answer), judged)| {
        let quantity = match blank.find {
            Find::Quantity(quantity) => quantity,
            Find::Vector(x, y) if is_wrong_before && answer.judgement.verdict == Verdict::Wrong => {
                return vector(question, blank, [x, y], judged, examined);
            }
            _ => return None,
        };
        let is_marked = part
            .scheme
            .iter()
            .any(|mark| mark.code == Code::A1FollowThrough && mark.earned_for.quantities().contains(&quantity));
        // What is right but for its form follows from nothing wrong, though it may from what was rounded before.
        let goes_on_in_figures =
            || is_marked && !examined.finds_exactly && examined.theirs.rounded(question).next().is_some();
        let is_right =
            answer.judgement.verdict == Verdict::Correct || wants_exact(&answer.judgement) && !goes_on_in_figures();
        let is_wrong = || answer.judgement.verdict == Verdict::Wrong || is_near_miss(&answer.judgement);
        let is_value = || matches!(blank.model.kind, Kind::Number | Kind::Angle | Kind::Expression);
        let follows = is_marked || (is_wrong_before && is_wrong() && is_value());
        if !follows || is_right || examined.theirs.values.is_empty() {
            return None;
        }
        let values = examined.followed(question, quantity)?;
        let right = question.prepared().known_sizes(quantity);
        let is_nought = |values: &[f64]| values.iter().all(|value| *value == 0.0);
        // Nothing is left to find where the student's own values leave nought.
        if is_nought(&values) && !right.as_deref().is_some_and(is_nought) {
            return None;
        }
        let is_right_already = || right.as_deref().is_some_and(|right| are_near(right, &values, 1e-3));
        if !is_marked && (is_stated(question, examined, quantity, &values) || is_right_already()) {
            return None;
        }
        // A decimal may be rounded, but not before a letter.
        let is_open = |expr: &&Expr| blank.model.kind == Kind::Expression || !has_decimal(expr);
        let exact = judged.readings.as_deref().and_then(formula).filter(is_open);
        let exact = exact.filter(|expr| has_these_sizes(question, expr, &values));
        let value = match exact {
            Some(exact) => exact.clone(),
            // A formula in letters must be it at every point.
            None if !are_near(&vec![values[0]; values.len()], &values, SAME) => return None,
            None => Expr::Decimal(format!("{:.12}", values[0].abs())),
        };
        let accept = in_figures(&blank.model);
        let readings = judged.readings.clone()?;
        let judged_by = |value: Expr| {
            let model = Model { quantity: blank.model.quantity, accept: accept.clone(), ..blank.model.of_value(value) };
            judge(&model, &Ok(readings.clone()))
        };
        let mut judgement = judged_by(value);
        if judgement.verdict != Verdict::Correct
            && let Some(written) = formula(&readings)
            && let Some(unrounded) = examined.followed_unrounded(question, (quantity, values[0]), written)
        {
            judgement = judged_by(Expr::Decimal(format!("{unrounded:.12}")));
        }
        let is_in_figures = !is_marked && judgement.note == Some(Note::UnderAccurate.tag());
        let follows = judgement.verdict == Verdict::Correct || is_in_figures;
        follows.then(|| Followed { judgement: judgement.in_setting(part.setting), is_marked })
    })
    .collect()
}

/// The verdict on a wrong vector against what follows for its components from the student's own values.
fn vector(
    question: &KeyedQuestion,
    blank: &KeyedBlank,
    components: [Quantity; 2],
    judged: &Judged,
    examined: &Examined,
) -> Option<Followed> {
    let own = examined.theirs.to_go_on_from(question);
    let own = own.iter().filter(|(quantity, _)| !components.contains(quantity));
    let mut known = question.given_with(own.map(|(quantity, written)| (*quantity, written)));
    Derivation::carry_out(&mut known, &components);
    let [x, y] = components.map(|component| known.number(component));
    let value = Expr::Vector(Box::new(written(&x?)), Box::new(written(&y?)));
    let model = Model { accept: in_figures(&blank.model), ..blank.model.of_value(value) };
    let judgement = judge(&model, &Ok(judged.readings.clone()?));
    (judgement.verdict == Verdict::Correct).then_some(Followed { judgement, is_marked: false })
}

/// What is accepted of what follows: the student's own values are in figures, so that nobody can be asked for more.
fn in_figures(model: &Model) -> Accept {
    match &model.accept {
        Accept::Exact => Accept::RoundsTo(Places::SignificantFigures(3)),
        rule => rule.clone(),
    }
}

/// How near a double comes to the exact value that it stands for, in parts of itself.
const SAME: f64 = 1e-9;

/// What is written as the answer.
fn formula(readings: &[Reading]) -> Option<&Expr> {
    let said = readings.first()?.statements.last()?.said.last()?;
    let Form::Value(expr) = &said.form else { return None };
    Some(expr)
}

fn has_decimal(expr: &Expr) -> bool {
    matches!(expr, Expr::Decimal(_)) || expr.children().into_iter().any(has_decimal)
}

/// Is it right as a decimal, where the exact value is wanted?
fn wants_exact(judgement: &Judgement) -> bool {
    judgement.note == Some(Note::ExactWanted.tag())
}

/// Is it less than one hundredth off?
pub(super) fn is_near_miss(judgement: &Judgement) -> bool {
    judgement.note == Some(Note::NearMiss.tag())
}

/// Is it one of the student's own wrong values of something else, so that nothing follows?
fn is_stated(question: &KeyedQuestion, examined: &Examined, asked: Quantity, values: &[f64]) -> bool {
    let is_it = |quantity: Quantity| {
        examined
            .theirs
            .values
            .get(&quantity)
            .is_some_and(|(own, _)| own.len() == values.len() && are_near(own, values, 1e-6))
    };
    examined.theirs.wrong(question).any(|(quantity, _)| quantity != asked && is_it(quantity))
}

/// Are they of one size at every point, but for such a part?
fn are_near(one: &[f64], other: &[f64], part: f64) -> bool {
    one.iter().zip(other).all(|(one, other)| (one.abs() - other.abs()).abs() <= part * one.abs())
}

/// Answers that follow from the student's own values say so, and no other mistake is looked for in them.
pub(super) fn say(answers: &mut [MarkedAnswer], followed: &[Option<Followed>]) {
    for (answer, followed) in answers.iter_mut().zip(followed) {
        if followed.as_ref().is_some_and(|followed| followed.is_marked) && !wants_exact(&answer.judgement) {
            say_of(answer);
        }
    }
}

/// Says of an answer that it follows.
pub(super) fn say_of(answer: &mut MarkedAnswer) {
    answer.judgement.verdict = Verdict::Partial;
    answer.judgement.note = Some(Ground::FollowThrough.tag());
    answer.judgement.feedback = "Right for the values that you had found before.".to_owned();
}

/// The solution of the rest of a part from the values that the student found, the `own` of a
/// [`MarkedPart`](crate::mark::MarkedPart), as it would be written on paper. Nothing if the rest does not need them.
pub fn from_own_values(question: &KeyedQuestion, part: &KeyedPart, own: &[(Quantity, Expr)]) -> Vec<WorkingLine> {
    // A fault of Carom here costs this solution, and not a class its marks.
    catch_unwind(AssertUnwindSafe(|| solved_again(question, part, own))).unwrap_or_default()
}

fn solved_again(question: &KeyedQuestion, part: &KeyedPart, own: &[(Quantity, Expr)]) -> Vec<WorkingLine> {
    let own: Vec<&(Quantity, Expr)> = own.iter().filter(|(_, written)| question.exact(written).is_some()).collect();
    let mut known = question.given_with(own.iter().map(|(quantity, written)| (*quantity, written)));
    let mut reached: BTreeSet<Quantity> = own.iter().map(|(quantity, _)| *quantity).collect();
    reached.extend(resolve(&mut known, &reached));
    let asked: Vec<Quantity> = part.blanks.iter().flat_map(|blank| blank.find.quantities()).collect();
    let asked: Vec<Quantity> = asked.into_iter().filter(|quantity| !reached.contains(quantity)).collect();
    let (derivation, _) = Derivation::carry_out(&mut known, &asked);
    // What the working shows besides: the components before, as they are along the line of centres and across it.
    let before = |axis| Sphere::BOTH.map(|sphere| Quantity::Velocity(sphere, Moment::Before, axis));
    Derivation::carry_out(&mut known, &[Axis::N, Axis::T].map(before).concat());
    let show = Show::new(&question.scene, &known, &asked);
    let mut lines = Vec::new();
    for step in &derivation.steps {
        if step.needs.iter().any(|needed| reached.contains(needed)) {
            reached.extend(&step.gives);
            let plain = |line: Line| {
                let words = line.words.map_formulas(&mut |expr| Ok::<_, ()>(in_decimals(expr))).unwrap_or(line.words);
                WorkingLine { words, equations: line.equations.iter().map(in_decimals).collect(), label: None }
            };
            lines.extend(step.lines(&show).into_iter().map(plain));
        }
    }
    if lines.is_empty() {
        return lines;
    }
    let equation = |(quantity, written): &(Quantity, Expr)| {
        let (symbol, is_turned) = match Show::new(&question.scene, &known, &asked).of(*quantity) {
            Some((show, in_law)) => (show.named(&show.symbol(in_law)), show.is_turned(in_law)),
            None => (show.symbol(*quantity), show.is_turned(*quantity)),
        };
        Expr::equation(symbol, if is_turned { written.clone().negated() } else { written.clone() })
    };
    let equations = own.iter().filter_map(|one| match (as_vector(&own, one.0), one.0.of_its_impact()) {
        (Some(vector), Quantity::Velocity(sphere, moment, Axis::X)) => {
            Some(Expr::equation(Expr::name(show.vector_letter(sphere, moment)), vector))
        }
        (Some(_), _) => None,
        (None, _) => Some(equation(one)),
    });
    let words = Text::words("You have:");
    lines.insert(0, WorkingLine { words, equations: equations.collect(), label: None });
    lines
}

/// Adds what the student's own components along i and j come to along the line of centres and across it.
fn resolve(known: &mut Known<Value>, own: &BTreeSet<Quantity>) -> Vec<Quantity> {
    let mut found = Vec::new();
    for sphere in Sphere::BOTH {
        let of = |axis| Quantity::Velocity(sphere, Moment::After, axis);
        let components = [of(Axis::X), of(Axis::Y), Quantity::Line(Axis::X), Quantity::Line(Axis::Y)];
        let [Some(x), Some(y), Some(along_x), Some(along_y)] = components.map(|component| known.number(component))
        else {
            continue;
        };
        if !own.contains(&of(Axis::X)) || !own.contains(&of(Axis::Y)) {
            continue;
        }
        let along = &(&x * &along_x) + &(&y * &along_y);
        let across = &(&y * &along_x) - &(&x * &along_y);
        for (axis, size) in [(Axis::N, along), (Axis::T, across)] {
            known.0.insert(of(axis), Datum::Number(size));
            found.push(of(axis));
        }
    }
    found
}

/// The velocity of which a value is one component along i and j, where the other is there too.
fn as_vector(own: &[&(Quantity, Expr)], quantity: Quantity) -> Option<Expr> {
    let Quantity::Velocity(sphere, moment, Axis::X | Axis::Y) = quantity.of_its_impact() else { return None };
    let component = |axis| {
        let is_it = |other: Quantity| {
            other.impact() == quantity.impact() && other.of_its_impact() == Quantity::Velocity(sphere, moment, axis)
        };
        own.iter().find(|(other, _)| is_it(*other)).map(|(_, written)| Box::new(written.clone()))
    };
    Some(Expr::Vector(component(Axis::X)?, component(Axis::Y)?))
}

/// The most decimal places that are written in place of a fraction.
const MOST_PLACES: u32 = 5;

/// `1.92` for the `48/25` that it became: a student goes on in the figures that were written down.
fn in_decimals(expr: &Expr) -> Expr {
    let number = match expr {
        Expr::Number(number) => Some(number.clone()),
        Expr::Quotient(above, below) => match (&**above, &**below) {
            (Expr::Number(above), Expr::Number(below)) if !below.is_zero() => Some(above / below),
            _ => None,
        },
        _ => None,
    };
    let short = number.filter(|number| number.as_small().is_some_and(|(_, below)| below >= 10)).and_then(|number| {
        let decimal = round(&number, &Places::DecimalPlaces(MOST_PLACES)).to_string();
        let is_exact = decimal.parse::<Fraction>().ok().as_ref() == Some(&number);
        is_exact.then(|| Expr::Decimal(decimal.trim_end_matches('0').to_owned()))
    });
    short.unwrap_or_else(|| expr.map_children(&mut in_decimals))
}
