//! Do the words of a sentence agree in number: `two spheres` with two names, `the spheres are`, `a sphere`?

use super::sentence::{Sentence, Token, is_one_of, sentences};
use super::sentences::remark_at;
use crate::examine::remark::Remark;
use crate::expr::Text;
use crate::mechanics::Sphere;

/// Things of which there may be several, each in the singular.
const THINGS: [&str; 4] = ["sphere", "particle", "ball", "wall"];

/// Words after which what comes is not what the sentence is about.
const PREPOSITIONS: [&str; 13] =
    ["of", "between", "with", "from", "to", "by", "on", "for", "towards", "and", "at", "joining", "against"];

/// Words for one thing doing or being something, and for several.
const VERBS: [(&str, &str); 5] =
    [("is", "are"), ("has", "have"), ("was", "were"), ("moves", "move"), ("collides", "collide")];

/// Counts, articles and verbs that are of another number than their nouns.
pub fn disagreeing(text: &Text, remarks: &mut Vec<Remark>) {
    for sentence in sentences(text) {
        for place in 0..sentence.len() {
            miscounted(&sentence, place, remarks);
            article(&sentence, place, remarks);
            verb(&sentence, place, remarks);
        }
    }
}

/// Is it a word for several of the things?
fn is_several(token: &Token) -> bool {
    THINGS.iter().any(|thing| matches!(token, Token::Word(word) if word.strip_suffix('s') == Some(thing)))
}

/// How far the names of spheres go that stand in a row, `*A*, *B* and *C*`, and how many they are.
fn row(words: &[Token]) -> (usize, usize) {
    let (mut end, mut count) = (0, 0);
    for (place, token) in words.iter().enumerate() {
        match token {
            Token::Sphere(_) => (end, count) = (place + 1, count + 1),
            Token::Comma => {}
            _ if is_one_of(token, &["and"]) => {}
            _ => break,
        }
        // A comma after the last name is not in the row.
        if *token == Token::Comma && !matches!(words.get(place + 1), Some(Token::Sphere(_))) {
            break;
        }
    }
    (end, count)
}

/// A word with the one after it, so that no other place is taken for it.
fn pair(sentence: &Sentence, at: usize) -> String {
    let words = sentence[at..].iter().take(2).map_while(|token| match token {
        Token::Word(word) => Some(word.as_str()),
        _ => None,
    });
    words.collect::<Vec<_>>().join(" ")
}

/// `Three spheres *A* and *B*`.
fn miscounted(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    let Token::Word(word) = &sentence[place] else { return };
    let Some(said) = ["two", "three"].iter().position(|count| count == word).map(|nth| nth + 2) else { return };
    let described = sentence[place + 1..].iter().take(6);
    let length =
        described.take_while(|token| matches!(token, Token::Word(_)) && !is_one_of(token, &PREPOSITIONS)).count();
    let noun = &sentence[place + 1..place + 1 + length];
    if !noun.last().is_some_and(is_several) {
        return;
    }
    let (_, named) = row(&sentence[place + 1 + length..]);
    // `Two spheres *A*, of mass 2 kg, and *B*` names them one by one.
    let all = Sphere::ALL.into_iter().filter(|sphere| sentence[place..].contains(&Token::Sphere(*sphere))).count();
    if named > 0 && named != said && all != said {
        let count = if named == 1 { "one is named".to_owned() } else { format!("{named} are named") };
        let what = format!("{word} of which {count}");
        let help = "name as many as there are, or say another number";
        let (at, shown) = (pair(sentence, place + length - 1), format!("{word} … {}", pair(sentence, place + length)));
        remarks.push(remark_at(&what, &at, &shown, help));
    }
}

/// `A small smooth spheres`.
fn article(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    if !is_one_of(&sentence[place], &["a", "an"]) {
        return;
    }
    let described = sentence[place + 1..].iter().take(5);
    let words: Vec<&Token> = described
        .take_while(|token| matches!(token, Token::Word(_)) && !is_one_of(token, &PREPOSITIONS) && !is_thing(token))
        .collect();
    let at = place + 1 + words.len();
    if let Some(Token::Word(several)) = sentence.get(at).filter(|token| is_several(token)) {
        let shown = format!("a … {several}");
        remarks.push(remark_at(
            "one of several",
            &pair(sentence, at - 1),
            &shown,
            "write the word in the singular, or say how many",
        ));
    }
}

