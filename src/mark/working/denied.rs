//! Equations that deny what is to be found: `80 = 18m²` has not led to `m = 4`.

use super::compare::any_within;
use super::examine::{Working, value};
use super::theirs::numbers;
use crate::expr::Expr;

/// Sides that are apart by less than this part of the greater may be so by rounding.
const ROUNDED: f64 = 0.05;

impl Working<'_> {
    /// Do lines set up an equation in the one letter that is sought of which the right value is plainly no root, and none of
    /// which it is? That the letter is so much is no such equation.
    pub(super) fn denies_what_is_found(&self) -> bool {
        if self.prepared.found.len() != 1 {
            return false;
        }
        let open = self.lines.iter().filter(|studied| studied.matched.is_empty() && !studied.line.is_crossed_out());
        let readings = open.filter_map(|studied| studied.reading.as_ref());
        let set_up = readings.flat_map(|reading| &reading.equations).filter(|(left, right)| {
            !self.is_sought(left) && !self.is_sought(right) && (self.has_sought(left) || self.has_sought(right))
        });
        let set_up: Vec<&(Expr, Expr)> = set_up.collect();
        let holds = |equation: &&(Expr, Expr)| self.holds_only_where_found(equation);
        // What was right at first may have been worked out wrongly: the last of them leads to the value.
        let last = set_up.last().filter(|last| !has_rounded_nought(last) && !holds(last));
        last.is_some_and(|last| self.is_denied(last))
            || set_up.iter().any(|equation| self.is_denied(equation)) && !set_up.iter().any(holds)
    }

    /// Is an equation in nothing but the letter that is sought, and plainly false of what that is?
    fn is_denied(&self, (left, right): &(Expr, Expr)) -> bool {
        let found = |expr: &Expr| {
            let right = |name: &str| {
                let mut found = self.prepared.found.iter();
                let (_, values) = found.find(|(letter, _)| letter.name() == name)?;
                Some(Expr::Decimal(format!("{:.12}", values.first().copied().flatten()?)))
            };
            numbers(&value(&expr.substitute(&right), self.prepared, &self.prepared.names)?)
        };
        let is_far = |(one, other): (&f64, &f64)| (one - other).abs() > ROUNDED * one.abs().max(other.abs());
        found(left).zip(found(right)).is_some_and(|(left, right)| left.iter().zip(&right).all(is_far))
    }
}

/// Is it set equal to nought with decimals, which are rounded? Of nought no part is small.
fn has_rounded_nought((left, right): &(Expr, Expr)) -> bool {
    let is_decimal = |inner: &Expr| matches!(inner, Expr::Decimal(_));
    [left, right].into_iter().any(Expr::is_zero) && [left, right].into_iter().any(|side| any_within(side, &is_decimal))
}
