//! Polynomials in letters with rational coefficients, and their greatest common divisor.
//!
//! Terms are kept sorted and without noughts, so equal polynomials are equal as data. Division and
//! the greatest common divisor see a polynomial as one in its last letter, whose coefficients are
//! polynomials in the others.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;
use dashu_int::ops::{Abs, Gcd};

use super::coprime::coprime;
use super::{Fraction, Letter};

/// A product of powers of letters, sorted by letter, exponents positive.
pub type Monomial = Vec<(Letter, u32)>;

/// A polynomial in letters with rational coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Polynomial {
    terms: Vec<(Monomial, Fraction)>,
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
        if value.is_zero() { Polynomial::zero() } else { Polynomial { terms: vec![(Vec::new(), value)] } }
    }

    /// A letter.
    pub fn letter(letter: Letter) -> Polynomial {
        Polynomial { terms: vec![(vec![(letter, 1)], Fraction::ONE)] }
    }

    /// One plus the square of a tangent: one over the square of the cosine.
    pub fn one_plus_square(tangent: Letter) -> Polynomial {
        Polynomial { terms: vec![(Vec::new(), Fraction::ONE), (vec![(tangent, 2)], Fraction::ONE)] }
    }

    /// Collects terms, adding those with the same monomial.
    pub fn from_terms(mut terms: Vec<(Monomial, Fraction)>) -> Polynomial {
        terms.sort_by(|a, b| order(&a.0, &b.0));
        let mut kept: Vec<(Monomial, Fraction)> = Vec::with_capacity(terms.len());
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
        match self.terms.as_slice() {
            [] => Some(Fraction::ZERO),
            [(monomial, value)] if monomial.is_empty() => Some(value.clone()),
            _ => None,
        }
    }

    /// Is it one?
    pub fn is_one(&self) -> bool {
        matches!(self.terms.as_slice(), [(monomial, value)] if monomial.is_empty() && value.is_one())
    }

    /// Its letters, sorted.
    pub fn letters(&self) -> Vec<Letter> {
        let mut letters: Vec<Letter> =
            self.terms.iter().flat_map(|(m, _)| m.iter().map(|(letter, _)| *letter)).collect();
        letters.sort();
        letters.dedup();
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
        let mut coefficients = vec![Vec::new(); self.degree(letter) as usize + 1];
        for (monomial, value) in &self.terms {
            let power = exponent(monomial, letter);
            let rest = monomial.iter().filter(|(other, _)| *other != letter).copied().collect();
            coefficients[power as usize].push((rest, value.clone()));
        }
        coefficients.into_iter().map(Polynomial::from_terms).collect()
    }

    /// The polynomial whose coefficients of the powers 0, 1, 2, … of a letter are given.
    pub fn from_coefficients(letter: Letter, coefficients: &[Polynomial]) -> Polynomial {
        let shifted = coefficients.iter().enumerate().flat_map(|(power, coefficient)| {
            coefficient.terms.iter().map(move |(monomial, value)| {
                (product(monomial, &if power == 0 { vec![] } else { vec![(letter, power as u32)] }), value.clone())
            })
        });
        Polynomial::from_terms(shifted.collect())
    }

    /// The rate of change with a letter.
    pub fn derivative(&self, letter: Letter) -> Polynomial {
        let coefficients = self.coefficients(letter);
        let lowered: Vec<Polynomial> = coefficients
            .iter()
            .enumerate()
            .skip(1)
            .map(|(power, coefficient)| coefficient.scaled(&Fraction::from(power as i64)))
            .collect();
        Polynomial::from_coefficients(letter, &lowered)
    }

    /// The positive number that leaves coprime whole coefficients when divided out; one for nought.
    pub fn content(&self) -> Fraction {
        let mut numerator = IBig::ZERO;
        let mut denominator = IBig::ONE;
        for (_, value) in &self.terms {
            let (n, d) = (value.numerator().abs(), value.denominator());
            numerator = if numerator == IBig::ZERO { n } else { numerator.gcd(n).into() };
            let shared: IBig = (&denominator).gcd(&d).into();
            denominator = denominator / shared * d;
        }
        if numerator == IBig::ZERO {
            return Fraction::ONE;
        }
        Fraction::from_integers(numerator, denominator).expect("a product of denominators is positive")
    }

    /// Whole coprime coefficients, the last term's positive.
    pub fn primitive(&self) -> Polynomial {
        if let [(monomial, _)] = self.terms.as_slice() {
            return Polynomial { terms: vec![(monomial.clone(), Fraction::ONE)] };
        }
        let Some((_, last)) = self.terms.last() else { return Polynomial::zero() };
        let content = self.content();
        let signed = if last.sign().is_lt() { -content } else { content };
        self.scaled(&signed.reciprocal().expect("a content is not nought"))
    }

    /// The quotient where the division leaves nothing, `None` where it does (or by nought).
    pub fn divided_by(&self, divisor: &Polynomial) -> Option<Polynomial> {
        if let Some(number) = divisor.as_constant() {
            return Some(self.scaled(&number.reciprocal()?));
        }
        if self.is_zero() {
            return Some(Polynomial::zero());
        }
        if let [(monomial, coefficient)] = divisor.terms.as_slice() {
            let inverse = coefficient.reciprocal()?;
            let terms: Option<Vec<_>> =
                self.terms.iter().map(|(m, c)| Some((quotient(m, monomial)?, c * &inverse))).collect();
            return terms.map(Polynomial::from_terms);
        }
        let letter = *divisor.letters().last()?;
        let (mut rest, below) = (self.coefficients(letter), divisor.coefficients(letter));
        if rest.len() < below.len() {
            return None;
        }
        let lead = below.last()?;
        let mut result = vec![Polynomial::zero(); rest.len() - below.len() + 1];
        for shift in (0..result.len()).rev() {
            let factor = rest[shift + below.len() - 1].divided_by(lead)?;
            for (index, coefficient) in below.iter().enumerate() {
                rest[shift + index] = &rest[shift + index] - &(&factor * coefficient);
            }
            result[shift] = factor;
        }
        rest.iter().all(Polynomial::is_zero).then(|| Polynomial::from_coefficients(letter, &result))
    }

    /// The greatest common divisor, primitive; nought only for two noughts.
    pub fn greatest_common_divisor(&self, other: &Polynomial) -> Polynomial {
        if self.is_zero() {
            return other.primitive();
        }
        if other.is_zero() {
            return self.primitive();
        }
        if self.as_constant().is_some() || other.as_constant().is_some() {
            return Polynomial::one();
        }
        if self.terms.len() == 1 || other.terms.len() == 1 {
            return Polynomial { terms: vec![(shared_monomial([self, other]), Fraction::ONE)] };
        }
        if coprime(self, other) {
            return Polynomial::one();
        }
        let last = self.letters().last().copied().max(other.letters().last().copied());
        let letter = last.expect("a polynomial that is no constant has a letter");
        let (content_a, mut a) = self.split_content(letter);
        let (content_b, mut b) = other.split_content(letter);
        let content = content_a.greatest_common_divisor(&content_b);
        if a.degree(letter) < b.degree(letter) {
            (a, b) = (b, a);
        }
        // Euclid's algorithm; taking out the content after each step keeps the coefficients small.
        while !b.is_zero() {
            if b.degree(letter) == 0 {
                return content;
            }
            let rest = a.pseudo_remainder(&b, letter);
            (a, b) = (b, rest.split_content(letter).1);
        }
        (&content * &a).primitive()
    }

    /// The greatest common divisor of the coefficients in a letter, and the polynomial without it.
    fn split_content(&self, letter: Letter) -> (Polynomial, Polynomial) {
        let content = self.coefficients(letter).iter().fold(Polynomial::zero(), |shared, coefficient| {
            if shared.is_one() { shared } else { shared.greatest_common_divisor(coefficient) }
        });
        if self.is_zero() {
            return (Polynomial::one(), Polynomial::zero());
        }
        let rest = self.divided_by(&content).expect("a content divides its polynomial");
        (content, rest.primitive())
    }

    /// The remainder of a multiple of `self` that can be divided without fractions.
    fn pseudo_remainder(&self, divisor: &Polynomial, letter: Letter) -> Polynomial {
        let below = divisor.coefficients(letter);
        let lead = below.last().expect("a divisor has a leading coefficient");
        let mut rest = self.coefficients(letter);
        while rest.len() >= below.len() {
            let top = rest.pop().expect("the loop condition keeps at least one coefficient");
            let shift = rest.len() + 1 - below.len();
            for coefficient in &mut rest {
                *coefficient = &*coefficient * lead;
            }
            for (index, coefficient) in below[..below.len() - 1].iter().enumerate() {
                rest[shift + index] = &rest[shift + index] - &(&top * coefficient);
            }
            while rest.last().is_some_and(Polynomial::is_zero) {
                rest.pop();
            }
        }
        Polynomial::from_coefficients(letter, &rest)
    }

    /// Pairwise coprime factors without repeated factors, each with its power, and the number that
    /// is left over: `self = number * product of factor^power`.
    pub fn square_free(&self) -> (Fraction, Vec<(Polynomial, u32)>) {
        let mut factors = Vec::new();
        let mut rest = self.clone();
        let shared = shared_monomial([self]);
        for (letter, power) in &shared {
            factors.push((Polynomial::letter(*letter), *power));
        }
        if !shared.is_empty() {
            rest = rest
                .divided_by(&Polynomial { terms: vec![(shared, Fraction::ONE)] })
                .expect("a shared monomial divides");
        }
        while let Some(letter) = rest.letters().last().copied() {
            // What does not contain the letter is a content, and is split in a later turn.
            let (content, part) = rest.split_content(letter);
            let scale =
                rest.divided_by(&(&content * &part)).and_then(|unit| unit.as_constant()).unwrap_or(Fraction::ONE);
            split_powers(part, letter, &mut factors);
            rest = content.scaled(&scale);
        }
        (rest.as_constant().expect("no letter is left"), factors)
    }
}

