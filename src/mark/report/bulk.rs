//! Marks in bulk: scripts marked one after another, each at once in the form in which it is written.
//!
//! Of thousands of students many write the same. Marks depend on the question, on what was handed in and on the profile, and
//! on nothing else; so what was said of a script is said again of the next that is equal to it, under the other name.

use std::collections::HashMap;

use serde_json::json;

use super::json_lines::lines_of;
use super::rows::cells_of;
use super::{MARKS, marked};
use crate::mark::marking::Memory;
use crate::mark::profile::Profile;
use crate::mark::submissions::{HandedIn, HandedRow, SetAside, Sorted};
use crate::table::{append, one_line, push_cell};

/// What the verdict of a row is that was not marked.
const NOT_MARKED: &str = "not-marked";

/// The most bytes of what is remembered. When there are more everything is forgotten.
const MOST: usize = 1 << 23;

/// The longest script that is remembered, in bytes: nobody writes a long one twice.
const LONGEST: usize = 1 << 9;

/// One who marks script after script, and remembers what was said of those before.
pub struct Bulk<'p> {
    profile: &'p Profile,
    as_table: bool,
    /// For each script what follows the name of the student in each of its rows.
    remembered: HashMap<Box<[u8]>, Box<[Box<str>]>>,
    answers: Memory,
    bytes: usize,
    /// The script that is looked for.
    sought: Vec<u8>,
    /// The student who came last, and the name as it is written: scripts of a student mostly follow each other.
    last: String,
    name: String,
}

impl<'p> Bulk<'p> {
    /// Marks as rows of a table without its header, or as JSON lines.
    pub fn new(profile: &'p Profile, as_table: bool) -> Bulk<'p> {
        Bulk {
            profile,
            as_table,
            remembered: HashMap::new(),
            answers: Memory::default(),
            bytes: 0,
            sought: Vec::new(),
            last: String::new(),
            name: String::new(),
        }
    }

    /// The marks of scripts; then what was set aside, each with its line and the reason.
    pub fn marks(&mut self, sorted: &Sorted) -> String {
        let mut text = String::new();
        sorted.scripts.iter().for_each(|script| self.one(script, &mut text));
        match self.as_table {
            true => text.push_str(&append(sorted.set_aside.iter().map(row_aside))),
            false => sorted.set_aside.iter().for_each(|aside| text.push_str(&line_aside(aside))),
        }
        text
    }

    fn one(&mut self, script: &HandedIn, text: &mut String) {
        let student = script.student();
        if self.name.is_empty() || self.last != student {
            student.clone_into(&mut self.last);
            self.name.clear();
            match self.as_table {
                true => push_cell(&mut self.name, &one_line(student)),
                // A string always makes JSON.
                false => self.name = serde_json::to_string(student).unwrap_or_default(),
            }
        }
        let begins = if self.as_table { "" } else { JSON_BEGINS };
        let mut write = |rests: &[Box<str>]| {
            for rest in rests {
                text.push_str(begins);
                text.push_str(&self.name);
                text.push_str(rest);
            }
        };
        identify(script, &mut self.sought);
        if let Some(rests) = self.remembered.get(&*self.sought) {
            return write(rests);
        }
        let rests = rests(script, &self.name, self.profile, self.as_table, &mut self.answers);
        write(&rests);
        if self.sought.len() <= LONGEST {
            let bytes = self.sought.len() + rests.iter().map(|rest| rest.len()).sum::<usize>();
            self.bytes += bytes;
            if self.bytes > MOST {
                self.remembered.clear();
                self.bytes = bytes;
            }
            self.remembered.insert(self.sought.as_slice().into(), rests);
        }
    }
}

/// What follows the name in each row or line of a script.
fn rests(script: &HandedIn, name: &str, profile: &Profile, as_table: bool, answers: &mut Memory) -> Box<[Box<str>]> {
    let script = marked(script, profile, answers);
    if as_table {
        let rest = |row: [String; MARKS.len()]| {
            let mut rest = String::new();
            for cell in &row[1..] {
                rest.push(',');
                push_cell(&mut rest, cell);
            }
            rest.push('\n');
            rest.into_boxed_str()
        };
        return script.rows().into_iter().map(cells_of).map(rest).collect();
    }
    let begins = JSON_BEGINS.len() + name.len();
    lines_of(&script).split_inclusive('\n').filter_map(|line| line.get(begins..)).map(Box::from).collect()
}

/// What stands before the name in a line of JSON.
const JSON_BEGINS: &str = "{\"student\":";

/// Everything on which the marks of a script depend, in bytes that only an equal script has.
fn identify(handed: &HandedIn, bytes: &mut Vec<u8>) {
    bytes.clear();
    let number = |bytes: &mut Vec<u8>, number: usize| bytes.extend(number.to_le_bytes());
    // While it is marked by, a question stays where it is.
    number(bytes, std::ptr::from_ref(handed.question).addr());
    for HandedRow { part, blank, row } in &handed.rows {
        number(bytes, *part);
        number(bytes, blank.unwrap_or(usize::MAX));
        for word in std::iter::once(row.answer()).chain(row.working()) {
            number(bytes, word.len());
            bytes.extend(word.as_bytes());
        }
        // No word is so long, so that a row ends here.
        number(bytes, usize::MAX);
    }
}

fn row_aside(aside: &SetAside) -> [String; MARKS.len()] {
    let row = &aside.row;
    let [student, question, part, blank] = [row.student(), row.question(), row.part(), row.blank()].map(str::to_owned);
    let nought = || "0".to_owned();
    let reason = format!("line {}: {}", row.line, aside.reason);
    [
        student,
        question,
        part,
        blank,
        NOT_MARKED.to_owned(),
        nought(),
        nought(),
        String::new(),
        NOT_MARKED.to_owned(),
        reason,
    ]
}

fn line_aside(aside: &SetAside) -> String {
    let row = &aside.row;
    let line = json!({
        "student": row.student(), "question": row.question(), "part": row.part(), "verdict": NOT_MARKED,
        "line": row.line, "reason": aside.reason, "answer": row.answer(), "working": row.working().collect::<Vec<_>>(),
    });
    format!("{line}\n")
}
