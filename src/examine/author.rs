//! The answers that the author of a question has worked out, compared with what Carom finds: marked as a student's.

use serde_json::Value as Json;

use super::finding::Finding;
use crate::answer::{Accept, Kind};
use crate::bank::{AuthorsTest, Question, Unposed};
use crate::expr::{Angles, Expr, print, read_as_written};
use crate::generate::with_numbers;
use crate::mark::AnswerKey;
use crate::mark::judging::{Model, Note, Verdict, judge};
use crate::mark::reading::read_answer;
use crate::number::{Fraction, Places, round};
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
    let text = serde_json::to_string(&Key::new(String::new(), None, vec![keyed.clone()])).unwrap_or_default();
    let Ok(key) = AnswerKey::read(&text) else { return one("its key cannot be read back".to_owned()) };
    let blanks = || key.papers.iter().flat_map(|paper| &paper.questions).flat_map(|question| &question.parts);
    let mut findings = Vec::new();
    for (name, answer) in &test.answers {
        let Some(blank) = blanks().flat_map(|part| &part.blanks).find(|blank| blank.find.name() == *name) else {
            continue;
        };
        let is_right = worked_out(&blank.model, answer);
        let exact = keyed.parts.iter().flat_map(|part| &part.blanks).find(|own| first(&own.find) == Some(name));
        let is_near = exact.is_none_or(|exact| is_as_near_as_it_claims(answer, &exact.decimal));
        if !is_right || !is_near {
            let found = comes_to(&print::unicode(&blank.model.value), exact.and_then(|exact| exact.decimal.as_str()));
            let message = format!("test {} fails: `{name}` is `{answer}` in it, and comes to `{found}`", place + 1);
            let help = "work it out again: either the answer is wrong or the scene is not the one that was meant";
            let found = Finding::new(message, format!("\"{answer}\""), "worked out here").with_help(help);
            findings.push(Finding { within: Some(test.span.clone()), ..found });
        }
    }
    findings
}

/// Is it what an author has worked out? Of a result that is printed, which earns a student nothing, the whole equation or its
/// right side.
fn worked_out(model: &Model, answer: &str) -> bool {
    let is_right = |model: &Model| {
        let judgement = judge(model, &read_answer(answer, &model.vocabulary));
        // A test is of the value: students are asked for exact form, and who has worked it out with a calculator is not.
        judgement.verdict == Verdict::Correct || judgement.note == Some(Note::ExactWanted.tag())
    };
    let as_asked = |value: &Expr, kind| Model::new(value.clone(), kind, Accept::Exact, model.vocabulary.clone());
    match &model.value {
        _ if model.kind != Kind::Shown => is_right(model),
        Expr::Relation(_, _, right) => {
            is_right(&as_asked(&model.value, Kind::Equation)) || is_right(&as_asked(right, Kind::Expression))
        }
        value => is_right(&as_asked(value, Kind::Expression)),
    }
}

/// A value as it is shown to its author: with decimals beside a formula, and an angle in degrees.
fn comes_to(value: &str, decimal: Option<&str>) -> String {
    let is_plain = value.chars().all(|sign| sign.is_ascii_digit() || "./−-".contains(sign));
    let places = Places::SignificantFigures(5);
    match decimal.and_then(|decimal| decimal.parse().ok()).filter(|_| !is_plain) {
        Some(decimal) => format!("{} ≈ {}", value.trim_end_matches("/1°"), round(&decimal, &places)),
        None => value.to_owned(),
    }
}

/// What is found, of a vector its first component.
fn first(find: &Json) -> Option<&str> {
    find.as_str().or_else(|| find.get(0)?.as_str())
}

