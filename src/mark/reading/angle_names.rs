//! The question's angles as keyboards have them: `tan a` for `tan α`.

use std::ops;

use super::Vocabulary;
use super::characters::{CLOSE, OPEN};
use super::choices::Choices;
use super::lexicon::sort;
use super::ranges::is_any;
use super::tokens::{Placed, Token, greek};
use crate::number::{Letter, Range};

/// What an angle stands under.
const FUNCTIONS: [&str; 7] = ["sin", "cos", "tan", "sec", "cosec", "csc", "cot"];

/// The tokens with the question's angle in the place of a small letter under a sine, cosine or tangent, where the question
/// has no such letter and one angle alone begins with it.
pub(super) fn with_angles(mut tokens: Vec<Placed>, vocabulary: &Vocabulary, choices: &mut Choices) -> Vec<Placed> {
    let is_angle = |letter: &&Letter| letter.range() == Range::Acute;
    if !vocabulary.letters.iter().any(|letter| is_angle(&letter)) {
        return tokens;
    }
    let mut angle = |own: &str| {
        let is_letter = own.len() == 1 && own.starts_with(|letter: char| letter.is_ascii_lowercase());
        let is_known = vocabulary.letters.iter().any(|letter| letter.name() == own);
        let mut namesakes = vocabulary.letters.iter().filter(is_angle).filter(|letter| letter.name().starts_with(own));
        let only = namesakes.next().filter(|_| is_letter && !is_known && namesakes.next().is_none());
        let (sign, name) = greek(only?.name())?;
        choices.note(|| format!("{own} read as {sign}"));
        Some(Token::Greek(name))
    };
    let mut named: Vec<String> = Vec::new();
    for at in 0..tokens.len() {
        let is_function = matches!(&tokens[at].token, Token::Word(word) if ends_in_function(word));
        for placed in is_function.then(|| argument(&tokens, at + 1)).into_iter().flatten() {
            if let Token::Word(own) = &tokens[placed].token
                && let Some(angle) = angle(own)
            {
                named.push(own.clone());
                tokens[placed].token = angle;
            }
        }
    }
    // `a + arctan(e tan a)`
    let is_sign = |placed: Option<&Placed>| placed.is_some_and(|placed| is_any(placed, &['+', '-']));
    for at in 0..tokens.len() {
        let is_term = is_sign(tokens.get(at + 1)) || is_sign(at.checked_sub(1).map(|before| &tokens[before]));
        if let Token::Word(own) = &tokens[at].token
            && is_term
            && named.contains(own)
            && let Some(angle) = angle(own)
        {
            tokens[at].token = angle;
        }
    }
    let mut out: Vec<Placed> = Vec::with_capacity(tokens.len());
    for placed in tokens {
        // `ucosa`
        if let Token::Word(word) = &placed.token
            && let Some((before, own)) = word.split_at_checked(word.len().saturating_sub(1))
            && ends_in_function(before)
            && sort(word).is_none()
            && let Some(angle) = angle(own)
        {
            let middle = placed.end - 1;
            out.push(Placed { token: Token::Word(before.to_owned()), end: middle, ..placed });
            out.push(Placed { token: angle, start: middle, end: placed.end, spaced: false });
        } else {
            out.push(placed);
        }
    }
    out
}

fn ends_in_function(word: &str) -> bool {
    FUNCTIONS.iter().any(|function| word.ends_with(function))
}

/// Where the argument of a function stands, after its power: in brackets, or a number of times one letter.
fn argument(tokens: &[Placed], from: usize) -> ops::Range<usize> {
    let is_power = |placed: &&Placed| matches!(placed.token, Token::Number(_)) || is_any(placed, &['^', OPEN, CLOSE]);
    let start = from + tokens[from..].iter().take_while(is_power).count();
    if !tokens.get(start).is_some_and(|placed| is_any(placed, &['(', '['])) {
        return start..tokens.len().min(start + 1);
    }
    let mut depth = 0_usize;
    let closes = |placed: &Placed| {
        depth += usize::from(is_any(placed, &['(', '[']));
        depth = depth.saturating_sub(usize::from(is_any(placed, &[')', ']'])));
        depth == 0
    };
    let end = tokens[start..].iter().position(closes).map_or(tokens.len(), |end| start + end);
    start..end
}
