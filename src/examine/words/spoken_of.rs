//! Of which answers a sentence speaks that says how they are to be given.

use super::sentence::{Token, says};
use crate::answer::Kind;
use crate::bank::Answer;
use crate::expr::print;

/// The answers that a sentence names before the word `exact`, by the first words of their names; all, if it names none.
pub fn spoken_of<'q>(sentence: &[Token], answers: &[&'q Answer]) -> Vec<&'q Answer> {
    let open = answers.iter().copied().filter(|answer| answer.kind != Kind::Shown);
    let end = sentence.iter().position(|token| *token == Token::Word("exact".to_owned())).unwrap_or(sentence.len());
    let is_named = |answer: &&Answer| {
        let name = print::text_unicode(&answer.name).to_lowercase();
        let first = name.split_whitespace().next().unwrap_or_default();
        let names_it = |token: &Token| match token {
            Token::Word(word) => word.strip_suffix('s') == Some(first) || word == first,
            Token::Number(expr, ..) => print::unicode(expr).to_lowercase().split_whitespace().any(|word| word == first),
            _ => false,
        };
        sentence[..end].iter().any(names_it)
    };
    let named: Vec<&Answer> = open.clone().filter(|answer| !is_of_all(sentence) && is_named(answer)).collect();
    if named.is_empty() { open.collect() } else { named }
}

/// 'Your answers' are all of them; of 'the speeds' one is enough to see that the author has thought of it.
pub fn is_of_all(sentence: &[Token]) -> bool {
    says(sentence, &["answer", "answers"])
}
