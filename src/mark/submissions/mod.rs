//! Submissions: what students handed in, read from a file and sorted into scripts.
//!
//! Two steps. [`read_rows`] reads a table or JSON lines into [`Row`]s; [`sort`] looks each of them up in the key and
//! gathers what belongs together. Nothing is dropped: what cannot be read or has no place in the key is [`SetAside`] with
//! its line and the reason, and everything else goes on.

mod empty;
mod json_lines;
mod lookup;
mod overrides;
mod sort;
mod stream;

pub use empty::{empty_submissions, empty_submissions_of_class, is_filled_in};
pub use overrides::{Override, read_overrides};
pub use sort::{HandedIn, HandedPart, Sorted, sort};
pub use stream::Stream;

use crate::diagnostic::{Diagnostic, Source};
use crate::table;

/// The columns of a table of submissions, and the fields of a line of JSON.
pub const COLUMNS: [&str; 6] = ["student", "question", "part", "blank", "answer", "working"];

/// A row as it was typed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// The line on which it begins, from 1.
    pub line: usize,
    /// The student.
    pub student: String,
    /// The number of the question on the sheet, or its id.
    pub question: String,
    /// The label of the part; empty if the question has none.
    pub part: String,
    /// The name of the blank; empty if the answer says all that the part asks.
    pub blank: String,
    /// The answer.
    pub answer: String,
    /// The lines of working.
    pub working: Vec<String>,
}

/// A row that is not marked, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetAside {
    /// The row. Of a line that is no JSON the whole stands as its answer.
    pub row: Row,
    /// What is wrong with it, and what there is.
    pub reason: String,
}

/// The rows of a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rows {
    /// Those that can be read.
    pub rows: Vec<Row>,
    /// Those that cannot.
    pub set_aside: Vec<SetAside>,
    /// What was hardly meant.
    pub warnings: Vec<Diagnostic>,
}

/// Reads the rows of a table, or of JSON lines if the text begins with a brace.
///
/// # Errors
///
/// Only what is wrong with the whole: a table without a column for the answers, say.
///
/// ```
/// use carom::diagnostic::Source;
/// use carom::mark::submissions::read_rows;
/// let table = Source::new("submissions.csv", "student,question,answer\nAda,1,2.78\n");
/// let lines = Source::new("submissions.jsonl", r#"{"student": "Ada", "question": 1, "answer": "2.78"}"#);
/// let (table, lines) = (read_rows(&table).unwrap(), read_rows(&lines).unwrap());
/// assert_eq!((table.rows[0].line, lines.rows[0].line), (2, 1));
/// assert_eq!(table.rows[0].answer, lines.rows[0].answer);
/// ```
pub fn read_rows(source: &Source) -> Result<Rows, Vec<Diagnostic>> {
    if source.text.trim_start().starts_with('{') {
        return Ok(json_lines::read(&source.text));
    }
    let needed = ["student", "question", "answer"];
    let table = table::read(source, &COLUMNS, &needed)?;
    let mut rows = Rows { warnings: table.warnings, ..Rows::default() };
    rows.rows.reserve_exact(table.records.len());
    for record in table.records {
        let [student, question, part, blank, answer, working] = record.cells;
        let student = match table::meant(student.trim()) {
            meant if meant.len() < student.len() => meant.to_owned(),
            _ => student,
        };
        let row = Row { line: record.line, student, question, part, blank, answer, working: lines_of(&working) };
        match record.fault {
            Some(reason) => rows.set_aside.push(SetAside { row, reason }),
            None => rows.rows.push(row),
        }
    }
    Ok(rows)
}

impl Row {
    /// How many bytes its cells have.
    fn bytes(&self) -> usize {
        let cells = [&self.student, &self.question, &self.part, &self.blank, &self.answer];
        cells.into_iter().chain(&self.working).map(String::len).sum()
    }

    /// Does it hand in anything?
    fn says_something(&self) -> bool {
        !self.answer.trim().is_empty() || !self.working.is_empty()
    }
}

/// The lines of a cell that say something.
fn lines_of(cell: &str) -> Vec<String> {
    cell.split(['\n', '\r']).map(str::trim).filter(|line| !line.is_empty()).map(str::to_owned).collect()
}
