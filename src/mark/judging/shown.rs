//! Results that are printed in the question and are to be shown: never earned by the final line alone.
//!
//! What is written can be no more than partly right here, and that only if it shows a step: an equation that comes to
//! the printed one without being it, or a chain of equal things that ends in it. The working itself is judged elsewhere.

use crate::expr::Expr;
use crate::mark::reading::{Form, Reading, Statement};

use super::as_printed::looks_like;
use super::equation::{equations, same_solutions};
use super::exact::{Equality, same};
use super::finding::Finding;
use super::{Model, Note};

/// Judges a whole reading against a printed result.
pub(super) fn judge(model: &Model, reading: &Reading) -> Finding {
    let mut step = None;
    let mut restated = false;
    for statement in &reading.statements {
        for equation in equations(statement) {
            let follows = same_solutions(model, &equation) == Equality::Equal;
            if !follows && !is_identity(model, &equation) {
                return Finding::wrong(Note::WorkingUnjudged);
            }
            match follows && is_printed(model, &equation) {
                true => restated = true,
                false if follows && step.is_none() => step = Some(Note::NotAsPrinted),
                false => {}
            }
        }
        if steps(model, statement) {
            step = Some(Note::WorkingUnjudged);
        }
    }
    let alone = |statement: &Statement| equations(statement).is_empty();
    if reading.statements.iter().all(alone) {
        return judge_alone(model, reading);
    }
    match step {
        Some(Note::NotAsPrinted) if reading.statements.len() > 1 => Finding::partial(Note::WorkingUnjudged),
        Some(note) => Finding::partial(note),
        None if restated => Finding::wrong(Note::Restated),
        // What is true of itself says nothing of the result.
        None => Finding::wrong(Note::WorkingUnjudged),
    }
}

/// Judges values without an equals sign: the right side of the result, or what comes to it.
fn judge_alone(model: &Model, reading: &Reading) -> Finding {
    let said = reading.statements.iter().flat_map(|statement| &statement.said);
    let values = said.filter_map(|said| match &said.form {
        Form::Value(expr) => Some(expr),
        _ => None,
    });
    let values: Vec<&Expr> = values.collect();
    let is_equal = |value: &&Expr| same(printed_value(model), value, &model.vocabulary.letters) == Equality::Equal;
    match () {
        () if values.iter().any(|value| is_printed_value(model, value)) => Finding::wrong(Note::Restated),
        () if values.iter().any(is_equal) => Finding::partial(Note::NotAsPrinted),
        () => Finding::WRONG,
    }
}

/// What is to be shown of the left side.
fn printed_value(model: &Model) -> &Expr {
    match &model.value {
        Expr::Relation(_, _, right) => right,
        value => value,
    }
}

/// Is it what is to be shown of the left side, as it is printed?
pub(in crate::mark) fn is_printed_value(model: &Model, value: &Expr) -> bool {
    looks_like(printed_value(model), value)
}

/// Is the equation true of itself, two ways of writing one side?
fn is_identity(model: &Model, equation: &Expr) -> bool {
    match equation {
        Expr::Relation(left, _, right) => same(left, right, &model.vocabulary.letters) == Equality::Equal,
        _ => false,
    }
}

/// Is it the printed equation, whichever side comes first?
fn is_printed(model: &Model, equation: &Expr) -> bool {
    let (Expr::Relation(left, _, right), Expr::Relation(one, _, two)) = (&model.value, equation) else { return false };
    (looks_like(left, one) && looks_like(right, two)) || (looks_like(left, two) && looks_like(right, one))
}

/// Is it a chain with a step between its ends: at least two things said that look different?
fn steps(model: &Model, statement: &Statement) -> bool {
    let mut looks: Vec<&Expr> = Vec::new();
    for said in &statement.said {
        if let Form::Value(expr) = &said.form
            && !looks.contains(&expr)
        {
            looks.push(expr);
        }
    }
    let sides = match &model.value {
        Expr::Relation(left, _, right) => [&**left, &**right],
        other => [other, other],
    };
    looks.retain(|expr| !sides.contains(expr));
    statement.said.len() > 1 && !looks.is_empty()
}
