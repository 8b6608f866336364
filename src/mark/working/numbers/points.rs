//! Fixed points at which formulas in letters are looked at: each letter stands for a number within its physical range.
//!
//! They are fixed so that the same script earns the same marks for ever. Without letters there is one point.

use crate::mechanics::{Datum, Known, Quantity};
use crate::number::{Fraction, Interval, Letter, Range, Value};

/// How many points are looked at where there are letters.
const POINTS: usize = 3;

/// In what parts of one a number is kept that a letter was found to be.
const FINE: i64 = 1 << 46;

/// Precision of the numbers that letters stand for.
const BITS: usize = 96;

/// What the letters stand for at each point: for an angle its tangent.
#[derive(Clone, Debug)]
pub(in crate::mark::working) struct Points {
    letters: Vec<(Letter, [Fraction; POINTS])>,
    /// How many points there are.
    pub(in crate::mark::working) count: usize,
}

impl Points {
    pub(in crate::mark::working) fn new(letters: &[Letter]) -> Points {
        let each = letters.iter().enumerate().map(|(place, letter)| {
            let at = |point: usize| {
                // Primes keep the numbers unrelated.
                let spread = ((place as i64 + 2) * 29 + point as i64 * 37) % 83;
                match letter.range() {
                    // One of them near one, where only a lively impact does what a question wants.
                    Range::Unit => Fraction::new([20, 50, 86][point] + spread % 9, 97),
                    Range::Real => Fraction::new(2 * spread - 71, 31),
                    _ => Fraction::new(spread + 17, 31),
                }
            };
            (*letter, [at(0), at(1), at(2)])
        });
        Points { letters: each.collect(), count: if letters.is_empty() { 1 } else { POINTS } }
    }

    /// What a letter stands for at a point; an angle in radians.
    pub(in crate::mark::working) fn letter(&self, name: &str, point: usize) -> Option<f64> {
        let same = |(letter, _): &&(Letter, _)| letter.is_called(name);
        let (letter, values) = self.letters.iter().find(same)?;
        let value = values[point].to_f64();
        Some(if letter.range() == Range::Acute { value.atan() } else { value })
    }

    /// An exact value at a point.
    pub(in crate::mark::working) fn value(&self, value: &Value, point: usize) -> Option<f64> {
        if let Value::Rational(number) = value {
            return Some(number.to_f64());
        }
        let at = |letter: Letter| {
            let (_, values) = self.letters.iter().find(|(known, _)| *known == letter)?;
            Some(Interval::from_fraction(&values[point], BITS))
        };
        Some(value.enclose(BITS, &at)?.to_f64())
    }

    /// All that is known, at a point.
    pub(in crate::mark::working) fn known(&self, known: &Known<Value>, point: usize) -> Known<f64> {
        let at = |value: &Value| self.value(value, point);
        let datum = |datum: &Datum<Value>| {
            Some(match datum {
                Datum::Number(value) => Datum::Number(at(value)?),
                Datum::Direction { y, x } => Datum::Direction { y: at(y)?, x: at(x)? },
                Datum::Equation([p, q, r]) => Datum::Equation([at(p)?, at(q)?, at(r)?]),
            })
        };
        Known(known.0.iter().filter_map(|(quantity, value)| Some((*quantity, datum(value)?))).collect())
    }
}

/// A quantity at one point; an angle in degrees.
pub(in crate::mark::working) fn size(known: &Known<f64>, quantity: Quantity) -> Option<f64> {
    sizes(std::slice::from_ref(known), quantity)?.first().copied()
}

/// A quantity at each point; an angle in degrees.
pub(in crate::mark::working) fn sizes(at_points: &[Known<f64>], quantity: Quantity) -> Option<Vec<f64>> {
    at_points
        .iter()
        .map(|known| match known.0.get(&quantity)? {
            Datum::Number(number) => Some(*number),
            Datum::Direction { y, x } => Some(y.atan2(*x).to_degrees()),
            Datum::Equation(_) => None,
        })
        .collect()
}

impl Points {
    /// The same with letters that were to be found standing for what was found at one point.
    pub(in crate::mark::working) fn with(&self, found: &[(Letter, Vec<Option<f64>>)], point: usize) -> Points {
        let mut all = self.clone();
        for (letter, values) in found {
            let own = all.letters.iter_mut().find(|(known, _)| known.is_called(letter.name()));
            if let (Some((_, at)), Some(value)) = (own, values[point]) {
                at[point] = Fraction::new((value * FINE as f64).round() as i64, FINE);
            }
        }
        all
    }
}
