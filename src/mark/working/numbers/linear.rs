//! A student's formula as a sum of unknowns with numbers before them: `4v + 2w - 8√3`.

use super::points::Points;
use super::spread::Spread;
use crate::expr::{Expr, Function};

/// A number, or a sum of unknowns with numbers before them, and a number.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::mark::working) struct Linear {
    pub(in crate::mark::working) constant: Spread,
    /// Unknowns by name, each once.
    pub(in crate::mark::working) unknowns: Vec<(String, Spread)>,
    /// The largest number that went into it, by which rounding errors of floats are measured.
    pub(in crate::mark::working) size: f64,
}

/// What a formula comes to.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::mark::working) enum Sum {
    Number(Linear),
    /// Components along i and j.
    Vector(Linear, Linear),
}

/// What names stand for, and which of the decimals are as they were given.
pub(in crate::mark::working) struct Context<'a> {
    pub(in crate::mark::working) points: &'a Points,
    pub(in crate::mark::working) point: usize,
    /// Names of what is given as a number: `e`, `m_A`.
    pub(in crate::mark::working) given: &'a [(String, Vec<f64>)],
    /// Decimals that stand in the question: they are exact.
    pub(in crate::mark::working) exact: &'a [String],
    /// With how many significant figures a decimal counts as rounded; with fewer it is taken at its word.
    pub(in crate::mark::working) rounded_from: usize,
}

impl Linear {
    pub(in crate::mark::working) fn number(value: Spread) -> Linear {
        Linear { constant: value, unknowns: Vec::new(), size: value.low.abs().max(value.high.abs()) }
    }

    pub(in crate::mark::working) fn unknown(name: &str) -> Linear {
        let one = Spread::exactly(1.0);
        Linear { constant: Spread::exactly(0.0), unknowns: vec![(name.to_owned(), one)], size: 1.0 }
    }

    /// The number before an unknown.
    pub(in crate::mark::working) fn before(&self, name: &str) -> Spread {
        self.unknowns.iter().find(|(known, _)| known == name).map_or(Spread::exactly(0.0), |(_, number)| *number)
    }

    pub(in crate::mark::working) fn is_number(&self) -> bool {
        self.unknowns.is_empty()
    }

    /// As an equation that sets it equal to nought: `p x + q y = r`.
    pub(in crate::mark::working) fn in_numbers(&self, [x, y]: [&str; 2]) -> [f64; 3] {
        [self.before(x).middle(), self.before(y).middle(), -self.constant.middle()]
    }

    pub(in crate::mark::working) fn plus(mut self, other: &Linear) -> Linear {
        self.constant = self.constant + other.constant;
        for (name, number) in &other.unknowns {
            match self.unknowns.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => *sum = *sum + *number,
                None => self.unknowns.push((name.clone(), *number)),
            }
        }
        self.size = self.size.max(other.size);
        let size = self.size;
        // What cancels is gone: `v - v`.
        self.unknowns.retain(|(_, number)| !(number.may_be_nought(size) && number.high - number.low < 1e-9 * size));
        self
    }

    pub(in crate::mark::working) fn times(mut self, factor: Spread) -> Linear {
        self.constant = self.constant * factor;
        for (_, number) in &mut self.unknowns {
            *number = *number * factor;
        }
        self.size *= factor.low.abs().max(factor.high.abs());
        self
    }
}

/// The one solution of `p x + q y = r` and another equation like it.
pub(in crate::mark::working) fn common_root([p, q, r]: [f64; 3], [s, t, u]: [f64; 3]) -> Option<[f64; 2]> {
    let determinant = p * t - q * s;
    let is_none = determinant.abs() <= 1e-9 * (p * t).abs().max((q * s).abs());
    let root = [(r * t - u * q) / determinant, (p * u - s * r) / determinant];
    root.iter().all(|number| number.is_finite() && !is_none).then_some(root)
}

