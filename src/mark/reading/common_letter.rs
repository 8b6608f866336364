//! A letter that two numbers have in common and the question does not have: in `3x : 4x` and `5m/(21.5m)` it cancels.

use super::choices::Choices;
use super::tokens::{Placed, Token};
use super::{Vocabulary, names};

/// The tokens of a quotient or ratio of two numbers without such a letter behind each.
pub(super) fn without_common_letter(
    tokens: Vec<Placed>,
    vocabulary: &Vocabulary,
    choices: &mut Choices,
) -> Vec<Placed> {
    let (first, second) = match tokens.as_slice() {
        [_, first, sign, _, second] if is_between(sign) => (first, second),
        [_, first, sign, open, _, second, close] if is_between(sign) && open.is('(') && close.is(')') => {
            (first, second)
        }
        _ => return tokens,
    };
    let letter = match &first.token {
        Token::Word(word) if word.len() == 1 && !names::is_made_of_letters(word, vocabulary) => word.clone(),
        _ => return tokens,
    };
    let numbers = tokens.iter().filter(|placed| matches!(placed.token, Token::Number(_))).count();
    let is_unit_vector = vocabulary.vectors && matches!(letter.as_str(), "i" | "j");
    if first.token != second.token || numbers != 2 || is_unit_vector {
        return tokens;
    }
    choices.note(|| format!("{letter} read as a factor of both numbers, and cancelled"));
    tokens.into_iter().filter(|placed| placed.token != Token::Word(letter.clone())).collect()
}

fn is_between(placed: &Placed) -> bool {
    placed.is(':') || placed.is('/')
}
