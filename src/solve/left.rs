//! Letters that were left in a solution though their values were found: what stands for them in an answer.

use std::fmt;

use crate::number::{Angle, Decimal, Interval, Letter, Places, Range, Uncertain, Value, round_certified};

/// So many binary places settle whatever intervals can settle. Where more would be wanted the number is nought or a tie by
/// itself, as the energy that is lost at e = 1, and no interval says so however narrow.
pub(super) const MOST_BITS: usize = 1024;

/// Letters with their values, which are long; of an angle the tangent.
#[derive(Clone, Copy, Debug)]
pub struct Left<'s>(pub(super) &'s [(Letter, Value)]);

impl Left<'_> {
    /// Are there none, as in nearly every solution?
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn of(&self, letter: Letter) -> Option<&Value> {
        self.0.iter().find_map(|(own, value)| (*own == letter).then_some(value))
    }

    /// An enclosure of what is a number once these stand for their letters.
    pub fn enclose(&self, value: &Value, bits: usize) -> Option<Interval> {
        value.enclose(bits, &|letter| self.of(letter)?.enclose_constant(bits))
    }

    /// The same of an angle, in degrees.
    pub fn enclose_angle(&self, angle: &Angle, bits: usize) -> Option<Interval> {
        angle.enclose(bits, &|letter| self.of(letter)?.enclose_constant(bits))
    }

    /// The double nearest to it, or one beside that.
    pub fn to_f64(&self, value: &Value) -> Option<f64> {
        if value.is_constant() { value.to_f64() } else { Some(self.enclose(value, 96)?.to_f64()) }
    }

    /// A value rounded half up, every figure proved.
    pub fn rounded(&self, value: &Value, places: &Places) -> Option<Decimal> {
        if value.is_constant() {
            return value.rounded(places).ok();
        }
        settled(|bits| self.enclose(value, bits), places).ok()
    }

    /// An angle in degrees, rounded half up, every figure proved.
    pub fn rounded_angle(&self, angle: &Angle, places: &Places) -> Option<Decimal> {
        if angle.is_constant() {
            return angle.rounded(places).ok();
        }
        settled(|bits| self.enclose_angle(angle, bits), places).ok()
    }
}

/// `x ≈ 1.06`.
impl fmt::Display for Left<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, (letter, value)) in self.0.iter().enumerate() {
            let (angle, places) = (Angle::of(value, &Value::ONE), Places::SignificantFigures(3));
            let (rounded, unit) = match (letter.range(), angle) {
                (Range::Acute, Some(angle)) => (angle.rounded(&places), "°"),
                _ => (value.rounded(&places), ""),
            };
            let about = rounded.map_or_else(|_| "a long sum of roots".to_owned(), |about| format!("{about}{unit}"));
            write!(f, "{}{} ≈ {about}", if place > 0 { ", " } else { "" }, letter.name())?;
        }
        Ok(())
    }
}

/// Rounded where intervals alone settle it.
pub(super) fn settled(enclose: impl Fn(usize) -> Option<Interval>, places: &Places) -> Result<Decimal, Uncertain> {
    round_certified(|bits| if bits <= MOST_BITS { enclose(bits) } else { None }, |_| false, places)
}
