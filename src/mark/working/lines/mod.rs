//! Lines as students write them: what stands in one, and what is said around it.

mod all_over;
mod candidates;
mod crossed_out;
mod decimal_commas;
mod doubtful;
mod explained;
mod labels;
mod line;
mod products;
mod remarks;
mod said;
mod sentence;

pub(super) use crossed_out::set_aside_replaced;
pub(super) use explained::explains;
pub(super) use line::{Line, Member, OWN, ReadLine, read};
pub(in crate::mark) use line::{MOST_LINES, goes_on, typed};
pub(super) use products::FUNCTIONS;
pub(super) use said::{
    Stated, clauses, clauses_by_words, is_called_otherwise, says_across, says_along, says_into_wall,
};
