//! Working looked through: what each line is, and which marks of the scheme it earns.
//!
//! Lines are read as answers are, in the question's letters and those that students give to what they look for. Then a
//! line is compared by what its formulas come to, not by how they look: at fixed points where letters remain, and within
//! the width that rounded figures leave open.

mod examine;
mod laws;
mod line;
mod linear;
mod pair;
mod points;
mod prepared;
mod spread;

pub(super) use examine::{Examined, Theirs, examine};
pub(super) use prepared::Prepared;
