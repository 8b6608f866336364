//! Variants of a question: seeds, the set of all valid numbers, and what makes numbers fit for print.

mod census;
mod deal;
mod rounding;
mod shuffle;
mod variant;

pub use census::{Census, enumerate};
pub use deal::{Deal, End, PATIENCE};
pub use rounding::{degrees_round_safely, rounds_safely};
pub use shuffle::{Shuffle, below};
pub use variant::{Unfit, Variant, examine, reference};
