//! Contact looked for at fixed steps of time, then the impact in closed form: what an engine does, in twenty lines.
//!
//! The spheres have met somewhere between two steps when their overlap is noticed, and the line of centres is taken as it is
//! then. The law of restitution is kept to the last figure, along a line that is a little off: an error of the first order
//! in the step, whatever the rest of an engine does.

use super::{NO_APPROACH, approach};
use crate::method::batch::{LETTERS_ARE_NO_FLOATS, batch, float};
use crate::method::{After, Found, Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Detection at fixed steps. Radii add up to one metre, and A starts so that contact comes after one metre of approach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedStep {
    /// Seconds between two looks.
    pub step: f64,
    /// The part of a step by which the first look is late.
    pub phase: f64,
}

impl FixedStep {
    /// 240 looks a second.
    pub const USUAL: FixedStep = FixedStep { step: 1.0 / 240.0, phase: 0.5 };
}

impl Method for FixedStep {
    fn name(&self) -> &'static str {
        "fixed-step"
    }

    fn role(&self) -> Role {
        Role::Exhibit
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, spheres that approach and do not pass through each other between two looks"
    }

    fn promises(&self) -> Promise {
        Promise::Nothing("the line of centres is taken when the overlap is noticed, which is late")
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let setting = *self;
        let form = |impact: &Impact<Value>| Ok((impact.in_floats().ok_or(LETTERS_ARE_NO_FLOATS)?, ()));
        batch(
            impacts,
            form,
            move |impact| setting.solve(impact),
            |(), after: &Option<After<f64>>| match after {
                Some(after) => float(*after),
                None => Found::Missed(format!("{NO_APPROACH}, or passed through each other between two looks")),
            },
        )
    }
}

impl FixedStep {
    fn solve(self, impact: &Impact<f64>) -> Option<After<f64>> {
        let (line, _) = approach(impact)?;
        let [a, b] = impact.before;
        let relative = [b[0] - a[0], b[1] - a[1]];
        let speed = relative[0].hypot(relative[1]);
        // Contact comes one metre of the way from the start. Until then no look shows an overlap, however slow the way is; the
        // last of them, and as many after it as roundings may need, tell all there is to see.
        let contact = 1.0 / speed;
        let first = self.step * self.phase;
        let before = ((contact - first) / self.step).floor().max(0.0);
        for look in [0.0, 1.0, 2.0, 3.0] {
            let late = first + (before + look) * self.step - contact;
            // The centre of B seen from that of A.
            let seen = [line[0] + relative[0] * late, line[1] + relative[1] * late];
            if late > 0.0 && seen[0] * seen[0] + seen[1] * seen[1] < 1.0 {
                return Geometry::AnyLine.solve(&Impact { line: seen, ..impact.clone() });
            }
        }
        None
    }
}
