//! Variants of a question: seeds, the set of all valid numbers, and what makes numbers fit for print.

mod rounding;
mod shuffle;

pub use rounding::{degrees_round_safely, rounds_safely};
pub use shuffle::{Shuffle, below};
