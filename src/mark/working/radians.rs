//! Angles that a student works with in radians: after `25° = 0.436` a line with `sin 0.436` is no line about half a degree.

use super::angles::argument;
use super::line::{Line, ReadLine};
use super::prepared::Prepared;
use crate::expr::Expr;
use crate::mechanics::Datum;

/// An angle in radians has so many figures at least.
const FEWEST: usize = 2;

/// Takes the angle under a sine, cosine or tangent for one in radians where it is an angle of the question to its figures.
/// As so many degrees it would be smaller than any that an exam has.
pub(super) fn put_in_place(lines: &mut [Line], prepared: &Prepared) {
    let known = prepared.known.iter().flat_map(|known| known.0.iter());
    let directions = known.filter_map(|(_, datum)| match datum {
        Datum::Direction { y, x } => Some(y.atan2(*x).abs()),
        _ => None,
    });
    let angles: Vec<f64> = directions.chain(prepared.angles.iter().map(|(_, angle)| angle.to_radians())).collect();
    let is_one = |text: &str| {
        let decimals = text.split_once('.').map_or("", |(_, decimals)| decimals);
        let half = 0.5001 * 10_f64.powi(-(decimals.len() as i32));
        let is = |size: f64| angles.iter().any(|angle| (angle - size).abs() <= half);
        super::linear::figures(text) >= FEWEST && !decimals.is_empty() && text.parse().is_ok_and(is)
    };
    for reading in lines.iter_mut().flat_map(Line::readings_mut).filter(|reading| has_decimal(reading, &is_one)) {
        *reading = reading.with(&|expr| in_radians(expr, &is_one));
    }
}

fn has_decimal(reading: &ReadLine, is: &dyn Fn(&str) -> bool) -> bool {
    super::angles::sides(reading).any(|side| in_radians(side, is) != *side)
}

fn in_radians(expr: &Expr, is: &dyn Fn(&str) -> bool) -> Expr {
    let decimal = argument(expr).and_then(|argument| match argument {
        Expr::Degrees(inner) => match &**inner {
            Expr::Decimal(text) => Some((inner, text)),
            _ => None,
        },
        _ => None,
    });
    match (expr, decimal) {
        (Expr::Call(function, _), Some((radians, text))) if is(text) => Expr::call(*function, (**radians).clone()),
        _ => expr.map_children(&mut |child| in_radians(child, is)),
    }
}
