//! Question banks: TOML files that a teacher writes, read into questions that have been checked.
//!
//! [`read_question`] reports every fault of a file at once, each with its line, what was expected and
//! one thing to try. What comes out, a [`Question`], holds no unread text: its words are formulas and
//! pieces, its parameters have finite domains, its marks know on which others they depend.

mod check;
mod contents;
mod document;
mod domain;
mod earned_for;
mod file;
mod folder;
mod givens;
mod literal;
mod posed;
mod question;
mod requirement;
mod scene_file;
mod scene_names;
mod schema;
mod shipped;
mod syntax;

pub use check::read_question;
pub use contents::{Contents, Heading};
pub(crate) use document::{Faults, Keys, kind, parse_even_empty};
pub use document::{key_span, row_span};
pub use domain::Domain;
pub use earned_for::EarnedFor;
pub use folder::{Bank, read_source};
pub(crate) use givens::names_in_degrees;
pub use givens::{GivenNames, Givens};
pub use posed::{Opened, Posed, Unposed};
pub use question::{Answer, AuthorsTest, Code, Find, Mark, Part, Question, Style, StyleName};
pub use requirement::{Measure, Requirement};
pub use scene_file::read_scene;
pub use scene_names::scene_names;
pub use schema::question_schema;
pub use shipped::shipped;
