//! Reading what a student typed on one line.

mod said;

pub use said::{Form, Label, Notation, Reading, ReferenceLine, Said, SaidUnit, Statement, Unreadable, Vocabulary};

/// The longest answer that is read, in bytes; a longer one goes to a person.
pub const LONGEST: usize = 2000;
