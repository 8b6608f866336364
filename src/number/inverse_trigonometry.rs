//! Inverse tangent, sine and cosine of certified intervals.
//!
//! Conventions as in `trigonometry`: radians, points in units of 2^-bits, errors proved beside the code.
//! Values: atan and asin from -pi/2 to pi/2, acos from 0 to pi, atan2 from -pi (left out) to pi.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::interval::{floor_quotient, root};
use super::{Interval, steps};

/// Bits beyond those asked for, so that a chain of roundings stays within a unit of the result.
const GUARD: usize = 16;

impl Interval {
    /// The angle from -pi/2 to pi/2 with this tangent.
    pub fn atan(&self) -> Interval {
        let lower = arc_tangent(&self.lower, self.bits);
        let range = if self.lower == self.upper { lower } else { lower.hull(&arc_tangent(&self.upper, self.bits)) };
        range.with_bits(self.bits)
    }

    /// The angle of the vector (x, y) from the positive x-axis, anticlockwise, above -pi and up to pi.
    ///
    /// `None` if the vector may be nought, or may lie on either side of the negative x-axis, where the
    /// angle jumps from pi to -pi. A vector that is certainly on that axis has the angle pi.
    pub fn atan2(y: &Interval, x: &Interval) -> Option<Interval> {
        let bits = y.bits.max(x.bits);
        let working = bits + GUARD;
        let (x, y) = (x.with_bits(working), y.with_bits(working));
        let angle = if let Some(side) = y.sign().filter(|side| *side != Ordering::Equal) {
            // Off the x-axis: a quarter turn to this side, less the angle from the y-axis.
            let quarter = Interval::half_pi(working);
            let quarter = if side == Ordering::Greater { quarter } else { -quarter };
            quarter - x.checked_div(&y)?.atan()
        } else {
            let slope = y.checked_div(&x)?.atan();
            match x.sign()? {
                Ordering::Greater => slope,
                _ if y.lower == IBig::ZERO => Interval::pi(working) + slope,
                _ => return None,
            }
        };
        Some(angle.with_bits(bits))
    }

    /// The angle from -pi/2 to pi/2 with this sine. What lies beyond -1 or 1 is left out of account, for a sine is
    /// known not to; `None` if that is all of the interval.
    pub fn asin(&self) -> Option<Interval> {
        self.within_unit_circle()?.between_ends(|sine| {
            let (sine, cosine) = unit_vector(sine, self.bits);
            Interval::atan2(&sine, &cosine)
        })
    }

    /// The angle from 0 to pi with this cosine. What lies beyond -1 or 1 is left out of account, for a cosine is
    /// known not to; `None` if that is all of the interval.
    pub fn acos(&self) -> Option<Interval> {
        self.within_unit_circle()?.between_ends(|cosine| {
            let (cosine, sine) = unit_vector(cosine, self.bits);
            Interval::atan2(&sine, &cosine)
        })
    }

    fn within_unit_circle(&self) -> Option<Interval> {
        let one = IBig::ONE << self.bits;
        self.intersection(&Interval { lower: -&one, upper: one, bits: self.bits })
    }
}

/// The point x from -1 to 1 as one component of a unit vector, and the other, root(1 - x^2).
fn unit_vector(point: &IBig, bits: usize) -> (Interval, Interval) {
    let working = bits + GUARD;
    let x = point << GUARD;
    let (other, exact) = root(&((IBig::ONE << (2 * working)) - &x * &x));
    let above = if exact { other.clone() } else { &other + 1 };
    (Interval::point(x, working), Interval { lower: other, upper: above, bits: working })
}

/// atan of a point, with more bits than it has.
fn arc_tangent(point: &IBig, bits: usize) -> Interval {
    if *point < IBig::ZERO {
        return -arc_tangent(&-point, bits);
    }
    if *point == IBig::ZERO {
        return Interval::integer(0, bits);
    }
    let halvings = bits.isqrt() / 3 + 1;
    let working = bits + halvings + bits.bit_len() + GUARD;
    if *point <= IBig::ONE << bits {
        let (angle, error) = arc_tangent_within_one(point << (working - bits), halvings, working);
        return Interval::around(&angle, &error, working);
    }
    // atan x = pi/2 - atan 1/x. The reciprocal is less than 1 unit too low, and atan changes by no more than that.
    let reciprocal = floor_quotient(&(IBig::ONE << (working + bits)), point);
    let (angle, error) = arc_tangent_within_one(reciprocal, halvings, working);
    Interval::half_pi(working) - Interval::around(&angle, &(error + 1), working)
}