/// A student's 7.499 may be accepted for 7.5; an author's says that it is not 7.5. So each decimal number of a test is
/// what its last digit claims. `exact` is the value to fifteen figures, of a vector a list of two.
fn is_as_near_as_it_claims(answer: &str, exact: &Json) -> bool {
    let Ok(written) = read_as_written(answer, Angles::Degrees) else { return true };
    let exact = match exact {
        Json::Array(both) => both.iter().map(Json::as_str).collect(),
        one => vec![one.as_str()],
    };
    match (decimals(&written), exact.as_slice()) {
        (Some(claimed), [Some(exact)]) if claimed.len() == 1 => is_near(claimed[0], exact),
        (Some(claimed), [Some(x), Some(y)]) if claimed.len() == 2 => is_near(claimed[0], x) && is_near(claimed[1], y),
        _ => true,
    }
}

/// Is a value what a number with decimals claims? Whether its sign is right has been judged.
fn is_near(claimed: Option<&str>, exact: &str) -> bool {
    let Some(claimed) = claimed else { return true };
    let (Ok(value), Ok(exact)) = (claimed.parse::<Fraction>(), exact.parse::<Fraction>()) else { return true };
    let places = claimed.split_once('.').map_or(0, |(_, digits)| digits.len());
    let half = (0..places).fold(Fraction::new(1, 2), |half, _| half * Fraction::new(1, 10));
    // The fifteenth figure may have been rounded.
    (exact.abs() - value.abs()).abs() <= half + Fraction::new(1, 1_000_000_000)
}

/// The number that an answer is, or its two components along **i** and **j**; none for one without decimals.
fn decimals(expr: &Expr) -> Option<Vec<Option<&str>>> {
    fn one(expr: &Expr) -> Option<Option<&str>> {
        decimals(expr)?.first().copied()
    }
    Some(match expr {
        Expr::Decimal(text) => vec![Some(text)],
        Expr::Negative(inner) | Expr::Degrees(inner) => decimals(inner)?,
        Expr::Number(_) => vec![None],
        Expr::Vector(x, y) => vec![one(x)?, one(y)?],
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::edited;

    #[test]
    fn a_number_of_the_author_is_what_its_digits_claim() {
        for (answer, exact, is_near) in [
            ("7.5", "7.50000000000000", true),
            ("7.499", "7.50000000000000", false),
            ("7.5001", "7.50000000000000", false),
            ("2.78", "2.77555756156289", true),
            ("-2.78", "-2.77555756156289", true),
            ("2.780", "2.77555756156289", false),
            ("46.1", "46.1021137519840", true),
            ("15/2", "7.50000000000000", true),
            ("0.33*u", "0.333333333333333", true),
        ] {
            assert_eq!(is_as_near_as_it_claims(answer, &exact.into()), is_near, "{answer}");
        }
        let vector = serde_json::json!(["2.25000000000000", "-1.33333333333333"]);
        assert!(is_as_near_as_it_claims("[2.25, -1.33]", &vector));
        assert!(!is_as_near_as_it_claims("[2.251, -1.33]", &vector));
    }

    #[test]
    fn a_test_is_of_the_value_though_students_are_asked_for_exact_form() {
        for (answer, is_it) in [("4*sqrt(39)/9", true), ("2.78", true), ("2.7756", true), ("2.77", false)] {
            let test =
                format!("[[test]]\nstyle = \"exact\"\nanswers = {{ \"A.after.speed\" = \"{answer}\" }}\n\n[reference]");
            let question = edited("rest/speeds-and-directions", &[("[reference]", &test)]);
            assert_eq!(disagreements(&question).is_empty(), is_it, "{answer}");
        }
    }

    #[test]
    fn a_result_that_is_shown_is_the_equation_or_its_right_side() {
        for (answer, is_it) in [
            ("2tan(alpha)/(1-e)", true),
            ("tan(beta) = 2tan(alpha)/(1-e)", true),
            ("tan(alpha)/(1-e)", false),
            ("tan(beta) = 2tan(alpha)/(1+e)", false),
        ] {
            let test = format!("[[test]]\nanswers = {{ \"A.after.t_over_n\" = \"{answer}\" }}\n\n[reference]");
            let question = edited("rest-letters/direction-and-deflection", &[("[reference]", &test)]);
            assert_eq!(disagreements(&question).is_empty(), is_it, "{answer}");
        }
    }
}
