//! Working looked through: what each line is, and which marks of the scheme it earns.
//!
//! Lines are read as answers are, in the question's letters and those that students give to what they look for. Then a
//! line is compared by what its formulas come to, not by how they look: at fixed points where letters remain, and within
//! the width that rounded figures leave open.

mod denied;
mod elsewhere;
mod equations;
mod evidence;
mod examine;
mod going_on;
mod impacts;
mod in_answers;
mod laws;
mod letters;
mod lines;
mod names;
mod numbers;
mod prepared;
mod scaled;
mod theirs;

pub(super) use denied::is_bare;
pub(super) use elsewhere::Elsewhere;
pub(super) use equations::Misread;
pub(super) use examine::{Examined, has_these_sizes};
pub(super) use impacts::examine;
pub(super) use lines::{MOST_LINES, goes_on, typed as typed_lines};
pub(super) use prepared::Prepared;
pub(super) use theirs::Theirs;
