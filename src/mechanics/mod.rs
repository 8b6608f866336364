//! Mechanics of an impact: scenes, laws, derivations, validity.

mod again;
mod backwards;
mod condition;
mod conditions_in_words;
mod derivation;
mod formula;
mod law;
mod line;
mod pose;
mod quantity;
mod range;
mod refusal;
mod scene;
mod scene_reader;
mod scene_text;
mod seen;
mod setting;
mod unknowns;
mod validity;
mod working;

pub use again::{Carried, Steps, Trace};
pub use backwards::{Found, backwards};
pub use derivation::{DeadEnd, Derivation, Road};
pub use law::{ALONG, Datum, Known, Law, Rule, Slip};
pub use line::Line;
pub use pose::pose;
pub use quantity::{Axis, Moment, Quantity, Sphere, UnknownQuantity};
pub use range::Values;
pub use refusal::{Because, Refusal};
pub use scene::{Condition, Contact, Given, Scene, Velocity};
pub use scene_reader::SceneFault;
pub use scene_text::{Pair, PolarText, SceneText, Sense, VelocityText};
pub use seen::{Seen, Shape};
pub use setting::Setting;
pub use validity::{check, check_with};
pub use working::Show;
