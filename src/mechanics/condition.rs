//! A condition on the collision as an equation: what it makes nought, and whether a solution keeps it.

use super::law::Known;
use super::refusal::Refusal;
use super::scene::Condition;
use super::{Datum, Quantity};
use crate::expr::{Expr, Fault, Meaning, Turn, evaluate, written};
use crate::number::{Angle, Letter, Range, Value};

/// The unknowns of a condition's own formulas replaced, but for angles: these keep their names.
pub(super) fn put_back(expr: &Expr, unknowns: &[Letter], values: &[Value]) -> Expr {
    expr.substitute(&|name| {
        let place = unknowns.iter().position(|unknown| unknown.name() == name && name.parse::<Quantity>().is_err())?;
        (unknowns[place].range() != Range::Acute).then(|| written(&values[place]))
    })
}

/// Nought at points inside the ranges of its letters, where it exists: for a formula whose roots do
/// not show that it is nought.
pub(super) fn vanishes(value: &Value) -> bool {
    use crate::number::{Fraction, Interval};
    let mut tried = 0;
    for sample in 1..40_i64 {
        let at = |letter: Letter| {
            let spread = letter.name().bytes().fold(sample * 17, |sum, byte| (sum * 31 + i64::from(byte)) % 89);
            Some(Interval::from_fraction(&Fraction::new(spread + 1, 90), 256))
        };
        let Some(interval) = value.enclose(256, &at) else { continue };
        tried += 1;
        if !interval.contains_zero() {
            return false;
        }
    }
    tried > 0
}

pub(super) fn fault(fault: Fault) -> Refusal {
    let refusal = Refusal::beyond(format!("a condition cannot be evaluated: {}", fault.message));
    match fault.help {
        Some(help) => refusal.try_this(help),
        None => refusal,
    }
}

/// A name in a condition: a quantity, or a letter of the scene.
pub(super) fn name_of(name: &str, letters: &dyn Fn(&str) -> Option<Meaning>, known: &Known<Value>) -> Option<Meaning> {
    if let Some(found) = letters(name) {
        return Some(found);
    }
    match known.0.get(&name.parse::<Quantity>().ok()?)? {
        Datum::Number(value) => Some(Meaning::Number(value.clone())),
        Datum::Direction { y, x } => Some(Meaning::Degrees(Turn::of(Angle::of(y, x)?))),
        Datum::Equation(_) => None,
    }
}

/// What a condition makes nought.
pub(super) struct Gap {
    /// The difference of its sides, or the sine of the difference of angles.
    pub(super) value: Value,
    pub(super) of_angles: bool,
}

pub(super) fn residual(
    condition: &Condition,
    letters: &dyn Fn(&str) -> Option<Meaning>,
    known: &Known<Value>,
) -> Result<Gap, Fault> {
    let names = |name: &str| {
        let quantity = name.parse::<Quantity>().ok();
        match quantity.and_then(|quantity| known.direction(quantity)) {
            Some((y, x)) => Some(Meaning::Degrees(Turn::of(Angle::unscaled(&y, &x)))),
            None => name_of(name, letters, known),
        }
    };
    // Beside a number of degrees an angle's letter means its degrees: `90 - alpha`.
    let in_degrees = |name: &str| match names(name) {
        Some(Meaning::Angle(turn)) => Some(Meaning::Degrees(turn)),
        other => other,
    };
    let side = |expr: &Expr| evaluate(expr, &names).or_else(|fault| evaluate(expr, &in_degrees).map_err(|_| fault));
    let (left, right) = (side(&condition.left)?, side(&condition.right)?);
    let turn = |meaning: &Meaning| match meaning {
        Meaning::Degrees(turn) | Meaning::Angle(turn) => Some(turn.clone()),
        Meaning::Number(value) => value.as_fraction().map(|degrees| Turn::degrees(degrees.clone())),
        _ => None,
    };
    let unlike = || Fault::new("the two sides are not of one kind", Default::default(), "two numbers or two angles");
    match (&left, &right) {
        (Meaning::Number(a), Meaning::Number(b)) => Ok(Gap { value: a - b, of_angles: false }),
        _ => {
            let (a, b) = turn(&left).zip(turn(&right)).ok_or_else(unlike)?;
            let gap = a.plus(&b.reversed()).ok_or_else(unlike)?;
            Ok(Gap { value: gap.cross().ok_or_else(unlike)?, of_angles: true })
        }
    }
}
