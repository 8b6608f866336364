//! Units: read, converted, condoned or flagged; never demanded.

use crate::expr::Expr;
use crate::number::{Fraction, Places};
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
pub(in crate::mark) fn dimension(unit: Unit) -> [i8; 4] {
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

/// The model in the unit of which so much makes the usual one, where a decimal in it counts by its figures: `30.8 km/h`. A power
/// of ten only moves the point.
pub(super) fn in_its_own_unit(model: &Model, scale: &Fraction) -> Option<Model> {
    let by_figures = !matches!(model.accept.places(), Some(Places::DecimalPlaces(_) | Places::Nearest(_)));
    let is_power_of_ten = (-60..=60).any(|power| Fraction::from(10).power(power).as_ref() == Some(scale));
    let share = scale.reciprocal().filter(|_| by_figures && !is_power_of_ten)?;
    Some(model.of_value(Expr::product([Expr::Number(share), model.value.clone()])))
}

/// `8.54 m` where the question has a mass m and the answer has not: the number before what may be metres, and what is to be
/// said of that.
pub(super) fn taken_for_a_letter(model: &Model, expr: &Expr) -> Option<(Expr, Note)> {
    let Expr::Product(factors) = expr else { return None };
    let [number @ .., Expr::Name(letter)] = factors.as_slice() else { return None };
    let number = Expr::product(number.iter().cloned());
    let is_constant = !model.known().has_names() && number.names().is_empty();
    let is_wrong = model.unit().is_some_and(|unit| unit != Unit::Metre);
    let note = if model.unit() == Some(Unit::None) { Note::UnitNotNeeded } else { Note::UnitWrong };
    (letter.text == "m" && is_constant && is_wrong).then_some((number, note))
}
