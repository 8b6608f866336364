//! What is added up in a formula, as the terms of a law are.

use crate::expr::{Expr, Relation};
use crate::mark::working::numbers::{Context, Spread, constant};

/// Nobody writes more terms into one of the two equations.
const MOST_TERMS: usize = 8;

/// How many terms a formula has, brackets multiplied out.
pub(super) fn count(expr: &Expr) -> usize {
    match expr {
        Expr::Sum(all) => all.iter().map(count).sum(),
        Expr::Negative(inner) | Expr::Quotient(inner, _) => count(inner),
        Expr::Product(factors) => factors.iter().map(count).product(),
        _ => 1,
    }
}

/// What is added up in a formula, brackets multiplied out.
pub(super) fn terms(expr: &Expr, context: &Context) -> Option<Vec<Spread>> {
    let found = match expr {
        Expr::Sum(all) => {
            let each: Option<Vec<Vec<Spread>>> = all.iter().map(|term| terms(term, context)).collect();
            each?.concat()
        }
        Expr::Negative(inner) => terms(inner, context)?.into_iter().map(|term| -term).collect(),
        Expr::Product(factors) => {
            let mut product = vec![Spread::exactly(1.0)];
            for factor in factors {
                let factor = terms(factor, context)?;
                product = product.iter().flat_map(|one| factor.iter().map(|other| *one * *other)).collect();
                if product.len() > MOST_TERMS {
                    return None;
                }
            }
            product
        }
        Expr::Quotient(above, below) => {
            let below = constant(below, context)?;
            terms(above, context)?.into_iter().map(|term| term.over(below)).collect::<Option<_>>()?
        }
        Expr::Relation(_, Relation::Equal, _) => return None,
        other => vec![constant(other, context)?],
    };
    (found.len() <= MOST_TERMS).then_some(found)
}

/// The same with every sign turned.
pub(super) fn terms_negated(expr: &Expr, context: &Context) -> Option<Vec<Spread>> {
    Some(terms(expr, context)?.into_iter().map(|term| -term).collect())
}
