//! Right answers beside working that comes to something else: the marks stand, and a person is told. What is plainly denied is
//! not for a person: see the last word.

use std::rc::Rc;

use super::memory::{Judged, Lines};
use crate::answer::Kind;
use crate::bank::Find;
use crate::expr::{Expr, Relation};
use crate::mark::award::{Ground, MarkedAnswer};
use crate::mark::judging::{Note, Verdict, is_nearly_rounding, judge};
use crate::mark::key::{KeyedBlank, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading, Said, Statement};
use crate::mark::script::PartScript;
use crate::mark::working::{Examined, Theirs, typed_lines};
use crate::mechanics::{Moment, Quantity};

/// What was handed in for a part, read and judged.
pub(super) struct HandedIn<'a> {
    pub(super) script: &'a PartScript,
    pub(super) lines: &'a Lines,
    pub(super) judged: &'a [Rc<Judged>],
}

/// Of answers that are right though what the working comes to is something else, says so: a person can tell whether they have
/// come from there.
pub(super) fn point_out(
    question: &KeyedQuestion,
    part: &KeyedPart,
    handed_in: &HandedIn,
    before: &Theirs,
    examined: &Examined,
    answers: &mut [MarkedAnswer],
) {
    let HandedIn { script, lines, judged } = handed_in;
    let is_right = |answer: &MarkedAnswer| {
        let is_typed = script.answers.iter().any(|(_, typed)| Some(typed) == answer.typed.as_ref());
        is_typed && answer.judgement.verdict == Verdict::Correct && answer.judgement.note.is_none()
    };
    let right: Vec<usize> = (0..answers.len()).filter(|place| is_right(&answers[*place])).collect();
    if right.is_empty() {
        return;
    }
    let wrong = wrong_velocities(question, before, examined);
    let elsewhere =
        |place: &usize| !wrong.is_empty() && leads_elsewhere(question, &part.blanks[*place], &wrong, examined);
    // Another answer is what the working ends with.
    let is_taken = |said: &Said| {
        let others = judged.iter().enumerate().filter(|(place, _)| !right.contains(place));
        others
            .filter_map(|(_, judged)| judged.said_last())
            .any(|own| own.form == said.form || is_nearly_rounding(said, own))
    };
    let beside = beside_end(part, examined, &right, &is_taken);
    let is_pointed_out = |place: &usize| {
        Some(*place) == beside || elsewhere(place) || is_another_range(&part.blanks[*place], script, lines)
    };
    for place in right.iter().copied().filter(is_pointed_out) {
        let judgement = &mut answers[place].judgement;
        judgement.note = Some(Ground::EndsElsewhere.tag());
        judgement.feedback = ENDS_ELSEWHERE.to_owned();
    }
}

const ENDS_ELSEWHERE: &str = "Right, though your working comes to something else: a person should look at it.";

/// Of these answers the one that no line has, where the lines end with another number for it that is called so or nothing.
fn beside_end(
    part: &KeyedPart,
    examined: &Examined,
    right: &[usize],
    is_taken: &dyn Fn(&Said) -> bool,
) -> Option<usize> {
    let end = examined.end.as_ref().filter(|end| !end.statement.said.last().is_some_and(is_taken))?;
    let value = Statement { label: None, ..end.statement.clone() };
    let reading = Reading { statements: vec![value], printed: String::new(), decided: Vec::new() };
    // What is the other way round, or measured from another line, is a step.
    const STEPS: [Note; 5] = [Note::Complement, Note::Supplement, Note::Sign, Note::Inverted, Note::UnitWrong];
    let is_step = |note: &str| STEPS.iter().any(|step| step.tag() == note);
    let is_wrong = |blank: &KeyedBlank| {
        let judgement = judge(&blank.model, &Ok(vec![reading.clone()]));
        judgement.verdict == Verdict::Wrong && !judgement.note.is_some_and(is_step)
    };
    let may_be_of = |place: usize| {
        let is_called = end.statement.label.is_none() || part.calls(place, &end.statement);
        // Nought may be anything's.
        is_called && end.is_never_right[place] && part.blanks[place].model.value != Expr::integer(0)
    };
    let beside = right.iter().copied().filter(|place| may_be_of(*place));
    let beside = beside.max_by_key(|place| (end.is_worked_out[*place], *place));
    beside.filter(|_| part.blanks.iter().all(is_wrong))
}