/// atan x for 0 <= x <= 1 and at least one halving, and its error in units.
///
/// Halving: tan(a/2) = x/(1 + root(1 + x^2)). The root is less than 1 unit too low, which moves the quotient, at most
/// a half of 1 with a divisor of at least 2, by less than 1 unit; rounding it moves it by 1 more; and an earlier
/// error e counts e/2 at most. So e/2 + 2 never passes 4, and atan changes by no more than its argument does.
///
/// Series: x - x^3/3 + x^5/5 - ... with x <= tan(pi/8) < 1/2. The square is at most 1 unit too low, each power by e/4
/// of the one before, half a unit for the square and 1 for the shift, which stays at or below 2. So a term is less
/// than 2 + 1 units wrong, and once a power has become nought, those left out alternate and fall from below 3.
fn arc_tangent_within_one(mut x: IBig, halvings: usize, bits: usize) -> (IBig, IBig) {
    let one = IBig::ONE << bits;
    let square_of_one = IBig::ONE << (2 * bits);
    for _ in 0..halvings {
        let (secant, _) = root(&(&square_of_one + &x * &x));
        x = floor_quotient(&(x << bits), &(&one + secant));
    }
    let square = (&x * &x) >> bits;
    let (mut power, mut sum, mut terms) = (x, IBig::ZERO, 0usize);
    while power != IBig::ZERO {
        steps::add(steps::of_bits(bits));
        let term = &power / (2 * terms + 1);
        sum = if terms.is_multiple_of(2) { sum + term } else { sum - term };
        power = (power * &square) >> bits;
        terms += 1;
    }
    (sum << halvings, IBig::from(4 + 3 * (terms + 1)) << halvings)
}

#[cfg(test)]
mod tests {
    use rand::rngs::ChaCha8Rng;
    use rand::{RngExt, SeedableRng};

    use super::*;
    use crate::number::Fraction;
    use crate::number::trigonometry::tests::{assert_figures, enclosed, late_figures};

    #[test]
    fn inverse_functions_to_forty_figures() {
        let surd = Interval::integer(27, 160).sqrt().unwrap() * enclosed("1/5", 160);
        assert_figures("atan(3 root 3/5)", &surd.atan(), "0.80463367710111247079712218090885235755598");
        for (value, angle) in [
            ("1", "0.78539816339744830961566084581987572104929"),
            ("-3", "-1.2490457723982544258299170772810901230778"),
            ("100", "1.5607966601082313810249815754304718935372"),
            ("1/7", "0.14189705460416392281285161710255308300778"),
        ] {
            assert_figures(value, &enclosed(value, 160).atan(), angle);
        }
        let (three_fifths, third) = (enclosed("3/5", 160), enclosed("-1/3", 160));
        assert_figures("asin", &three_fifths.asin().unwrap(), "0.64350110879328438680280922871732263804151");
        assert_figures("acos", &three_fifths.acos().unwrap(), "0.92729521800161223242851246292242880405707");
        assert_figures("acos", &(-three_fifths).acos().unwrap(), "2.2142974355881810060341309203570740801401");
        assert_figures("asin", &third.asin().unwrap(), "-0.33983690945412193709639251339176406638824");
    }

    #[test]
    fn six_thousand_figures_of_an_angle() {
        assert_eq!(late_figures(&enclosed("2/3", 20_000).atan(), 6015), "36880098921985682963864098");
    }

    fn angle(y: (i64, i64), x: (i64, i64)) -> Option<Interval> {
        let interval = |(lower, upper)| Interval::integer(lower, 64).hull(&Interval::integer(upper, 64));
        Interval::atan2(&interval(y), &interval(x))
    }

