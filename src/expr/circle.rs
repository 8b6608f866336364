//! sin² + cos² = 1 in what is written: of the ways to write a sum, the one with the fewest terms.
//!
//! A value keeps each angle as its tangent, and knows of it that the circle closes. Between two angles a
//! sum stays in pieces, though: cos² α cos² β + cos² α sin² β has two terms above one denominator.

use super::term::{Circular, Term};
use crate::number::{Fraction, Letter};

/// The terms in the fewest that sin² + cos² = 1 leaves, as they are where nothing is shorter.
pub(super) fn fewest(mut terms: Vec<Term>) -> Vec<Term> {
    let mut angles: Vec<Letter> = terms.iter().flat_map(|term| term.circular.keys().map(|(angle, _)| *angle)).collect();
    angles.sort();
    angles.dedup();
    // A shorter sum in one angle may bring like terms in another one together; each turn leaves fewer.
    loop {
        let before = terms.len();
        for angle in &angles {
            for (square, other) in [(Circular::Sin, Circular::Cos), (Circular::Cos, Circular::Sin)] {
                let without = without_square(&terms, (*angle, square), (*angle, other));
                if without.len() < terms.len() {
                    terms = without;
                }
            }
        }
        if terms.len() == before {
            return terms;
        }
    }
}

/// One less the square of the other in place of each square of a sine or cosine.
fn without_square(terms: &[Term], square: (Letter, Circular), other: (Letter, Circular)) -> Vec<Term> {
    let mut sum: Vec<Term> = Vec::new();
    for term in terms {
        let power = term.circular.get(&square).copied().unwrap_or(0);
        let mut part = term.clone();
        part.raise(square, power % 2);
        let raised = part.circular.get(&other).copied().unwrap_or(0);
        // (1 - x²)^n: each coefficient of the binomial from the one before.
        let count = i64::from(power / 2);
        for step in 0..=count {
            add(&mut sum, &part);
            part.raise(other, raised + 2 * (step as u32 + 1));
            part.number = &part.number * &Fraction::new(step - count, step + 1);
        }
    }
    sum.retain(|term| !term.number.is_zero());
    sum
}

/// Adds a term to its like, or after all others.
fn add(sum: &mut Vec<Term>, term: &Term) {
    match sum.iter_mut().find(|other| other.is_like(term)) {
        Some(like) => like.number = &like.number + &term.number,
        None => sum.push(term.clone()),
    }
}
