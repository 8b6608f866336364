//! Doubles seen from exact numbers: what a double is exactly, how far it is off, and functions rounded as well as can be.
//!
//! The reference of this room is never another float. A double is a fraction, so a formula evaluated in fractions says
//! what it should have given; where a sine or an angle comes in, certified intervals of [`BITS`] places do.
//!
//! Sines and their like are rounded here from such intervals to the nearest double. So what goes wrong in the maps is the
//! fault of an arrangement and never of the machine's library, and the maps are the same on every machine.

use dashu_int::IBig;

use crate::number::{Fraction, Interval};

/// Binary places of the intervals. The smallest value in a map is about 10^-40, which leaves 50 figures of it.
pub const BITS: usize = 320;

/// The unit roundoff: half the distance from 1 to the next double.
pub const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// How far a result is from the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// By this part of the truth; 0 is exact.
    Off(f64),
    /// There is no number, or an infinite one.
    NoNumber,
    /// The method does not take the scene.
    Refused,
}

impl Outcome {
    /// The error of a double against an exact value, relative to that; what should be nought must be.
    pub fn relative(found: f64, truth: &Fraction) -> Outcome {
        Outcome::scaled(found, truth, truth)
    }

    /// The error of a double against an exact value, as a part of another.
    pub fn scaled(found: f64, truth: &Fraction, scale: &Fraction) -> Outcome {
        let Some(found) = fraction(found) else { return Outcome::NoNumber };
        let gap = (&found - truth).abs();
        if gap.is_zero() {
            return Outcome::Off(0.0);
        }
        match scale.abs().reciprocal() {
            Some(per) => Outcome::Off((&gap * &per).to_f64()),
            None => Outcome::NoNumber,
        }
    }

    /// The error of a double against an enclosed value that is not nought, relative to that.
    pub fn against(found: f64, truth: &Interval) -> Outcome {
        // The enclosure is narrower by far than the last place of a double, so its middle will do.
        Outcome::relative(found, &(&(&truth.lower() + &truth.upper()) * &Fraction::new(1, 2)))
    }

    /// The error; none if there is no number to speak of.
    pub fn error(self) -> Option<f64> {
        match self {
            Outcome::Off(error) => Some(error),
            _ => None,
        }
    }

    /// Is it within a bound? A refusal keeps every bound, since nothing wrong is said.
    pub fn within(self, bound: f64) -> bool {
        match self {
            Outcome::Off(error) => error <= bound,
            Outcome::NoNumber => false,
            Outcome::Refused => true,
        }
    }

    /// The worse of two.
    pub fn worse(self, other: Outcome) -> Outcome {
        match (self, other) {
            (Outcome::NoNumber, _) | (_, Outcome::NoNumber) => Outcome::NoNumber,
            (Outcome::Off(one), Outcome::Off(two)) => Outcome::Off(one.max(two)),
            (Outcome::Off(one), Outcome::Refused) | (Outcome::Refused, Outcome::Off(one)) => Outcome::Off(one),
            (Outcome::Refused, Outcome::Refused) => Outcome::Refused,
        }
    }
}

/// What a double is exactly; none for an infinity or what is no number.
///
/// ```
/// use carom::study::fraction;
/// assert_eq!(fraction(0.375).unwrap().to_string(), "3/8");
/// assert_eq!(fraction(0.1).unwrap().to_string(), "3602879701896397/36028797018963968");
/// assert_eq!(fraction(f64::INFINITY), None);
/// ```
pub fn fraction(value: f64) -> Option<Fraction> {
    if !value.is_finite() {
        return None;
    }
    let bits = value.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    let figures = bits & ((1 << 52) - 1);
    // Numbers below 2^-1022 have no leading one.
    let figures = if exponent == 0 { figures } else { figures | 1 << 52 };
    let power = exponent.max(1) - 1075;
    let integer = if value < 0.0 { -IBig::from(figures) } else { IBig::from(figures) };
    let (up, down) = (power.max(0) as usize, (-power).max(0) as usize);
    Fraction::from_integers(integer << up, IBig::ONE << down)
}

/// An enclosure of a double, in which it lies exactly unless it is below 2^-[`BITS`].
pub fn enclosed(value: f64) -> Interval {
    Interval::from_fraction(&fraction(value).unwrap_or(Fraction::ZERO), BITS)
}

/// The sine of an angle in radians, rounded correctly.
pub fn sin(angle: f64) -> f64 {
    enclosed(angle).sin().to_f64()
}

/// The cosine of an angle in radians, rounded correctly.
pub fn cos(angle: f64) -> f64 {
    enclosed(angle).cos().to_f64()
}

/// The angle with this cosine, in radians, rounded correctly; no number beyond -1 and 1.
pub fn acos(cosine: f64) -> f64 {
    if !(-1.0..=1.0).contains(&cosine) {
        return f64::NAN;
    }
    enclosed(cosine).acos().map_or(f64::NAN, |angle| angle.to_f64())
}

/// The angle of the vector (x, y), in radians, rounded correctly.
pub fn atan2(y: f64, x: f64) -> f64 {
    Interval::atan2(&enclosed(y), &enclosed(x)).map_or(f64::NAN, |angle| angle.to_f64())
}

/// Radians in a degree, as a double.
pub fn radians_per_degree() -> f64 {
    Interval::pi(BITS).checked_div(&Interval::integer(180, BITS)).map_or(f64::NAN, |ratio| ratio.to_f64())
}

/// Ten to a power that may be negative, rounded correctly.
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

/// Ten to a small power, which is exact if the power is not negative.
pub fn power_of_ten_quickly(exponent: i32) -> f64 {
    const POWERS: [f64; 9] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8];
    let size = POWERS.get(exponent.unsigned_abs() as usize).copied();
    match size {
        Some(size) if exponent >= 0 => size,
        Some(size) => 1.0 / size,
        None => power_of_ten(exponent),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_what_a_double_is() {
        for value in [1.0, -0.1, 1e-300, 5e-324, f64::MAX, 0.0, 1.0 / 3.0, -1e16] {
            let exact = fraction(value).unwrap();
            assert_eq!(exact.to_f64(), value, "{exact}");
        }
        assert_eq!(fraction(f64::NAN), None);
        assert_eq!(fraction(-2.5).unwrap(), Fraction::new(-5, 2));
    }

    #[test]
    fn functions_agree_with_the_library_to_its_last_place() {
        for (ours, library) in [
            (sin(0.5), 0.5f64.sin()),
            (cos(1.5625), 1.5625f64.cos()),
            (acos(0.999999), 0.999999f64.acos()),
            (atan2(1.0, -2.0), 1f64.atan2(-2.0)),
            (radians_per_degree(), 1f64.to_radians()),
        ] {
            assert!((ours - library).abs() <= 4.0 * ROUNDOFF * ours.abs(), "{ours} {library}");
        }
        assert!(acos(1.0000000000000002).is_nan());
    }

    #[test]
    fn errors_are_parts_of_the_truth() {
        let third = Fraction::new(1, 3);
        let Outcome::Off(error) = Outcome::relative(1.0 / 3.0, &third) else { panic!() };
        assert!(error > 0.0 && error <= ROUNDOFF, "{error}");
        assert_eq!(Outcome::relative(0.0, &Fraction::ZERO), Outcome::Off(0.0));
        assert_eq!(Outcome::relative(1e-17, &Fraction::ZERO), Outcome::NoNumber);
        assert_eq!(Outcome::relative(f64::NAN, &third), Outcome::NoNumber);
        assert_eq!(Outcome::Refused.worse(Outcome::Off(1.0)), Outcome::Off(1.0));
    }
}
