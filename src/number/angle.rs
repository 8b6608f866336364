//! Angles that are asked for: exact through their tangent, in degrees at the end.

use std::cmp::Ordering;

use super::decimal::{Decimal, Places};
use super::enclose::Assignment;
use super::rounding::{Uncertain, round, round_certified};
use super::value::Root;
use super::{Direction, FloatInterval, Fraction, Interval, Letter, Value};

/// The angle from the positive x-direction to the vector `(x, y)`, anticlockwise, above -180 and up
/// to 180 degrees.
///
/// Where the sign of `x` is known and it is no long sum of roots, the vector is scaled to `x = 1`, `-1` or `0`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angle {
    y: Value,
    x: Value,
}

impl Angle {
    /// The size in degrees, without its sign, of the angle of a direction with these components: two doubles that surely hold
    /// it. `None` where a component has letters, or doubles do not suffice.
    pub(crate) fn size_between_doubles(y: &Value, x: &Value) -> Option<FloatInterval> {
        let (y, x) = (y.between_doubles()?, x.between_doubles()?);
        let acute = (y.checked_div(x)?.abs().atan() * FloatInterval::point(180.0)).checked_div(FloatInterval::pi())?;
        Some(if x.upper < 0.0 { FloatInterval::point(180.0) - acute } else { acute })
    }

    /// The angle of a vector; `None` for the vector nought.
    pub fn of(y: &Value, x: &Value) -> Option<Angle> {
        if x.is_zero() {
            return match y.sign() {
                Some(Ordering::Equal) => None,
                Some(Ordering::Less) => Some(Angle { y: Value::from(-1), x: Value::ZERO }),
                Some(Ordering::Greater) => Some(Angle { y: Value::ONE, x: Value::ZERO }),
                None => Some(Angle { y: y.clone(), x: Value::ZERO }),
            };
        }
        if y.is_zero() {
            return match x.sign() {
                Some(Ordering::Less) => Some(Angle { y: Value::ZERO, x: Value::from(-1) }),
                Some(_) => Some(Angle { y: Value::ZERO, x: Value::ONE }),
                None => Some(Angle { y: Value::ZERO, x: x.clone() }),
            };
        }
        if is_rationalised(x) {
            // To divide would be to rationalise the denominator, root after root, for nothing; but what both
            // share may be all that makes it so.
            let (y, x) = Value::without_common_factors(y, x);
            return if is_rationalised(&x) { Some(Angle { y, x }) } else { Angle::of(&y, &x) };
        }
        let (scale, unit) = match x.sign() {
            Some(Ordering::Less) => (-x, Value::from(-1)),
            Some(_) => (x.clone(), Value::ONE),
            None => return Some(Angle { y: y.clone(), x: x.clone() }),
        };
        Some(Angle { y: y.divided_by(&scale)?, x: unit })
    }

    /// The angle of a vector as it is, not scaled: for equations, in which a division would only bring
    /// in a factor.
    pub fn unscaled(y: &Value, x: &Value) -> Angle {
        Angle { y: y.clone(), x: x.clone() }
    }

    /// The acute angle between the vector and the x-axis, from 0 to 90 degrees.
    pub fn acute(y: &Value, x: &Value) -> Option<Angle> {
        Angle::of(&y.absolute(), &x.absolute())
    }

    /// The angle between two directions, from 0 to 180 degrees, by their cross and scalar product.
    pub fn between(cross: &Value, dot: &Value) -> Option<Angle> {
        Angle::of(&cross.absolute(), dot)
    }

    /// The vector's y-component, scaled as the type says.
    pub fn y(&self) -> &Value {
        &self.y
    }

    /// The vector's x-component, scaled as the type says.
    pub fn x(&self) -> &Value {
        &self.x
    }

    /// The letters it depends on.
    pub fn letters(&self) -> Vec<Letter> {
        let mut letters = self.y.letters();
        letters.extend(self.x.letters());
        letters.sort();
        letters.dedup();
        letters
    }

    /// Is it a number of degrees, without letters?
    pub fn is_constant(&self) -> bool {
        self.y.is_constant() && self.x.is_constant()
    }

