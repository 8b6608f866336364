//! Each number as the sum of two doubles, about 32 figures, from data that are doubles.
//!
//! The arithmetic is far more precise than the data: a third that comes in as the nearest double goes on being that double, so
//! a sphere that should stop keeps a small velocity, and the more faithfully so the more figures there are.

use std::ops::{Add, Mul, Neg, Sub};

use crate::method::batch::{LETTERS_ARE_NO_FLOATS, batch, float};
use crate::method::needs::geometry_of;
use crate::method::{After, Field, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Two doubles for each number.
pub(in crate::method) struct DoubleDouble;

/// The sum of two doubles, the second less than a roundoff of the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Twofold {
    high: f64,
    low: f64,
}

/// A sum and what rounding took from it.
#[inline(always)]
fn sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    let of_b = high - a;
    Twofold { high, low: (a - (high - of_b)) + (b - of_b) }
}

/// A sum as it is, if the first is the larger.
#[inline(always)]
fn ordered(high: f64, low: f64) -> Twofold {
    let total = high + low;
    Twofold { high: total, low: low - (total - high) }
}

/// A product and what rounding took from it.
#[inline(always)]
fn product(a: f64, b: f64) -> Twofold {
    let high = a * b;
    Twofold { high, low: a.mul_add(b, -high) }
}

impl Add for Twofold {
    type Output = Twofold;
    #[inline(always)]
    fn add(self, other: Twofold) -> Twofold {
        let (high, low) = (sum(self.high, other.high), sum(self.low, other.low));
        let first = ordered(high.high, high.low + low.high);
        ordered(first.high, first.low + low.low)
    }
}

impl Neg for Twofold {
    type Output = Twofold;
    #[inline(always)]
    fn neg(self) -> Twofold {
        Twofold { high: -self.high, low: -self.low }
    }
}

impl Sub for Twofold {
    type Output = Twofold;
    #[inline(always)]
    fn sub(self, other: Twofold) -> Twofold {
        self + -other
    }
}

impl Mul for Twofold {
    type Output = Twofold;
    #[inline(always)]
    fn mul(self, other: Twofold) -> Twofold {
        let high = product(self.high, other.high);
        ordered(high.high, high.low + (self.high * other.low + self.low * other.high))
    }
}

impl Field for Twofold {
    fn one(&self) -> Twofold {
        Twofold { high: 1.0, low: 0.0 }
    }
    fn nought(&self) -> Twofold {
        Twofold::default()
    }
    #[inline(always)]
    fn over(&self, divisor: &Twofold) -> Option<Twofold> {
        // Three steps of long division with doubles for digits.
        let digit = |value: Twofold| Twofold { high: value.high / divisor.high, low: 0.0 };
        let first = digit(*self);
        let rest = *self - *divisor * first;
        let second = digit(rest);
        let third = digit(rest - *divisor * second);
        (divisor.high != 0.0).then(|| ordered(first.high, second.high) + third)
    }
    fn is_nought(&self) -> bool {
        self.high == 0.0
    }
}

impl Method for DoubleDouble {
    fn name(&self) -> &'static str {
        "double-double"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, taken as the nearest doubles; any line of centres"
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(32.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let geometry = geometry_of(impacts);
        let form = |impact: &Impact<Value>| {
            let doubles = impact.in_floats().ok_or(LETTERS_ARE_NO_FLOATS)?;
            let twofold = doubles.turned_into(|number| Some(Twofold { high: *number, low: 0.0 }));
            Ok((twofold.ok_or(LETTERS_ARE_NO_FLOATS)?, ()))
        };
        batch(
            impacts,
            form,
            move |impact| geometry.solve(impact),
            |(), after: &Option<After<Twofold>>| match after {
                Some(after) => float(after.map(|velocity| velocity.map(|component| component.high))),
                None => Found::Missed("the line of centres is of no length".to_owned()),
            },
        )
    }
}
