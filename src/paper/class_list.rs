//! The list of a class: who gets a sheet, read from a table.

use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Source};
use crate::expr::print::words_unicode;
use crate::table;

/// The columns of the table.
const COLUMNS: [&str; 2] = ["student", "name"];

/// A student or a name with more characters than this is none: the quote that ends it is missing, or all is in one cell.
pub const LONGEST_NAME: usize = 20_000;

/// A class, in its own order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ClassList {
    /// The students; at least one, each different from every other.
    pub students: Vec<Student>,
    /// Columns whose names were probably meant for others.
    pub warnings: Vec<Diagnostic>,
}

/// A student of a class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Student {
    /// What no other student of the class is called: a number of the school's, or a name.
    pub id: String,
    /// The name; empty if the list has no column for it.
    pub name: String,
}

impl Student {
    /// As it is printed: the name with the id, or whichever there is.
    pub fn shown(&self) -> String {
        if self.name.is_empty() { self.id.clone() } else { format!("{} ({})", self.name, self.id) }
    }
}

impl ClassList {
    /// Reads a table with a column `student`, and perhaps one `name`. A list of names alone has the names for students.
    ///
    /// # Errors
    ///
    /// Every row that names no student, one of more than [`LONGEST_NAME`] characters, or one that is in the list already:
    /// nobody is to be left without a sheet.
    ///
    /// ```
    /// use carom::diagnostic::Source;
    /// use carom::paper::ClassList;
    /// let list = ClassList::read(&Source::new("class.csv", "student,name\n1034,Ada Lovelace\n1035,Ben\n")).unwrap();
    /// assert_eq!(list.students[0].shown(), "Ada Lovelace (1034)");
    /// ```
    pub fn read(source: &Source) -> Result<ClassList, Vec<Diagnostic>> {
        let header = source.text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default().to_lowercase();
        let named = |column: &str| header.split([',', ';', '\t']).any(|name| name.trim().trim_matches('"') == column);
        let needed = if named("name") && !named("student") { ["name"] } else { ["student"] };
        let (mut faults, mut too_long) = (Vec::new(), Vec::new());
        let is_too_long = |length: &usize| *length > LONGEST_NAME;
        let mut lines: HashMap<String, usize> = HashMap::new();
        let mut students = Vec::new();
        let warnings = table::read(source, &COLUMNS, &needed, |record| {
            let end = record.start + source.text[record.start..].lines().next().map_or(0, str::len);
            let mut fault = |message: String, label: &str| {
                let help = "mend the row, or take it out: each student has one";
                faults.push(Diagnostic::new(message, source, record.start..end, label).with_help(help));
            };
            let [student, name] = record.cells.map(|cell| table::visible(table::meant(cell.trim())));
            let id = if student.is_empty() && needed == ["name"] { name.clone() } else { student };
            if let Some(reason) = record.fault {
                fault(reason, "this row cannot be read");
            } else if let Some(length) = [&id, &name].map(|cell| cell.chars().count()).into_iter().find(is_too_long) {
                // What is that long is not shown: it would fill the terminal.
                let begins = short(if is_too_long(&id.chars().count()) { &id } else { &name });
                let message = format!("line {}: {begins} has {length} characters", record.line);
                let place = Source::new(source.file.clone(), "");
                let help = format!("a student or a name has at most {LONGEST_NAME}: look where its quotes end");
                too_long.push(Diagnostic::new(message, &place, 0..0, "").with_help(help));
            } else if id.is_empty() {
                fault("a row without a student".to_owned(), "expected a student in the column `student`");
            } else if let Some(line) = lines.insert(id.clone(), record.line) {
                let shown = short(&id);
                fault(format!("{shown} is in the list twice"), &format!("line {line} has the same student"));
            } else {
                let name = if name == id { String::new() } else { name };
                students.push(Student { id, name });
            }
        })?;
        faults.extend(too_long);
        if faults.is_empty() && students.is_empty() {
            let end = source.text.len().min(1);
            let label = "below the names of the columns a line for each student is expected";
            let fault = Diagnostic::new("nobody is in this class", source, 0..end, label);
            faults.push(fault.with_help("write a number or a name for each, and save it"));
        }
        if faults.is_empty() { Ok(ClassList { students, warnings }) } else { Err(faults) }
    }
}

/// In backticks, harmless, and not longer than one reads.
fn short(id: &str) -> String {
    const SHOWN: usize = 60;
    let shown = words_unicode(id);
    match shown.char_indices().nth(SHOWN) {
        Some((cut, _)) => format!("`{}…`", &shown[..cut]),
        None => format!("`{shown}`"),
    }
}
