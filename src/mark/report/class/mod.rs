//! A class at a glance, as a head of department asks for it: marks by student and by question, how hard each mark was and
//! whether it told strong students from weak ones, which mistakes were made by whom, what looks wrong with a question, and
//! what a person must still look at.
//!
//! Of a class each student may have other numbers. A question is then the same for all by its id in the bank, and a mark by
//! its part and its id in the scheme.

mod discrimination;
mod entries;
mod finding;
mod looks;
mod mistakes;
mod question;
mod same_value;
mod tables;

use std::collections::BTreeMap;

pub use discrimination::Discrimination;
pub use finding::Finding;
pub use looks::Look;
pub use mistakes::{Made, Mistake};
pub use question::{MarkFigures, QuestionFigures};
pub use tables::{marks_table, mistakes_table, students_table};

use super::{MarkReport, MarkedScript};
use entries::{Class, Entry};

/// Are students called by their names?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    /// As they handed in, in that order.
    Shown,
    /// `Student 1` has the most marks, and the order says nothing else: neither the alphabet nor who handed in first.
    LeftOut,
}

/// A class at a glance.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClassReport {
    /// Are students called by their names?
    pub names: Names,
    /// The students who handed in; elsewhere they are places in this list.
    pub students: Vec<StudentMarks>,
    /// The marks of the paper, if all have equally many; of the longest, if not.
    pub available: usize,
    /// The questions that somebody handed in, in the order of the sheet.
    pub questions: Vec<QuestionFigures>,
    /// Slips, those of the most students first.
    pub slips: Vec<Mistake>,
    /// Too few figures, and rounding too early or not at all.
    pub accuracy: Vec<Mistake>,
    /// The notes in the rows of the table of marks, the most frequent first.
    pub notes: Vec<NoteCount>,
    /// What looks wrong with a question, in its order.
    pub findings: Vec<Finding>,
    /// What a person must look at.
    pub look: Vec<Look>,
    /// How many rows have no place in the key.
    pub not_marked: usize,
}

/// What a student earned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudentMarks {
    /// As the student handed in, or `Student 1`.
    pub id: String,
    /// The same with the name, where the key of a class has both: `Ada Lovelace (1001)`.
    pub name: String,
    /// All marks earned.
    pub marks: usize,
    /// The marks of the student's paper, what was not handed in among them.
    pub available: usize,
    /// For each question of the report the marks earned; `None` if it was not handed in.
    pub questions: Vec<Option<usize>>,
}

impl StudentMarks {
    /// The name alone, where the key of a class has one; else empty.
    pub fn own_name(&self) -> &str {
        let with_id = self.name.strip_suffix(')').and_then(|name| name.strip_suffix(self.id.as_str()));
        with_id.and_then(|name| name.strip_suffix(" (")).unwrap_or("")
    }
}

/// How often something was noted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoteCount {
    /// The tag.
    pub note: String,
    /// In how many rows.
    pub count: usize,
}

impl ClassReport {
    /// The report on scripts that have been marked, when so many rows could not be.
    pub fn new(report: &MarkReport, not_marked: usize, names: Names) -> ClassReport {
        let class = Class::of(report, names);
        let questions = question::figures(&class);
        let (slips, accuracy) = mistakes::made(&class);
        let students: Vec<StudentMarks> = class.entries.iter().map(Entry::in_all).collect();
        ClassReport {
            names,
            available: students.iter().map(|student| student.available).max().unwrap_or(0),
            findings: finding::all(&class, &questions),
            look: looks::all(&class),
            notes: notes(report),
            students,
            questions,
            slips,
            accuracy,
            not_marked,
        }
    }

    /// All marks earned.
    pub fn marks(&self) -> usize {
        self.students.iter().map(|student| student.marks).sum()
    }

    /// The mean mark of a student in tenths of a mark, rounded.
    pub fn mean_in_tenths(&self) -> usize {
        rounded(10 * self.marks(), self.students.len())
    }

    /// How many students have how much of their paper: below 10 per cent, below 20, …, and from 90 to all.
    pub fn tenths(&self) -> [usize; 10] {
        let mut tenths = [0; 10];
        for student in self.students.iter().filter(|student| student.available > 0) {
            tenths[(10 * student.marks / student.available).min(9)] += 1;
        }
        tenths
    }
}

impl StudentMarks {
    /// The share of the paper that was earned, in whole per cent.
    pub fn per_cent(&self) -> usize {
        rounded(100 * self.marks, self.available)
    }
}

/// A quotient rounded, a half up; nothing of nothing is nought.
fn rounded(above: usize, below: usize) -> usize {
    match below {
        0 => 0,
        below => (2 * above + below) / (2 * below),
    }
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
