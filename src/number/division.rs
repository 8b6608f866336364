//! Division of polynomials, their greatest common divisor, and their factors without repetition.
//!
//! All three see a polynomial as one in its last letter, whose coefficients are polynomials in the
//! other letters.

use super::coprime::letters_of_common_factors;
use super::polynomial::{quotient, shared_monomial};
use super::{Fraction, Letter, Polynomial};

impl Polynomial {
    /// The quotient where the division leaves nothing, `None` where it does (or by nought).
    pub fn divided_by(&self, divisor: &Polynomial) -> Option<Polynomial> {
        if let Some(number) = divisor.as_constant() {
            return Some(self.scaled(&number.reciprocal()?));
        }
        if self.is_zero() {
            return Some(Polynomial::zero());
        }
        if let [(monomial, coefficient)] = divisor.terms() {
            let inverse = coefficient.reciprocal()?;
            let terms: Option<Vec<_>> =
                self.terms().iter().map(|(m, c)| Some((quotient(m, monomial)?, c * &inverse))).collect();
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
        if self.terms().len() == 1 || other.terms().len() == 1 {
            return Polynomial::monomial(shared_monomial([self, other]));
        }
        let (possible, absent) = letters_of_common_factors(self, other);
        let Some(letter) = possible.last().copied() else { return Polynomial::one() };
        if let Some(absent) = absent.first() {
            let mut coefficients = [self, other].map(|polynomial| polynomial.coefficients(*absent)).concat();
            return common_factor(&mut coefficients);
        }
        // Where there is a common factor it is as a rule all of the shorter one, or 1 + t², from cos² = 1/(1 + t²). To divide is
        // quick, and what is left has nothing in common.
        let (short, long) = if self.terms().len() <= other.terms().len() { (self, other) } else { (other, self) };
        if long.divided_by(short).is_some() {
            return short.primitive();
        }
        for circle in possible.iter().map(|letter| Polynomial::one_plus_square(*letter)) {
            if let Some((a, b)) = self.divided_by(&circle).zip(other.divided_by(&circle)) {
                return (&circle * &a.greatest_common_divisor(&b)).primitive();
            }
        }
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
        if self.is_zero() {
            return (Polynomial::one(), Polynomial::zero());
        }
        let content = common_factor(&mut self.coefficients(letter));
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
        if let Some(scale) = scale_of_linear(self) {
            return (scale, vec![(self.primitive(), 1)]);
        }
        let mut factors = Vec::new();
        let mut rest = self.clone();
        let shared = shared_monomial([self]);
        for (letter, power) in &shared {
            factors.push((Polynomial::letter(*letter), *power));
        }
        if !shared.is_empty() {
            rest = rest.divided_by(&Polynomial::monomial(shared)).expect("a shared monomial divides");
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

/// Of what is linear in its one letter, as `4e - 6`, by what its primitive part, which has no factors, is multiplied.
fn scale_of_linear(polynomial: &Polynomial) -> Option<Fraction> {
    match polynomial.terms() {
        [(none, _), (one, coefficient)] if none.is_empty() && matches!(one[..], [(_, 1)]) => {
            Some(coefficient / &polynomial.primitive().terms().last()?.1)
        }
        _ => None,
    }
}

/// What coefficients have in common: as a rule nothing, and then two of the shortest show it.
fn common_factor(coefficients: &mut [Polynomial]) -> Polynomial {
    coefficients.sort_by_key(|coefficient| coefficient.terms().len());
    coefficients.iter().fold(Polynomial::zero(), |common, coefficient| {
        if common.is_one() { common } else { common.greatest_common_divisor(coefficient) }
    })
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
    fn a_factor_that_is_a_whole_polynomial_or_a_circle_is_found() {
        let (a, b, c) = (letter("a"), letter("b"), letter("c"));
        let circle = |letter: &Polynomial| &(letter * letter) + &number(1);
        let whole = &circle(&a) * &(&b - &number(2));
        let table = [
            (whole.clone(), &whole * &(&a + &c), whole.clone()),
            (&whole * &number(-6), whole.clone(), whole.clone()),
            (&whole * &circle(&b), &(&circle(&a) * &circle(&b)) * &(&b + &number(2)), &circle(&a) * &circle(&b)),
            (&circle(&a) * &(&a + &c), &circle(&a) * &(&a - &c), circle(&a)),
            (&circle(&a) * &circle(&a), &(&circle(&a) * &circle(&a)) * &circle(&c), &circle(&a) * &circle(&a)),
        ];
        for (left, right, common) in table {
            assert_eq!(left.greatest_common_divisor(&right), common.primitive());
            assert_eq!(right.greatest_common_divisor(&left), common.primitive());
        }
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
        let factors = parted(&polynomial);
        assert!(factors.contains(&(&a + &b, 2)), "{factors:?}");
        assert!(factors.contains(&(a, 3)), "{factors:?}");
    }

    /// The factors, which multiply up to the polynomial.
    fn parted(polynomial: &Polynomial) -> Vec<(Polynomial, u32)> {
        let (number, factors) = polynomial.square_free();
        let product = factors
            .iter()
            .fold(Polynomial::constant(number), |product, (factor, power)| &product * &factor.power(*power));
        assert_eq!(&product, polynomial);
        factors
    }

    #[test]
    fn what_is_linear_in_one_letter_is_one_factor_in_lowest_terms() {
        let (a, b) = (letter("a"), letter("b"));
        let lowest = &a.scaled(&Fraction::from(2)) - &number(3);
        for scale in [Fraction::from(2), Fraction::new(-1, 5), Fraction::ONE] {
            assert_eq!(parted(&lowest.scaled(&scale)), [(lowest.clone(), 1)], "{scale}");
        }
        assert_eq!(parted(&a.scaled(&Fraction::from(-6))), [(a.clone(), 1)]);
        assert_eq!(parted(&(&a + &b)), [(&a + &b, 1)]);
        assert_eq!(parted(&number(7)), []);
    }
}
