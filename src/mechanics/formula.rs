//! Products and differences composed as a careful hand writes them.

use crate::expr::{Expr, written};
use crate::number::Value;

/// A product without needless brackets: factors of factors are factors, and a minus stands in front.
pub fn times(left: Expr, right: Expr) -> Expr {
    match (left, right) {
        (Expr::Negative(left), Expr::Negative(right)) => times_in_order(*left, *right),
        (Expr::Number(left), Expr::Negative(right)) if left.sign().is_lt() => {
            times_in_order(Expr::Number(-left), *right)
        }
        (Expr::Negative(left), right) => times_in_order(*left, right).negated(),
        (left, Expr::Negative(right)) => times_in_order(left, *right).negated(),
        (left, right) => times_in_order(left, right),
    }
}

fn times_in_order(left: Expr, right: Expr) -> Expr {
    let factors = |expr: Expr| match expr {
        Expr::Product(factors) => factors,
        other => vec![other],
    };
    let product = Expr::product(factors(left).into_iter().chain(factors(right)));
    if product.is_zero() { Expr::integer(0) } else { product }
}

/// `left - right`, without a double minus.
pub fn difference(left: Expr, right: Expr) -> Expr {
    match right {
        Expr::Number(number) if number.sign().is_lt() => Expr::sum([left, Expr::Number(-number)]),
        Expr::Negative(inner) => Expr::sum([left, *inner]),
        Expr::Sum(terms) => Expr::sum(std::iter::once(left).chain(terms.into_iter().map(Expr::negated))),
        right => Expr::sum([left, right.negated()]),
    }
}

/// A letter times a value.
pub fn multiple(factor: &Value, letter: Expr) -> Expr {
    if factor.as_fraction().is_some_and(|number| (-number.clone()).is_one()) {
        return letter.negated();
    }
    times(written(factor), letter)
}
