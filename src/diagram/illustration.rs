//! The numbers by which a picture is drawn: exact values measured, letters at values that show well.

use super::Point;
use crate::number::{Fraction, Interval, Letter, Range, Value};

/// Precision of a measurement; no picture is finer.
const BITS: usize = 64;

/// What a letter is drawn as: an acute angle by its tangent, at about 40 degrees.
fn shown(letter: Letter) -> Fraction {
    match letter.range() {
        Range::Acute => Fraction::new(21, 25),
        Range::Unit => Fraction::new(1, 2),
        _ => Fraction::ONE,
    }
}

/// A value as a number, with every letter at the value that it is drawn as.
pub fn measure(value: &Value) -> Option<f64> {
    let enclosure = value.enclose(BITS, &|letter| Some(Interval::from_fraction(&shown(letter), BITS)))?;
    Some(enclosure.to_f64())
}

/// The direction of a vector, of length 1; `None` for nought.
pub fn direction(x: &Value, y: &Value) -> Option<Point> {
    let point = Point::new(measure(x)?, measure(y)?);
    // A component that is nought is so exactly, and not nearly.
    let exact = Point::new(if x.is_zero() { 0.0 } else { point.x }, if y.is_zero() { 0.0 } else { point.y });
    (exact.length() > 0.0).then(|| exact.unit())
}
