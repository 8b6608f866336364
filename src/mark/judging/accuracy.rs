//! Accuracy in examiners' words, tested on the figures that the student wrote against certified figures of the model.
//!
//! The rules, in the order in which they are tried. *n figures* is what the rule of acceptance asks for.
//!
//! 1. Exactly the model value is right, however few figures it has: `9` for 9, `1.92` for 48/25.
//! 2. Over-accuracy is free: a decimal with at least n figures is right if it and the model round to the same n figures:
//!    0.2325 for 10/43, since both round to 0.233. So is one whose figures are all right: 2.745 for 2.7446.
//! 3. A decimal with fewer figures, but two at least, that is the model rounded to them is *under-accurate*.
//! 4. A decimal with two figures at least that is the model cut off after them is *truncated*.
//! 5. A decimal with at least three figures that differs from the model by less than one hundredth of it is a *near
//!    miss*: what early rounding leads to.
//! 6. Arithmetic that is left undone is judged by what it comes to, if no decimal in it has fewer than two figures.
//! 7. Anything else is wrong; one significant figure is evidence of nothing. A whole number is no other that was rounded:
//!    10 for 12 is simply wrong.

use std::cmp::Ordering;

use crate::answer::Accept;
use crate::expr::Expr;
use crate::mark::enclosure::enclose;
use crate::number::{Decimal, FloatInterval, Fraction, Interval, Places, Uncertain, Value, round, round_certified};

use super::Note;
use super::angle::Enclosed;
use super::coarsest::Coarsest;
use super::exact::{Equality, proved};
use super::finding::Finding;

/// The fewest significant figures that are worth anything without being exact.
pub(super) const FEWEST: u32 = 2;
/// The fewest with which a decimal can be a near miss.
const FEWEST_NEAR: u32 = 3;
/// The figures to which a decimal is looked at where the exact value is wanted.
const FIGURES_FOR_EXACT: u32 = 3;
/// The precision of enclosures that tell what is far from what.
pub(super) const BITS: usize = 96;
/// The finest enclosure of a formula that is too long for its exact value.
const MOST_BITS: usize = 2048;
/// No rounding is tried beyond so many decimal places: the figures after them say nothing about a mark.
const MOST_PLACES: i64 = 60;

/// A decimal as it was written.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Written {
    pub(super) value: Fraction,
    /// Significant figures, noughts at the end included.
    pub(super) figures: u32,
    /// The place of the last figure: 2 for `2.78`, 0 for `46`, -2 for `1.2 × 10^3`.
    pub(super) places: i64,
    /// Noughts at the end of a whole number, which may or may not be figures: 2 in `1200`.
    noughts: u32,
    /// Was it worked out from what was written? Then its own last figures say nothing.
    worked_out: bool,
    /// Was it left to be worked out? Then whichever decimals are in it may be exact: `√(1.2124² + 2.5²)`.
    left_undone: bool,
}

impl Written {
    /// The decimal that the expression is, if it is nothing more: `2.78`, `-46`, `1.2*10^3`.
    pub(super) fn of(expr: &Expr) -> Option<Written> {
        match expr {
            Expr::Decimal(text) => Written::text(text),
            Expr::Number(number) if number.is_integer() => Written::text(&number.to_string()),
            Expr::Negative(inner) => Some(Written::of(inner)?.negated()),
            Expr::Product(factors) => match factors.as_slice() {
                [mantissa, Expr::Power(base, exponent)] if **base == Expr::integer(10) => {
                    let mantissa = Written::of(mantissa)?;
                    let power = match &**exponent {
                        Expr::Number(power) => power.as_small(),
                        Expr::Negative(power) => match &**power {
                            Expr::Number(power) => power.as_small().map(|(power, below)| (-power, below)),
                            _ => None,
                        },
                        _ => None,
                    };
                    let (power, 1) = power? else { return None };
                    let by = Fraction::from(10).power(i32::try_from(power).ok().filter(|power| power.abs() <= 60)?)?;
                    Some(Written { noughts: 0, ..mantissa }.times(&by, power))
                }
                _ => None,
            },
            _ => None,
        }
    }

    pub(super) fn text(text: &str) -> Option<Written> {
        let value: Fraction = text.parse().ok()?;
        let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
        let digits: String = whole.chars().chain(decimals.chars()).filter(char::is_ascii_digit).collect();
        let figures = digits.trim_start_matches('0').len() as u32;
        let noughts = if text.contains('.') || figures == 0 {
            0
        } else {
            (digits.len() - digits.trim_end_matches('0').len()) as u32
        };
        Some(Written { value, figures, places: decimals.len() as i64, noughts, worked_out: false, left_undone: false })
    }

