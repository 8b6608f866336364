//! What is said beside a value or an equation and is no part of it: how far it is rounded, which equation is used.

use super::SaidUnit;
use super::phrases::Walk;
use super::tokens::{Placed, Token};
use super::units::unit;
use crate::expr::Expr;

impl Walk<'_> {
    /// `(3 s.f.)`, `to 2 dp`: how far a value is rounded; the token after it.
    pub(super) fn accuracy(&self, at: usize) -> Option<usize> {
        let open = self.tokens[at].is('(');
        let start = at + usize::from(open);
        let words = ["correct to", "rounded to", "to"];
        let number = self.any(start, &words).unwrap_or(start);
        let led = open || number > start;
        let small = |expr: &Expr| matches!(expr, Expr::Number(value) if value.as_small().is_some_and(|(n, d)| n < 10 && d == 1));
        let counts = match &self.tokens.get(number)?.token {
            Token::Number(value) => small(value),
            Token::Word(word) => matches!(word.as_str(), "one" | "two" | "three" | "four"),
            _ => false,
        };
        if !(counts && (led || at > 0)) {
            return None;
        }
        let kinds = [
            "sf",
            "dp",
            "sig figs",
            "sig fig",
            "significant figures",
            "significant figure",
            "decimal places",
            "decimal place",
        ];
        let end = self.any(number + 1, &kinds)?;
        let end = end + usize::from(self.tokens.get(end).is_some_and(|token| token.is('.')));
        match open {
            true => self.tokens.get(end).is_some_and(|token| token.is(')')).then_some(end + 1),
            false => Some(end),
        }
    }

    /// `eqn 2`, `from (1)`, `in equation (1)`: which equation is meant; the token after it.
    pub(super) fn named_equation(&self, at: usize) -> Option<usize> {
        self.word(at)?;
        let lead = self.any(at, &["from", "using", "in", "into", "sub into", "by", "of"]);
        let named = self.any(lead.unwrap_or(at), &["eq", "eqn", "equation", "eqs", "eqns", "equations"]);
        let number = named.or(lead)?;
        let number = number + usize::from(self.tokens.get(number).is_some_and(|token| token.is('.')));
        let counts = |at: usize| {
            matches!(&self.tokens.get(at)?.token, Token::Number(Expr::Number(value)) if value.is_integer())
                .then_some(at + 1)
        };
        let is = |at: usize, sign: char| self.tokens.get(at).is_some_and(|token| token.is(sign));
        let bracketed =
            |at: usize| is(at, '(').then(|| counts(at + 1).filter(|next| is(*next, ')')))?.map(|next| next + 1);
        match is(number, '(') {
            true => {
                let mut end = bracketed(number)?;
                // `from (1) and (2)`
                while let Some(next) = self.any(end, &["and"]).or(is(end, ',').then_some(end + 1)).and_then(bracketed) {
                    end = next;
                }
                Some(end)
            }
            // `(from 1)`
            false => counts(number).filter(|next| named.is_some() || (at > 0 && is(at - 1, '(') && is(*next, ')'))),
        }
    }
}

/// Brackets around words are an aside, and part it from the rest as commas would: `0 m/s (at rest)`. So are brackets in
/// which a value is said again, or a condition: `√13 (3.61 m/s)`, `√13 (= 3.61)`, `8 (k > 0)`.
pub(super) fn with_asides_set_off(mut tokens: Vec<Placed>) -> Vec<Placed> {
    for start in 1..tokens.len() {
        if let Some(end) = said_again(&tokens, start) {
            tokens[start].token = Token::Sign(',');
            tokens[end].token = Token::Sign(',');
        }
    }
    let mut open: Vec<(usize, bool)> = Vec::new();
    for at in 0..tokens.len() {
        match tokens[at].token {
            Token::Sign('(') => open.push((at, false)),
            Token::Phrase(_) => {
                if let Some(last) = open.last_mut() {
                    last.1 = true;
                }
            }
            Token::Sign(')') => {
                if let Some((start, true)) = open.pop() {
                    tokens[start].token = Token::Sign(',');
                    tokens[at].token = Token::Sign(',');
                }
            }
            _ => {}
        }
    }
    tokens
}

/// The closing bracket of a value that is said again, or of a condition, in the bracket that opens here.
fn said_again(tokens: &[Placed], start: usize) -> Option<usize> {
    let after_value =
        matches!(tokens[start - 1].token, Token::Number(_) | Token::Word(_) | Token::Sign(')' | '°' | '⟧'));
    if !tokens[start].is('(') || !after_value || !tokens[start].spaced {
        return None;
    }
    let inner = tokens.get(start + 1)?;
    let close = start + tokens[start..].iter().position(|placed| placed.is(')'))?;
    let inside = &tokens[start + 1..close];
    let compares = |placed: &Placed| matches!(placed.token, Token::Sign('<' | '>' | '≤' | '≥'));
    if inner.is('=') || inner.is('≈') || inside.iter().any(compares) {
        let opens = inside.iter().any(|placed| placed.is('('));
        return (!opens).then_some(close);
    }
    if is_the_same(&tokens[..start], inside) {
        return Some(close);
    }
    // A speed, an impulse or an energy: no letters of a question look like their units.
    let whole = |unit: &SaidUnit| unit.dimension[1] != 0 && unit.dimension[2] != 0;
    let end = match unit(tokens, start + 2, "").filter(|(unit, _)| whole(unit)) {
        Some((_, end)) => end,
        // `√13 m/s (3.61)`
        None => {
            let before = (1..start).filter_map(|at| unit(&tokens[..start], at, ""));
            before.filter(|(unit, end)| *end == start && whole(unit)).map(|_| start + 2).next()?
        }
    };
    (matches!(inner.token, Token::Number(_)) && tokens.get(end)?.is(')')).then_some(end)
}

/// Is a number or a fraction in brackets nearly the decimal before them: `0.75 (3/4)`? A product would be another number.
fn is_the_same(before: &[Placed], inside: &[Placed]) -> bool {
    let number = |placed: &Placed| match &placed.token {
        Token::Number(Expr::Number(value)) => Some(value.to_f64()),
        Token::Number(Expr::Decimal(text)) => text.parse().ok(),
        _ => None,
    };
    let value = |tokens: &[Placed]| match tokens {
        [only] => number(only),
        [above, line, below] if line.is('/') => Some(number(above)? / number(below)?),
        _ => None,
    };
    let begins = |placed: &Placed| placed.is('=') || placed.is('≈') || placed.is(',');
    let stated = before.iter().rposition(begins).map_or(before, |at| &before[at + 1..]);
    let is_decimal = matches!(stated, [Placed { token: Token::Number(Expr::Decimal(_)), .. }]);
    let both: Option<(f64, f64)> = value(stated).zip(value(inside)).filter(|_| is_decimal);
    both.is_some_and(|(one, other)| (one - other).abs() < 0.01 * one.abs())
}

/// Where the unit ends that stands after a note on accuracy, and belongs to the number before: `3.61 (3sf) m/s`.
pub(super) fn unit_before_accuracy(tokens: &[Placed], after_number: bool, next: usize) -> Option<usize> {
    let (_, end) = unit(tokens, next, "").filter(|_| after_number)?;
    Some(end)
}
