//! Angles that a student works with in radians: after `25° = 0.436` a line with `sin 0.436` is no line about half a degree.

use super::angles::{argument, sides};
use crate::expr::Expr;
use crate::mark::working::lines::Line;
use crate::mark::working::numbers::{any_within, figures};
use crate::mark::working::prepared::Prepared;
use crate::mechanics::Datum;

/// An angle in radians has so many figures at least.
const FEWEST: usize = 2;

/// Takes the angle under a sine, cosine or tangent for one in radians where it is an angle of the question to its figures.
/// As so many degrees it would be smaller than any that an exam has.
pub(super) fn put_in_place(lines: &mut [Line], prepared: &Prepared) {
    let mut angles: Option<Vec<f64>> = None;
    for reading in lines.iter_mut().filter(|line| line.typed.contains('.')).flat_map(Line::readings_mut) {
        if sides(reading).any(|side| any_within(side, &|inner| decimal(inner).is_some())) {
            let angles = angles.get_or_insert_with(|| in_question(prepared));
            let is_one = |text: &str| is_one_of(text, angles);
            if sides(reading).any(|side| any_within(side, &|inner| decimal(inner).is_some_and(is_one))) {
                *reading = reading.with(&|expr| in_radians(expr, &is_one));
            }
        }
    }
}

/// The angles of the question, in radians.
fn in_question(prepared: &Prepared) -> Vec<f64> {
    let known = prepared.known.iter().flat_map(|known| known.0.iter());
    let directions = known.filter_map(|(_, datum)| match datum {
        Datum::Direction { y, x } => Some(y.atan2(*x).abs()),
        _ => None,
    });
    directions.chain(prepared.angles.iter().map(|(_, angle)| angle.to_radians())).collect()
}

/// Is a decimal one of these to its figures?
fn is_one_of(text: &str, angles: &[f64]) -> bool {
    let decimals = text.split_once('.').map_or("", |(_, decimals)| decimals);
    let half = 0.5001 * 10_f64.powi(-(decimals.len() as i32));
    let is = |size: f64| angles.iter().any(|angle| (angle - size).abs() <= half);
    figures(text) >= FEWEST && !decimals.is_empty() && text.parse().is_ok_and(is)
}

/// The decimal under a sine, cosine or tangent, taken for degrees.
fn decimal(expr: &Expr) -> Option<&str> {
    match argument(expr)? {
        Expr::Degrees(inner) => match &**inner {
            Expr::Decimal(text) => Some(text),
            _ => None,
        },
        _ => None,
    }
}

fn in_radians(expr: &Expr, is: &dyn Fn(&str) -> bool) -> Expr {
    match (expr, decimal(expr)) {
        (Expr::Call(function, _), Some(text)) if is(text) => Expr::call(*function, Expr::Decimal(text.to_owned())),
        _ => expr.map_children(&mut |child| in_radians(child, is)),
    }
}
