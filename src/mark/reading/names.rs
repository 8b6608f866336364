//! Words into letters of the question and functions: `usin` is u and sine, `mu` is m and u where the question has both.

use super::Vocabulary;
use super::choices::{Choices, Doubt};
use super::tokens::Token;
use crate::expr::Function;
use crate::number::Letter;

/// Functions by every name that students use; longer names first.
const FUNCTIONS: [(&str, Function); 14] = [
    ("arcsin", Function::Asin),
    ("arccos", Function::Acos),
    ("arctan", Function::Atan),
    ("artan", Function::Atan),
    ("invtan", Function::Atan),
    ("invsin", Function::Asin),
    ("invcos", Function::Acos),
    ("asin", Function::Asin),
    ("acos", Function::Acos),
    ("atan", Function::Atan),
    ("abs", Function::Abs),
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
];

/// What is one over a function, or the inverse of that, by every name.
const RECIPROCALS: [(&str, Function); 12] = [
    ("arccosec", Function::Asin),
    ("arccsc", Function::Asin),
    ("arcsec", Function::Acos),
    ("arccot", Function::Atan),
    ("acosec", Function::Asin),
    ("acsc", Function::Asin),
    ("asec", Function::Acos),
    ("acot", Function::Atan),
    ("cosec", Function::Sin),
    ("csc", Function::Sin),
    ("sec", Function::Cos),
    ("cot", Function::Tan),
];

/// Names of the root sign.
const ROOTS: [&str; 4] = ["squareroot", "sqrt", "root", "rt"];

/// Capitals that name spheres, unit vectors or units, and are no slips for small letters.
const CAPITALS_OF_THEIR_OWN: &str = "ABCIJNOPQS";

/// A piece of a word and how many bytes it takes.
type Piece = (Token, usize);

/// The tokens of a word, if it is made of letters of the question and functions alone.
pub(super) fn split(word: &str, place: usize, vocabulary: &Vocabulary, choices: &mut Choices) -> Option<Vec<Token>> {
    if let Some(whole) = letter(word, vocabulary) {
        let apart = (word.len() > 1).then(|| pieces(word, vocabulary, false)).flatten();
        if let Some(apart) = apart.filter(|_| !word.contains('_'))
            && choices.otherwise(Doubt::Names, place)
        {
            return Some(apart);
        }
        return Some(vec![whole]);
    }
    let found = pieces(word, vocabulary, true)?;
    for (token, typed) in found.iter().zip(word.chars()) {
        if let Token::Letter(name) = token
            && found.len() == word.len()
            && *name != typed.to_string()
        {
            choices.note(|| format!("{typed} read as {name}"));
        }
    }
    Some(found)
}

/// `4I + J` with small letters, where **i** and **j** are unit vectors and no letters stand for themselves as capitals.
pub(super) fn with_small_unit_vectors(text: &str, vocabulary: &Vocabulary) -> Option<String> {
    let is_taken = |name: &str| vocabulary.letters.iter().any(|letter| letter.name() == name);
    if !vocabulary.vectors || is_taken("I") || is_taken("J") {
        return None;
    }
    let small = |(at, sign): (usize, char)| {
        let stands = || {
            let (before, after) = (text[..at].chars().next_back(), &text[at + 1..]);
            let is_named = after.trim_start().starts_with(['=', ':']);
            !before.is_some_and(char::is_alphabetic)
                && !after.starts_with(|next: char| next.is_alphanumeric() || next == '_')
                && !is_named
        };
        if matches!(sign, 'I' | 'J') && stands() { sign.to_ascii_lowercase() } else { sign }
    };
    let found: String = text.char_indices().map(small).collect();
    let has_both = ['I', 'J'].iter().all(|sign| text.matches(*sign).count() > found.matches(*sign).count());
    has_both.then_some(found)
}

/// Is it made of letters of the question and functions alone?
pub(super) fn is_made_of_letters(word: &str, vocabulary: &Vocabulary) -> bool {
    letter(word, vocabulary).is_some() || pieces(word, vocabulary, true).is_some()
}

