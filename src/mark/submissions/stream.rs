//! Submissions that no memory holds: read piece by piece, handed on a student at a time.
//!
//! The rows of a student must stand together, as a table has them that is sorted by student; then a student's rows are all
//! that is ever held. Of students whose rows have come only a number of eight bytes is kept, so that a row that comes later
//! is set aside instead of being marked as if it were alone.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use super::{Row, Rows, SetAside, is_array, json_lines, read_rows};
use crate::diagnostic::{Diagnostic, Source};

/// More rows of one student are set aside: no sheet has so many answers.
const MOST: usize = 10_000;

/// And more bytes in them: no student writes so much.
const MOST_BYTES: usize = 1 << 23;

/// A stream of rows.
#[derive(Clone, Debug)]
pub struct Stream {
    /// The names of the columns, if it is a table; else every line is JSON.
    header: Option<Source>,
    /// The rows of the student whose rows are coming.
    held: Vec<Row>,
    /// How many bytes they have.
    bytes: usize,
    /// The students whose rows have come.
    closed: HashSet<u64>,
    /// What was hardly meant in the names of the columns.
    warnings: Vec<Diagnostic>,
}

impl Stream {
    /// A stream that begins with this record: the names of the columns, or a line of JSON.
    ///
    /// # Errors
    ///
    /// What is wrong with the names of the columns; a JSON array, which is not read line by line.
    ///
    /// ```
    /// use carom::diagnostic::Source;
    /// use carom::mark::submissions::Stream;
    /// let mut stream = Stream::new(&Source::new("stdin", "student,question,answer\n")).unwrap();
    /// let rows = stream.take("Ada,1,2.78\nAda,2,60\nBen,1,3\nAda,3,4\n", 2);
    /// assert_eq!((rows.rows.len(), rows.rows[1].line), (3, 3));
    /// assert!(rows.set_aside[0].reason.contains("stand together"));
    /// ```
    pub fn new(first: &Source) -> Result<Stream, Vec<Diagnostic>> {
        if is_array(&first.text) {
            let at = first.text.find('[').unwrap_or(0);
            let label = "a stream is read line by line: expected one object a line, as `{\"student\": \"Ada\", …}`";
            let fault = Diagnostic::new("a JSON array in place of JSON lines", first, at..at + 1, label);
            return Err(vec![
                fault.with_help("mark it without `--stream`, or write each object of it on a line of its own"),
            ]);
        }
        let is_table = !first.text.trim_start().starts_with('{');
        let warnings = if is_table { read_rows(first)?.warnings } else { Vec::new() };
        let header = is_table.then(|| Source::new(first.file.clone(), format!("{}\n", first.text.trim())));
        Ok(Stream { header, held: Vec::new(), bytes: 0, closed: HashSet::new(), warnings })
    }

    /// Is it a table?
    pub fn is_table(&self) -> bool {
        self.header.is_some()
    }

    /// Columns that look like one that is known and are not.
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }

    /// The rows of a piece of whole records whose first line has this number: of every student whose rows are over.
    pub fn take(&mut self, piece: &str, line: usize) -> Rows {
        let (mut rows, before) = match &self.header {
            None => (json_lines::read(piece), 0),
            Some(header) => {
                let lines = header.text.matches('\n').count();
                let text = format!("{}{piece}", header.text);
                // The names of the columns have been found in order.
                (read_rows(&Source::new(header.file.clone(), text)).unwrap_or_default(), lines)
            }
        };
        let all = rows.rows.iter_mut().chain(rows.set_aside.iter_mut().map(|aside| &mut aside.row));
        all.for_each(|row| row.line = row.line + line - 1 - before);
        let mut whole = Rows { set_aside: rows.set_aside, ..Rows::default() };
        whole.rows.reserve_exact(self.held.len() + rows.rows.len());
        for row in rows.rows {
            self.place(row, &mut whole);
        }
        whole
    }

    /// The rows that are left at the end.
    pub fn end(&mut self) -> Rows {
        Rows { rows: std::mem::take(&mut self.held), ..Rows::default() }
    }

    fn place(&mut self, row: Row, whole: &mut Rows) {
        let student = row.student().trim();
        // Whose these are nobody knows; they belong to nothing.
        if student.is_empty() {
            whole.rows.push(row);
            return;
        }
        let is_next = self.held.first().is_none_or(|held| held.student().trim() != student);
        if is_next {
            if let Some(last) = self.held.first() {
                self.closed.insert(number(last.student().trim()));
                whole.rows.append(&mut self.held);
                self.bytes = 0;
            }
            if self.closed.contains(&number(student)) {
                let reason = "other students stand between this row and the others of this student: in a stream all rows of \
                              a student stand together; sort it by student";
                whole.set_aside.push(SetAside { row, reason: reason.to_owned() });
                return;
            }
        }
        let bytes = row.bytes();
        if self.held.len() < MOST && self.bytes + bytes <= MOST_BYTES {
            self.bytes += bytes;
            self.held.push(row);
        } else {
            let reason = format!("the student has more than {MOST} rows, or more than {MOST_BYTES} bytes in them");
            whole.set_aside.push(SetAside { row, reason });
        }
    }
}

/// A number for a student; two students have the same once in 10^19 times.
fn number(student: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    student.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_of_a_student_is_held_without_bound() {
        let columns = ["question", "part", "blank", "answer", "working"];
        let header = format!("student,{}\n", columns.join(","));
        let long = "x".repeat(1 << 20);
        for place in 0..columns.len() {
            let mut cells = [""; 5];
            cells[place] = &long;
            let row = format!("Ada,{}\n", cells.join(","));
            let mut stream = Stream::new(&Source::new("stdin", header.as_str())).unwrap();
            let mut aside = Vec::new();
            for line in 0..12 {
                aside.extend(stream.take(&row, 2 + line).set_aside);
            }
            assert_eq!((stream.end().rows.len(), aside.len()), (7, 5), "{}", columns[place]);
            assert!(aside[0].reason.contains(&MOST_BYTES.to_string()), "{}", aside[0].reason);
        }
    }

    #[test]
    fn a_column_that_nobody_looks_at_is_told_of() {
        let stream = Stream::new(&Source::new("stdin", "student,question,answer,workings\n")).unwrap();
        assert!(stream.warnings()[0].to_string().contains("nobody looks at the column `workings`"));
        assert!(Stream::new(&Source::new("stdin", "student,question,answer\n")).unwrap().warnings().is_empty());
    }
}
