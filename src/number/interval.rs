//! Certified intervals: two ends between which the true value is proved to lie.
//!
//! Conventions. An interval is closed. Its ends are whole multiples of 2^-bits, held as big integers; such
//! a multiple is called a unit here. Every operation rounds its lower end down and its upper end up, so what
//! was inside before is inside afterwards. Of two operands with different `bits` the coarser one is first
//! written in the finer units, which is exact. Angles are in radians.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use dashu_int::IBig;
use dashu_int::ops::{BitTest, DivEuclid, SquareRootRem, UnsignedAbs};

use super::{Fraction, steps};

/// A closed interval with ends that are multiples of 2^-bits, rounded outwards by every operation.
///
/// ```
/// use carom::number::{Fraction, Interval};
/// let root = Interval::integer(2, 64).sqrt().unwrap();
/// let square = root.clone() * root;
/// assert!(square.contains(&Fraction::from(2)));
/// assert!(square.width() < Fraction::new(1, 1 << 60));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Interval {
    /// In units of 2^-bits, as `upper`; never above it.
    pub(super) lower: IBig,
    pub(super) upper: IBig,
    pub(super) bits: usize,
}

impl Interval {
    /// The narrowest interval around a fraction; a point if the denominator is a small enough power of two.
    pub fn from_fraction(value: &Fraction, bits: usize) -> Interval {
        let (numerator, denominator) = (value.numerator() << bits, value.denominator());
        Interval {
            lower: floor_quotient(&numerator, &denominator),
            upper: ceiling_quotient(&numerator, &denominator),
            bits,
        }
    }

    /// A whole number, exactly.
    pub fn integer(value: i64, bits: usize) -> Interval {
        Interval::point(IBig::from(value) << bits, bits)
    }

    /// One multiple of 2^-bits, exactly.
    pub(super) fn point(units: IBig, bits: usize) -> Interval {
        Interval { lower: units.clone(), upper: units, bits }
    }

    /// What lies within `error` units of an approximation.
    pub(super) fn around(approximation: &IBig, error: &IBig, bits: usize) -> Interval {
        Interval { lower: approximation - error, upper: approximation + error, bits }
    }

    /// The same interval in units of 2^-bits: exact if they are finer, outwards if they are coarser.
    pub fn with_bits(&self, bits: usize) -> Interval {
        match bits.checked_sub(self.bits) {
            Some(finer) => Interval { lower: &self.lower << finer, upper: &self.upper << finer, bits },
            None => {
                let coarser = self.bits - bits;
                Interval { lower: &self.lower >> coarser, upper: ceiling_shift(&self.upper, coarser), bits }
            }
        }
    }

    /// The number of binary places that the ends have.
    pub fn bits(&self) -> usize {
        self.bits
    }

    /// The lower end.
    pub fn lower(&self) -> Fraction {
        fraction(&self.lower, self.bits)
    }

    /// The upper end.
    pub fn upper(&self) -> Fraction {
        fraction(&self.upper, self.bits)
    }

    /// How far the ends are apart.
    pub fn width(&self) -> Fraction {
        fraction(&(&self.upper - &self.lower), self.bits)
    }

    /// The double nearest to the middle, for columns of floats and charts; never for a printed answer.
    pub fn to_f64(&self) -> f64 {
        fraction(&(&self.upper + &self.lower), self.bits + 1).to_f64()
    }

    /// Does it reach beyond plus or minus 2^bits?
    pub(crate) fn exceeds(&self, bits: usize) -> bool {
        self.upper.bit_len().max(self.lower.bit_len()) > self.bits + bits
    }

    fn count_steps(&self, other: &Interval) {
        steps::add(steps::of_bits(self.upper.bit_len().max(other.upper.bit_len())));
    }

    /// May the value be nought?
    pub fn contains_zero(&self) -> bool {
        self.lower <= IBig::ZERO && self.upper >= IBig::ZERO
    }

    /// The sign where the interval decides it: all of it above nought, all of it below, or nought alone.
    pub fn sign(&self) -> Option<Ordering> {
        let (lower, upper) = (self.lower.cmp(&IBig::ZERO), self.upper.cmp(&IBig::ZERO));
        (lower == upper).then_some(lower)
    }

