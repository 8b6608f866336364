//! Reports: scripts marked, and what is told of them, as tables, as JSON lines, in a summary and for each student.

mod bulk;
mod class;
mod feedback;
mod file_names;
mod json_lines;
mod not_marked;
mod rows;

pub use bulk::Bulk;
pub use class::{
    ClassReport, Discrimination, Finding, Look, Made, MarkFigures, Mistake, Names, NoteCount, QuestionFigures,
    StudentMarks, marks_table, mistakes_table, students_table,
};
pub use feedback::Feedback;
pub use file_names::file_names;
pub use json_lines::marks_jsonl;
pub use not_marked::not_marked_csv;
pub use rows::{MARKS, MarkRow, marks_csv};

use super::award::MarkedPart;
use super::key::{KeyedPaper, KeyedPart, KeyedQuestion};
use super::marking::{Memory, Word, from_own_values, mark_remembering, overrule};
use super::profile::Profile;
use super::submissions::{HandedIn, Override};
use crate::paper::WorkingLine;

/// Scripts marked, in the order in which they were handed in.
#[derive(Clone, Debug)]
pub struct MarkReport<'k> {
    /// What each student earned for each question.
    pub scripts: Vec<MarkedScript<'k>>,
    /// Words of a person on what nobody handed in.
    pub idle: Vec<Override>,
}

/// What a student earned for a question.
#[derive(Clone, Debug)]
pub struct MarkedScript<'k> {
    /// The student.
    pub student: String,
    /// The student's paper.
    pub paper: &'k KeyedPaper,
    /// The question.
    pub question: &'k KeyedQuestion,
    /// The parts handed in, in the order of the key.
    pub parts: Vec<MarkedUnder<'k>>,
}

/// A part marked, beside what it was marked against.
#[derive(Clone, Debug)]
pub struct MarkedUnder<'k> {
    /// The part in the key.
    pub keyed: &'k KeyedPart,
    /// Did the student name the blanks?
    pub named: bool,
    /// What it earned.
    pub marked: MarkedPart,
}

impl<'k> MarkReport<'k> {
    /// Marks scripts, and lets a person have the last word.
    pub fn new(scripts: &[HandedIn<'k>], profile: &Profile, overrides: Vec<Override>) -> MarkReport<'k> {
        let mut memory = Memory::default();
        let mut scripts: Vec<MarkedScript<'k>> =
            scripts.iter().map(|script| marked(script, profile, &mut memory)).collect();
        let idle = overrides.iter().filter(|word| !obey(word, &overrides, &mut scripts)).cloned().collect();
        MarkReport { scripts, idle }
    }
}

fn marked<'k>(handed: &HandedIn<'k>, profile: &Profile, memory: &mut Memory) -> MarkedScript<'k> {
    let (script, parts) = handed.script();
    let mut all: Vec<Option<MarkedPart>> =
        mark_remembering(handed.question, &script, profile, memory).into_iter().map(Some).collect();
    let each = parts.iter().filter_map(|part| {
        let marked = all.get_mut(part.place)?.take()?;
        Some(MarkedUnder { keyed: &handed.question.parts[part.place], named: part.named, marked })
    });
    let (paper, question) = (handed.paper, handed.question);
    MarkedScript { student: script.student, paper, question, parts: each.collect() }
}

/// Obeys all words on the part of which one speaks; was there such a part?
fn obey(word: &Override, all: &[Override], scripts: &mut [MarkedScript]) -> bool {
    let is_his = |script: &&mut MarkedScript| script.student == word.student && script.question.number == word.question;
    let Some(script) = scripts.iter_mut().find(is_his) else { return false };
    let label = &script.question.parts[word.part].label;
    let Some(part) = script.parts.iter_mut().find(|part| part.keyed.label == *label) else { return false };
    let same = all
        .iter()
        .filter(|other| (&other.student, other.question, other.part) == (&word.student, word.question, word.part));
    let words: Vec<Word> =
        same.map(|word| Word { mark: word.mark, given: word.given, comment: word.comment.clone() }).collect();
    overrule(part.keyed, &mut part.marked, &words);
    true
}

impl MarkedScript<'_> {
    /// The marks earned.
    pub fn marks(&self) -> usize {
        self.parts.iter().map(|part| part.marked.marks()).sum()
    }

    /// The marks that the question has, in all its parts.
    pub fn available(&self) -> usize {
        self.question.parts.iter().map(KeyedPart::available).sum()
    }

    /// The solution of the rest of a part from the student's own values, where they are wrong and marks were lost.
    pub fn from_own_values(&self, part: &MarkedUnder) -> Vec<WorkingLine> {
        from_own_values(self.question, part.keyed, &part.marked.own)
    }
}
