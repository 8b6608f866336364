//! Why an answer is wrong: every mistake that leads to it, and what it would leave of the marks.

use std::rc::Rc;

use super::memory::Judged;
use crate::bank::{EarnedFor, Find};
use crate::mark::award::{Cause, MarkedAnswer};
use crate::mark::judging::{Note, Verdict};
use crate::mark::key::{KeyedBlank, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Reading, Said};
use crate::mark::slips::{self, EARLY_ROUNDING, early_rounding};
use crate::mark::working::Examined;

/// The most mistakes that are listed for one answer.
const MOST: usize = 12;

/// Names the mistakes behind each answer of a part that is not right.
pub(super) fn name(
    question: &KeyedQuestion,
    part: &KeyedPart,
    answers: &mut [MarkedAnswer],
    judged: &[Rc<Judged>],
    examined: &Examined,
) {
    for ((blank, answer), judged) in part.blanks.iter().zip(answers).zip(judged) {
        let near = answer.judgement.note == Some(Note::NearMiss.tag());
        let is_open = answer.judgement.verdict == Verdict::Wrong || near;
        let Some(readings) = judged.readings.as_ref().filter(|_| is_open) else { continue };
        let behind = || behind(question, part, blank, readings, examined);
        // Values on the way belong to a student, and so does what comes of rounding them.
        answer.causes = match examined.theirs.0.is_empty() {
            true => judged.causes.get_or_init(behind).clone(),
            false => behind(),
        };
    }
}

/// Every mistake behind an answer.
fn behind(
    question: &KeyedQuestion,
    part: &KeyedPart,
    blank: &KeyedBlank,
    readings: &[Reading],
    examined: &Examined,
) -> Vec<Cause> {
    let asked = blank.find.quantities();
    if asked.is_empty() {
        return Vec::new();
    }
    let mut causes: Vec<Cause> = rounded(question, &blank.find, readings, examined).into_iter().collect();
    let each = readings.iter().filter_map(last_said).map(|said| question.mistakes().causes(&asked, said));
    let found = each.into_iter().find(|found| !found.is_empty()).unwrap_or_default();
    causes.extend(found.iter().take(MOST).map(|cause| explained(cause, part)));
    causes
}

/// What the answer comes to in the end.
fn last_said(reading: &Reading) -> Option<&Said> {
    reading.statements.last()?.said.last()
}

/// Is it right but for rounding on the way?
fn rounded(question: &KeyedQuestion, find: &Find, readings: &[Reading], examined: &Examined) -> Option<Cause> {
    let Find::Quantity(quantity) = find else { return None };
    let said = last_said(readings.first()?)?;
    let shown: Vec<_> = examined.theirs.0.iter().map(|(quantity, (_, written))| (*quantity, written.clone())).collect();
    if shown.is_empty() && !question.mistakes().may_be_rounded(*quantity, said) {
        return None;
    }
    let found = early_rounding(&question.given, &question.letters, *quantity, &shown, said)?;
    Some(Cause { tag: EARLY_ROUNDING.to_owned(), sentence: found.sentence.to_owned(), probable: Vec::new() })
}

/// The mistake with the marks of the part that a student who made it has probably earned.
fn explained(cause: &slips::Cause, part: &KeyedPart) -> Cause {
    let mut earned: Vec<bool> = Vec::new();
    for mark in &part.scheme {
        let own = match &mark.earned_for {
            EarnedFor::Law(law, _) if mark.code.is_method() => cause.earns_method(*law),
            EarnedFor::Law(law, _) => cause.earns_accuracy(*law),
            EarnedFor::Quantity(quantity) => cause.keeps(*quantity) && !is_asked(part, *quantity),
            EarnedFor::Condition | EarnedFor::Unknown(_) => false,
        };
        earned.push(own && mark.depends.iter().all(|needed| earned[*needed]));
    }
    let probable = part.scheme.iter().zip(earned).filter(|(_, earned)| *earned).map(|(mark, _)| mark.id.clone());
    Cause { tag: cause.tags.join("+"), sentence: part.said(&cause.sentence), probable: probable.collect() }
}

/// The answer itself is wrong, whatever else is right.
fn is_asked(part: &KeyedPart, quantity: crate::mechanics::Quantity) -> bool {
    part.blanks.iter().any(|blank| blank.find.quantities().contains(&quantity))
}
