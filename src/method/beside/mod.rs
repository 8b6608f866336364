//! Methods beside the answer path: right in their own numbers, and here to be compared with.

mod along;
pub(super) mod centre_of_mass;
pub(super) mod columns;
pub(super) mod cramer;
pub(super) mod double_double;
pub(super) mod elimination;
pub(super) mod float_intervals;
pub(super) mod from_integers;
pub(super) mod fused;
pub(super) mod interval;
pub(super) mod ratio;
pub(super) mod reduced_mass;
pub(super) mod single;
pub(super) mod textbook;
pub(super) mod two_equations;
