//! The direction of a line: any vector along it, in either sense, or its gradient.

use crate::expr::{Expr, Function, Meaning};
use crate::mark::reading::{ACROSS, Form, Label, ReferenceLine, Said};

use super::accuracy::Written;
use super::coarsest::Coarsest;
use super::exact::{self, Equality, same};
use super::finding::Finding;
use super::sorts::words;
use super::{Model, Note, number, selection, vector};

/// Judges one value against a line. What is said to be perpendicular to the line, or to be the tangent, must be so.
pub(super) fn judge(model: &Model, said: &Said, label: Option<&Label>) -> Finding {
    let Some((x, y)) = along(model) else { return Finding::unreadable(Note::CannotBeCompared) };
    let has = |wanted: &[&str]| {
        label.is_some_and(|label| words(&label.typed.to_lowercase()).any(|word| wanted.contains(&word)))
    };
    let is_across = said.reference == Some(ReferenceLine::AlongCommonTangent);
    let is_of_tangent = has(&["tangent", "wall", "surface", "plane"]) != has(&["perpendicular", "perp"]);
    let finding = match is_across != is_of_tangent {
        true if compared(model, (&x, &y), said, label).is_credited() => Finding::unreadable(Note::CannotBeCompared),
        true => compared(model, (&y.negated(), &x), said, label),
        false => compared(model, (&x, &y), said, label),
    };
    // A change of velocity lies along the line of centres, and no velocity need do so.
    let is_of_motion =
        has(&["velocity", "speed", "vel", "path", "motion"]) && !has(&["change", "difference", "relative"]);
    if finding.is_credited() && is_of_motion { Finding::unreadable(Note::NamedOtherwise) } else { finding }
}

/// The value against the line of a vector.
fn compared(model: &Model, (right_x, right_y): (&Expr, &Expr), said: &Said, label: Option<&Label>) -> Finding {
    if let Form::Gradient(gradient) = &said.form {
        let finding = by_gradient(model, right_x, right_y, gradient);
        // Who calls the answer perpendicular to itself may speak of another line.
        let turned = || by_gradient(model, right_x, right_y, &Expr::integer(1).over(gradient.clone()).negated());
        let is_across = said.remarks.iter().any(|remark| remark == ACROSS) && !gradient.is_zero();
        if is_across && !finding.is_credited() && turned().is_credited() {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        return finding;
    }
    if let Some((x, y, _)) = vector::said_components(model, said) {
        return parallel(model, (right_x, right_y), (&x, &y));
    }
    // `-1 : 3`, `i : j = -1 : 3`; under another name it may be the other way round.
    if let Form::Ratio(x, y) = &said.form {
        let name: String = label.map(|label| label.typed.split_whitespace().collect()).unwrap_or_default();
        if !matches!(&*name, "" | "i:j" | "x:y") && !name.ends_with("ratio") {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        return parallel(model, (right_x, right_y), (x, y));
    }
    // `45° below i`, `arctan 3`: which way it is measured is for a person to see.
    if let (Form::Value(angle), true) = (&said.form, selection::is_angular(said)) {
        let is_inverse = exact::is_angle(angle, &model.vocabulary.letters);
        let slope = Expr::call(Function::Tan, if is_inverse { angle.clone() } else { Expr::degrees(angle.clone()) });
        let turned = Expr::integer(1).over(slope.clone());
        let slopes = [slope.clone(), turned.clone(), slope.negated(), turned.negated()];
        let size = |slope: &Expr| exact::value(slope, &model.vocabulary.letters).is_some();
        let fits = |slope: &Expr| size(slope) && by_gradient(model, right_x, right_y, slope).is_credited();
        return if slopes.iter().any(fits) { Finding::unreadable(Note::CannotBeCompared) } else { Finding::WRONG };
    }
    let named = label.is_some_and(|label| {
        let typed = label.typed.trim().to_lowercase();
        typed == "m" || typed.contains("grad") || typed.contains("slope") || typed == "dy/dx"
    });
    match &said.form {
        Form::Value(gradient) if exact::unknown_letter(gradient, &model.vocabulary.letters).is_none() => {
            let finding = by_gradient(model, right_x, right_y, gradient);
            if named { finding } else { finding.at_most_partial(Note::GradientUnstated) }
        }
        Form::Mixed(_) => Finding::wrong(Note::NumberPlusVector),
        Form::Percentage(_) => Finding::WRONG,
        _ => Finding::unreadable(Note::CannotBeCompared),
    }
}

/// A vector along the model's line; a number is its gradient.
fn along(model: &Model) -> Option<(Expr, Expr)> {
    vector::components(model).or_else(|| match model.known().meaning()? {
        Meaning::Number(_) => Some((Expr::integer(1), model.value.clone())),
        _ => None,
    })
}

fn by_gradient(model: &Model, x: &Expr, y: &Expr, gradient: &Expr) -> Finding {
    if same(x, &Expr::integer(0), &model.vocabulary.letters) == Equality::Equal {
        return Finding::WRONG;
    }
    let slope = model.of_value(y.clone().over(x.clone()));
    number::value(&slope, gradient, &Written::of(gradient))
}

/// Is the vector a multiple of the model's, and not nought?
fn parallel(model: &Model, right: (&Expr, &Expr), found: (&Expr, &Expr)) -> Finding {
    let letters = &model.vocabulary.letters;
    let nothing = |expr: &Expr| same(expr, &Expr::integer(0), letters) == Equality::Equal;
    for component in [found.0, found.1] {
        if exact::unknown_letter(component, letters).is_some() {
            return Finding::wrong(Note::UnknownLetter);
        }
    }
    if nothing(found.0) && nothing(found.1) {
        return Finding::WRONG;
    }
    let product = |one: &Expr, two: &Expr| Expr::Product(vec![one.clone(), two.clone()]);
    match same(&product(right.1, found.0), &product(right.0, found.1), letters) {
        Equality::Equal => return Finding::EXACT,
        Equality::Undecided => return Finding::unreadable(Note::CannotBeCompared),
        Equality::Different => {}
    }
    let decimals = [found.0, found.1].iter().any(|component| Coarsest::of(component).is_some());
    if decimals && !nothing(found.0) {
        return by_gradient(model, right.0, right.1, &found.1.clone().over(found.0.clone()));
    }
    if nothing(right.0) == nothing(right.1)
        && same(&product(right.0, found.0), &product(right.1, found.1), letters) == Equality::Equal
    {
        return Finding::wrong(Note::ComponentsExchanged);
    }
    Finding::WRONG
}
