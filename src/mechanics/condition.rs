//! A condition on the collision as an equation: what it makes nought, and whether a solution keeps it.

use super::law::Known;
use super::refusal::Refusal;
use super::scene::Condition;
use super::{Axis, Datum, Derivation, Moment, Quantity, Sphere};
use crate::expr::{Expr, Fault, Meaning, Relation, Turn, evaluate, print, written};
use crate::number::{Angle, Fraction, Letter, Range, Value};

/// The unknowns of a condition's own formulas replaced, but for angles: these keep their names.
pub(super) fn put_back(expr: &Expr, unknowns: &[Letter], values: &[Value]) -> Expr {
    expr.substitute(&|name| {
        let place = unknowns.iter().position(|unknown| unknown.name() == name && name.parse::<Quantity>().is_err())?;
        (unknowns[place].range() != Range::Acute).then(|| written(&values[place]))
    })
}

/// An equation that asks of an angle what it never is, whatever moves how.
pub(super) fn beyond_its_range(condition: &Condition, letters: &dyn Fn(&str) -> Option<Meaning>) -> Option<Refusal> {
    if condition.relation != Relation::Equal {
        return None;
    }
    let sides = [(&condition.left, &condition.right), (&condition.right, &condition.left)];
    sides.into_iter().find_map(|(named, target)| {
        let Expr::Name(name) = named else { return None };
        let (least, most) = range_of(name.text.parse().ok()?)?;
        let degrees = match evaluate(target, letters).ok()? {
            Meaning::Number(value) => value.enclose_constant(64)?,
            Meaning::Degrees(turn) | Meaning::Angle(turn) => turn.enclose(64)?,
            _ => return None,
        };
        let is_beyond = degrees.upper() < Fraction::from(least) || degrees.lower() > Fraction::from(most);
        is_beyond.then(|| {
            let asked = print::plain(&Expr::equation(condition.left.clone(), condition.right.clone()));
            Refusal::impossible(format!(
                "`{asked}` never holds: this angle is from {}° to {most}°",
                least.to_string().replace("-", "−")
            ))
        })
    })
}

/// The least and the greatest number of degrees of an angle.
fn range_of(quantity: Quantity) -> Option<(i64, i64)> {
    use Quantity::{
        Alpha, AngleBetween, AngleFromI, AngleFromN, AngleToLine, AngleToWall, Deflection, ImpulseAngle,
        SignedDeflection,
    };
    match quantity.of_its_impact() {
        AngleToLine(..) | AngleToWall(..) | ImpulseAngle | Alpha => Some((0, 90)),
        Deflection(_) | AngleBetween(_) => Some((0, 180)),
        AngleFromN(..) | AngleFromI(..) | SignedDeflection(_) => Some((-180, 180)),
        _ => None,
    }
}

/// Are both sides of an inequality angles from 0 to 180 degrees? Then the sine of their difference has the sign of the
/// difference, but where one is 0 and the other 180 degrees.
pub(super) fn are_unsigned_angles(condition: &Condition, letters: &dyn Fn(&str) -> Option<Meaning>) -> bool {
    let is_unsigned = |side: &Expr| {
        let named = if let Expr::Name(name) = side { name.text.parse().ok().and_then(range_of) } else { None };
        if let Some((least, _)) = named {
            return least == 0;
        }
        match evaluate(side, letters) {
            Ok(Meaning::Number(value)) => value.as_fraction().is_some_and(is_within),
            Ok(Meaning::Degrees(turn) | Meaning::Angle(turn)) => match turn.rest {
                None => is_within(&turn.degrees),
                Some(_) => {
                    turn.is_constant()
                        && turn.enclose(64).is_some_and(|own| is_within(&own.lower()) && is_within(&own.upper()))
                }
            },
            _ => false,
        }
    };
    is_unsigned(&condition.left) && is_unsigned(&condition.right)
}

fn is_within(degrees: &Fraction) -> bool {
    *degrees > Fraction::ZERO && *degrees < Fraction::from(180)
}

