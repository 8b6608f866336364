//! Submissions: what students handed in, read from a file and sorted into scripts.
//!
//! Two steps. [`read_rows`] reads a table or JSON into [`Row`]s; [`sort`] looks each of them up in the key and
//! gathers what belongs together. Nothing is dropped: what cannot be read or has no place in the key is [`SetAside`] with
//! its line and the reason, and everything else goes on.

mod empty;
mod json_array;
mod json_lines;
mod lookup;
mod overrides;
mod sort;
mod stream;

pub use empty::{empty_submissions, empty_submissions_of_class, is_filled_in};
pub use overrides::{Override, contradictions, read_overrides};
pub use sort::{HandedIn, HandedPart, HandedRow, Sorted, sort};
pub use stream::Stream;

use crate::diagnostic::{Diagnostic, Source};
use crate::table;

/// The columns of a table of submissions, and the fields of a line of JSON.
pub const COLUMNS: [&str; 6] = ["student", "question", "part", "blank", "answer", "working"];

/// A row as it was typed.
///
/// Its cells are one text: of a million rows each is one piece of memory and not six.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// The line on which it begins, from 1.
    pub line: usize,
    /// The cells, one after another.
    text: Box<str>,
    /// Where each ends in the text.
    ends: [usize; COLUMNS.len()],
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

/// Reads the rows of a table, of JSON lines if the text begins with a brace, or of a JSON array if with a bracket.
///
/// # Errors
///
/// Only what is wrong with the whole: a table without a column for the answers, say, or an array that is not closed.
///
/// ```
/// use carom::diagnostic::Source;
/// use carom::mark::submissions::read_rows;
/// let table = Source::new("submissions.csv", "student,question,answer\nAda,1,2.78\n");
/// let lines = Source::new("submissions.jsonl", r#"{"student": "Ada", "question": 1, "answer": "2.78"}"#);
/// let (table, lines) = (read_rows(&table).unwrap(), read_rows(&lines).unwrap());
/// assert_eq!((table.rows[0].line, lines.rows[0].line), (2, 1));
/// assert_eq!(table.rows[0].answer(), lines.rows[0].answer());
/// ```
pub fn read_rows(source: &Source) -> Result<Rows, Vec<Diagnostic>> {
    if source.text.trim_start().starts_with('{') {
        return Ok(json_lines::read(&source.text));
    }
    if is_array(&source.text) {
        return json_array::read(source);
    }
    let needed = ["student", "question", "answer"];
    let mut rows = Rows::default();
    // About as many as there are, where rows are short.
    rows.rows.reserve(source.text.len() / 64);
    let warnings = table::read(source, &COLUMNS, &needed, |record| {
        let mut cells = record.cells;
        cells[0] = table::meant(cells[0].trim());
        let row = Row::new(record.line, cells);
        match record.fault {
            Some(reason) => rows.set_aside.push(SetAside { row, reason }),
            None => rows.rows.push(row),
        }
    })?;
    Ok(Rows { warnings, ..rows })
}

/// Is it one JSON array? No table begins with a bracket and what may follow it there.
fn is_array(text: &str) -> bool {
    let inside = text.trim_start().strip_prefix('[');
    inside.is_some_and(|inside| inside.trim_start().is_empty() || inside.trim_start().starts_with(['{', ']', '[', '"']))
}

impl Rows {
    /// Adds a row that has been read; what stood there is set aside if it could not be.
    fn place(&mut self, row: Result<Row, String>, line: usize, text: &str) {
        match row {
            Ok(row) => self.rows.push(row),
            Err(reason) => self.set_aside.push(SetAside { row: Row::unread(line, text), reason }),
        }
    }
}

impl Row {
    /// A row of these cells, in the order of [`COLUMNS`].
    pub fn new(line: usize, cells: [&str; COLUMNS.len()]) -> Row {
        let mut text = String::with_capacity(cells.iter().map(|cell| cell.len()).sum());
        let ends = cells.map(|cell| {
            text.push_str(cell);
            text.len()
        });
        Row { line, text: text.into_boxed_str(), ends }
    }

    /// A row of which only what stands in it is known.
    pub fn unread(line: usize, text: &str) -> Row {
        Row::new(line, ["", "", "", "", text, ""])
    }

    /// The student.
    pub fn student(&self) -> &str {
        self.cell(0)
    }

    /// The number of the question on the sheet, or its id.
    pub fn question(&self) -> &str {
        self.cell(1)
    }

    /// The label of the part; empty if the question has none.
    pub fn part(&self) -> &str {
        self.cell(2)
    }

    /// The name of the blank; empty if the answer says all that the part asks.
    pub fn blank(&self) -> &str {
        self.cell(3)
    }

    /// The answer.
    pub fn answer(&self) -> &str {
        self.cell(4)
    }

    /// The lines of working: those of its cell that say something.
    pub fn working(&self) -> impl Iterator<Item = &str> {
        self.cell(5).split(['\n', '\r']).map(str::trim).filter(|line| !line.is_empty())
    }

    fn cell(&self, place: usize) -> &str {
        let start = place.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.text[start..self.ends[place]]
    }

    /// How many bytes its cells have.
    fn bytes(&self) -> usize {
        self.text.len()
    }

    /// Does it hand in anything?
    fn says_something(&self) -> bool {
        !self.answer().trim().is_empty() || self.working().next().is_some()
    }
}
