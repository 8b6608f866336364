//! What two values share, taken out of both.

use std::cmp::Ordering;

use super::terms::{Roots, Terms};
use super::value::Value;
use super::{Fraction, Polynomial, Range};

impl Value {
    /// Two values divided by the same positive value, so that no root, no polynomial and no number but one is
    /// left that all their terms share. Their quotient is the same, and so is the angle of the vector that they are.
    ///
    /// ```
    /// use carom::number::Value;
    /// let root = Value::from(2).square_root().unwrap();
    /// let (a, b) = Value::without_common_factors(&(&root * &Value::from(6)), &(&root * &Value::fraction(9, 2)));
    /// assert_eq!((a, b), (Value::from(4), Value::from(3)));
    /// ```
    pub fn without_common_factors(a: &Value, b: &Value) -> (Value, Value) {
        without(a, b, Signs::Known).unwrap_or_else(|| (a.clone(), b.clone()))
    }

    /// The same for values of which only the quotient counts: what is taken out of both may be negative as well.
    pub fn in_lowest_terms(a: &Value, b: &Value) -> (Value, Value) {
        let (a, b) = without(a, b, Signs::Any).unwrap_or_else(|| (a.clone(), b.clone()));
        if b.sign() == Some(Ordering::Less) { (-a, -b) } else { (a, b) }
    }
}

/// Which factors may be taken out.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Signs {
    /// Those of which it is known whether they are positive.
    Known,
    /// All.
    Any,
}

/// Two values without what they share; `None` where that is not to be taken out, and of nought.
fn without(a: &Value, b: &Value, signs: Signs) -> Option<(Value, Value)> {
    let ((above, p), (below, q)) = (a.parts(), b.parts());
    let (mut above, mut below) = (above.into_owned(), below.into_owned());
    // Over one denominator, which can then be left out, but for what makes tangents sines and cosines.
    let shared = p.greatest_common_divisor(&q);
    let exact = |polynomial: &Polynomial, divisor: &Polynomial| {
        polynomial.divided_by(divisor).expect("a common divisor divides")
    };
    let (left, right) = (exact(&q, &shared), exact(&p, &shared));
    let both = &left * &*p;
    let turned = |polynomial: &Polynomial| {
        sign(polynomial).or((signs == Signs::Any && !polynomial.is_zero()).then_some(Fraction::ONE))
    };
    let sign = turned(&both)?;
    let secants = secants(both);
    above.change(|coefficient| coefficient * &left);
    below.change(|coefficient| coefficient * &right);
    let coefficients = || above.coefficients().chain(below.coefficients());
    let factor = coefficients().fold(Polynomial::zero(), |shared, p| shared.greatest_common_divisor(p));
    let (factor, turn) = match turned(&factor) {
        Some(turn) => (factor, turn),
        None => (Polynomial::one(), Fraction::ONE),
    };
    let whole = coefficients().fold(Fraction::ZERO, |content, p| {
        p.terms().iter().fold(content, |content, (_, number)| content.common_measure(number))
    });
    let scale = (&whole * &(&sign * &turn)).reciprocal()?;
    let roots = shared_roots(&above, &below);
    let rest = |terms: Terms| {
        let divided = terms.into_iter().map(|(mut key, coefficient)| {
            key.retain(|root| !roots.contains(root));
            (key, exact(&coefficient, &factor).scaled(&scale))
        });
        Value::build(divided.collect(), secants.clone())
    };
    Some((rest(above), rest(below)))
}

/// One or minus one; `None` where the sign depends on the letters, and of nought.
fn sign(polynomial: &Polynomial) -> Option<Fraction> {
    match Value::quotient(polynomial.clone(), Polynomial::one()).sign()? {
        Ordering::Less => Some(Fraction::from(-1)),
        Ordering::Equal => None,
        Ordering::Greater => Some(Fraction::ONE),
    }
}

/// The factors 1 + tan² of a denominator, each one over the square of a cosine.
fn secants(mut denominator: Polynomial) -> Polynomial {
    let mut product = Polynomial::one();
    for letter in denominator.letters() {
        if !matches!(letter.range(), Range::Acute | Range::Degrees) {
            continue;
        }
        let secant = Polynomial::one_plus_square(letter);
        while let Some(rest) = denominator.divided_by(&secant) {
            denominator = rest;
            product = &product * &secant;
        }
    }
    product
}

/// The roots in every product of both sums.
fn shared_roots(above: &Terms, below: &Terms) -> Roots {
    let mut keys = above.products().chain(below.products());
    let mut shared = keys.next().cloned().unwrap_or_default();
    keys.for_each(|key| shared.retain(|root| key.contains(root)));
    shared
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Letter;

    #[test]
    fn what_both_share_is_taken_out_unless_its_sign_is_unknown() {
        let letter = |name, range| Value::letter(Letter::new(name, range).unwrap());
        let (u, x) = (letter("u", Range::Positive), letter("x", Range::Real));
        let root = |n: i64| Value::from(n).square_root().unwrap();
        let sum = &root(3) + &root(11);
        let rest = &Value::from(3) + &root(33);
        let (a, b) = (&sum * &Value::from(5), &rest * &Value::from(2));
        let scaled = |value: &Value, by: &Value| &(value * by) * &Value::fraction(1, 64);
        let e = Value::letter(Letter::new("e", Range::Unit).unwrap());
        let below = (&Value::from(3) - &e).reciprocal().unwrap();
        for factor in [u.clone(), &u * &u, u.reciprocal().unwrap(), root(5), &x * &x, &Value::from(2) - &e, below] {
            let (above, below) = Value::without_common_factors(&scaled(&a, &factor), &scaled(&b, &factor));
            assert_eq!((above, below), (a.clone(), b.clone()), "{factor:?}");
        }
        let (above, below) = Value::without_common_factors(&scaled(&a, &x), &scaled(&b, &x));
        assert_eq!((above, below), (&a * &x, &b * &x));
        for factor in [x.clone(), (&x - &e).reciprocal().unwrap()] {
            let (above, below) = Value::in_lowest_terms(&scaled(&a, &factor), &scaled(&b, &factor));
            assert_eq!((above, below), (a.clone(), b.clone()), "{factor:?}");
        }
        assert_eq!(Value::in_lowest_terms(&Value::from(4), &Value::from(-6)), (Value::from(-2), Value::from(3)));
        assert_eq!(Value::in_lowest_terms(&Value::ZERO, &Value::ZERO), (Value::ZERO, Value::ZERO));
        assert_eq!(Value::without_common_factors(&Value::ZERO, &Value::from(-3)), (Value::ZERO, Value::from(-1)));
    }
}
