//! The file of submissions that comes with a sheet, to be filled in.

use std::collections::HashSet;

use super::{COLUMNS, read_rows};
use crate::diagnostic::Source;
use crate::paper::{KeyPaper, KeyQuestion};
use crate::table::{decode, write};

/// A header and a row for each blank, the student left empty.
pub fn empty_submissions(questions: &[KeyQuestion]) -> String {
    write(COLUMNS, rows("", questions))
}

/// A header and a row for each blank of each sheet of a class, with the student.
pub fn empty_submissions_of_class(papers: &[KeyPaper]) -> String {
    write(COLUMNS, papers.iter().flat_map(|paper| rows(&paper.student, &paper.questions)))
}

fn rows<'k>(student: &'k str, questions: &'k [KeyQuestion]) -> impl Iterator<Item = [String; 6]> + 'k {
    let rows = questions.iter().flat_map(|question| {
        let parts = question.parts.iter();
        parts.flat_map(move |part| part.blanks.iter().map(move |blank| (question.number, &part.label, &blank.name)))
    });
    rows.map(move |(number, label, blank)| [student, &number.to_string(), label, blank, "", ""].map(str::to_owned))
}

/// Has anybody written into such a file, other than the names of this class? One that cannot be read may hold anything.
///
/// ```
/// use carom::mark::submissions::is_filled_in;
/// let table = b"student,question,part,blank,answer,working\nAda,1,,speed of A,,\n";
/// assert!(is_filled_in(table, &[]));
/// assert!(!is_filled_in(table, &["Ada"]));
/// assert!(is_filled_in(b"student,question,part,blank,answer,working\nAda,1,,speed of A,2.78,\n", &["Ada"]));
/// ```
pub fn is_filled_in(bytes: &[u8], class: &[&str]) -> bool {
    let class: HashSet<&str> = class.iter().copied().collect();
    let rows = decode(bytes).ok().and_then(|text| read_rows(&Source::new("", text)).ok());
    let is_ours = |student: &str| student.is_empty() || class.contains(student);
    let is_filled = |row: &super::Row| !is_ours(row.student().trim()) || row.says_something();
    rows.is_none_or(|rows| !rows.set_aside.is_empty() || rows.rows.iter().any(is_filled))
}
