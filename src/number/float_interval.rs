//! Intervals between two doubles: as certain as [`Interval`](super::Interval), a hundred times as quick, and never finer
//! than a double.
//!
//! A processor rounds sums, products, quotients and roots to the nearest double, so the true end is at most one double
//! away: stepping to the next one on the outer side always encloses, and needs no change of the rounding mode. For sines
//! and their like no such promise is made; their ends are moved outwards by far more than any library errs.

use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::{Add, Mul, Neg, Sub};

use super::{Fraction, Interval};

/// Between two doubles, both finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FloatInterval {
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

/// By so much of itself or of one, whichever is more, a sine or an angle may be wrong: two thousand doubles.
const SLACK: f64 = 4.6e-13;

/// Whole numbers up to here are doubles.
const WHOLE: f64 = 9_007_199_254_740_992.0;

impl FloatInterval {
    /// One double further out at each end.
    #[inline(always)]
    pub(crate) fn outwards(lower: f64, upper: f64) -> FloatInterval {
        FloatInterval { lower: lower.next_down(), upper: upper.next_up() }
    }

    /// A double, exactly.
    pub(crate) fn point(value: f64) -> FloatInterval {
        FloatInterval { lower: value, upper: value }
    }

    /// Doubles on either side of one that is the nearest to the true value, or beside the nearest.
    pub(crate) fn around(near: f64) -> FloatInterval {
        FloatInterval { lower: near.next_down().next_down(), upper: near.next_up().next_up() }
    }

    /// Doubles on either side of a fraction; a whole number that is a double is a point.
    pub(crate) fn from_fraction(value: &Fraction) -> FloatInterval {
        let near = value.to_f64();
        if value.is_integer() && near.abs() < WHOLE {
            return FloatInterval::point(near);
        }
        // Both halves of a long fraction are rounded before they are divided.
        let off = 4.0 * f64::EPSILON * near.abs();
        FloatInterval::outwards(near - off, near + off)
    }

    /// Doubles on either side of both ends.
    pub(crate) fn from_interval(value: &Interval) -> FloatInterval {
        let [lower, upper] = [value.lower(), value.upper()].map(|end| FloatInterval::from_fraction(&end));
        FloatInterval { lower: lower.lower, upper: upper.upper }
    }

    /// The number of radians in half a turn.
    pub(crate) fn pi() -> FloatInterval {
        FloatInterval::outwards(PI, PI)
    }

    /// Are both ends numbers? Where something overflowed they are not, and nothing is enclosed.
    pub(crate) fn is_finite(self) -> bool {
        self.lower.is_finite() && self.upper.is_finite()
    }

    /// The middle, if the ends are so near it that it has twelve right figures.
    pub(crate) fn sharp(self) -> Option<f64> {
        let middle = self.lower / 2.0 + self.upper / 2.0;
        (self.upper - self.lower <= 1e-12 * middle.abs()).then_some(middle)
    }

    /// Do the two have a point in common? If not, the values inside are certainly different.
    pub(crate) fn overlaps(self, other: FloatInterval) -> bool {
        self.lower <= other.upper && other.lower <= self.upper
    }

    /// The sign where the interval decides it, as [`Interval::sign`] does.
    pub(crate) fn sign(self) -> Option<Ordering> {
        let (lower, upper) = (self.lower.partial_cmp(&0.0)?, self.upper.partial_cmp(&0.0)?);
        (lower == upper).then_some(lower)
    }

    /// The value without its sign.
    pub(crate) fn abs(self) -> FloatInterval {
        match (self.lower >= 0.0, self.upper <= 0.0) {
            (true, _) => self,
            (_, true) => -self,
            _ => FloatInterval { lower: 0.0, upper: self.upper.max(-self.lower) },
        }
    }

    /// The quotient; `None` if the divisor may be nought.
    #[inline(always)]
    pub(crate) fn checked_div(self, divisor: FloatInterval) -> Option<FloatInterval> {
        (divisor.lower > 0.0 || divisor.upper < 0.0).then(|| {
            FloatInterval::among([
                self.lower / divisor.lower,
                self.lower / divisor.upper,
                self.upper / divisor.lower,
                self.upper / divisor.upper,
            ])
        })
    }

    /// The square root; a lower end below nought counts as nought, as in [`Interval::sqrt`].
    pub(crate) fn sqrt(self) -> Option<FloatInterval> {
        (self.upper >= 0.0).then(|| {
            let root = FloatInterval::outwards(self.lower.max(0.0).sqrt(), self.upper.sqrt());
            FloatInterval { lower: root.lower.max(0.0), ..root }
        })
    }

    /// The cube root; `None` unless all of the interval is at least nought.
    pub(crate) fn cube_root(self) -> Option<FloatInterval> {
        (self.lower >= 0.0).then(|| self.rising(f64::cbrt))
    }

    /// The sine of so many radians.
    pub(crate) fn sin(self) -> FloatInterval {
        self.wave(f64::sin)
    }

    /// The cosine of so many radians.
    pub(crate) fn cos(self) -> FloatInterval {
        self.wave(f64::cos)
    }

