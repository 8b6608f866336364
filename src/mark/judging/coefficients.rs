//! Formulas with decimals in them: `0.167v` for v/6. Each coefficient is judged as a decimal.

use crate::answer::Accept;
use crate::number::{Fraction, Places, Value};

use super::Note;
use super::accuracy::{Target, Written, decimal};
use super::coarsest::Coarsest;
use super::finding::Finding;

/// So many figures of a coefficient are taken where it is no fraction: more than any answer has.
const FIGURES: Places = Places::SignificantFigures(24);

/// Compares the coefficients of each product of letters; the worst of them decides. Without letters there is but one number,
/// whatever stands below its line: `2.5/sin 64.1°`.
pub(super) fn compare(model: &Value, student: &Value, decimals: &Coarsest, accept: &Accept) -> Finding {
    let one = |right: &Value, found: &Value| {
        if right.equals(found) {
            return Finding::EXACT;
        }
        let Some(value) = fraction(found) else { return Finding::unreadable(Note::CannotBeCompared) };
        let written = Written::worked_out(value, decimals);
        let written = if model.is_constant() { written.left_undone() } else { written };
        decimal(&written, &Target::Value(right, None), accept)
    };
    if model.is_constant() && student.is_constant() {
        return one(model, student);
    }
    if model.denominator() != student.denominator() {
        return Finding::WRONG;
    }
    let (right, found) = (model.coefficients(), student.coefficients());
    if right.len() != found.len() || !right.keys().eq(found.keys()) {
        return Finding::WRONG;
    }
    let each = right.values().zip(found.values()).map(|(right, found)| one(right, found));
    each.reduce(Finding::and).unwrap_or(Finding::WRONG)
}

fn fraction(value: &Value) -> Option<Fraction> {
    value.as_fraction().cloned().or_else(|| value.rounded(&FIGURES).ok().map(|decimal| decimal.to_fraction()))
}
