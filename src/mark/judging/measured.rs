//! The line from which an angle is measured, where words other than those after the value name it: `angle with the tangent =
//! 8.13°`, `8.13° between the path and the tangent`, `an angle with the tangent of 8.13°`.

use std::borrow::Cow;

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::reading::{Form, NamedLine, Reading, Said, Statement, named_line};
use crate::mechanics::Quantity;

use super::{Model, selection};

/// The reading with those lines beside the values, and whether one of them is such that only a person can tell how it lies.
pub(super) fn from_named_lines<'r>(model: &Model, reading: &'r Reading) -> (Cow<'r, Reading>, bool) {
    let is_of_angle = matches!(model.kind, Kind::Angle | Kind::Velocity);
    if !is_of_angle && !matches!(model.quantity, Some(Quantity::Speed(..))) {
        return (Cow::Borrowed(reading), false);
    }
    let mut statements: Vec<Statement> = Vec::with_capacity(reading.statements.len());
    let mut is_unknown = false;
    for statement in &reading.statements {
        let mut statement = statement.clone();
        if let Some(line) = line_of(model, &statement) {
            let is_free = |said: &&mut Said| said.reference.is_none() && is_angle(model, said);
            for said in statement.said.iter_mut().filter(is_free) {
                match line {
                    NamedLine::Known(line) => said.reference = Some(line),
                    NamedLine::Unknown => is_unknown = true,
                }
            }
        }
        // `an angle with the tangent of 8.13°`
        if let ([first, ..], Some(before)) = (statement.said.as_mut_slice(), statements.last())
            && let [Said { form: Form::Direction, reference: Some(line), .. }] = before.said.as_slice()
            && !line.is_direction()
            && statement.label.is_none()
            && first.reference.is_none()
            && is_angle(model, first)
        {
            first.reference = Some(*line);
            statement.label = statements.pop().and_then(|before| before.label);
        }
        statements.push(statement);
    }
    let same = statements == reading.statements;
    let reading = if same { Cow::Borrowed(reading) } else { Cow::Owned(Reading { statements, ..reading.clone() }) };
    (reading, is_unknown)
}

/// The line that a statement's label names, or the words between which its angle lies.
fn line_of(model: &Model, statement: &Statement) -> Option<NamedLine> {
    let vectors = model.vocabulary.vectors;
    let label = statement.label.as_ref().filter(|label| !matches!(label.expr, Some(Expr::Call(..))));
    let remarks = || statement.said.iter().flat_map(|said| &said.remarks);
    let lies_between = remarks().any(|remark| remark.contains("between"));
    let remarks = remarks().filter(|_| lies_between);
    let words = label.map(|label| label.typed.as_str()).into_iter().chain(remarks.map(String::as_str));
    words.filter_map(|words| named_line(words, vectors)).next()
}

fn is_angle(model: &Model, said: &Said) -> bool {
    let is_bare = model.kind == Kind::Angle && said.unit.is_none();
    matches!(said.form, Form::Value(_)) && (is_bare || selection::is_angular(said))
}
