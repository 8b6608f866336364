//! Ratios, free of scale: `2 : 3`, `4 : 6` and `2/3` are one.
//!
//! Convention. Which sphere comes first is the question's to say, and the model does not repeat it. Where an answer names
//! both and puts A first, its numbers are taken as they are; with B first, or the other way up, only a person can tell.

use crate::expr::{Expr, Meaning, written};
use crate::mark::reading::{Form, Label, Reading, Said};
use crate::mechanics::{Quantity, Sphere};

use super::accuracy::Written;
use super::finding::Finding;
use super::otherwise::spheres_in_remark;
use super::sorts::{Sort, sort, words};
use super::spheres::{named_sphere, named_spheres};
use super::statements::{pair, unnamed};
use super::{Model, Note, number};

/// Two numbers one after the other, and what their ratio is called: `2 to 3`, `A to B is 2 to 3`, `the ratio is 2 to 3`.
pub(super) fn of_its_terms(reading: &Reading) -> Option<(Said, Option<Label>)> {
    let [(statement, first), second] = pair(reading)?;
    // `m_A = 2m, m_B = 3m`
    if let (Some(one), Some(other)) = (named_sphere(statement), named_sphere(second.0))
        && let (Form::Value(of_one), Form::Value(of_other)) = (&first.form, &second.1.form)
        && one != other
        && first.unit == second.1.unit
    {
        let is_usual = (one as usize) < other as usize;
        let (above, below) = if is_usual { (of_one, of_other) } else { (of_other, of_one) };
        let form = Form::Ratio(above.clone(), below.clone());
        let remarks = [first, second.1].into_iter().flat_map(|said| said.remarks.clone()).collect();
        let [first, second] = if is_usual { [one, other] } else { [other, one] };
        let label = Label { typed: format!("{} : {}", first.name(), second.name()), expr: None };
        return Some((Said { form, unit: None, reference: None, remarks }, Some(label)));
    }
    let is_ratio = |label: &Label| {
        named_spheres(&label.typed).len() == 2 || words(&label.typed).any(|word| word.eq_ignore_ascii_case("ratio"))
    };
    let label = statement.label.clone().filter(is_ratio);
    let first_term = match (&label, &first.form) {
        (Some(_), Form::Value(value)) if first.reference.is_none() => value,
        _ => unnamed((statement, first))?,
    };
    let second_term = unnamed(second)?;
    if first.unit.is_some() || second.1.unit.is_some() {
        return None;
    }
    let remarks = [first, second.1].into_iter().flat_map(|said| said.remarks.clone()).collect();
    let form = Form::Ratio(first_term.clone(), second_term.clone());
    Some((Said { form, unit: None, reference: None, remarks }, label))
}

/// Are the terms no more than a list? `2, 3` and `2 and 3` may be meant for anything.
pub(super) fn is_a_list(reading: &Reading, label: Option<&Label>) -> bool {
    let is_to = |said: &Said| said.remarks.iter().any(|remark| matches!(remark.as_str(), "to" | "is to" | "in"));
    label.is_none() && !reading.statements.iter().flat_map(|statement| &statement.said).any(is_to)
}

/// Judges one value against a ratio, with what it is called.
pub(super) fn judge(model: &Model, said: &Said, label: Option<&Label>) -> Finding {
    let finding = as_it_stands(model, said);
    // `ratio of speeds 2:3`
    let is_mass = |label: &Label| words(&label.typed).filter_map(sort).all(|sort| sort == Sort::Mass);
    if finding.is_credited()
        && model.quantity == Some(Quantity::MassRatio)
        && label.is_some_and(|label| !is_mass(label))
    {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let order = label.map(|label| named_spheres(&label.typed)).unwrap_or_default();
    // `2:3 (B to A)`, `2:3 (B first)`
    let is_turned = |remark: &String| {
        let spheres = spheres_in_remark(remark);
        let is_first = remark.contains("first");
        spheres.len() == if is_first { 1 } else { 2 } && spheres[0] != Sphere::A
    };
    if finding.is_credited() && said.remarks.iter().any(is_turned) {
        return Finding::unreadable(Note::RatioUnchecked);
    }
    let [first, second] = order.as_slice() else { return finding };
    let usual = (*first as usize) < *second as usize;
    match finding.is_credited() && !usual || finding.note == Some(Note::Inverted) {
        true => Finding::unreadable(Note::RatioUnchecked),
        false => finding,
    }
}

/// The value by itself: the model is a quotient, or its two terms as `[2, 3]`.
fn as_it_stands(model: &Model, said: &Said) -> Finding {
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
    let of_quotient = model.of_value(right.clone());
    let finding = number::value(&of_quotient, &found, &Written::of(&found));
    // `1 : 1.67`: the figures are those of the second term.
    let finding = match &said.form {
        Form::Ratio(first, second) if *first == Expr::integer(1) => {
            let turned = model.of_value(Expr::integer(1).over(right));
            finding.or_better(number::value(&turned, second, &Written::of(second)))
        }
        _ => finding,
    };
    if said.unit.is_some() { finding.spoilt_by(Note::UnitNotNeeded) } else { finding }
}
