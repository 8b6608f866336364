//! The marker: what students hand in, read and judged as an examiner does.
//!
//! An answer goes two steps. [`reading`] turns what was typed into every [`Reading`](reading::Reading) that a person
//! might see in it, the likeliest first, and never guesses in silence: what cannot be read is
//! [`Unreadable`](reading::Unreadable) and goes to a person. [`judging`] compares the readings with the model answer.

mod award;
mod enclosure;
pub mod judging;
mod key;
mod marking;
mod profile;
mod profile_file;
pub mod reading;
pub mod report;
mod script;
pub mod slips;
pub mod submissions;
mod working;

pub use award::{Award, Cause, Evidence, Examiner, MarkedAnswer, MarkedLine, MarkedPart, Place};
#[cfg(test)]
pub(crate) use key::shipped_key;
pub use key::{AnswerKey, KeyFault, KeyedBlank, KeyedMark, KeyedPaper, KeyedPart, KeyedQuestion};
pub use marking::{Word, from_own_values, mark, mark_each, overrule};
pub use profile::{Charge, Profile};
pub use script::{PartScript, Script};
