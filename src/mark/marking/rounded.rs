//! Answers that are a decimal of the working, rounded: `√(1.87² + 2²) = 2.74`, and then 2.7.

use super::memory::Lines;
use crate::expr::Expr;
use crate::mark::judging::{is_nearly_rounding, is_rounding};
use crate::mark::key::KeyedPart;
use crate::mark::reading::{Form, Reading, Said, Statement};
use crate::mark::script::PartScript;
use crate::mark::working::typed_lines;

/// The decimal in which the working of an answer ends, as it stands there, where the answer is that rounded as it should be.
pub(super) fn rounded_from(
    part: &KeyedPart,
    place: usize,
    readings: &[Reading],
    script: &PartScript,
    lines: &Lines,
) -> Option<String> {
    let answer = readings.first()?.statements.last()?.said.last()?;
    let may_be_of = |statement: &&Statement| {
        let is_worked_out = statement.said.len() > 1;
        is_worked_out || statement.label.is_none() || part.calls(place, statement)
    };
    let value = |line: &str| {
        let readings = lines.read(line, &part.blanks[place].model.vocabulary);
        let statements = &readings.as_ref().as_ref().ok()?.first()?.statements;
        let mut ends = statements.iter().rev().filter(may_be_of).filter_map(|statement| statement.said.last());
        ends.find(|said| is_nearly_rounding(said, answer)).cloned()
    };
    let value = typed_lines(&script.working).rev().find_map(value);
    value.filter(|value| is_rounding(value, answer)).as_ref().and_then(decimal)
}

fn decimal(said: &Said) -> Option<String> {
    match &said.form {
        Form::Value(Expr::Decimal(text)) => Some(text.to_string()),
        _ => None,
    }
}
