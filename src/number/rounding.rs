//! Rounding as schools do it, proved in every digit.
//!
//! Conventions. A half is rounded away from nought, on both sides: 2.5 to 3 and -2.5 to -3. A 'unit' is one in the
//! last figure kept; a 'tie' is a value half a unit from both neighbours. To significant figures the unit grows
//! tenfold at each power of ten: the tie below 10.0 is 9.995, the one above is 10.05. Nought to any number of
//! significant figures is `0`.

use std::cmp::Ordering;
use std::fmt;

use dashu_int::IBig;
use dashu_int::ops::{BitTest, UnsignedAbs};

use super::decimal::power_of_ten;
use super::interval::floor_quotient;
use super::{Decimal, FloatInterval, Fraction, Interval, Places};

/// Rounds an exact value.
///
/// ```
/// use carom::number::{Fraction, Places, round};
/// assert_eq!(round(&Fraction::new(1999, 1000), &Places::SignificantFigures(3)).to_string(), "2.00");
/// assert_eq!(round(&Fraction::new(-5, 2), &Places::DecimalPlaces(0)).to_string(), "-3");
/// ```
pub fn round(exact: &Fraction, places: &Places) -> Decimal {
    round_quotient(&exact.numerator(), &exact.denominator(), places)
}

/// The number of bits with which [`round_certified`] begins; twice as many at each step.
const FIRST_BITS: usize = 64;
/// The number of bits beyond which it gives up.
const LAST_BITS: usize = 1 << 17;

/// The rounding was not proved: the enclosure never became narrow enough, or there was none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Uncertain;

impl fmt::Display for Uncertain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the rounding is not certain after {LAST_BITS} bits")
    }
}

impl std::error::Error for Uncertain {}

/// Rounds a value that can be enclosed as narrowly as one likes, and proves every figure.
///
/// `enclose` gives an interval around the value, computed with so many bits, or `None` if that is too few.
/// `equals` decides exactly whether the value is a certain fraction. It is asked only where no enclosure can
/// tell: for a tie that the interval holds, or for nought to significant figures; once for each.
///
/// ```
/// use carom::number::{Fraction, Interval, Places, round_certified};
/// let root_of_two = |bits| Interval::integer(2, bits).sqrt();
/// let rounded = round_certified(root_of_two, |_| false, &Places::SignificantFigures(30)).unwrap();
/// assert_eq!(rounded.to_string(), "1.41421356237309504880168872421");
/// ```
pub fn round_certified(
    enclose: impl Fn(usize) -> Option<Interval>,
    equals: impl Fn(&Fraction) -> bool,
    places: &Places,
) -> Result<Decimal, Uncertain> {
    let mut denied: Vec<Fraction> = Vec::new();
    let mut bits = FIRST_BITS;
    while bits <= LAST_BITS {
        if let Some(enclosure) = enclose(bits) {
            let (below, above) = round_ends(&enclosure, places);
            if below == above {
                return Ok(below);
            }
            if let Some(suspect) = suspect(&enclosure, &below, &above, places)
                && !denied.contains(&suspect)
            {
                if equals(&suspect) {
                    return Ok(round(&suspect, places));
                }
                denied.push(suspect);
            }
        }
        bits *= 2;
    }
    Err(Uncertain)
}

/// The one value because of which no narrower enclosure might settle the rounding: nought, where ever smaller units
/// pile up, or the tie between neighbours; `None` if the ends are further apart than that.
fn suspect(enclosure: &Interval, below: &Decimal, above: &Decimal, places: &Places) -> Option<Fraction> {
    if matches!(places, Places::SignificantFigures(_)) && enclosure.contains_zero() {
        return Some(Fraction::ZERO);
    }
    // The unit changes at numbers that are themselves rounded, so the tie is half-way on either side of them.
    let middle = (below.to_fraction() + above.to_fraction()) * Fraction::new(1, 2);
    let rounded = round(&middle, places);
    (rounded == *below || rounded == *above).then_some(middle)
}

