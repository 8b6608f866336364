//! Is an exact value nought, and what is its sign? Decided, never measured.
//!
//! For most values the normal form itself tells. Where it cannot, these arguments do:
//!
//! * A nested root, `a + b√r`: it is nought exactly if `a² = b² r` while `a` and `b` have opposite
//!   signs. So nested roots are compared by squaring, from the outermost inwards.
//! * Sines and cosines of given degrees: twice a sine or cosine of a rational angle is an algebraic
//!   integer. A sum of products of such numbers and surds with whole coefficients is one too, so the
//!   product of its conjugates is a whole number. If the sum is not nought, that product is at least
//!   one in size; with at most `D` conjugates, each at most `M`, the sum is at least `M^-(D-1)`.
//!   An enclosure finer than that decides.
//!   Most that are nought are so because angles add up, which the sum written as one of cosines shows at once.
//! * A formula in letters is nought exactly if each coefficient of each product of letters is; its
//!   sign is known if all these coefficients have one sign once a coefficient of restitution `e` is
//!   written `1/(1+x)`, `x` positive, or if it has one at all corners of a cosine and a sine.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use dashu_int::ops::BitTest;

use super::polynomial::{Monomial, Polynomial};
use super::terms::{Roots, Terms};
use super::value::{Root, Value};
use super::{FloatInterval, Fraction, Interval, Letter, Range, waves};

/// Beyond this many binary places a decision is not tried any further. No angle in whole
/// hundredths of a degree comes near it.
const MOST_BITS: usize = 1 << 18;

/// How many points are looked at where a formula may be nought here and another one there.
const MOST_POINTS: u32 = 12;

impl Value {
    /// Is it nought (for a formula: whatever its letters stand for)?
    pub fn is_zero(&self) -> bool {
        let Value::Compound(compound) = self else { return self.is_written_zero() };
        let nested = self.last_nested();
        if nested.is_none() && !self.has_letter(Letter::is_constant) {
            // No nested root and no given angle: the normal form is nought only as nought itself.
            return false;
        }
        if self.is_constant() && self.between_doubles().and_then(FloatInterval::sign).is_some_and(Ordering::is_ne) {
            return false;
        }
        if let Some(root) = nested {
            if is_one_product(&compound.terms) {
                let is_nought = |root: &Root| matches!(root, Root::Nested { .. }) && root.square().is_zero();
                return compound.terms.products().flatten().any(is_nought);
            }
            // Nearly always one point tells, of what is very small more finely; and to square root after root is long.
            return self.may_vanish(0, 64) && self.may_vanish(0, 512) && self.is_zero_with(root);
        }
        // A finer enclosure may tell where doubles do not.
        if self.is_constant() && self.enclose_constant(64).is_some_and(|interval| !interval.contains_zero()) {
            return false;
        }
        let (terms, _) = self.parts();
        by_letters(&terms).values().all(constant_is_zero)
    }

    /// `a + b root`, the root nested.
    fn is_zero_with(&self, root: &Root) -> bool {
        let (a, b) = self.split(root);
        if b.is_zero() {
            return a.is_zero();
        }
        if !(&(&a * &a) - &(&(&b * &b) * &root.square())).is_zero() {
            return false;
        }
        // At each point one of a + b root and a - b root is nought, and not both as b is not.
        match (a.sign(), b.sign()) {
            (Some(x), Some(y)) => x != y,
            _ => self.vanishes_at_points(),
        }
    }

    /// Of two formulas of which at each point one is nought: is it this one at all of them? Points inside the letters'
    /// ranges tell, as soon as an enclosure there keeps clear of nought.
    fn vanishes_at_points(&self) -> bool {
        (0..MOST_POINTS).all(|point| self.may_vanish(point, 64)) && (6..12).all(|power| self.may_vanish(0, 1 << power))
    }

    /// Is nought not yet excluded at a point by so many bits?
    fn may_vanish(&self, point: u32, bits: usize) -> bool {
        let enclosure = self.enclose(bits, &|letter| Some(Interval::from_fraction(&letter.at(point), bits)));
        enclosure.is_none_or(|interval| interval.contains_zero())
    }

    /// The sign, if it is the same wherever the letters lie in their ranges; `None` if it is not, or
    /// if the argument above does not show it.
    pub fn sign(&self) -> Option<Ordering> {
        let Value::Compound(compound) = self else { return Some(self.as_fraction()?.sign()) };
        if self.is_constant() {
            return constant_sign(self);
        }
        let below = match compound.denominator.is_one() {
            true => Ordering::Greater,
            false => common_sign(&Terms::one(Roots::new(), compound.denominator.clone()))?,
        };
        let whole = || Value::build(compound.terms.clone(), Polynomial::one());
        let above = common_sign(&compound.terms).or_else(|| whole().sign_at_corners())?;
        Some(if below.is_lt() { above.reverse() } else { above })
    }

