//! Right values that a student's own working denies: they have not come from there.

mod at_the_end;
mod brackets;
mod by_contact;
mod by_equations;
mod by_laws;
mod by_line;
mod by_velocity;

pub(crate) use at_the_end::End;
pub(super) use brackets::bracketed;
pub(in crate::mark) use by_velocity::is_bare;

use crate::expr::{Expr, Function};
use crate::mark::working::examine::Value;
use crate::mark::working::laws::is_worked;
use crate::mark::working::numbers::any_within;

/// Values that are apart by less than this part of the greater may be so by rounding.
const ROUNDED: f64 = 0.05;

/// Are they plainly different at every point?
fn are_far(one: &[f64], other: &[f64]) -> bool {
    one.iter().zip(other).all(|(one, other)| (one - other).abs() > ROUNDED * one.abs().max(other.abs()))
}

/// Are vectors plainly different, whichever way each points?
fn are_apart_either_way([x, y]: [f64; 2], [other_x, other_y]: [f64; 2]) -> bool {
    let size = x.hypot(y).max(other_x.hypot(other_y));
    [1.0, -1.0].into_iter().all(|sign| (x - sign * other_x).hypot(y - sign * other_y) > ROUNDED * size)
}

/// Along i and along j; a number is along i alone.
fn middle(value: &Value) -> [f64; 2] {
    match value {
        Value::Number(number) => [number.middle(), 0.0],
        Value::Vector(x, y) => [x.middle(), y.middle()],
    }
}

/// Is anything left to be worked out? Not in `40/3`, `4√39/9`, `4m` or `24i + 18j`, but in `7/5.5`.
fn is_unfinished(expr: &Expr) -> bool {
    let is_one_by_itself = |factor: &Expr| matches!(factor, Expr::Call(Function::Sqrt, _) | Expr::Name(_));
    match expr {
        Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) => false,
        Expr::Negative(inner) | Expr::Degrees(inner) | Expr::Call(Function::Sqrt, inner) => is_unfinished(inner),
        Expr::Vector(x, y) => is_unfinished(x) || is_unfinished(y),
        Expr::Quotient(above, below) => {
            let is_more = |expr: &Expr| matches!(expr, Expr::Quotient(..) | Expr::Decimal(_));
            [above, below].into_iter().any(|part| is_unfinished(part) || any_within(part, &is_more))
        }
        // `4m` is as far as it goes, and `4 × 3` is not.
        Expr::Product(factors) => !factors.iter().any(is_one_by_itself) || factors.iter().any(is_unfinished),
        Expr::Sum(_) => is_worked(expr),
        _ => true,
    }
}
