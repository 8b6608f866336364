//! The scripts of a class, by student and by question, whichever numbers and whichever order each sheet has.

use std::cmp::Reverse;
use std::collections::HashMap;

use super::{Names, StudentMarks};
use crate::mark::report::feedback::shown;
use crate::mark::report::{MarkReport, MarkedScript};

/// The scripts of a class.
pub(super) struct Class<'r> {
    /// The questions, in the order of the sheet.
    pub columns: Vec<Column<'r>>,
    /// The students.
    pub entries: Vec<Entry<'r>>,
}

/// A question, on whosever sheet it stands.
pub(super) struct Column<'r> {
    /// Its id in the bank.
    pub id: &'r str,
    /// Its number on the first sheet that has it.
    pub number: usize,
    /// Has it that number on all sheets?
    pub everywhere: bool,
}

/// A student.
pub(super) struct Entry<'r> {
    /// As the student handed in, and as the report calls the student.
    pub id: String,
    pub name: String,
    /// What was handed in, by question.
    pub scripts: Vec<Option<&'r MarkedScript<'r>>>,
}

impl<'r> Class<'r> {
    pub fn of(report: &'r MarkReport<'r>, names: Names) -> Class<'r> {
        let mut columns: Vec<(Column, usize)> = Vec::new();
        let mut places: HashMap<(&str, usize), usize> = HashMap::new();
        let mut students: HashMap<&str, usize> = HashMap::new();
        let mut entries: Vec<(&str, Vec<(usize, &MarkedScript)>)> = Vec::new();
        for script in &report.scripts {
            let (id, number, time) = (script.question.id.as_str(), script.question.number, time(script));
            let place = *places.entry((id, time)).or_insert_with(|| {
                columns.push((Column { id, number, everywhere: true }, columns.len()));
                columns.len() - 1
            });
            columns[place].0.everywhere &= columns[place].0.number == number;
            let student = *students.entry(&script.student).or_insert_with(|| {
                entries.push((&script.student, Vec::new()));
                entries.len() - 1
            });
            entries[student].1.push((place, script));
        }
        columns.sort_by_key(|(column, first)| (column.number, *first));
        let mut order = vec![0; columns.len()];
        columns.iter().enumerate().for_each(|(now, (_, first))| order[*first] = now);
        let by_question = |handed: Vec<(usize, &'r MarkedScript<'r>)>| {
            let mut scripts = vec![None; columns.len()];
            handed.into_iter().for_each(|(place, script)| scripts[order[place]] = Some(script));
            scripts
        };
        let entry = |(id, handed): (&str, Vec<(usize, &'r MarkedScript<'r>)>)| Entry {
            id: id.to_owned(),
            name: handed.first().map_or_else(|| id.to_owned(), |(_, script)| shown(id, script.paper)),
            scripts: by_question(handed),
        };
        let mut entries: Vec<Entry> = entries.into_iter().map(entry).collect();
        if names == Names::LeftOut {
            entries.sort_by_cached_key(|entry| (Reverse(entry.marks()), entry.traits()));
            for (number, entry) in (1..).zip(&mut entries) {
                entry.name = format!("Student {number}");
                entry.id.clone_from(&entry.name);
            }
        }
        Class { columns: columns.into_iter().map(|(column, _)| column).collect(), entries }
    }

    /// What was handed in for a question, each with the place of the student.
    pub fn scripts(&self, column: usize) -> impl Iterator<Item = (usize, &'r MarkedScript<'r>)> {
        self.entries.iter().enumerate().filter_map(move |(student, entry)| Some((student, entry.scripts[column]?)))
    }
}

/// Which time on its sheet a question stands there: the same question may be asked twice, with other numbers.
fn time(script: &MarkedScript) -> usize {
    let same = |id: &str, number| id == script.question.id && number < script.question.number;
    script.paper.questions.iter().filter(|question| same(&question.id, question.number)).count()
}

/// Of a question the marks, which of them are lost, what was typed as answers and as working, and what was noted of it.
type Traits = (Reverse<usize>, Vec<bool>, Vec<Option<String>>, Vec<String>, Vec<&'static str>);

impl Entry<'_> {
    /// All marks earned.
    pub fn marks(&self) -> usize {
        self.scripts.iter().flatten().map(|script| script.marks()).sum()
    }

    /// What was earned and typed, which orders students of equal marks without a word of their names.
    fn traits(&self) -> Vec<Traits> {
        let each = self.scripts.iter().map(|script| {
            let parts = script.iter().flat_map(|script| &script.parts);
            let lost = parts.clone().flat_map(|part| &part.marked.awards).map(|award| !award.given).collect();
            let answers = parts.clone().flat_map(|part| &part.marked.answers);
            let typed = answers.clone().map(|answer| answer.typed.clone()).collect();
            let working = parts.clone().flat_map(|part| &part.marked.lines).map(|line| line.typed.clone()).collect();
            let noted = answers.filter_map(|answer| answer.judgement.note);
            let noted =
                noted.chain(parts.flat_map(|part| &part.marked.awards).filter_map(|award| award.note)).collect();
            (Reverse(script.map_or(0, MarkedScript::marks)), lost, typed, working, noted)
        });
        each.collect()
    }

    pub fn in_all(&self) -> StudentMarks {
        let paper = self.scripts.iter().flatten().map(|script| script.paper).next();
        let parts = paper.into_iter().flat_map(|paper| &paper.questions).flat_map(|question| &question.parts);
        StudentMarks {
            id: self.id.clone(),
            name: self.name.clone(),
            marks: self.marks(),
            available: parts.map(|part| part.available()).sum(),
            questions: self.scripts.iter().map(|script| script.map(MarkedScript::marks)).collect(),
        }
    }
}
