//! Do the words ask for exact form where answers must be exact, and are answers exact only where the words ask for it?
//!
//! Words that ask are sentences with 'exact' or 'surd' in them. One with 'or' in it ('to 3 significant figures, or in exact
//! form') leaves the choice to the student.

use super::finding::Finding;
use super::tally::Remark;
use crate::answer::{Accept, Kind};
use crate::bank::{Answer, Find, Question};
use crate::expr::{Piece, Text, print};
use crate::generate::Variant;
use crate::number::{Fraction, Places, Value};
use crate::paper::Words;

/// A number that has more figures than these has no end as a decimal.
const MANY: Places = Places::SignificantFigures(12);

/// Words that ask for exact form of answers that may be rounded.
pub fn unkept(question: &Question) -> Vec<Finding> {
    let all: Vec<&Answer> = question.parts.iter().flat_map(|part| &part.answers).collect();
    let mut found: Vec<(&Text, &Answer, Vec<&str>)> = Vec::new();
    for style in &question.styles {
        let before = style.stem.iter().chain([&style.note]).map(|text| (text, all.clone()));
        let asked =
            question.parts.iter().flat_map(|part| part.ask.iter().map(|ask| (ask, part.answers.iter().collect())));
        for (text, answers) in before.chain(asked) {
            let may_be_rounded = |answer: &&&Answer| *answer.accept(style.name) != Accept::Exact;
            let unkept = sentences(text).into_iter().filter(|sentence| demands(sentence)).find_map(|sentence| {
                let meant = meant(&sentence, &answers);
                let rounded: Vec<&&Answer> = meant.iter().filter(may_be_rounded).collect();
                let is_kept = rounded.len() < meant.len() && !is_of_all(&sentence);
                rounded.first().filter(|_| !is_kept).map(|answer| **answer)
            });
            let Some(answer) = unkept else { continue };
            match found.iter_mut().find(|(known, ..)| *known == text) {
                Some((_, _, styles)) => styles.push(style.name.name()),
                None => found.push((text, answer, vec![style.name.name()])),
            }
        }
    }
    found.into_iter().map(|(text, answer, styles)| finding(text, answer, &styles)).collect()
}

fn finding(text: &Text, answer: &Answer, styles: &[&str]) -> Finding {
    let name = print::text_unicode(&answer.name);
    let asking = match styles {
        [one] => format!("style `{one}` asks"),
        _ => format!("styles `{}` ask", styles.join("`, `")),
    };
    let message = format!("{asking} for exact form, and `{name}` may be rounded there");
    let label = "so a student who rounds it, against these words, is marked right";
    let help = match styles {
        [one] => format!("name the answer in `exact = [ … ]` of `[style.{one}]`, or take the words out"),
        _ => "write `accept = \"exact\"` at the answer, or take the words out".to_owned(),
    };
    Finding::new(message, place(text), label).with_help(help)
}

/// The words as they stand in the file, to the next formula on either side.
fn place(text: &Text) -> String {
    let asking = text.0.iter().find_map(|piece| match piece {
        Piece::Words(words) if asks(words) => Some(words.trim().to_owned()),
        _ => None,
    });
    asking.unwrap_or_default()
}

pub(super) fn sentences(text: &Text) -> Vec<String> {
    print::text_unicode(text).split(". ").map(str::to_lowercase).collect()
}

/// Do the words speak of exact form at all?
fn asks(words: &str) -> bool {
    has_word(words, "exact") || has_word(words, "surd") || has_word(words, "surds")
}

fn demands(sentence: &str) -> bool {
    asks(sentence) && !has_word(sentence, "or")
}

fn has_word(words: &str, wanted: &str) -> bool {
    words.split(|c: char| !c.is_alphanumeric()).any(|word| word.eq_ignore_ascii_case(wanted))
}

/// 'Your answers' are all of them; of 'the speeds' one is enough to see that the author has thought of it.
fn is_of_all(sentence: &str) -> bool {
    has_word(sentence, "answer") || has_word(sentence, "answers")
}

/// The answers of which a sentence speaks: those whose names begin with one of its words; all, if none does.
pub(super) fn meant<'q>(sentence: &str, answers: &[&'q Answer]) -> Vec<&'q Answer> {
    let open = answers.iter().copied().filter(|answer| answer.kind != Kind::Shown);
    let asking = sentence.split_inclusive("exact").next().unwrap_or(sentence);
    let is_named = |answer: &&Answer| {
        let name = print::text_unicode(&answer.name).to_lowercase();
        let first = name.split_whitespace().next().unwrap_or_default();
        !is_of_all(sentence) && (has_word(asking, first) || has_word(asking, &format!("{first}s")))
    };
    let named: Vec<&Answer> = open.clone().filter(is_named).collect();
    if named.is_empty() { open.collect() } else { named }
}

/// Answers of a variant that must be exact, are no decimals, and of which no words say so.
pub fn unasked(question: &Question, variant: &Variant, words: &Words, remarks: &mut Vec<Remark>) {
    let said = |text: &Text| asks(&print::text_unicode(text));
    if words.stem.iter().any(said) {
        return;
    }
    for (part, _) in question.parts.iter().zip(&words.asks).filter(|(_, ask)| !said(ask)) {
        for answer in &part.answers {
            let by_itself = matches!(answer.kind, Kind::Shown | Kind::Line | Kind::Range);
            if !by_itself && *answer.accept(variant.style) == Accept::Exact && invites_rounding(answer, variant) {
                let what = format!("the answer `{}` must be exact, and no words say so", answer.find.name());
                let label = "a student who rounds it loses the mark";
                let help = "ask for exact form in the words, or leave `accept` out";
                remarks.push(Remark::new(what, format!("\"{}\"", answer.find.name()), label, help));
            }
        }
    }
}

/// Has a number of the answer no end as a decimal?
fn invites_rounding(answer: &Answer, variant: &Variant) -> bool {
    let solution = &variant.solution;
    let endless = |value: &Value| {
        let ends = |fraction: &Fraction| value.rounded(&MANY).is_ok_and(|decimal| decimal.to_fraction() == *fraction);
        value.is_constant() && !value.as_fraction().is_some_and(ends)
    };
    if let Find::Unknown(name) = &answer.find {
        return solution.found().iter().any(|(letter, value)| letter.name() == name && endless(value));
    }
    answer.find.quantities().into_iter().any(|quantity| match solution.number(quantity) {
        Some(value) => endless(&value),
        None => {
            solution.angle(quantity).is_some_and(|angle| angle.letters().is_empty() && angle.whole_degrees().is_none())
        }
    })
}
