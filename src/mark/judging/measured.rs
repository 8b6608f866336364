//! The line from which an angle is measured, where words other than those after the value name it: `angle with the tangent =
//! 8.13°`, `8.13° between the path and the tangent`, `an angle with the tangent of 8.13°`.

use std::borrow::Cow;

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::reading::{Form, NamedLine, Reading, ReferenceLine, Said, Statement, named_line};
use crate::mechanics::Quantity;

use super::{Model, selection};

/// The reading with those lines beside the values, and whether one of them is such that only a person can tell how it lies.
pub(super) fn from_named_lines<'r>(model: &Model, reading: &'r Reading) -> (Cow<'r, Reading>, bool) {
    let is_of_angle = matches!(model.kind, Kind::Angle | Kind::Velocity);
    if !is_of_angle && !matches!(model.quantity, Some(Quantity::Speed(..))) {
        return (Cow::Borrowed(reading), false);
    }
    let lines: Vec<Option<NamedLine>> = reading.statements.iter().map(|statement| line_of(model, statement)).collect();
    let is_direction = |statement: &Statement| line_alone(statement).is_some();
    if lines.iter().all(Option::is_none) && !reading.statements.iter().any(is_direction) {
        return (Cow::Borrowed(reading), false);
    }
    let mut statements: Vec<Statement> = Vec::with_capacity(reading.statements.len());
    let mut is_unknown = false;
    for (mut statement, line) in reading.statements.iter().cloned().zip(lines) {
        let is_free = |said: &&mut Said| said.reference.is_none() && is_angle(model, said);
        for said in statement.said.iter_mut().filter(is_free) {
            match line {
                Some(NamedLine::Known(line)) => said.reference = Some(line),
                Some(NamedLine::Unknown) => is_unknown = true,
                None => {}
            }
        }
        // `an angle with the tangent of 8.13°`
        if let ([first, ..], Some(line)) = (statement.said.as_mut_slice(), statements.last().and_then(line_alone))
            && statement.label.is_none()
            && first.reference.is_none()
            && is_angle(model, first)
        {
            first.reference = Some(line);
            statement.label = statements.pop().and_then(|before| before.label);
        }
        statements.push(statement);
    }
    (Cow::Owned(Reading { statements, ..reading.clone() }), is_unknown)
}

/// The line that a statement names and from which it measures nothing itself.
fn line_alone(statement: &Statement) -> Option<ReferenceLine> {
    match statement.said.as_slice() {
        [Said { form: Form::Direction, reference: Some(line), .. }] if !line.is_direction() => Some(*line),
        _ => None,
    }
}

/// The line that a statement's label names, or the words between which its angle lies.
fn line_of(model: &Model, statement: &Statement) -> Option<NamedLine> {
    let vectors = model.vocabulary.vectors;
    let label = statement.label.as_ref().filter(|label| !matches!(label.expr, Some(Expr::Call(..))));
    let remarks = || statement.remarks();
    let lies_between = remarks().any(|remark| remark.contains("between"));
    let remarks = remarks().filter(|_| lies_between);
    let words = label.map(|label| label.typed.as_str()).into_iter().chain(remarks.map(String::as_str));
    words.filter_map(|words| named_line(words, vectors)).next()
}

fn is_angle(model: &Model, said: &Said) -> bool {
    let is_bare = model.kind == Kind::Angle && said.unit.is_none();
    matches!(said.form, Form::Value(_)) && (is_bare || selection::is_angular(said))
}
