//! Vectors over two lines: `(4` above `1)`, `4i` above `+ j`.

use super::Vocabulary;
use super::choices::{Choices, Doubt};
use super::tokens::{Placed, Token};

/// The tokens with a column over two lines as one on one line, `(4; 1)`. Without brackets the two lines may be two values.
pub(super) fn on_two_lines(mut tokens: Vec<Placed>, vocabulary: &Vocabulary, choices: &mut Choices) -> Vec<Placed> {
    if !vocabulary.vectors {
        return tokens;
    }
    let Some((first, middle, last)) = two_lines(&tokens) else { return tokens };
    let is_figure = |placed: &Placed| match placed.token {
        Token::Number(_) | Token::Root { .. } => true,
        Token::Sign(sign) => matches!(sign, '-' | '/' | '.' | '⟦' | '⟧'),
        _ => false,
    };
    let (above, below) = (&tokens[first..middle], &tokens[middle + 1..=last]);
    let open = above.iter().rposition(|placed| placed.is('(') || placed.is('['));
    let close = below.iter().position(|placed| placed.is(')') || placed.is(']'));
    let (bracketed, column) = match (open, close) {
        (Some(open), Some(close)) => (true, [&above[open + 1..], &below[..close]]),
        _ => (false, [above, below]),
    };
    if !column.iter().all(|part| !part.is_empty() && part.iter().all(is_figure)) {
        return tokens;
    }
    let place = tokens[middle].start;
    if bracketed || choices.otherwise(Doubt::Column, place) {
        let sign = |sign, from: &Placed| Placed { token: Token::Sign(sign), ..from.clone() };
        tokens[middle].token = Token::Sign(';');
        if !bracketed {
            let (open, close) = (sign('(', &tokens[first]), sign(')', &tokens[last]));
            tokens.insert(last + 1, close);
            tokens.insert(first, open);
        }
    }
    tokens
}

/// `4i` above `+ j`: one vector, whose second component has a line of its own.
pub(super) fn with_joined_lines(mut tokens: Vec<Placed>, vocabulary: &Vocabulary) -> Vec<Placed> {
    let has = |line: &[Placed], name: &str| {
        line.iter().any(|placed| matches!(&placed.token, Token::Word(word) if word == name))
    };
    let goes_on = |above: &[Placed], below: &[Placed]| {
        let is_split = |first: &str, second: &str| {
            has(above, first) && !has(above, second) && has(below, second) && !has(below, first)
        };
        let is_sign = |placed: Option<&Placed>| placed.is_some_and(|placed| placed.is('+') || placed.is('-'));
        let is_joined = is_sign(below.first()) || is_sign(above.last());
        is_joined && (is_split("i", "j") || is_split("j", "i"))
    };
    if vocabulary.vectors
        && let Some((first, middle, last)) = two_lines(&tokens)
        && goes_on(&tokens[first..middle], &tokens[middle + 1..=last])
    {
        tokens.remove(middle);
    }
    tokens
}

/// Where the first of two lines begins, where it ends and where the second one does: an empty line before or after them
/// is none.
fn two_lines(tokens: &[Placed]) -> Option<(usize, usize, usize)> {
    let is_said = |placed: &Placed| !placed.is('\n');
    let (first, last) = (tokens.iter().position(is_said)?, tokens.iter().rposition(is_said)?);
    let mut breaks = (first..last).filter(|at| tokens[*at].is('\n'));
    breaks.next().filter(|_| breaks.next().is_none()).map(|middle| (first, middle, last))
}
