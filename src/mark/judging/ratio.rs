//! Ratios, free of scale: `2 : 3`, `4 : 6` and `2/3` are one.

use crate::expr::{Expr, Meaning, written};
use crate::mark::reading::{Form, Said};

use super::accuracy::Written;
use super::finding::Finding;
use super::{Model, Note, number};

/// Judges one value against a ratio: the model is a quotient, or its two terms as `[2, 3]`.
pub(super) fn judge(model: &Model, said: &Said) -> Finding {
    let right = match model.known().meaning() {
        Some(Meaning::Vector(first, second)) => match first.divided_by(second) {
            Some(quotient) => written(&quotient),
            None => return Finding::unreadable(Note::CannotBeCompared),
        },
        _ => model.value.clone(),
    };
    let found = match &said.form {
        Form::Ratio(first, second) if second.is_zero() || first.is_zero() => return Finding::WRONG,
        Form::Ratio(first, second) => first.clone().over(second.clone()),
        Form::Value(expr) => expr.clone(),
        Form::Percentage(expr) => expr.clone().over(Expr::integer(100)),
        _ => return Finding::WRONG,
    };
    let model = model.of_value(right);
    let finding = number::value(&model, &found, &Written::of(&found));
    if said.unit.is_some() { finding.spoilt_by(Note::UnitNotNeeded) } else { finding }
}
