//! Certified enclosures of exact values, and the decimals that they prove.

use std::cell::RefCell;
use std::collections::HashMap;
use std::hash::Hash;
use std::ops::{Add, Mul};
use std::thread::LocalKey;

use foldhash::fast::FixedState;
use smallvec::SmallVec;

use super::decimal::{Decimal, Places};
use super::polynomial::Polynomial;
use super::rounding::{Uncertain, round, round_certified};
use super::terms::Roots;
use super::value::{Root, Value};
use super::{FloatInterval, Fraction, Interval, Letter};

/// What the letters stand for while a value is enclosed: for an angle its tangent.
pub type Assignment<'a> = &'a dyn Fn(Letter) -> Option<Interval>;

/// What a value is enclosed by: ends with as many binary places as are wanted, or two doubles.
trait Enclosure: Clone + Add<Output = Self> + Mul<Output = Self> {
    fn of_fraction(value: &Fraction, bits: usize) -> Self;
    fn over(self, divisor: Self) -> Option<Self>;
    fn root(self) -> Option<Self>;
    /// The cosine and tangent of so many degrees.
    fn cosine_and_tangent(letter: Letter, bits: usize) -> Option<(Self, Self)>;
}

impl Enclosure for Interval {
    fn of_fraction(value: &Fraction, bits: usize) -> Interval {
        Interval::from_fraction(value, bits)
    }

    fn over(self, divisor: Interval) -> Option<Interval> {
        self.checked_div(&divisor)
    }

    fn root(self) -> Option<Interval> {
        self.sqrt()
    }

    fn cosine_and_tangent(letter: Letter, bits: usize) -> Option<(Interval, Interval)> {
        cosine_and_tangent(letter, bits)
    }
}

impl Enclosure for FloatInterval {
    fn of_fraction(value: &Fraction, _: usize) -> FloatInterval {
        FloatInterval::from_fraction(value)
    }

    fn over(self, divisor: FloatInterval) -> Option<FloatInterval> {
        self.checked_div(divisor)
    }

    fn root(self) -> Option<FloatInterval> {
        self.sqrt()
    }

    fn cosine_and_tangent(letter: Letter, _: usize) -> Option<(FloatInterval, FloatInterval)> {
        thread_local!(static ANGLES: RefCell<Angles<Letter, FloatInterval>> = RefCell::default());
        remembered(&ANGLES, letter, || {
            let (cosine, tangent) = cosine_and_tangent(letter, 96)?;
            Some((FloatInterval::from_interval(&cosine), FloatInterval::from_interval(&tangent)))
        })
    }
}

impl Value {
    /// An interval that surely holds the value, about `bits` binary places wide; `None` if a letter
    /// has no number, or the precision does not yet suffice for a quotient or a root.
    pub fn enclose(&self, bits: usize, at: Assignment) -> Option<Interval> {
        self.enclosed(bits, at)
    }

    /// Two doubles that surely hold a value without letters: nearly always enough to decide by. `None` if it has letters, or if
    /// doubles do not suffice.
    pub(crate) fn between_doubles(&self) -> Option<FloatInterval> {
        self.between_doubles_at(&|_| None)
    }

    /// The same where the letters have these numbers.
    pub(crate) fn between_doubles_at(&self, at: &dyn Fn(Letter) -> Option<FloatInterval>) -> Option<FloatInterval> {
        self.enclosed(0, at).filter(|ends: &FloatInterval| ends.is_finite())
    }

    fn enclosed<E: Enclosure>(&self, bits: usize, at: &dyn Fn(Letter) -> Option<E>) -> Option<E> {
        let (terms, denominator) = match self {
            Value::Rational(number) => return Some(E::of_fraction(number, bits)),
            Value::Compound(compound) => (&compound.terms, &compound.denominator),
        };
        let mut known: SmallVec<[(Letter, E); 2]> = SmallVec::new();
        let mut letter = |letter: Letter| -> Option<E> {
            if let Some((_, value)) = known.iter().find(|(other, _)| *other == letter) {
                return Some(value.clone());
            }
            let value = if letter.is_constant() { E::cosine_and_tangent(letter, bits)?.1 } else { at(letter)? };
            known.push((letter, value.clone()));
            Some(value)
        };
        let mut sum = E::of_fraction(&Fraction::ZERO, bits);
        for (roots, coefficient) in terms.iter() {
            let mut term = enclose_polynomial(coefficient, bits, &mut letter)?;
            for root in roots {
                term = term * enclose_root(root, bits, at)?;
            }
            sum = sum + term;
        }
        if denominator.is_one() { Some(sum) } else { sum.over(enclose_polynomial(denominator, bits, &mut letter)?) }
    }

    /// An enclosure of a value without letters.
    pub fn enclose_constant(&self, bits: usize) -> Option<Interval> {
        self.enclose(bits, &|_| None)
    }

