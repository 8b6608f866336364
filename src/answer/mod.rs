//! Kinds of answer, and the rules by which a student's answer is accepted.

mod accept;
mod kind;

pub use accept::{Accept, UnreadableRule};
pub use kind::{Kind, UnknownKind};
