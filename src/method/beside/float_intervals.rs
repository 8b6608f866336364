//! Intervals with doubles as ends, each rounded one double further out than it needs to be.

use crate::method::batch::batch;
use crate::method::needs::geometry_of;
use crate::method::{After, Field, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{FloatInterval, Fraction, Interval, Value};

/// Intervals of doubles.
pub(in crate::method) struct FloatIntervals;

/// Doubles on either side of a value, or the double that it is.
fn enclosed(value: &Value) -> Option<FloatInterval> {
    let near = value.to_f64()?;
    let exact = value.as_fraction().is_some_and(|value| Fraction::from_f64(near).as_ref() == Some(value));
    // `to_f64` is the nearest double or one beside it.
    Some(if exact { FloatInterval::point(near) } else { FloatInterval::around(near) })
}

/// The same as an interval of whole multiples of a power of two.
fn interval(found: FloatInterval) -> Option<Interval> {
    let end = |end: f64| Some(Interval::from_fraction(&Fraction::from_f64(end)?, 128));
    Some(end(found.lower)?.hull(&end(found.upper)?))
}

impl Field for FloatInterval {
    fn one(&self) -> FloatInterval {
        FloatInterval::point(1.0)
    }
    fn nought(&self) -> FloatInterval {
        FloatInterval::point(0.0)
    }
    #[inline(always)]
    fn over(&self, divisor: &FloatInterval) -> Option<FloatInterval> {
        self.checked_div(*divisor)
    }
    fn is_nought(&self) -> bool {
        self.lower == 0.0 && self.upper == 0.0
    }
}

impl Method for FloatIntervals {
    fn name(&self) -> &'static str {
        "float-intervals"
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
        let geometry = geometry_of(impacts);
        let form = |impact: &Impact<Value>| Ok((impact.turned_into(enclosed).ok_or("letters have no enclosure")?, ()));
        batch(
            impacts,
            form,
            move |impact| geometry.solve(impact),
            |(), after: &Option<After<FloatInterval>>| {
                let enclosed = after.and_then(|after| {
                    let [[a_x, a_y], [b_x, b_y]] = after.map(|velocity| velocity.map(interval));
                    Some([[a_x?, a_y?], [b_x?, b_y?]])
                });
                enclosed.map_or_else(|| Found::Missed("an end is no finite number".to_owned()), Found::Enclosed)
            },
        )
    }
}
