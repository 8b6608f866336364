//! One of the two laws in which a pair of brackets was lost and nobody went on as if it stood there: `w - v = ½ × 5 + 1` where
//! ½(5 + 1) is meant, and `7 = 2v + 3v + 3` once `w = v + 3` was said.

use super::convention::is_value;
use super::conventions::Convention;
use super::departure::Departure;
use super::offered::differences;
use super::pair::{Laws, Matched};
use crate::expr::Expr;
use crate::mark::working::denied::bracketed;
use crate::mark::working::numbers::any_within;
use crate::mark::working::prepared::Prepared;

/// The law that an equation is with a pair of brackets more.
pub(super) fn with_brackets_lost(
    equation: &(Expr, Expr),
    laws: &Laws,
    convention: &Convention,
    prepared: &Prepared,
) -> Option<Matched> {
    let (left, right) = equation;
    let names: Vec<_> = [left, right].into_iter().flat_map(Expr::names).collect();
    let has = |letter: &String| names.iter().any(|name| name.text == *letter);
    // With one velocity alone it could be anything.
    if is_value(equation) || !convention.letters.iter().all(has) || ![left, right].into_iter().any(has_sum) {
        return None;
    }
    let of_left = bracketed(left).into_iter().map(|left| (left, right.clone()));
    let of_right = bracketed(right).into_iter().map(|right| (left.clone(), right));
    of_left.chain(of_right).find_map(|equation| {
        let linear = differences(&equation, prepared)?;
        let apiece = || super::apiece::Apiece::of(&equation, prepared);
        laws.exactly(&linear, apiece, convention).map(|law| Matched::with(law, Departure::BracketsLost))
    })
}

fn has_sum(side: &Expr) -> bool {
    any_within(side, &|inner| matches!(inner, Expr::Sum(_)))
}
