//! Values as sums of a few things with rational coefficients: 3 + 2√2, or 6 cos 10° - v.
//!
//! The things are products of roots and powers of letters. As a sum of them a value has one form only, so what is linear
//! in the velocities may be done to the coefficients alone; a nought among them stays an exact nought.

use std::collections::BTreeMap;

use smallvec::SmallVec;

use crate::number::{Fraction, Monomial, Polynomial, Root, Roots, Value};

/// A product of roots and powers of letters.
pub(super) type Element = (Roots, Monomial);

/// The coefficients of a value, each with its element.
pub(super) type Coefficients = SmallVec<[(Element, Fraction); 2]>;

/// The coefficients of a value; `None` if it has a denominator with letters.
pub(super) fn coefficients(value: &Value) -> Option<Coefficients> {
    let mut coefficients = SmallVec::new();
    if let Value::Rational(number) = value {
        if !number.is_zero() {
            coefficients.push((Element::default(), number.clone()));
        }
        return Some(coefficients);
    }
    let (terms, below) = value.parts();
    if !below.is_one() {
        return None;
    }
    for (roots, polynomial) in terms.iter() {
        for (monomial, coefficient) in polynomial.terms() {
            coefficients.push(((roots.clone(), monomial.clone()), coefficient.clone()));
        }
    }
    Some(coefficients)
}

/// The value with these coefficients.
pub(super) fn sum<'a>(coefficients: impl Iterator<Item = (&'a Element, Fraction)>) -> Value {
    let mut terms: BTreeMap<&[Root], Vec<(Monomial, Fraction)>> = BTreeMap::new();
    let mut rational = Fraction::ZERO;
    for ((roots, monomial), coefficient) in coefficients {
        match roots.is_empty() && monomial.is_empty() {
            true => rational = &rational + &coefficient,
            false => terms.entry(roots).or_default().push((monomial.clone(), coefficient)),
        }
    }
    if terms.is_empty() {
        return Value::from(rational);
    }
    terms.entry(&[]).or_default().push((Monomial::new(), rational));
    let terms = terms.into_iter().map(|(roots, terms)| (roots.into(), Polynomial::from_terms(terms)));
    Value::build(terms.filter(|(_, terms)| !terms.is_zero()).collect(), Polynomial::one())
}
