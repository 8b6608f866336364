//! Pi, sine, cosine and tangent of certified intervals.
//!
//! Conventions. Angles are in radians. A 'point' is an integer that counts units of 2^-bits. The kernels work
//! on points with some guard bits, return an approximation with an error that is proved beside the code, and
//! are rounded outwards at the end; guard bits only make the result narrow, they are no part of the proof.

use std::cell::RefCell;

use dashu_int::IBig;
use dashu_int::ops::{BitTest, UnsignedAbs};

use super::interval::floor_quotient;
use super::{Interval, steps};

/// Angles above 2^16384 are answered by the whole range of sine and cosine: to reduce one of n bits takes
/// pi to n bits, and a number that somebody typed must not stall us.
const GREATEST_MAGNITUDE: usize = 1 << 14;

impl Interval {
    /// Pi, at most two units wide.
    ///
    /// ```
    /// use carom::number::{Fraction, Interval};
    /// assert!(Interval::pi(64).lower() > "3.14159265358979323".parse().unwrap());
    /// ```
    pub fn pi(bits: usize) -> Interval {
        // Each angle needs pi; the finest value so far serves all that ask for less.
        thread_local!(static FINEST: RefCell<Option<Interval>> = const { RefCell::new(None) });
        FINEST.with_borrow_mut(|finest| match finest {
            Some(pi) if pi.bits >= bits => pi.with_bits(bits),
            _ => finest.insert(machin(bits.max(256))).with_bits(bits),
        })
    }

    /// Half of pi. Halving is exact: the same count of units that are half as large.
    pub(super) fn half_pi(bits: usize) -> Interval {
        Interval { bits: bits.max(1), ..Interval::pi(bits.max(1) - 1) }.with_bits(bits)
    }

    /// The sine, of any angle.
    pub fn sin(&self) -> Interval {
        self.wave(1, |(sine, _)| sine)
    }

    /// The cosine, of any angle.
    pub fn cos(&self) -> Interval {
        self.wave(0, |(_, cosine)| cosine)
    }

    /// The tangent; `None` where the cosine may be nought.
    pub fn tan(&self) -> Option<Interval> {
        let turns = self.quarter_turns()?;
        if passes(&turns, 1) || passes(&turns, 3) {
            return None;
        }
        // Between two poles the tangent increases.
        self.between_ends(|point| {
            let (sine, cosine) = sine_and_cosine(point, self.bits);
            sine.checked_div(&cosine)
        })
    }

    /// The range of a monotonic function: what its values at both ends span.
    pub(super) fn between_ends(&self, value: impl Fn(&IBig) -> Option<Interval>) -> Option<Interval> {
        let lower = value(&self.lower)?;
        let range = if self.lower == self.upper { lower } else { lower.hull(&value(&self.upper)?) };
        Some(range.with_bits(self.bits))
    }

    /// A function that is 1 after `crest` quarter turns (and whole turns more), -1 half a turn later, and
    /// monotonic in between: its values at both ends, and each extreme that the interval may pass.
    fn wave(&self, crest: u8, part: fn((Interval, Interval)) -> Interval) -> Interval {
        let one = IBig::ONE << self.bits;
        let whole = Interval { lower: -&one, upper: one.clone(), bits: self.bits };
        let Some(turns) = self.quarter_turns() else { return whole };
        let mut range = part(sine_and_cosine(&self.lower, self.bits));
        if self.lower != self.upper {
            range = range.hull(&part(sine_and_cosine(&self.upper, self.bits)));
        }
        let mut range = range.with_bits(self.bits);
        if passes(&turns, crest) {
            range.upper = one.clone();
        }
        if passes(&turns, (crest + 2) % 4) {
            range.lower = -&one;
        }
        range.intersection(&whole).unwrap_or(whole)
    }

    /// The first and the last whole number of quarter turns that may lie in the interval, in this order unless
    /// there is none; `None` for angles too large to say.
    fn quarter_turns(&self) -> Option<(IBig, IBig)> {
        let magnitude = self.lower.bit_len().max(self.upper.bit_len()).saturating_sub(self.bits);
        if magnitude > GREATEST_MAGNITUDE {
            return None;
        }
        let turns = self.over_positive(&Interval::half_pi(self.bits + magnitude + 16));
        Some((-(-turns.lower >> turns.bits), turns.upper >> turns.bits))
    }
}

