//! Sums, differences, products and substitution of exact values, each brought into the normal form.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};
use std::sync::Arc;

use super::terms::{Roots, Terms};
use super::value::{Compound, Root, Value, integer};
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
        let ((left, a), (right, b)) = (self.parts(), other.parts());
        if a == b {
            return Value::build(sum(&left, &right), a.into_owned());
        }
        let shared = a.greatest_common_divisor(&b);
        let [by_left, by_right] =
            [&b, &a].map(|denominator| denominator.divided_by(&shared).expect("a common divisor divides"));
        Value::build(sum(&times(&left, &by_left), &times(&right, &by_right)), &*a * &by_left)
    }
}

/// Every coefficient multiplied by a polynomial.
fn times<'t>(terms: &'t Terms, factor: &Polynomial) -> Cow<'t, Terms> {
    if factor.is_one() {
        return Cow::Borrowed(terms);
    }
    Cow::Owned(terms.with(|coefficient| coefficient * factor))
}

/// The coefficients of the same products of roots added. Both rows are sorted, so products are compared once, which
/// counts where there is a root in a root.
fn sum(left: &Terms, right: &Terms) -> Terms {
    let (mut left, mut right) = (left.iter().peekable(), right.iter().peekable());
    Terms::from_sorted(std::iter::from_fn(|| {
        let order = match (left.peek(), right.peek()) {
            (Some((x, _)), Some((y, _))) => x.cmp(y),
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (None, None) => return None,
        };
        let own = if order.is_le() { left.next() } else { None };
        let others = if order.is_ge() { right.next() } else { None };
        match (own, others) {
            (Some((roots, p)), Some((_, q))) => Some((roots.clone(), p + q)),
            (Some((roots, p)), None) | (None, Some((roots, p))) => Some((roots.clone(), p.clone())),
            (None, None) => None,
        }
    }))
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
                let terms = compound.terms.with(|coefficient| coefficient.scaled(number));
                let denominator = compound.denominator.clone();
                return Value::Compound(Arc::new(Compound { terms, denominator }));
            }
            _ => {}
        }
        if let (Some(one), Some(other)) = (self.as_surd(), other.as_surd()) {
            return product_of_surds(one, other);
        }
        let ((left, a), (right, b)) = (self.parts(), other.parts());
        let denominator = &*a * &*b;
        let mut terms = Terms::default();
        // Where a root meets itself its square takes its place; squares that are not numbers are
        // themselves values, and join the sum at the end.
        let mut squared = Vec::new();
        for (x, p) in left.iter() {
            for (y, q) in right.iter() {
                let mut coefficient = p * q;
                let mut key = Roots::with_capacity(x.len() + y.len());
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
                    let entry = terms.coefficient_mut(key);
                    *entry = &*entry + &coefficient;
                } else {
                    squared.push((Value::build(Terms::one(key, coefficient), denominator.clone()), square));
                }
            }
        }
        let plain = Value::build(terms, denominator);
        squared.iter().fold(plain, |sum, (term, square)| &sum + &(term * square))
    }
}

/// The product of two surds: a root that meets itself comes out.
fn product_of_surds((a, x): (&Fraction, &[Root]), (b, y): (&Fraction, &[Root])) -> Value {
    let mut number = a * b;
    let mut roots: Roots = y.iter().filter(|root| !x.contains(root)).cloned().collect();
    for root in x {
        match root {
            Root::Prime(prime) if y.contains(root) => number = &number * &integer(*prime),
            _ => roots.push(root.clone()),
        }
    }
    roots.sort();
    Value::surd(number, roots)
}

impl Neg for &Value {
    type Output = Value;
    fn neg(self) -> Value {
        match self {
            Value::Rational(number) => Value::Rational(-number.clone()),
            Value::Compound(compound) => {
                let terms = compound.terms.with(|coefficient| -coefficient);
                Value::Compound(Arc::new(Compound { terms, denominator: compound.denominator.clone() }))
            }
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
        if !self.has_letter(|own| *own == letter) {
            return Some(self.clone());
        }
        let number = replacement.as_fraction();
        let at = |polynomial: &Polynomial| -> Value {
            if let Some(number) = number {
                return Value::quotient(polynomial.with(letter, number), Polynomial::one());
            }
            // Horner's scheme, so that the replacement is multiplied as seldom as possible.
            polynomial.coefficients(letter).iter().rev().fold(Value::ZERO, |sum, coefficient| {
                &(&sum * replacement) + &Value::quotient(coefficient.clone(), Polynomial::one())
            })
        };
        let (terms, denominator) = self.parts();
        let mut sum = Value::ZERO;
        for (roots, coefficient) in terms.iter() {
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
