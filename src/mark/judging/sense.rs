//! The sense along the line of centres that is said beside a value, against that in which the sphere moves.
//!
//! Convention. A component along the line of centres is positive from A to B: `3 m/s from B to A` is −3. Beside a speed the
//! sense is not asked, and one that is not right is for a person. Beside the size of an impulse it may be either, for there
//! are two of them.

use std::cmp::Ordering;

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::enclosure::about;
use crate::mark::reading::{Form, Label, Reading, ReferenceLine, Said, Sense};
use crate::mechanics::{Axis, Quantity, Sphere};

use super::finding::Finding;
use super::known::Prepared;
use super::otherwise::spheres_in_remark;
use super::{Model, Note, Verdict, angle, exact, number, selection, sides};

/// Does a sphere that moves so, backwards or not, move in the sense that is said? `None` if nobody knows.
pub(super) fn agrees(said: Option<Sense>, backwards: Option<bool>) -> Option<bool> {
    match (said, backwards) {
        (None, _) | (Some(Sense::Perhaps), Some(false)) => Some(true),
        (Some(Sense::Perhaps), _) | (_, None) => None,
        (Some(Sense::AToB), Some(backwards)) => Some(!backwards),
        (Some(Sense::BToA), Some(backwards)) => Some(backwards),
    }
}

/// Judges a number by the direction that is said beside it, where that matters for what is asked.
pub(super) fn judge(model: &Model, said: &Said, label: Option<&Label>) -> Option<Finding> {
    let line = said.reference?;
    if lies_elsewhere(model.quantity?, line) {
        let plain = number::judge(model, &Said { reference: None, ..said.clone() }, label);
        return Some(if plain.is_credited() { Finding::unreadable(Note::ReferenceUnchecked) } else { plain });
    }
    let of = |form: Form| number::judge(model, &Said { form, reference: None, ..said.clone() }, label);
    let plain = || of(said.form.clone());
    let (sphere, axis) = match model.quantity? {
        Quantity::Velocity(sphere, _, axis) | Quantity::SphereMomentum(sphere, _, axis) => (sphere, axis),
        Quantity::Impulse(sphere, axis) => (sphere, axis),
        Quantity::Speed(sphere, _) => {
            // Away from B is where C goes.
            let is_of_c = sphere == Sphere::C && line.is_sense_alone();
            let agrees = is_of_c || agrees(line.sense(), model.rebounds) != Some(false);
            let lies = |degrees: i64| model.path.as_ref().is_none_or(|path| *path == Expr::integer(degrees));
            let lies = match line.unsensed() {
                ReferenceLine::AlongLineOfCentres => lies(0),
                ReferenceLine::AlongCommonTangent => lies(90),
                _ => true,
            };
            return (!(agrees && lies)).then(|| plain().at_most_partial(Note::DirectionUnchecked));
        }
        // `3.38 N s from A to B, on B`: on the other sphere the sense is the other one.
        Quantity::ImpulseMagnitude => {
            let is_of_one = said
                .remarks
                .iter()
                .chain(label.map(|label| &label.typed))
                .all(|text| spheres_in_remark(text).is_empty());
            let is_else = is_of_one && agrees(line.sense(), model.pushes_back) == Some(false);
            return is_else.then(|| plain().at_most_partial(Note::DirectionUnchecked));
        }
        _ => return None,
    };
    let right = match axis {
        Axis::N => ReferenceLine::AlongLineOfCentres,
        Axis::T => ReferenceLine::AlongCommonTangent,
        _ => return None,
    };
    if line.is_direction() && line.unsensed() != right && !(axis == Axis::N && line.is_sense_alone()) {
        return Some(if plain().is_credited() { Finding::wrong(Note::DirectionWrong) } else { Finding::WRONG });
    }
    let Form::Value(expr) = &said.form else { return None };
    if line.sense() != Some(Sense::BToA) || axis == Axis::T {
        return None;
    }
    let (plain, turned) = (plain(), of(Form::Value(expr.clone().negated())));
    Some(match (turned.is_credited(), plain.is_credited()) {
        (false, false) => Finding::WRONG,
        // `−3 m/s from B to A`: said twice, or taken back? And where C lies nobody has said.
        _ if is_negative(expr) || sphere == Sphere::C => Finding::unreadable(Note::CannotBeCompared),
        (true, _) => turned,
        (false, true) => Finding::wrong(Note::Sign),
    })
}

