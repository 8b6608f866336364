//! Exact values modulo a prime: what holds of them holds of their images, and an image is a machine integer.
//!
//! A value with letters, roots of primes and cosines is mapped by choosing a number for each letter and a root modulo the
//! prime for each root. What is no square there is no square of a value in the same roots: such a value would be whole
//! over the ring that letters, roots and what stands below generate, which is regular where neither 2, nor a prime under a
//! root, nor what stands below vanishes; so it would lie in the ring itself, and its image would be the root.

use dashu_int::IBig;

use super::value::{Root, Value};
use super::{Fraction, Letter, Polynomial, Range};

/// Below 2^31, so that products stay in machine integers; 3 modulo 4, so that a root is a power; and every prime up to 43
/// is a square modulo it.
pub(super) const PRIME: u64 = 2_147_366_399;

/// So many choices of numbers and roots are tried: of values that are no squares one in a thousand passes, and what is a
/// square with other roots, as 2 + √3 is of (√6 + √2)/2. Most are known by the first or the second; to
/// find that one which passes all is none costs as much as a hundred.
const TRIALS: u64 = 10;

/// Is the value proved not to be the square of a value in its own roots and some of those given? Nested roots prove nothing.
pub(super) fn is_no_square(value: &Value, roots: &[Root]) -> bool {
    (1..=TRIALS).any(|trial| {
        let roots: Option<Vec<(&Root, u64)>> = roots
            .iter()
            .enumerate()
            .map(|(place, root)| {
                // Either root will do, and the other is another trial.
                let image = of_root(root, trial)?;
                Some((root, if trial >> place & 1 == 0 { image } else { PRIME - image }))
            })
            .collect();
        roots.and_then(|roots| of_value(value, &roots, trial)).is_some_and(|image| image != 0 && root(image).is_none())
    })
}

fn of_value(value: &Value, roots: &[(&Root, u64)], trial: u64) -> Option<u64> {
    let (terms, denominator) = value.parts();
    let below = of_polynomial(&denominator, trial)?;
    let mut sum = 0;
    for (product, coefficient) in terms.iter() {
        let mut term = of_polynomial(coefficient, trial)?;
        for root in product {
            let (_, image) = roots.iter().find(|(known, _)| *known == root)?;
            term = term * image % PRIME;
        }
        sum = (sum + term) % PRIME;
    }
    Some(sum * inverse(below)? % PRIME)
}

fn of_root(root: &Root, trial: u64) -> Option<u64> {
    match root {
        Root::Prime(prime) => self::root(u64::try_from(prime % u128::from(PRIME)).ok()?).filter(|image| *image != 0),
        // The cosine of the angle whose half has the tangent from which `at` makes that of the angle.
        Root::Cosine(tangent) => {
            let half = spread(*tangent, trial);
            let square = half * half % PRIME;
            Some((1 + PRIME - square) % PRIME * inverse(1 + square)? % PRIME).filter(|image| *image != 0)
        }
        Root::Nested { .. } => None,
    }
}

fn of_polynomial(polynomial: &Polynomial, trial: u64) -> Option<u64> {
    polynomial.terms().iter().try_fold(0, |sum, (monomial, coefficient)| {
        let mut term = of_fraction(coefficient)?;
        for (letter, exponent) in monomial {
            term = term * power(at(*letter, trial)?, u64::from(*exponent)) % PRIME;
        }
        Some((sum + term) % PRIME)
    })
}

/// A fraction modulo the prime; `None` if the prime divides its denominator.
pub(super) fn of_fraction(fraction: &Fraction) -> Option<u64> {
    let (above, below) = match fraction.as_small() {
        Some((above, below)) => {
            let prime = PRIME as i64;
            (above.rem_euclid(prime).unsigned_abs(), below.rem_euclid(prime).unsigned_abs())
        }
        None => (of_integer(fraction.numerator()), of_integer(fraction.denominator())),
    };
    if below == 1 { Some(above) } else { Some(above * inverse(below)? % PRIME) }
}