    #[test]
    fn directions_in_all_quadrants_and_on_the_axes() {
        for y in -3..=3_i64 {
            for x in -3..=3_i64 {
                let Some(found) = angle((y, y), (x, x)) else {
                    assert_eq!((x, y), (0, 0));
                    continue;
                };
                assert!((found.to_f64() - (y as f64).atan2(x as f64)).abs() < 1e-15, "{y} {x}");
                assert!(found.width() < Fraction::new(1, 1 << 61), "{y} {x}");
            }
        }
    }

    #[test]
    fn boxes_of_directions() {
        let eighths = |y, x| angle(y, x).map(|range| [range.lower(), range.upper()].map(|end| end.to_f64() * 4.0));
        let pi = std::f64::consts::PI;
        for (y, x, expected) in [
            ((1, 2), (1, 2), None),
            ((-1, 1), (1, 2), Some([-pi, pi])),
            ((1, 2), (-1, 1), Some([pi, 3.0 * pi])),
            ((-2, -1), (-1, 1), Some([-3.0 * pi, -pi])),
            ((0, 1), (-2, -1), Some([3.0 * pi, 4.0 * pi])),
        ] {
            let found = eighths(y, x).unwrap();
            let expected = expected.unwrap_or([4.0 * 0.5_f64.atan(), 4.0 * 2_f64.atan()]);
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{y:?} {x:?}: {found:?}");
        }
        for (y, x) in
            [((-1, 1), (-1, 1)), ((0, 0), (0, 1)), ((-1, 1), (-2, -1)), ((-1, 0), (-2, -1)), ((0, 1), (-1, 0))]
        {
            assert_eq!(angle(y, x), None, "{y:?} {x:?}");
        }
    }

    #[test]
    fn sines_and_cosines_are_clamped_to_what_they_can_be() {
        let (one, beyond) = (Interval::integer(1, 64), enclosed("1.01", 64));
        assert_eq!(beyond.asin(), None);
        assert_eq!((-beyond.clone()).acos(), None);
        assert_eq!(one.acos(), Some(Interval::integer(0, 64)));
        assert!((-one.clone()).acos().unwrap().overlaps(&Interval::pi(200)));
        assert!((-one.clone()).asin().unwrap().overlaps(&-Interval::half_pi(200)));
        let reaching = Interval::integer(0, 64).hull(&beyond);
        assert!(reaching.asin().unwrap().overlaps(&Interval::half_pi(200)));
        assert!(reaching.acos().unwrap().contains_zero());
    }

    #[test]
    fn the_proved_errors_hold_before_guard_bits_hide_them() {
        let mut random = ChaCha8Rng::seed_from_u64(6);
        for bits in (0..400).step_by(7) {
            for _ in 0..10 {
                let point =
                    IBig::from(random.random_range(-1 << 30..1 << 30_i64)) << bits >> random.random_range(20..40);
                let finer = arc_tangent(&(&point << 90usize), bits + 90);
                assert!(arc_tangent(&point, bits).overlaps(&finer), "{finer:?}");
            }
        }
    }

    #[test]
    fn an_angle_is_found_again_from_its_tangent_sine_and_cosine() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        for _ in 0..100 {
            let bits = random.random_range(4..300);
            // Below pi/2 in magnitude.
            let exact = Fraction::new(random.random_range(-1500..=1500), 1000);
            let angle = Interval::from_fraction(&exact, bits);
            assert!(angle.sin().asin().unwrap().contains(&exact), "{exact} {bits}");
            assert!(angle.cos().acos().unwrap().contains(&exact.abs()), "{exact} {bits}");
            if let Some(tangent) = angle.tan() {
                assert!(tangent.atan().contains(&exact), "{exact} {bits}");
                assert!(tangent.atan().width() <= angle.width() * Fraction::from(9) + Fraction::new(4, 1), "{bits}");
            }
            let point = Interval::point(IBig::from(random.random_range(-5000..5000)) << bits >> 9usize, bits);
            let unit = Fraction::ONE / Fraction::from(IBig::ONE << bits);
            assert!(point.atan().width() <= unit * Fraction::from(2), "{point:?}");
            assert!(point.atan().overlaps(&point.with_bits(bits + 100).atan()));
        }
    }
}
