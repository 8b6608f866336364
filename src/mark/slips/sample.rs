//! Numbers at three points: a formula in letters by what it comes to there, a plain number three times over; or at one,
//! where there are no letters.

use std::cell::Cell;
use std::ops::{Add, Mul, Neg, Sub};

use crate::mechanics::{Datum, Known};
use crate::number::{FloatInterval, Fraction, Interval, Letter, Number, Range, Value};

/// How many points there are.
pub(super) const POINTS: usize = 3;

/// A difference that is smaller than this part of what it is a difference of is nought: floats leave noise behind.
const NOISE: f64 = 1e-13;

/// A number at each of the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample<const N: usize = POINTS>(pub(super) [f64; N]);

impl<const N: usize> Sample<N> {
    /// The same number at every point.
    pub(super) fn constant(value: f64) -> Sample<N> {
        Sample([value; N])
    }

    /// An exact value at the points; `None` where it does not exist.
    pub(super) fn of(value: &Value) -> Option<Sample<N>> {
        if let Some(number) = value.as_fraction() {
            return Some(Sample::constant(number.to_f64()));
        }
        if value.is_constant() {
            let near = value.between_doubles().and_then(FloatInterval::sharp);
            return near.or_else(|| value.to_f64()).map(Sample::constant);
        }
        let mut sample = [0.0; N];
        for (point, at_point) in sample.iter_mut().enumerate() {
            let near = value.between_doubles_at(&|letter| Some(FloatInterval::from_fraction(&at(letter, point))));
            let finely = || value.enclose(96, &|letter| Some(Interval::from_fraction(&at(letter, point), 96)));
            *at_point = match near.and_then(FloatInterval::sharp) {
                Some(near) => near,
                // Where terms cancel doubles have too few figures.
                None => finely()?.to_f64(),
            };
        }
        Some(Sample(sample))
    }

    /// About a value, where its letters are these numbers, of an angle the tangent; not a number where it does not exist.
    pub(super) fn nearly(value: &Value, letters: &dyn Fn(Letter) -> Option<Sample<N>>) -> Sample<N> {
        let varies = Cell::new(false);
        let at = |point: usize| {
            value.nearly(&|letter| {
                let number = letters(letter).unwrap_or(Sample::constant(f64::NAN));
                varies.set(varies.get() || !number.is_constant());
                number.0[point]
            })
        };
        let first = at(0);
        Sample(std::array::from_fn(|point| if point == 0 || !varies.get() { first } else { at(point) }))
    }

    /// What a letter stands for; of an angle its tangent.
    pub(super) fn of_tangent(letter: Letter) -> Sample<N> {
        Sample(std::array::from_fn(|point| at(letter, point).to_f64()))
    }

    /// What a letter stands for; of an angle the angle in radians.
    pub(super) fn of_letter(letter: Letter) -> Sample<N> {
        let numbers = Sample::of_tangent(letter);
        if letter.range() == Range::Acute { numbers.map(f64::atan) } else { numbers }
    }

    /// Is it the same at every point, as all is where there are no letters?
    fn is_constant(self) -> bool {
        self.0[1..].iter().all(|value| *value == self.0[0])
    }

    pub(super) fn map(self, change: impl Fn(f64) -> f64) -> Sample<N> {
        if self.is_constant() { Sample::constant(change(self.0[0])) } else { Sample(self.0.map(change)) }
    }

    pub(super) fn with(self, other: Sample<N>, combine: impl Fn(f64, f64) -> f64) -> Sample<N> {
        if self.is_constant() && other.is_constant() {
            return Sample::constant(combine(self.0[0], other.0[0]));
        }
        Sample(std::array::from_fn(|point| combine(self.0[point], other.0[point])))
    }

    /// Is it a number at every point?
    pub(super) fn is_finite(self) -> bool {
        self.0.iter().all(|value| value.is_finite())
    }

    /// Is it the same, but for so small a part?
    pub(super) fn is_near(self, other: Sample<N>, part: f64) -> bool {
        self.0.iter().zip(other.0).all(|(one, two)| (one - two).abs() <= part * one.abs().max(two.abs()).max(1e-3))
    }
}

/// What a letter stands for at a point, inside its physical range; for an angle the tangent. The points are fixed, so
/// that the same answer is always recognised as the same. At the first point speeds, masses and lengths are one: there a
/// value is its own coefficient.
fn at(letter: Letter, point: usize) -> Fraction {
    let seed = 11 + 37 * point as i64;
    let spread = letter.name().bytes().fold(seed, |sum, byte| (sum * 31 + i64::from(byte)) % 97);
    match letter.range() {
        Range::Unit => Fraction::new(spread + 2, 101),
        Range::Real => Fraction::new(2 * spread - 97, 31),
        Range::Positive if point == 0 => Fraction::ONE,
        _ => Fraction::new(spread + 17, 31),
    }
}

/// A sum from which noise is taken.
fn sum(one: f64, two: f64) -> f64 {
    let sum = one + two;
    if sum.abs() <= NOISE * (one.abs() + two.abs()) { 0.0 } else { sum }
}

impl<const N: usize> Add for Sample<N> {
    type Output = Sample<N>;
    fn add(self, other: Sample<N>) -> Sample<N> {
        self.with(other, sum)
    }
}

impl<const N: usize> Sub for Sample<N> {
    type Output = Sample<N>;
    fn sub(self, other: Sample<N>) -> Sample<N> {
        self + -other
    }
}

impl<const N: usize> Mul for Sample<N> {
    type Output = Sample<N>;
    fn mul(self, other: Sample<N>) -> Sample<N> {
        self.with(other, |one, two| one * two)
    }
}

impl<const N: usize> Neg for Sample<N> {
    type Output = Sample<N>;
    fn neg(self) -> Sample<N> {
        self.map(|value| -value)
    }
}

impl<const N: usize> Number for Sample<N> {
    fn scaled(&self, factor: &Fraction) -> Sample<N> {
        let factor = factor.to_f64();
        self.map(|value| value * factor)
    }
    fn one(&self) -> Sample<N> {
        Sample::constant(1.0)
    }
    fn over(&self, divisor: &Sample<N>) -> Option<Sample<N>> {
        divisor.0.iter().all(|value| *value != 0.0).then(|| self.with(*divisor, |one, two| one / two))
    }
    fn root(&self) -> Option<Sample<N>> {
        self.0.iter().all(|value| *value >= 0.0).then(|| self.map(f64::sqrt))
    }
    fn size(&self) -> Sample<N> {
        self.map(f64::abs)
    }
    fn is_nought(&self) -> bool {
        self.0 == [0.0; N]
    }
    /// At the first point masses are one.
    fn coefficient(&self) -> Sample<N> {
        Sample::constant(self.0[0])
    }
    // Without a fraction on the way: these are what the laws do most.
    fn nought(&self) -> Sample<N> {
        Sample::constant(0.0)
    }
    fn half(&self) -> Sample<N> {
        self.map(|value| value / 2.0)
    }
}

/// All that is given, at the points; `None` if a value does not exist there.
pub(super) fn sampled<const N: usize>(given: &Known<Value>) -> Option<Known<Sample<N>>> {
    let mut known = Known::default();
    for (quantity, datum) in given.0.iter() {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(Sample::of(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: Sample::of(y)?, x: Sample::of(x)? },
            Datum::Equation(_) => continue,
        };
        known.0.insert(*quantity, datum);
    }
    Some(known)
}