/// Is all of the enclosure proved to lie at least `margin` units away from every tie?
///
/// The unit of a tie is that of the figures on whose boundary it lies: 0.01 for 9.995 to three figures.
/// An enclosure that holds nought and more is never clear to significant figures.
///
/// ```
/// use carom::number::{Fraction, Interval, Places, clear_of_tie};
/// let value = Interval::from_fraction(&Fraction::new(2744, 1000), 64);
/// let places = Places::SignificantFigures(3);
/// assert!(clear_of_tie(&value, &places, &Fraction::new(1, 20)));
/// assert!(!clear_of_tie(&value, &places, &Fraction::new(1, 5)));
/// ```
pub fn clear_of_tie(enclosure: &Interval, places: &Places, margin: &Fraction) -> bool {
    // To round and to measure by magnitude, which is the same by symmetry, spares the mirrored cases.
    if enclosure.sign() == Some(Ordering::Less) {
        return clear_of_tie(&-enclosure.clone(), places, margin);
    }
    let (rounded, above) = round_ends(enclosure, places);
    if rounded != above {
        return false;
    }
    let centre = rounded.to_fraction();
    let upper_unit = unit(&centre, places);
    // Just below a power of ten the figures are finer than at it.
    let lower_unit = match places {
        Places::SignificantFigures(_) => unit(&(&centre - &(&upper_unit * &Fraction::new(1, 20))), places),
        _ => upper_unit.clone(),
    };
    let room = Fraction::new(1, 2) - margin.clone();
    enclosure.lower() >= &centre - &(lower_unit * room.clone()) && enclosure.upper() <= centre + upper_unit * room
}

/// Are two doubles, and so what lies between them, clear of a tie by this part of a unit, as [`clear_of_tie`] says it? Nothing
/// is said near a power of ten, for steps, and where they are about so far from a tie.
pub(crate) fn clear_in_doubles(ends: FloatInterval, places: &Places, margin: f64) -> Option<bool> {
    const SLACK: f64 = 1e-6;
    let size = ends.abs().lower;
    let exponent = match places {
        Places::SignificantFigures(figures) => {
            let magnitude = size.log10();
            let next = 10f64.powf(magnitude - magnitude.floor());
            if !(1.001..9.99).contains(&next) {
                return None;
            }
            magnitude.floor() - f64::from((*figures).max(1)) + 1.0
        }
        Places::DecimalPlaces(places) => -f64::from(*places),
        Places::Nearest(_) => return None,
    };
    let unit = 10f64.powf(exponent);
    let (count, width) = (size / unit, (ends.upper - ends.lower) / unit);
    let beyond = ((count - count.floor()) - 0.5).abs() - margin;
    // Counts beyond this have no figures left after the point.
    (count < 1e8 && width < SLACK && beyond.abs() > SLACK).then_some(beyond > 0.0)
}

/// Both ends, rounded.
fn round_ends(enclosure: &Interval, places: &Places) -> (Decimal, Decimal) {
    let denominator = IBig::ONE << enclosure.bits;
    (round_quotient(&enclosure.lower, &denominator, places), round_quotient(&enclosure.upper, &denominator, places))
}

/// Rounds a quotient with positive denominator, which need not be in lowest terms.
fn round_quotient(numerator: &IBig, denominator: &IBig, places: &Places) -> Decimal {
    let (mut factor, mut exponent) = grid(numerator, denominator, places);
    let magnitude = IBig::from(numerator.unsigned_abs());
    let mut count = match exponent {
        0.. => nearest_integer(&magnitude, &(denominator * &factor * power_of_ten(exponent))),
        _ => nearest_integer(&(magnitude * power_of_ten(-exponent)), &(denominator * &factor)),
    };
    if let Places::SignificantFigures(figures) = places
        && count == power_of_ten((*figures).max(1).into())
    {
        // 9.995 has become 1000 hundredths, one figure too many.
        count /= 10u8;
        exponent += 1;
    }
    if *numerator < IBig::ZERO {
        factor = -factor;
    }
    match u32::try_from(-exponent) {
        Ok(places) => Decimal { figures: count * factor, places },
        Err(_) => Decimal { figures: count * factor * power_of_ten(exponent), places: 0 },
    }
}

