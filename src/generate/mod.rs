//! Variants of a question: seeds, the set of all valid numbers, and what makes numbers fit for print.

mod census;
mod deal;
mod form;
mod numbers;
mod processors;
mod rounding;
mod shuffle;
mod sieve;
mod variant;

pub use census::{Census, MOST_SETS, enumerate, out_of, portions};
pub use deal::{Deal, End, PATIENCE};
pub use form::Form;
pub use numbers::{Further, Numbers, examine};
pub(crate) use processors::on_all_processors;
pub use rounding::{degrees_round_safely, rounds_safely};
pub use shuffle::{Shuffle, below};
pub use sieve::Sieve;
pub use variant::{Unfit, Variant, answer_rounds_safely, reference, with_numbers};
