//! Sums, differences, products and substitution of exact values, each brought into the normal form.

use std::ops::{Add, Mul, Neg, Sub};
use std::sync::Arc;

use super::value::{Compound, Root, Terms, Value, integer};
use super::{Fraction, Letter, Polynomial};

impl Add for &Value {
    type Output = Value;
    fn add(self, other: &Value) -> Value {
        match (self, other) {
            (Value::Rational(a), Value::Rational(b)) => return Value::Rational(a + b),
            (Value::Rational(nought), value) | (value, Value::Rational(nought)) if nought.is_zero() => {
                return value.clone();
            }
            _ => {}
        }
        let ((mut terms, a), (others, b)) = (self.parts(), other.parts());
        let mut denominator = a.clone();
        let (mut left, mut right) = (Polynomial::one(), Polynomial::one());
        if a != b {
            let shared = a.greatest_common_divisor(&b);
            left = b.divided_by(&shared).expect("a common divisor divides");
            right = a.divided_by(&shared).expect("a common divisor divides");
            denominator = &a * &left;
        }
        terms.values_mut().for_each(|coefficient| *coefficient = &*coefficient * &left);
        for (key, coefficient) in others {
            let entry = terms.entry(key).or_default();
            *entry = &*entry + &(&coefficient * &right);
        }
        Value::build(terms, denominator)
    }
}

impl Mul for &Value {
    type Output = Value;
    fn mul(self, other: &Value) -> Value {
        match (self, other) {
            (Value::Rational(a), Value::Rational(b)) => return Value::Rational(a * b),
            (Value::Rational(number), Value::Compound(compound))
            | (Value::Compound(compound), Value::Rational(number)) => {
                if number.is_zero() {
                    return Value::ZERO;
                }
                let terms = compound.terms.iter().map(|(key, p)| (key.clone(), p.scaled(number))).collect();
                let denominator = compound.denominator.clone();
                return Value::Compound(Arc::new(Compound { terms, denominator }));
            }
            _ => {}
        }
        let ((left, a), (right, b)) = (self.parts(), other.parts());
        let denominator = &a * &b;
        let mut terms = Terms::new();
        // Where a root meets itself its square takes its place; squares that are not numbers are
        // themselves values, and join the sum at the end.
        let mut squared = Vec::new();
        for (x, p) in &left {
            for (y, q) in &right {
                let mut coefficient = p * q;
                let mut key = Vec::with_capacity(x.len() + y.len());
                let mut square = Value::ONE;
                for root in x {
                    match (y.contains(root), root) {
                        (false, _) => key.push(root.clone()),
                        (true, Root::Prime(prime)) => coefficient = coefficient.scaled(&integer(*prime)),
                        (true, _) => square = &square * &root.square(),
                    }
                }
                key.extend(y.iter().filter(|root| !x.contains(root)).cloned());
                key.sort();
                if square.as_fraction().is_some_and(Fraction::is_one) {
                    let entry = terms.entry(key).or_default();
                    *entry = &*entry + &coefficient;
                } else {
                    squared.push((Value::build(Terms::from([(key, coefficient)]), denominator.clone()), square));
                }
            }
        }
        let plain = Value::build(terms, denominator);
        squared.iter().fold(plain, |sum, (term, square)| &sum + &(term * square))
    }
}

impl Neg for &Value {
    type Output = Value;
    fn neg(self) -> Value {
        match self {
            Value::Rational(number) => Value::Rational(-number.clone()),
            Value::Compound(_) => self * &Value::from(-1),
        }
    }
}

impl Sub for &Value {
    type Output = Value;
    fn sub(self, other: &Value) -> Value {
        self + &-other
    }
}

macro_rules! by_value {
    ($($law:ident $name:ident),*) => {$(
        impl $law for Value {
            type Output = Value;
            fn $name(self, other: Value) -> Value {
                (&self).$name(&other)
            }
        }
    )*};
}
by_value!(Add add, Sub sub, Mul mul);

impl Neg for Value {
    type Output = Value;
    fn neg(self) -> Value {
        -&self
    }
}

impl Value {
    /// Every occurrence of a letter replaced; `None` if that divides by nought or takes the root of
    /// a negative number. The replacement of the letter of an angle is a tangent.
    pub fn substitute(&self, letter: Letter, replacement: &Value) -> Option<Value> {
        if !self.letters().contains(&letter) {
            return Some(self.clone());
        }
        let at = |polynomial: &Polynomial| -> Value {
            // Horner's scheme, so that the replacement is multiplied as seldom as possible.
            polynomial.coefficients(letter).iter().rev().fold(Value::ZERO, |sum, coefficient| {
                &(&sum * replacement) + &Value::quotient(coefficient.clone(), Polynomial::one())
            })
        };
        let (terms, denominator) = self.parts();
        let mut sum = Value::ZERO;
        for (roots, coefficient) in &terms {
            let mut term = at(coefficient);
            for root in roots {
                let factor = match root {
                    Root::Cosine(tangent) if *tangent == letter => {
                        (&Value::ONE + &(replacement * replacement)).reciprocal()?.square_root()?
                    }
                    Root::Nested { radicand, .. } => radicand.substitute(letter, replacement)?.square_root()?,
                    other => Value::root(other.clone()),
                };
                term = &term * &factor;
            }
            sum = &sum + &term;
        }
        sum.divided_by(&at(&denominator))
    }
}
