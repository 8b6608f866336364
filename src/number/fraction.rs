//! Fractions: small ones in machine integers with checked arithmetic, large ones in big integers.
//!
//! A fraction is always in lowest terms with a positive denominator, so two equal fractions are
//! equal as data, whichever of the two representations they came through.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};
use std::str::FromStr;

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use dashu_ratio::RBig;

use super::root::exact_root;
use super::steps;

/// An exact rational number in lowest terms.
///
/// ```
/// use carom::number::Fraction;
/// let third = Fraction::new(1, 3);
/// assert_eq!((third + Fraction::new(1, 6)).to_string(), "1/2");
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Fraction(Repr);

#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    /// Numerator and positive denominator, coprime; the numerator is never `i64::MIN`.
    Small(i64, i64),
    /// Only for what does not fit into `Small`, so that each value has one representation.
    Big(Box<RBig>),
}

impl Fraction {
    /// Nought.
    pub const ZERO: Fraction = Fraction(Repr::Small(0, 1));
    /// One.
    pub const ONE: Fraction = Fraction(Repr::Small(1, 1));

    /// The fraction `numerator/denominator`, reduced. Panics if the denominator is nought.
    pub fn new(numerator: i64, denominator: i64) -> Fraction {
        assert!(denominator != 0, "a fraction with denominator nought");
        Fraction::reduce(numerator.into(), denominator.into())
    }

    /// The fraction of two big integers, reduced; `None` if the denominator is nought.
    pub fn from_integers(numerator: IBig, denominator: IBig) -> Option<Fraction> {
        if denominator == IBig::ZERO {
            return None;
        }
        if let (Ok(n), Ok(d)) = (i64::try_from(&numerator), i64::try_from(&denominator)) {
            return Some(Fraction::reduce(n.into(), d.into()));
        }
        let (sign, magnitude) = denominator.into_parts();
        Some(Fraction::from_big(RBig::from_parts(numerator * sign, magnitude)))
    }