/// The word taken apart from its end, the longest name first at every place.
fn pieces(word: &str, vocabulary: &Vocabulary, long: bool) -> Option<Vec<Token>> {
    if !word.is_ascii() {
        return None;
    }
    let mut from: Vec<Option<Piece>> = vec![None; word.len() + 1];
    let reached = |from: &[Option<Piece>], at: usize| at == word.len() || from[at].is_some();
    for at in (0..word.len()).rev() {
        from[at] = candidates(&word[at..], vocabulary)
            .into_iter()
            .filter(|(_, length)| long || *length < word.len())
            .find(|(_, length)| reached(&from, at + length));
    }
    let mut out = Vec::new();
    let mut at = 0;
    while at < word.len() {
        let (token, length) = from[at].clone()?;
        out.push(token);
        at += length;
    }
    Some(out)
}

/// Is it the name of a function, such as `tan`?
pub(super) fn is_function(word: &str) -> bool {
    FUNCTIONS.iter().any(|(name, _)| name.eq_ignore_ascii_case(word))
}

/// What the rest of a word can begin with, the longest first.
fn candidates(rest: &str, vocabulary: &Vocabulary) -> Vec<Piece> {
    let begins = |name: &str| rest.get(..name.len()).is_some_and(|start| start.eq_ignore_ascii_case(name));
    let first = rest.bytes().next().unwrap_or_default();
    let mut found: Vec<Piece> = Vec::new();
    if b"acisrtp".contains(&first.to_ascii_lowercase()) {
        let functions = FUNCTIONS.into_iter().map(|(name, function)| (name, Token::Function(function)));
        let reciprocals = RECIPROCALS.into_iter().map(|(name, function)| (name, Token::Reciprocal(function)));
        let roots = ROOTS.into_iter().map(|name| (name, Token::Root { cube: false }));
        let others = [("cbrt", Token::Root { cube: true }), ("pi", Token::Pi)];
        let named = functions.chain(reciprocals).chain(roots).chain(others);
        found.extend(named.filter(|(name, _)| begins(name)).map(|(name, token)| (token, name.len())));
    }
    let own = vocabulary.letters.iter().filter(|letter| letter.begins_with(first));
    let longest = own.map(|letter| letter.name().len()).max().unwrap_or(0).max(1);
    for length in (1..=rest.len().min(longest)).rev() {
        if let Some(token) = rest.get(..length).and_then(|name| letter(name, vocabulary)) {
            found.push((token, length));
        }
    }
    found.sort_by_key(|(_, length)| std::cmp::Reverse(*length));
    found
}

fn without_underscores(name: &str) -> impl Iterator<Item = u8> {
    name.bytes().filter(|byte| *byte != b'_').map(|byte| byte.to_ascii_lowercase())
}

/// A letter of the question by its name, a unit vector, or a capital typed for a small letter.
pub(super) fn letter(name: &str, vocabulary: &Vocabulary) -> Option<Token> {
    let first = name.bytes().next()?;
    // `vA` and `va` are `v_A`.
    let same = |letter: &&Letter| {
        let (own, several) = (letter.name(), name.len() > 1 && name.is_ascii());
        let alike = || without_underscores(&own[1..]).eq(without_underscores(&name[1..]));
        own == name || (several && own.len() > 1 && own.is_ascii() && own[..1] == name[..1] && alike())
    };
    if let Some(letter) = vocabulary.letters.iter().filter(|letter| letter.begins_with(first)).find(same) {
        return Some(Token::Letter(letter.name().to_owned()));
    }
    if vocabulary.vectors && matches!(name, "i" | "j") {
        return name.chars().next().map(Token::Along);
    }
    let is_capital = name.len() == 1 && name.starts_with(|first: char| first.is_ascii_uppercase());
    if !is_capital || CAPITALS_OF_THEIR_OWN.contains(name) {
        return None;
    }
    let small = name.to_ascii_lowercase();
    let has = |letter: &Letter| letter.begins_with(small.as_bytes()[0]) && letter.name() == small;
    vocabulary.letters.iter().any(has).then_some(Token::Letter(small))
}