/// Nought at points inside the ranges of its letters, where it exists: for a formula whose roots do
/// not show that it is nought.
pub(super) fn vanishes(value: &Value) -> bool {
    use crate::number::Interval;
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

/// What is wrong with a condition that speaks of the direction of a sphere at rest, by what follows from what is given, the
/// first so many entries of what is known.
pub(super) fn without_direction(relation: &Expr, known: &Known<Value>, given: usize) -> Option<String> {
    let mut quantities = relation.names().into_iter().filter_map(|name| name.text.parse::<Quantity>().ok());
    let missing = quantities.find(|quantity| {
        let rests = |(sphere, moment)| is_at_rest(known, given, quantity.impact(), sphere, moment);
        !known.0.contains_key(quantity) && of_directions(*quantity).into_iter().any(rests)
    })?;
    Some(format!("there `{missing}` has no value, since a sphere at rest has no direction"))
}

/// The spheres and moments of whose directions an angle or tangent is.
fn of_directions(quantity: Quantity) -> Vec<(Sphere, Moment)> {
    use Quantity::*;
    match quantity.of_its_impact() {
        AngleToLine(sphere, moment) | AngleFromN(sphere, moment) | AngleFromI(sphere, moment) => vec![(sphere, moment)],
        TanToLine(sphere, moment) | TOverN(sphere, moment) => vec![(sphere, moment)],
        AngleToWall(sphere, moment) | TanToWall(sphere, moment) => vec![(sphere, moment)],
        Deflection(sphere) | SignedDeflection(sphere) | TanDeflection(sphere) => {
            vec![(sphere, Moment::Before), (sphere, Moment::After)]
        }
        AngleBetween(moment) => Sphere::BOTH.map(|sphere| (sphere, moment)).to_vec(),
        _ => Vec::new(),
    }
}

/// Are both components of a velocity nought, in whichever axes they follow?
fn is_at_rest(known: &Known<Value>, given: usize, impact: u8, sphere: Sphere, moment: Moment) -> bool {
    let mut known = known.clone();
    [[Axis::X, Axis::Y], [Axis::N, Axis::T]].into_iter().any(|axes| {
        let components = axes.map(|axis| Quantity::Velocity(sphere, moment, axis).in_impact(impact));
        let components: Vec<Quantity> = components.into_iter().flatten().collect();
        Derivation::carry_on(&mut known, given, &components);
        components.iter().all(|component| known.number(*component).is_some_and(|value| value.is_zero()))
    })
}

/// What a condition makes nought.
pub(super) struct Gap {
    /// The difference of its sides, or the sine of the difference of angles.
    pub(super) value: Value,
    /// Of angles the same multiple of the cosine of the difference: below nought where the directions are opposite.
    pub(super) cosine: Option<Value>,
}

impl Gap {
    pub(super) fn is_of_angles(&self) -> bool {
        self.cosine.is_some()
    }

    /// Is it nought where the unknowns have these values, as far as an enclosure tells? `None` where there is none, as where
    /// other letters remain. Values with many roots cannot be put in: every quotient would be rationalised root after root.
    pub(super) fn vanishes_at(&self, unknowns: &[Letter], values: &[Value]) -> Option<bool> {
        const BITS: usize = 256;
        let at = |letter: Letter| {
            let place = unknowns.iter().position(|unknown| *unknown == letter)?;
            values[place].enclose_constant(BITS)
        };
        let is_opposite = match &self.cosine {
            Some(cosine) => cosine.enclose(BITS, &at)?.sign()?.is_lt(),
            None => false,
        };
        Some(!is_opposite && self.value.enclose(BITS, &at)?.contains_zero())
    }
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
        (Meaning::Number(a), Meaning::Number(b)) => Ok(Gap { value: a - b, cosine: None }),
        _ => {
            let (a, b) = turn(&left).zip(turn(&right)).ok_or_else(unlike)?;
            let gap = a.plus(&b.reversed()).ok_or_else(unlike)?;
            Ok(Gap { value: gap.cross().ok_or_else(unlike)?, cosine: Some(gap.dot().ok_or_else(unlike)?) })
        }
    }
}
