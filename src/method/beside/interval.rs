//! The impulse by the reduced mass in certified intervals of 128 binary places.

use crate::method::batch::batch;
use crate::method::geometry::any_line;
use crate::method::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Interval, Value};

/// Certified intervals.
pub(in crate::method) struct Intervals;

/// How many binary places their ends have.
const BITS: usize = 128;

impl Method for Intervals {
    fn name(&self) -> &'static str {
        "intervals"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, any line of centres"
    }

    fn promises(&self) -> Promise {
        Promise::Enclosed
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let form = |impact: &Impact<Value>| {
            let enclosed = impact.turned_into(|value| value.enclose_constant(BITS));
            Ok((enclosed.ok_or("letters have no enclosure")?, ()))
        };
        batch(impacts, form, any_line, |(), after: &Option<After<Interval>>| match after {
            Some(after) => Found::Enclosed(after.clone()),
            None => Found::Missed("the line of centres may be of no length".to_owned()),
        })
    }
}
