//! Numbers with the width that rounding leaves open.
//!
//! A student who writes 15.6 has seen something from 15.55 to 15.65. Lines of working are compared in such widths: the
//! true number must lie within what the student's figures allow. The width of exact numbers is that of floats.

use std::ops::{Add, Mul, Neg, Sub};

/// From `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::mark::working) struct Spread {
    pub(in crate::mark::working) low: f64,
    pub(in crate::mark::working) high: f64,
}

/// What floats may lose on the way, in parts of the numbers involved.
const FLOAT: f64 = 1e-11;

impl Spread {
    pub(in crate::mark::working) fn of(low: f64, high: f64) -> Option<Spread> {
        (low.is_finite() && high.is_finite()).then(|| Spread { low: low.min(high), high: low.max(high) })
    }

    pub(in crate::mark::working) fn exactly(value: f64) -> Spread {
        Spread { low: value, high: value }
    }

    pub(in crate::mark::working) fn middle(self) -> f64 {
        (self.low + self.high) / 2.0
    }

    fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Could it be nought, where numbers of this size were added up?
    pub(in crate::mark::working) fn may_be_nought(self, size: f64) -> bool {
        let slack = FLOAT * size.max(self.size());
        self.low <= slack && self.high >= -slack
    }

    /// Could it be this number?
    pub(in crate::mark::working) fn may_be(self, value: f64) -> bool {
        (self - Spread::exactly(value)).may_be_nought(value.abs().max(self.size()))
    }

    /// Multiplied by a number that is as it is.
    pub(in crate::mark::working) fn times(self, number: f64) -> Spread {
        let (one, other) = (self.low * number, self.high * number);
        Spread { low: one.min(other), high: one.max(other) }
    }

    pub(in crate::mark::working) fn over(self, below: Spread) -> Option<Spread> {
        if below.low <= 0.0 && below.high >= 0.0 {
            return None;
        }
        Spread::among([self.low / below.low, self.low / below.high, self.high / below.low, self.high / below.high])
    }

    /// The image under a function that rises or falls all the way.
    pub(super) fn through(self, function: impl Fn(f64) -> f64) -> Option<Spread> {
        Spread::of(function(self.low), function(self.high))
    }

    pub(in crate::mark::working) fn absolute(self) -> Spread {
        let (low, high) = (self.low.abs(), self.high.abs());
        let least = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { low.min(high) };
        Spread { low: least, high: low.max(high) }
    }

    pub(super) fn to_the(self, power: u32) -> Option<Spread> {
        let base = if power.is_multiple_of(2) { self.absolute() } else { self };
        base.through(|number| number.powi(power as i32))
    }

    fn among(ends: [f64; 4]) -> Option<Spread> {
        let low = ends.into_iter().fold(f64::INFINITY, f64::min);
        let high = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Spread::of(low, high)
    }
}

impl Add for Spread {
    type Output = Spread;
    fn add(self, other: Spread) -> Spread {
        Spread { low: self.low + other.low, high: self.high + other.high }
    }
}

impl Sub for Spread {
    type Output = Spread;
    fn sub(self, other: Spread) -> Spread {
        Spread { low: self.low - other.high, high: self.high - other.low }
    }
}

impl Neg for Spread {
    type Output = Spread;
    fn neg(self) -> Spread {
        Spread { low: -self.high, high: -self.low }
    }
}

impl Mul for Spread {
    type Output = Spread;
    fn mul(self, other: Spread) -> Spread {
        let ends = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        Spread::among(ends).unwrap_or(Spread { low: f64::MIN, high: f64::MAX })
    }
}
