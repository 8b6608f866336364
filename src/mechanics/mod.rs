//! Mechanics of an oblique impact of two smooth spheres: scenes, laws, derivations, validity.

mod quantity;
mod scene_text;

pub use quantity::{Axis, Moment, Quantity, Sphere, UnknownQuantity};
pub use scene_text::{Pair, PolarText, SceneText, Sense, VelocityText};