/// Is it a line along which no impulse acts, or from which another angle is measured than that whose tangent is asked?
fn lies_elsewhere(asked: Quantity, line: ReferenceLine) -> bool {
    use ReferenceLine::{AlongCommonTangent, CommonTangent, LineOfCentres, OriginalDirection};
    match asked.of_its_impact() {
        Quantity::ImpulseMagnitude | Quantity::Approach | Quantity::Separation => line.unsensed() == AlongCommonTangent,
        Quantity::TanToLine(..) => matches!(line.unsensed(), CommonTangent | OriginalDirection),
        Quantity::TanToWall(..) => matches!(line.unsensed(), LineOfCentres | OriginalDirection),
        Quantity::TanDeflection(_) => matches!(line.unsensed(), CommonTangent | LineOfCentres),
        _ => false,
    }
}

/// Is an angle told beside a speed that is not the one at which the sphere moves?
pub(super) fn is_beside_the_path(model: &Model, reading: &Reading) -> bool {
    if reading.statements.iter().flat_map(|statement| &statement.said).any(|said| is_beside_the_vector(model, said)) {
        return true;
    }
    let along_centres = Expr::integer(0);
    let path = match (&model.path, model.quantity.map(Quantity::of_its_impact)) {
        (Some(path), Some(Quantity::Speed(..))) => path,
        // Smooth spheres push each other along the line of centres.
        (_, Some(Quantity::ImpulseMagnitude)) => &along_centres,
        _ => return false,
    };
    let to_centres =
        |line: ReferenceLine| matches!(line.unsensed(), ReferenceLine::LineOfCentres | ReferenceLine::CommonTangent);
    let mut angle_model = Model { kind: Kind::Angle, ..model.of_value(path.clone()) };
    // What is too long for its exact value is told apart by doubles.
    if angle_model.known().turn().is_none()
        && let Some(radians) = about(path, &[])
    {
        angle_model.value = Expr::Decimal(format!("{:.9}", radians.to_degrees()));
        angle_model.prepared = Prepared::default();
    }
    let said = reading.statements.iter().flat_map(|statement| &statement.said);
    let mut angles = said.filter(|said| selection::is_angular(said) && said.reference.is_some_and(to_centres));
    angles.any(|said| angle::judge(&angle_model, said, None).verdict == Verdict::Wrong)
}

/// Is it an angle with **i** or **j** at which the vector whose size is asked does not lie? Of an impulse there are two, the
/// one opposite to the other.
fn is_beside_the_vector(model: &Model, said: &Said) -> bool {
    let Some([x, y]) = &model.vector else { return false };
    let (Some(x), Some(y)) = (about(x, &[]), about(y, &[])) else { return false };
    let Some(line) = said.reference.filter(|_| selection::is_angular(said)) else { return false };
    let degrees = match line {
        ReferenceLine::I => y.abs().atan2(x),
        ReferenceLine::J => x.abs().atan2(y),
        ReferenceLine::MinusI => y.abs().atan2(-x),
        _ => return false,
    }
    .to_degrees();
    let is_right = |degrees: f64| {
        let right = Model { kind: Kind::Angle, ..model.of_value(Expr::Decimal(format!("{degrees:.9}"))) };
        angle::judge(&right, &Said { reference: None, ..said.clone() }, None).is_credited()
    };
    let is_of_either = model.quantity.map(Quantity::of_its_impact) == Some(Quantity::ImpulseMagnitude);
    // `at 56.3° below i`
    let is_above = sides::says_upwards(&said.remarks.iter().collect::<Vec<_>>());
    if line == ReferenceLine::I && !is_of_either && is_above.is_some_and(|above| above != (y > 0.0)) {
        return true;
    }
    !(is_right(degrees) || is_of_either && is_right(180.0 - degrees))
}

/// Is it along **i** or **j**, and the vector whose size is asked along the other? Or the other way, where the question asks for
/// the impulse on one body?
pub(super) fn is_across_the_vector(model: &Model, x: &Expr, y: &Expr) -> bool {
    let Some([right_x, right_y]) = &model.vector else { return false };
    let is_opposite = || {
        let product = |one: &Expr, other: &Expr| about(&Expr::product([one.clone(), other.clone()]), &[]);
        let along = product(x, right_x).zip(product(y, right_y));
        along.is_some_and(|(along_i, along_j)| along_i + along_j < 0.0)
    };
    right_x.is_zero() && y.is_zero() || right_y.is_zero() && x.is_zero() || model.pushes_back.is_some() && is_opposite()
}

fn is_negative(expr: &Expr) -> bool {
    let sign = exact::value(expr, &[]).and_then(|value| value.sign());
    matches!(expr, Expr::Negative(_)) || sign == Some(Ordering::Less)
}
