//! Numbers: fractions, surds, letters, certified intervals and rounding; what a law can be evaluated in.

mod fraction;
mod interval;
mod inverse_trigonometry;
mod rounding;
mod trigonometry;

pub use fraction::{Fraction, NotAFraction};
pub use interval::Interval;
pub use rounding::{Decimal, Places, Step, Uncertain, clear_of_tie, round, round_certified};
