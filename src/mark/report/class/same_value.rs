//! One wrong value that many students give: a misreading that they share, or a fault of the question or of its key.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use super::entries::Class;
use crate::answer::Kind;
use crate::expr::print;
use crate::mark::award::MarkedAnswer;
use crate::mark::judging::Verdict;
use crate::mark::key::KeyedBlank;
use crate::mark::reading::{Form, read_answer};
use crate::mark::slips::value_at_first_point;

/// A wrong value and who gave it.
pub(super) struct SameValue {
    /// The label of the part, and the blank.
    pub part: String,
    pub blank: String,
    /// The value as most wrote it.
    pub value: String,
    /// What would have been right.
    pub right: String,
    /// How many gave it.
    pub students: usize,
    /// The likeliest mistake that leads there, by its tag; empty if none does.
    pub cause: String,
}

/// What is put in for a blank, apart from how it is written: two students of whom one has 2.31 and the other 2.310 m/s, or
/// its exact form, gave one value. The right answer belongs to it, since another sheet may have other numbers.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Given {
    part: String,
    blank: String,
    right: String,
    value: String,
}

/// Who gave it, how they wrote it and how often, and the mistake that leads there.
#[derive(Default)]
struct By {
    students: BTreeSet<usize>,
    ways: BTreeMap<String, usize>,
    cause: String,
}

/// More of a question are not told.
const MOST: usize = 3;

/// The wrong values of a question that so many students gave, the most frequent first.
pub(super) fn all(class: &Class, question: usize, least: usize) -> Vec<SameValue> {
    let mut found: BTreeMap<Given, By> = BTreeMap::new();
    for (student, script) in class.scripts(question) {
        for part in &script.parts {
            // A line for several blanks gives no single value.
            if !part.named && part.marked.answers.len() > 1 {
                continue;
            }
            for (blank, answer) in part.keyed.blanks.iter().zip(&part.marked.answers) {
                let Some((value, printed)) = value(blank, answer) else { continue };
                let right = right(blank);
                let given = Given { part: part.marked.label.clone(), blank: blank.name.clone(), right, value };
                let by = found.entry(given).or_default();
                by.students.insert(student);
                *by.ways.entry(printed).or_default() += 1;
                if let Some(first) = answer.causes.first().filter(|_| by.cause.is_empty()) {
                    by.cause.clone_from(&first.tag);
                }
            }
        }
    }
    let mut all: Vec<SameValue> = found
        .into_iter()
        .filter(|(_, by)| by.students.len() >= least)
        .map(|(Given { part, blank, right, .. }, By { students, ways, cause })| {
            // As most wrote it; of equally many the shortest.
            let way = ways.into_iter().max_by_key(|(value, count)| (*count, Reverse(value.len())));
            let value = way.map(|(value, _)| value).unwrap_or_default();
            SameValue { part, blank, value, right, students: students.len(), cause }
        })
        .collect();
    all.sort_by_key(|same| Reverse(same.students));
    all.truncate(MOST);
    all
}

/// What would have been right; an angle as a student would write it.
fn right(blank: &KeyedBlank) -> String {
    let degrees = || value_at_first_point(&blank.model.value, &[]);
    match (blank.model.kind == Kind::Angle).then(degrees).flatten() {
        Some(degrees) => format!("{degrees:.1}°"),
        None => print::unicode(&blank.model.value),
    }
}

/// A wrong answer as a value to three figures, and as it was written without its unit.
fn value(blank: &KeyedBlank, answer: &MarkedAnswer) -> Option<(String, String)> {
    // A result that is printed in the question is no wrong value, only not enough.
    if answer.judgement.verdict != Verdict::Wrong || blank.model.kind == Kind::Shown {
        return None;
    }
    let readings = read_answer(answer.typed.as_deref()?, &blank.model.vocabulary).ok()?;
    let said = readings.into_iter().next()?.statements.pop()?.said.pop()?;
    let letters = &blank.model.vocabulary.letters;
    let (kind, pieces) = match said.form {
        Form::Value(value) => ("", vec![value]),
        Form::Percentage(value) => ("%", vec![value]),
        Form::Ratio(one, two) => (":", vec![one, two]),
        Form::Vector(one, two, _) => ("i, j", vec![one, two]),
        _ => return None,
    };
    let values: Option<Vec<String>> =
        pieces.iter().map(|piece| value_at_first_point(piece, letters).map(|value| format!("{value:.2e}"))).collect();
    let printed: Vec<String> = pieces.iter().map(print::unicode).collect();
    let printed = match kind {
        "" => printed.concat(),
        "%" => format!("{}%", printed.concat()),
        ":" => printed.join(" : "),
        _ => format!("({})", printed.join(", ")),
    };
    Some((format!("{kind} {}", values?.join(", ")), printed))
}
