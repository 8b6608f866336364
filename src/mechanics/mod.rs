//! Mechanics of an oblique impact of two smooth spheres: scenes, laws, derivations, validity.

mod backwards;
mod derivation;
mod law;
mod pose;
mod quantity;
mod refusal;
mod scene;
mod scene_text;
mod validity;
mod working;

pub use backwards::{Found, backwards};
pub use derivation::{DeadEnd, Derivation};
pub use law::{Datum, Known, Law, Rule, Slip};
pub use pose::pose;
pub use quantity::{Axis, Moment, Quantity, Sphere, UnknownQuantity};
pub use refusal::{Because, Refusal};
pub use scene::{Condition, Contact, Given, Scene, SceneFault, Velocity};
pub use scene_text::{Pair, PolarText, SceneText, Sense, VelocityText};
pub use validity::check;
pub use working::{Line, Show};