    /// Does the fraction lie in the interval, ends included?
    pub fn contains(&self, value: &Fraction) -> bool {
        let (numerator, denominator) = (value.numerator() << self.bits, value.denominator());
        &self.lower * &denominator <= numerator && numerator <= &self.upper * denominator
    }

    /// Do the two have a point in common? If not, the values inside are certainly different.
    pub fn overlaps(&self, other: &Interval) -> bool {
        self.intersection(other).is_some()
    }

    /// What the two have in common; `None` if nothing. Where both enclose one value, so does this.
    pub fn intersection(&self, other: &Interval) -> Option<Interval> {
        let (one, two, bits) = aligned(self, other);
        let (lower, upper) = (one.lower.max(two.lower), one.upper.min(two.upper));
        (lower <= upper).then_some(Interval { lower, upper, bits })
    }

    /// The narrowest interval that holds both.
    pub fn hull(&self, other: &Interval) -> Interval {
        let (one, two, bits) = aligned(self, other);
        Interval { lower: one.lower.min(two.lower), upper: one.upper.max(two.upper), bits }
    }

    /// The value without its sign.
    pub fn abs(&self) -> Interval {
        if self.lower >= IBig::ZERO {
            self.clone()
        } else if self.upper <= IBig::ZERO {
            -self.clone()
        } else {
            Interval { lower: IBig::ZERO, upper: self.upper.clone().max(-&self.lower), bits: self.bits }
        }
    }

    /// The quotient; `None` if the divisor may be nought.
    pub fn checked_div(&self, divisor: &Interval) -> Option<Interval> {
        match divisor.sign()? {
            Ordering::Greater => Some(self.over_positive(divisor)),
            Ordering::Less => Some((-self.clone()).over_positive(&-divisor.clone())),
            Ordering::Equal => None,
        }
    }

    /// The quotient by an interval that is all of it above nought.
    pub(super) fn over_positive(&self, divisor: &Interval) -> Interval {
        self.count_steps(divisor);
        let (dividend, divisor, bits) = aligned(self, divisor);
        // The quotient is least with the largest divisor if the dividend is positive, else with the smallest.
        let below = if dividend.lower >= IBig::ZERO { &divisor.upper } else { &divisor.lower };
        let above = if dividend.upper >= IBig::ZERO { &divisor.lower } else { &divisor.upper };
        Interval {
            lower: floor_quotient(&(dividend.lower << bits), below),
            upper: ceiling_quotient(&(dividend.upper << bits), above),
            bits,
        }
    }

    /// The square root; `None` if all of the interval is negative. A lower end below nought counts as nought,
    /// for the value under a root is known not to be negative when an enclosure of it reaches below.
    pub fn sqrt(&self) -> Option<Interval> {
        if self.upper < IBig::ZERO {
            return None;
        }
        self.count_steps(self);
        let lower = self.lower.clone().max(IBig::ZERO);
        // root(n 2^-bits) = root(n 2^bits) 2^-bits.
        let (lower, _) = root(&(lower << self.bits));
        let (upper, exact) = root(&(&self.upper << self.bits));
        Some(Interval { lower, upper: if exact { upper } else { upper + 1 }, bits: self.bits })
    }
}

impl Interval {
    /// The cube root; `None` unless all of the interval is at least nought.
    pub fn cube_root(&self) -> Option<Interval> {
        if self.lower < IBig::ZERO {
            return None;
        }
        self.count_steps(self);
        // root(n 2^-bits) = root(n 2^(2 bits)) 2^-bits.
        let root = |end: &IBig| IBig::from((end << (2 * self.bits)).unsigned_abs().nth_root(3));
        Some(Interval { lower: root(&self.lower), upper: root(&self.upper) + 1, bits: self.bits })
    }
}

/// Both in the finer of their units.
fn aligned(one: &Interval, two: &Interval) -> (Interval, Interval, usize) {
    let bits = one.bits.max(two.bits);
    (one.with_bits(bits), two.with_bits(bits), bits)
}

/// `units` times 2^-bits.
fn fraction(units: &IBig, bits: usize) -> Fraction {
    // Taking the common power of two off first spares a greatest common divisor of large integers.
    let common = units.trailing_zeros().unwrap_or(bits).min(bits);
    Fraction::from_integers(units >> common, IBig::ONE << (bits - common)).unwrap_or(Fraction::ZERO)
}