fn is_thing(token: &Token) -> bool {
    is_one_of(token, &THINGS) || is_several(token)
}

/// `*A* and *B* has`, `the spheres is`: what comes between commas is not asked.
fn verb(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    let (end, named) = row(&sentence[place..]);
    let is_row = named > 1
        && !place.checked_sub(1).is_some_and(|before| matches!(sentence[before], Token::Comma | Token::Sphere(_)));
    let after = match is_row {
        true => place + end,
        false if is_several(&sentence[place]) => place + 1,
        false => return,
    };
    let lead = sentence[..place].iter().rev().find(|token| !is_described(token));
    if lead.is_some_and(|token| is_one_of(token, &PREPOSITIONS) || matches!(token, Token::Sphere(_))) {
        return;
    }
    let aside = |from: usize| match sentence.get(from) {
        Some(Token::Comma) => {
            sentence[from + 1..].iter().position(|token| *token == Token::Comma).map(|end| from + end + 2)
        }
        _ => Some(from),
    };
    let Some(at) = aside(after) else { return };
    let Some(Token::Word(said)) = sentence.get(at) else { return };
    if let Some((_, several)) = VERBS.iter().find(|(one, _)| one == said) {
        let who = if is_row { "several spheres" } else { "several" };
        let shown = format!("{who} … {said}");
        remarks.push(remark_at(
            "a verb of one for several",
            &pair(sentence, at),
            &shown,
            &format!("write `{several}`"),
        ));
    }
}

/// Does a word describe the noun after it?
fn is_described(token: &Token) -> bool {
    is_several(token)
        || is_one_of(
            token,
            &[
                "the",
                "these",
                "two",
                "three",
                "both",
                "small",
                "smooth",
                "uniform",
                "equal",
                "identical",
                "fixed",
                "vertical",
            ],
        )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::read_markup;

    #[test]
    fn one_is_not_several() {
        let table = [
            ("Two small smooth spheres *A* and *B* have equal radii.", ""),
            ("Two smooth spheres *A*, *B* and *C* lie in a line.", "two of which 3 are named"),
            ("Two smooth spheres *A*, of mass {m}, and *B*, of mass {k}, have equal radii.", ""),
            ("Two balls *A* (mass {m}) and *B* (mass {k}) roll towards each other.", ""),
            ("Two smooth spheres *A*, of mass {m}, lie in a line.", "two of which one is named"),
            ("Three small smooth spheres *A* and *B*, of equal radius, lie in a line.", "three of which 2 are named"),
            ("Three spheres *A*, *B* and *C*, of masses {m}, {k} and {l}, are at rest.", ""),
            ("Two spheres lie between *A* and the wall.", ""),
            ("A small smooth spheres *A* moves.", "a … spheres"),
            ("A smooth sphere *A* strikes two walls.", ""),
            ("A sphere between two walls is at rest.", ""),
            ("The coefficient of restitution between the two spheres is {e}.", ""),
            ("The distance from *A* to *B* is {d}; the speed of *A* and *B* is {u}.", ""),
            ("The line joining *A* and *B* is parallel to {i}.", ""),
            ("The spheres is at rest.", "several … is"),
            ("*A* and *B* has equal radii.", "several spheres … has"),
            ("Two spheres *A* and *B*, of equal radii, is moving.", "several spheres … is"),
            ("Two spheres *A* and *B*, of equal radii, are moving.", ""),
            ("*A* strikes *B* and is then at rest.", ""),
            ("As a result of the collision between *A* and *B* is turned the path of *A*.", ""),
            ("Sphere *A* hits *B*, which has mass {m}.", ""),
        ];
        for (words, shown) in table {
            let mut remarks = Vec::new();
            for text in read_markup(words).unwrap() {
                disagreeing(&text, &mut remarks);
            }
            let said = format!("{remarks:?}");
            assert!(remarks.is_empty() == shown.is_empty() && said.contains(shown), "{words}: {said}");
        }
    }
}
