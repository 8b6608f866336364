//! What all printers agree on before they print: products flattened, ones dropped, signs in front.

use std::borrow::Cow;
use std::cmp::Ordering;

use crate::expr::Expr;
use crate::number::Fraction;

/// The tree without what is never printed: products inside products, a coefficient one in front,
/// and sums and products of a single member.
///
/// Most trees have nothing of that and are not copied.
pub(super) fn tidied(expr: &Expr) -> Cow<'_, Expr> {
    if is_tidy(expr) { Cow::Borrowed(expr) } else { Cow::Owned(tidy(expr)) }
}

fn is_tidy(expr: &Expr) -> bool {
    let by_itself = match expr {
        Expr::Product(factors) => {
            let nested = factors.iter().any(|factor| matches!(factor, Expr::Product(_)));
            factors.len() > 1 && !factors[0].is_one() && !nested
        }
        Expr::Sum(terms) => terms.len() > 1,
        _ => true,
    };
    by_itself && expr.all_children(&mut |child| is_tidy(child))
}

fn tidy(expr: &Expr) -> Expr {
    match expr.map_children(&mut |child| tidy(child)) {
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

/// Does a tidied expression begin with a minus sign?
pub(super) fn begins_with_minus(expr: &Expr) -> bool {
    match expr {
        Expr::Number(value) => value.sign() == Ordering::Less,
        Expr::Decimal(text) => text.starts_with('-'),
        Expr::Negative(_) => true,
        Expr::Degrees(inner) | Expr::Quotient(inner, _) => begins_with_minus(inner),
        Expr::Product(factors) => factors.first().is_some_and(begins_with_minus),
        _ => false,
    }
}

/// The size behind the minus sign with which a tidied expression begins; `None` if it begins without.
///
/// Only one minus is taken off: `4 - (-3)` in working is printed as it was composed.
pub(super) fn behind_minus(expr: &Expr) -> Option<Cow<'_, Expr>> {
    if !begins_with_minus(expr) {
        return None;
    }
    Some(match expr {
        Expr::Number(value) => Cow::Owned(Expr::Number(value.abs())),
        Expr::Decimal(text) => Cow::Owned(Expr::Decimal(text.strip_prefix('-')?.to_owned())),
        Expr::Negative(inner) => Cow::Borrowed(&**inner),
        Expr::Degrees(inner) => Cow::Owned(Expr::degrees(behind_minus(inner)?.into_owned())),
        Expr::Product(factors) => {
            let first = behind_minus(factors.first()?)?.into_owned();
            Cow::Owned(product(std::iter::once(first).chain(factors[1..].iter().cloned()).collect()))
        }
        Expr::Quotient(numerator, denominator) => {
            let size = behind_minus(numerator)?.into_owned();
            Cow::Owned(Expr::Quotient(Box::new(size), denominator.clone()))
        }
        _ => return None,
    })
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
