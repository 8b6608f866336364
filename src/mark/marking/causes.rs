//! Why an answer is wrong: every mistake that leads to it, and what it would leave of the marks.

use std::rc::Rc;

use super::by_lines::ByLines;
use super::follow::{Followed, is_near_miss, say_of};
use super::memory::Judged;
use crate::bank::{EarnedFor, Find};
use crate::mark::award::{Cause, MarkedAnswer};
use crate::mark::judging::{Note, Verdict};
use crate::mark::key::{KeyedBlank, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading, Said};
use crate::mark::slips::{self, Asked, EARLY_ROUNDING, Mistakes, early_rounding};
use crate::mark::working::Examined;
use crate::mechanics::{Quantity, Slip, Velocity};

/// The most mistakes that are listed for one answer.
const MOST: usize = 12;

/// What the causes of a part are named by, besides its answers.
pub(super) struct Seen<'a> {
    /// What the lines show.
    pub(super) by_lines: &'a ByLines,
    /// Is a value wrong that the student found in an earlier part?
    pub(super) is_wrong_before: bool,
    /// Is an unknown wrong that was asked for in an earlier part?
    pub(super) is_unknown_wrong: bool,
    pub(super) followed: &'a [Option<Followed>],
}

/// Names the mistakes behind each answer of a part that is not right.
pub(super) fn name(
    question: &KeyedQuestion,
    part: &KeyedPart,
    answers: &mut [MarkedAnswer],
    judged: &[Rc<Judged>],
    examined: &Examined,
    seen: &Seen,
) {
    for (place, (blank, judged)) in part.blanks.iter().zip(judged).enumerate() {
        let answer = &mut answers[place];
        let is_truncated = answer.judgement.note == Some(Note::Truncated.tag());
        let is_open = answer.judgement.verdict == Verdict::Wrong || is_near_miss(&answer.judgement) || is_truncated;
        let Some(readings) = judged.readings.as_ref().filter(|_| is_open) else { continue };
        let behind = || behind(question, part, blank, readings, examined, seen.by_lines);
        // What is on paper belongs to a student, and so does what comes of rounding it.
        let is_bare = examined.lines.is_empty() && examined.theirs.values.is_empty() && seen.by_lines.says_nothing();
        let mut found = match is_bare {
            true => judged.causes.get_or_init(behind).clone(),
            false => behind(),
        };
        // What is right but for the values on paper that lead to it was not cut off, but rounded before.
        if is_truncated {
            found.retain(|found| found.is_of_paper);
        }
        if is_truncated && !found.is_empty() {
            let (note, feedback) = (Note::EarlyRounding.tag(), Note::EarlyRounding.sentence().to_owned());
            (answer.judgement.note, answer.judgement.feedback) = (Some(note), feedback);
        }
        // An unknown that was found wrongly goes into all that is worked out with it.
        found.retain(|found| !(found.is_of_law && seen.is_unknown_wrong));
        let follows = seen.followed[place].is_some();
        // A mistake leads to just this value: it is no other that was rounded, and none that comes near by rounding early.
        let is_of_few = answer.judgement.note == Some(Note::TooFewFigures.tag());
        let is_slip = |found: &Found| found.is_of_law && !found.cause.tag.contains('+');
        let is_rounded = found.iter().any(|found| found.cause.tag == EARLY_ROUNDING);
        let is_no_miss = is_near_miss(&answer.judgement) && !is_rounded && !follows && found.iter().any(is_slip);
        if is_no_miss || is_of_few && found.iter().any(|found| found.is_of_law) {
            answer.judgement = answer.judgement.clone().simply_wrong();
        }
        if follows && (seen.is_wrong_before || !found.iter().any(|found| found.explains)) {
            found.clear();
            say_of(answer);
        }
        // What is said of the answer itself already says what is wrong with it.
        let is_told = answer.judgement.note.is_some() && !follows;
        if found.is_empty() && !is_told && !seen.is_wrong_before {
            found.extend(seen.by_lines.arithmetic(part, place, follows).map(of_figures));
        }
        answer.causes = found.into_iter().map(|found| found.cause).collect();
    }
}

/// A mistake as it is told.
#[derive(Clone, Debug)]
pub(super) struct Found {
    cause: Cause,
    /// Is it in the use of a law, and not in the figures?
    is_of_law: bool,
    /// Is it more than the figures of the answer?
    explains: bool,
    /// Is it the rounding of values that the working shows?
    is_of_paper: bool,
}

fn of_figures(cause: Cause) -> Found {
    Found { cause, is_of_law: false, explains: false, is_of_paper: false }
}

