//! What a scene determines though no form of it is short enough to be written: named, with a certified decimal.
//!
//! A quotient by a sum of many roots is not carried out, so a quantity that needs one is not known exactly. It is
//! determined all the same: intervals go where the roots cannot.

use std::fmt;

use super::left::settled;
use super::{Answer, Solution};
use crate::mechanics::{Datum, Derivation, Known, Quantity};
use crate::number::{Decimal, Interval, Places, Value};

/// What shows that a quantity exists.
const BITS: usize = 128;

/// A quantity that is determined and has no short exact form.
#[derive(Clone, Debug)]
pub struct Inexact {
    /// Which.
    pub quantity: Quantity,
    /// To 3 significant figures, every one proved; none where that is not decided.
    pub rounded: Option<Decimal>,
}

/// `A.after.n ≈ 1.25 m/s`.
impl fmt::Display for Inexact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", self.quantity)?;
        let Some(rounded) = &self.rounded else { return Ok(()) };
        match self.quantity.unit().plain() {
            "" => write!(f, " ≈ {rounded}"),
            "deg" => write!(f, " ≈ {rounded}°"),
            unit => write!(f, " ≈ {rounded} {unit}"),
        }
    }
}

impl Solution {
    /// What was asked for and is determined, but not to be had exactly. Where letters remain nothing is.
    pub fn without_exact_form(&self) -> Vec<Inexact> {
        let open = |quantity: &&Quantity| !self.knows(**quantity) && Answer::of(self, **quantity).is_none();
        let open: Vec<Quantity> = self.asked.iter().filter(open).copied().collect();
        if open.is_empty() {
            return Vec::new();
        }
        let there = self.in_intervals(BITS, &open);
        let exists = |quantity: &&Quantity| enclosure(&there, **quantity, BITS).is_some();
        let rounded = |quantity| {
            let enclose = |bits| enclosure(&self.in_intervals(bits, &[quantity]), quantity, bits);
            settled(enclose, &Places::SignificantFigures(3)).ok()
        };
        let inexact = |quantity: &Quantity| Inexact { quantity: *quantity, rounded: rounded(*quantity) };
        open.iter().filter(exists).map(inexact).collect()
    }

    /// What is known without letters, and what follows of it, in intervals.
    fn in_intervals(&self, bits: usize, asked: &[Quantity]) -> Known<Interval> {
        let left = self.left();
        let number = |value: &Value| left.enclose(value, bits);
        let datum = |datum: &Datum<Value>| {
            Some(match datum {
                Datum::Number(value) => Datum::Number(number(value)?),
                Datum::Direction { y, x } => Datum::Direction { y: number(y)?, x: number(x)? },
                Datum::Equation([p, q, r]) => Datum::Equation([number(p)?, number(q)?, number(r)?]),
            })
        };
        let enclosed = self.known.0.iter().filter_map(|(quantity, known)| Some((*quantity, datum(known)?)));
        let mut known = Known(enclosed.collect());
        Derivation::carry_out(&mut known, asked);
        known
    }
}

/// A number, or the degrees of an angle.
fn enclosure(known: &Known<Interval>, quantity: Quantity, bits: usize) -> Option<Interval> {
    let degrees = |(y, x): (Interval, Interval)| {
        (Interval::atan2(&y, &x)? * Interval::integer(180, bits)).checked_div(&Interval::pi(bits))
    };
    known.number(quantity).or_else(|| degrees(known.direction(quantity)?))
}
