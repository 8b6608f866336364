//! When a member of a line is what is looked for.

use super::examine::Value;
use super::spread::Spread;
use crate::expr::Expr;

/// Does the value come to this, whatever its sign? An angle may be in degrees or radians, its complement, or its tangent.
pub(super) fn comes_to(value: Value, right: f64, is_angle: bool) -> bool {
    let Value::Number(spread) = value else { return false };
    let size = spread.absolute();
    if !is_angle {
        return size.may_be(right.abs());
    }
    let degrees = right.abs();
    let tangent = degrees.to_radians().tan().abs();
    let angles = [degrees, 90.0 - degrees, degrees.to_radians(), (90.0 - degrees).to_radians(), tangent, 1.0 / tangent];
    angles.into_iter().any(|angle| angle.is_finite() && size.may_be(angle.abs()))
}

pub(super) fn is_vector(values: &[Value], x: &[f64], y: &[f64], scale: f64) -> bool {
    values.iter().zip(x.iter().zip(y)).all(|(value, (x, y))| match value {
        Value::Vector(along_i, along_j) => along_i.may_be(x * scale) && along_j.may_be(y * scale),
        Value::Number(_) => false,
    })
}

pub(super) fn is_parallel(values: &[Value], x: &[f64], y: &[f64]) -> bool {
    values.iter().zip(x.iter().zip(y)).all(|(value, (x, y))| match value {
        Value::Vector(along_i, along_j) => {
            let cross = *along_i * Spread::exactly(*y) - *along_j * Spread::exactly(*x);
            let size = along_i.absolute().high + along_j.absolute().high;
            size > 0.0 && cross.may_be_nought(size)
        }
        Value::Number(_) => false,
    })
}

/// Is it more than a number as it stands?
pub(super) fn is_composite(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) => false,
        Expr::Negative(inner) | Expr::Degrees(inner) => is_composite(inner),
        _ => true,
    }
}

pub(super) fn any_within(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expr) || expr.children().into_iter().any(|child| any_within(child, is))
}