    /// The angle in radians with that tangent.
    pub(crate) fn atan(self) -> FloatInterval {
        self.rising(f64::atan)
    }

    /// The angle in radians with that sine; `None` if none of it is one. What reaches beyond 1 is cut off there.
    pub(crate) fn asin(self) -> Option<FloatInterval> {
        (self.lower <= 1.0 && self.upper >= -1.0).then(|| self.rising(|end| end.clamp(-1.0, 1.0).asin()))
    }

    /// The angle in radians with that cosine.
    pub(crate) fn acos(self) -> Option<FloatInterval> {
        Some(FloatInterval::outwards(FRAC_PI_2, FRAC_PI_2) - self.asin()?)
    }

    /// A wave nowhere rises by more than what is under it.
    fn wave(self, wave: fn(f64) -> f64) -> FloatInterval {
        let middle = self.lower / 2.0 + self.upper / 2.0;
        let (half, value) = (self.upper / 2.0 - self.lower / 2.0, wave(middle));
        // The middle itself is a double that was rounded.
        let off = half * 1.001 + SLACK * middle.abs().max(1.0);
        FloatInterval { lower: (value - off).max(-1.0), upper: (value + off).min(1.0) }
    }

    /// The image under a function that rises all the way.
    fn rising(self, function: impl Fn(f64) -> f64) -> FloatInterval {
        let (lower, upper) = (function(self.lower), function(self.upper));
        FloatInterval { lower: lower - SLACK * lower.abs().max(1.0), upper: upper + SLACK * upper.abs().max(1.0) }
    }

    #[inline(always)]
    fn among(corners: [f64; 4]) -> FloatInterval {
        let least = corners.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        FloatInterval::outwards(least, greatest)
    }
}

impl Add for FloatInterval {
    type Output = FloatInterval;
    #[inline(always)]
    fn add(self, other: FloatInterval) -> FloatInterval {
        FloatInterval::outwards(self.lower + other.lower, self.upper + other.upper)
    }
}

impl Sub for FloatInterval {
    type Output = FloatInterval;
    #[inline(always)]
    fn sub(self, other: FloatInterval) -> FloatInterval {
        FloatInterval::outwards(self.lower - other.upper, self.upper - other.lower)
    }
}

impl Neg for FloatInterval {
    type Output = FloatInterval;
    #[inline(always)]
    fn neg(self) -> FloatInterval {
        FloatInterval { lower: -self.upper, upper: -self.lower }
    }
}

impl Mul for FloatInterval {
    type Output = FloatInterval;
    #[inline(always)]
    fn mul(self, other: FloatInterval) -> FloatInterval {
        FloatInterval::among([
            self.lower * other.lower,
            self.lower * other.upper,
            self.upper * other.lower,
            self.upper * other.upper,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What must be inside, to far more figures than a double has.
    fn holds(found: FloatInterval, certain: &Interval) -> bool {
        let [lower, upper] = [found.lower, found.upper].map(|end| Fraction::from_f64(end).expect("finite"));
        lower <= certain.lower() && certain.upper() <= upper
    }

    #[test]
    fn what_a_certified_interval_encloses_is_inside() {
        const BITS: usize = 160;
        let ones = (-19_993..20_000).step_by(371).flat_map(|one| [(one, 1), (one, 3), (one, 450), (one, 899)]);
        for (place, (one, below)) in ones.enumerate() {
            let other = place as i64 % 23 - 11;
            let [a, b] = [Fraction::new(one, below), Fraction::new(other, 7)];
            let [x, y] = [&a, &b].map(FloatInterval::from_fraction);
            let [p, q] = [&a, &b].map(|value| Interval::from_fraction(value, BITS));
            let small = Fraction::new(one, 20_000);
            let (t, r) = (FloatInterval::from_fraction(&small), Interval::from_fraction(&small, BITS));
            let pairs = [
                (Some(x + y), Some(p.clone() + q.clone())),
                (Some(x - y), Some(p.clone() - q.clone())),
                (Some(x * y), Some(p.clone() * q.clone())),
                (x.checked_div(y), p.checked_div(&q)),
                (Some(x.sin()), Some(p.sin())),
                (Some(x.cos()), Some(p.cos())),
                (Some(x.atan()), Some(p.atan())),
                (x.abs().sqrt(), p.abs().sqrt()),
                (x.abs().cube_root(), p.abs().cube_root()),
                (t.asin(), r.asin()),
                (t.acos(), r.acos()),
                (Some(FloatInterval::from_interval(&p)), Some(p)),
            ];
            for (which, pair) in pairs.into_iter().enumerate() {
                match pair {
                    (Some(found), Some(certain)) => assert!(holds(found, &certain), "{which} of {a} and {b}"),
                    (found, certain) => assert!(found.is_none() && certain.is_none(), "{which} of {a} and {b}"),
                }
            }
        }
    }

    #[test]
    fn what_has_no_value_has_no_enclosure() {
        let two = FloatInterval::point(2.0);
        assert!(two.asin().is_none() && (-two).sqrt().is_none() && (-two).cube_root().is_none());
        assert!(two.checked_div(two - two).is_none());
        assert!(!(FloatInterval::point(f64::MAX) * two).is_finite());
    }
}
