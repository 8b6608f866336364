//! Exact values: fractions, surds, nested roots, sines of given angles and letters, in one normal form.
//!
//! A value is a sum over products of *roots*, each root the positive square root of something
//! simpler, with polynomials in letters as coefficients, over one polynomial:
//!
//! ```text
//!     (p_0 + p_1 √2 + p_2 √2 cos α + …) / q        p_k, q polynomials in letters; tan α is a letter
//! ```
//!
//! The cosine of an acute angle is a root too, since cos² α = 1/(1 + tan² α). No denominator holds a
//! root, numerators and denominator share no factor, and q is primitive; so two values are equal if
//! and only if they are equal as data, but for two things that data cannot see: relations between
//! sines of given degrees (cos 20° = cos 40° + cos 80°, or sin 20° = cos 70° where each is a value of
//! its own) and between nested roots. The room [`decide`](super::decide) decides those.

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use smallvec::smallvec;

use super::terms::{Roots, Terms};
use super::{Fraction, Letter, Polynomial};

/// An exact real number, or an exact formula in letters.
///
/// ```
/// use carom::number::{Fraction, Value};
/// let root = Value::from(12).square_root().unwrap();
/// assert_eq!(format!("{root:?}"), "2*sqrt(3)");
/// assert_eq!(&root * &root, Value::from(12));
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Value {
    /// A rational number; every rational value is one of these.
    Rational(Fraction),
    /// Anything else.
    Compound(Arc<Compound>),
}

/// Sums of products of roots over a polynomial: see the [module](self).
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Compound {
    /// What each product of roots is multiplied by, sorted by product, no polynomial nought.
    pub(crate) terms: Terms,
    /// Primitive, never nought.
    pub(crate) denominator: Polynomial,
}

/// A positive square root of something simpler.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Root {
    /// Of a prime (or of a large number that is taken for one): √2.
    Prime(u128),
    /// The cosine of an acute angle, by the letter of its tangent.
    Cosine(Letter),
    /// Of a value that is no square. `depth` is one more than that of any root inside.
    Nested {
        /// How many nested roots stand inside each other here.
        depth: u32,
        /// What the root is taken of.
        radicand: Value,
    },
}

impl Root {
    /// The square of the root.
    pub fn square(&self) -> Value {
        match self {
            Root::Prime(prime) => Value::Rational(integer(*prime)),
            Root::Cosine(tangent) => Value::quotient(Polynomial::one(), Polynomial::one_plus_square(*tangent)),
            Root::Nested { radicand, .. } => radicand.clone(),
        }
    }

    fn depth(&self) -> u32 {
        match self {
            Root::Nested { depth, .. } => *depth,
            _ => 0,
        }
    }
}

/// A whole number as a fraction.
pub(crate) fn integer(value: u128) -> Fraction {
    i64::try_from(value).map_or_else(|_| Fraction::from(dashu_int::IBig::from(value)), Fraction::from)
}

impl Value {
    /// Nought.
    pub const ZERO: Value = Value::Rational(Fraction::ZERO);
    /// One.
    pub const ONE: Value = Value::Rational(Fraction::ONE);

    /// The rational number `numerator/denominator`. Panics if the denominator is nought.
    pub fn fraction(numerator: i64, denominator: i64) -> Value {
        Value::Rational(Fraction::new(numerator, denominator))
    }

    /// A letter: for an angle its tangent.
    pub fn letter(letter: Letter) -> Value {
        Value::quotient(Polynomial::letter(letter), Polynomial::one())
    }

    /// The cosine of the acute angle whose tangent the letter is.
    pub fn cosine(tangent: Letter) -> Value {
        Value::root(Root::Cosine(tangent))
    }

    /// The sine of the acute angle whose tangent the letter is.
    pub fn sine(tangent: Letter) -> Value {
        &Value::cosine(tangent) * &Value::letter(tangent)
    }

    /// A root.
    pub(crate) fn root(root: Root) -> Value {
        Value::build(Terms::one(smallvec![root], Polynomial::one()), Polynomial::one())
    }

    /// A number that is not nought times different roots of primes, sorted: the normal form as it stands.
    pub(super) fn surd(number: Fraction, roots: Roots) -> Value {
        if roots.is_empty() {
            return Value::Rational(number);
        }
        let (terms, denominator) = (Terms::one(roots, Polynomial::constant(number)), Polynomial::one());
        Value::Compound(Arc::new(Compound { terms, denominator }))
    }

    /// The number and the roots of which [`Value::surd`] makes it, if it is irrational and made so.
    pub(super) fn as_surd(&self) -> Option<(&Fraction, &[Root])> {
        let Value::Compound(compound) = self else { return None };
        let (roots, coefficient) = compound.terms.first().filter(|_| compound.terms.len() == 1)?;
        let is_surd = compound.denominator.is_one() && roots.iter().all(|root| matches!(root, Root::Prime(_)));
        is_surd.then_some((coefficient.as_number()?, roots))
    }

