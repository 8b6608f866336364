//! Two polynomials without a common factor, told by their remainders at a point: quick, and never wrong.
//!
//! Let g be the greatest common divisor. Replace every letter but one by a number, modulo a prime, so that the
//! leading coefficient of the first polynomial in that letter does not vanish. It is a multiple of that of g, so g
//! keeps its degree, and what becomes of g divides what becomes of both. If these have no common factor, g has
//! degree nought in that letter; and if that is so for each letter, g is a number. Where the test says nothing, the
//! polynomials may have a common factor or may have been unlucky, and Euclid's algorithm decides.

use super::residue::{PRIME, inverse, of_fraction, power, spread};
use super::{Letter, Polynomial};

/// Which of the points that [`spread`] has. One is enough: of polynomials without a common factor it is unlucky with one pair in
/// a thousand million.
const POINT: u64 = 1;

/// The letters that a common factor of the polynomials may have, and those that are proved to be in none. A factor without
/// a letter divides each coefficient in it.
pub(super) fn letters_of_common_factors(a: &Polynomial, b: &Polynomial) -> (Vec<Letter>, Vec<Letter>) {
    let (of_a, of_b) = (a.letters(), b.letters());
    let is_in_one = |letter: &Letter| of_a.contains(letter) != of_b.contains(letter);
    let is_absent = |letter: &Letter| is_in_one(letter) || coprime_in(a, b, *letter);
    let mut all: Vec<Letter> = of_a.iter().chain(&of_b).copied().collect();
    all.sort();
    all.dedup();
    let (absent, possible) = all.into_iter().partition(is_absent);
    (possible, absent)
}

fn coprime_in(a: &Polynomial, b: &Polynomial, letter: Letter) -> bool {
    let (Some(a), Some(b)) = (image(a, letter), image(b, letter)) else { return false };
    // What the first loses in degree its divisors might lose too; the second may lose what it likes.
    a.last().is_some_and(|lead| *lead != 0) && remainder_degree(a, b) == Some(0)
}

/// The coefficients modulo the prime, lowest first, with numbers for all other letters; `None` if the prime
/// divides a denominator.
fn image(polynomial: &Polynomial, letter: Letter) -> Option<Vec<u64>> {
    let mut image = vec![0; polynomial.degree(letter) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let mut value = of_fraction(coefficient)?;
        let mut place = 0;
        for (other, exponent) in monomial {
            if *other == letter {
                place = *exponent as usize;
            } else {
                value = value * power(spread(*other, POINT), u64::from(*exponent)) % PRIME;
            }
        }
        image[place] = (image[place] + value) % PRIME;
    }
    Some(image)
}

/// The degree of the greatest common divisor of two polynomials modulo the prime; `None` if both are nought.
fn remainder_degree(mut a: Vec<u64>, mut b: Vec<u64>) -> Option<usize> {
    loop {
        while b.last() == Some(&0) {
            b.pop();
        }
        let Some(lead) = b.last() else { return a.len().checked_sub(1) };
        let inverse = inverse(*lead)?;
        while a.len() >= b.len() {
            let shift = a.len() - b.len();
            let factor = a.last().map_or(0, |top| top * inverse % PRIME);
            for (index, coefficient) in b.iter().enumerate() {
                a[shift + index] = (a[shift + index] + PRIME - factor * coefficient % PRIME) % PRIME;
            }
            a.pop();
        }
        while a.last() == Some(&0) {
            a.pop();
        }
        (a, b) = (b, a);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Fraction, Range};

    fn coprime(a: &Polynomial, b: &Polynomial) -> bool {
        letters_of_common_factors(a, b).0.is_empty()
    }

    fn letter(name: &str) -> Polynomial {
        Polynomial::letter(Letter::new(name, Range::Positive).unwrap())
    }

    fn plus(p: &Polynomial, number: i64) -> Polynomial {
        p + &Polynomial::constant(Fraction::from(number))
    }

    #[test]
    fn polynomials_with_a_common_factor_are_never_called_coprime() {
        let (x, y) = (letter("x"), letter("y"));
        let factors = [plus(&x, 1), plus(&y, -2), &x + &y, plus(&(&x * &y), 3), &(&x * &x) + &plus(&y, 1), x, y];
        for common in &factors {
            for p in &factors {
                for q in &factors {
                    assert!(!coprime(&(common * p), &(common * q)), "{common:?} {p:?} {q:?}");
                    let apart = p != q && coprime(p, q);
                    assert_eq!(apart, p != q, "{p:?} {q:?}");
                }
            }
        }
    }

    #[test]
    fn a_prime_in_a_denominator_or_a_leading_coefficient_proves_nothing() {
        let x = letter("x");
        let prime = Fraction::from(i64::try_from(PRIME).unwrap());
        let below = plus(&x, 1).scaled(&prime.reciprocal().unwrap());
        assert!(!coprime(&below, &plus(&x, 2)));
        let leading = plus(&x.scaled(&prime), 1);
        assert!(!coprime(&leading, &plus(&x, 2)));
    }
}
