//! Methods compared: speed against accuracy, and maps of where each arrangement of a formula fails.

mod chart;
mod claim;
mod double;
mod exam_grid;
mod impacts;
mod map;
mod quantities;
mod tolerance;
mod velocities;

pub use chart::*;
pub use claim::{Claim, claims, try_all};
pub use double::{BITS, Outcome, ROUNDOFF, fraction};
pub use exam_grid::{Bounds, Census, Count, WHOLE, blocks, census, methods};
pub use impacts::{REGIMES, Regime};
pub use map::{Arrangement, Dealer, Map, Row, Subject};
pub use quantities::QUANTITIES;
pub use tolerance::{CHAINS, Chain, Spread, spread};
pub use velocities::{Scale, mapped, ordinary_error, outcome, regime};
/// Velocity maps.
pub use velocities::map as velocity_map;
