//! A question examined, every variant of it: [`survey`] takes a whole bank through it on all processors.
//!
//! Of each set of numbers that a style allows it is found whether it is fit for print, and what turns it away: the
//! [`Census`](crate::generate::Census). Each variant is then looked at as a careful teacher would: its words read, its
//! answers have the form that its style promises and are told apart, every slip that students make shows. Then students
//! whose marks are known hand it in, and what the author has worked out by hand is compared.

mod again;
mod apart;
mod author;
mod coincidence;
mod coverage;
mod finding;
mod glance;
mod neighbours;
mod promise;
mod remark;
mod report;
mod scheme;
mod shows;
mod students;
mod suggested;
mod survey;
mod tally;
mod unprinted;
mod words;

pub use coverage::{Coverage, MarkCount, coverage};
pub use finding::Finding;
pub use glance::glance;
pub use neighbours::neighbours;
pub use report::{AnswerForms, Hidden, Report, StyleReport, Turned};
pub use students::{Expected, Student, students};
pub use survey::{MARKED, Step, survey, work};

/// What stands in a text, each with what is to stand in its place.
#[cfg(test)]
type Edits<'t> = &'t [(&'t str, &'t str)];

/// A shipped question after edits of its text, all of which must apply.
#[cfg(test)]
fn edited(id: &str, edits: Edits) -> crate::bank::Question {
    let (_, text) = crate::bank::shipped().find(|(shipped, _)| *shipped == id).unwrap();
    let mut text = text.to_owned();
    for (from, to) in edits {
        assert!(text.contains(from), "{id}: {from}");
        text = text.replace(from, to);
    }
    let source = crate::diagnostic::Source::new(id, text);
    crate::bank::read_question(id, &source).unwrap_or_else(|faults| panic!("{faults:?}"))
}
