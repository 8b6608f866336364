//! The stretches of an answer between its separators.

use super::phrases::Phrase;
use super::tokens::{Placed, Token};

/// The stretches between newlines, semicolons, commas, arrows and full stops that stand outside brackets, and whether an
/// arrow leads to each of them.
pub(super) fn segments(tokens: &[Placed]) -> Vec<(bool, &[Placed])> {
    let mut found: Vec<(bool, &[Placed])> = Vec::new();
    let (mut depth, mut start, mut arrow) = (0_usize, 0, false);
    for (at, placed) in tokens.iter().enumerate() {
        match placed.token {
            Token::Sign('(' | '[' | '{' | '⟦') => depth += 1,
            Token::Sign(')' | ']' | '}' | '⟧') => depth = depth.saturating_sub(1),
            _ => {}
        }
        let parts = match placed.token {
            Token::Sign('\n' | '¦' | '⇒') => true,
            Token::Sign(';' | ',') => depth == 0,
            Token::Sign('.') => depth == 0 && is_full_stop(&tokens[start..at], &tokens[at + 1..]),
            _ => false,
        };
        if parts {
            found.push((arrow, &tokens[start..at]));
            (start, arrow) = (at + 1, placed.is('⇒'));
        } else if let Some(name) = next_sphere(&tokens[start..=at]).filter(|_| depth == 0) {
            // `A: 3 B: 4`
            found.push((arrow, &tokens[start..start + name]));
            (start, arrow) = (start + name, false);
        }
    }
    found.push((arrow, &tokens[start..]));
    found.retain(|(_, part)| !part.is_empty());
    found
}

/// `KE before = 20 J. KE after = 11 J.`: does a point part two sentences that state a value each? After `k` and `i` it does
/// not, nor before an equals sign.
fn is_full_stop(before: &[Placed], after: &[Placed]) -> bool {
    let is_equals = |placed: &Placed| placed.is('=') || placed.is(':');
    let ends = |placed: &Placed| matches!(placed.token, Token::Sign('.' | ';' | ',' | '\n' | '⇒'));
    let mut sentence = after.iter().take_while(|placed| !ends(placed));
    // In `45. = 46.1` the same sentence goes on.
    let begins = after.first().is_some_and(|next| next.spaced && !is_equals(next));
    before.iter().any(is_equals) && begins && sentence.any(is_equals)
}

/// Where the name of a sphere begins that a colon ends here, after a value of another: `speed of B:`. So does the name of
/// another quantity, `speed: 3.82 direction:`.
fn next_sphere(tokens: &[Placed]) -> Option<usize> {
    let [before @ .., Placed { token: Token::Phrase(name @ (Phrase::Sphere | Phrase::Noun)), .. }, colon] = tokens
    else {
        return None;
    };
    if *name == Phrase::Noun && !before.iter().any(|placed| placed.is(':') || placed.is('=')) {
        return None;
    }
    let names =
        |placed: &&Placed| matches!(placed.token, Token::Phrase(Phrase::Noun | Phrase::Remark | Phrase::Joiner));
    let words = before.iter().rev().take_while(names).count();
    let name = before.len() - words;
    let first_noun = before[name..].iter().position(|placed| placed.token == Token::Phrase(Phrase::Noun));
    let is_after_value = name > 0 && !before[name - 1].is(':');
    (colon.is(':') && is_after_value).then(|| first_noun.map_or(before.len(), |noun| name + noun))
}

/// An answer between quotation marks without them.
pub(super) fn unquoted(tokens: &[Placed]) -> &[Placed] {
    match tokens {
        [first, inner @ .., last] if first.token == last.token && (first.is('"') || first.is('\'')) => inner,
        _ => tokens,
    }
}

/// Are all brackets closed?
pub(super) fn outside(tokens: &[Placed]) -> bool {
    let count = |signs: [char; 4]| {
        tokens.iter().filter(|placed| matches!(placed.token, Token::Sign(sign) if signs.contains(&sign))).count()
    };
    count(['(', '[', '{', '⟦']) <= count([')', ']', '}', '⟧'])
}
