//! Mechanics of an oblique impact of two smooth spheres: scenes, laws, derivations, validity.

mod quantity;

pub use quantity::{Axis, Moment, Quantity, Sphere, UnknownQuantity};
