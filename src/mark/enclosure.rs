//! Expressions enclosed at fixed points inside the physical ranges of their letters.
//!
//! Intervals that keep apart refute an equality, quickly and for any expression however long; that they meet proves
//! nothing, and is never taken for proof. The points are fixed so that the same answer earns the same marks for ever.

use std::cell::OnceCell;
use std::ops::{Add, Mul, Neg};

use crate::expr::{Expr, Function};
use crate::number::{FloatInterval, Fraction, Interval, Letter, Range};

/// How many points are looked at where letters remain.
pub(super) const POINTS: u32 = 6;

/// The highest power that is enclosed.
const MOST_POWER: i64 = 64;

/// The letter of that name; a capital is condoned where the question has only the small letter, or the reverse.
pub(super) fn letter<'a>(letters: &'a [Letter], name: &str) -> Option<&'a Letter> {
    letters.iter().find(|letter| letter.name() == name).or_else(|| {
        let single = name.len() == 1;
        letters.iter().find(|letter| single && letter.name().eq_ignore_ascii_case(name))
    })
}

/// Beyond 2 to this power, up or down, nothing is enclosed: towers of powers grow without end.
const LARGEST: usize = 600;

/// What a value can be enclosed in, angles in radians.
trait Enclosure: Clone + Add<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// How finely.
    type Bits: Copy;
    fn of(value: &Fraction, bits: Self::Bits) -> Self;
    fn pi(bits: Self::Bits) -> Self;
    /// The quotient; `None` if the divisor may be nought.
    fn over(&self, divisor: &Self) -> Option<Self>;
    /// The outcome of a function; `None` where it has none, or it is not certain that it has one.
    fn through(&self, function: Function) -> Option<Self>;
    fn cube_root(&self) -> Option<Self>;
    /// Is all of it below nought?
    fn is_negative(&self) -> bool;
    /// Is it so large that nothing more is said of it?
    fn is_too_large(&self) -> bool;
}

impl Enclosure for Interval {
    type Bits = usize;
    fn of(value: &Fraction, bits: usize) -> Interval {
        Interval::from_fraction(value, bits)
    }
    fn pi(bits: usize) -> Interval {
        Interval::pi(bits)
    }
    fn over(&self, divisor: &Interval) -> Option<Interval> {
        self.checked_div(divisor)
    }
    fn through(&self, function: Function) -> Option<Interval> {
        match function {
            Function::Sqrt => self.sqrt(),
            Function::Sin => Some(self.sin()),
            Function::Cos => Some(self.cos()),
            Function::Tan => self.tan(),
            Function::Asin => self.asin(),
            Function::Acos => self.acos(),
            Function::Atan => Some(self.atan()),
            Function::Abs => Some(self.abs()),
        }
    }
    fn cube_root(&self) -> Option<Interval> {
        Interval::cube_root(self)
    }
    fn is_negative(&self) -> bool {
        self.sign().is_some_and(|sign| sign.is_lt())
    }
    fn is_too_large(&self) -> bool {
        self.exceeds(LARGEST)
    }
}

impl Enclosure for FloatInterval {
    type Bits = ();
    fn of(value: &Fraction, (): ()) -> FloatInterval {
        FloatInterval::from_fraction(value)
    }
    fn pi((): ()) -> FloatInterval {
        FloatInterval::pi()
    }
    fn over(&self, divisor: &FloatInterval) -> Option<FloatInterval> {
        self.checked_div(*divisor)
    }
    fn through(&self, function: Function) -> Option<FloatInterval> {
        match function {
            Function::Sqrt => self.sqrt(),
            Function::Sin => Some(self.sin()),
            Function::Cos => Some(self.cos()),
            Function::Tan => self.sin().checked_div(self.cos()),
            Function::Asin => self.asin(),
            Function::Acos => self.acos(),
            Function::Atan => Some(self.atan()),
            Function::Abs => Some(self.abs()),
        }
    }
    fn cube_root(&self) -> Option<FloatInterval> {
        FloatInterval::cube_root(*self)
    }
    fn is_negative(&self) -> bool {
        self.sign().is_some_and(|sign| sign.is_lt())
    }
    fn is_too_large(&self) -> bool {
        !self.is_finite()
    }
}

/// A point, and how finely values are enclosed there.
struct At<'a, N: Enclosure> {
    letters: &'a [Letter],
    point: u32,
    bits: N::Bits,
    /// The angles in radians, letter by letter, each worked out when it is first met: it may be met hundreds of times.
    angles: Vec<OnceCell<N>>,
}

/// An interval that holds the value of the expression at a point, angles in radians; `None` where it has no value, or
/// the precision does not tell.
pub(super) fn enclose(expr: &Expr, letters: &[Letter], point: u32, bits: usize) -> Option<Interval> {
    at(letters, point, bits).enclose(expr)
}