/// Is there a number among first to last that leaves the remainder `residue` on division by four?
fn passes((first, last): &(IBig, IBig), residue: u8) -> bool {
    first + remainder_of_four(&(IBig::from(residue) - first)) <= *last
}

fn remainder_of_four(value: &IBig) -> u8 {
    value & 3u8
}

/// Machin: pi = 16 atan(1/5) - 4 atan(1/239).
fn machin(bits: usize) -> Interval {
    let working = bits + bits.bit_len() + 8;
    let (five, five_error) = arc_tangent_of_reciprocal(5, working);
    let (large, large_error) = arc_tangent_of_reciprocal(239, working);
    let error = IBig::from(16 * five_error + 4 * large_error);
    Interval::around(&(five * 16 - large * 4), &error, working).with_bits(bits)
}

/// atan(1/n) = 1/n - 1/(3 n^3) + 1/(5 n^5) - ... for n >= 2, and its error in units.
///
/// Each power is at most 4/3 units too low (1 for its own rounding, plus a quarter and less of the error of the one
/// before), hence each term at most 4/3 + 1 < 3 units wrong. When a power has become nought, the terms left out
/// alternate and fall, so they amount to less than the first of them, which is below 4/3 + 1 units as well.
fn arc_tangent_of_reciprocal(n: u32, bits: usize) -> (IBig, usize) {
    let square = IBig::from(n * n);
    let mut power = (IBig::ONE << bits) / n;
    let (mut sum, mut terms) = (IBig::ZERO, 0usize);
    while power != IBig::ZERO {
        steps::add(steps::of_bits(bits));
        let term = &power / (2 * terms + 1);
        sum = if terms.is_multiple_of(2) { sum + term } else { sum - term };
        power /= &square;
        terms += 1;
    }
    (sum, 3 * (terms + 1))
}