    /// The number of degrees, where it is a rational one that one would look for: a whole one or quarters, such as lie half
    /// way between whole and half ones, or one as fine as the angles that were given. Found by measuring, then proved.
    pub fn whole_degrees(&self) -> Option<Fraction> {
        let letters = self.letters();
        if !letters.iter().all(Letter::is_constant) {
            return None;
        }
        let fine = letters.iter().filter_map(|letter| letter.name().parse::<Fraction>().ok());
        let denominator = fine.fold(Fraction::from(4), |product, given| {
            let below = Fraction::from(given.denominator());
            if (&product / &below).is_integer() { product } else { &product * &below }
        });
        if self.is_between_parts_of_a_degree(&denominator) || self.is_no_rational_number_of_degrees() {
            return None;
        }
        if let Some(candidate) = self.nearest_by_doubles(&denominator) {
            return self.is_degrees(&candidate).then_some(candidate);
        }
        let measured = self.enclose(64, &|_| None)?;
        let middle = &(&measured.lower() + &measured.upper()) * &Fraction::new(1, 2);
        let steps = Fraction::from((&(&middle * &denominator) + &Fraction::new(1, 2)).floor());
        let candidate = &steps / &denominator;
        let gap = (&middle - &candidate).abs();
        (gap < Fraction::new(1, 1 << 40) && self.is_degrees(&candidate)).then_some(candidate)
    }

    /// The whole number of such parts of a degree that it must be if it is one, measured in doubles.
    fn nearest_by_doubles(&self, denominator: &Fraction) -> Option<Fraction> {
        const MOST: f64 = 1e8;
        let size = Angle::size_between_doubles(&self.y, &self.x)?;
        let sign = if self.y.between_doubles()?.sign()?.is_lt() { -1 } else { 1 };
        let parts = denominator.to_f64();
        let steps = (size.lower * parts).round();
        let is_one = steps == (size.upper * parts).round() && steps < MOST;
        is_one.then(|| &Fraction::from(steps as i64 * sign) / denominator)
    }

    /// Is it surely no whole number of such parts of a degree? Nearly always doubles show it.
    fn is_between_parts_of_a_degree(&self, denominator: &Fraction) -> bool {
        const SLACK: f64 = 1e-6;
        let parts = denominator.to_f64();
        Angle::size_between_doubles(&self.y, &self.x).is_some_and(|size| {
            let (low, high) = (size.lower * parts, size.upper * parts);
            high - low < SLACK && high < 1e8 && (low - low.round()).abs() > 2.0 * SLACK
        })
    }

    /// Does the square of its tangent `t²` show it? If that is rational, so is `cos 2θ = (1 − t²)/(1 + t²)`, and of rational
    /// numbers of degrees only cosines of 0, ±1/2 and ±1 are rational (Niven's theorem): `t²` is 0, 1/3, 1 or 3.
    fn is_no_rational_number_of_degrees(&self) -> bool {
        let square = |value: &Value| (value * value).as_fraction().cloned();
        let Some((y, x)) = square(&self.y).zip(square(&self.x)) else { return false };
        let three = Fraction::from(3);
        !(y.is_zero() || x.is_zero() || y == x || y == &x * &three || &y * &three == x)
    }

    /// Is it exactly this number of degrees?
    pub fn is_degrees(&self, degrees: &Fraction) -> bool {
        let Some(direction) = Direction::degrees(degrees) else { return false };
        let cross = &(&self.y * &direction.cos) - &(&self.x * &direction.sin);
        let dot = &(&self.x * &direction.cos) + &(&self.y * &direction.sin);
        cross.is_zero() && dot.sign() == Some(Ordering::Greater)
    }

    /// An enclosure in degrees; `None` as for [`Value::enclose`].
    pub fn enclose(&self, bits: usize, at: Assignment) -> Option<Interval> {
        let radians = Interval::atan2(&self.y.enclose(bits, at)?, &self.x.enclose(bits, at)?)?;
        (radians * Interval::integer(180, bits)).checked_div(&Interval::pi(bits))
    }

    /// Degrees, rounded half up, every digit proved. Fails if letters remain.
    pub fn rounded(&self, places: &Places) -> Result<Decimal, Uncertain> {
        match self.whole_degrees() {
            Some(exact) => Ok(round(&exact, places)),
            None if !self.is_constant() => Err(Uncertain),
            None => round_certified(|bits| self.enclose(bits, &|_| None), |tie| self.is_degrees(tie), places),
        }
    }
}

/// Would a division by it be long, or with letters make pages of a sum with a root in it or of a root of a formula?
fn is_rationalised(x: &Value) -> bool {
    let roots = x.roots();
    let is_long = || x.is_sum_of_roots() || roots.iter().any(|root| matches!(root, Root::Nested { .. }));
    x.is_laborious() || (!roots.is_empty() && !x.is_constant() && is_long())
}