/// The unit at this value: `factor` times ten to the power of `exponent`.
fn grid(numerator: &IBig, denominator: &IBig, places: &Places) -> (IBig, i64) {
    match places {
        Places::DecimalPlaces(count) => (IBig::ONE, -i64::from(*count)),
        Places::Nearest(step) => (step.decimal().figures.clone(), -i64::from(step.decimal().places)),
        Places::SignificantFigures(_) if *numerator == IBig::ZERO => (IBig::ONE, 0),
        Places::SignificantFigures(count) => {
            (IBig::ONE, leading_place(numerator, denominator) + 1 - i64::from((*count).max(1)))
        }
    }
}

fn unit(value: &Fraction, places: &Places) -> Fraction {
    let (factor, exponent) = grid(&value.numerator(), &value.denominator(), places);
    let power = Fraction::from(power_of_ten(exponent.abs()));
    let factor = Fraction::from(factor);
    if exponent < 0 { factor / power } else { factor * power }
}

/// The place of the first figure that is not nought: 0 for 2.78, -2 for 0.0305, 3 for 1234.
fn leading_place(numerator: &IBig, denominator: &IBig) -> i64 {
    let magnitude = IBig::from(numerator.unsigned_abs());
    let reaches = |place: i64| match place {
        0.. => magnitude >= denominator * power_of_ten(place),
        _ => &magnitude * power_of_ten(-place) >= *denominator,
    };
    // Lengths in bits give the place to within one; 0.30103 is the logarithm of two.
    let bits = magnitude.bit_len() as f64 - denominator.bit_len() as f64;
    let mut place = (bits * std::f64::consts::LOG10_2).floor() as i64;
    while !reaches(place) {
        place -= 1;
    }
    while reaches(place + 1) {
        place += 1;
    }
    place
}

/// The quotient of positive integers, a half rounded up.
fn nearest_integer(numerator: &IBig, denominator: &IBig) -> IBig {
    floor_quotient(&(numerator * 2 + denominator), &(denominator * 2))
}

#[cfg(test)]
mod tests {
    use rand::rngs::ChaCha8Rng;
    use rand::{RngExt, SeedableRng};

    use super::Places::{DecimalPlaces, SignificantFigures};
    use super::*;

    fn read(text: &str) -> Fraction {
        text.parse().unwrap()
    }

    fn nearest(step: &str) -> Places {
        Places::nearest(&read(step)).unwrap()
    }

    #[test]
    fn rounded_values_and_their_noughts() {
        for (exact, places, expected) in [
            ("2.77555", SignificantFigures(3), "2.78"),
            ("0.58999", SignificantFigures(3), "0.590"),
            ("16", SignificantFigures(3), "16.0"),
            ("-0.03049", SignificantFigures(3), "-0.0305"),
            ("1234", SignificantFigures(3), "1230"),
            ("1250", SignificantFigures(2), "1300"),
            ("2", SignificantFigures(3), "2.00"),
            ("0", SignificantFigures(3), "0"),
            ("2.5", SignificantFigures(0), "3"),
            // Ties, which binary floats get wrong, and a figure carried to the front.
            ("2.675", SignificantFigures(3), "2.68"),
            ("-2.675", SignificantFigures(3), "-2.68"),
            ("1.005", DecimalPlaces(2), "1.01"),
            ("9.995", SignificantFigures(3), "10.0"),
            ("9.994999", SignificantFigures(3), "9.99"),
            ("-9.995", SignificantFigures(3), "-10.0"),
            ("999.5", SignificantFigures(3), "1000"),
            ("99999.5", SignificantFigures(2), "100000"),
            ("0.0004995", SignificantFigures(3), "0.000500"),
            ("0.0009995", SignificantFigures(3), "0.00100"),
            ("2/3", SignificantFigures(5), "0.66667"),
            ("2.5", DecimalPlaces(0), "3"),
            ("-2.5", DecimalPlaces(0), "-3"),
            ("0.5", DecimalPlaces(0), "1"),
            ("-0.04", DecimalPlaces(1), "0.0"),
            ("0", DecimalPlaces(2), "0.00"),
            ("38.2", DecimalPlaces(0), "38"),
            ("2/3", nearest("0.25"), "0.75"),
            ("3/8", nearest("0.25"), "0.50"),
            ("-3/8", nearest("0.25"), "-0.50"),
            ("67.5", nearest("15"), "75"),
            ("22", nearest("1"), "22"),
            ("2.3", nearest("2/5"), "2.4"),
        ] {
            let rounded = round(&read(exact), &places);
            assert_eq!(rounded.to_string(), expected, "{exact} to {places:?}");
            assert_eq!(rounded.to_fraction(), read(expected));
        }
    }

