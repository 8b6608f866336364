//! What a formula comes to: at fixed points where letters remain, and within the width that rounding leaves open.

mod compare;
mod figures;
mod linear;
mod points;
mod spread;

pub(super) use compare::{any_within, comes_to, comes_to_angle, is_composite, is_parallel, is_vector};
pub(super) use figures::is_sum_of_figures;
pub(super) use linear::{Context, Linear, Sum, common_root, constant, constants, difference, figures, sum};
pub(super) use points::{Points, size, sizes};
pub(super) use spread::Spread;
