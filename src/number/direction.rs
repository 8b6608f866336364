//! Directions as exact sines and cosines: given degrees, acute letters, and sums of angles.

use super::{Fraction, Letter, Range, Value};

/// The cosine and sine of an angle. Angles add by multiplying as complex numbers do, so a sum of
/// angles needs no formula of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Direction {
    /// The cosine.
    pub cos: Value,
    /// The sine.
    pub sin: Value,
}

impl Direction {
    /// The direction of so many degrees, any rational number of them.
    ///
    /// Multiples of 15 degrees are surds. Any other angle is brought into the first quadrant by the signs of
    /// its sine and cosine, and its tangent is a letter that stands for itself. `None` if the number of degrees is too long to
    /// be the name of a letter.
    pub fn degrees(degrees: &Fraction) -> Option<Direction> {
        let right = Fraction::from(90);
        let turns = (degrees / &right).floor();
        let quarter = &turns & 3u8;
        let rest = degrees - &(&Fraction::from(turns) * &right);
        // Mirrored in the axes, as 160° is taken for 180° - 20°: so angles of both sides have one letter.
        let acute = if quarter.is_multiple_of(2) { rest } else { &right - &rest };
        let Direction { cos, sin } = acute_degrees(&acute)?;
        Some(match quarter {
            0 => Direction { cos, sin },
            1 => Direction { cos: -cos, sin },
            2 => Direction { cos: -cos, sin: -sin },
            _ => Direction { cos, sin: -sin },
        })
    }

    /// The direction of an acute angle that is a letter.
    pub fn acute(tangent: Letter) -> Direction {
        Direction { cos: Value::cosine(tangent), sin: Value::sine(tangent) }
    }

    /// The direction between -90 and 90 degrees with this tangent.
    pub fn of_tangent(tangent: &Value) -> Option<Direction> {
        let secant = (&Value::ONE + &(tangent * tangent)).square_root()?;
        let cos = secant.reciprocal()?;
        Some(Direction { sin: tangent * &cos, cos })
    }

    /// The direction between -90 and 90 degrees with this sine; `None` if the sine is known to be
    /// larger than one in size.
    pub fn of_sine(sine: &Value) -> Option<Direction> {
        let cos = (&Value::ONE - &(sine * sine)).square_root()?;
        Some(Direction { cos, sin: sine.clone() })
    }

    /// The direction between 0 and 180 degrees with this cosine.
    pub fn of_cosine(cosine: &Value) -> Option<Direction> {
        Direction::of_sine(cosine).map(|Direction { cos, sin }| Direction { cos: sin, sin: cos })
    }

    /// The direction of the sum of the two angles.
    pub fn plus(&self, other: &Direction) -> Direction {
        Direction {
            cos: &(&self.cos * &other.cos) - &(&self.sin * &other.sin),
            sin: &(&self.sin * &other.cos) + &(&self.cos * &other.sin),
        }
    }

    /// The direction of the angle with its sign changed.
    pub fn reversed(&self) -> Direction {
        Direction { cos: self.cos.clone(), sin: -&self.sin }
    }

    /// The direction of a whole multiple of the angle.
    pub fn times(&self, count: i32) -> Direction {
        let base = if count < 0 { self.reversed() } else { self.clone() };
        let none = Direction { cos: Value::ONE, sin: Value::ZERO };
        (0..count.unsigned_abs()).fold(none, |sum, _| sum.plus(&base))
    }

    /// The tangent; `None` at a right angle.
    pub fn tangent(&self) -> Option<Value> {
        self.sin.divided_by(&self.cos)
    }
}

/// From nought up to 90 degrees.
fn acute_degrees(degrees: &Fraction) -> Option<Direction> {
    let root = |n: i64| Value::from(n).square_root().expect("a positive number has a root");
    let half = Value::fraction(1, 2);
    let quarter = Value::fraction(1, 4);
    let (cos, sin) = match degrees.as_small() {
        Some((0, 1)) => (Value::ONE, Value::ZERO),
        Some((15, 1)) => (&(&root(6) + &root(2)) * &quarter, &(&root(6) - &root(2)) * &quarter),
        Some((30, 1)) => (&root(3) * &half, half),
        Some((45, 1)) => (&root(2) * &half, &root(2) * &half),
        Some((60, 1)) => (half.clone(), &root(3) * &half),
        Some((90, 1)) => (Value::ZERO, Value::ONE),
        Some((75, 1)) => (&(&root(6) - &root(2)) * &quarter, &(&root(6) + &root(2)) * &quarter),
        _ => {
            let tangent = Letter::new(&degrees.to_string(), Range::Degrees)?;
            (Value::cosine(tangent), Value::sine(tangent))
        }
    };
    Some(Direction { cos, sin })
}
