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
    if is_tidy(expr, vectors) { Cow::Borrowed(expr) } else { Cow::Owned(tidy(expr, vectors)) }
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

fn tidy(expr: &Expr, vectors: Vectors) -> Expr {
    match expr.map_children(&mut |child| tidy(child, vectors)) {
        Expr::Number(value) if value.sign() == Ordering::Less => negative(Expr::Number(-value)),
        Expr::Decimal(text) if text.starts_with('-') => negative(Expr::Decimal(text[1..].to_owned())),
        Expr::Degrees(inner) => fronted(*inner, Expr::degrees),
        Expr::Quotient(numerator, denominator) => {
            fronted(*numerator, |numerator| Expr::Quotient(Box::new(numerator), denominator))
        }
        Expr::Product(factors) => product(factors),
        Expr::Sum(mut terms) if terms.len() < 2 => terms.pop().unwrap_or_else(|| Expr::integer(0)),
        Expr::Vector(x, y) if vectors == Vectors::Sums => along_components(*x, *y),
        other => other,
    }
}

fn negative(size: Expr) -> Expr {
    Expr::Negative(Box::new(size))
}

/// What is made of a part that stands in front, its minus sign before the whole.
fn fronted(first: Expr, whole: impl FnOnce(Expr) -> Expr) -> Expr {
    match first {
        Expr::Negative(size) => negative(fronted(*size, whole)),
        first => whole(first),
    }
}

/// The product of tidied factors.
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
        _ if matches!(flat[0], Expr::Negative(_)) => fronted(flat.remove(0), |size| {
            flat.insert(0, size);
            product(flat)
        }),
        _ => Expr::Product(flat),
    }
}

/// The vector of tidied components as a sum along i and j, without the one that is nought.
fn along_components(x: Expr, y: Expr) -> Expr {
    let along = |component: Expr, unit: &str| product(vec![component, Expr::name(unit)]);
    match (x.is_zero(), y.is_zero()) {
        (true, true) => Expr::Vector(Box::new(x), Box::new(y)),
        (false, true) => along(x, "i"),
        (true, false) => along(y, "j"),
        (false, false) => Expr::Sum(vec![along(x, "i"), along(y, "j")]),
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
