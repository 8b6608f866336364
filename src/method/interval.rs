//! The impulse by the reduced mass in certified intervals of 128 binary places.

use super::batch::batch;
use super::kernel::any_line;
use super::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Interval, Value};

/// Certified intervals.
pub(super) struct Intervals;

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
            enclosed.ok_or_else(|| "letters have no enclosure".to_owned())
        };
        batch(impacts, form, any_line, |_, after: &Option<After<Interval>>| match after {
            Some(after) => Found::Enclosed(after.clone()),
            None => Found::Missed("the line of centres may be of no length".to_owned()),
        })
    }
}