/// The velocities along the line of centres that the working of this part has found to be of another size.
fn wrong_velocities(question: &KeyedQuestion, before: &Theirs, examined: &Examined) -> Vec<Quantity> {
    let wrong: Vec<Quantity> = examined.theirs.wrong(question).map(|(quantity, _)| quantity).collect();
    let right = |quantity: Quantity| match question.meeting(quantity.impact()) {
        Some(meeting) => {
            question.impact(meeting, &Theirs::default())?.prepared().known_sizes(meeting.in_law(quantity)?)
        }
        None => question.prepared().known_sizes(quantity).filter(|_| wrong.contains(&quantity)),
    };
    let is_apart = |(quantity, (own, _)): &(&Quantity, &(Vec<f64>, Expr))| {
        let is_velocity = matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, _));
        is_velocity
            && !before.values.contains_key(quantity)
            && !examined.found_once.contains(quantity)
            && right(**quantity).is_some_and(|right| are_apart(own, &right))
    };
    examined.theirs.values.iter().filter(is_apart).map(|(quantity, _)| *quantity).collect()
}

/// Is a blank for one of the velocities that are wrong, or for what comes to something else by them?
fn leads_elsewhere(question: &KeyedQuestion, blank: &KeyedBlank, wrong: &[Quantity], examined: &Examined) -> bool {
    let Find::Quantity(asked) = blank.find else { return false };
    let prepared = question.prepared();
    let along = question.along_its_line(asked).map_or(prepared.along(asked), |(along, _)| along);
    if wrong.contains(&asked) || wrong.contains(&along) {
        return true;
    }
    // What is found rightly by itself does not come from there.
    if [asked, along].iter().any(|own| examined.theirs.values.contains_key(own)) {
        return false;
    }
    let [own, right] = [examined.followed(question, asked), prepared.known_sizes(asked)];
    own.zip(right).is_some_and(|(own, right)| are_apart(&own, &right))
}

/// Does the last line say of the letter of a range that it is elsewhere, and no line where it is?
fn is_another_range(blank: &KeyedBlank, script: &PartScript, lines: &Lines) -> bool {
    if blank.model.kind != Kind::Range {
        return false;
    }
    let verdict = |line: &str| {
        let readings = lines.read(line, &blank.model.vocabulary);
        let is_comparison = |said: &Said| match &said.form {
            Form::Range(..) => true,
            Form::Equation(Expr::Relation(_, relation, _)) => *relation != Relation::Equal,
            _ => false,
        };
        let reading = readings.as_ref().as_ref().ok()?.first()?;
        let is_range = reading.statements.iter().flat_map(|statement| &statement.said).any(is_comparison);
        let judgement = is_range.then(|| judge(&blank.model, &readings))?;
        // `v < 0` is said of a letter of the student's own.
        (judgement.note != Some(Note::UnknownLetter.tag())).then_some(judgement.verdict)
    };
    let mut verdicts = typed_lines(&script.working).rev().map(verdict);
    verdicts.next().flatten() == Some(Verdict::Wrong) && verdicts.all(|one| one.is_none_or(|one| one == Verdict::Wrong))
}

/// Are they plainly of different sizes at every point?
fn are_apart(own: &[f64], right: &[f64]) -> bool {
    /// Less of the greater may be rounding.
    const ROUNDED: f64 = 0.05;
    let apart = |(own, right): (&f64, &f64)| (own.abs() - right.abs()).abs() > ROUNDED * own.abs().max(right.abs());
    own.len() == right.len() && own.iter().zip(right).all(apart)
}
