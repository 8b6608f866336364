//! Angles that are too long to be worked out exactly: compared at points, and by their enclosures.

use crate::expr::{Expr, Function};
use crate::mark::reading::Said;

use super::accuracy::Written;
use super::angle::in_turns;
use super::exact::{self, Equality};
use super::finding::Finding;
use super::{Model, Note, number};

/// The angle of which the model's value is the number of degrees, or that it is.
pub(super) fn as_angle(model: &Model) -> Expr {
    in_degrees(&model.value).unwrap_or_else(|| model.value.clone())
}

/// So many degrees as an angle, if it is a number of them: `arctan(4/11)/1°`, and `180 − arctan(4/11)/1°`.
fn in_degrees(expr: &Expr) -> Option<Expr> {
    match expr {
        Expr::Quotient(angle, below) if **below == Expr::degrees(Expr::integer(1)) => Some((**angle).clone()),
        Expr::Negative(inner) => in_degrees(inner).map(Expr::negated),
        Expr::Sum(terms) => {
            let angles: Vec<Option<Expr>> = terms.iter().map(in_degrees).collect();
            let number =
                |(angle, term): (&Option<Expr>, &Expr)| angle.clone().unwrap_or_else(|| Expr::degrees(term.clone()));
            angles.iter().any(Option::is_some).then(|| Expr::Sum(angles.iter().zip(terms).map(number).collect()))
        }
        _ => None,
    }
}

/// A number of degrees, or of radians, beside an angle that is too long to be worked out exactly.
pub(super) fn by_enclosure(model: &Model, said: &Said, expr: &Expr) -> Finding {
    let is_in_radians = said.unit.as_ref().is_some_and(|unit| !unit.degrees && unit.dimension == [0, 0, 0, 1]);
    let size = match (in_degrees(&model.value), is_in_radians) {
        (Some(angle), true) => angle,
        (Some(_), false) | (None, true) => model.value.clone(),
        (None, false) => model.value.clone().over(Expr::degrees(Expr::integer(1))),
    };
    number::value(&model.of_value(size), expr, &Written::of(expr))
}

/// What an inverse tangent is of.
fn tangent(angle: &Expr) -> Option<Expr> {
    match angle {
        Expr::Call(Function::Atan, tangent) => Some((**tangent).clone()),
        _ => None,
    }
}

/// An angle in letters that is long to compare, or of which only the tangent is seen to agree, is compared at points.
pub(super) fn at_points(model: &Model, expr: &Expr) -> Finding {
    let letters = &model.vocabulary.letters;
    let right = in_turns(model);
    // Two angles of which the tangents are known are equal if those are.
    let found = match tangent(&right).zip(tangent(&in_degrees(expr).unwrap_or_else(|| expr.clone()))) {
        Some((right, own)) => exact::same(&right, &own, letters),
        None => exact::same(&right, expr, letters),
    };
    match found {
        Equality::Equal => Finding::EXACT,
        Equality::Different => Finding::WRONG,
        Equality::Undecided => Finding::unreadable(Note::CannotBeCompared),
    }
}