/// The quotient by a positive integer, rounded down. (Shifting right rounds down by itself.)
pub(super) fn floor_quotient(numerator: &IBig, denominator: &IBig) -> IBig {
    numerator.div_euclid(denominator)
}

/// The quotient by a positive integer, rounded up.
fn ceiling_quotient(numerator: &IBig, denominator: &IBig) -> IBig {
    -(-numerator).div_euclid(denominator)
}

/// The quotient by a power of two, rounded up.
fn ceiling_shift(value: &IBig, places: usize) -> IBig {
    -(-value >> places)
}

/// The square root of an integer that is not negative, rounded down, and whether it is exact.
pub(super) fn root(value: &IBig) -> (IBig, bool) {
    let (root, rest) = value.unsigned_abs().sqrt_rem();
    (root.into(), rest.is_zero())
}

impl Add for Interval {
    type Output = Interval;
    fn add(self, other: Interval) -> Interval {
        let (one, two, bits) = aligned(&self, &other);
        Interval { lower: one.lower + two.lower, upper: one.upper + two.upper, bits }
    }
}

impl Sub for Interval {
    type Output = Interval;
    fn sub(self, other: Interval) -> Interval {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval { lower: -self.upper, upper: -self.lower, bits: self.bits }
    }
}

impl Mul for Interval {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        self.count_steps(&other);
        let (one, two, bits) = aligned(&self, &other);
        let (mut least, mut greatest) = (&one.lower * &two.lower, &one.upper * &two.upper);
        if one.lower < IBig::ZERO || two.lower < IBig::ZERO {
            // Any of the four corners may be the least or the greatest product.
            let corners = [least, greatest, &one.lower * &two.upper, &one.upper * &two.lower];
            least = corners.iter().min().cloned().unwrap_or_default();
            greatest = corners.into_iter().max().unwrap_or_default();
        }
        Interval { lower: least >> bits, upper: ceiling_shift(&greatest, bits), bits }
    }
}

/// Both ends as doubles, for failing tests: `[2.5, 2.75] (64 bits)`.
impl fmt::Debug for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}] ({} bits)", self.lower().to_f64(), self.upper().to_f64(), self.bits)
    }
}

#[cfg(test)]
mod tests {
    use rand::rngs::ChaCha8Rng;
    use rand::{RngExt, SeedableRng};

    use super::*;

    fn read(text: &str) -> Fraction {
        text.parse().unwrap()
    }

    /// The narrowest interval around both.
    fn between(lower: &str, upper: &str, bits: usize) -> Interval {
        Interval::from_fraction(&read(lower), bits).hull(&Interval::from_fraction(&read(upper), bits))
    }

    fn ends(interval: &Interval) -> [String; 2] {
        [interval.lower().to_string(), interval.upper().to_string()]
    }

    #[test]
    fn ends_are_rounded_outwards() {
        // A third in units of 1/8 lies between 2 and 3 of them; 3/4 is 6 of them.
        assert_eq!(ends(&Interval::from_fraction(&read("1/3"), 3)), ["1/4", "3/8"]);
        assert_eq!(ends(&Interval::from_fraction(&read("-1/3"), 3)), ["-3/8", "-1/4"]);
        assert_eq!(ends(&Interval::from_fraction(&read("3/4"), 3)), ["3/4", "3/4"]);
        let eighth = between("-3/8", "3/8", 3);
        assert_eq!(ends(&eighth.with_bits(2)), ["-1/2", "1/2"]);
        assert_eq!(ends(&eighth.with_bits(9)), ["-3/8", "3/8"]);
        assert_eq!(eighth.width(), read("3/4"));
    }

