//! The answers that the author of a question has worked out, compared with what Carom finds: marked as a student's.

use super::finding::Finding;
use crate::bank::{AuthorsTest, Question, Unposed};
use crate::expr::print;
use crate::generate::with_numbers;
use crate::mark::AnswerKey;
use crate::mark::judging::{Verdict, judge};
use crate::mark::reading::read_answer;
use crate::paper::{Key, compose, key_question};

/// Every test of the author that fails.
pub fn disagreements(question: &Question) -> Vec<Finding> {
    question.tests.iter().enumerate().flat_map(|(place, test)| of_test(question, place, test)).collect()
}

fn of_test(question: &Question, place: usize, test: &AuthorsTest) -> Vec<Finding> {
    let one = |message: String| {
        let found = Finding::new(format!("test {} fails: {message}", place + 1), "", "these are its numbers");
        let help = "give it numbers with which the collision is possible, in `numbers`";
        vec![Finding { within: Some(test.span.clone()), ..found.with_help(help) }]
    };
    let style = &question.styles[test.style];
    let variant = match with_numbers(question, style, &test.numbers) {
        Ok(variant) => variant,
        Err(Unposed::Refused(refusal)) => return one(format!("its numbers are refused, since {}", refusal.reason)),
        Err(_) => return one("a formula has no value with its numbers".to_owned()),
    };
    let printed = compose(question, &variant, 1);
    let keyed = key_question(question, &variant, &printed);
    let text = serde_json::to_string(&Key::new(String::new(), None, vec![keyed])).unwrap_or_default();
    let Ok(key) = AnswerKey::read(&text) else { return one("its key cannot be read back".to_owned()) };
    let blanks = || key.papers.iter().flat_map(|paper| &paper.questions).flat_map(|question| &question.parts);
    let mut findings = Vec::new();
    for (name, answer) in &test.answers {
        let Some(blank) = blanks().flat_map(|part| &part.blanks).find(|blank| blank.find.name() == *name) else {
            continue;
        };
        let judged = judge(&blank.model, &read_answer(answer, &blank.model.vocabulary));
        if judged.verdict != Verdict::Correct {
            let found = print::unicode(&blank.model.value);
            let message = format!("test {} fails: `{name}` is `{answer}` in it, and comes to `{found}`", place + 1);
            let help = "work it out again: either the answer is wrong or the scene is not the one that was meant";
            let found = Finding::new(message, format!("\"{answer}\""), "worked out here").with_help(help);
            findings.push(Finding { within: Some(test.span.clone()), ..found });
        }
    }
    findings
}
