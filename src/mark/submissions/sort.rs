//! Rows looked up in the key and gathered into scripts, in the order in which students and questions first appear.

use std::collections::HashMap;

use super::{Row, Rows, SetAside, lookup};
use crate::mark::key::{AnswerKey, KeyedPaper, KeyedQuestion};
use crate::mark::script::{PartScript, Script};

/// All scripts of a file, and what has no place in any.
#[derive(Clone, Debug)]
pub struct Sorted<'k> {
    /// What each student handed in for each question.
    pub scripts: Vec<HandedIn<'k>>,
    /// Rows that are not marked, in the order of their lines.
    pub set_aside: Vec<SetAside>,
    /// How many rows nobody filled in.
    pub unfilled: usize,
}

/// What a student handed in for a question, beside the question.
#[derive(Clone, Debug)]
pub struct HandedIn<'k> {
    /// The student's paper.
    pub paper: &'k KeyedPaper,
    /// The question.
    pub question: &'k KeyedQuestion,
    /// What stands under it.
    pub script: Script,
    /// The parts handed in, in the order of the key.
    pub parts: Vec<HandedPart>,
}

/// A part of a question that was handed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HandedPart {
    /// Its place in the question.
    pub place: usize,
    /// Were blanks named?
    pub named: bool,
}

/// Rows of a script that have been looked up: the part, the blank if one is named, the row.
struct Gathered<'k> {
    paper: &'k KeyedPaper,
    question: &'k KeyedQuestion,
    student: String,
    rows: Vec<(usize, Option<usize>, Row)>,
}

/// Sorts rows by student and question.
///
/// A row without an answer and without working is nothing if it names no student, and an empty answer if it does. Where
/// the same is answered twice, the last answer counts.
pub fn sort<'k>(key: &'k AnswerKey, rows: Rows) -> Sorted<'k> {
    let mut gathered: Vec<Gathered<'k>> = Vec::new();
    let mut places: HashMap<(String, usize), usize> = HashMap::new();
    let mut set_aside = rows.set_aside;
    let mut unfilled = 0;
    for row in rows.rows {
        let student = row.student.trim();
        if student.is_empty() && !row.says_something() {
            unfilled += 1;
            continue;
        }
        match look_up(key, student, &row) {
            Ok((paper, question, part, blank)) => {
                // Most rows follow one of the same student and question.
                let place = question;
                let question = &paper.questions[place];
                let is_same = |last: &Gathered| std::ptr::eq(last.question, question) && last.student == student;
                let place = match gathered.last() {
                    Some(last) if is_same(last) => gathered.len() - 1,
                    _ => *places.entry((student.to_owned(), place)).or_insert_with(|| {
                        gathered.push(Gathered { paper, question, student: student.to_owned(), rows: Vec::new() });
                        gathered.len() - 1
                    }),
                };
                gathered[place].rows.push((part, blank, row));
            }
            Err(reason) => set_aside.push(SetAside { row, reason }),
        }
    }
    let scripts = gathered.into_iter().map(|gathered| gathered.into_script(&mut set_aside)).collect();
    set_aside.sort_by_key(|aside| aside.row.line);
    Sorted { scripts, set_aside, unfilled }
}

type Place<'k> = (&'k KeyedPaper, usize, usize, Option<usize>);

fn look_up<'k>(key: &'k AnswerKey, student: &str, row: &Row) -> Result<Place<'k>, String> {
    let paper = lookup::paper(key, student)?;
    let place = lookup::question(paper, &row.question)?;
    let question = &paper.questions[place];
    let part = lookup::part(question, &row.part)?;
    let named = Some(row.blank.trim()).filter(|name| !name.is_empty());
    let blank = named.map(|name| lookup::blank(&question.parts[part], name)).transpose()?;
    Ok((paper, place, part, blank))
}

impl<'k> Gathered<'k> {
    fn into_script(self, set_aside: &mut Vec<SetAside>) -> HandedIn<'k> {
        // The line of the answer that counts, where there are several.
        let mut last: Vec<((usize, Option<usize>), usize)> = Vec::with_capacity(self.rows.len().min(16));
        for (part, blank, row) in self.rows.iter().filter(|(_, _, row)| !row.answer.trim().is_empty()) {
            match last.iter_mut().find(|(place, _)| *place == (*part, *blank)) {
                Some((_, line)) => *line = row.line,
                None => last.push(((*part, *blank), row.line)),
            }
        }
        let mut parts: Vec<PartScript> = Vec::new();
        let mut handed: Vec<HandedPart> = Vec::new();
        for (place, blank, mut row) in self.rows {
            let counts = last.iter().find(|(known, _)| *known == (place, blank)).map(|(_, line)| *line);
            if let Some(counts) = counts.filter(|line| row.line != *line && !row.answer.trim().is_empty()) {
                let reason = format!("line {counts} answers the same, and the last answer counts");
                set_aside.push(SetAside { row, reason });
                continue;
            }
            let part = &self.question.parts[place];
            let at = handed.iter().position(|handed| handed.place == place).unwrap_or_else(|| {
                handed.push(HandedPart { place, named: false });
                parts.push(PartScript { label: part.label.clone(), ..PartScript::default() });
                parts.len() - 1
            });
            handed[at].named |= blank.is_some();
            if !row.answer.trim().is_empty() {
                // As the key has it, and mostly the student too.
                let name = blank.map(|blank| match &part.blanks[blank].name {
                    name if *name == row.blank => std::mem::take(&mut row.blank),
                    name => name.clone(),
                });
                parts[at].answers.push((name, row.answer));
            }
            // Working that stands beside each blank of a part is the working of the part, once.
            if !row.working.is_empty() && !contains(&parts[at].working, &row.working) {
                parts[at].working.extend(row.working);
            }
        }
        handed.sort_by_key(|handed| handed.place);
        let script = Script { student: self.student, question: self.question.number, parts };
        HandedIn { paper: self.paper, question: self.question, script, parts: handed }
    }
}

fn contains(working: &[String], lines: &[String]) -> bool {
    working.windows(lines.len()).any(|window| window == lines)
}
