//! Exhibits: an impact as a simulation comes to it, and what that costs in time and figures.
//!
//! Each has settings of its own, so that a study can vary them; the list of methods holds one usual setting of each.

mod fixed_step;
mod sequential;
mod spring;

pub use fixed_step::FixedStep;
pub use sequential::Sequential;
pub use spring::{Integrator, Spring};

use super::Impact;

/// The unit vector from A to B, and how fast A approaches B along it; nothing if it does not, or the line has no length.
fn approach(impact: &Impact<f64>) -> Option<([f64; 2], f64)> {
    let size = impact.line[0].hypot(impact.line[1]);
    let line = impact.line.map(|component| component / size);
    let [a, b] = impact.before;
    let speed = (a[0] - b[0]) * line[0] + (a[1] - b[1]) * line[1];
    (speed > 0.0).then_some((line, speed))
}

/// Why a simulation finds nothing where the spheres part.
const NO_APPROACH: &str = "the spheres do not approach along the line from A to B";
