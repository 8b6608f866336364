//! Ratios, free of scale: `2 : 3`, `4 : 6` and `2/3` are one.

use crate::expr::{Expr, Meaning, written};
use crate::mark::reading::{Form, Reading, Said};

use super::accuracy::Written;
use super::finding::Finding;
use super::statements::{pair, unnamed};
use super::{Model, Note, number};

/// Two numbers one after the other: `2 to 3`.
pub(super) fn of_its_terms(reading: &Reading) -> Option<Said> {
    let terms = pair(reading)?.map(|(statement, said)| {
        unnamed((statement, said)).filter(|_| said.unit.is_none()).map(|term| (term.clone(), said.remarks.clone()))
    });
    let [Some((first, mut remarks)), Some((second, more))] = terms else { return None };
    remarks.extend(more);
    Some(Said { form: Form::Ratio(first, second), unit: None, reference: None, remarks })
}

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