    /// Lowest terms of a quotient of machine integers whose denominator is not nought.
    fn reduce(numerator: i128, denominator: i128) -> Fraction {
        // Nearly all fractions of an exam are this small, and 64 bits are divided several times faster.
        if let (Ok(n), Ok(d)) = (i64::try_from(numerator), i64::try_from(denominator))
            && n != i64::MIN
            && d > 0
        {
            // It divides the denominator, so it is no greater.
            let divisor = if d == 1 { 1 } else { gcd(n.unsigned_abs(), d.unsigned_abs()) as i64 };
            return Fraction(Repr::Small(n / divisor, d / divisor));
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        let (mut n, mut d) = (numerator, denominator);
        if divisor > 1 {
            // The greatest common divisor of i128 values that came from i64 products fits.
            n /= divisor as i128;
            d /= divisor as i128;
        }
        if d < 0 {
            (n, d) = (-n, -d);
        }
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(n), Ok(d)) if n != i64::MIN => Fraction(Repr::Small(n, d)),
            _ => Fraction(Repr::Big(Box::new(RBig::from_parts(n.into(), d.unsigned_abs().into())))),
        }
    }

    fn from_big(value: RBig) -> Fraction {
        match (i64::try_from(value.numerator()), i64::try_from(value.denominator())) {
            (Ok(n), Ok(d)) if n != i64::MIN => Fraction(Repr::Small(n, d)),
            _ => Fraction(Repr::Big(Box::new(value))),
        }
    }

    fn to_big(&self) -> RBig {
        match &self.0 {
            Repr::Small(n, d) => RBig::from_parts((*n).into(), d.unsigned_abs().into()),
            Repr::Big(value) => (**value).clone(),
        }
    }

    /// Numerator and denominator, if both fit into machine integers.
    pub fn as_small(&self) -> Option<(i64, i64)> {
        match self.0 {
            Repr::Small(n, d) => Some((n, d)),
            Repr::Big(_) => None,
        }
    }

    /// The length of numerator and denominator together, in bits.
    pub(crate) fn length(&self) -> usize {
        match &self.0 {
            Repr::Small(n, d) => (128 - n.unsigned_abs().leading_zeros() - d.unsigned_abs().leading_zeros()) as usize,
            Repr::Big(value) => bits(value),
        }
    }

    /// The numerator in lowest terms; it carries the sign.
    pub fn numerator(&self) -> IBig {
        match &self.0 {
            Repr::Small(n, _) => (*n).into(),
            Repr::Big(value) => value.numerator().clone(),
        }
    }

    /// The denominator in lowest terms; always positive.
    pub fn denominator(&self) -> IBig {
        match &self.0 {
            Repr::Small(_, d) => (*d).into(),
            Repr::Big(value) => value.denominator().clone().into(),
        }
    }

    /// Is it nought?
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Repr::Small(0, _))
    }

    /// Is it one?
    pub fn is_one(&self) -> bool {
        matches!(self.0, Repr::Small(1, 1))
    }

    /// Is it a whole number?
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Repr::Small(_, d) => *d == 1,
            Repr::Big(value) => value.is_int(),
        }
    }

    /// `Less`, `Equal` or `Greater` as the fraction is negative, nought or positive.
    pub fn sign(&self) -> Ordering {
        match &self.0 {
            Repr::Small(n, _) => n.cmp(&0),
            Repr::Big(value) => value.numerator().cmp(&IBig::ZERO),
        }
    }

    /// The fraction without its sign.
    pub fn abs(&self) -> Fraction {
        if self.sign() == Ordering::Less { -self.clone() } else { self.clone() }
    }

    /// One over the fraction; `None` for nought.
    pub fn reciprocal(&self) -> Option<Fraction> {
        if let Repr::Small(n, d) = self.0 {
            return (n != 0).then(|| Fraction(Repr::Small(d * n.signum(), n.abs())));
        }
        Fraction::from_integers(self.denominator(), self.numerator())
    }

    /// A whole power; negative powers of nought give `None`.
    pub fn power(&self, exponent: i32) -> Option<Fraction> {
        let base = if exponent < 0 { self.reciprocal()? } else { self.clone() };
        // Powers of what has no common factor have none.
        if let Repr::Small(n, d) = base.0
            && let Some((n, d)) = n.checked_pow(exponent.unsigned_abs()).zip(d.checked_pow(exponent.unsigned_abs()))
            && n != i64::MIN
        {
            return Some(Fraction(Repr::Small(n, d)));
        }
        let power = exponent.unsigned_abs() as usize;
        Fraction::from_integers(base.numerator().pow(power), base.denominator().pow(power))
    }

    /// The greatest whole number not above the fraction.
    pub fn floor(&self) -> IBig {
        match &self.0 {
            Repr::Small(n, d) => n.div_euclid(*d).into(),
            Repr::Big(value) => value.floor(),
        }
    }

    /// The largest fraction of which both are whole multiples; nought only of two noughts.
    pub fn common_measure(&self, other: &Fraction) -> Fraction {
        use dashu_int::ops::Gcd;
        match (self.is_zero(), other.is_zero()) {
            (true, _) => return other.abs(),
            (_, true) => return self.abs(),
            _ => {}
        }
        if let (Some((n, d)), Some((m, e))) = (self.as_small(), other.as_small()) {
            let (d, e) = (d.unsigned_abs(), e.unsigned_abs());
            let (above, below) = (gcd(n.unsigned_abs(), m.unsigned_abs()), i128::from(d / gcd(d, e)) * i128::from(e));
            return Fraction::reduce(above.into(), below);
        }
        let numerator: IBig = self.numerator().gcd(other.numerator()).into();
        let (x, y) = (self.denominator(), other.denominator());
        let shared: IBig = (&x).gcd(&y).into();
        Fraction::from_integers(numerator, x / shared * y).expect("a product of denominators is positive")
    }

    /// The exact square root where it is rational.
    pub fn square_root(&self) -> Option<Fraction> {
        if self.sign() == Ordering::Less {
            return None;
        }
        if let Some((n, d)) = self.as_small() {
            let root = |number: i64| Some(number.isqrt()).filter(|root| root * root == number);
            return Some(Fraction(Repr::Small(root(n)?, root(d)?)));
        }
        let numerator = exact_root(&self.numerator())?;
        let denominator = exact_root(&self.denominator())?;
        Fraction::from_integers(numerator, denominator)
    }

    /// The fraction that a double is; none for what is no number.
    pub fn from_f64(value: f64) -> Option<Fraction> {
        RBig::try_from(value).ok().map(Fraction::from_big)
    }

    /// The nearest double, for columns of floats and charts; never for a printed answer.
    pub fn to_f64(&self) -> f64 {
        match &self.0 {
            Repr::Small(n, d) => *n as f64 / *d as f64,
            Repr::Big(value) => value.to_f64().value(),
        }
    }
}

