//! What goes back to each student: all scripts of one, on a page.

use std::collections::HashMap;

use super::{MarkReport, MarkedScript, file_names};
use crate::mark::key::KeyedPaper;

/// The page of a student.
#[derive(Clone, Debug)]
pub struct Feedback<'r> {
    /// The student.
    pub student: &'r str,
    /// The same with the name, where the key of a class has both: `Ada Lovelace (1001)`.
    pub shown: String,
    /// The name of its file, without an ending.
    pub file: String,
    /// The code of the paper.
    pub code: &'r str,
    /// The questions handed in, in the order of the sheet.
    pub scripts: Vec<&'r MarkedScript<'r>>,
}

impl<'r> Feedback<'r> {
    /// A page for each student, in the order in which they handed in.
    pub fn of(report: &'r MarkReport<'r>) -> Vec<Feedback<'r>> {
        let mut pages: Vec<Feedback<'r>> = Vec::new();
        let mut places: HashMap<&str, usize> = HashMap::new();
        for script in &report.scripts {
            let (student, code) = (script.student.as_str(), script.paper.code.as_str());
            let place = *places.entry(student).or_insert_with(|| {
                let shown = shown(student, script.paper);
                pages.push(Feedback { student, shown, file: String::new(), code, scripts: Vec::new() });
                pages.len() - 1
            });
            pages[place].scripts.push(script);
        }
        let names = file_names(pages.iter().map(|page| page.student));
        for (page, name) in pages.iter_mut().zip(names) {
            page.file = name;
            page.scripts.sort_by_key(|script| script.question.number);
        }
        pages
    }

    /// The marks earned.
    pub fn marks(&self) -> usize {
        self.scripts.iter().map(|script| script.marks()).sum()
    }

    /// The marks of the whole paper.
    pub fn available(&self) -> usize {
        let paper = self.scripts.first().map(|script| script.paper);
        let parts = paper.into_iter().flat_map(|paper| &paper.questions).flat_map(|question| &question.parts);
        parts.map(|part| part.available()).sum()
    }
}

/// A student by name, if the key has one, and by what the school calls the student.
pub(super) fn shown(student: &str, paper: &KeyedPaper) -> String {
    if paper.name.is_empty() { student.to_owned() } else { format!("{} ({student})", paper.name) }
}
