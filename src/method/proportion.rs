//! What of an impact matters only in proportion: masses to each other, and the components of the line of centres.

use super::Impact;
use crate::number::{Fraction, Value};

/// Masses and line of centres in rational proportion, and a rational e.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Proportions {
    /// Masses in the ratio of those given.
    pub masses: [Fraction; 2],
    /// A vector along the line of centres; which way it points does not matter to the velocities after.
    pub line: [Fraction; 2],
    /// The coefficient of restitution.
    pub e: Fraction,
}

impl Impact<Value> {
    /// The three, if all are rational: 2m and 3m are, and so is the direction of (1, 2)/√5.
    pub(super) fn proportions(&self) -> Option<Proportions> {
        let e = self.restitution.as_fraction()?.clone();
        Some(Proportions { masses: proportion(&self.masses)?, line: proportion(&self.line)?, e })
    }
}

/// Two fractions in the ratio of two values that are not both nought, if there are such.
pub(super) fn proportion([one, other]: &[Value; 2]) -> Option<[Fraction; 2]> {
    if let (Some(one), Some(other)) = (one.as_fraction(), other.as_fraction()) {
        return (!one.is_zero() || !other.is_zero()).then(|| [one.clone(), other.clone()]);
    }
    if one.is_written_zero() {
        return Some([Fraction::ZERO, Fraction::ONE]);
    }
    if other.is_written_zero() {
        return Some([Fraction::ONE, Fraction::ZERO]);
    }
    // Values in normal form are in rational proportion if and only if their terms are, each by the same ratio.
    if one.denominator() != other.denominator() {
        return None;
    }
    let (left, right) = (one.numerator_terms(), other.numerator_terms());
    let mut ratio: Option<Fraction> = None;
    if left.len() != right.len() {
        return None;
    }
    for ((roots, above), (same, below)) in left.iter().zip(right.iter()) {
        if roots != same || above.terms().len() != below.terms().len() {
            return None;
        }
        for ((monomial, p), (same, q)) in above.terms().iter().zip(below.terms()) {
            let quotient = p / q;
            if monomial != same || ratio.as_ref().is_some_and(|ratio| *ratio != quotient) {
                return None;
            }
            ratio = Some(quotient);
        }
    }
    ratio.map(|ratio| [ratio, Fraction::ONE])
}