    #[test]
    fn exact_and_certified_rounding_agree() {
        let mut random = ChaCha8Rng::seed_from_u64(4);
        let steps = [nearest("0.05"), nearest("15")];
        for turn in 0..400_u32 {
            // Many denominators of 2^a 5^b, so that ties do occur.
            let denominator = *[1, 8, 40, 200, 2000, 20_000, 7, 333].get(turn as usize % 8).unwrap();
            let exact = Fraction::new(random.random_range(-30_000..=30_000), denominator);
            let mut places = vec![SignificantFigures(1 + turn % 5), DecimalPlaces(turn % 4)];
            places.extend(steps.clone());
            for places in places {
                let certified =
                    round_certified(|bits| Some(Interval::from_fraction(&exact, bits)), |f| *f == exact, &places);
                assert_eq!(certified, Ok(round(&exact, &places)), "{exact} to {places:?}");
                // A sloppy enclosure that only narrows with the bits decides the same, tie or not.
                let sloppy = |bits: usize| {
                    let error = Fraction::ONE / Fraction::from(IBig::ONE << (bits / 16));
                    let [low, high] = [&exact - &error, &exact + &error].map(|end| Interval::from_fraction(&end, bits));
                    Some(low.hull(&high))
                };
                assert_eq!(round_certified(sloppy, |f| *f == exact, &places), Ok(round(&exact, &places)), "{exact}");
            }
        }
    }

    #[test]
    fn a_tie_in_a_surd_is_settled_by_the_exact_decision() {
        // root(q^2) is a tie, but no enclosure of a root that knows nothing of it can tell.
        for (tie, places, expected) in [
            ("2.675", SignificantFigures(3), "2.68"),
            ("9.995", SignificantFigures(3), "10.0"),
            ("0.0004995", SignificantFigures(3), "0.000500"),
            ("12.5", DecimalPlaces(0), "13"),
        ] {
            let square = read(tie) * read(tie);
            // A root of two put on and taken off again blurs the ends.
            let blurred = |bits| {
                let two = Interval::integer(2, bits).sqrt()?;
                Some(Interval::from_fraction(&square, bits).sqrt()? + two.clone() - two)
            };
            let equals = |value: &Fraction| value.sign() == Ordering::Greater && value * value == square;
            assert_eq!(round_certified(blurred, equals, &places).unwrap().to_string(), expected, "{tie}");
            let negative = |bits| blurred(bits).map(|value| -value);
            let rounded = round_certified(negative, |value| equals(&-value.clone()), &places).unwrap();
            assert_eq!(rounded.to_string(), format!("-{expected}"));
        }
    }

