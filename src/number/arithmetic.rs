//! What a law can be evaluated in: exact values, certified intervals, floats.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Fraction, Interval, Value};

/// A kind of number in which the laws of mechanics can be evaluated.
///
/// Where a number is nought, a quotient or a root may not exist; `None` says so. For intervals it
/// also says that the precision does not suffice.
pub trait Number: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// The number times a fraction.
    fn scaled(&self, factor: &Fraction) -> Self;
    /// One of this kind.
    fn one(&self) -> Self;
    /// The quotient, `None` by nought.
    fn over(&self, divisor: &Self) -> Option<Self>;
    /// The root that is not negative; `None` of a negative number.
    fn root(&self) -> Option<Self>;
    /// The size without the sign.
    fn size(&self) -> Self;
    /// The size without the sign where another number, if there is one, is positive.
    fn size_where_positive(&self, _positive: impl FnOnce() -> Option<Self>) -> Self {
        self.size()
    }
    /// The size of what the impact makes positive: a formula whose letters do not tell is itself.
    fn size_of_positive(&self) -> Self {
        self.size()
    }
    /// Is it known to be nought?
    fn is_nought(&self) -> bool;

    /// Nought of this kind.
    fn nought(&self) -> Self {
        self.scaled(&Fraction::ZERO)
    }

    /// Half the number.
    fn half(&self) -> Self {
        self.scaled(&Fraction::new(1, 2))
    }

    /// What stands before its letters: 2 of 2*m*, as it is left when a common *m* has been cancelled. A plain number is its own.
    fn coefficient(&self) -> Self {
        self.clone()
    }

    /// The number times itself.
    fn squared(&self) -> Self {
        self.clone() * self.clone()
    }
}

impl Number for Value {
    fn scaled(&self, factor: &Fraction) -> Value {
        self * &Value::Rational(factor.clone())
    }
    fn one(&self) -> Value {
        Value::ONE
    }
    /// Not by a divisor with many roots: to rationalise it would take for ever and print as pages.
    fn over(&self, divisor: &Value) -> Option<Value> {
        if divisor.is_laborious() { None } else { self.divided_by(divisor) }
    }
    fn root(&self) -> Option<Value> {
        self.square_root()
    }
    fn size(&self) -> Value {
        self.absolute()
    }
    fn size_where_positive(&self, positive: impl FnOnce() -> Option<Value>) -> Value {
        match positive() {
            Some(positive) => self.absolute_where_positive(&positive),
            None => self.absolute(),
        }
    }
    fn size_of_positive(&self) -> Value {
        if self.sign().is_none() { self.clone() } else { self.absolute() }
    }
    fn is_nought(&self) -> bool {
        self.is_zero()
    }
    fn coefficient(&self) -> Value {
        let with_one = |value: Value, letter| value.substitute(letter, &Value::ONE);
        self.letters().into_iter().try_fold(self.clone(), with_one).unwrap_or_else(|| self.clone())
    }
}

impl Number for Interval {
    fn scaled(&self, factor: &Fraction) -> Interval {
        self.clone() * Interval::from_fraction(factor, self.bits())
    }
    fn one(&self) -> Interval {
        Interval::integer(1, self.bits())
    }
    fn over(&self, divisor: &Interval) -> Option<Interval> {
        self.checked_div(divisor)
    }
    fn root(&self) -> Option<Interval> {
        self.sqrt()
    }
    fn size(&self) -> Interval {
        self.abs()
    }
    fn is_nought(&self) -> bool {
        self.sign() == Some(std::cmp::Ordering::Equal)
    }
}

impl Number for f64 {
    fn scaled(&self, factor: &Fraction) -> f64 {
        self * factor.to_f64()
    }
    fn one(&self) -> f64 {
        1.0
    }
    fn over(&self, divisor: &f64) -> Option<f64> {
        (*divisor != 0.0).then(|| self / divisor)
    }
    fn root(&self) -> Option<f64> {
        (*self >= 0.0).then(|| self.sqrt())
    }
    fn size(&self) -> f64 {
        self.abs()
    }
    fn is_nought(&self) -> bool {
        *self == 0.0
    }
}
