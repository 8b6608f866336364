//! Variants of a question: seeds, the set of all valid numbers, and what makes numbers fit for print.

mod census;
mod deal;
mod form;
mod rounding;
mod shuffle;
mod variant;

pub use census::{Census, MOST_SETS, enumerate, out_of};
pub use deal::{Deal, End, PATIENCE};
pub use form::Form;
pub use rounding::{degrees_round_safely, rounds_safely};
pub use shuffle::{Shuffle, below};
pub use variant::{Further, Unfit, Variant, answer_rounds_safely, examine, examine_further, reference, with_numbers};