/// The same between two doubles, which is quick, and tells most values apart.
pub(super) fn enclose_roughly(expr: &Expr, letters: &[Letter], point: u32) -> Option<FloatInterval> {
    at(letters, point, ()).enclose(expr)
}

/// About how much it is, at the first point. What this tells is for a person to see, and never that two are equal.
pub(super) fn about(expr: &Expr, letters: &[Letter]) -> Option<f64> {
    enclose_roughly(expr, letters, 0).map(|within| (within.lower + within.upper) / 2.0)
}

fn at<N: Enclosure>(letters: &[Letter], point: u32, bits: N::Bits) -> At<'_, N> {
    At { letters, point, bits, angles: vec![OnceCell::new(); letters.len()] }
}

impl<N: Enclosure> At<'_, N> {
    fn enclose(&self, expr: &Expr) -> Option<N> {
        self.parts(expr).filter(|found| !found.is_too_large())
    }

    fn of(&self, value: &Fraction) -> N {
        N::of(value, self.bits)
    }

    fn parts(&self, expr: &Expr) -> Option<N> {
        let inner = |expr: &Expr| self.enclose(expr);
        match expr {
            Expr::Number(value) => Some(self.of(value)),
            Expr::Decimal(text) => Some(self.of(&text.parse().ok()?)),
            Expr::Name(name) => self.letter(&name.text),
            Expr::Pi => Some(N::pi(self.bits)),
            Expr::Degrees(degrees) => (inner(degrees)? * N::pi(self.bits)).over(&self.of(&Fraction::from(180))),
            Expr::Negative(value) => Some(-inner(value)?),
            Expr::Sum(terms) => terms.iter().try_fold(self.of(&Fraction::ZERO), |sum, term| Some(sum + inner(term)?)),
            Expr::Product(factors) => factors.iter().try_fold(self.of(&Fraction::ONE), |product, factor| {
                Some(product * inner(factor)?).filter(|product| !product.is_too_large())
            }),
            Expr::Quotient(above, below) => inner(above)?.over(&inner(below)?),
            Expr::Power(base, exponent) => self.power(&inner(base)?, exponent),
            Expr::Call(function, argument) => match self.of_acute(*function, argument) {
                Some(found) => Some(found),
                None => inner(argument)?.through(*function),
            },
            Expr::Vector(..) | Expr::Relation(..) => None,
        }
    }

    fn letter(&self, name: &str) -> Option<N> {
        let letter = letter(self.letters, name)?;
        let value = || self.of(&letter.at(self.point));
        if letter.range() != Range::Acute {
            return Some(value());
        }
        let place = self.letters.iter().position(|other| other == letter)?;
        if self.angles[place].get().is_none() {
            self.angles[place].set(value().through(Function::Atan)?).ok();
        }
        self.angles[place].get().cloned()
    }

    /// The tangent, sine or cosine of an acute letter, which stands for its tangent: no angle need be worked out.
    fn of_acute(&self, function: Function, of: &Expr) -> Option<N> {
        let Expr::Name(name) = of else { return None };
        let letter = letter(self.letters, &name.text).filter(|letter| letter.range() == Range::Acute)?;
        let tangent = letter.at(self.point);
        let above = match function {
            Function::Tan => return Some(self.of(&tangent)),
            Function::Sin => self.of(&tangent),
            Function::Cos => self.of(&Fraction::ONE),
            _ => return None,
        };
        let secant = self.of(&(&Fraction::ONE + &(&tangent * &tangent))).through(Function::Sqrt)?;
        above.over(&secant)
    }

    fn power(&self, base: &N, exponent: &Expr) -> Option<N> {
        let one = || self.of(&Fraction::ONE);
        let (count, below) = match exponent {
            Expr::Number(number) => number.as_small()?,
            Expr::Decimal(text) => text.parse::<Fraction>().ok()?.as_small()?,
            Expr::Negative(inner) => return one().over(&self.power(base, inner)?),
            Expr::Quotient(above, below) => match (&**above, &**below) {
                (Expr::Number(above), Expr::Number(below)) => (above * &below.reciprocal()?).as_small()?,
                _ => return None,
            },
            _ => return None,
        };
        let base = match below {
            1 => base.clone(),
            2 if !base.is_negative() => base.through(Function::Sqrt)?,
            3 => base.cube_root()?,
            _ => return None,
        };
        if !(0..=MOST_POWER).contains(&count) {
            return None;
        }
        (0..count).try_fold(one(), |product, _| Some(product * base.clone()).filter(|product| !product.is_too_large()))
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
                let at: At<Interval> = at(&letters, point, 96);
                let quick = at.of_acute(function, &theta).unwrap();
                let angle = at.enclose(&theta).unwrap();
                assert!(quick.overlaps(&angle.through(function).unwrap()), "{function:?} at {point}");
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
