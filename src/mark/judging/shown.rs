//! Results that are printed in the question and are to be shown: never earned by the final line alone.
//!
//! What is written can be no more than partly right here, and that only if it shows a step: an equation that comes to
//! the printed one without being it, or a chain of equal things that ends in it. The working itself is judged elsewhere.

use crate::expr::Expr;
use crate::mark::reading::{Form, Reading, Statement};

use super::equation::{equations, same_solutions};
use super::exact::{Equality, same};
use super::finding::Finding;
use super::{Model, Note};

/// Judges a whole reading against a printed result.
pub(super) fn judge(model: &Model, reading: &Reading) -> Finding {
    let letters = &model.vocabulary.letters;
    let mut step = None;
    for statement in &reading.statements {
        for equation in equations(statement) {
            let follows = same_solutions(model, &equation) == Equality::Equal;
            if !follows && !is_identity(model, &equation) {
                return Finding::wrong(Note::WorkingUnjudged);
            }
            if follows && step.is_none() && !is_printed(model, &equation) {
                step = Some(Note::NotAsPrinted);
            }
        }
        if steps(model, statement) {
            step = Some(Note::WorkingUnjudged);
        }
    }
    let alone = |statement: &Statement| equations(statement).is_empty();
    if reading.statements.iter().all(alone) {
        // A value alone, where the result is an equation or where it is that value.
        let restated = reading.statements.iter().flat_map(|statement| &statement.said).any(|said| match &said.form {
            Form::Value(expr) => same(&model.value, expr, letters) == Equality::Equal,
            _ => false,
        });
        return if restated { Finding::wrong(Note::Restated) } else { Finding::WRONG };
    }
    match step {
        Some(Note::NotAsPrinted) if reading.statements.len() > 1 => Finding::partial(Note::WorkingUnjudged),
        Some(note) => Finding::partial(note),
        None => Finding::wrong(Note::Restated),
    }
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
    let letters = &model.vocabulary.letters;
    let (Expr::Relation(left, _, right), Expr::Relation(one, _, two)) = (&model.value, equation) else { return false };
    let equal = |a: &Expr, b: &Expr| a == b || same(a, b, letters) == Equality::Equal;
    (equal(left, one) && equal(right, two)) || (equal(left, two) && equal(right, one))
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