fn gcd<N: Copy + Default + PartialEq + Rem<Output = N>>(mut a: N, mut b: N) -> N {
    while b != N::default() {
        (a, b) = (b, a % b);
    }
    a
}

impl From<i64> for Fraction {
    fn from(value: i64) -> Fraction {
        Fraction::reduce(value.into(), 1)
    }
}

impl From<IBig> for Fraction {
    fn from(value: IBig) -> Fraction {
        Fraction::from_big(RBig::from(value))
    }
}

fn bits(value: &RBig) -> usize {
    value.numerator().bit_len() + value.denominator().bit_len()
}

impl Add for &Fraction {
    type Output = Fraction;
    fn add(self, other: &Fraction) -> Fraction {
        steps::add(1);
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            let (a, b, c, d) = (i128::from(*a), i128::from(*b), i128::from(*c), i128::from(*d));
            // |a d + c b| < 2^127 because each factor is below 2^63.
            return if b == d { Fraction::reduce(a + c, b) } else { Fraction::reduce(a * d + c * b, b * d) };
        }
        let (one, two) = (self.to_big(), other.to_big());
        steps::add(steps::of_bits(bits(&one).max(bits(&two))));
        Fraction::from_big(one + two)
    }
}

impl Mul for &Fraction {
    type Output = Fraction;
    fn mul(self, other: &Fraction) -> Fraction {
        steps::add(1);
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            return Fraction::reduce(i128::from(*a) * i128::from(*c), i128::from(*b) * i128::from(*d));
        }
        let (one, two) = (self.to_big(), other.to_big());
        steps::add(steps::of_bits(bits(&one).max(bits(&two))));
        Fraction::from_big(one * two)
    }
}

impl Neg for Fraction {
    type Output = Fraction;
    fn neg(self) -> Fraction {
        match self.0 {
            Repr::Small(n, d) => Fraction(Repr::Small(-n, d)),
            Repr::Big(value) => Fraction::from_big(-*value),
        }
    }
}

impl Sub for &Fraction {
    type Output = Fraction;
    fn sub(self, other: &Fraction) -> Fraction {
        self + &-other.clone()
    }
}

/// Panics on division by nought, as machine integers do; ask [`Fraction::reciprocal`] first.
impl Div for &Fraction {
    type Output = Fraction;
    // Division of fractions is multiplication by the reciprocal.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, other: &Fraction) -> Fraction {
        self * &other.reciprocal().expect("a fraction divided by nought")
    }
}

macro_rules! by_value {
    ($($law:ident $name:ident),*) => {$(
        impl $law for Fraction {
            type Output = Fraction;
            fn $name(self, other: Fraction) -> Fraction {
                (&self).$name(&other)
            }
        }
    )*};
}
by_value!(Add add, Sub sub, Mul mul, Div div);

impl Ord for Fraction {
    fn cmp(&self, other: &Fraction) -> Ordering {
        steps::add(1);
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            return (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)));
        }
        self.to_big().cmp(&other.to_big())
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Fraction) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// `3`, `-5/2`.
impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_integer() {
            write!(f, "{}", self.numerator())
        } else {
            write!(f, "{}/{}", self.numerator(), self.denominator())
        }
    }
}

impl fmt::Debug for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

/// The text is no whole number, fraction or decimal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotAFraction;

