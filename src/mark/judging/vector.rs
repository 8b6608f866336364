//! Vectors: component by component, however they are written.

use crate::expr::{Expr, Function, Meaning, written};
use crate::mark::reading::{Form, Notation, Said};

use super::accuracy::Written;
use super::exact;
use super::finding::Finding;
use super::units::{self, UnitCheck};
use super::{Model, Note, number};

/// The magnitude of a vector.
pub(super) fn magnitude(x: &Expr, y: &Expr) -> Expr {
    let square = |component: &Expr| component.clone().to_the(2);
    Expr::call(Function::Sqrt, Expr::Sum(vec![square(x), square(y)]))
}

/// The model's components.
pub(super) fn components(model: &Model) -> Option<(Expr, Expr)> {
    match model.known().meaning()? {
        Meaning::Vector(x, y) => Some((written(x), written(y))),
        _ => None,
    }
}

/// What was said, by its components.
pub(super) fn said_components(model: &Model, said: &Said) -> Option<(Expr, Expr, Notation)> {
    match &said.form {
        Form::Vector(x, y, notation) => Some((x.clone(), y.clone(), *notation)),
        Form::Value(expr) => match exact::meaning(expr, &model.vocabulary.letters)? {
            Meaning::Vector(x, y) => Some((written(&x), written(&y), Notation::UnitVectors)),
            _ => None,
        },
        Form::AtRest => Some((Expr::integer(0), Expr::integer(0), Notation::Words)),
        _ => None,
    }
}

/// Judges one value against a vector.
pub(super) fn judge(model: &Model, said: &Said) -> Finding {
    let Some((right_x, right_y)) = components(model) else { return Finding::unreadable(Note::CannotBeCompared) };
    let Some((x, y, notation)) = said_components(model, said) else {
        return match &said.form {
            // Nought is the one vector that is written like a number.
            Form::Value(expr) if expr.is_zero() && right_x.is_zero() && right_y.is_zero() => Finding::EXACT,
            Form::Value(expr) if exact::unknown_letter(expr, &model.vocabulary.letters).is_some() => {
                let bare = matches!(expr, Expr::Name(_));
                if bare { Finding::unreadable(Note::UnknownLetter) } else { Finding::wrong(Note::UnknownLetter) }
            }
            Form::Value(_) | Form::Percentage(_) => Finding::wrong(Note::ScalarForVector),
            Form::Mixed(_) => Finding::wrong(Note::NumberPlusVector),
            Form::Direction => Finding::unreadable(Note::CannotBeCompared),
            _ => Finding::WRONG,
        };
    };
    let (factor, unit_note, spoilt) = match units::check(model, said.unit.as_ref()) {
        UnitCheck::Fine => (None, None, None),
        UnitCheck::Converted(scale) => (Some(scale), Some(Note::UnitConverted), None),
        UnitCheck::Condoned(note) => (None, Some(note), None),
        UnitCheck::Spoilt(note) => (None, None, Some(note)),
    };
    let scaled = |component: &Expr| match &factor {
        Some(scale) => Expr::product([Expr::Number(scale.clone()), component.clone()]),
        None => component.clone(),
    };
    let (x, y) = (scaled(&x), scaled(&y));
    let mut finding = both(model, (&right_x, &x), (&right_y, &y));
    if !finding.is_credited() {
        return explain(model, (&right_x, &right_y), (&x, &y), finding);
    }
    if let Some(note) = unit_note {
        finding = finding.remarked(note);
    }
    if let Some(note) = spoilt {
        finding = finding.spoilt_by(note);
    }
    if notation == Notation::Coordinates { finding.spoilt_by(Note::Coordinates) } else { finding }
}

/// Each component against its own.
fn both(model: &Model, x: (&Expr, &Expr), y: (&Expr, &Expr)) -> Finding {
    let one = |(right, found): (&Expr, &Expr)| {
        let component = model.of_value(right.clone());
        number::value(&component, found, &Written::of(found))
    };
    one(x).and(one(y))
}

fn explain(model: &Model, right: (&Expr, &Expr), found: (&Expr, &Expr), finding: Finding) -> Finding {
    if both(model, (right.0, found.1), (right.1, found.0)).is_correct() {
        return Finding::wrong(Note::ComponentsExchanged);
    }
    let (x, y) = (found.0.clone().negated(), found.1.clone().negated());
    if both(model, (right.0, &x), (right.1, &y)).is_correct() {
        return Finding::wrong(Note::Sign);
    }
    finding
}
