//! Answers as students type them, on a phone, from a calculator, in words, each with an examiner's verdict: the table is
//! `tests/data/as-students-type.toml`.

use std::fs;
use std::path::Path;

use carom::answer::{Accept, Kind};
use carom::mark::judging::{Model, ModelOptions, judge};
use carom::mark::reading::read_answer;
use carom::number::{Letter, Range};
use serde::Deserialize;

#[derive(Deserialize)]
struct Table {
    question: Vec<Question>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Question {
    model: String,
    kind: Option<String>,
    find: Option<String>,
    accept: Option<String>,
    #[serde(default)]
    letters: Vec<String>,
    answers: Vec<(String, String)>,
}

fn model(question: &Question) -> Model {
    let range = |name: &str| match name {
        "e" => Range::Unit,
        "theta" | "alpha" => Range::Acute,
        _ => Range::Positive,
    };
    let options = ModelOptions {
        kind: question.kind.as_ref().map(|name| Kind::ALL.iter().copied().find(|kind| kind.name() == name).unwrap()),
        accept: question.accept.as_ref().map(|rule| Accept::said(rule).unwrap()),
        letters: question.letters.iter().map(|name| Letter::new(name, range(name)).unwrap()).collect(),
        quantity: question.find.as_ref().map(|name| name.parse().unwrap()),
        letter: None,
    };
    Model::read(&question.model, &options).unwrap_or_else(|fault| panic!("{}: {fault:?}", question.model))
}

#[test]
fn answers_fare_as_an_examiner_would_have_it() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/as-students-type.toml"));
    let table: Table = toml::from_str(&text.unwrap()).unwrap();
    let count: usize = table.question.iter().map(|question| question.answers.len()).sum();
    assert!(count >= 150, "{count} answers");
    let mut faults = Vec::new();
    for question in &table.question {
        let model = model(question);
        for (answer, verdict) in &question.answers {
            let judged = judge(&model, &read_answer(answer, &model.vocabulary));
            if judged.verdict.name() != verdict {
                let (note, reading) = (judged.note.unwrap_or_default(), judged.reading.unwrap_or_default());
                let found = judged.verdict.name();
                faults.push(format!("`{answer}` for {}: {found} {note} [{reading}], not {verdict}", question.model));
            }
        }
    }
    assert!(faults.is_empty(), "{} of {count} differ:\n{}", faults.len(), faults.join("\n"));
}
