//! Angles inside an expression: a rational number of degrees and the angle of a vector.

use std::cmp::Ordering;

use crate::number::{Angle, Direction, Fraction, Interval, Value};

/// The longest number, in bits, in an angle that is multiplied: about 300 figures.
const LONGEST: usize = 1_000;

/// A multiple of a multiple of an angle grows by its factor, and has no more terms than these.
const MOST_TERMS: usize = 48;

/// The most nested roots inside each other in an angle that is halved: every halving puts a root around the last, so that an
/// eighth of an acute letter has two.
const DEEPEST: u32 = 1;

/// An angle that can be added to others: so many degrees, and the angle of a vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    /// The part that is a rational number of degrees.
    pub degrees: Fraction,
    /// The part that is known through its tangent, such as `atan(3/4)` or a letter.
    pub rest: Option<Angle>,
}

impl Turn {
    /// So many degrees.
    pub fn degrees(degrees: Fraction) -> Turn {
        Turn { degrees, rest: None }
    }

    /// The angle of a vector.
    pub fn of(angle: Angle) -> Turn {
        match angle.whole_degrees() {
            Some(degrees) => Turn::degrees(degrees),
            None => Turn { degrees: Fraction::ZERO, rest: Some(angle) },
        }
    }

    /// The sum of two angles; `None` if their numbers are so long that nobody can wait for it.
    pub fn plus(&self, other: &Turn) -> Option<Turn> {
        let rest = match (&self.rest, &other.rest) {
            (None, rest) | (rest, None) => rest.clone(),
            (Some(a), Some(b)) => {
                if !self.is_short() || !other.is_short() {
                    return None;
                }
                let y = &(a.y() * b.x()) + &(a.x() * b.y());
                let x = &(a.x() * b.x()) - &(a.y() * b.y());
                Some(Angle::of(&y, &x)?)
            }
        };
        Some(Turn { degrees: &self.degrees + &other.degrees, rest })
    }

    /// The angle with its sign changed.
    pub fn reversed(&self) -> Turn {
        let rest = self.rest.as_ref().and_then(|angle| Angle::of(&-angle.y(), angle.x()));
        Turn { degrees: -self.degrees.clone(), rest }
    }

    /// A multiple; the part known by its tangent can only be multiplied by a whole number or halved, and not again and again
    /// until nobody can wait for it.
    pub fn times(&self, factor: &Fraction) -> Option<Turn> {
        let degrees = &self.degrees * factor;
        if self.rest.is_none() {
            return Some(Turn::degrees(degrees));
        }
        let (count, below) = factor.as_small()?;
        if matches!(below, 2 | 4 | 8) {
            let half = Turn { degrees: Fraction::ZERO, rest: self.rest.clone() }.halved()?;
            let halves = half.times(&(factor * &Fraction::from(2)))?;
            return Some(Turn { degrees, ..halves });
        }
        if below != 1 || count.abs() > 12 {
            return None;
        }
        let base = if count < 0 { self.reversed() } else { self.clone() };
        let rest = Turn { degrees: Fraction::ZERO, rest: base.rest };
        (0..count.abs()).try_fold(Turn::degrees(degrees), |sum, _| sum.plus(&rest).filter(Turn::is_short))
    }

    /// Half of the part known by its tangent, where that lies between -90 and 90 degrees: a sum of angles may have gone
    /// further round than its vector tells. Not where it has been halved often enough.
    fn halved(&self) -> Option<Turn> {
        let angle = self.rest.as_ref()?;
        let is_right = angle.x().sign().is_some_and(Ordering::is_gt);
        let is_deep = angle.y().depth().max(angle.x().depth()) > DEEPEST;
        if !is_right || is_deep || !self.is_short() {
            return None;
        }
        let size = (&(angle.x() * angle.x()) + &(angle.y() * angle.y())).square_root()?;
        Some(Turn::of(Angle::of(angle.y(), &(angle.x() + &size))?))
    }

    /// Are its numbers such as can be worked with?
    fn is_short(&self) -> bool {
        let is_short = |value: &Value| value.longest_number() <= LONGEST && value.terms() <= MOST_TERMS;
        self.rest.as_ref().is_none_or(|angle| is_short(angle.y()) && is_short(angle.x()))
    }

    /// A positive multiple of the sine, without the root that makes it the sine itself: nought where the
    /// angle is a whole number of half turns.
    pub fn cross(&self) -> Option<Value> {
        let degrees = Direction::degrees(&self.degrees)?;
        Some(match &self.rest {
            None => degrees.sin,
            Some(angle) => &(angle.y() * &degrees.cos) + &(angle.x() * &degrees.sin),
        })
    }