    /// The coefficient of each product of letters (and of roots that hold letters) above the denominator.
    pub(crate) fn coefficients(&self) -> BTreeMap<(Roots, Monomial), Value> {
        let mut groups = by_letters(&self.parts().0);
        groups.retain(|_, coefficient| !coefficient.is_zero());
        groups
    }

    /// Is the value known to be equal to another?
    pub fn equals(&self, other: &Value) -> bool {
        self == other || (self - other).is_zero()
    }
}

/// Is there a single product of roots and letters, and nothing in it that is given as a number of degrees?
fn is_one_product(terms: &Terms) -> bool {
    let mut products = terms.coefficients().flat_map(Polynomial::terms);
    let is_free = |(letters, _): &(Monomial, Fraction)| !letters.iter().any(|(letter, _)| letter.is_constant());
    products.next().is_some_and(is_free) && products.next().is_none()
}

/// The value's coefficient of each product of letters (and of roots that hold letters).
fn by_letters(terms: &Terms) -> BTreeMap<(Roots, Monomial), Value> {
    let mut groups: BTreeMap<(Roots, Monomial), Value> = BTreeMap::new();
    for (key, coefficient) in terms.iter() {
        let (constant, lettered): (Roots, Roots) =
            key.iter().cloned().partition(|root| Value::root(root.clone()).is_constant());
        for (monomial, number) in coefficient.terms() {
            let (fixed, free): (Monomial, Monomial) = monomial.iter().partition(|(letter, _)| letter.is_constant());
            let factor = Polynomial::from_terms([(fixed, number.clone())]);
            let product = Value::build(Terms::one(constant.clone(), factor), Polynomial::one());
            let sum = groups.entry((lettered.clone(), free)).or_insert(Value::ZERO);
            *sum = &*sum + &product;
        }
    }
    groups
}

/// The sign that all coefficients share, if letters are in their ranges.
fn common_sign(terms: &Terms) -> Option<Ordering> {
    let terms = without_units(terms);
    let mut common = Ordering::Equal;
    let mut shares = |monomial: &Monomial, sign: Ordering| {
        let even = |(letter, power): &(Letter, u32)| letter.range() != Range::Real || power % 2 == 0;
        if sign.is_eq() {
            return true;
        }
        let is_shared = monomial.iter().all(even) && (common.is_eq() || common == sign);
        common = sign;
        is_shared
    };
    let all = match without_roots(&terms) {
        Some(terms) => terms.iter().all(|(monomial, number)| shares(monomial, number.sign())),
        None => by_letters(&terms)
            .iter()
            .all(|((_, monomial), coefficient)| constant_sign(coefficient).is_some_and(|sign| shares(monomial, sign))),
    };
    all.then_some(common)
}

/// The terms of a polynomial in letters alone, without roots and without what is given as a number of degrees.
fn without_roots(terms: &Terms) -> Option<&[(Monomial, Fraction)]> {
    let (roots, polynomial) = terms.first()?;
    let mut letters = polynomial.terms().iter().flat_map(|(monomial, _)| monomial);
    let is_plain = terms.len() == 1 && roots.is_empty() && letters.all(|(letter, _)| !letter.is_constant());
    is_plain.then(|| polynomial.terms())
}

/// The terms times a positive factor, each coefficient of restitution `e` written as `1/(1+x)`.
fn without_units(terms: &Terms) -> Cow<'_, Terms> {
    let monomials = terms.coefficients().flat_map(Polynomial::terms).flat_map(|(monomial, _)| monomial);
    let units: BTreeSet<Letter> =
        monomials.map(|(letter, _)| *letter).filter(|letter| letter.range() == Range::Unit).collect();
    units.into_iter().fold(Cow::Borrowed(terms), |terms, unit| {
        let highest = terms.coefficients().map(|p| p.degree(unit)).max().unwrap_or(0);
        let grown = &Polynomial::one() + &Polynomial::letter(unit);
        Cow::Owned(terms.with(|coefficient| {
            let powers = coefficient.coefficients(unit);
            let shifted = powers.iter().enumerate().map(|(power, p)| p * &grown.power(highest - power as u32));
            shifted.fold(Polynomial::zero(), |sum, p| &sum + &p)
        }))
    })
}

