//! Polynomials in letters with rational coefficients.
//!
//! Terms are kept sorted and without noughts, so equal polynomials are equal as data.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use smallvec::{SmallVec, smallvec};

use super::{Fraction, Letter};

/// A product of powers of letters, sorted by letter, exponents positive.
pub type Monomial = Vec<(Letter, u32)>;

/// A polynomial in letters with rational coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Polynomial {
    // Most polynomials of an exam are numbers, and those should cost no memory of their own.
    terms: SmallVec<[(Monomial, Fraction); 1]>,
}

impl Polynomial {
    /// Nought.
    pub fn zero() -> Polynomial {
        Polynomial::default()
    }

    /// One.
    pub fn one() -> Polynomial {
        Polynomial::constant(Fraction::ONE)
    }

    /// A number.
    pub fn constant(value: Fraction) -> Polynomial {
        if value.is_zero() { Polynomial::zero() } else { Polynomial { terms: smallvec![(Vec::new(), value)] } }
    }

    /// A letter.
    pub fn letter(letter: Letter) -> Polynomial {
        Polynomial { terms: smallvec![(vec![(letter, 1)], Fraction::ONE)] }
    }

    /// One plus the square of a tangent: one over the square of the cosine.
    pub fn one_plus_square(tangent: Letter) -> Polynomial {
        Polynomial { terms: smallvec![(Vec::new(), Fraction::ONE), (vec![(tangent, 2)], Fraction::ONE)] }
    }

    /// A product of powers of letters.
    pub(crate) fn monomial(monomial: Monomial) -> Polynomial {
        Polynomial { terms: smallvec![(monomial, Fraction::ONE)] }
    }

    /// Collects terms, adding those with the same monomial.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, Fraction)>) -> Polynomial {
        let mut terms: SmallVec<[(Monomial, Fraction); 4]> = terms.into_iter().collect();
        terms.sort_by(|a, b| order(&a.0, &b.0));
        let mut kept = SmallVec::<[(Monomial, Fraction); 1]>::new();
        for (monomial, coefficient) in terms {
            match kept.last_mut() {
                Some((last, sum)) if *last == monomial => *sum = &*sum + &coefficient,
                _ => kept.push((monomial, coefficient)),
            }
        }
        kept.retain(|(_, coefficient)| !coefficient.is_zero());
        Polynomial { terms: kept }
    }

    /// The terms, sorted by monomial.
    pub fn terms(&self) -> &[(Monomial, Fraction)] {
        &self.terms
    }

    /// Is it nought?
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its value, if there is no letter in it.
    pub fn as_constant(&self) -> Option<Fraction> {
        if self.is_zero() { Some(Fraction::ZERO) } else { self.as_number().cloned() }
    }

    /// The same of what is not nought.
    pub(super) fn as_number(&self) -> Option<&Fraction> {
        match self.terms.as_slice() {
            [(monomial, value)] if monomial.is_empty() => Some(value),
            _ => None,
        }
    }

    /// Is it one?
    pub fn is_one(&self) -> bool {
        matches!(self.terms.as_slice(), [(monomial, value)] if monomial.is_empty() && value.is_one())
    }

    /// Its letters, sorted.
    pub fn letters(&self) -> Vec<Letter> {
        let mut letters = Vec::new();
        for (letter, _) in self.terms.iter().flat_map(|(monomial, _)| monomial) {
            if !letters.contains(letter) {
                letters.push(*letter);
            }
        }
        letters.sort();
        letters
    }

    /// The highest power of a letter in it.
    pub fn degree(&self, letter: Letter) -> u32 {
        self.terms.iter().map(|(monomial, _)| exponent(monomial, letter)).max().unwrap_or(0)
    }

    /// Every coefficient multiplied by a number.
    pub fn scaled(&self, factor: &Fraction) -> Polynomial {
        if factor.is_zero() {
            return Polynomial::zero();
        }
        Polynomial { terms: self.terms.iter().map(|(m, c)| (m.clone(), c * factor)).collect() }
    }

    /// A whole power.
    pub fn power(&self, exponent: u32) -> Polynomial {
        (0..exponent).fold(Polynomial::one(), |product, _| &product * self)
    }

    /// The coefficients of the powers 0, 1, 2, … of a letter.
    pub fn coefficients(&self, letter: Letter) -> Vec<Polynomial> {
        let mut coefficients: Vec<Polynomial> = (0..=self.degree(letter)).map(|_| Polynomial::zero()).collect();
        for (monomial, value) in &self.terms {
            let power = exponent(monomial, letter);
            let rest = monomial.iter().filter(|(other, _)| *other != letter).copied().collect();
            // Products with the same power of the letter keep their order without it.
            coefficients[power as usize].terms.push((rest, value.clone()));
        }
        coefficients
    }

    /// The polynomial whose coefficients of the powers 0, 1, 2, … of a letter are given.
    pub fn from_coefficients(letter: Letter, coefficients: &[Polynomial]) -> Polynomial {
        let shifted = coefficients.iter().enumerate().flat_map(|(power, coefficient)| {
            coefficient.terms.iter().map(move |(monomial, value)| {
                (product(monomial, &if power == 0 { vec![] } else { vec![(letter, power as u32)] }), value.clone())
            })
        });
        Polynomial::from_terms(shifted)
    }

    /// The polynomial with a number in place of a letter.
    pub(crate) fn with(&self, letter: Letter, number: &Fraction) -> Polynomial {
        Polynomial::from_terms(self.terms.iter().map(|(monomial, coefficient)| {
            let rest = monomial.iter().filter(|(other, _)| *other != letter).copied().collect();
            let powers = 0..exponent(monomial, letter);
            (rest, powers.fold(coefficient.clone(), |product, _| &product * number))
        }))
    }

    /// The rate of change with a letter.
    pub fn derivative(&self, letter: Letter) -> Polynomial {
        let lowered = self.terms.iter().filter_map(|(monomial, coefficient)| {
            let power = exponent(monomial, letter);
            let lower = |(own, power): &(Letter, u32)| {
                let power = power - u32::from(*own == letter);
                (power > 0).then_some((*own, power))
            };
            let factor = Fraction::from(i64::from(power));
            (power > 0).then(|| (monomial.iter().filter_map(lower).collect(), coefficient * &factor))
        });
        Polynomial::from_terms(lowered)
    }

    /// The positive number that leaves coprime whole coefficients when divided out; one for nought.
    pub fn content(&self) -> Fraction {
        let numbers = self.terms.iter().map(|(_, number)| number);
        let shared = numbers.fold(Fraction::ZERO, |shared, number| shared.common_measure(number));
        if shared.is_zero() { Fraction::ONE } else { shared }
    }

    /// Whole coprime coefficients, the last term's positive.
    pub fn primitive(&self) -> Polynomial {
        if let [(monomial, _)] = self.terms.as_slice() {
            return Polynomial { terms: smallvec![(monomial.clone(), Fraction::ONE)] };
        }
        let Some((_, last)) = self.terms.last() else { return Polynomial::zero() };
        let content = self.content();
        let signed = if last.sign().is_lt() { -content } else { content };
        self.scaled(&signed.reciprocal().expect("a content is not nought"))
    }
}

