//! Values as sums of a few things with rational coefficients: 3 + 2√2, or 6 cos 10° - v.
//!
//! The things are products of roots and powers of letters. As a sum of them a value has one form only, so what is linear
//! in the velocities may be done to the coefficients alone; a nought among them stays an exact nought.

use crate::number::{Fraction, Monomial, Polynomial, Root, Value};
use std::collections::BTreeMap;

/// A product of roots and powers of letters.
pub(super) type Element = (Vec<Root>, Monomial);

/// The coefficients of a value; `None` if it has a denominator with letters.
pub(super) fn coefficients(value: &Value) -> Option<Vec<(Element, Fraction)>> {
    if let Value::Rational(number) = value {
        return Some(if number.is_zero() { Vec::new() } else { vec![(Element::default(), number.clone())] });
    }
    if !value.denominator().is_one() {
        return None;
    }
    let mut coefficients = Vec::new();
    for (roots, polynomial) in value.numerator_terms() {
        for (monomial, coefficient) in polynomial.terms() {
            coefficients.push(((roots.clone(), monomial.clone()), coefficient.clone()));
        }
    }
    Some(coefficients)
}

/// The value with these coefficients.
pub(super) fn sum<'a>(coefficients: impl Iterator<Item = (&'a Element, Fraction)>) -> Value {
    let mut terms: BTreeMap<Vec<Root>, Vec<(Monomial, Fraction)>> = BTreeMap::new();
    for ((roots, monomial), coefficient) in coefficients {
        terms.entry(roots.clone()).or_default().push((monomial.clone(), coefficient));
    }
    let terms = terms.into_iter().map(|(roots, terms)| (roots, Polynomial::from_terms(terms))).collect();
    Value::build(terms, Polynomial::one())
}
