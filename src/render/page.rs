//! The page: what a template sees of a paper, every formula printed in the notation of the format.
//!
//! `templates/README.md` lists these names for those who write templates; a test compares the two.
//! Fields of type [`Value`] are printed already and are not escaped again; `String`s are escaped.

use serde::Serialize;
use tera::Value;

use super::{Notation, PageNames};
use crate::expr::{Expr, Piece, Relation, Text};
use crate::paper::{Paper, PrintedAnswer, PrintedPart, PrintedQuestion, SchemeRow, WorkingLine};
use crate::unit::Unit;

/// A paper. Words that were not given are empty; so is the seed of the reference paper.
#[derive(Serialize)]
pub(super) struct Page {
    title: String,
    school: String,
    date: String,
    seed: String,
    marks: usize,
    questions: Vec<Question>,
}

#[derive(Serialize)]
struct Question {
    number: usize,
    id: String,
    mirrors: String,
    stem: Vec<Value>,
    parts: Vec<Part>,
    marks: usize,
}

#[derive(Serialize)]
struct Part {
    label: String,
    ask: Value,
    answers: Vec<Answer>,
    working: Vec<Line>,
    scheme: Vec<Mark>,
    marks: usize,
}

/// The unit stands with the last of the two forms, as it is written by hand: `4√39/9 ≈ 2.78 m s⁻¹`.
#[derive(Serialize)]
struct Answer {
    name: Value,
    exact: Value,
    rounded: Value,
    phrase: Value,
}

#[derive(Serialize)]
struct Line {
    words: Value,
    equations: Vec<Equation>,
    label: String,
}

/// An equation whole, and in three pieces for columns; what is no equation stands in `right` alone.
///
/// In a chain a left side that is the same as the one above it is left out of the pieces.
#[derive(Serialize)]
struct Equation {
    whole: Value,
    left: Value,
    relation: Value,
    right: Value,
}

#[derive(Serialize)]
struct Mark {
    id: String,
    code: String,
    earned: Value,
    equation: Value,
    note: Value,
    depends: Vec<String>,
}

/// The page of a paper.
pub(super) fn page(paper: &Paper, notation: Notation) -> Page {
    Page {
        title: paper.title.clone(),
        school: paper.school.clone(),
        date: paper.date.clone(),
        seed: paper.seed.map(|seed| seed.to_string()).unwrap_or_default(),
        marks: paper.marks(),
        questions: paper.questions.iter().map(|question| question_on(question, notation)).collect(),
    }
}

/// The names at the top of every page.
pub(super) fn names() -> PageNames {
    let nothing =
        Paper { title: String::new(), school: String::new(), date: String::new(), seed: None, questions: Vec::new() };
    match serde_json::to_value(page(&nothing, Notation::Unicode)) {
        Ok(serde_json::Value::Object(fields)) => fields.into_iter().map(|(name, _)| name).collect(),
        _ => PageNames::new(),
    }
}

fn question_on(question: &PrintedQuestion, notation: Notation) -> Question {
    Question {
        number: question.number,
        id: question.id.clone(),
        mirrors: question.mirrors.clone().unwrap_or_default(),
        stem: question.stem.iter().map(|paragraph| words(paragraph, notation)).collect(),
        parts: question.parts.iter().map(|part| part_on(part, notation)).collect(),
        marks: question.marks(),
    }
}

fn part_on(part: &PrintedPart, notation: Notation) -> Part {
    Part {
        label: part.label.clone(),
        ask: words(&part.ask, notation),
        answers: part.answers.iter().map(|answer| answer_on(answer, notation)).collect(),
        working: part.working.iter().map(|line| line_on(line, notation)).collect(),
        scheme: part.scheme.iter().map(|row| mark_on(row, notation)).collect(),
        marks: part.marks(),
    }
}

fn answer_on(answer: &PrintedAnswer, notation: Notation) -> Answer {
    let quantity = |value: &Expr| words(&Text(vec![Piece::Quantity(value.clone(), answer.unit)]), notation);
    let formula = |value: &Expr| words(&Text(vec![Piece::Formula(value.clone())]), notation);
    let (exact, rounded) = match &answer.rounded {
        Some(rounded) => (formula(&answer.exact), quantity(rounded)),
        // 60° is an angle without our help
        None if matches!(answer.exact, Expr::Degrees(_)) && answer.unit == Unit::Degree => {
            (formula(&answer.exact), nothing())
        }
        None => (quantity(&answer.exact), nothing()),
    };
    Answer { name: words(&answer.name, notation), exact, rounded, phrase: words(&answer.phrase, notation) }
}

fn line_on(line: &WorkingLine, notation: Notation) -> Line {
    let mut above = None;
    let mut equations = Vec::with_capacity(line.equations.len());
    for equation in &line.equations {
        let sides = sides(equation);
        let left = sides.as_ref().map(|(left, _, _)| (*left).clone());
        equations.push(match sides {
            Some((left, relation, right)) => Equation {
                whole: formula(equation, notation),
                left: if above.as_ref() == Some(left) { nothing() } else { formula(left, notation) },
                relation: Value::safe_string(notation.relation(relation)),
                right: formula(&right, notation),
            },
            None => {
                let whole = formula(equation, notation);
                Equation { whole: whole.clone(), left: nothing(), relation: nothing(), right: whole }
            }
        });
        above = left;
    }
    Line {
        words: words(&line.words, notation),
        equations,
        label: line.label.map(|label| label.to_string()).unwrap_or_default(),
    }
}

fn mark_on(row: &SchemeRow, notation: Notation) -> Mark {
    Mark {
        id: row.id.clone(),
        code: row.code.clone(),
        earned: words(&row.earned, notation),
        equation: row.equation.as_ref().map_or_else(nothing, |equation| formula(equation, notation)),
        note: words(&row.note, notation),
        depends: row.depends.clone(),
    }
}

/// What stands left of the first relation of an equation, that relation, and all the rest.
///
/// `(a = b) ⇒ (c = d)` is read as `a` | `=` | `b ⇒ c = d`, so that it aligns with the equations around it.
fn sides(equation: &Expr) -> Option<(&Expr, Relation, Expr)> {
    let Expr::Relation(left, relation, right) = equation else { return None };
    match sides(left) {
        Some((first, inner, rest)) => Some((first, inner, Expr::Relation(Box::new(rest), *relation, right.clone()))),
        None => Some((left, *relation, (**right).clone())),
    }
}

fn words(text: &Text, notation: Notation) -> Value {
    Value::safe_string(&notation.text(text))
}

fn formula(value: &Expr, notation: Notation) -> Value {
    Value::safe_string(&notation.formula(value))
}

fn nothing() -> Value {
    Value::safe_string("")
}