    /// Is it further from a number than any rule forgives?
    pub(super) fn is_far_from(&self, exact: FloatInterval, wanted: &Places) -> bool {
        let last_place = if self.noughts > 0 { -i64::from(self.noughts) } else { self.places };
        is_far(FloatInterval::from_fraction(&self.value), last_place, exact, wanted)
    }

    /// Is it the number, rounded to the places that it has?
    pub(super) fn is_rounding_of(&self, exact: &Value) -> bool {
        let rounded = decimal_places(self.places).and_then(|places| exact.rounded(&places).ok());
        rounded.is_some_and(|rounded| rounded.to_fraction() == self.value)
    }

    /// Is it the other, rounded to fewer places?
    pub(super) fn is_short_for(&self, other: &Written) -> bool {
        self.places < other.places && self.is_rounding_of(&other.value.clone().into())
    }

    /// The decimal with its sign changed.
    pub(super) fn negated(&self) -> Written {
        Written { value: -self.value.clone(), ..self.clone() }
    }

    /// So many times the decimal, where that moves its point by so many places to the right.
    pub(super) fn times(&self, factor: &Fraction, places: i64) -> Written {
        Written { value: &self.value * factor, places: self.places - places, ..self.clone() }
    }

    /// The decimal in another unit. A power of ten moves the point; any other factor leaves no place that was written.
    pub(super) fn converted(&self, scale: &Fraction) -> Written {
        let moved = (-60..=60).find(|power| Fraction::from(10).power(*power).as_ref() == Some(scale));
        let written = self.times(scale, moved.map_or(0, i64::from));
        Written { worked_out: self.worked_out || moved.is_none(), ..written }
    }

    /// A value that was worked out with decimals: it is worth no more figures than the shortest of them, nor than it has
    /// itself where it ends as they do, as `28 − 22.7` has two.
    pub(super) fn worked_out(value: Fraction, decimals: &Coarsest) -> Written {
        let own = in_units(&value, decimals.places).map(|whole| whole.to_string().trim_start_matches('0').len() as u32);
        let figures = own.map_or(decimals.figures, |own| own.min(decimals.figures));
        Written { value, figures, places: decimals.places, noughts: 0, worked_out: true, left_undone: false }
    }

    /// The same where nothing is done with it but working it out.
    pub(super) fn left_undone(self) -> Written {
        Written { left_undone: true, ..self }
    }
}

/// How many units of that place a number is, if it ends there.
fn in_units(value: &Fraction, places: i64) -> Option<Fraction> {
    let tens = Fraction::from(10).power(places.clamp(0, MOST_PLACES) as i32)?;
    Some((value * &tens).abs()).filter(Fraction::is_integer)
}

pub(super) fn suffices(figures: u32, places: i64, wanted: &Places) -> bool {
    match wanted {
        Places::SignificantFigures(count) => figures >= *count,
        Places::DecimalPlaces(count) => places >= i64::from(*count),
        Places::Nearest(_) => true,
    }
}

/// Does the last figure stand as far on as the last of the figures of the model that are asked for?
fn reaches(places: i64, model: &Decimal, wanted: &Places) -> bool {
    let Places::SignificantFigures(count) = wanted else { return true };
    let figures = model.figures.to_string().trim_start_matches('-').len() as i64;
    let before_the_point = figures - i64::from(model.places);
    places >= i64::from(*count) - before_the_point
}

/// Is a last figure of that place no coarser than the rule asks? `2 kJ` is not 1923 J to the nearest joule.
fn is_as_fine_as(places: i64, wanted: &Places) -> bool {
    match wanted {
        Places::Nearest(step) => {
            let unit = Fraction::new(1, 10).power(places.clamp(-MOST_PLACES, MOST_PLACES) as i32);
            unit.is_none_or(|unit| unit <= step.decimal().to_fraction())
        }
        _ => true,
    }
}

/// Enclosures of one number: to [`BITS`], and between doubles.
#[derive(Clone)]
pub(super) struct Nearly {
    pub(super) finely: Interval,
    pub(super) roughly: FloatInterval,
}

impl Nearly {
    pub(super) fn of(finely: Interval) -> Nearly {
        let roughly = FloatInterval::from_interval(&finely);
        Nearly { finely, roughly }
    }
}

