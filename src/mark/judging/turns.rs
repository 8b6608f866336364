//! The angles of which an angle is put together, before any of them is worked out.

use crate::expr::{Expr, Function};

/// Is it put together of inverse sines, cosines or tangents, as `2 arctan x` is?
pub(super) fn is_angle(expr: &Expr) -> bool {
    match expr {
        Expr::Call(function, _) => matches!(function, Function::Asin | Function::Acos | Function::Atan),
        Expr::Sum(parts) | Expr::Product(parts) => parts.iter().any(is_angle),
        Expr::Negative(inner) | Expr::Quotient(inner, _) => is_angle(inner),
        _ => false,
    }
}

/// Is it a part of a letter, such as α/2 or ½ α?
pub(super) fn is_halved(expr: &Expr) -> bool {
    match expr {
        Expr::Quotient(above, below) => matches!((&**above, &**below), (Expr::Name(_), Expr::Number(_))),
        Expr::Product(factors) => !expr.names().is_empty() && !is_angle(expr) && factors.iter().any(is_fraction),
        _ => false,
    }
}

fn is_fraction(expr: &Expr) -> bool {
    match expr {
        Expr::Number(number) => !number.is_integer(),
        Expr::Quotient(..) => expr.names().is_empty(),
        _ => false,
    }
}

/// The angles of which an angle is put together, and how often each is taken.
#[derive(Default)]
pub(super) struct Turns<'a> {
    pub(super) angles: Vec<(&'a Expr, u64)>,
}

impl<'a> Turns<'a> {
    pub(super) fn count(&mut self, expr: &'a Expr, times: u64) {
        match expr {
            Expr::Sum(terms) => terms.iter().for_each(|term| self.count(term, times)),
            Expr::Negative(inner) => self.count(inner, times),
            Expr::Quotient(above, _) if !is_halved(expr) => self.count(above, times),
            Expr::Product(factors) if !is_halved(expr) && (!expr.names().is_empty() || is_angle(expr)) => {
                let number = |factor: &Expr| match factor {
                    Expr::Number(number) => number.as_small().map_or(1, |(count, _)| count.unsigned_abs()),
                    _ => 1,
                };
                let times = factors.iter().map(number).fold(times, u64::saturating_mul).min(64);
                let is_part = |factor: &&Expr| !factor.names().is_empty() || is_angle(factor);
                factors.iter().filter(is_part).for_each(|factor| self.count(factor, times));
            }
            _ => self.angles.push((expr, times)),
        }
    }
}
