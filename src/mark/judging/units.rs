//! Units: read, converted, condoned or flagged; never demanded.

use crate::expr::Expr;
use crate::number::Fraction;
use crate::unit::Unit;

use super::exact;
use super::{Model, Note};
use crate::mark::reading::SaidUnit;

/// What a unit does to the value before it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum UnitCheck {
    /// Nothing: it is right, or there is none, or nothing is known of the right one.
    Fine,
    /// The value is to be multiplied by this first.
    Converted(Fraction),
    /// It is condoned with a remark.
    Condoned(Note),
    /// The value can be right, but the unit spoils it.
    Spoilt(Note),
}

/// The dimension of a unit in powers of kilogram, metre, second and radian.
fn dimension(unit: Unit) -> [i8; 4] {
    match unit {
        Unit::None => [0, 0, 0, 0],
        Unit::Kilogram => [1, 0, 0, 0],
        Unit::Metre => [0, 1, 0, 0],
        Unit::MetrePerSecond => [0, 1, -1, 0],
        Unit::NewtonSecond => [1, 1, -1, 0],
        Unit::Joule => [1, 2, -2, 0],
        Unit::Degree => [0, 0, 0, 1],
    }
}

/// Is it grams, which no answer is in?
pub(super) fn are_grams(unit: &SaidUnit) -> bool {
    unit.dimension == dimension(Unit::Kilogram) && unit.scale == Expr::Number(Fraction::new(1, 1000))
}

/// N/s, often written for N s.
const NEWTONS_PER_SECOND: [i8; 4] = [1, 1, -3, 0];

/// How the unit that was written goes with the one that is right.
pub(super) fn check(model: &Model, said: Option<&SaidUnit>) -> UnitCheck {
    let Some(said) = said else { return UnitCheck::Fine };
    let scale = exact::value(&said.scale, &[]).and_then(|scale| scale.as_fraction().cloned());
    let Some(scale) = scale else { return UnitCheck::Spoilt(Note::UnitWrong) };
    let converted = |scale: Fraction| if scale.is_one() { UnitCheck::Fine } else { UnitCheck::Converted(scale) };
    let Some(unit) = model.unit() else { return converted(scale) };
    if said.dimension == dimension(unit) {
        return converted(scale);
    }
    match unit {
        Unit::NewtonSecond if said.dimension == NEWTONS_PER_SECOND && scale.is_one() => {
            UnitCheck::Condoned(Note::UnitCondoned)
        }
        Unit::None => UnitCheck::Spoilt(Note::UnitNotNeeded),
        _ => UnitCheck::Spoilt(Note::UnitWrong),
    }
}
