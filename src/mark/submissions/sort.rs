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
    /// The rows that count, in order; there is one at least.
    pub rows: Vec<HandedRow>,
}

/// A row that has been looked up in the key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HandedRow {
    /// The place of the part in the question.
    pub part: usize,
    /// The place of the blank in the part, if one is named.
    pub blank: Option<usize>,
    /// The row.
    pub row: Row,
}

/// A part of a question that was handed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HandedPart {
    /// Its place in the question.
    pub place: usize,
    /// Were blanks named?
    pub named: bool,
}

/// Sorts rows by student and question.
///
/// A row without an answer and without working is nothing if it names no student, and an empty answer if it does. Where
/// the same is answered twice, the last answer counts.
pub fn sort<'k>(key: &'k AnswerKey, rows: Rows) -> Sorted<'k> {
    let mut scripts: Vec<HandedIn<'k>> = Vec::new();
    let mut students = Students::default();
    let mut set_aside = rows.set_aside;
    let mut unfilled = 0;
    for row in rows.rows {
        let student = row.student().trim();
        if student.is_empty() && !row.says_something() {
            unfilled += 1;
            continue;
        }
        match look_up(key, student, &row) {
            Ok((paper, question, part, blank)) => {
                let own = students.scripts(paper.student.as_deref().unwrap_or(student));
                let handed = HandedRow { part, blank, row };
                match own.iter().find(|(place, _)| *place == question) {
                    Some((_, script)) => scripts[*script].rows.push(handed),
                    None => {
                        own.push((question, scripts.len()));
                        scripts.push(HandedIn { paper, question: &paper.questions[question], rows: vec![handed] });
                    }
                }
            }
            Err(reason) => set_aside.push(SetAside { row, reason }),
        }
    }
    scripts.iter_mut().for_each(|script| script.drop_earlier(&mut set_aside));
    set_aside.sort_by_key(|aside| aside.row.line);
    Sorted { scripts, set_aside, unfilled }
}

/// The scripts of each student.
#[derive(Default)]
struct Students {
    places: HashMap<String, usize>,
    /// The places of the questions on the student's paper, each with that of the script among all.
    scripts: Vec<Vec<(usize, usize)>>,
    /// The student who came last, for most rows follow one of the same student.
    last: Option<(String, usize)>,
}

impl Students {
    fn scripts(&mut self, student: &str) -> &mut Vec<(usize, usize)> {
        let place = match &self.last {
            Some((last, place)) if last == student => *place,
            _ => {
                let place = *self.places.entry(student.to_owned()).or_insert(self.scripts.len());
                self.scripts.resize_with(self.scripts.len().max(place + 1), Vec::new);
                self.last = Some((student.to_owned(), place));
                place
            }
        };
        &mut self.scripts[place]
    }
}

type Place<'k> = (&'k KeyedPaper, usize, usize, Option<usize>);

fn look_up<'k>(key: &'k AnswerKey, student: &str, row: &Row) -> Result<Place<'k>, String> {
    let paper = lookup::paper(key, student)?;
    let found = lookup::question_and_part(paper, row.question(), row.part());
    let (place, part) = found.map_err(|(message, _)| message)?;
    let question = &paper.questions[place];
    let named = Some(row.blank().trim()).filter(|name| !name.is_empty());
    let blank = named.map(|name| lookup::blank(&question.parts[part], name)).transpose()?;
    Ok((paper, place, part, blank))
}

impl HandedIn<'_> {
    /// The student, as the key of a class says; whatever was typed where all have the same paper.
    pub fn student(&self) -> &str {
        let typed = || self.rows.first().map_or("", |handed| handed.row.student().trim());
        self.paper.student.as_deref().unwrap_or_else(typed)
    }

    /// Did the student write anything, an answer or a line of working?
    pub fn says_something(&self) -> bool {
        self.rows.iter().any(|handed| handed.row.says_something())
    }

    /// Where the same is answered twice, drops the earlier answers.
    fn drop_earlier(&mut self, set_aside: &mut Vec<SetAside>) {
        let answers = |handed: &HandedRow| !handed.row.answer().trim().is_empty();
        // The line of the answer that counts, where there are several.
        let mut last: Vec<((usize, Option<usize>), usize)> = Vec::new();
        let mut is_twice = false;
        if self.rows.len() > 1 {
            for handed in self.rows.iter().filter(|handed| answers(handed)) {
                let place = (handed.part, handed.blank);
                match last.iter_mut().find(|(known, _)| *known == place) {
                    Some((_, line)) => (*line, is_twice) = (handed.row.line, true),
                    None => last.push((place, handed.row.line)),
                }
            }
        }
        if !is_twice {
            return;
        }
        let counts = |handed: &HandedRow| last.iter().find(|(known, _)| *known == (handed.part, handed.blank));
        let earlier = self.rows.extract_if(.., |handed| {
            answers(handed) && counts(handed).is_some_and(|(_, line)| handed.row.line != *line)
        });
        set_aside.extend(earlier.map(|HandedRow { part, blank, row }| {
            let line = last.iter().find(|(known, _)| *known == (part, blank)).map_or(0, |(_, line)| *line);
            SetAside { row, reason: format!("line {line} answers the same, and the last answer counts") }
        }));
    }

    /// The script, and the parts that were handed in, in the order of the key.
    pub fn script(&self) -> (Script, Vec<HandedPart>) {
        let mut parts: Vec<PartScript> = Vec::new();
        let mut handed: Vec<HandedPart> = Vec::new();
        for HandedRow { part: place, blank, row } in &self.rows {
            let part = &self.question.parts[*place];
            let at = handed.iter().position(|handed| handed.place == *place).unwrap_or_else(|| {
                handed.push(HandedPart { place: *place, named: false });
                parts.push(PartScript { label: part.label.clone(), ..PartScript::default() });
                parts.len() - 1
            });
            handed[at].named |= blank.is_some();
            if !row.answer().trim().is_empty() {
                let name = blank.map(|blank| part.blanks[blank].name.clone());
                parts[at].answers.push((name, row.answer().to_owned()));
            }
            // Working that stands beside each blank of a part is the working of the part, once.
            let working: Vec<String> = row.working().map(str::to_owned).collect();
            if !working.is_empty() && !contains(&parts[at].working, &working) {
                parts[at].working.extend(working);
            }
        }
        handed.sort_by_key(|handed| handed.place);
        (Script { student: self.student().to_owned(), question: self.question.number, parts }, handed)
    }
}

fn contains(working: &[String], lines: &[String]) -> bool {
    working.windows(lines.len()).any(|window| window == lines)
}