    /// Its cosine and sine; `None` if a root does not exist or the degrees are too fine.
    pub fn direction(&self) -> Option<Direction> {
        let degrees = Direction::degrees(&self.degrees)?;
        let Some(angle) = &self.rest else { return Some(degrees) };
        let size = (&(angle.x() * angle.x()) + &(angle.y() * angle.y())).square_root()?;
        let rest = Direction { cos: angle.x().divided_by(&size)?, sin: angle.y().divided_by(&size)? };
        Some(degrees.plus(&rest))
    }

    /// Is it a number of degrees, without letters?
    pub fn is_constant(&self) -> bool {
        self.rest.as_ref().is_none_or(Angle::is_constant)
    }

    /// An enclosure of the number of degrees, if there are no letters in it.
    pub fn enclose(&self, bits: usize) -> Option<Interval> {
        let degrees = Interval::from_fraction(&self.degrees, bits);
        match &self.rest {
            None => Some(degrees),
            Some(angle) => Some(degrees + angle.enclose(bits, &|_| None)?),
        }
    }

    /// About how many degrees, if there are no letters in it.
    pub fn to_f64(&self) -> Option<f64> {
        let sharp = |value: &Value| value.between_doubles()?.sharp();
        let by_doubles = || match &self.rest {
            None => Some(self.degrees.to_f64()),
            Some(angle) => Some(self.degrees.to_f64() + sharp(angle.y())?.atan2(sharp(angle.x())?).to_degrees()),
        };
        by_doubles().or_else(|| self.enclose(64).map(|degrees| degrees.to_f64()))
    }

    /// Is it exactly so many degrees, as a number, not only as a direction?
    pub fn is_degrees(&self, degrees: &Fraction) -> bool {
        let rest = degrees - &self.degrees;
        match &self.rest {
            None => rest.is_zero(),
            Some(angle) => rest.abs() <= Fraction::from(180) && angle.is_degrees(&rest),
        }
    }

    /// Is it exactly so many degrees, whatever its letters stand for? `None` if that depends on them, as far as can be seen: it
    /// may be half a turn from there for some.
    pub fn is_surely_degrees(&self, degrees: &Fraction) -> Option<bool> {
        let is = self.is_degrees(degrees);
        let gap = || self.plus(&Turn::degrees(-degrees.clone()));
        let is_open = || !self.is_constant() && gap().is_none_or(|gap| gap.is_level_somehow());
        if !is && is_open() { None } else { Some(is) }
    }

    /// Is it nought or half a turn, and nobody knows which?
    fn is_level_somehow(&self) -> bool {
        let sign = |value: Option<Value>| value.and_then(|value| value.sign());
        self.cross().is_none_or(|cross| cross.is_zero()) && sign(self.dot()).is_none()
    }

    /// The same multiple of the cosine as [`Turn::cross`] is of the sine.
    pub fn dot(&self) -> Option<Value> {
        let degrees = Direction::degrees(&self.degrees)?;
        Some(match &self.rest {
            None => degrees.cos,
            Some(angle) => &(angle.x() * &degrees.cos) - &(angle.y() * &degrees.sin),
        })
    }

    /// The tangent; `None` at a right angle. No root is taken for it.
    pub fn tangent(&self) -> Option<Value> {
        self.cross()?.divided_by(&self.dot()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Letter, Range};

    #[test]
    fn an_angle_is_not_multiplied_until_nobody_can_wait_for_it() {
        let angle = Angle::of(&Value::from(7), &Value::from(1 << 20)).unwrap();
        let three = Fraction::from(3);
        // 3 to the power 40 times, as in `mm…m arctan u` where m is 3.
        let often = (0..40).try_fold(Turn::of(angle.clone()), |turn, _| turn.times(&three));
        assert_eq!(often, None);
        assert!(Turn::of(angle).times(&three).and_then(|turn| turn.times(&three)).is_some());
    }

    #[test]
    fn an_eighth_of_a_letter_is_an_angle_and_halves_of_halves_have_an_end() {
        let theta =
            Turn::of(Angle::of(&Value::letter(Letter::new("theta", Range::Acute).unwrap()), &Value::ONE).unwrap());
        let half = Fraction::new(1, 2);
        let eighth = (0..3).try_fold(theta.clone(), |turn, _| turn.times(&half));
        assert!(eighth.is_some());
        assert_eq!(eighth, theta.times(&Fraction::new(1, 8)));
        assert_eq!((0..17).try_fold(theta, |turn, _| turn.times(&half)), None);
    }
}
