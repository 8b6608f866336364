//! Velocities of which the working has found another value: a bare `A: 0.4` after `v = 1` has not come from it.

use super::{are_far, is_unfinished};
use crate::mark::reading::{Form, Statement};
use crate::mark::working::examine::Working;
use crate::mark::working::numbers::sizes;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

impl Working<'_> {
    /// The speeds and velocities after the impact of spheres whose component along the line of centres is plainly another in
    /// the lines, at the last place that has a value for its letter.
    pub(in crate::mark::working) fn found_otherwise(&self) -> Vec<Quantity> {
        let after = |sphere| {
            let along = |axis| Quantity::Velocity(sphere, Moment::After, axis);
            [Quantity::Speed(sphere, Moment::After), along(Axis::N), along(Axis::X), along(Axis::Y)]
        };
        Sphere::BOTH.into_iter().filter(|sphere| self.is_found_otherwise(*sphere)).flat_map(after).collect()
    }

    fn is_found_otherwise(&self, sphere: Sphere) -> bool {
        let along = Quantity::Velocity(sphere, Moment::After, Axis::N);
        let right = |quantity| sizes(&self.prepared.known, quantity);
        let sizes = |numbers: &[f64]| numbers.iter().map(|number| number.abs()).collect::<Vec<f64>>();
        let Some(((own, _), along)) = self.theirs.values.get(&along).zip(right(along)) else { return false };
        // The letter may be of the whole speed, but where nothing is left along the line of centres nobody tells the two apart.
        let is_speed = along.iter().any(|along| along.abs() > 1e-9)
            && right(Quantity::Speed(sphere, Moment::After)).is_some_and(|speed| !are_far(own, &speed));
        are_far(&sizes(own), &sizes(&along)) && !is_speed
    }
}

/// Is it a value with nothing that was worked out to come to it?
pub(in crate::mark) fn is_bare(statement: &Statement) -> bool {
    match statement.said.as_slice() {
        [said] => matches!(&said.form, Form::Value(expr) if !is_unfinished(expr)),
        _ => false,
    }
}