/// Reads `7`, `-3/4`, `0.125` and `.5`, exactly.
impl FromStr for Fraction {
    type Err = NotAFraction;
    fn from_str(text: &str) -> Result<Fraction, NotAFraction> {
        if let (false, Ok(small)) = (text.starts_with('+'), text.parse::<i64>()) {
            return Ok(small.into());
        }
        let integer = |text: &str| {
            let digits = text.strip_prefix('-').unwrap_or(text);
            let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
            if plain { IBig::from_str(text).map_err(|_| NotAFraction) } else { Err(NotAFraction) }
        };
        if let Some((numerator, denominator)) = text.split_once('/') {
            return Fraction::from_integers(integer(numerator)?, integer(denominator)?).ok_or(NotAFraction);
        }
        let Some((whole, decimals)) = text.split_once('.') else { return Ok(integer(text)?.into()) };
        let digits = whole.strip_prefix('-').unwrap_or(whole);
        if !decimals.bytes().all(|byte| byte.is_ascii_digit()) || (decimals.is_empty() && digits.is_empty()) {
            return Err(NotAFraction);
        }
        // As nearly all are: ten to the power 18 is a machine integer.
        if digits.len() + decimals.len() <= 18 && digits.bytes().all(|byte| byte.is_ascii_digit()) {
            let both = digits.bytes().chain(decimals.bytes());
            let all = both.fold(0_i128, |all, digit| 10 * all + i128::from(digit - b'0'));
            let signed = if whole.len() > digits.len() { -all } else { all };
            return Ok(Fraction::reduce(signed, 10_i128.pow(decimals.len() as u32)));
        }
        let all = integer(&format!("{whole}{decimals}"))?;
        Fraction::from_integers(all, IBig::from(10).pow(decimals.len())).ok_or(NotAFraction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Fraction {
        text.parse().unwrap()
    }

    #[test]
    fn a_value_has_one_representation_however_it_was_reached() {
        let big = read("9223372036854775807") * read("9223372036854775807");
        assert!(big.as_small().is_none());
        let back = big / read("9223372036854775807");
        assert_eq!(back, Fraction::from(i64::MAX));
        assert_eq!(back.as_small(), Some((i64::MAX, 1)));
    }

    #[test]
    fn decimals_are_read_exactly() {
        for (text, exact) in [
            ("0.1", "1/10"),
            (".5", "1/2"),
            ("-.25", "-1/4"),
            ("2.50", "5/2"),
            ("-0.5", "-1/2"),
            ("6/4", "3/2"),
            ("5.", "5"),
            ("-0.00", "0"),
            ("123456789012345678.5", "246913578024691357/2"),
            ("0.0000000000000000002", "1/5000000000000000000"),
        ] {
            assert_eq!(read(text).to_string(), exact, "{text}");
        }
        for text in ["", ".", "-", "-.", "1/0", "1.2.3", "1e3", "+1", "+1.5", "1.+5", "1_0", "--1"] {
            assert!(text.parse::<Fraction>().is_err(), "{text}");
        }
    }

    #[test]
    fn small_arithmetic_that_overflows_goes_on_in_big_integers() {
        let a = Fraction::new(i64::MAX, 3);
        let b = Fraction::new(i64::MAX - 1, 5);
        assert_eq!((&(&a * &b) / &b), a);
        assert_eq!((&(&a + &b) - &b), a);
        assert_eq!(-Fraction::from(i64::MIN), read("9223372036854775808"));
    }

    #[test]
    fn a_double_is_a_fraction() {
        assert_eq!(Fraction::from_f64(-0.375), Some(read("-3/8")));
        assert_ne!(Fraction::from_f64(0.1), Some(read("0.1")));
        assert_eq!(Fraction::from_f64(f64::NAN), None);
    }

    #[test]
    fn roots_and_powers() {
        assert_eq!(read("4/9").square_root(), Some(read("2/3")));
        assert_eq!(read("2").square_root(), None);
        assert_eq!(read("-4").square_root(), None);
        assert_eq!(read("2/3").power(-2), Some(read("9/4")));
        assert_eq!(read("-7/2").floor(), IBig::from(-4));
        assert_eq!(read("-4/3").common_measure(&read("2/5")), read("2/15"));
        assert_eq!(read("0").common_measure(&read("-1/6")), read("1/6"));
    }
}
