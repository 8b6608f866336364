//! Whether the coefficient of restitution stands in what a student wrote, so that it was not forgotten.

use crate::expr::Expr;
use crate::mark::working::examine::{Studied, value};
use crate::mark::working::numbers::{any_within, sizes};
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::numbers;
use crate::mechanics::Quantity;

/// Does e stand in a line? The half of an energy in which a velocity is still to be found is none.
pub(in crate::mark::working) fn line_shows_e(studied: &Studied, prepared: &Prepared) -> bool {
    let is_open_square = |inner: &Expr| matches!(inner, Expr::Power(base, _) if matches!(**base, Expr::Name(_)));
    let members = || studied.reading.iter().flat_map(|reading| &reading.members);
    let equations = studied.reading.iter().flat_map(|reading| &reading.equations);
    let is_energy = equations.flat_map(|(left, right)| [left, right]).any(|side| any_within(side, &is_open_square));
    !is_energy && members().any(|member| shows_e(&member.expr, prepared))
}

/// Does e stand in a formula: by its letter, as a factor, or squared in `1 - e²`? In an energy a half is no e.
pub(in crate::mark::working) fn shows_e(expr: &Expr, prepared: &Prepared) -> bool {
    let Some(e) = sizes(&prepared.known, Quantity::Restitution) else { return false };
    let is = |expr: &Expr, power: i32| {
        let values = value(expr, prepared, &[]).and_then(|values| numbers(&values));
        values.is_some_and(|values| {
            values.iter().zip(&e).all(|(value, e)| (value - e.powi(power)).abs() < 1e-6 * value.abs())
        })
    };
    let is_square = |inner: &Expr| matches!(inner, Expr::Power(..));
    any_within(expr, &|inner| match inner {
        Expr::Name(name) => name.text == "e",
        Expr::Product(factors) => !any_within(inner, &is_square) && factors.iter().any(|factor| is(factor, 1)),
        Expr::Sum(terms) => match terms.as_slice() {
            [one, Expr::Negative(taken)] => *one == Expr::integer(1) && is(taken, 2),
            _ => false,
        },
        _ => false,
    })
}
