//! Decimals, and to which places one is asked for.

use std::cmp::Ordering;
use std::fmt;

use dashu_int::IBig;
use dashu_int::ops::UnsignedAbs;

use super::Fraction;

/// To which places a value is rounded.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Places {
    /// So many figures from the first that is not nought; none is taken as one.
    SignificantFigures(u32),
    /// So many figures after the point.
    DecimalPlaces(u32),
    /// The nearest multiple of a step, such as 0.5 or 15.
    Nearest(Step),
}

/// A positive step whose multiples can all be written as decimals; made by [`Places::nearest`].
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Step(Decimal);

impl Step {
    /// The step as it was given.
    pub fn decimal(&self) -> &Decimal {
        &self.0
    }
}

impl Places {
    /// The nearest multiple of a step; `None` unless it is positive and has finitely many decimals.
    ///
    /// ```
    /// use carom::number::{Fraction, Places, round};
    /// let half = Places::nearest(&Fraction::new(1, 2)).unwrap();
    /// assert_eq!(round(&Fraction::new(7, 3), &half).to_string(), "2.5");
    /// assert_eq!(Places::nearest(&Fraction::new(1, 3)), None);
    /// ```
    pub fn nearest(step: &Fraction) -> Option<Places> {
        (step.sign() == Ordering::Greater).then_some(())?;
        Some(Places::Nearest(Step(Decimal::exact(step)?)))
    }
}

/// A number in decimal figures, with the noughts at its end that say how far it was rounded.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Decimal {
    /// All figures without the point: 278 in `2.78`, 200 in `2.00`.
    pub figures: IBig,
    /// How many of them stand after the point.
    pub places: u32,
}

impl Decimal {
    /// The fraction with as few figures as it takes; `None` if it takes infinitely many.
    pub fn exact(value: &Fraction) -> Option<Decimal> {
        let (mut denominator, mut twos, mut fives) = (value.denominator(), 0u32, 0u32);
        while &denominator % 2u8 == 0 {
            denominator /= 2u8;
            twos += 1;
        }
        while &denominator % 5u8 == 0 {
            denominator /= 5u8;
            fives += 1;
        }
        let places = twos.max(fives);
        let figures = value * &Fraction::from(power_of_ten(places.into()));
        figures.is_integer().then(|| Decimal { figures: figures.numerator(), places })
    }

    /// The exact value of the figures.
    pub fn to_fraction(&self) -> Fraction {
        Fraction::from_integers(self.figures.clone(), power_of_ten(self.places.into())).unwrap_or(Fraction::ZERO)
    }
}

/// `2.78`, `0.590`, `16.0`, `-0.0305`, `1230`.
impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.figures < IBig::ZERO { "-" } else { "" };
        let places = self.places as usize;
        let figures = format!("{:0>width$}", self.figures.clone().unsigned_abs().to_string(), width = places + 1);
        let (whole, decimals) = figures.split_at(figures.len() - places);
        let point = if decimals.is_empty() { "" } else { "." };
        write!(f, "{sign}{whole}{point}{decimals}")
    }
}

/// Ten to a power that is not negative.
pub(super) fn power_of_ten(exponent: i64) -> IBig {
    IBig::from(10).pow(exponent as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Fraction {
        text.parse().unwrap()
    }

    #[test]
    fn steps_that_no_decimal_can_show_are_refused() {
        for step in ["0", "-1", "1/3", "1/70"] {
            assert_eq!(Places::nearest(&read(step)), None, "{step}");
        }
        assert_eq!(Decimal::exact(&read("-7/40")).unwrap().to_string(), "-0.175");
        assert_eq!(Decimal::exact(&read("12")).unwrap().to_string(), "12");
        assert_eq!(Decimal::exact(&read("0")).unwrap().to_string(), "0");
    }
}