fn of_integer(number: IBig) -> u64 {
    let rest = number % IBig::from(PRIME);
    let positive = if rest < IBig::ZERO { rest + IBig::from(PRIME) } else { rest };
    u64::try_from(positive).unwrap_or(0)
}

/// A number for a letter: for a tangent one of an angle whose cosine exists modulo the prime.
fn at(letter: Letter, trial: u64) -> Option<u64> {
    let spread = spread(letter, trial);
    match letter.range() {
        Range::Acute | Range::Degrees => {
            Some(2 * spread % PRIME * inverse(1 + PRIME - spread * spread % PRIME)? % PRIME)
        }
        _ => Some(spread),
    }
}

/// A number for a letter in a trial, spread over all numbers by its name.
pub(super) fn spread(letter: Letter, trial: u64) -> u64 {
    letter.name().bytes().fold(trial * 0x9E37, |sum, byte| (sum * 1_000_003 + u64::from(byte) + 1) % PRIME)
}

/// One over a number; `None` for nought.
pub(super) fn inverse(number: u64) -> Option<u64> {
    let number = number % PRIME;
    (number != 0).then(|| power(number, PRIME - 2))
}

/// A square root, if there is one.
fn root(number: u64) -> Option<u64> {
    let root = power(number, PRIME.div_ceil(4));
    (root * root % PRIME == number % PRIME).then_some(root)
}

pub(super) fn power(base: u64, mut exponent: u64) -> u64 {
    let (mut base, mut result) = (base % PRIME, 1);
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = result * base % PRIME;
        }
        base = base * base % PRIME;
        exponent /= 2;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prime_is_what_it_is_said_to_be() {
        assert!((2..50_000).all(|number| !PRIME.is_multiple_of(number)));
        assert_eq!(PRIME % 4, 3);
        for prime in [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43] {
            assert!(root(prime).is_some(), "{prime}");
        }
        // Of a number and its opposite one is a square, for -1 is none.
        for number in 1..1000 {
            assert_ne!(root(number).is_some(), root(PRIME - number).is_some(), "{number}");
        }
    }

    fn surd(number: i64) -> Value {
        Value::from(number).square_root().unwrap()
    }

    fn letter(name: &str, range: Range) -> Value {
        Value::letter(Letter::new(name, range).unwrap())
    }

    /// Values in roots, letters and given angles, and those that are no squares.
    fn values() -> [Vec<Value>; 2] {
        let (x, u) = (letter("x", Range::Real), letter("u", Range::Positive));
        let angle = |name| Letter::new(name, Range::Degrees).unwrap();
        let (cos, sin) = (Value::cosine(angle("20")), Value::sine(angle("55")));
        let some = vec![
            &surd(3) * &Value::fraction(7, 2),
            &surd(2) + &surd(3),
            &(&surd(2) + &surd(43)) - &surd(5),
            &(&cos * &Value::from(5)) + &sin,
            &(&cos * &u) - &(&surd(3) * &x),
            (&cos + &x).divided_by(&(&u + &Value::from(3))).unwrap(),
            &(&Value::cosine(angle("55")) + &cos) - &surd(7),
        ];
        let no_squares = vec![
            &Value::from(1) + &surd(3),
            &surd(6) - &Value::ONE,
            x.clone(),
            &surd(2) * &(&x * &x),
            &Value::from(2) + &cos,
            &(&cos * &sin) + &Value::from(41),
        ];
        [some, no_squares]
    }

    #[test]
    fn a_square_is_never_called_none() {
        for value in values().concat() {
            let square = &value * &value;
            assert!(!is_no_square(&square, &value.roots()), "{value:?}");
            assert!(!is_no_square(&square.reciprocal().unwrap(), &value.roots()), "{value:?}");
        }
    }

    #[test]
    fn what_is_no_square_is_known_for_it() {
        for value in &values()[1] {
            assert!(is_no_square(value, &value.roots()), "{value:?}");
        }
    }
}