/// An exact number that a decimal is held against.
pub(super) enum Target<'a> {
    /// A value, with its enclosures where they are known.
    Value(&'a Value, Option<&'a Nearly>),
    /// A formula without letters that is too long for its exact value, with its enclosures.
    Formula(&'a Expr, Option<&'a Nearly>),
    /// An angle as so many degrees.
    Degrees(&'a Enclosed),
    /// An angle as so many radians.
    Radians(&'a Enclosed),
}

impl Target<'_> {
    /// Its enclosures, where they are known.
    fn nearly(&self) -> Option<&Nearly> {
        match self {
            Target::Value(_, nearly) | Target::Formula(_, nearly) => *nearly,
            Target::Degrees(angle) => angle.enclosure(),
            Target::Radians(_) => None,
        }
    }

    fn enclose(&self, bits: usize) -> Option<Interval> {
        match self {
            // A rounding may be certified by any enclosure that is narrow enough.
            Target::Value(_, Some(nearly)) | Target::Formula(_, Some(nearly)) if bits <= BITS => {
                Some(nearly.finely.clone())
            }
            Target::Value(value, _) => value.enclose_constant(bits),
            // What has no enclosure has none that is finer, and a tie that is not decided by so many bits is for a person.
            Target::Formula(_, None) => None,
            Target::Formula(..) if bits > MOST_BITS => None,
            Target::Formula(expr, _) => enclose(expr, &[], 0, bits),
            Target::Degrees(angle) => angle.enclose(bits),
            Target::Radians(angle) => {
                (angle.enclose(bits)? * Interval::pi(bits)).checked_div(&Interval::integer(180, bits))
            }
        }
    }

    pub(super) fn equals(&self, number: &Fraction) -> bool {
        let is_apart = |nearly: &Nearly| {
            !nearly.roughly.overlaps(FloatInterval::from_fraction(number))
                || !nearly.finely.overlaps(&Interval::from_fraction(number, BITS))
        };
        if self.nearly().is_some_and(is_apart) {
            return false;
        }
        match self {
            Target::Value(value, _) => value.equals(&Value::from(number.clone())),
            Target::Formula(expr, _) => proved(expr, &Expr::Number(number.clone()), &[]) == Equality::Equal,
            Target::Degrees(angle) => angle.turn.is_degrees(number),
            // Neither pi times a fraction nor an inverse tangent of a root is a fraction, but for nought.
            Target::Radians(angle) => number.is_zero() && angle.turn.is_degrees(number),
        }
    }

    pub(super) fn rounded(&self, places: &Places) -> Result<Decimal, Uncertain> {
        match self {
            Target::Value(value, nearly) if nearly.is_none() || value.as_fraction().is_some() => value.rounded(places),
            Target::Degrees(angle) | Target::Radians(angle) if !angle.turn.is_constant() => Err(Uncertain),
            _ => round_certified(|bits| self.enclose(bits), |tie| self.equals(tie), places),
        }
    }

    /// Is the number within one hundredth of it?
    fn is_near(&self, number: &Fraction) -> bool {
        let bits = BITS;
        let Some(exact) = self.enclose(bits) else { return false };
        let gap = (Interval::from_fraction(number, bits) - exact.clone()).abs();
        (gap * Interval::integer(100, bits)).upper() < exact.abs().lower()
    }
}

/// The places that the rule asks for; where the exact value is wanted, those to which a decimal is recognised.
pub(super) fn places(accept: &Accept) -> Places {
    accept.places().cloned().unwrap_or(Places::SignificantFigures(FIGURES_FOR_EXACT))
}

