//! Do the words ask for exact form where answers must be exact, and are answers exact only where the words ask for it?
//!
//! Words that ask are sentences with 'exact' or 'surd' in them. One with 'or' in it ('to 3 significant figures, or in exact
//! form') leaves the choice to the student.

use super::sentence::{Token, says, sentences};
use super::spoken_of::{is_of_all, spoken_of};
use crate::answer::{Accept, Kind};
use crate::bank::{Answer, Find, Question};
use crate::examine::Finding;
use crate::examine::remark::Remark;
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
                let meant = spoken_of(&sentence, &answers);
                let is_excepted = |answer: &&&Answer| excepts_angles(&sentence) && answer.kind == Kind::Angle;
                let rounded: Vec<&&Answer> =
                    meant.iter().filter(|answer| may_be_rounded(answer) && !is_excepted(answer)).collect();
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
    let asks = |words: &str| {
        let mut each = words.split(|sign: char| !sign.is_alphanumeric());
        each.any(|word| EXACT.contains(&word.to_lowercase().as_str()))
    };
    let asking = text.0.iter().find_map(|piece| match piece {
        Piece::Words(words) if asks(words) => Some(words.trim().to_owned()),
        _ => None,
    });
    asking.unwrap_or_default()
}

/// Words that speak of exact form.
const EXACT: [&str; 3] = ["exact", "surd", "surds"];

fn demands(sentence: &[Token]) -> bool {
    says(sentence, &EXACT) && !says(sentence, &["or"])
}

/// `Give exact answers, and angles to 3 significant figures.`
fn excepts_angles(sentence: &[Token]) -> bool {
    const OTHERWISE: [&str; 7] = ["significant", "decimal", "figures", "degree", "except", "apart", "but"];
    says(sentence, &["angle", "angles"]) && says(sentence, &OTHERWISE)
}

/// Which words speak of exact form: they are the same in every variant.
#[derive(Clone, Debug)]
pub struct AsksExact {
    stem: bool,
    /// Of each part.
    asks: Vec<bool>,
}

impl AsksExact {
    /// Reads them in the words of a variant.
    pub fn of(words: &Words) -> AsksExact {
        let said = |text: &Text| sentences(text).iter().any(|sentence| says(sentence, &EXACT));
        AsksExact {
            stem: words.stem.iter().any(|text| said(text)),
            asks: words.asks.iter().map(|text| said(text)).collect(),
        }
    }
}

/// Answers of a variant that must be exact, are no decimals, and of which no words say so. What the words say is read when it
/// is wanted.
pub fn unasked<'h>(
    question: &Question,
    variant: &Variant,
    words: &dyn Fn() -> &'h AsksExact,
    remarks: &mut Vec<Remark>,
) {
    let is_to_be_exact = |answer: &&Answer| {
        let by_itself = matches!(answer.kind, Kind::Shown | Kind::Line | Kind::Range);
        !by_itself && *answer.accept(variant.style) == Accept::Exact
    };
    // Few questions have such answers, and reading words costs more than to see that there are none.
    if !question.parts.iter().flat_map(|part| &part.answers).any(|answer| is_to_be_exact(&answer)) {
        return;
    }
    let AsksExact { stem: false, asks } = words() else { return };
    for (part, _) in question.parts.iter().zip(asks).filter(|(_, asks)| !**asks) {
        let exact = part.answers.iter().filter(is_to_be_exact);
        for answer in exact.filter(|answer| invites_rounding(answer, variant)) {
            let what = format!("the answer `{}` must be exact, and no words say so", answer.find.name());
            let label = "a student who rounds it loses the mark";
            if answer.is_exact_by_style(variant.style) {
                let help = "ask for exact form in the `note` of the style, or take the answer out of this list";
                remarks.push(Remark::new(what, "", label, help).at_key("exact"));
                continue;
            }
            let help = "ask for exact form in the words, or write `accept = \"awrt 3sf\"`";
            // The scene may name the letter too.
            let key = if matches!(answer.find, Find::Unknown(_)) { "find = " } else { "" };
            remarks.push(Remark::new(what, format!("{key}\"{}\"", answer.find.name()), label, help));
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
        None => solution.angle(quantity).is_some_and(|angle| angle.is_constant() && angle.whole_degrees().is_none()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn exact_form_is_asked_for_where_it_is_kept() {
        let id = "rest/heavier-sphere-struck";
        let note = "Give the speeds in exact form and the angle for *A* to 3 significant figures.";
        let table: [(&str, Edits, &str); 4] = [
            (id, &[], ""),
            (id, &[(note, "Give exact answers.")], "`direction of A` may be rounded there"),
            (id, &[(note, "Give exact answers, and angles to 3 significant figures.")], ""),
            (id, &[(note, "Give your answers in exact form, except for angles.")], ""),
        ];
        for (id, edits, words) in table {
            let said: String = unkept(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
