//! When a member of a line is what is looked for.

use super::spread::Spread;
use crate::expr::Expr;
use crate::mark::working::examine::Value;

/// Does the value come to this, whatever its sign?
pub(in crate::mark::working) fn comes_to(value: Value, right: f64) -> bool {
    matches!(value, Value::Number(spread) if spread.absolute().may_be(right.abs()))
}

/// Does the value come to this angle, in degrees or radians, or to its tangent; perhaps to those of its complement?
pub(in crate::mark::working) fn comes_to_angle(value: Value, degrees: f64, may_be_complement: bool) -> bool {
    let degrees = degrees.abs();
    let angles = if may_be_complement { vec![degrees, 90.0 - degrees] } else { vec![degrees] };
    let forms = angles.into_iter().flat_map(|angle| [angle, angle.to_radians(), angle.to_radians().tan()]);
    let mut finite = forms.filter(|form| form.is_finite());
    finite.any(|form| comes_to(value, form))
}

pub(in crate::mark::working) fn is_vector(values: &[Value], x: &[f64], y: &[f64], scale: f64) -> bool {
    values.iter().zip(x.iter().zip(y)).all(|(value, (x, y))| match value {
        // A component that is nought is nought beside the other.
        Value::Vector(along_i, along_j) => {
            let (x, y) = (x * scale, y * scale);
            let is = |one: &Spread, right: f64| (*one - Spread::exactly(right)).may_be_nought(x.hypot(y));
            is(along_i, x) && is(along_j, y)
        }
        Value::Number(_) => false,
    })
}

pub(in crate::mark::working) fn is_parallel(values: &[Value], x: &[f64], y: &[f64]) -> bool {
    values.iter().zip(x.iter().zip(y)).all(|(value, (x, y))| match value {
        Value::Vector(along_i, along_j) => {
            let cross = along_i.times(*y) - along_j.times(*x);
            let size = along_i.absolute().high + along_j.absolute().high;
            size > 0.0 && cross.may_be_nought(size)
        }
        Value::Number(_) => false,
    })
}

/// Is it more than a number as it stands?
pub(in crate::mark::working) fn is_composite(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) => false,
        Expr::Negative(inner) | Expr::Degrees(inner) => is_composite(inner),
        _ => true,
    }
}

pub(in crate::mark::working) fn any_within(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expr) || expr.children().into_iter().any(|child| any_within(child, is))
}