    /// The value rounded half up, every digit proved. Fails for a value with letters.
    ///
    /// ```
    /// use carom::number::{Places, Value};
    /// let speed = Value::fraction(208, 27).square_root().unwrap();
    /// assert_eq!(speed.rounded(&Places::SignificantFigures(3)).unwrap().to_string(), "2.78");
    /// ```
    pub fn rounded(&self, places: &Places) -> Result<Decimal, Uncertain> {
        match self {
            Value::Rational(number) => Ok(round(number, places)),
            _ if !self.is_constant() => Err(Uncertain),
            _ => round_certified(
                |bits| self.enclose_constant(bits),
                |tie: &Fraction| (self - &Value::Rational(tie.clone())).is_zero(),
                places,
            ),
        }
    }

    /// The nearest double or one beside it, for charts and columns of floats; none if letters remain.
    pub fn to_f64(&self) -> Option<f64> {
        match self {
            Value::Rational(number) => Some(number.to_f64()),
            _ => self.enclose_constant(96).map(|interval| interval.to_f64()),
        }
    }
}

impl Value {
    /// About the value, where the letters have these numbers, of an angle the tangent; not a number where it does not
    /// exist. No digit is proved.
    pub fn nearly(&self, at: &dyn Fn(Letter) -> f64) -> f64 {
        let number = |letter: Letter| match letter.is_constant() {
            true => letter.name().parse::<Fraction>().map_or(f64::NAN, |degrees| degrees.to_f64().to_radians().tan()),
            false => at(letter),
        };
        let polynomial = |polynomial: &Polynomial| -> f64 {
            let powers = |monomial: &[(Letter, u32)]| -> f64 {
                monomial.iter().map(|(letter, power)| number(*letter).powi(*power as i32)).product()
            };
            polynomial.terms().iter().map(|(monomial, coefficient)| coefficient.to_f64() * powers(monomial)).sum()
        };
        match self {
            Value::Rational(number) => number.to_f64(),
            Value::Compound(compound) => {
                let root = |root: &Root| match root {
                    Root::Prime(prime) => (*prime as f64).sqrt(),
                    Root::Cosine(letter) => 1.0 / number(*letter).hypot(1.0),
                    Root::Nested { radicand, .. } => radicand.nearly(at).sqrt(),
                };
                let term = |(roots, coefficient): (&Roots, &Polynomial)| {
                    polynomial(coefficient) * roots.iter().map(root).product::<f64>()
                };
                compound.terms.iter().map(term).sum::<f64>() / polynomial(&compound.denominator)
            }
        }
    }
}

/// How many angles are remembered at once.
const MOST_ANGLES: usize = 512;

/// The cosine and tangent of each angle that is remembered.
type Angles<K, E> = HashMap<K, (E, E), FixedState>;

/// The cosine and tangent of so many degrees. The same angle comes back in every quantity of a scene,
/// so it is remembered.
fn cosine_and_tangent(letter: Letter, bits: usize) -> Option<(Interval, Interval)> {
    thread_local!(static ANGLES: RefCell<Angles<(Letter, usize), Interval>> = RefCell::default());
    remembered(&ANGLES, (letter, bits), || {
        let angle = radians(letter, bits)?;
        Some((angle.cos(), angle.tan()?))
    })
}

/// What is remembered of an angle, or found and remembered.
fn remembered<K: Eq + Hash, E: Clone>(
    angles: &'static LocalKey<RefCell<Angles<K, E>>>,
    key: K,
    find: impl FnOnce() -> Option<(E, E)>,
) -> Option<(E, E)> {
    if let Some(known) = angles.with_borrow(|angles| angles.get(&key).cloned()) {
        return Some(known);
    }
    let both = find()?;
    angles.with_borrow_mut(|angles| {
        if angles.len() >= MOST_ANGLES {
            angles.clear();
        }
        angles.insert(key, both.clone());
    });
    Some(both)
}

fn radians(letter: Letter, bits: usize) -> Option<Interval> {
    let degrees: Fraction = letter.name().parse().ok()?;
    let turn = &degrees / &Fraction::from(180);
    Some(Interval::pi(bits) * Interval::from_fraction(&turn, bits))
}

fn enclose_root<E: Enclosure>(root: &Root, bits: usize, at: &dyn Fn(Letter) -> Option<E>) -> Option<E> {
    match root {
        Root::Cosine(letter) if letter.is_constant() => E::cosine_and_tangent(*letter, bits).map(|(cosine, _)| cosine),
        Root::Nested { radicand, .. } => radicand.enclosed(bits, at)?.root(),
        other => other.square().enclosed(bits, at)?.root(),
    }
}

fn enclose_polynomial<E: Enclosure>(
    polynomial: &Polynomial,
    bits: usize,
    letter: &mut dyn FnMut(Letter) -> Option<E>,
) -> Option<E> {
    let mut sum = E::of_fraction(&Fraction::ZERO, bits);
    for (monomial, coefficient) in polynomial.terms() {
        let mut term = E::of_fraction(coefficient, bits);
        for (name, power) in monomial {
            let base = letter(*name)?;
            for _ in 0..*power {
                term = term * base.clone();
            }
        }
        sum = sum + term;
    }
    Some(sum)
}
