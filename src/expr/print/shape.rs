//! What all printers agree on before they print: products flattened, ones dropped, signs in front.

use std::borrow::Cow;
use std::cmp::Ordering;

use crate::expr::Expr;
use crate::number::Fraction;

/// How vectors are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Vectors {
    /// By their two components.
    Pairs,
    /// As sums along i and j; only the zero vector is left.
    Sums,
}

/// The tree without what is never printed: products inside products, a coefficient one in front, and sums and products
/// of a single member. What begins with a minus sign is an [`Expr::Negative`].
///
/// Only one minus is taken off: `4 - (-3)` in working is printed as it was composed. Most trees are tidy and are not
/// copied.
pub(super) fn tidied(expr: &Expr, vectors: Vectors) -> Cow<'_, Expr> {
    if is_tidy(expr, vectors) {
        return Cow::Borrowed(expr);
    }
    let flat = flattened(expr);
    Cow::Owned(match vectors {
        Vectors::Pairs => signed(&flat),
        Vectors::Sums => signed(&along_components(&flat)),
    })
}

fn is_tidy(expr: &Expr, vectors: Vectors) -> bool {
    let is_negative = |part: &Expr| matches!(part, Expr::Negative(_));
    let by_itself = match expr {
        Expr::Number(value) => value.sign() != Ordering::Less,
        Expr::Decimal(text) => !text.starts_with('-'),
        Expr::Degrees(inner) | Expr::Quotient(inner, _) => !is_negative(inner),
        Expr::Product(factors) => {
            let nested = factors.iter().any(|factor| matches!(factor, Expr::Product(_)));
            factors.len() > 1 && !factors[0].is_one() && !is_negative(&factors[0]) && !nested
        }
        Expr::Sum(terms) => terms.len() > 1,
        Expr::Vector(x, y) => vectors == Vectors::Pairs || x.is_zero() && y.is_zero(),
        _ => true,
    };
    by_itself && expr.all_children(&mut |child| is_tidy(child, vectors))
}

fn flattened(expr: &Expr) -> Expr {
    match expr.map_children(&mut flattened) {
        Expr::Product(factors) => product(factors),
        Expr::Sum(mut terms) if terms.len() < 2 => terms.pop().unwrap_or_else(|| Expr::integer(0)),
        other => other,
    }
}

/// The product of flattened factors.
fn product(factors: Vec<Expr>) -> Expr {
    let mut flat = Vec::with_capacity(factors.len());
    for factor in factors {
        match factor {
            Expr::Product(inner) => flat.extend(inner),
            other => flat.push(other),
        }
    }
    let ones = flat.iter().take_while(|factor| factor.is_one()).count();
    flat.drain(..ones.min(flat.len().saturating_sub(1)));
    match flat.len() {
        0 => Expr::integer(1),
        1 => flat.remove(0),
        _ => Expr::Product(flat),
    }
}

/// The tree with vectors as sums along i and j, without a component that is nought.
fn along_components(expr: &Expr) -> Expr {
    let along = |component: Box<Expr>, unit: &str| product(vec![*component, Expr::name(unit)]);
    match expr.map_children(&mut along_components) {
        Expr::Vector(x, y) => match (x.is_zero(), y.is_zero()) {
            (true, true) => Expr::Vector(x, y),
            (false, true) => along(x, "i"),
            (true, false) => along(y, "j"),
            (false, false) => Expr::Sum(vec![along(x, "i"), along(y, "j")]),
        },
        other => other,
    }
}

/// The tree with signs in front: -3 as the negative of 3, and so what begins with it.
fn signed(expr: &Expr) -> Expr {
    match expr.map_children(&mut signed) {
        Expr::Number(value) if value.sign() == Ordering::Less => negative(Expr::Number(-value)),
        Expr::Decimal(text) if text.starts_with('-') => negative(Expr::Decimal(text[1..].to_owned())),
        Expr::Degrees(number) => fronted(*number, Expr::degrees),
        Expr::Quotient(numerator, denominator) => {
            fronted(*numerator, |numerator| Expr::Quotient(Box::new(numerator), denominator))
        }
        Expr::Product(factors) => signed_product(factors),
        other => other,
    }
}

/// The product of signed factors; behind a one that is dropped another sign may come to the front.
fn signed_product(factors: Vec<Expr>) -> Expr {
    match product(factors) {
        Expr::Product(mut factors) if matches!(factors[0], Expr::Negative(_)) => {
            fronted(factors.remove(0), |first| signed_product(std::iter::once(first).chain(factors).collect()))
        }
        other => other,
    }
}

fn negative(size: Expr) -> Expr {
    Expr::Negative(Box::new(size))
}

/// What is made of a part that stands in front, its minus sign before the whole.
fn fronted(part: Expr, whole: impl FnOnce(Expr) -> Expr) -> Expr {
    match part {
        Expr::Negative(size) => negative(fronted(*size, whole)),
        part => whole(part),
    }
}

/// Is a tidied expression a number without sign that is written with digits alone?
pub(super) fn is_digits(expr: &Expr) -> bool {
    match expr {
        Expr::Number(value) => value.is_integer(),
        Expr::Decimal(_) => true,
        _ => false,
    }
}

/// A whole exponent of at least two, as stands between a function's name and its argument.
pub(super) fn is_whole_power(exponent: &Expr) -> bool {
    matches!(exponent, Expr::Number(value) if value.is_integer() && *value > Fraction::ONE)
}