/// Yun's algorithm on a polynomial that is primitive in the letter.
fn split_powers(part: Polynomial, letter: Letter, factors: &mut Vec<(Polynomial, u32)>) {
    let exact = |a: &Polynomial, b: &Polynomial| a.divided_by(b).expect("a common divisor divides");
    let slope = part.derivative(letter);
    let repeated = part.greatest_common_divisor(&slope);
    let mut simple = exact(&part, &repeated);
    let mut change = &exact(&slope, &repeated) - &simple.derivative(letter);
    let mut power = 1;
    while simple.as_constant().is_none() {
        let factor = simple.greatest_common_divisor(&change);
        simple = exact(&simple, &factor);
        change = &exact(&change, &factor) - &simple.derivative(letter);
        if factor.as_constant().is_none() {
            factors.push((factor, power));
        }
        power += 1;
    }
    // `simple` has become one: input and factors are primitive, and so is each product of them.
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

fn quotient(a: &Monomial, b: &Monomial) -> Option<Monomial> {
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
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
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
        let mut terms = Vec::with_capacity(self.terms.len() * other.terms.len());
        for (m, c) in &self.terms {
            for (n, d) in &other.terms {
                terms.push((product(m, n), c * d));
            }
        }
        Polynomial::from_terms(terms)
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

#[cfg(test)]
mod tests {
    use super::super::Range;
    use super::*;

    fn letter(name: &str) -> Polynomial {
        Polynomial::letter(Letter::new(name, Range::Positive).unwrap())
    }

    fn number(value: i64) -> Polynomial {
        Polynomial::constant(value.into())
    }

    #[test]
    fn a_shared_factor_is_found_whatever_else_is_there() {
        let (a, b, c) = (letter("a"), letter("b"), letter("c"));
        let shared = &(&a * &b) + &number(3);
        let left = &(&shared * &(&a - &c)) * &(&b + &number(1));
        let right = &(&shared * &(&a + &c)) * &(&c - &number(2));
        assert_eq!(left.greatest_common_divisor(&right), shared);
        assert_eq!((&a + &b).greatest_common_divisor(&(&a - &b)), Polynomial::one());
        assert_eq!((&a * &b).greatest_common_divisor(&(&(&a * &a) + &(&a * &c))), a);
    }

    #[test]
    fn division_is_exact_or_refused() {
        let (a, b) = (letter("a"), letter("b"));
        let sum = &a + &b;
        let square = &sum * &sum;
        assert_eq!(square.divided_by(&sum), Some(sum.clone()));
        assert_eq!(square.divided_by(&(&a - &b)), None);
        assert_eq!(square.divided_by(&Polynomial::zero()), None);
    }

    #[test]
    fn repeated_factors_are_told_apart() {
        let (a, b) = (letter("a"), letter("b"));
        let polynomial = (&(&(&a + &b).power(2) * &(&a - &number(1))) * &a.power(3)).scaled(&Fraction::new(-5, 2));
        let (number, factors) = polynomial.square_free();
        let mut back = Polynomial::constant(number);
        for (factor, power) in &factors {
            back = &back * &factor.power(*power);
        }
        assert_eq!(back, polynomial);
        assert!(factors.contains(&(&a + &b, 2)), "{factors:?}");
        assert!(factors.contains(&(a, 3)), "{factors:?}");
    }
}
