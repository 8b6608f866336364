//! The impulse acts along the line of centres, so its direction is that line.
//!
//! `n = I_B/|I_B|`: what B receives points from A to B.

use super::{Datum, Known, Law, Line, Outcome, Rule, Show, Slip, rule};
use crate::expr::Expr;
use crate::mechanics::Axis::{X, Y};
use crate::mechanics::{Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "line of centres";

pub const ACCURACY: &str = "correct direction, any multiple";

pub const METHOD: (&str, &str) = ("line of centres parallel to the impulse", "any multiple of the vector");

pub const SLIPS: &[Slip] = &[Slip {
    tag: "line-perpendicular",
    sentence: "The impulse acts along the line of centres: its direction is the change in A's momentum.",
}];

pub fn rules() -> Vec<Rule> {
    let line = [Quantity::Line(X), Quantity::Line(Y)];
    [Sphere::A, Sphere::B]
        .into_iter()
        .map(|sphere| {
            let impulse = [Quantity::Impulse(sphere, X), Quantity::Impulse(sphere, Y)];
            // A form for each sphere; A's impulse is the one that an exam asks for.
            rule(Law::LineOfCentres, sphere as u8, &impulse, &line, 1)
        })
        .collect()
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let [x, y] = known.numbers([rule.needs[0], rule.needs[1]])?;
    let size = (x.squared() + y.squared()).root()?;
    let (x, y) = (x.over(&size)?, y.over(&size)?);
    let (x, y) = if rule.form == Sphere::A as u8 { (-x, -y) } else { (x, y) };
    Some(vec![Datum::Number(x), Datum::Number(y)])
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let outcome = evaluate(rule, known)?;
    match (slip, outcome.as_slice()) {
        ("line-perpendicular", [Datum::Number(x), Datum::Number(y)]) => {
            Some(vec![Datum::Number(-y.clone()), Datum::Number(x.clone())])
        }
        _ => None,
    }
}

/// The direction.
pub fn earning(_: &Rule, show: &Show) -> Option<Expr> {
    Some(show.line_direction())
}

pub fn lines(_: &Rule, show: &Show) -> Vec<Line> {
    vec![Line::with(
        "The impulse acts along the line of centres, so the line of centres is parallel to {n}.",
        &[("n", show.line_direction())],
        vec![],
    )]
}
