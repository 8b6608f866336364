//! Numbers: fractions, surds, letters, certified intervals and rounding; what a law can be evaluated in.

mod fraction;

pub use fraction::{Fraction, NotAFraction};
