//! The file of submissions that comes with a sheet, to be filled in.

use super::{COLUMNS, decode, read_rows};
use crate::diagnostic::Source;
use crate::mark::report::cells::table;
use crate::paper::KeyQuestion;

/// A header and a row for each blank, the student left empty.
pub fn empty_submissions(questions: &[KeyQuestion]) -> String {
    let rows = questions.iter().flat_map(|question| {
        let parts = question.parts.iter();
        parts.flat_map(move |part| part.blanks.iter().map(move |blank| (question.number, &part.label, &blank.name)))
    });
    let rows = rows.map(|(number, label, blank)| ["", &number.to_string(), label, blank, "", ""].map(str::to_owned));
    table(COLUMNS, rows)
}

/// Has anybody written into such a file? One that cannot be read may hold anything.
///
/// ```
/// use carom::mark::submissions::is_filled_in;
/// assert!(!is_filled_in(b"student,question,part,blank,answer,working\n,1,,speed of A,,\n"));
/// assert!(is_filled_in(b"student,question,part,blank,answer,working\nAda,1,,speed of A,,\n"));
/// ```
pub fn is_filled_in(bytes: &[u8]) -> bool {
    let rows = decode(bytes).ok().and_then(|text| read_rows(&Source::new("", text)).ok());
    let is_filled = |row: &super::Row| !row.student.trim().is_empty() || row.says_something();
    rows.is_none_or(|rows| !rows.set_aside.is_empty() || rows.rows.iter().any(is_filled))
}
