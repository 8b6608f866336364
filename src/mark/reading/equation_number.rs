//! The number that a student gives to an equation: `3v + 2w = 8 (1)`, `w − v = 2 … (2)`, `[3] 5v = 4`.

use super::choices::{Choices, Doubt};
use super::tokens::{Placed, Token};
use crate::expr::Expr;

/// The tokens of an equation without its number. Where a bracket may also be a factor, both are readings.
pub(super) fn without_number<'a>(tokens: &'a [Placed], choices: &mut Choices) -> &'a [Placed] {
    if tokens.iter().any(|placed| placed.is('=')) {
        let tokens = without_number_before(tokens, choices);
        return without_number_after(tokens, choices, true);
    }
    // `u(1-e)/2 (2)`: what it is equal to is not written.
    let has_letters = |placed: &Placed| matches!(placed.token, Token::Word(_) | Token::Greek(_));
    match tokens.iter().any(has_letters) {
        true => without_number_after(tokens, choices, false),
        false => tokens,
    }
}

fn without_number_before<'a>(tokens: &'a [Placed], choices: &mut Choices) -> &'a [Placed] {
    let (number, rest) = match tokens {
        [open, number, close, rest @ ..] if are_brackets(open, close) => (number, rest),
        [number, close, rest @ ..] if close.is(')') => (number, rest),
        _ => return tokens,
    };
    let Some(next) = rest.first().filter(|_| is_number(number)) else { return tokens };
    match next.token {
        Token::Sign(':') => &rest[1..],
        Token::Number(_) if next.spaced => rest,
        // `(2) v + …`
        Token::Word(_) | Token::Greek(_) if next.spaced && !choices.otherwise(Doubt::EquationNumber, number.start) => {
            rest
        }
        _ => tokens,
    }
}

fn without_number_after<'a>(tokens: &'a [Placed], choices: &mut Choices, is_equation: bool) -> &'a [Placed] {
    let [equation @ .., open, number, close] = tokens else { return tokens };
    if !are_brackets(open, close) || !is_number(number) {
        return tokens;
    }
    // What leads from the equation to its number.
    let leads = |placed: &&Placed| placed.is('…') || placed.is('-') || placed.is('.');
    let count = equation.iter().rev().take_while(leads).count();
    let (equation, lead) = equation.split_at(equation.len() - count);
    let Some(last) = equation.last() else { return tokens };
    let is_whole = match last.token {
        Token::Sign(sign) => matches!(sign, ')' | ']' | '}' | '⟧' | '°' | '%' | '|'),
        _ => true,
    };
    if !is_whole {
        return tokens;
    }
    let likely = match lead {
        [] if !open.spaced => return tokens,
        // `1/2 (4)` is as likely a product.
        [] => is_equation && !matches!(last.token, Token::Number(_) | Token::Sign(_)),
        [dash] if dash.is('-') && !is_equation => return tokens,
        // `4u —(1)`; from a number it may be taken off.
        [dash] if dash.is('-') && !(dash.spaced && open.spaced) && matches!(last.token, Token::Number(_)) => {
            return tokens;
        }
        [dash] if dash.is('-') => true,
        _ => return equation,
    };
    if likely != choices.otherwise(Doubt::EquationNumber, number.start) { equation } else { tokens }
}

fn are_brackets(open: &Placed, close: &Placed) -> bool {
    [('(', ')'), ('[', ']'), ('{', '}')].into_iter().any(|(left, right)| open.is(left) && close.is(right))
}

/// Is it a number such as equations have, or a star?
fn is_number(placed: &Placed) -> bool {
    match &placed.token {
        Token::Number(Expr::Number(number)) => {
            number.as_small().is_some_and(|(number, below)| (1..=20).contains(&number) && below == 1)
        }
        Token::Sign(sign) => *sign == '*',
        _ => false,
    }
}