/// Sine and cosine of a point, with more bits than it has and no magnitude above [`GREATEST_MAGNITUDE`].
///
/// The angle x is reduced twice: r = x - k pi/2 with |r| < 0.8, and t = r/2^h. The series give sin t and cos t,
/// h doublings give r, and the remainder of k modulo 4 tells which is which and with what sign.
fn sine_and_cosine(point: &IBig, bits: usize) -> (Interval, Interval) {
    if *point == IBig::ZERO {
        return (Interval::integer(0, bits), Interval::integer(1, bits));
    }
    let halvings = bits.isqrt() / 2;
    let working = bits + 2 * halvings + bits.bit_len() + 24;
    let magnitude = point.bit_len().saturating_sub(bits);

    // pi/2 is taken with as many more bits as k may have, so that k times its error stays small.
    let half_pi = Interval::half_pi(working + magnitude);
    let fine = point << (working - bits + magnitude);
    let k = floor_quotient(&(&fine + (&half_pi.lower >> 1usize)), &half_pi.lower);
    let reduced = (fine - &k * &half_pi.lower) >> (magnitude + halvings);
    // In units of 2^-working: k times the width of pi/2, brought to these units, and one for each shift down.
    let reduction = (((&half_pi.upper - &half_pi.lower) * k.clone().unsigned_abs()) >> (magnitude + halvings)) + 2;

    let (mut sine, mut cosine, series) = sine_and_cosine_series(&reduced, working);
    // Sine and cosine change by no more than their angle does.
    let mut error = reduction + series;
    for _ in 0..halvings {
        // sin 2a = 2 sin a cos a, cos 2a = 1 - 2 sin^2 a. With errors below e < 2^-10 in both, and |a| <= 0.4 as
        // even the last angle before doubling is, the first is wrong by 2 (|sin a| + |cos a|) e + 2 e^2 < 3 e,
        // the second by 4 |sin a| e + 2 e^2 < 2 e; the shift adds at most 1 unit.
        let doubled = (&sine * &cosine) >> (working - 1);
        cosine = (IBig::ONE << working) - ((&sine * &sine) >> (working - 1));
        sine = doubled;
        error = error * 3 + 1;
    }
    let (sine, cosine) = (Interval::around(&sine, &error, working), Interval::around(&cosine, &error, working));
    match remainder_of_four(&k) {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// sin t and cos t from their series, and the error of each in units; |t| < 1.
///
/// Term n is term n-1 times t/n, with a shift and a division that each lose at most 1 unit: with e the error of the
/// term before, e|t|/n + 1/n + 1, which is at most 2 for n = 1, and never above 3 thereafter. When a term has become
/// nought, its true value is at most 3 units, and those of the same series after it sum to less than 3 more.
fn sine_and_cosine_series(t: &IBig, bits: usize) -> (IBig, IBig, usize) {
    let mut term = IBig::ONE << bits;
    let (mut sine, mut cosine, mut n) = (IBig::ZERO, term.clone(), 0usize);
    loop {
        steps::add(steps::of_bits(bits));
        n += 1;
        term = ((term * t) >> bits) / n;
        if term == IBig::ZERO {
            return (sine, cosine, 3 * n + 6);
        }
        match n % 4 {
            0 => cosine += &term,
            1 => sine += &term,
            2 => cosine -= &term,
            _ => sine -= &term,
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use rand::rngs::ChaCha8Rng;
    use rand::{RngExt, SeedableRng};

    use super::*;
    use crate::number::Fraction;

    pub fn read(text: &str) -> Fraction {
        text.parse().unwrap()
    }

    pub fn enclosed(text: &str, bits: usize) -> Interval {
        Interval::from_fraction(&read(text), bits)
    }

    /// Is it narrow, and do both ends agree with these figures (from another library) to 39 places?
    pub fn assert_figures(name: &str, interval: &Interval, figures: &str) {
        let last = Fraction::ONE / read(&format!("1{}", "0".repeat(39)));
        let figures = read(figures);
        let near = interval.lower() > &figures - &last && interval.upper() < &figures + &last;
        assert!(near, "{name}: {interval:?}");
    }

    /// The last 26 of the first `count` figures after the point, if both ends agree on them.
    pub fn late_figures(interval: &Interval, count: usize) -> String {
        let scale = Fraction::from(IBig::from(10).pow(count));
        let (lower, upper) = ((interval.lower() * scale.clone()).floor(), (interval.upper() * scale).floor());
        assert_eq!(lower, upper);
        let figures = lower.to_string();
        figures[figures.len() - 26..].to_owned()
    }

    #[test]
    fn pi_and_sines_to_forty_figures() {
        let degree = |count: i64| Interval::pi(160) * enclosed(&format!("{count}/180"), 160);
        assert_figures("pi", &Interval::pi(160), "3.1415926535897932384626433832795028841972");
        assert_figures("sin 10 deg", &degree(10).sin(), "0.17364817766693034885171662676931479600038");
        for (angle, sine, cosine) in [
            ("1", "0.84147098480789650665250232163029899962256", "0.54030230586813971740093660744297660373231"),
            ("-7", "-0.65698659871878909039699909159363517793687", "0.753902254343304638141197521719182012218313"),
            ("100000", "0.035748797972016509316470500695808829009046", "-0.999360807438212451891135414144802203235387"),
            (
                "100000000000000000000",
                "-0.645251285265780844205811711312523007406904",
                "0.76397040444172830040014680273788112283447",
            ),
        ] {
            let angle = enclosed(angle, 160);
            assert_figures("sin", &angle.sin(), sine);
            assert_figures("cos", &angle.cos(), cosine);
        }
        assert_figures("tan 1", &enclosed("1", 160).tan().unwrap(), "1.5574077246549022305069748074583601730873");
        assert_figures("tan 2", &enclosed("2", 160).tan().unwrap(), "-2.1850398632615189916433061023136825434320");
    }

    #[test]
    fn six_thousand_figures_of_pi_and_of_a_sine() {
        assert_eq!(late_figures(&Interval::pi(20_000), 6014), "84506877246029016187667952");
        assert_eq!(late_figures(&enclosed("2", 20_000).sin(), 6015), "29163406399418700256231184");
    }

    #[test]
    fn the_proved_errors_hold_before_guard_bits_hide_them() {
        let mut random = ChaCha8Rng::seed_from_u64(5);
        for bits in (0..400).step_by(7) {
            assert!(machin(bits + 90).overlaps(&machin(bits)));
            for _ in 0..10 {
                let point =
                    IBig::from(random.random_range(-1 << 30..1 << 30_i64)) << bits >> random.random_range(20..40);
                let (sine, cosine) = sine_and_cosine(&point, bits);
                let (finer_sine, finer_cosine) = sine_and_cosine(&(point << 90usize), bits + 90);
                assert!(sine.overlaps(&finer_sine) && cosine.overlaps(&finer_cosine), "{sine:?} {cosine:?}");
            }
        }
    }

    #[test]
    fn results_are_a_few_units_wide_and_more_bits_are_narrower() {
        for bits in [0, 1, 2, 3, 16, 64, 65, 100, 192, 1000] {
            let unit = Fraction::ONE / Fraction::from(IBig::ONE << bits);
            assert!(Interval::pi(bits).width() <= &unit * &Fraction::from(2), "{bits}");
            assert!(Interval::pi(bits).overlaps(&Interval::pi(bits + 40)));
            // A point is an angle without width of its own.
            for numerator in [-9, -4, 0, 1, 5, 77] {
                let angle = Interval::point(IBig::from(numerator) << bits >> 2usize, bits);
                for value in [angle.sin(), angle.cos()] {
                    assert!(value.width() <= &unit * &Fraction::from(2), "{angle:?} {value:?}");
                }
            }
        }
    }

    #[test]
    fn wide_angles_reach_the_extremes_that_they_pass() {
        for (lower, upper, sine, cosine) in [
            ("0", "1", (0.0, 0.8414709848078965), (0.5403023058681398, 1.0)),
            ("-1", "1", (-0.8414709848078965, 0.8414709848078965), (0.5403023058681398, 1.0)),
            ("1", "2", (0.8414709848078965, 1.0), (-0.4161468365471424, 0.5403023058681398)),
            ("3", "4", (-0.7568024953079282, 0.1411200080598672), (-1.0, -0.6536436208636119)),
            ("4", "5", (-1.0, -0.7568024953079282), (-0.6536436208636119, 0.2836621854632262)),
            ("-5", "-4", (0.7568024953079282, 1.0), (-0.6536436208636119, 0.2836621854632262)),
            ("0", "7", (-1.0, 1.0), (-1.0, 1.0)),
        ] {
            let angle = enclosed(lower, 64).hull(&enclosed(upper, 64));
            for (value, (least, greatest)) in [(angle.sin(), sine), (angle.cos(), cosine)] {
                let near = |end: Fraction, expected: f64| (end.to_f64() - expected).abs() < 1e-15;
                assert!(near(value.lower(), least) && near(value.upper(), greatest), "{angle:?}: {value:?}");
            }
        }
    }

    #[test]
    fn exact_values_and_poles() {
        let zero = Interval::integer(0, 64);
        assert_eq!((zero.sin(), zero.cos(), zero.tan()), (zero.clone(), Interval::integer(1, 64), Some(zero.clone())));
        assert_eq!(Interval::half_pi(64).tan(), None);
        assert_eq!(Interval::integer(1, 64).hull(&Interval::integer(2, 64)).tan(), None);
        let pi = Interval::pi(64);
        assert!(pi.tan().unwrap().contains_zero() && pi.cos().contains(&Fraction::from(-1)));
        let sixth = pi * enclosed("1/6", 64);
        assert!(sixth.sin().contains(&Fraction::new(1, 2)));
    }

    #[test]
    fn an_absurd_angle_gives_the_whole_range_at_once() {
        let absurd = Interval::point(IBig::ONE << 100_000usize, 64);
        assert_eq!((absurd.sin().width(), absurd.tan()), (Fraction::from(2), None));
    }

    #[test]
    fn every_angle_of_an_interval_has_its_sine_in_the_range() {
        let mut random = ChaCha8Rng::seed_from_u64(2);
        for _ in 0..150 {
            let bits = random.random_range(0..90);
            let start = Fraction::new(random.random_range(-4000..=4000), 300);
            let width = Fraction::new(random.random_range(0..=900), 300);
            let at = |part: i64| &start + &(&width * &Fraction::new(part, 7));
            let range = Interval::from_fraction(&at(0), bits).hull(&Interval::from_fraction(&at(7), bits));
            for part in 0..=7 {
                let angle = Interval::from_fraction(&at(part), 200);
                let (sine, cosine) = (angle.sin(), angle.cos());
                assert!(range.sin().overlaps(&sine) && range.cos().overlaps(&cosine), "{range:?} {angle:?}");
                if let (Some(wide), Some(narrow)) = (range.tan(), angle.tan()) {
                    assert!(wide.overlaps(&narrow), "{range:?} {angle:?}");
                }
                let squares = sine.clone() * sine.clone() + cosine.clone() * cosine;
                assert!(squares.contains(&Fraction::ONE));
                assert!((sine.to_f64() - angle.to_f64().sin()).abs() < 1e-14);
            }
        }
    }
}
