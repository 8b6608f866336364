//! The label of a part before its answer: `(a) 2.78`, `ii) 4i + j`.

use super::Vocabulary;
use super::phrases::Phrase;
use super::tokens::{Placed, Token};

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
    match tokens {
        [open, name, close, rest @ ..] if open.is('(') && close.is(')') && !rest.is_empty() && part(name, rest) => rest,
        [name, close, rest @ ..] if close.is(')') && !rest.is_empty() && part(name, rest) => rest,
        _ => tokens,
    }
}
