//! The label of a part before its answer: `(a) 2.78`, `ii) 4i + j`.

use super::Vocabulary;
use super::phrases::Phrase;
use super::tokens::{Placed, Token};
use crate::expr::Expr;

/// The tokens without the number of the question and its part, `3(a) 2.5`, `Q3(a)(ii) 2.5`, as a whole number close before
/// one letter in brackets cannot be a factor where the question has no such letter.
pub(super) fn without_question_number(mut tokens: Vec<Placed>, vocabulary: &Vocabulary) -> Vec<Placed> {
    let is_q = |placed: &Placed| matches!(&placed.token, Token::Word(word) if word.eq_ignore_ascii_case("q"));
    let numbered = if tokens.first().is_some_and(is_q) { &tokens[1..] } else { &tokens[..] };
    let [Placed { token: Token::Number(Expr::Number(number)), .. }, rest @ ..] = numbered else { return tokens };
    let known = |word: &str| vocabulary.letters.iter().any(|letter| letter.name() == word);
    let is_part = |word: &str| {
        let is_letter = word.len() == 1 && word.starts_with(|letter: char| letter.is_ascii_lowercase());
        let is_unit_vector = vocabulary.vectors && matches!(word, "i" | "j");
        (is_letter || matches!(word, "ii" | "iii" | "iv" | "vi")) && !known(word) && !is_unit_vector
    };
    let mut rest = rest;
    let whole = rest.len();
    while let [open, Placed { token: Token::Word(word), .. }, close, after @ ..] = rest
        && open.is('(')
        && !open.spaced
        && close.is(')')
        && is_part(word)
    {
        rest = after;
    }
    let begins = |placed: &Placed| placed.spaced && !matches!(placed.token, Token::Sign('+' | '-' | '*' | '/' | '='));
    // `Q2: 2.78`
    if tokens.first().is_some_and(is_q)
        && let [mark, first, ..] = rest
        && (mark.is(':') || mark.is(')'))
        && begins(first)
    {
        let label = tokens.len() - rest.len() + 1;
        tokens.drain(..label);
        return tokens;
    }
    if number.is_integer() && rest.len() < whole && rest.first().is_some_and(begins) {
        let label = tokens.len() - rest.len();
        tokens.drain(..label);
    }
    tokens
}

/// The tokens without the arrow in brackets that says which way is resolved: `(→)`, `R(→)`.
pub(super) fn without_arrow(tokens: &[Placed]) -> &[Placed] {
    let rest = match tokens {
        [Placed { token: Token::Word(word), .. }, rest @ ..] if word == "R" => rest,
        _ => tokens,
    };
    match rest {
        [open, arrow, close, rest @ ..] if open.is('(') && arrow.is('⇒') && close.is(')') && !rest.is_empty() => {
            if rest[0].is(':') {
                &rest[1..]
            } else {
                rest
            }
        }
        _ => tokens,
    }
}

/// `A → 2.78`, `v → 2.78`: an arrow after the name of a sphere alone is a colon, and so it is after a letter that the question
/// does not have.
pub(super) fn with_arrows_after_names(mut tokens: Vec<Placed>, vocabulary: &Vocabulary) -> Vec<Placed> {
    let is_known = |name: &str| vocabulary.letters.iter().any(|letter| letter.name() == name);
    let is_name = |token: &Token, after: &[Placed]| match token {
        Token::Phrase(Phrase::Sphere) => true,
        Token::Word(word) => {
            let is_number = matches!(after, [Placed { token: Token::Number(_) | Token::Root { .. }, .. }, ..]);
            word.len() == 1 && !is_known(word) && is_number
        }
        _ => false,
    };
    for at in 1..tokens.len() {
        let begins = at < 2 || matches!(tokens[at - 2].token, Token::Sign(',' | ';' | '\n'));
        if begins && tokens[at].is('⇒') && is_name(&tokens[at - 1].token, &tokens[at + 1..]) {
            tokens[at].token = Token::Sign(':');
        }
    }
    tokens
}

/// The tokens without `(a)`, `a)` or `(ii)` before them.
pub(super) fn without_part_label<'a>(tokens: &'a [Placed], vocabulary: &Vocabulary) -> &'a [Placed] {
    let letter = |word: &str| vocabulary.letters.iter().any(|letter| letter.name() == word);
    // `(i) 4i + j` is a label and a vector, `(i) − 3j` is a vector.
    let begins = |rest: &[Placed]| {
        rest.first().is_some_and(|first| {
            first.spaced && !matches!(first.token, Token::Sign('+' | '-' | '*' | '/' | '^' | '=' | '°' | '%'))
        })
    };
    let part = |placed: &Placed, rest: &[Placed]| match &placed.token {
        Token::Word(word) if matches!(word.as_str(), "i" | "j" | "ii" | "iii" | "iv" | "vi") => begins(rest),
        Token::Word(word) => word.len() == 1 && !letter(word),
        Token::Phrase(Phrase::Remark) => placed.end == placed.start + 1,
        _ => false,
    };
    // `1) 2.78`
    let numbered = |placed: &Placed, rest: &[Placed]| {
        let is_count = |expr: &Expr| matches!(expr, Expr::Number(value) if value.is_integer());
        matches!(&placed.token, Token::Number(value) if is_count(value)) && begins(rest)
    };
    match tokens {
        [name, close, rest @ ..] if close.is(')') && numbered(name, rest) => rest,
        [open, name, close, rest @ ..] if open.is('(') && close.is(')') && !rest.is_empty() && part(name, rest) => rest,
        [name, close, rest @ ..] if close.is(')') && !rest.is_empty() && part(name, rest) => rest,
        _ => tokens,
    }
}
