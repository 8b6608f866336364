//! Inverse tangent, sine and cosine of certified intervals.
//!
//! Conventions as in `trigonometry`: radians, points in units of 2^-bits, errors proved beside the code.
//! Values: atan and asin from -pi/2 to pi/2, acos from 0 to pi, atan2 from -pi (left out) to pi.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::Interval;
use super::interval::{floor_quotient, root};

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
        let term = &power / (2 * terms + 1);
        sum = if terms.is_multiple_of(2) { sum + term } else { sum - term };
        power = (power * &square) >> bits;
        terms += 1;
    }
    (sum << halvings, IBig::from(4 + 3 * (terms + 1)) << halvings)
}
