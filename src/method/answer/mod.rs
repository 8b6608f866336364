//! Methods on the path of printed answers, one file each: exact, or enclosed by a proved bound.

pub(super) mod certified;
pub(super) mod fractions;
pub(super) mod integers;
pub(super) mod letters;
pub(super) mod linear_forms;
pub(super) mod matrix;
pub(super) mod polynomials;
pub(super) mod surd_field;
pub(super) mod surd_integers;
