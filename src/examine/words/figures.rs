//! Do the words ask for the figures to which answers are accepted? Whoever does as he is told must not lose a mark by it.

use super::sentence::{Token, sentences};
use super::spoken_of::{is_of_all, spoken_of};
use crate::answer::{Accept, Kind};
use crate::bank::{Answer, Question, StyleName};
use crate::examine::Finding;
use crate::expr::{Text, print};
use crate::number::Places;

/// Words that ask for other figures than those to which an answer is accepted.
pub fn otherwise(question: &Question) -> Vec<Finding> {
    let rows =
        |part: usize| question.parts[part].answers.iter().enumerate().map(move |(row, answer)| (part, row, answer));
    let all: Vec<_> = (0..question.parts.len()).flat_map(rows).collect();
    let mut findings: Vec<Finding> = Vec::new();
    for style in &question.styles {
        let before = style.stem.iter().chain([&style.note]).map(|text| (text, None));
        let asks = question.parts.iter().enumerate();
        let asks = asks.flat_map(|(place, part)| part.ask.iter().map(move |ask| (ask, Some(place))));
        for (text, part) in before.chain(asks) {
            // What a part asks of its own answers goes before what is asked of all.
            let has_own = |part: usize| {
                question.parts[part].ask.iter().flat_map(sentences).any(|words| !asked(&words).is_empty())
            };
            let is_meant = |own: usize| part.map_or(!has_own(own), |part| part == own);
            let answers: Vec<_> = all.iter().filter(|(own, ..)| is_meant(*own)).collect();
            let Some((places, answer)) = unlike(text, style.name, answers.iter().map(|(.., answer)| *answer)) else {
                continue;
            };
            let name = print::text_unicode(&answer.name);
            let rule = answer.accept(style.name);
            let asked = Accept::Rounded(places.clone());
            let message = format!("style `{}` asks for `{asked}`, and the rule of `{name}` is `{rule}`", style.name);
            let help =
                format!("write `accept = \"{}\"` at the answer, or ask for what it has", Accept::RoundsTo(places));
            let found = Finding::new(message, "", "who does as the words say may lose the mark").with_help(help);
            let at = answers.iter().find(|(.., own)| std::ptr::eq(*own, answer));
            let found = at.map_or(found.clone(), |(part, row, _)| found.at_row(*part, "answers", *row));
            // Of one text of all styles it is told once.
            if !findings.iter().any(|known| known.row == found.row) {
                findings.push(found);
            }
        }
    }
    findings
}

/// The figures that a text asks for, and the first answer of which it speaks, if none of these is accepted to them.
fn unlike<'q>(
    text: &Text,
    style: StyleName,
    answers: impl Iterator<Item = &'q Answer>,
) -> Option<(Places, &'q Answer)> {
    let is_number = |answer: &&Answer| matches!(answer.kind, Kind::Number | Kind::Angle | Kind::Vector);
    let answers: Vec<&Answer> = answers.filter(is_number).collect();
    sentences(text).into_iter().find_map(|sentence| {
        let asked = asked(&sentence);
        let places = |answer: &Answer| answer.accept(style).places().cloned();
        let rounded: Vec<&Answer> =
            spoken_of(&sentence, &answers).into_iter().filter(|answer| places(answer).is_some()).collect();
        let is_met = |answer: &&Answer| asked.iter().any(|asked| places(answer).as_ref() == Some(asked));
        // Of `your answers` each must be as it says, of `the speeds` one.
        let unmet = match is_of_all(&sentence) || !rounded.iter().any(is_met) {
            true => rounded.iter().find(|answer| !is_met(answer)),
            false => None,
        };
        Some((asked.first()?.clone(), *unmet?))
    })
}

/// All figures that a sentence asks for: `to 3 significant figures`, `to the nearest degree`.
pub(super) fn asked(sentence: &[Token]) -> Vec<Places> {
    const COUNTS: [&str; 5] = ["one", "two", "three", "four", "five"];
    let word = |token: &Token| match token {
        Token::Word(word) => word.clone(),
        Token::Number(expr, ..) => print::unicode(expr),
        Token::Sphere(_) | Token::Comma => String::new(),
    };
    let words: Vec<String> = sentence.iter().map(word).collect();
    let at = (0..words.len()).filter_map(|at| {
        let count = COUNTS.iter().position(|count| *count == words[at]).map(|count| (count + 1).to_string());
        let first = count.as_deref().unwrap_or(&words[at]);
        let is_rule = first == "nearest" || first.parse::<u32>().is_ok();
        let rest = |length: usize| words.get(at + 1..at + length).map(|rest| format!("{first} {}", rest.join(" ")));
        let said = |length| Accept::said(&rest(length)?).ok();
        // `3sf` is one word.
        let is_short = first.starts_with(|sign: char| sign.is_ascii_digit()) && first.ends_with(['f', 'p']);
        let short = || Accept::said(first).ok().filter(|_| is_short);
        [3, 2].into_iter().filter(|_| is_rule).find_map(said).or_else(short)?.places().cloned()
    });
    at.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};
    use crate::expr::read_markup;

    #[test]
    fn figures_of_the_words_are_those_of_the_rule() {
        let id = "rest/speeds-and-directions";
        assert_eq!(otherwise(&edited(id, &[])), []);
        let table = [
            ("significant figures", 2, "asks for `2sf`, and the rule of"),
            ("decimal places", 1, "asks for `1dp`, and the rule of"),
        ];
        for (what, count, words) in table {
            let note = format!("to {count} {what}");
            let found = otherwise(&edited(id, &[("to 3 significant figures", &note)]));
            assert!(found.iter().any(|found| found.message.contains(words)), "{found:?}");
        }
        let wall = "walls/rebound-speed-and-direction";
        let rule = ("find = \"ke.lost\", accept = \"awrt 3sf\"", "find = \"ke.lost\", accept = \"2dp\"");
        let said =
            |edits: Edits| otherwise(&edited(wall, edits)).into_iter().map(|found| found.message).collect::<String>();
        assert!(said(&[rule]).contains("asks for `3sf`, and the rule of `kinetic energy lost` is `2dp`"));
        let in_part = ("lost in the impact.", "lost in the impact, to 2 decimal places.");
        assert_eq!(said(&[rule, in_part]), "");
        let count = |words: &str| asked(&sentences(&read_markup(words).unwrap()[0])[0]).len();
        let table = [
            ("Give it to three significant figures, or to the nearest degree.", 2),
            ("Give it to 3 s.f.", 1),
            ("Give it to 3sf, or 1dp.", 2),
            ("The 3 spheres move with the nearest at {2 m/s} in 3 figures.", 0),
        ];
        for (words, figures) in table {
            assert_eq!(count(words), figures, "{words}");
        }
    }
}
