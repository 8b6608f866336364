//! Intervals with doubles as ends, each rounded one double further out than it needs to be.
//!
//! A processor rounds to the nearest double, so the true end is at most one double away: stepping to the next one on the
//! outer side always encloses, and needs no change of the rounding mode.

use std::ops::{Add, Mul, Sub};

use crate::method::batch::batch;
use crate::method::needs::geometry_of;
use crate::method::{After, Field, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Fraction, Interval, Value};

/// Intervals of doubles.
pub(in crate::method) struct FloatIntervals;

/// Between two doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Between {
    lower: f64,
    upper: f64,
}

impl Between {
    /// One double further out at each end.
    #[inline(always)]
    fn outwards(lower: f64, upper: f64) -> Between {
        Between { lower: lower.next_down(), upper: upper.next_up() }
    }

    /// Doubles on either side of a value, or the double that it is.
    fn of(value: &Value) -> Option<Between> {
        let near = value.to_f64()?;
        let exact = value.as_fraction().is_some_and(|value| Fraction::from_f64(near).as_ref() == Some(value));
        // `to_f64` is the nearest double or one beside it.
        Some(if exact {
            Between { lower: near, upper: near }
        } else {
            Between { lower: near.next_down().next_down(), upper: near.next_up().next_up() }
        })
    }

    /// The same as an interval of whole multiples of a power of two.
    fn interval(self) -> Option<Interval> {
        let end = |end: f64| Some(Interval::from_fraction(&Fraction::from_f64(end)?, 128));
        Some(end(self.lower)?.hull(&end(self.upper)?))
    }
}

impl Add for Between {
    type Output = Between;
    #[inline(always)]
    fn add(self, other: Between) -> Between {
        Between::outwards(self.lower + other.lower, self.upper + other.upper)
    }
}

impl Sub for Between {
    type Output = Between;
    #[inline(always)]
    fn sub(self, other: Between) -> Between {
        Between::outwards(self.lower - other.upper, self.upper - other.lower)
    }
}

impl Mul for Between {
    type Output = Between;
    #[inline(always)]
    fn mul(self, other: Between) -> Between {
        let corners =
            [self.lower * other.lower, self.lower * other.upper, self.upper * other.lower, self.upper * other.upper];
        let least = corners.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Between::outwards(least, greatest)
    }
}

impl Field for Between {
    fn one(&self) -> Between {
        Between { lower: 1.0, upper: 1.0 }
    }
    fn nought(&self) -> Between {
        Between { lower: 0.0, upper: 0.0 }
    }
    #[inline(always)]
    fn over(&self, divisor: &Between) -> Option<Between> {
        let corners = [
            self.lower / divisor.lower,
            self.lower / divisor.upper,
            self.upper / divisor.lower,
            self.upper / divisor.upper,
        ];
        let least = corners.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        (divisor.lower > 0.0 || divisor.upper < 0.0).then(|| Between::outwards(least, greatest))
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
        let form =
            |impact: &Impact<Value>| Ok((impact.turned_into(Between::of).ok_or("letters have no enclosure")?, ()));
        batch(
            impacts,
            form,
            move |impact| geometry.solve(impact),
            |(), after: &Option<After<Between>>| {
                let enclosed = after.and_then(|after| {
                    let [[a_x, a_y], [b_x, b_y]] = after.map(|velocity| velocity.map(Between::interval));
                    Some([[a_x?, a_y?], [b_x?, b_y?]])
                });
                enclosed.map_or_else(|| Found::Missed("an end is no finite number".to_owned()), Found::Enclosed)
            },
        )
    }
}
