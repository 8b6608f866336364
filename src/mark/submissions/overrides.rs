//! A person's word on single marks, from a table.

use std::collections::BTreeMap;

use super::lookup;
use crate::diagnostic::{Diagnostic, Severity, Source};
use crate::mark::key::AnswerKey;
use crate::table;

const COLUMNS: [&str; 6] = ["student", "question", "part", "mark", "given", "comment"];

/// A person's word on one mark of one script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    /// The line on which it stands, from 1.
    pub line: usize,
    /// The student.
    pub student: String,
    /// The number of the question on the sheet.
    pub question: usize,
    /// The place of the part in the question.
    pub part: usize,
    /// The place of the mark in the scheme of the part.
    pub mark: usize,
    /// Is the mark given?
    pub given: bool,
    /// Why; may be empty.
    pub comment: String,
}

/// Reads a table `student,question,part,mark,given,comment`.
///
/// # Errors
///
/// Every row that says something else than `1` or `0`, or speaks of what is not in the key, and a column whose name is
/// misspelt: a person's word is not to get lost.
pub fn read_overrides(source: &Source, key: &AnswerKey) -> Result<Vec<Override>, Vec<Diagnostic>> {
    let mut faults = Vec::new();
    let mut overrides = Vec::new();
    let warnings = table::read(source, &COLUMNS, &["student", "question", "mark", "given"], |record| {
        let (line, start) = (record.line, record.start);
        let read = match record.fault {
            Some(fault) => Err((fault, 0)),
            None => one(line, record.cells, key),
        };
        match read {
            Ok(found) => overrides.push(found),
            Err((message, cell)) => {
                let end = start + source.text[start..].lines().next().map_or(0, str::len);
                let label = match cell {
                    4 => "expected 1 for a mark that is given, or 0",
                    _ => "this row cannot be obeyed",
                };
                let help = "mend the row, or take it out: nothing is marked until each can be obeyed";
                faults.push(Diagnostic::new(message, source, start..end, label).with_help(help));
            }
        }
    })?;
    // A comment under a name that nobody looks at would get lost.
    faults.splice(0..0, warnings.into_iter().map(|fault| Diagnostic { severity: Severity::Error, ..fault }));
    if faults.is_empty() { Ok(overrides) } else { Err(faults) }
}

/// The words on each mark of which some give it and some do not, in the order of their lines; the last of them counts.
pub fn contradictions(words: &[Override]) -> Vec<Vec<&Override>> {
    let mut on_each: BTreeMap<_, Vec<&Override>> = BTreeMap::new();
    for word in words {
        on_each.entry((&word.student, word.question, word.part, word.mark)).or_default().push(word);
    }
    let mut contradictions: Vec<Vec<&Override>> = on_each.into_values().collect();
    contradictions.retain(|words| words.iter().any(|word| word.given != words[0].given));
    contradictions.sort_by_key(|words| words[0].line);
    contradictions
}

/// A row; what is wrong with it and in which cell.
fn one(line: usize, cells: [&str; 6], key: &AnswerKey) -> Result<Override, (String, usize)> {
    let [student, question, part, mark, given, comment] = cells;
    let student = table::meant(student.trim());
    let at = |cell: usize| move |message: String| (message, cell);
    let paper = lookup::paper(key, student).map_err(at(0))?;
    let found = lookup::question_and_part(paper, question, part);
    let (place, part) = found.map_err(|(message, cell)| (message, cell + 1))?;
    let question = &paper.questions[place];
    let mark = lookup::mark(&question.parts[part], mark).map_err(at(3))?;
    let given = match given.trim() {
        "1" => true,
        "0" => false,
        other => return Err((format!("{} is neither 1 nor 0", lookup::shown(other)), 4)),
    };
    let student = paper.student.as_deref().unwrap_or(student).to_owned();
    let comment = comment.trim().to_owned();
    Ok(Override { line, student, question: question.number, part, mark, given, comment })
}