/// What the formula comes to at a point; `None` if it is no sum of this kind.
pub(in crate::mark::working) fn sum(expr: &Expr, context: &Context) -> Option<Sum> {
    let number = |value: Spread| Some(Sum::Number(Linear::number(value)));
    match expr {
        Expr::Number(value) => number(Spread::exactly(value.to_f64())),
        Expr::Decimal(text) => number(decimal(text, context)?),
        Expr::Name(name) => {
            let given = context.given.iter().find(|(known, _)| *known == name.text);
            let value = context.points.letter(&name.text, context.point).or(given.map(|(_, at)| at[context.point]));
            let unit = |x: f64, y: f64| {
                let component = |size| Linear::number(Spread::exactly(size));
                Some(Sum::Vector(component(x), component(y)))
            };
            match (value, name.text.as_str()) {
                (Some(value), _) => number(Spread::exactly(value)),
                (None, "i") => unit(1.0, 0.0),
                (None, "j") => unit(0.0, 1.0),
                (None, _) => Some(Sum::Number(Linear::unknown(&name.text))),
            }
        }
        Expr::Pi => number(Spread::exactly(std::f64::consts::PI)),
        Expr::Degrees(inner) => number(constant(inner, context)?.through(f64::to_radians)?),
        Expr::Negative(inner) => Some(scaled(sum(inner, context)?, Spread::exactly(-1.0))),
        Expr::Sum(terms) => {
            let mut total: Option<Sum> = None;
            for term in terms {
                let next = sum(term, context)?;
                total = Some(match total {
                    None => next,
                    Some(total) => added(total, next)?,
                });
            }
            total
        }
        Expr::Product(factors) => {
            let mut product = Sum::Number(Linear::number(Spread::exactly(1.0)));
            for factor in factors {
                product = multiplied(product, sum(factor, context)?)?;
            }
            Some(product)
        }
        Expr::Quotient(above, below) => {
            let below = constant(below, context)?;
            Some(scaled(sum(above, context)?, Spread::exactly(1.0).over(below)?))
        }
        Expr::Power(base, exponent) => number(power(constant(base, context)?, exponent)?),
        Expr::Call(function, argument) => number(call(*function, constant(argument, context)?)?),
        Expr::Vector(x, y) => {
            let component = |expr: &Expr| match sum(expr, context)? {
                Sum::Number(linear) => Some(linear),
                Sum::Vector(..) => None,
            };
            Some(Sum::Vector(component(x)?, component(y)?))
        }
        Expr::Relation(..) => None,
    }
}

/// The numbers without an unknown that are added up in a formula, brackets multiplied out; `None` if it is no sum of this
/// kind or has a vector in it.
pub(in crate::mark::working) fn constants(expr: &Expr, context: &Context) -> Option<Vec<Spread>> {
    let pieces = pieces(expr, context)?.into_iter();
    Some(
        pieces
            .filter(|piece| piece.is_number() && !piece.constant.may_be_nought(0.0))
            .map(|piece| piece.constant)
            .collect(),
    )
}

/// What is added up in a formula, brackets multiplied out.
fn pieces(expr: &Expr, context: &Context) -> Option<Vec<Linear>> {
    let times = |pieces: Vec<Linear>, factor: Spread| pieces.into_iter().map(|piece| piece.times(factor)).collect();
    Some(match expr {
        Expr::Sum(terms) => {
            let each: Option<Vec<Vec<Linear>>> = terms.iter().map(|term| pieces(term, context)).collect();
            each?.concat()
        }
        Expr::Negative(inner) => times(pieces(inner, context)?, Spread::exactly(-1.0)),
        Expr::Quotient(above, below) => {
            times(pieces(above, context)?, Spread::exactly(1.0).over(constant(below, context)?)?)
        }
        Expr::Product(factors) => {
            let mut product = vec![Linear::number(Spread::exactly(1.0))];
            for factor in factors {
                let factor = pieces(factor, context)?;
                let both = product.iter().flat_map(|one| factor.iter().map(move |other| (one, other)));
                let multiplied = |(one, other): (&Linear, &Linear)| match (one.is_number(), other.is_number()) {
                    (true, _) => Some(other.clone().times(one.constant)),
                    (_, true) => Some(one.clone().times(other.constant)),
                    _ => None,
                };
                product = both.take(MOST_PIECES).map(multiplied).collect::<Option<_>>()?;
            }
            (product.len() < MOST_PIECES).then_some(product)?
        }
        other => match sum(other, context)? {
            Sum::Number(linear) => vec![linear],
            Sum::Vector(..) => return None,
        },
    })
}

/// Nobody multiplies out so many terms.
const MOST_PIECES: usize = 16;

/// What a formula without unknowns comes to.
pub(in crate::mark::working) fn constant(expr: &Expr, context: &Context) -> Option<Spread> {
    match sum(expr, context)? {
        Sum::Number(linear) if linear.is_number() => Some(linear.constant),
        _ => None,
    }
}

