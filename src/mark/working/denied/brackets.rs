//! Formulas as they are if a pair of brackets was lost on paper: `I = 2 × 3 + 6` is 18 where `2 × (3 + 6)` was meant. Who
//! goes on with 18 has had the brackets in mind, and an examiner lets that pass.

use super::middle;
use crate::expr::Expr;
use crate::mark::working::examine::{Value, Working};

/// The most formulas that are tried for one with a pair of brackets more, and with two.
const MOST: usize = 60;
const MOST_WITH_TWO: usize = 400;

/// By more than such a part of it a number is another, where only figures were rounded.
const ROUNDED: f64 = 0.005;

/// The same of the many formulas with two pairs of brackets more, of which one comes near anything.
const ROUNDED_OF_TWO: f64 = 0.0005;

impl Working<'_> {
    /// Does a formula come to these values with one pair of brackets more, or with two: one for each sphere?
    pub(super) fn is_recovered(&self, formula: &Expr, own: &[Value]) -> bool {
        let comes_to = |formula: &Expr, rounded: f64| {
            let values = self.in_given_names(formula);
            let is = |(value, own): (&Value, &Value)| is_within(middle(value), middle(own), rounded);
            values.is_some_and(|values| values.iter().zip(own).all(is))
        };
        bracketed(formula).iter().any(|formula| comes_to(formula, ROUNDED))
            || with_two_pairs(formula).any(|formula| comes_to(&formula, ROUNDED_OF_TWO))
    }
}

/// Are they one value, whichever way it points?
pub(super) fn is_same(one: [f64; 2], own: [f64; 2]) -> bool {
    is_within(one, own, ROUNDED)
}

fn is_within([x, y]: [f64; 2], [own_x, own_y]: [f64; 2], rounded: f64) -> bool {
    let size = x.hypot(y).max(own_x.hypot(own_y));
    [1.0, -1.0].into_iter().any(|sign| (x - sign * own_x).hypot(y - sign * own_y) <= rounded * size)
}

/// Each way to put a pair of brackets about a part of a sum, in which a factor, a minus sign or a quotient then takes in more.
pub(in crate::mark::working) fn bracketed(formula: &Expr) -> Vec<Expr> {
    let mut found = match formula {
        Expr::Sum(terms) => of_sum(terms),
        _ => Vec::new(),
    };
    for (place, child) in formula.children().into_iter().enumerate() {
        for changed in bracketed(child) {
            let mut at = 0;
            found.push(formula.map_children(&mut |child| {
                at += 1;
                if at == place + 1 { changed.clone() } else { child.clone() }
            }));
        }
        found.truncate(MOST);
    }
    found
}

/// A sum with a pair of brackets more in one part of it and one in the rest, as there is one for each sphere.
fn with_two_pairs(formula: &Expr) -> impl Iterator<Item = Expr> + '_ {
    let terms: &[Expr] = if let Expr::Sum(terms) = formula { terms } else { &[] };
    let parts = (2..terms.len().saturating_sub(1)).map(|place| terms.split_at(place));
    let both = parts.flat_map(|(first, rest)| {
        let [first, rest] = [first, rest].map(|terms| bracketed(&Expr::Sum(terms.to_vec())));
        let each = move |one: Expr| rest.clone().into_iter().map(move |other| Expr::sum([one.clone(), other]));
        first.into_iter().flat_map(each)
    });
    both.take(MOST_WITH_TWO)
}

fn of_sum(terms: &[Expr]) -> Vec<Expr> {
    let mut found = Vec::new();
    for first in 0..terms.len() {
        for last in first + 1..terms.len() {
            let with = |middle: Expr| {
                let before = terms[..first].iter().cloned();
                Expr::sum(before.chain([middle]).chain(terms[last + 1..].iter().cloned()))
            };
            found.extend(opened_in(&terms[first], &terms[first + 1..=last]).into_iter().map(with));
            // `3 + 6 × 2` with nothing before it: within a longer sum nobody means so.
            if first == 0 {
                found.extend(closed_in(&terms[first..last], &terms[last]).into_iter().map(with));
            }
        }
    }
    found
}

/// `2 × 3 + 6` as `2 × (3 + 6)`, and `-3 + 6` as `-(3 + 6)`: the brackets begin within the first term.
fn opened_in(first: &Expr, rest: &[Expr]) -> Vec<Expr> {
    match first {
        Expr::Negative(inner) => {
            let whole = Expr::sum([(**inner).clone()].into_iter().chain(rest.iter().cloned()));
            let within = opened_in(inner, rest).into_iter();
            within.chain([whole]).map(|inner| Expr::Negative(Box::new(inner))).collect()
        }
        Expr::Product(factors) => {
            let split = |place: usize| {
                let inner = Expr::product(factors[place..].iter().cloned());
                let sum = Expr::sum([inner].into_iter().chain(rest.iter().cloned()));
                Expr::product(factors[..place].iter().cloned().chain([sum]))
            };
            (1..factors.len()).map(split).collect()
        }
        Expr::Quotient(above, below) => {
            let sum = Expr::sum([(**below).clone()].into_iter().chain(rest.iter().cloned()));
            vec![(**above).clone().over(sum)]
        }
        _ => Vec::new(),
    }
}

/// `3 + 6 × 2` as `(3 + 6) × 2`, and `3 + 6/2` as `(3 + 6)/2`: the brackets end within the last term.
fn closed_in(rest: &[Expr], last: &Expr) -> Vec<Expr> {
    match last {
        Expr::Negative(inner) => {
            let signed = |factor: Expr| Expr::Negative(Box::new(factor));
            match &**inner {
                Expr::Product(factors) => {
                    let mut factors = factors.clone();
                    factors[0] = signed(factors[0].clone());
                    closed_in(rest, &Expr::Product(factors))
                }
                Expr::Quotient(above, below) => {
                    closed_in(rest, &Expr::Quotient(Box::new(signed((**above).clone())), below.clone()))
                }
                _ => Vec::new(),
            }
        }
        Expr::Product(factors) => {
            let split = |place: usize| {
                let inner = Expr::product(factors[..place].iter().cloned());
                let sum = Expr::sum(rest.iter().cloned().chain([inner]));
                Expr::product([sum].into_iter().chain(factors[place..].iter().cloned()))
            };
            (1..factors.len()).map(split).collect()
        }
        Expr::Quotient(above, below) => {
            let sum = Expr::sum(rest.iter().cloned().chain([(**above).clone()]));
            vec![sum.over((**below).clone())]
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::bracketed;
    use crate::expr::{Angles, print, read};

    #[test]
    fn brackets_take_in_more_of_a_sum() {
        let lost = |formula: &str, meant: &str| {
            let found: Vec<String> =
                bracketed(&read(formula, Angles::Degrees).unwrap()).iter().map(print::plain).collect();
            assert!(found.iter().any(|found| found == meant), "{formula}: {found:?}");
        };
        lost("2*3 + 6", "2*(3 + 6)");
        lost("1/2*2*4^2 - 1^2", "(1/2)*2*(4^2 - 1^2)");
        lost("3 + 6*2", "(3 + 6)*2");
        lost("5 + 1/7 - 2", "(5 + 1)/7 - 2");
        lost("5 + 1/7 - 2", "5 + 1/(7 - 2)");
        lost("9 - 4 + 3", "9 - (4 + 3)");
        lost("sqrt(2*3 + 6)", "sqrt(2*(3 + 6))");
    }
}
