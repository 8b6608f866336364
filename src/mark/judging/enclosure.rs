//! Expressions enclosed at fixed points inside the physical ranges of their letters.
//!
//! Intervals that keep apart refute an equality, quickly and for any expression however long; that they meet proves
//! nothing, and is never taken for proof. The points are fixed so that the same answer earns the same marks for ever.

use std::cell::OnceCell;

use crate::expr::{Expr, Function};
use crate::number::{Fraction, Interval, Letter, Range};

/// How many points are looked at where letters remain.
pub(super) const POINTS: u32 = 6;

/// The highest power that is enclosed.
const MOST_POWER: i64 = 64;

/// What a letter stands for at a point: for an angle its tangent.
pub(super) fn at_point(letter: &Letter, point: u32) -> Fraction {
    let seed = 7 + i64::from(point) * 41;
    let spread = letter.name().bytes().fold(seed, |sum, byte| (sum * 31 + i64::from(byte)) % 97);
    match letter.range() {
        Range::Unit => Fraction::new(spread + 1, 101),
        Range::Real => Fraction::new(2 * spread - 97, 29),
        _ => Fraction::new(spread + 13, 29),
    }
}

/// Beyond 2 to this power, up or down, nothing is enclosed: towers of powers grow without end.
const LARGEST: usize = 600;

/// A point, and how finely values are enclosed there.
struct At<'a> {
    letters: &'a [Letter],
    point: u32,
    bits: usize,
    /// The angles in radians, letter by letter, each worked out when it is first met: it may be met hundreds of times.
    angles: Vec<OnceCell<Interval>>,
}

/// An interval that holds the value of the expression at a point, angles in radians; `None` where it has no value, or
/// the precision does not tell.
pub(super) fn enclose(expr: &Expr, letters: &[Letter], point: u32, bits: usize) -> Option<Interval> {
    At { letters, point, bits, angles: vec![OnceCell::new(); letters.len()] }.enclose(expr)
}

impl At<'_> {
    fn enclose(&self, expr: &Expr) -> Option<Interval> {
        self.parts(expr).filter(|found| !found.exceeds(LARGEST))
    }

    fn parts(&self, expr: &Expr) -> Option<Interval> {
        let bits = self.bits;
        let inner = |expr: &Expr| self.enclose(expr);
        match expr {
            Expr::Number(value) => Some(Interval::from_fraction(value, bits)),
            Expr::Decimal(text) => Some(Interval::from_fraction(&text.parse().ok()?, bits)),
            Expr::Name(name) => self.letter(&name.text),
            Expr::Pi => Some(Interval::pi(bits)),
            Expr::Degrees(degrees) => Some(inner(degrees)? * degree(bits)?),
            Expr::Negative(value) => Some(-inner(value)?),
            Expr::Sum(terms) => terms.iter().try_fold(Interval::integer(0, bits), |sum, term| Some(sum + inner(term)?)),
            Expr::Product(factors) => factors.iter().try_fold(Interval::integer(1, bits), |product, factor| {
                Some(product * inner(factor)?).filter(|product| !product.exceeds(LARGEST))
            }),
            Expr::Quotient(above, below) => inner(above)?.checked_div(&inner(below)?),
            Expr::Power(base, exponent) => power(&inner(base)?, exponent, bits),
            Expr::Call(function, argument) => match self.of_acute(*function, argument) {
                Some(found) => Some(found),
                None => call(*function, &inner(argument)?),
            },
            Expr::Vector(..) | Expr::Relation(..) => None,
        }
    }

    fn letter(&self, name: &str) -> Option<Interval> {
        let letter = super::exact::letter(self.letters, name)?;
        let value = || Interval::from_fraction(&at_point(letter, self.point), self.bits);
        if letter.range() != Range::Acute {
            return Some(value());
        }
        let place = self.letters.iter().position(|other| other == letter)?;
        Some(self.angles[place].get_or_init(|| value().atan()).clone())
    }

    /// The tangent, sine or cosine of an acute letter, which stands for its tangent: no angle need be worked out.
    fn of_acute(&self, function: Function, of: &Expr) -> Option<Interval> {
        let Expr::Name(name) = of else { return None };
        let letter = super::exact::letter(self.letters, &name.text).filter(|letter| letter.range() == Range::Acute)?;
        let tangent = at_point(letter, self.point);
        let above = match function {
            Function::Tan => return Some(Interval::from_fraction(&tangent, self.bits)),
            Function::Sin => Interval::from_fraction(&tangent, self.bits),
            Function::Cos => Interval::integer(1, self.bits),
            _ => return None,
        };
        let secant = Interval::from_fraction(&(&Fraction::ONE + &(&tangent * &tangent)), self.bits).sqrt()?;
        above.checked_div(&secant)
    }
}

/// One degree in radians.
fn degree(bits: usize) -> Option<Interval> {
    Interval::pi(bits).checked_div(&Interval::integer(180, bits))
}

fn power(base: &Interval, exponent: &Expr, bits: usize) -> Option<Interval> {
    let (count, below) = match exponent {
        Expr::Number(number) => number.as_small()?,
        Expr::Decimal(text) => text.parse::<Fraction>().ok()?.as_small()?,
        Expr::Negative(inner) => {
            return Interval::integer(1, bits).checked_div(&power(base, inner, bits)?);
        }
        Expr::Quotient(above, below) => match (&**above, &**below) {
            (Expr::Number(above), Expr::Number(below)) => (above * &below.reciprocal()?).as_small()?,
            _ => return None,
        },
        _ => return None,
    };
    let base = match below {
        1 => base.clone(),
        2 if base.sign().is_none_or(|sign| sign.is_ge()) => base.sqrt()?,
        3 => base.cube_root()?,
        _ => return None,
    };
    if !(0..=MOST_POWER).contains(&count) {
        return None;
    }
    (0..count).try_fold(Interval::integer(1, bits), |product, _| {
        Some(product * base.clone()).filter(|product| !product.exceeds(LARGEST))
    })
}

fn call(function: Function, argument: &Interval) -> Option<Interval> {
    match function {
        Function::Sqrt => argument.sqrt(),
        Function::Sin => Some(argument.sin()),
        Function::Cos => Some(argument.cos()),
        Function::Tan => argument.tan(),
        Function::Asin => argument.asin(),
        Function::Acos => argument.acos(),
        Function::Atan => Some(argument.atan()),
        Function::Abs => Some(argument.abs()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_sines_cosines_and_tangents_of_an_acute_letter_without_its_angle() {
        let letters = [Letter::new("theta", Range::Acute).unwrap()];
        let theta = Expr::name("theta");
        for function in [Function::Sin, Function::Cos, Function::Tan] {
            for point in 0..POINTS {
                let at = At { letters: &letters, point, bits: 96, angles: vec![OnceCell::new()] };
                let quick = at.of_acute(function, &theta).unwrap();
                let angle = at.enclose(&theta).unwrap();
                assert!(quick.overlaps(&call(function, &angle).unwrap()), "{function:?} at {point}");
            }
        }
    }

    #[test]
    fn a_power_that_is_no_number_is_not_enclosed() {
        let one = Expr::integer(1);
        let nought = Expr::Quotient(Box::new(one.clone()), Box::new(Expr::integer(0)));
        assert!(enclose(&Expr::Power(Box::new(one), Box::new(nought)), &[], 0, 96).is_none());
    }
}