/// The order of monomials: the first letter of the alphabet in which they differ decides. It is kept by
/// multiplication, so that the last term of a product is the product of the last terms.
fn order(a: &Monomial, b: &Monomial) -> Ordering {
    for (x, y) in a.iter().zip(b) {
        match (x.0.cmp(&y.0), x.1.cmp(&y.1)) {
            (Ordering::Equal, Ordering::Equal) => {}
            (Ordering::Equal, powers) => return powers,
            (letters, _) => return letters.reverse(),
        }
    }
    a.len().cmp(&b.len())
}

fn exponent(monomial: &Monomial, letter: Letter) -> u32 {
    monomial.iter().find(|(other, _)| *other == letter).map_or(0, |(_, power)| *power)
}

/// The product of two monomials.
pub(crate) fn product(a: &Monomial, b: &Monomial) -> Monomial {
    let mut result = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        match a[i].0.cmp(&b[j].0) {
            Ordering::Less => (result.push(a[i]), i += 1).1,
            Ordering::Greater => (result.push(b[j]), j += 1).1,
            Ordering::Equal => {
                result.push((a[i].0, a[i].1 + b[j].1));
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    result.extend_from_slice(&a[i..]);
    result.extend_from_slice(&b[j..]);
    result
}

/// The quotient of two monomials, if the second divides the first.
pub(crate) fn quotient(a: &Monomial, b: &Monomial) -> Option<Monomial> {
    let mut result = a.clone();
    for (letter, power) in b {
        let position = result.iter().position(|(other, _)| other == letter)?;
        result[position].1 = result[position].1.checked_sub(*power)?;
    }
    result.retain(|(_, power)| *power > 0);
    Some(result)
}

/// The greatest monomial that divides every term of every polynomial given.
pub(crate) fn shared_monomial<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Monomial {
    let mut monomials = polynomials.into_iter().flat_map(|p| p.terms.iter().map(|(monomial, _)| monomial));
    let mut shared = monomials.next().cloned().unwrap_or_default();
    for monomial in monomials {
        for (letter, power) in &mut shared {
            *power = (*power).min(exponent(monomial, *letter));
        }
        shared.retain(|(_, power)| *power > 0);
        if shared.is_empty() {
            break;
        }
    }
    shared
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let mut terms = SmallVec::new();
        let (mut a, mut b) = (self.terms.iter().peekable(), other.terms.iter().peekable());
        loop {
            match (a.peek(), b.peek()) {
                (Some(x), Some(y)) if x.0 == y.0 => {
                    let sum = &x.1 + &y.1;
                    if !sum.is_zero() {
                        terms.push((x.0.clone(), sum));
                    }
                    a.next();
                    b.next();
                }
                (Some(x), Some(y)) if order(&x.0, &y.0).is_gt() => {
                    terms.push((*y).clone());
                    b.next();
                }
                (Some(x), _) => {
                    terms.push((*x).clone());
                    a.next();
                }
                (None, Some(y)) => {
                    terms.push((*y).clone());
                    b.next();
                }
                (None, None) => return Polynomial { terms },
            }
        }
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        if self.is_one() {
            return other.clone();
        }
        if other.is_one() {
            return self.clone();
        }
        if let ([(m, c)], [(n, d)]) = (self.terms(), other.terms()) {
            return Polynomial { terms: smallvec![(product(m, n), c * d)] };
        }
        let products = |(m, c)| other.terms.iter().map(move |(n, d)| (product(m, n), c * d));
        Polynomial::from_terms(self.terms.iter().flat_map(|(m, c)| products((m, c))))
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial { terms: self.terms.iter().map(|(m, c)| (m.clone(), -c.clone())).collect() }
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        self + &-other
    }
}
