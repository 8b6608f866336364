//! What a person must look at: unreadable answers, lines that cannot be read where marks are missing, and another way to what
//! is to be shown.

use super::entries::Class;
use crate::bank::Code;
use crate::mark::award::{Evidence, Ground, Place};
use crate::mark::judging::{Judgement, Verdict};
use crate::mark::report::{MarkedScript, MarkedUnder};
use crate::mark::working::MOST_LINES;
use crate::mark::{Award, MarkedLine, MarkedPart};

/// What a person must look at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Look {
    /// The student's place among all.
    pub student: usize,
    /// The number of the question on the student's sheet.
    pub question: usize,
    /// The label of the part.
    pub part: String,
    /// The name of the blank, or the line of working.
    pub place: String,
    /// What was typed.
    pub typed: String,
    /// Why the marker does not decide.
    pub reason: String,
}

/// All of it, by student.
pub(super) fn all(class: &Class) -> Vec<Look> {
    let students = class.entries.iter().enumerate();
    let scripts = students.flat_map(|(student, entry)| entry.scripts.iter().flatten().map(move |s| (student, *s)));
    scripts.flat_map(|(student, script)| of_script(student, script)).collect()
}

fn of_script<'r>(student: usize, script: &'r MarkedScript<'r>) -> impl Iterator<Item = Look> + 'r {
    script.parts.iter().flat_map(move |part| {
        let look = move |place: String, typed: &str, reason: &str| Look {
            student,
            question: script.question.number,
            part: part.marked.label.clone(),
            place,
            typed: typed.to_owned(),
            reason: reason.to_owned(),
        };
        let answers = part.marked.answers.iter().filter(|answer| is_for_a_person(&answer.judgement));
        // An answer to all blanks together is one answer.
        let answers = answers.take(if part.named { usize::MAX } else { 1 }).map(move |answer| {
            let place = if part.named { answer.name.clone() } else { String::new() };
            look(place, answer.typed.as_deref().unwrap_or_default(), &answer.judgement.feedback)
        });
        let lines = (1..).zip(&part.marked.lines).filter(|(_, line)| line.reading.is_none() && !is_full(part));
        let lines = lines.map(move |(number, line)| {
            let reason = match number > MOST_LINES {
                true => {
                    format!("Of working {MOST_LINES} lines are read: a person should look at the rest, from here on.")
                }
                false => "This line of working cannot be read.".to_owned(),
            };
            look(format!("line {number}"), &line.typed, &reason)
        });
        let other_way = line_of_another_way(&part.marked)
            .map(|found| (found, "and this line plays no part in what was found of it"))
            .or_else(|| Some((chain_to_result(&part.marked)?, "and not all of its steps were found in this line")));
        let other_way = other_way.map(move |((number, line), why)| {
            let reason = format!("The working ends with what is to be shown, {why}.");
            look(format!("line {number}"), &line.typed, &reason)
        });
        answers.chain(lines).chain(other_way)
    })
}

/// One that cannot be read, or that is right beside working that ends with another number.
fn is_for_a_person(judgement: &Judgement) -> bool {
    judgement.verdict == Verdict::Unreadable || judgement.note == Some(Ground::EndsElsewhere.tag())
}

/// Does the working end with what is to be shown, with no line of it false, and are marks missing that no mistake has cost?
fn is_result_open(part: &MarkedPart) -> bool {
    let is_result = |award: &&Award| award.code == Code::A1Shown;
    let of_line = |award: &Award| matches!(&award.evidence, Some(Evidence { place: Place::Line(_), .. }));
    let ends = part.found.iter().find(is_result).is_some_and(|award| award.given && of_line(award));
    // What was lost for a mistake is no other way.
    let is_silent = |award: &Award| award.given || award.evidence.is_none() || award.falls_with_another();
    let is_lost = part.awards.iter().find(is_result).is_some_and(|award| !award.given);
    ends && is_lost && part.awards.iter().filter(|award| !is_result(award)).all(is_silent)
}

/// The first line that was read and plays no part, where the working ends with what is to be shown and marks are missing: it may
/// be a step of another way.
fn line_of_another_way(part: &MarkedPart) -> Option<(usize, &MarkedLine)> {
    let mut lines = (1..).zip(&part.lines).filter(|(_, line)| line.reading.is_some() && line.role.is_empty());
    lines.find(|(_, line)| is_result_open(part) && line.typed.contains(['=', '<', '>', '≤', '≥', '∝']))
}

/// The last line that is a chain of equals signs, where the working ends with what is to be shown and marks are missing: the
/// whole derivation may stand in it, with no law written out.
fn chain_to_result(part: &MarkedPart) -> Option<(usize, &MarkedLine)> {
    let mut lines = part.lines.iter().enumerate().map(|(place, line)| (place + 1, line)).rev();
    lines.find(|(_, line)| is_result_open(part) && line.typed.matches('=').count() > 1)
}

fn is_full(part: &MarkedUnder) -> bool {
    part.marked.awards.iter().all(|award| award.given)
}
