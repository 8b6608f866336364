//! The reference numbers of a question: do they make one, does the key that is printed of it lead to the same answers
//! again, and does no answer hang on the last figure?

use serde_json::Value as Json;

use super::finding::Finding;
use crate::answer::Kind;
use crate::bank::Question;
use crate::expr::{Angles, print};
use crate::generate::{answer_rounds_safely, reference};
use crate::mechanics::Scene;
use crate::number::{Places, round};
use crate::paper::{KeyQuestion, compose, key_question};
use crate::solve::solve;

/// What is amiss with the reference numbers.
pub fn reference_faults(question: &Question) -> Vec<Finding> {
    let one = |message: String| Finding::new(message, "[reference]", "with these numbers");
    let Ok(variant) = reference(question) else {
        return vec![one("the reference numbers make no question".to_owned())];
    };
    let printed = compose(question, &variant, 1);
    let key = key_question(question, &variant, &printed);
    let mut findings: Vec<Finding> = again(question, &key).into_iter().map(one).collect();
    let blanks = key.parts.iter().flat_map(|part| &part.blanks);
    for (answer, blank) in question.parts.iter().flat_map(|part| &part.answers).zip(blanks) {
        if !answer_rounds_safely(answer, variant.style, &variant.solution) {
            let message = format!("`{}` of the reference is too near a tie to be rounded", answer.find.name());
            let help = "change a number, or ask for another accuracy with `accept`";
            let long = blank.decimal.as_str().and_then(|decimal| decimal.parse().ok());
            let label = long.map(|long| format!("it comes to {}", round(&long, &Places::SignificantFigures(8))));
            let found = one(message).with_help(help);
            findings.push(Finding { label: label.unwrap_or(found.label.clone()), ..found });
        }
    }
    findings
}

/// Solves the scene of a key by itself; what is not as in the key.
fn again(question: &Question, key: &KeyQuestion) -> Option<String> {
    let Ok(scene) = Scene::read(&key.scene, &(), Angles::Radians) else {
        return Some("the scene of its key cannot be read".to_owned());
    };
    let solution = match solve(&scene, &question.asked()) {
        Ok(solution) => solution,
        Err(refusal) => return Some(format!("the scene of its key is refused: {refusal}")),
    };
    for (part, printed) in question.parts.iter().zip(&key.parts) {
        for (answer, blank) in part.answers.iter().zip(&printed.blanks) {
            let exact = answer.find.quantities().into_iter().filter_map(|quantity| solution.exchange(quantity));
            let found: Vec<String> = exact.map(|exact| print::plain(&exact)).collect();
            let found = match solution.range().filter(|_| answer.kind == Kind::Range) {
                Some(values) => vec![print::plain(&values.written())],
                None => found,
            };
            let held: Vec<&str> = match &blank.exact {
                Json::Array(list) => list.iter().filter_map(Json::as_str).collect(),
                one => one.as_str().into_iter().collect(),
            };
            if !found.is_empty() && found != held {
                let (held, found) = (held.join(", "), found.join(", "));
                return Some(format!("{} is {held} in the key and {found} by its scene", blank.name));
            }
        }
    }
    None
}