    #[test]
    fn arithmetic_on_wide_intervals_takes_the_worst_corners() {
        let products = [
            (("2", "3"), ("4", "5"), ["8", "15"]),
            (("-2", "3"), ("4", "5"), ["-10", "15"]),
            (("-3", "-2"), ("4", "5"), ["-15", "-8"]),
            (("-3", "-2"), ("-5", "4"), ["-12", "15"]),
            (("-2", "3"), ("-5", "4"), ["-15", "12"]),
            (("-3", "-2"), ("-5", "-4"), ["8", "15"]),
        ];
        for ((a, b), (c, d), expected) in products {
            assert_eq!(ends(&(between(a, b, 8) * between(c, d, 8))), expected);
            assert_eq!(ends(&(between(c, d, 5) * between(a, b, 8))), expected);
        }
        let quotients = [
            (("2", "3"), ("4", "8"), ["1/4", "3/4"]),
            (("-2", "3"), ("4", "8"), ["-1/2", "3/4"]),
            (("-3", "-2"), ("4", "8"), ["-3/4", "-1/4"]),
            (("2", "3"), ("-8", "-4"), ["-3/4", "-1/4"]),
            (("-2", "3"), ("-8", "-4"), ["-3/4", "1/2"]),
        ];
        for ((a, b), (c, d), expected) in quotients {
            assert_eq!(ends(&between(a, b, 8).checked_div(&between(c, d, 8)).unwrap()), expected);
        }
        assert_eq!(ends(&(between("1", "2", 3) - between("1/2", "5", 4))), ["-4", "3/2"]);
        assert_eq!(ends(&between("-3", "2", 3).abs()), ["0", "3"]);
        assert_eq!(ends(&between("-3", "-2", 3).abs()), ["2", "3"]);
        assert_eq!(Interval::integer(1, 8).checked_div(&between("-1", "1", 8)), None);
        assert_eq!(Interval::integer(1, 8).checked_div(&Interval::integer(0, 8)), None);
    }

    #[test]
    fn signs_are_decided_only_where_they_are_certain() {
        for (lower, upper, sign) in [
            ("1/8", "1", Some(Ordering::Greater)),
            ("-1", "-1/8", Some(Ordering::Less)),
            ("0", "0", Some(Ordering::Equal)),
            ("0", "1", None),
            ("-1", "0", None),
            ("-1", "1", None),
        ] {
            let interval = between(lower, upper, 3);
            assert_eq!(interval.sign(), sign, "{interval:?}");
            assert_eq!(interval.contains_zero(), !matches!(sign, Some(Ordering::Greater | Ordering::Less)));
        }
    }

    #[test]
    fn common_parts() {
        let (low, high) = (between("0", "2", 4), between("1", "3", 9));
        assert_eq!(ends(&low.intersection(&high).unwrap()), ["1", "2"]);
        assert!(low.overlaps(&between("2", "3", 4)));
        assert!(!low.overlaps(&between("33/16", "3", 4)));
    }

    #[test]
    fn square_roots() {
        assert_eq!(ends(&Interval::from_fraction(&read("9/4"), 2).sqrt().unwrap()), ["3/2", "3/2"]);
        assert_eq!(ends(&Interval::integer(2, 2).sqrt().unwrap()), ["5/4", "3/2"]);
        assert_eq!(ends(&between("-1", "4", 2).sqrt().unwrap()), ["0", "2"]);
        assert_eq!(between("-2", "-1/4", 2).sqrt(), None);
    }

    #[test]
    fn doubles_come_from_the_middle() {
        assert_eq!(between("1", "2", 64).to_f64(), 1.5);
        assert_eq!(Interval::from_fraction(&read("1/3"), 5000).to_f64(), 1.0 / 3.0);
        assert_eq!(Interval::integer(-3, 5000).to_f64(), -3.0);
    }

    #[test]
    fn no_chain_of_operations_loses_the_exact_value() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        for bits in [0, 5, 64, 192] {
            for _ in 0..40 {
                let mut exact = Fraction::ONE;
                let mut enclosure = Interval::integer(1, bits);
                for _ in 0..12 {
                    let value = Fraction::new(random.random_range(-60..=60), random.random_range(1..=30));
                    let operand = Interval::from_fraction(&value, bits);
                    (exact, enclosure) = match random.random_range(0..5) {
                        0 => (exact + value, enclosure + operand),
                        1 => (value - exact, operand - enclosure),
                        2 => (exact * value, enclosure * operand),
                        3 => match enclosure.checked_div(&operand) {
                            Some(quotient) => (exact / value, quotient),
                            None => (exact, enclosure),
                        },
                        _ => ((&exact * &exact), (enclosure.clone() * enclosure)),
                    };
                    assert!(enclosure.contains(&exact), "{exact} is not in {enclosure:?}");
                    if enclosure.width() > Fraction::from(1000) {
                        (exact, enclosure) = (Fraction::ONE, Interval::integer(1, bits));
                    }
                    let square = Interval::from_fraction(&(&exact * &exact), bits);
                    assert!(square.sqrt().unwrap().contains(&exact.abs()), "{exact}");
                }
            }
        }
    }
}
