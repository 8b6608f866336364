//! A class at a glance: how hard each question was, which marks were won, what went wrong, what a person must look at.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use super::{MarkReport, MarkedScript, MarkedUnder};
use crate::mark::judging::Verdict;

/// A class at a glance.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Summary {
    /// How many students handed in.
    pub students: usize,
    /// All marks earned.
    pub marks: usize,
    /// The marks of the paper, if all have equally many; of the longest, if not.
    pub available: usize,
    /// The questions in the order of the sheet.
    pub questions: Vec<Facility>,
    /// What was noted, the most frequent first.
    pub notes: Vec<NoteCount>,
    /// What a person must look at.
    pub look: Vec<Look>,
}

/// How hard a question was.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Facility {
    /// Its number on the sheet.
    pub number: usize,
    /// Its id in the bank.
    pub id: String,
    /// How many handed it in.
    pub scripts: usize,
    /// All marks earned with it.
    pub marks: usize,
    /// The marks of one script.
    pub available: usize,
    /// Each mark of its scheme.
    pub scheme: Vec<MarkWon>,
}

/// How many won a mark.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MarkWon {
    /// The label of the part.
    pub part: String,
    /// Its id within the part.
    pub id: String,
    /// Its code.
    pub code: String,
    /// How many won it.
    pub won: usize,
}

/// How often something was noted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NoteCount {
    /// The tag.
    pub note: String,
    /// In how many rows.
    pub count: usize,
}

/// What a person must look at.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Look {
    /// The student.
    pub student: String,
    /// The number of the question on the sheet.
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

impl Facility {
    /// The share of the marks that was earned, in whole per cent.
    pub fn per_cent(&self) -> usize {
        match self.scripts * self.available {
            0 => 0,
            all => (200 * self.marks + all) / (2 * all),
        }
    }
}

impl Summary {
    /// The summary of a report.
    pub fn new(report: &MarkReport) -> Summary {
        let students: BTreeSet<&str> = report.scripts.iter().map(|script| script.student.as_str()).collect();
        let of_paper = |script: &MarkedScript| {
            let parts = script.paper.questions.iter().flat_map(|question| &question.parts);
            parts.map(|part| part.available()).sum()
        };
        Summary {
            students: students.len(),
            marks: report.scripts.iter().map(MarkedScript::marks).sum(),
            available: report.scripts.iter().map(of_paper).max().unwrap_or(0),
            questions: questions(report),
            notes: notes(report),
            look: report.scripts.iter().flat_map(looks).collect(),
        }
    }

    /// The mean mark of a student in tenths of a mark, rounded.
    pub fn mean_in_tenths(&self) -> usize {
        match self.students {
            0 => 0,
            students => (20 * self.marks + students) / (2 * students),
        }
    }
}

fn questions(report: &MarkReport) -> Vec<Facility> {
    let mut found: BTreeMap<(usize, &str), Facility> = BTreeMap::new();
    for script in &report.scripts {
        let (number, id) = (script.question.number, script.question.id.as_str());
        let facility = found.entry((number, id)).or_insert_with(|| Facility {
            number,
            id: id.to_owned(),
            scripts: 0,
            marks: 0,
            available: script.available(),
            scheme: Vec::new(),
        });
        facility.scripts += 1;
        facility.marks += script.marks();
        // Of a class each may have other numbers, but the scheme of a question is the same for all.
        let parts = script.question.parts.iter();
        let scheme = parts.flat_map(|part| part.scheme.iter().map(move |mark| (part, mark)));
        if facility.scheme.is_empty() {
            let row = |(part, mark): (&crate::mark::KeyedPart, &crate::mark::KeyedMark)| MarkWon {
                part: part.label.clone(),
                id: mark.id.clone(),
                code: mark.code.name().to_owned(),
                won: 0,
            };
            facility.scheme = scheme.map(row).collect();
        }
        for part in &script.parts {
            for award in part.marked.awards.iter().filter(|award| award.given) {
                let is_it = |row: &&mut MarkWon| row.part == part.marked.label && row.id == award.id;
                if let Some(row) = facility.scheme.iter_mut().find(is_it) {
                    row.won += 1;
                }
            }
        }
    }
    found.into_values().collect()
}

fn notes(report: &MarkReport) -> Vec<NoteCount> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for row in report.scripts.iter().flat_map(MarkedScript::rows).filter(|row| !row.note.is_empty()) {
        *counts.entry(row.note).or_default() += 1;
    }
    let mut counts: Vec<NoteCount> = counts.into_iter().map(|(note, count)| NoteCount { note, count }).collect();
    counts.sort_by_key(|one| std::cmp::Reverse(one.count));
    counts
}

/// What a person must look at in a script: unreadable answers, and lines that cannot be read where marks are missing.
fn looks<'r>(script: &'r MarkedScript) -> impl Iterator<Item = Look> + 'r {
    script.parts.iter().flat_map(move |part| {
        let look = move |place: String, typed: &str, reason: &str| Look {
            student: script.student.clone(),
            question: script.question.number,
            part: part.marked.label.clone(),
            place,
            typed: typed.to_owned(),
            reason: reason.to_owned(),
        };
        let answers = part.marked.answers.iter().filter(|answer| answer.judgement.verdict == Verdict::Unreadable);
        // An answer to all blanks together is one answer.
        let answers = answers.take(if part.named { usize::MAX } else { 1 }).map(move |answer| {
            let place = if part.named { answer.name.clone() } else { String::new() };
            look(place, answer.typed.as_deref().unwrap_or_default(), &answer.judgement.feedback)
        });
        let lines = (1..).zip(&part.marked.lines).filter(|(_, line)| line.reading.is_none() && !is_full(part));
        let lines = lines.map(move |(number, line)| {
            look(format!("line {number}"), &line.typed, "This line of working cannot be read.")
        });
        answers.chain(lines)
    })
}

fn is_full(part: &MarkedUnder) -> bool {
    part.marked.awards.iter().all(|award| award.given)
}
