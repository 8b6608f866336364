//! Letters that a student brings: told by how the whole working has them.

use super::angles::{is_short, tangent_letter};
use crate::mark::working::lines::{FUNCTIONS, OWN, typed};
use crate::number::Letter;

/// Capitals that a student tells from the question's small letters: `M` where there is an `m` too.
pub(in crate::mark::working) fn own_capitals(working: &[String], letters: &[Letter]) -> Vec<String> {
    let single = |letter: &&Letter| letter.name().len() == 1;
    let is_letter = |sign: char| letters.iter().filter(single).any(|letter| letter.name().starts_with(sign));
    let words = working.iter().flat_map(|line| line.split(|sign: char| !sign.is_alphabetic()));
    let formulas: String = words.filter(|word| word.chars().all(|sign| is_letter(sign.to_ascii_lowercase()))).collect();
    let has_both = |letter: &&Letter| {
        let small = letter.name();
        formulas.contains(small) && formulas.contains(&small.to_ascii_uppercase())
    };
    let both = letters.iter().filter(single).filter(has_both);
    both.map(|letter| letter.name().to_ascii_uppercase())
        .filter(|capital| !letters.iter().any(|letter| letter.name() == *capital))
        .collect()
}

/// Letters with an index that begin a word somewhere, as in `x2 - x1 = 5`: in `3x1 + 2x2` there is no sign of multiplication.
pub(in crate::mark::working) fn indexed_letters(working: &[String]) -> Vec<&'static str> {
    let is_there = |name: &&str| {
        let Some((letter, index)) = name.split_once('_') else { return false };
        let begins = |typed: &str, name: &str| {
            let stands = |(at, found): (usize, &str)| {
                let (before, after) = (typed[..at].chars().next_back(), typed[at + found.len()..].chars().next());
                [before, after].into_iter().all(|sign| sign.is_none_or(|sign| !sign.is_alphanumeric() && sign != '_'))
            };
            typed.match_indices(name).any(stands)
        };
        typed(working).any(|line| begins(line, &format!("{letter}{index}")))
    };
    OWN.into_iter().filter(is_there).collect()
}

/// Letters that a student sets equal to a sine, cosine or tangent, or to a component: `let T = tan α`, `k = v cos α`.
pub(in crate::mark::working) fn short_letters(working: &[String], letters: &[Letter]) -> Vec<String> {
    let mut found: Vec<String> = Vec::from_iter(tangent_letter(typed(working), letters));
    for typed in
        working.iter().flat_map(|cell| cell.lines()).filter(|line| FUNCTIONS.iter().any(|name| line.contains(name)))
    {
        let sides: Vec<&str> = typed.split('=').collect();
        for pair in sides.windows(2) {
            let mut before = pair[0].trim_end().chars().rev();
            let (letter, stands_alone) =
                (before.next(), before.next().is_none_or(|sign| !sign.is_alphanumeric() && sign != '_'));
            let value = pair[1].split([',', ';']).next().unwrap_or_default();
            let Some(letter) = letter.filter(|_| stands_alone).map(String::from) else { continue };
            let is_new = letters.iter().all(|own| own.name() != letter) && !found.contains(&letter);
            if is_new && is_short(&letter) && FUNCTIONS.iter().any(|name| value.contains(name)) {
                found.push(letter);
            }
        }
    }
    found
}
