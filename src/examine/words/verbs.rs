//! Does a verb agree in number with its subject?
//!
//! It is held against it where a clause begins with one that can be read in one way only; of all others nothing is said.

use super::agreement::{is_word, pair, word_at};
use super::grammar::{ADVERBS, Count, body, verb};
use super::phrases::{Phrase, joined, noun_after, phrase, row};
use super::sentence::{Sentence, Token, is_one_of, says};
use super::sentences::remark_at;
use crate::examine::remark::Remark;

/// `*A* and *B* has`, `the spheres is`, `the mass of the spheres are`.
pub(super) fn verb_of_a_clause(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    let Some(subject) = phrase(sentence, place) else { return };
    let Some(at) = verb_after(sentence, &subject) else { return };
    if begins_a_clause(sentence, place, &subject, word_at(sentence, at)) {
        held_against(sentence, &[subject.count()], place, at, remarks);
    }
}

/// Where the verb of a subject stands: what comes between commas is passed over.
fn verb_after(sentence: &Sentence, subject: &Phrase) -> Option<usize> {
    const ASIDES: [&str; 10] = ["of", "with", "which", "who", "whose", "each", "both", "moving", "having", "in"];
    let end = subject.end;
    let verb_at = |mut at: usize| {
        while ADVERBS.contains(&word_at(sentence, at)) {
            at += 1;
        }
        verb(word_at(sentence, at)).map(|_| at)
    };
    if sentence.get(end) != Some(&Token::Comma) {
        return verb_at(end);
    }
    sentence.get(end + 1).filter(|first| is_one_of(first, &ASIDES))?;
    // `Of masses {m}, {k} and {l} respectively, lie`: the first comma need not be the last. Of one another may be told there:
    // `the sphere, of mass {m}, and the ball, of mass {k}, are`.
    let most = if subject.count() == Count::Several { usize::MAX } else { 1 };
    let commas = (end + 2..sentence.len()).filter(|at| sentence[*at] == Token::Comma);
    let mut commas = commas.take(most);
    let last = commas.find_map(|comma| Some((comma, verb_at(comma + 1)?)));
    let (comma, at) = last?;
    let is_clause = is_one_of(&sentence[end + 1], &["which", "who", "whose"]);
    let has_verb =
        sentence[end + 1..comma].iter().any(|token| matches!(token, Token::Word(word) if verb(word).is_some()));
    (is_clause || !has_verb).then_some(at)
}

/// `Immediately before the collision`, at the beginning of a sentence and without a comma behind it.
fn is_of_time(opening: &[Token]) -> bool {
    const IMPACTS: [&str; 4] = ["collision", "impact", "impulse", "collisions"];
    let rest = match opening {
        [just, rest @ ..] if is_one_of(just, &["immediately", "just", "shortly", "straight"]) => rest,
        all => all,
    };
    matches!(rest, [before, the, impact]
        if is_one_of(before, &["before", "after"]) && is_one_of(the, &["the", "this"]) && is_one_of(impact, &IMPACTS))
}

/// Can what stands at a place be nothing but the subject of a clause?
fn begins_a_clause(sentence: &Sentence, place: usize, subject: &Phrase, verb: &str) -> bool {
    const OPENING: [&str; 10] = ["that", "when", "if", "where", "while", "whether", "because", "so", "which", "then"];
    const IN_TIME: [&str; 5] = ["before", "after", "until", "once", "as"];
    const AHEAD: [&str; 14] = [
        "after",
        "before",
        "when",
        "if",
        "in",
        "immediately",
        "at",
        "as",
        "initially",
        "given",
        "since",
        "because",
        "just",
        "while",
    ];
    let Some(before) = place.checked_sub(1) else { return true };
    if is_of_time(&sentence[..place]) {
        return true;
    }
    match &sentence[before] {
        // `*A* and then *B* strike the wall`
        Token::Word(word) if word == "then" => {
            before.checked_sub(1).is_none_or(|and| word_at(sentence, and) != "and") || subject.count() == Count::Several
        }
        // `Of the same radius as *A*` compares, and begins nothing.
        Token::Word(word) if word == "as" && says(&sentence[before.saturating_sub(3)..before], &["same"]) => false,
        Token::Word(word) if IN_TIME.contains(&word.as_str()) => {
            let is_body = row(sentence, place).is_some()
                || noun_after(sentence, place).is_some_and(|noun| body(word_at(sentence, noun)).is_some());
            is_body && !["is", "are", "was", "were"].contains(&verb)
        }
        Token::Word(word) => OPENING.contains(&word.as_str()),
        Token::Comma => is_one_of(&sentence[0], &AHEAD) && !sentence[..before].contains(&Token::Comma),
        _ => false,
    }
}

/// `*B*, of mass 2 kg, which are`.
pub(super) fn verb_of_which(sentence: &Sentence, place: usize, remarks: &mut Vec<Remark>) {
    let before = place.checked_sub(1).map(|before| &sentence[before]);
    let is_of_more =
        before.is_some_and(|token| !is_word(token) || is_one_of(token, &["and", "of"]) || is_inner(sentence, place));
    let Some(mut whole) = joined(sentence, place).filter(|_| !is_of_more) else { return };
    while sentence.get(whole.end) == Some(&Token::Comma) && word_at(sentence, whole.end + 1) == "of" {
        let Some(more) = joined(sentence, whole.end + 2) else { return };
        whole.counts.extend(more.counts);
        whole.end = more.end;
    }
    let at = whole.end + usize::from(sentence.get(whole.end) == Some(&Token::Comma));
    if ["which", "that", "who"].contains(&word_at(sentence, at)) && verb(word_at(sentence, at + 1)).is_some() {
        // `They reverse their directions, which is more than one knows`: of all that was said.
        let is_of_all = ["is", "was"].contains(&word_at(sentence, at + 1));
        if !(is_of_all && whole.count() == Count::Several) {
            held_against(sentence, &whole.counts, place, at + 1, remarks);
        }
    }
}

/// Is what stands at a place within a longer phrase, to which more belongs?
fn is_inner(sentence: &Sentence, place: usize) -> bool {
    (0..place).any(|from| joined(sentence, from).is_some_and(|outer| outer.end > place))
}

/// A verb of another number than all that may be its subject.
fn held_against(sentence: &Sentence, counts: &[Count], place: usize, at: usize, remarks: &mut Vec<Remark>) {
    let said = word_at(sentence, at);
    let Some((count, other)) = verb(said).filter(|(count, _)| !counts.contains(count)) else { return };
    // `If *B* were at rest`, `it is necessary that *A* move`.
    const SUPPOSED: [&str; 9] =
        ["if", "suppose", "whether", "though", "necessary", "required", "order", "ensure", "would"];
    if count == Count::Several && says(sentence, &SUPPOSED) {
        return;
    }
    let (what, who) = match count {
        Count::One if matches!(sentence[place], Token::Sphere(_)) => ("a verb of one for several", "several spheres"),
        Count::One => ("a verb of one for several", "several"),
        Count::Several => ("a verb of several for one", "one"),
    };
    let shown = format!("{who} … {said}");
    remarks.push(remark_at(what, &pair(sentence, at), &shown, &format!("write `{other}`")));
}
