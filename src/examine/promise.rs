//! Do the answers of a variant keep what the question promises of their form?
//!
//! A friendly or exact style promises numbers that can be written down exactly; so does the rule `exact` in every style.
//! 'In terms of *m*' promises an answer with that letter in it.

use super::remark::Remark;
use super::words::unit_asked;
use crate::answer::{Accept, Kind};
use crate::bank::{Answer, Question, StyleName};
use crate::expr::{Expr, Piece, Text, print};
use crate::generate::{Form, Variant};
use crate::paper::Words;

/// What the answers of a variant do not keep.
pub fn broken(question: &Question, variant: &Variant, words: &Words, remarks: &mut Vec<Remark>) {
    for answer in question.parts.iter().flat_map(|part| &part.answers).filter(|answer| answer.kind != Kind::Line) {
        let is_angle = || answer.find.quantities().iter().any(|of| variant.solution.known().direction(*of).is_some());
        let promised = match (answer.accept(variant.style), variant.style) {
            (Accept::Exact, _) => "the rule `exact` promises an exact value",
            (_, StyleName::Friendly | StyleName::Exact) if !is_angle() => "the style promises an exact value",
            _ => continue,
        };
        if Form::of_answer(answer, &variant.solution) == Some(Form::Decimal) {
            let what = format!("the answer `{}` has no short exact form", answer.find.name());
            let help = "require simpler numbers, or move the style's numbers to `[style.calculator]` with `awrt 3sf`";
            remarks.push(Remark::new(what, format!("\"{}\"", answer.find.name()), promised, help));
        }
    }
    for (part, ask) in question.parts.iter().zip(&words.asks) {
        let answers: Vec<&Answer> = part.answers.iter().collect();
        let named = in_terms(ask, &answers, variant, remarks);
        beyond(&named, &answers, variant, remarks);
        in_a_unit(ask, &answers, variant, remarks);
    }
    let all: Vec<&Answer> = question.parts.iter().flat_map(|part| &part.answers).collect();
    for paragraph in &words.stem {
        in_terms(paragraph, &all, variant, remarks);
    }
}

/// A letter after 'in terms of' must stand in one of the answers at least; all such letters.
fn in_terms(text: &Text, answers: &[&Answer], variant: &Variant, remarks: &mut Vec<Remark>) -> Vec<String> {
    let mut is_listing = false;
    let mut named = Vec::new();
    for piece in &text.0 {
        match piece {
            Piece::Words(words) => {
                let goes_on = matches!(words.trim(), "and" | "," | ", and");
                is_listing = words.trim_end().ends_with("in terms of") || (is_listing && goes_on);
            }
            Piece::Formula(Expr::Name(name)) if is_listing && !matches!(name.text.as_str(), "i" | "j") => {
                named.push(name.text.clone());
                let has = |answer: &&Answer| letters(answer, variant).contains(&name.text);
                if !answers.iter().any(has) {
                    let what = format!("an answer is asked for in terms of `{}` and does not have it", name.text);
                    let label = "no answer has the letter";
                    let help = "take the letter out of the words, or give it in `[scene]`";
                    remarks.push(Remark::new(what, "in terms of {", label, help));
                }
            }
            _ => is_listing = false,
        }
    }
    named
}

/// Where letters are named in which answers are asked for, these have no other.
fn beyond(named: &[String], answers: &[&Answer], variant: &Variant, remarks: &mut Vec<Remark>) {
    let open = answers.iter().filter(|answer| !matches!(answer.kind, Kind::Shown | Kind::Range));
    for answer in open.filter(|_| !named.is_empty()) {
        if let Some(other) = letters(answer, variant).into_iter().find(|letter| !named.contains(letter)) {
            let find = answer.find.name();
            let what = format!(
                "the answer `{find}` has the letter `{other}`, and is asked for in terms of `{}`",
                named.join("`, `")
            );
            let help = "name all letters that the answer has, or give the letter a value";
            remarks.push(Remark::new(what, format!("in terms of {{{}", named[0]), "not all letters are named", help));
        }
    }
}

/// What is asked for in a unit is a number, and has no letter.
fn in_a_unit(text: &Text, answers: &[&Answer], variant: &Variant, remarks: &mut Vec<Remark>) {
    let asked = print::text_unicode(text);
    let Some((unit, _)) = unit_asked(&asked).filter(|_| !asked.contains("in terms of")) else { return };
    if let Some(letter) = answers.iter().find_map(|answer| letters(answer, variant).into_iter().next()) {
        let what = format!("an answer with the letter `{letter}` is asked for in `{unit}`");
        let help = format!("ask for it in terms of `{letter}`, or give the letter a value");
        remarks.push(Remark::new(what, format!("in {unit}"), "it has a letter", help));
    }
}

/// The letters of an answer; of a letter that is to be found no more is known than that it has a value.
fn letters(answer: &Answer, variant: &Variant) -> Vec<String> {
    let solution = &variant.solution;
    let mut found = Vec::new();
    for quantity in answer.find.quantities() {
        let number = solution.number(quantity).map(|value| value.letters());
        let letters = number.or_else(|| solution.angle(quantity).map(|angle| angle.letters())).unwrap_or_default();
        found.extend(letters.iter().filter(|letter| !letter.is_constant()).map(|letter| letter.name().to_owned()));
    }
    if let crate::bank::Find::Unknown(name) = &answer.find {
        let values = solution.found().iter().filter(|(letter, _)| letter.name() == name);
        let letters = values.flat_map(|(_, value)| value.letters()).filter(|letter| !letter.is_constant());
        found.extend(letters.map(|letter| letter.name().to_owned()));
    }
    found
}
