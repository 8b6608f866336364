//! Lines as students write them: what stands in one, and what is said around it.

mod crossed_out;
mod doubtful;
mod line;
mod products;
mod remarks;
mod said;

pub(super) use crossed_out::set_aside_replaced;
pub(in crate::mark) use line::MOST_LINES;
pub(super) use line::{Line, Member, OWN, ReadLine, read, typed};
pub(super) use products::FUNCTIONS;
pub(super) use said::{Stated, clauses, is_called_otherwise, says_across, says_along, says_into_wall};
