//! What all printers agree on before they print: products flattened, ones dropped, signs in front.

use std::cmp::Ordering;

use crate::expr::Expr;
use crate::number::Fraction;

/// The tree without what is never printed: products inside products, a coefficient one in front,
/// and sums and products of a single member.
pub(super) fn tidied(expr: &Expr) -> Expr {
    match expr.map_children(&mut |child| tidied(child)) {
        Expr::Product(factors) => product(factors),
        Expr::Sum(mut terms) if terms.len() < 2 => terms.pop().unwrap_or_else(|| Expr::integer(0)),
        other => other,
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
        _ => Expr::Product(flat),
    }
}

/// The size behind the minus sign with which a tidied expression begins; `None` if it begins without.
///
/// Only one minus is taken off: `4 - (-3)` in working is printed as it was composed.
pub(super) fn behind_minus(expr: &Expr) -> Option<Expr> {
    match expr {
        Expr::Number(value) => (value.sign() == Ordering::Less).then(|| Expr::Number(value.abs())),
        Expr::Decimal(text) => text.strip_prefix('-').map(|size| Expr::Decimal(size.to_owned())),
        Expr::Negative(inner) => Some((**inner).clone()),
        Expr::Degrees(inner) => behind_minus(inner).map(Expr::degrees),
        Expr::Product(factors) => {
            let first = behind_minus(factors.first()?)?;
            Some(product(std::iter::once(first).chain(factors[1..].iter().cloned()).collect()))
        }
        Expr::Quotient(numerator, denominator) => {
            behind_minus(numerator).map(|size| Expr::Quotient(Box::new(size), denominator.clone()))
        }
        _ => None,
    }
}

/// Is it a number without sign that is written with digits alone?
pub(super) fn is_digits(expr: &Expr) -> bool {
    match expr {
        Expr::Number(value) => value.is_integer() && value.sign() != Ordering::Less,
        Expr::Decimal(text) => !text.starts_with('-'),
        _ => false,
    }
}

/// A whole exponent of at least two, as stands between a function's name and its argument.
pub(super) fn is_whole_power(exponent: &Expr) -> bool {
    matches!(exponent, Expr::Number(value) if value.is_integer() && *value > Fraction::ONE)
}