    /// A nested root of a value that is no square.
    pub(crate) fn nested(radicand: Value) -> Value {
        let depth = 1 + radicand.depth();
        Value::root(Root::Nested { depth, radicand })
    }

    /// How many nested roots stand inside each other in it.
    pub(crate) fn depth(&self) -> u32 {
        let Value::Compound(compound) = self else { return 0 };
        compound.terms.products().flatten().map(Root::depth).max().unwrap_or(0)
    }

    /// The last of the nested roots in it, by which it is decided what it is.
    pub(super) fn last_nested(&self) -> Option<&Root> {
        let Value::Compound(compound) = self else { return None };
        compound.terms.products().flatten().filter(|root| root.depth() > 0).max()
    }

    /// A quotient of two polynomials, the second not nought.
    pub fn quotient(numerator: Polynomial, denominator: Polynomial) -> Value {
        Value::build(Terms::one(Roots::new(), numerator), denominator)
    }

    /// The normal form of terms over a denominator that is not nought.
    pub(crate) fn build(terms: Terms, denominator: Polynomial) -> Value {
        let mut terms = terms.without_noughts();
        if terms.is_empty() {
            return Value::ZERO;
        }
        let mut denominator = denominator;
        if denominator.as_constant().is_none() {
            let mut shared = denominator.clone();
            for coefficient in terms.coefficients() {
                shared = shared.greatest_common_divisor(coefficient);
                if shared.is_one() {
                    break;
                }
            }
            if !shared.is_one() {
                let exact = |p: &Polynomial| p.divided_by(&shared).expect("a common divisor divides");
                terms.change(exact);
                denominator = exact(&denominator);
            }
        }
        if !denominator.is_one() {
            let primitive = denominator.primitive();
            if primitive != denominator {
                let scale = denominator.divided_by(&primitive).and_then(|unit| unit.as_constant());
                let inverse = scale.and_then(|unit| unit.reciprocal()).expect("a denominator is not nought");
                terms.change(|coefficient| coefficient.scaled(&inverse));
            }
            denominator = primitive;
        }
        if let (1, true, Some((roots, numerator))) = (terms.len(), denominator.is_one(), terms.first())
            && let (true, Some(number)) = (roots.is_empty(), numerator.as_constant())
        {
            return Value::Rational(number);
        }
        Value::Compound(Arc::new(Compound { terms, denominator })).without_complements()
    }

    /// The terms and the denominator, whichever kind of value it is.
    pub(crate) fn parts(&self) -> (Cow<'_, Terms>, Cow<'_, Polynomial>) {
        match self {
            Value::Rational(number) => {
                let number = Polynomial::constant(number.clone());
                (Cow::Owned(Terms::one(Roots::new(), number)), Cow::Owned(Polynomial::one()))
            }
            Value::Compound(compound) => (Cow::Borrowed(&compound.terms), Cow::Borrowed(&compound.denominator)),
        }
    }

    /// The rational number it is, if it is one.
    pub fn as_fraction(&self) -> Option<&Fraction> {
        match self {
            Value::Rational(number) => Some(number),
            Value::Compound(_) => None,
        }
    }

    /// Numerator and denominator, if no root is in it.
    pub fn as_quotient(&self) -> Option<(Polynomial, Polynomial)> {
        let (terms, denominator) = self.parts();
        match terms.len() {
            1 => Some((terms.get(&[])?.clone(), denominator.into_owned())),
            0 => Some((Polynomial::zero(), denominator.into_owned())),
            _ => None,
        }
    }

    /// The roots in it, simplest first; what stands inside nested roots is not listed.
    pub fn roots(&self) -> Vec<Root> {
        let Value::Compound(compound) = self else { return Vec::new() };
        let mut roots: Vec<Root> = compound.terms.products().flatten().cloned().collect();
        roots.sort();
        roots.dedup();
        roots
    }

    /// All letters in it, those inside roots too, tangents of given degrees included; sorted.
    pub fn letters(&self) -> Vec<Letter> {
        let Value::Compound(compound) = self else { return Vec::new() };
        let mut letters = compound.denominator.letters();
        letters.extend(compound.terms.coefficients().flat_map(Polynomial::letters));
        for root in self.roots() {
            match root {
                Root::Prime(_) => {}
                Root::Cosine(tangent) => letters.push(tangent),
                Root::Nested { radicand, .. } => letters.extend(radicand.letters()),
            }
        }
        letters.sort();
        letters.dedup();
        letters
    }

