//! A formula worked out at the points at which letters have numbers.

use crate::expr::{Expr, Function};
use crate::mechanics::{Datum, Known};
use crate::number::{Fraction, Letter, Number, Range};

use super::sample::{POINTS, Sample};

/// The highest power that is worked out.
const MOST_POWER: f64 = 64.0;

/// What a name stands for.
type Names<'a, const N: usize> = &'a dyn Fn(&str) -> Option<Evaluated<N>>;

/// A formula worked out at the points; an angle in radians.
pub(super) struct Evaluated<const N: usize = POINTS> {
    pub(super) value: Sample<N>,
    pub(super) is_angle: bool,
}

impl<const N: usize> Evaluated<N> {
    pub(super) fn in_letters(expr: &Expr, letters: &[Letter]) -> Option<Evaluated<N>> {
        Evaluated::of(expr, &|name| Evaluated::of_letter(name, letters))
    }

    pub(super) fn of_letter(name: &str, letters: &[Letter]) -> Option<Evaluated<N>> {
        let letter = letters.iter().find(|letter| letter.name() == name)?;
        Some(Evaluated { value: Sample::of_letter(*letter), is_angle: letter.range() == Range::Acute })
    }

    pub(super) fn of(expr: &Expr, names: Names<N>) -> Option<Evaluated<N>> {
        let inner = |expr: &Expr| Evaluated::of(expr, names);
        let number = |value: f64| Some(Evaluated { value: Sample::constant(value), is_angle: false });
        match expr {
            Expr::Number(value) => number(value.to_f64()),
            Expr::Decimal(text) => number(text.parse::<Fraction>().ok()?.to_f64()),
            Expr::Name(name) => names(&name.text),
            Expr::Pi => Some(Evaluated { value: Sample::constant(std::f64::consts::PI), is_angle: true }),
            Expr::Degrees(degrees) => {
                let degrees = inner(degrees)?;
                let value = if degrees.is_angle { degrees.value } else { degrees.value.map(f64::to_radians) };
                Some(Evaluated { value, is_angle: true })
            }
            Expr::Negative(value) => inner(value).map(|found| Evaluated { value: -found.value, ..found }),
            Expr::Sum(terms) => all(terms, names, |sum, term| sum + term),
            Expr::Product(factors) => all(factors, names, |product, factor| product * factor),
            Expr::Quotient(above, below) => {
                let (above, below) = (inner(above)?, inner(below)?);
                let is_angle = above.is_angle && !below.is_angle;
                Some(Evaluated { value: above.value.over(&below.value)?, is_angle })
            }
            Expr::Power(base, exponent) => {
                let (base, exponent) = (inner(base)?.value, inner(exponent)?.value);
                let value = base.with(exponent, f64::powf);
                (exponent.0[0].abs() <= MOST_POWER).then_some(Evaluated { value, is_angle: false })
            }
            Expr::Call(function, argument) => {
                let argument = inner(argument)?.value;
                let is_angle = matches!(function, Function::Asin | Function::Acos | Function::Atan);
                Some(Evaluated { value: argument.map(by_name(*function)), is_angle })
            }
            Expr::Vector(..) | Expr::Relation(..) => None,
        }
    }
}

fn all<const N: usize>(
    parts: &[Expr],
    names: Names<N>,
    combine: impl Fn(Sample<N>, Sample<N>) -> Sample<N>,
) -> Option<Evaluated<N>> {
    let parts: Option<Vec<Evaluated<N>>> = parts.iter().map(|part| Evaluated::of(part, names)).collect();
    parts?
        .into_iter()
        .reduce(|one, two| Evaluated { value: combine(one.value, two.value), is_angle: one.is_angle || two.is_angle })
}

fn by_name(function: Function) -> fn(f64) -> f64 {
    match function {
        Function::Sqrt => f64::sqrt,
        Function::Sin => f64::sin,
        Function::Cos => f64::cos,
        Function::Tan => f64::tan,
        Function::Asin => f64::asin,
        Function::Acos => f64::acos,
        Function::Atan => f64::atan,
        Function::Abs => f64::abs,
    }
}

/// How far the sides of a condition are apart: of angles in degrees, beside which a plain number is one of degrees.
pub(super) fn condition_gap<const N: usize>(
    left: &Expr,
    right: &Expr,
    others: &[(Letter, Sample<N>)],
    own: (Letter, Sample<N>),
    known: &Known<Sample<N>>,
) -> Option<Sample<N>> {
    let names = |name: &str| {
        if let Some((letter, number)) = others.iter().chain([&own]).find(|(letter, _)| letter.name() == name) {
            let is_angle = letter.range() == Range::Acute;
            return Some(Evaluated { value: if is_angle { number.map(f64::atan) } else { *number }, is_angle });
        }
        match known.0.get(&name.parse().ok()?)? {
            Datum::Number(value) => Some(Evaluated { value: *value, is_angle: false }),
            Datum::Direction { y, x } => Some(Evaluated { value: y.with(*x, f64::atan2), is_angle: true }),
            Datum::Equation(_) => None,
        }
    };
    let (left, right) = (Evaluated::of(left, &names)?, Evaluated::of(right, &names)?);
    let degrees = |side: Evaluated<N>| if side.is_angle { side.value.map(f64::to_degrees) } else { side.value };
    Some(match left.is_angle || right.is_angle {
        true => degrees(left) - degrees(right),
        false => left.value - right.value,
    })
}