/// How a decimal fares by the rules above.
pub(super) fn decimal(written: &Written, target: &Target, accept: &Accept) -> Finding {
    let wanted = places(accept);
    let roughly = match target.nearly() {
        Some(nearly) => Some(nearly.roughly),
        None => target.enclose(BITS).as_ref().map(FloatInterval::from_interval),
    };
    if roughly.is_some_and(|exact| written.is_far_from(exact, &wanted)) {
        return Finding::WRONG;
    }
    if target.equals(&written.value) {
        return Finding::EXACT;
    }
    let Ok(model) = target.rounded(&wanted) else { return Finding::unreadable(Note::CannotBeCompared) };
    // `10.0` has three figures, and 9.96 has its third one place further on. What is worked out may end beyond its decimals.
    let reaches = in_units(&written.value, written.places).is_none() || reaches(written.places, &model, &wanted);
    let enough = suffices(written.figures, written.places, &wanted) && reaches;
    let is_fine = is_as_fine_as(written.places, &wanted);
    let last = last_place(written, target);
    let coarse = Written { places: -i64::from(written.noughts), ..written.clone() };
    let to_noughts = written.noughts > 0 && last_place(&coarse, target) == LastPlace::Rounded;
    // What rounds to nought may come from either side of it.
    let has_other_sign = match written.value.sign() {
        Ordering::Less => roughly.is_some_and(|exact| exact.lower > 0.0),
        Ordering::Equal => false,
        Ordering::Greater => roughly.is_some_and(|exact| exact.upper < 0.0),
    };
    let rounds_alike = !has_other_sign && round(&written.value, &wanted).to_fraction() == model.to_fraction();
    // 2.745 for 2.7446 is right to the figures that it has, though it would be rounded to 2.75 again.
    let is_as_good = written.left_undone && written.figures >= FEWEST && rounds_alike;
    if is_as_good || enough && (last == LastPlace::Rounded && is_fine || rounds_alike) {
        let later = last == LastPlace::Neither && !to_noughts && !written.worked_out;
        let right = Finding::correct(later.then_some(Note::LaterFigures));
        return if *accept == Accept::Exact { right.at_most_partial(Note::ExactWanted) } else { right };
    }
    // Nobody rounds 32 to 30, nor 0.5, which is short already, to 1.
    let is_short = |number: &Fraction| {
        let one_figure = round(number, &Places::SignificantFigures(1)).to_fraction();
        number.is_integer() || one_figure == *number
    };
    let exactly = model.to_fraction();
    let was_rounded = !(written.value.is_integer() && is_short(&exactly) && target.equals(&exactly));
    match last {
        LastPlace::Rounded if written.figures >= FEWEST => Finding::partial(Note::UnderAccurate),
        LastPlace::CutOff if written.figures >= FEWEST => Finding::partial(Note::Truncated),
        LastPlace::Rounded if written.figures > 0 && was_rounded => Finding::wrong(Note::TooFewFigures),
        LastPlace::Rounded | LastPlace::CutOff => Finding::WRONG,
        LastPlace::Neither => {
            if to_noughts {
                // `1200` for 1234, to the nearest hundred.
                let few = written.figures.saturating_sub(written.noughts) < FEWEST;
                return match few {
                    true if was_rounded => Finding::wrong(Note::TooFewFigures),
                    true => Finding::WRONG,
                    false => Finding::partial(Note::UnderAccurate),
                };
            }
            if written.figures >= FEWEST_NEAR && target.is_near(&written.value) {
                return Finding::partial(Note::NearMiss);
            }
            Finding::WRONG
        }
    }
}

/// Is a value, of which the last figure has that place, further off than any rule forgives? Most wrong answers are, and
/// doubles show it.
///
/// Two that round to one value are at most a unit of that rounding apart; what is rounded or cut off is within a unit
/// of its own last figure; a near miss is within a hundredth.
pub(super) fn is_far(found: FloatInterval, last_place: i64, exact: FloatInterval, wanted: &Places) -> bool {
    let size = exact.abs().upper;
    let tenths = |places: u32, most: u32| 0.1_f64.powi(places.min(most).cast_signed());
    let unit = match wanted {
        Places::SignificantFigures(figures) => size * tenths(figures.saturating_sub(1), 2),
        Places::DecimalPlaces(places) => tenths(*places, 60),
        Places::Nearest(step) => step.decimal().to_fraction().to_f64(),
    };
    let last = 10_f64.powi(-(last_place.clamp(-MOST_PLACES, MOST_PLACES) as i32));
    // Doubles are rounded, but not by so much.
    (found - exact).abs().lower > unit.max(last).max(size / 100.0) * 1.000_001
}

/// What the last figure that was written is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LastPlace {
    /// The model, rounded to that place.
    Rounded,
    /// The model, cut off after that place.
    CutOff,
    Neither,
}

fn last_place(written: &Written, target: &Target) -> LastPlace {
    let Some(places) = decimal_places(written.places) else { return LastPlace::Neither };
    let Ok(rounded) = target.rounded(&places) else { return LastPlace::Neither };
    let rounded = rounded.to_fraction();
    if rounded == written.value {
        return LastPlace::Rounded;
    }
    // Rounded away from nought by one in the last place: cut off, it would have been one less in size.
    let unit = match written.places {
        0.. => Fraction::new(1, 10).power(written.places as i32),
        _ => Fraction::from(10).power(-written.places as i32),
    };
    let size = rounded.abs() - unit.unwrap_or(Fraction::ZERO);
    let same_sign = rounded.sign() == written.value.sign() || written.value.is_zero();
    let was_rounded_up =
        target.rounded(&finer(written.places)).is_ok_and(|finer| finer.to_fraction().abs() < rounded.abs());
    if size == written.value.abs() && same_sign && was_rounded_up { LastPlace::CutOff } else { LastPlace::Neither }
}

fn decimal_places(places: i64) -> Option<Places> {
    if places.abs() > MOST_PLACES {
        return None;
    }
    match u32::try_from(places) {
        Ok(places) => Some(Places::DecimalPlaces(places)),
        Err(_) => Places::nearest(&Fraction::from(10).power(-places as i32)?),
    }
}

/// Eight places further on.
fn finer(places: i64) -> Places {
    Places::DecimalPlaces((places.clamp(0, MOST_PLACES) + 8) as u32)
}