    /// Each product of roots with the polynomial it is multiplied by, over [`Value::denominator`].
    pub(crate) fn numerator_terms(&self) -> Cow<'_, Terms> {
        self.parts().0
    }

    /// The polynomial below, primitive.
    pub fn denominator(&self) -> Polynomial {
        self.parts().1.into_owned()
    }

    /// How many terms it takes to write it down, above and below.
    pub fn terms(&self) -> usize {
        match self {
            Value::Rational(_) => 1,
            Value::Compound(compound) => {
                let above: usize = compound.terms.coefficients().map(|p| p.terms().len()).sum();
                let without_nested = above + compound.denominator.terms().len();
                if self.last_nested().is_none() {
                    return without_nested;
                }
                let nested = self.roots().into_iter().map(|root| match root {
                    Root::Nested { radicand, .. } => radicand.terms(),
                    _ => 0,
                });
                without_nested + nested.sum::<usize>()
            }
        }
    }

    /// Is it a number, without letters?
    pub fn is_constant(&self) -> bool {
        !self.has_letter(|letter| !letter.is_constant())
    }

    /// Does it depend on any letter, be it only the tangent of an angle given in degrees?
    pub(crate) fn has_letters(&self) -> bool {
        self.has_letter(|_| true)
    }

    /// Is there such a letter in it? Asked of nearly every value, so without making a list.
    pub(crate) fn has_letter(&self, is_such: impl Fn(&Letter) -> bool + Copy) -> bool {
        let Value::Compound(compound) = self else { return false };
        let within = |polynomial: &Polynomial| {
            polynomial.terms().iter().any(|(monomial, _)| monomial.iter().any(|(letter, _)| is_such(letter)))
        };
        let holds = |root: &Root| match root {
            Root::Prime(_) => false,
            Root::Cosine(tangent) => is_such(tangent),
            Root::Nested { radicand, .. } => radicand.has_letter(is_such),
        };
        compound.terms.iter().any(|(key, coefficient)| key.iter().any(holds) || within(coefficient))
            || within(&compound.denominator)
    }

    /// Written down as nought: see [`Value::is_zero`] for what only a decision can tell.
    pub(crate) fn is_written_zero(&self) -> bool {
        matches!(self, Value::Rational(number) if number.is_zero())
    }

    /// `a` and `b` in `self = a + b root`.
    pub(crate) fn split(&self, root: &Root) -> (Value, Value) {
        let (terms, denominator) = self.parts();
        let (with, without): (Vec<_>, Vec<_>) = terms.iter().partition(|(roots, _)| roots.contains(root));
        let built = |terms: Vec<(&Roots, &Polynomial)>| {
            let rest = |roots: &Roots| roots.iter().filter(|other| *other != root).cloned().collect();
            let terms = terms.into_iter().map(|(roots, coefficient)| (rest(roots), coefficient.clone()));
            Value::build(terms.collect(), denominator.clone().into_owned())
        };
        (built(without), built(with))
    }

    /// The length of the longest number in it, in bits.
    pub(crate) fn longest_number(&self) -> usize {
        let Value::Compound(compound) = self else { return self.as_fraction().map_or(0, Fraction::length) };
        let above = compound.terms.coefficients();
        let numbers = above.chain([&compound.denominator]).flat_map(|polynomial| polynomial.terms());
        numbers.map(|(_, number)| number.length()).max().unwrap_or_default()
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Value {
        Value::Rational(value.into())
    }
}

impl From<Fraction> for Value {
    fn from(value: Fraction) -> Value {
        Value::Rational(value)
    }
}

/// For messages of tests: exact, but not as a teacher writes it.
impl fmt::Debug for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (terms, denominator) = self.parts();
        let polynomial = |p: &Polynomial| {
            let term = |(monomial, c): &(super::Monomial, Fraction)| {
                let letters: String = monomial.iter().map(|(letter, power)| format!("*{letter:?}^{power}")).collect();
                format!("{c}{letters}")
            };
            p.terms().iter().map(term).collect::<Vec<_>>().join(" + ")
        };
        let sum: Vec<String> = terms
            .iter()
            .map(|(roots, coefficient)| {
                let roots: String = roots
                    .iter()
                    .map(|root| match root {
                        Root::Prime(prime) => format!("*sqrt({prime})"),
                        Root::Cosine(tangent) => format!("*cos[{tangent:?}]"),
                        Root::Nested { radicand, .. } => format!("*sqrt({radicand:?})"),
                    })
                    .collect();
                let coefficient = polynomial(coefficient);
                if terms.len() > 1 && coefficient.contains(' ') {
                    format!("({coefficient}){roots}")
                } else {
                    coefficient + &roots
                }
            })
            .collect();
        let sum = sum.join(" + ");
        if denominator.is_one() { write!(f, "{sum}") } else { write!(f, "({sum})/({})", polynomial(&denominator)) }
    }
}