/// Left minus right of an equation; an unknown below a line is multiplied out.
pub(in crate::mark::working) fn difference(left: &Expr, right: &Expr, context: &Context) -> Option<Sum> {
    if let Some((left, right)) = sum(left, context).zip(sum(right, context)) {
        return added(left, scaled(right, Spread::exactly(-1.0)));
    }
    let parts = |expr: &Expr| match expr {
        Expr::Quotient(above, below) => Some((sum(above, context)?, sum(below, context)?)),
        other => Some((sum(other, context)?, Sum::Number(Linear::number(Spread::exactly(1.0))))),
    };
    let ((above, below), (other_above, other_below)) = parts(left).zip(parts(right))?;
    let right = multiplied(other_above, below)?;
    added(multiplied(above, other_below)?, scaled(right, Spread::exactly(-1.0)))
}

fn scaled(sum: Sum, factor: Spread) -> Sum {
    match sum {
        Sum::Number(linear) => Sum::Number(linear.times(factor)),
        Sum::Vector(x, y) => Sum::Vector(x.times(factor), y.times(factor)),
    }
}

fn added(one: Sum, other: Sum) -> Option<Sum> {
    match (one, other) {
        (Sum::Number(one), Sum::Number(other)) => Some(Sum::Number(one.plus(&other))),
        (Sum::Vector(x, y), Sum::Vector(u, v)) => Some(Sum::Vector(x.plus(&u), y.plus(&v))),
        // A letter beside a vector is an unknown vector.
        (Sum::Vector(x, y), Sum::Number(vector)) | (Sum::Number(vector), Sum::Vector(x, y)) => {
            let is_vector = vector.constant == Spread::exactly(0.0);
            is_vector.then(|| Sum::Vector(x.plus(&vector), y.plus(&vector)))
        }
    }
}

fn multiplied(one: Sum, other: Sum) -> Option<Sum> {
    match (one, other) {
        (Sum::Number(one), other) if one.is_number() => Some(scaled(other, one.constant)),
        (one, Sum::Number(other)) if other.is_number() => Some(scaled(one, other.constant)),
        _ => None,
    }
}

/// A decimal with the width of its last figure, unless it is one of the question's own.
fn decimal(text: &str, context: &Context) -> Option<Spread> {
    let value = text.parse::<f64>().ok()?;
    let figures = figures(text);
    if figures < context.rounded_from || context.exact.iter().any(|given| given == text) {
        return Some(Spread::exactly(value));
    }
    let places = text.split_once('.').map_or(0, |(_, after)| after.len());
    let half = 0.5 * 10_f64.powi(-(places as i32));
    Spread::of(value - half, value + half)
}

/// How many significant figures a decimal shows.
pub(in crate::mark::working) fn figures(text: &str) -> usize {
    let digits = text.bytes().filter(u8::is_ascii_digit);
    digits.skip_while(|digit| *digit == b'0').count()
}

fn power(base: Spread, exponent: &Expr) -> Option<Spread> {
    match exponent {
        Expr::Number(number) => match number.as_small()? {
            (count @ 0..=12, 1) => base.to_the(u32::try_from(count).ok()?),
            (1, 2) => call(Function::Sqrt, base),
            _ => None,
        },
        Expr::Negative(inner) => Spread::exactly(1.0).over(power(base, inner)?),
        Expr::Quotient(above, below) => match (&**above, &**below) {
            (Expr::Number(above), Expr::Number(below)) if !below.is_zero() => power(base, &Expr::Number(above / below)),
            _ => None,
        },
        _ => None,
    }
}

fn call(function: Function, argument: Spread) -> Option<Spread> {
    let small = argument.high - argument.low < 0.2;
    match function {
        Function::Sqrt if argument.low >= 0.0 => argument.through(f64::sqrt),
        Function::Abs => Some(argument.absolute()),
        Function::Atan => argument.through(f64::atan),
        Function::Asin if argument.absolute().high <= 1.0 => argument.through(f64::asin),
        Function::Acos if argument.absolute().high <= 1.0 => argument.through(f64::acos),
        Function::Sin if small => argument.through(f64::sin),
        Function::Cos if small => argument.through(f64::cos),
        Function::Tan if small && argument.middle().cos().abs() > 0.1 => argument.through(f64::tan),
        Function::Tan if argument.low == argument.high => argument.through(f64::tan),
        _ => None,
    }
}