    #[test]
    fn values_a_hair_beside_a_tie_are_widened_until_they_are_told_apart() {
        let hair = Fraction::ONE / Fraction::from(IBig::ONE << 900usize);
        for (value, expected) in [(read("2.675") - hair.clone(), "2.67"), (read("2.675") + hair.clone(), "2.68")] {
            let blurred = |bits| Some(Interval::from_fraction(&value, bits) + Interval::pi(bits) - Interval::pi(bits));
            let rounded = round_certified(blurred, |suspect| *suspect == value, &SignificantFigures(3));
            assert_eq!(rounded.unwrap().to_string(), expected);
        }
        // A very small value: 2^-900 is 1.18 times 10^-271.
        let tiny =
            round_certified(|bits| Some(Interval::from_fraction(&hair, bits)), |_| false, &SignificantFigures(3));
        assert_eq!(tiny.unwrap().to_string(), format!("0.{}118", "0".repeat(270)));
    }

    #[test]
    fn nought_is_asked_for_once_and_an_undecided_value_is_owned_up_to() {
        use std::cell::Cell;
        let asked = Cell::new(0);
        let blurred_nought = |bits| Some(Interval::pi(bits) - Interval::pi(bits));
        let yes = |value: &Fraction| {
            asked.set(asked.get() + 1);
            value.is_zero()
        };
        assert_eq!(round_certified(blurred_nought, yes, &SignificantFigures(3)).unwrap().to_string(), "0");
        assert_eq!(asked.get(), 1);

        asked.set(0);
        let stubborn = |_| Some(Interval::integer(-1, 8).hull(&Interval::integer(1, 8)));
        let no = |_: &Fraction| {
            asked.set(asked.get() + 1);
            false
        };
        assert_eq!(round_certified(stubborn, no, &SignificantFigures(3)), Err(Uncertain));
        assert_eq!(asked.get(), 1);
        assert_eq!(round_certified(|_| None, |_| true, &DecimalPlaces(1)), Err(Uncertain));
        // Too few bits at first is no obstacle.
        let late = |bits| (bits > 1000).then(|| Interval::integer(7, bits));
        assert_eq!(round_certified(late, |_| false, &DecimalPlaces(1)).unwrap().to_string(), "7.0");
    }

    #[test]
    fn distance_from_ties_counts_in_units_of_the_last_figure() {
        let sf = SignificantFigures(3);
        for (value, places, margin, clear) in [
            // 2.744 is a tenth of a unit from the tie 2.745.
            ("2.744", &sf, "0.1", true),
            ("2.744", &sf, "0.11", false),
            ("2.746", &sf, "0.1", true),
            ("2.746", &sf, "0.11", false),
            ("2.745", &sf, "0.01", false),
            ("-2.744", &sf, "0.1", true),
            ("-2.744", &sf, "0.11", false),
            // About 10.0 the ties are 9.995 in hundredths and 10.05 in tenths.
            ("9.996", &sf, "0.1", true),
            ("9.996", &sf, "0.11", false),
            ("10.04", &sf, "0.1", true),
            ("10.04", &sf, "0.11", false),
            ("10", &sf, "0.5", true),
            ("0", &sf, "0.5", true),
            ("0", &DecimalPlaces(1), "0.5", true),
            ("-0.04", &DecimalPlaces(1), "0.1", true),
            ("-0.04", &DecimalPlaces(1), "0.11", false),
            ("37.3", &DecimalPlaces(0), "0.2", true),
            ("37.3", &DecimalPlaces(0), "0.21", false),
            ("20", &nearest("15"), "0.16", true),
            ("20", &nearest("15"), "0.17", false),
        ] {
            // The enclosure of a decimal is not a point, so the margins named are met but for a hair.
            let enclosure = Interval::from_fraction(&read(value), 200);
            let hair = Fraction::ONE / Fraction::from(IBig::ONE << 100usize);
            let proved = clear_of_tie(&enclosure, places, &(read(margin) - hair));
            assert_eq!(proved, clear, "{value} to {places:?}, {margin}");
        }
        let wide = Interval::integer(-1, 8).hull(&Interval::integer(1, 8));
        assert!(!clear_of_tie(&wide, &sf, &Fraction::ZERO));
        assert!(!clear_of_tie(&wide, &DecimalPlaces(0), &Fraction::ZERO));
    }
}
