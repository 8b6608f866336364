//! The noun phrases of a sentence, `the speeds of *A* and *B*`, and of how many things each is.

use super::grammar::{Count, DESCRIBING, JOINING, body, determiner, ends_a_phrase, noun, verb};
use super::sentence::{Sentence, Token, is_one_of};
use crate::expr::Expr;

/// A noun phrase.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phrase {
    /// Of how many its first noun is, and each that is joined to it.
    pub counts: Vec<Count>,
    /// The place after it.
    pub end: usize,
    /// Its first noun; empty for names.
    head: String,
}

impl Phrase {
    /// Of how many it is.
    pub fn count(&self) -> Count {
        self.counts[0]
    }
}

fn word<'s>(sentence: &'s Sentence, at: usize) -> Option<&'s str> {
    match sentence.get(at)? {
        Token::Word(word) => Some(word),
        _ => None,
    }
}

/// The noun phrase that begins at a place; none if there is none, or if it may be read in two ways.
pub fn phrase(sentence: &Sentence, at: usize) -> Option<Phrase> {
    let first = joined(sentence, at)?;
    if word(sentence, first.end) != Some("and") {
        return Some(first);
    }
    // `The mass of the sphere and the speed` may be a mass of both; `the mass of *A* and the mass of *B*` may not.
    let other = joined(sentence, first.end + 1)?;
    let is_certain = first.counts.len() == 1 || (first.head == other.head && !first.head.is_empty());
    let ends = word(sentence, other.end) != Some("and");
    let counts = [&[Count::Several], &first.counts[..], &other.counts].concat();
    (is_certain && ends).then_some(Phrase { counts, end: other.end, head: String::new() })
}

/// A noun with all that is joined to it by `of`, `between`, `moving with`.
pub fn joined(sentence: &Sentence, at: usize) -> Option<Phrase> {
    let mut whole = bare(sentence, at)?;
    loop {
        let mut next = whole.end;
        while word(sentence, next).is_some_and(|word| JOINING.contains(&word)) {
            next += 1;
        }
        if next == whole.end {
            return Some(whole);
        }
        match (bare(sentence, next), sentence.get(next)) {
            // `The speed of *A* before the spheres collide`: a clause of its own.
            (Some(inner), _) if is_in_time(sentence, whole.end, next) && acts(sentence, &inner) => return Some(whole),
            (Some(inner), _) => {
                whole.counts.extend(inner.counts);
                whole.end = inner.end;
            }
            (None, Some(Token::Number(..))) => whole.end = next + 1,
            _ => return None,
        }
    }
}

/// Do the words between two places tell when?
fn is_in_time(sentence: &Sentence, from: usize, to: usize) -> bool {
    sentence[from..to].iter().any(|token| is_one_of(token, &["before", "after"]))
}

/// Do spheres do something, or is it done to them: `the spheres collide`, `*A* strikes`, `it is struck`?
fn acts(sentence: &Sentence, who: &Phrase) -> bool {
    let is_body = who.head.is_empty() || body(&who.head).is_some();
    let is_done = |word: &str| word.ends_with("ed") || ["struck", "hit", "met"].contains(&word);
    let does = |next: &str| match next {
        "is" | "are" | "was" | "were" | "has" | "have" => word(sentence, who.end + 1).is_some_and(is_done),
        next => verb(next).is_some(),
    };
    is_body && word(sentence, who.end).is_some_and(does)
}

/// Names in a row, or a noun with what describes it before and names it after.
fn bare(sentence: &Sentence, at: usize) -> Option<Phrase> {
    let of = |count, end, head: &str| Some(Phrase { counts: vec![count], end, head: head.to_owned() });
    match word(sentence, at) {
        Some("it") => return of(Count::One, at + 1, ""),
        Some("they") => return of(Count::Several, at + 1, ""),
        Some("each" | "one") if word(sentence, at + 1) == Some("of") => return of(Count::One, at + 1, ""),
        _ => {}
    }
    if let Some((end, named)) = row(sentence, at) {
        return of(if named == 1 { Count::One } else { Count::Several }, end, "");
    }
    let place = noun_after(sentence, at)?;
    let head = word(sentence, place)?;
    let end = place + 1;
    // `A spheres` is of neither number.
    word(sentence, at).and_then(determiner).is_none_or(|said| noun(head) == Some(said)).then_some(())?;
    match (noun(head)?, row(sentence, end), sentence.get(end)) {
        // Of `sphere *A* and *B*` one cannot tell what is meant.
        (Count::One, Some((_, named)), _) if named > 1 => None,
        (count, Some((end, _)), _) => of(count, end, head),
        (count, None, Some(Token::Number(..))) => of(count, end + 1, head),
        (count, None, _) => of(count, end, head),
    }
}

/// The noun to which the words from a place lead, which is the last of its phrase.
pub fn noun_after(sentence: &Sentence, at: usize) -> Option<usize> {
    let is_led = word(sentence, at).is_some_and(|word| {
        determiner(word).is_some() || DESCRIBING.contains(&word) || ["the", "its", "their", "another"].contains(&word)
    });
    let is_any = word(sentence, at).is_some_and(|word| ["a", "an", "the", "two", "three", "its"].contains(&word));
    let start = at + usize::from(is_led);
    for place in start..start + 6 {
        let here = word(sentence, place)?;
        if noun(here).is_some() {
            // What comes before another noun describes it: `a mass ratio`.
            let is_last = word(sentence, place + 1).is_none_or(ends_a_phrase);
            return is_last.then_some(place);
        }
        let describes = is_any || DESCRIBING.contains(&here) || determiner(here).is_some();
        if !describes || (ends_a_phrase(here) && !DESCRIBING.contains(&here)) {
            return None;
        }
    }
    None
}

/// How far the names go that stand in a row from a place, `*A*, *B* and *C*`, and how many they are.
pub fn row(sentence: &Sentence, at: usize) -> Option<(usize, usize)> {
    if !sentence.get(at).is_some_and(is_name) {
        return None;
    }
    let (mut end, mut named) = (at + 1, 1);
    loop {
        let mut next = end;
        if sentence.get(next) == Some(&Token::Comma) {
            next += 1;
        }
        if word(sentence, next) == Some("and") {
            next += 1;
        }
        let is_whole = next > end && sentence.get(next).is_some_and(is_name);
        if !is_whole {
            return Some((end, named));
        }
        (end, named) = (next + 1, named + 1);
    }
}

/// The name of a sphere, or a letter.
fn is_name(token: &Token) -> bool {
    matches!(token, Token::Sphere(_)) || matches!(token, Token::Number(Expr::Name(_), ..))
}

/// Is the row of names from one place to another bound by `and` before its last?
pub fn is_bound(sentence: &Sentence, at: usize, end: usize) -> bool {
    end < at + 2 || is_one_of(&sentence[end - 2], &["and"])
}
