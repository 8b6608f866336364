//! Columns over two lines: `(4` above `1)`.

use super::Vocabulary;
use super::choices::{Choices, Doubt};
use super::tokens::{Placed, Token};

/// The tokens with a column over two lines as one on one line, `(4; 1)`. Without brackets the two lines may be two values.
pub(super) fn on_two_lines(mut tokens: Vec<Placed>, vocabulary: &Vocabulary, choices: &mut Choices) -> Vec<Placed> {
    if !vocabulary.vectors {
        return tokens;
    }
    // What is typed before the first line and after the last is no line.
    let ends = [tokens.iter().position(is_said), tokens.iter().rposition(is_said)];
    let [Some(first), Some(last)] = ends else { return tokens };
    let is_figure = |placed: &Placed| match placed.token {
        Token::Number(_) | Token::Root { .. } => true,
        Token::Sign(sign) => matches!(sign, '-' | '/' | '.' | '⟦' | '⟧'),
        _ => false,
    };
    let breaks: Vec<usize> = (first..last).filter(|at| tokens[*at].is('\n')).collect();
    let [middle] = breaks.as_slice() else { return tokens };
    let (above, below) = (&tokens[first..*middle], &tokens[middle + 1..=last]);
    let open = above.iter().rposition(|placed| placed.is('(') || placed.is('['));
    let close = below.iter().position(|placed| placed.is(')') || placed.is(']'));
    let (bracketed, column) = match (open, close) {
        (Some(open), Some(close)) => (true, [&above[open + 1..], &below[..close]]),
        _ => (false, [above, below]),
    };
    if !column.iter().all(|part| !part.is_empty() && part.iter().all(is_figure)) {
        return tokens;
    }
    let place = tokens[*middle].start;
    if bracketed || choices.otherwise(Doubt::Column, place) {
        let sign = |sign, from: &Placed| Placed { token: Token::Sign(sign), ..from.clone() };
        tokens[*middle].token = Token::Sign(';');
        if !bracketed {
            let (open, close) = (sign('(', &tokens[first]), sign(')', &tokens[last]));
            tokens.insert(last + 1, close);
            tokens.insert(first, open);
        }
    }
    tokens
}

fn is_said(placed: &Placed) -> bool {
    !placed.is('\n')
}
