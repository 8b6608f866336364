//! Variants of a question: seeds, the set of all valid numbers, and what makes numbers fit for print.

mod shuffle;

pub use shuffle::{Shuffle, below};
