//! What somebody means who writes words where a formula, a law or a quantity is expected.

mod formula;
mod law;
mod name;
mod quantity;

pub use formula::{formula_meant, formulas_meant, is_sentence};
pub use name::name_meant;