/// Every mistake behind an answer that the working does not speak against.
fn behind(
    question: &KeyedQuestion,
    part: &KeyedPart,
    blank: &KeyedBlank,
    readings: &[Reading],
    examined: &Examined,
    by_lines: &ByLines,
) -> Vec<Found> {
    let asked = blank.asked();
    let rounded = rounded(question, &blank.find, readings, examined);
    let is_of_paper = !examined.theirs.values.is_empty();
    let mut found: Vec<Found> =
        rounded.into_iter().map(|cause| Found { cause, is_of_law: false, explains: true, is_of_paper }).collect();
    let is_rounded = !found.is_empty();
    let causes_in = |mistakes: &Mistakes| {
        let mut each =
            readings.iter().flat_map(|reading| said_of(&asked, reading)).map(|said| mistakes.causes(&asked, said));
        each.find(|found| !found.is_empty())
    };
    let causes = question.mistakes_where_found().and_then(causes_in).or_else(|| causes_in(question.mistakes()));
    let causes = causes.unwrap_or_default();
    let said = readings.first().and_then(last_said);
    let is_nought = said.is_some_and(|said| matches!(&said.form, Form::Value(value) if value.is_zero()));
    let mut fitting: Vec<&slips::Cause> = causes
        .iter()
        .filter(|cause| by_lines.allows(cause))
        // Two mistakes at once come to nought too easily.
        .filter(|cause| !(is_nought && cause.tags.len() > 1))
        .filter(|cause| !(is_rounded && cause.tags == [EARLY_ROUNDING]))
        .collect();
    // What a line shows plainly has led to the answer, where it may have.
    if fitting.iter().any(|cause| by_lines.shows(cause)) {
        fitting.retain(|cause| by_lines.shows(cause));
    }
    if fitting.iter().any(|cause| by_lines.is_of_last_step(cause)) {
        fitting.retain(|cause| by_lines.is_of_last_step(cause));
    }
    found.extend(fitting.into_iter().take(MOST).map(|cause| {
        let is_of_law = !cause.laws.is_empty();
        Found {
            cause: explained(cause, part, has_angles(question)),
            is_of_law,
            explains: is_of_law,
            is_of_paper: false,
        }
    }));
    found
}

/// What is said of a sine and a cosine that are exchanged, as of the two components that are.
fn without_angles(sentence: &str) -> String {
    let said = |tag: &str| Slip::all().iter().find(|(_, slip)| slip.tag == tag).map(|(_, slip)| slip.sentence);
    match said("sincos-swap").zip(said("wrong-axis")) {
        Some((of_angles, of_components)) => sentence.replace(of_angles, of_components),
        None => sentence.to_owned(),
    }
}

/// Does the question give a velocity by an angle? Components in numbers are no sine and cosine that could be exchanged.
fn has_angles(question: &KeyedQuestion) -> bool {
    let mut velocities = question.scene.before.iter().chain(&question.scene.after).flatten();
    velocities.any(|velocity| matches!(velocity, Velocity::Polar { .. }))
}

/// What an answer comes to. Of a range an end may be said before the other.
fn said_of<'a>(asked: &Asked, reading: &'a Reading) -> Vec<&'a Said> {
    match asked {
        Asked::Ends => reading.statements.iter().flat_map(|statement| &statement.said).collect(),
        _ => Vec::from_iter(last_said(reading)),
    }
}

/// What the answer comes to in the end.
fn last_said(reading: &Reading) -> Option<&Said> {
    reading.statements.last()?.said.last()
}

/// Is it right but for rounding on the way?
fn rounded(question: &KeyedQuestion, find: &Find, readings: &[Reading], examined: &Examined) -> Option<Cause> {
    let Find::Quantity(quantity) = find else { return None };
    let said = last_said(readings.first()?)?;
    let shown: Vec<_> =
        examined.theirs.values.iter().map(|(quantity, (_, written))| (*quantity, written.clone())).collect();
    if shown.is_empty() && !question.mistakes().may_be_rounded(*quantity, said) {
        return None;
    }
    let found = early_rounding(&question.given, &question.letters, *quantity, &shown, said)?;
    Some(Cause { tag: EARLY_ROUNDING.to_owned(), sentence: found.sentence.to_owned(), probable: Vec::new() })
}

/// The mistake with the marks of the part that a student who made it has probably earned.
fn explained(cause: &slips::Cause, part: &KeyedPart, has_angles: bool) -> Cause {
    let mut earned: Vec<bool> = Vec::new();
    for mark in &part.scheme {
        let own = match &mark.earned_for {
            EarnedFor::Law(law, _) if mark.code.is_method() => cause.earns_method(*law),
            EarnedFor::Law(law, _) => cause.earns_accuracy(*law),
            EarnedFor::Quantity(_) | EarnedFor::Both(_) => {
                let is_kept = |quantity: &Quantity| cause.keeps(*quantity) && !is_asked(part, *quantity);
                mark.earned_for.quantities().iter().all(is_kept)
            }
            // Wrong values in a condition are no reason not to have set it up.
            EarnedFor::Condition => mark.code.is_method(),
            EarnedFor::Unknown(_) => false,
        };
        earned.push(own && mark.depends.iter().all(|needed| earned[*needed]));
    }
    let sentence = if has_angles { cause.sentence.clone() } else { without_angles(&cause.sentence) };
    let probable = part.scheme.iter().zip(earned).filter(|(_, earned)| *earned).map(|(mark, _)| mark.id.clone());
    Cause { tag: cause.tags.join("+"), sentence: part.said(&sentence), probable: probable.collect() }
}

/// The answer itself is wrong, whatever else is right.
fn is_asked(part: &KeyedPart, quantity: Quantity) -> bool {
    part.blanks.iter().any(|blank| blank.find.quantities().contains(&quantity))
}