/// The sign of a value without letters.
fn constant_sign(value: &Value) -> Option<Ordering> {
    if let Some(number) = value.as_fraction() {
        return Some(number.sign());
    }
    if let Some(sign) = value.between_doubles().and_then(FloatInterval::sign).filter(|sign| sign.is_ne()) {
        return Some(sign);
    }
    let enclosed = |bits| value.enclose_constant(bits).and_then(|interval: Interval| interval.sign());
    if let Some(sign) = enclosed(64).or_else(|| enclosed(256)) {
        return Some(sign);
    }
    if value.is_zero() {
        return Some(Ordering::Equal);
    }
    let mut bits = 1024;
    while bits <= MOST_BITS {
        if let Some(sign) = enclosed(bits) {
            return Some(sign);
        }
        bits *= 2;
    }
    None
}

/// A sum of products of surds, sines and cosines of given degrees: is it nought?
fn constant_is_zero(value: &Value) -> bool {
    let (terms, _) = value.parts();
    if value.as_fraction().is_some() || !value.has_letter(Letter::is_constant) {
        return value.is_written_zero();
    }
    // Nearly always a rough enclosure tells, and the product that follows is long.
    if value.enclose_constant(128).is_some_and(|interval| !interval.contains_zero()) {
        return false;
    }
    // Times a power of each cosine, so that only sines and cosines are left of the tangents.
    let mut angles = value.letters();
    angles.retain(Letter::is_constant);
    let highest: Vec<u32> =
        angles.iter().map(|t| terms.coefficients().map(|p| p.degree(*t)).max().unwrap_or(0)).collect();
    // Times these powers, angles that add up cancel; what does is nought, however long the product of its conjugates.
    if waves::vanishes(&terms, &angles, &highest) {
        return true;
    }
    let scaled = angles.iter().zip(&highest).fold(value.clone(), |product, (tangent, power)| {
        (0..*power).fold(product, |product, _| &product * &Value::cosine(*tangent))
    });
    let needed = separation(&terms, &angles, &highest);
    let mut bits = 256;
    loop {
        if scaled.enclose_constant(bits).is_some_and(|interval| !interval.contains_zero()) {
            return false;
        }
        if bits >= needed || bits > MOST_BITS {
            return true;
        }
        bits = (bits * 4).min(needed.max(bits + 1));
    }
}

/// Binary places that separate the value, times the powers of cosines, from nought: see the module.
fn separation(terms: &Terms, angles: &[Letter], highest: &[u32]) -> usize {
    // The conjugates lie in the field of the angles' roots of unity with the surds adjoined.
    let mut order: u128 = 4;
    for tangent in angles {
        let degrees: Fraction = tangent.name().parse().unwrap_or(Fraction::ONE);
        let turn = &degrees / &Fraction::from(360);
        let below = u128::try_from(turn.denominator()).unwrap_or(u128::MAX);
        order = lowest_common_multiple(order, below);
    }
    let mut primes: Vec<u128> = Vec::new();
    let mut denominators = 0;
    let mut size = 0;
    for (key, coefficient) in terms.iter() {
        let mut surd_bits = 0;
        for root in key {
            if let Root::Prime(prime) = root {
                surd_bits += (128 - prime.leading_zeros() as usize) / 2 + 1;
                primes.push(*prime);
            }
        }
        for (_, number) in coefficient.terms() {
            denominators += number.denominator().bit_len();
            size = size.max(number.numerator().bit_len() + surd_bits) + 1;
        }
    }
    primes.sort();
    primes.dedup();
    // Each sine and cosine, doubled to be an algebraic integer, has conjugates of size at most two.
    let doubled: usize = highest.iter().map(|power| *power as usize + 1).sum();
    let largest = size + 2 * doubled + denominators + 8;
    // The real numbers among them are half of the field.
    let degree = usize::try_from(totient(order) / 2).unwrap_or(usize::MAX).saturating_mul(1 << primes.len().min(20));
    degree.saturating_mul(largest).saturating_add(64)
}

fn lowest_common_multiple(a: u128, b: u128) -> u128 {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    (a / x).saturating_mul(b)
}

/// How many numbers up to `order` share no factor with it: the degree of the field of its roots of unity.
fn totient(order: u128) -> u128 {
    let (mut rest, mut result, mut prime) = (order, order, 2);
    while prime * prime <= rest && prime < 1 << 20 {
        if rest % prime == 0 {
            result -= result / prime;
            while rest % prime == 0 {
                rest /= prime;
            }
        }
        prime += 1;
    }
    if rest > 1 { result - result / rest } else { result }
}
