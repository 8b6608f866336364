//! The story of a question as JSON.

use serde_json::{Value as Json, json};

use super::mistakes::{LawMistakes, Mistake};
use super::{Reference, value_in_words};
use crate::bank::{Domain, Question, Style};
use crate::cli::check::StyleCount;
use crate::expr::print as written;
use crate::paper::PrintedPart;

/// Everything that `carom explain` says, but the example.
pub fn story(question: &Question, styles: &[StyleCount], known: Option<&Reference>) -> Json {
    let styles = question.styles.iter().zip(styles).map(|(style, counted)| of_style(question, style, counted));
    let mut story = json!({
        "id": question.id, "title": question.title, "mirrors": question.mirrors, "topic": question.topic,
        "marks": question.marks(), "erratum": question.erratum, "styles": styles.collect::<Vec<_>>(),
    });
    if let Some(Reference { variant, printed, mistakes }) = known {
        let numbers = question.reference.iter();
        let numbers = numbers.map(|(name, value)| json!({"name": name, "value": written::plain(value)}));
        story["reference"] = numbers.collect();
        let steps = variant.solution.steps().into_iter().map(|step| {
            let gives: Vec<String> = step.gives.iter().map(ToString::to_string).collect();
            json!({"law": step.law.name(), "gives": gives})
        });
        story["steps"] = steps.collect();
        story["parts"] = printed.parts.iter().map(of_part).collect();
        story["slips"] = mistakes.iter().flat_map(of_law).collect();
    }
    story
}

fn of_style(question: &Question, style: &Style, counted: &StyleCount) -> Json {
    let parameters = style.parameters.iter().map(|(name, domain)| {
        json!({
            "name": name, "count": domain.size(), "values": values(domain),
        })
    });
    let lets = style.lets.iter().map(|(name, expr)| json!({"name": name, "formula": written::plain(expr)}));
    let turned = counted.census.funnel(question, style).into_iter();
    let turned = turned.map(|(reason, count)| json!({"reason": reason, "count": count}));
    let mut whole = counted.json();
    whole["parameters"] = parameters.collect();
    whole["let"] = lets.collect();
    whole["require"] = style.require.iter().map(|requirement| json!(requirement.text)).collect();
    whole["turned_away"] = turned.collect();
    whole
}

/// The first thousand; a range may have more than anybody reads.
fn values(domain: &Domain) -> Vec<String> {
    (0..domain.size().min(1000)).map(|index| written::plain(&domain.value(index))).collect()
}

fn of_part(part: &PrintedPart) -> Json {
    let answers = part.answers.iter();
    let answers =
        answers.map(|answer| json!({"name": written::text_unicode(&answer.name), "value": value_in_words(answer)}));
    let marks = part.scheme.iter().map(|row| {
        json!({
            "code": row.code, "for": written::text_unicode(&row.in_one_line()), "note": written::text_unicode(&row.note),
            "depends": row.depends,
        })
    });
    json!({"label": part.label, "answers": answers.collect::<Vec<_>>(), "marks": marks.collect::<Vec<_>>()})
}

fn of_law(mistakes: &LawMistakes) -> Vec<Json> {
    let one = |Mistake { slip, leads_to, .. }: &Mistake| {
        let wrong = leads_to.iter().map(|wrong| {
            json!({"part": wrong.part, "answer": wrong.name, "values": wrong.values, "unit": wrong.unit.trim()})
        });
        json!({
            "law": mistakes.law.name(), "tag": slip.tag, "sentence": slip.sentence, "leads_to": wrong.collect::<Vec<_>>(),
        })
    };
    mistakes.slips.iter().map(one).collect()
}
