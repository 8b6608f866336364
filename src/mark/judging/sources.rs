//! Where a value comes from, told behind it: `5 J (33.5 before, 28.5 after)`, `8.54 (8 along, 3 perp)`.

use crate::mark::reading::{Form, Statement};
use crate::mechanics::Quantity;

use super::Model;
use super::moments::{EARLIER, LATER};
use super::otherwise::{DIRECTED, PARTS};
use super::selection::says;
use super::sorts::is_of_change;
use super::statements::is_rival;

/// The first value without those behind it of which it comes: all of them are of another moment or are components.
pub(super) fn without_its_sources(model: &Model, mut statements: Vec<Statement>) -> Vec<Statement> {
    let [first, rest @ ..] = statements.as_slice() else { return statements };
    let Some(asked) = model.quantity.map(Quantity::of_its_impact).filter(|_| !rest.is_empty()) else {
        return statements;
    };
    let is_value = |statement: &Statement| {
        statement.said.iter().all(|said| matches!(said.form, Form::Value(_)) && !is_rival(said))
    };
    let are_sources = match asked {
        Quantity::Deflection(_) | Quantity::SignedDeflection(_) => are_before_and_after(first, rest),
        _ if is_of_change(asked) => are_before_and_after(first, rest),
        Quantity::Speed(..) => are_components(model, first, rest),
        _ => false,
    };
    if are_sources && statements.iter().all(is_value) {
        statements.truncate(1);
    }
    statements
}

/// What there is before an impact and what there is after it, and nothing else.
fn are_before_and_after(first: &Statement, rest: &[Statement]) -> bool {
    let is_of = |statement: &Statement| (says(statement, &EARLIER), says(statement, &LATER));
    let moments: Vec<(bool, bool)> = rest.iter().map(is_of).collect();
    is_of(first) == (false, false)
        && moments.iter().all(|(is_earlier, is_later)| is_earlier != is_later)
        && moments.contains(&(true, false))
        && moments.contains(&(false, true))
}

/// Components, each with its direction, or all of them together. One alone may be the speed along a line of a sphere that
/// moves along it.
fn are_components(model: &Model, first: &Statement, rest: &[Statement]) -> bool {
    let is_directed = |statement: &Statement| {
        let has_line = statement.said.iter().any(|said| said.reference.is_some_and(|line| line.is_direction()));
        has_line || says(statement, &DIRECTED) || says(statement, &PARTS)
    };
    let are_told_together = rest.first().is_some_and(|first| says(first, &PARTS));
    let is_component = |statement: &Statement| is_directed(statement) || are_told_together && statement.label.is_none();
    let is_along_none = || model.path.as_ref().is_some_and(|path| !path.is_zero());
    !is_directed(first) && rest.iter().all(is_component) && (rest.len() > 1 || is_along_none())
}
