//! What is known of the motion about which a blank asks: which way a sphere goes, who takes part, how a vector points. What is
//! said beside a value is judged by it.

use std::borrow::Cow;
use std::cmp::Ordering;

use crate::bank::Find;
use crate::expr::{Expr, Function, Relation, written};
use crate::mark::judging::Model;
use crate::mechanics::{Axis, Derivation, Known, Moment, Quantity, Scene, Setting, Sphere};
use crate::number::Value;

/// Tells a model answer what is known, of a blank with this name.
pub(super) fn tell(model: &mut Model, name: &str, find: &Find, scene: &Scene, known: &Known<Value>) {
    model.rebounds = rebounds(find, known);
    model.path = path(find, known);
    model.turns_back = turns_back(find, scene, known);
    model.same_way = same_way(find, scene, known);
    model.pushes_back = pushes_back(name, find, scene);
    model.meet_again = meet_again(find, scene);
    model.anticlockwise = anticlockwise(find, known);
    model.against_i = against_i(find, known, scene);
    model.vector = vector(find, known);
    model.strangers = strangers(find, scene);
    // A wall has no share in it.
    model.is_of_both &= Quantity::Mass(Sphere::B).is_in(scene.setting);
}

/// Does the sphere whose direction or speed is asked move from B towards A?
fn rebounds(find: &Find, known: &Known<Value>) -> Option<bool> {
    let Find::Quantity(quantity) = find else { return None };
    let along = known.number(quantity.along_the_line()?)?;
    along.sign().map(Ordering::is_lt)
}

/// Does the sphere go back along the line of centres, or is it to go back if the letter lies in a range? Nobody does who had
/// no velocity along it, or has none left.
fn turns_back(find: &Find, scene: &Scene, known: &Known<Value>) -> Option<bool> {
    let (after, sign_after) = match find {
        _ if is_letter(find) => way_wanted(scene)?,
        Find::Quantity(quantity) => {
            let after = quantity.along_the_line().unwrap_or(*quantity);
            (after, sign(after, known)?)
        }
        _ => return None,
    };
    let before = after.before_its_impact()?;
    // Where a letter is sought, nothing has been worked out so far.
    let mut known = Cow::Borrowed(known);
    if known.number(before).is_none() {
        Derivation::carry_out(known.to_mut(), &[before]);
    }
    Some(sign(before, &known)? != sign_after)
}

/// Is a letter to be found, of which e is one?
fn is_letter(find: &Find) -> bool {
    matches!(find, Find::Unknown(_) | Find::Quantity(Quantity::Restitution))
}

/// Do both spheres of an impact move the same way, and along the line of centres?
fn same_way(find: &Find, scene: &Scene, known: &Known<Value>) -> Option<bool> {
    let Find::Quantity(quantity) = find else { return None };
    let own = quantity.along_the_line()?;
    let Quantity::Velocity(sphere, moment, _) = own.of_its_impact() else { return None };
    let strangers = strangers(find, scene);
    let other = Sphere::ALL.into_iter().find(|other| *other != sphere && !strangers.contains(other))?;
    let of_other = Quantity::Velocity(other, moment, Axis::N).in_impact(own.impact())?;
    let is_along = |quantity: Quantity| Some(known.number(quantity.along(Axis::T))?.sign()?.is_eq());
    (is_along(own)? && is_along(of_other)?).then(|| Some(sign(own, known)? == sign(of_other, known)?))?
}

fn sign(quantity: Quantity, known: &Known<Value>) -> Option<Ordering> {
    known.number(quantity)?.sign().filter(|sign| sign.is_ne())
}

/// The velocity of which a condition wants the sign, and that sign.
fn way_wanted(scene: &Scene) -> Option<(Quantity, Ordering)> {
    scene.conditions.iter().find_map(|condition| {
        let Expr::Name(name) = &condition.left else { return None };
        let sign = match condition.relation {
            Relation::Less => Ordering::Less,
            Relation::Greater => Ordering::Greater,
            _ => return None,
        };
        condition.right.is_zero().then(|| Some((name.text.parse().ok()?, sign)))?
    })
}

/// Are two spheres to meet again if a letter lies in a range, or not to? They do where the one ahead, whose name comes later,
/// is the slower.
fn meet_again(find: &Find, scene: &Scene) -> Option<bool> {
    let velocity = |expr: &Expr| match expr {
        Expr::Name(name) => name.text.parse::<Quantity>().ok().map(Quantity::of_its_impact),
        _ => None,
    };
    let after = |expr: &Expr| match velocity(expr)? {
        Quantity::Velocity(sphere, Moment::After, _) => Some(sphere),
        _ => None,
    };
    if !is_letter(find) {
        return None;
    }
    scene.conditions.iter().find_map(|condition| {
        let (left, right) = (after(&condition.left)?, after(&condition.right)?);
        let is_less = match condition.relation {
            Relation::Less | Relation::LessOrEqual => true,
            Relation::Greater | Relation::GreaterOrEqual => false,
            _ => return None,
        };
        (left != right).then_some(is_less == (left > right))
    })
}

/// Does what is asked point above **i**, or turn anticlockwise, as **i** and **j** have it?
fn anticlockwise(find: &Find, known: &Known<Value>) -> Option<bool> {
    let Find::Quantity(quantity) = find else { return None };
    let of_impact = |own: Quantity| own.in_impact(quantity.impact());
    let along = |sphere, moment, axis| known.number(of_impact(Quantity::Velocity(sphere, moment, axis))?);
    let upwards = match quantity.of_its_impact() {
        Quantity::AngleFromI(sphere, moment) => along(sphere, moment, Axis::Y)?,
        Quantity::ImpulseAngle => known.number(of_impact(Quantity::Impulse(Sphere::A, Axis::Y))?)?,
        Quantity::Deflection(sphere) | Quantity::SignedDeflection(sphere) | Quantity::TanDeflection(sphere) => {
            let [x, y] = [Axis::X, Axis::Y].map(|axis| along(sphere, Moment::Before, axis));
            let [p, q] = [Axis::X, Axis::Y].map(|axis| along(sphere, Moment::After, axis));
            &(&x? * &q?) - &(&y? * &p?)
        }
        _ => return None,
    };
    upwards.sign().filter(|sign| sign.is_ne()).map(Ordering::is_gt)
}

/// Does the impulse on a body that is alone point against **i**?
fn against_i(find: &Find, known: &Known<Value>, scene: &Scene) -> Option<bool> {
    let Find::Quantity(quantity @ Quantity::ImpulseAngle) = find else { return None };
    let along = known.number(Quantity::Impulse(Sphere::A, Axis::X).in_impact(quantity.impact())?)?;
    along.sign().filter(|sign| sign.is_ne() && scene.setting.is_of_one()).map(Ordering::is_lt)
}

/// The vector in **i** and **j** of which the size is asked.
fn vector(find: &Find, known: &Known<Value>) -> Option<[Expr; 2]> {
    let Find::Quantity(quantity) = find else { return None };
    let is_in_i_and_j = known.number(Quantity::Velocity(Sphere::A, Moment::Before, Axis::X)).is_some();
    let along = |axis: Axis| {
        let own = match quantity.of_its_impact() {
            Quantity::Speed(sphere, moment) => Quantity::Velocity(sphere, moment, axis),
            Quantity::ImpulseMagnitude => Quantity::Impulse(Sphere::A, axis),
            _ => return None,
        };
        let own = own.in_impact(quantity.impact())?;
        // Of an impulse along one axis its size is found without them.
        let mut known = Cow::Borrowed(known);
        if known.number(own).is_none() && is_in_i_and_j {
            Derivation::carry_out(known.to_mut(), &[own]);
        }
        Some(written(&known.number(own)?))
    };
    Some([along(Axis::X)?, along(Axis::Y)?])
}

/// Does the impulse of which the size is asked act from B to A, or away from a wall? Its name tells on whom: `impulse on B`.
fn pushes_back(name: &str, find: &Find, scene: &Scene) -> Option<bool> {
    let Find::Quantity(quantity) = find else { return None };
    let then = scene.then.iter().find(|then| then.meeting.number == quantity.impact());
    let is_of_wall = then.map_or(scene.setting == Setting::Wall, |then| then.meeting.with_wall);
    let (_, on) = name.split_once(" on ").unwrap_or_default();
    match then.map_or(Sphere::BOTH, |then| then.meeting.of) {
        _ if quantity.of_its_impact() != Quantity::ImpulseMagnitude => None,
        _ if is_of_wall => Some(true),
        Sphere::BOTH => Some(Sphere::BOTH.into_iter().find(|sphere| sphere.name() == on)? == Sphere::A),
        // Which way C lies nobody has said.
        _ => None,
    }
}

/// The spheres that take no part in the impact to which a quantity belongs, or of whose way a condition says nothing.
fn strangers(find: &Find, scene: &Scene) -> Vec<Sphere> {
    if let Some((Quantity::Velocity(own, ..), _)) =
        way_wanted(scene).filter(|_| is_letter(find)).map(|(wanted, sign)| (wanted.of_its_impact(), sign))
    {
        return Sphere::ALL.into_iter().filter(|sphere| *sphere != own).collect();
    }
    let Find::Quantity(quantity) = find else { return Vec::new() };
    let then = scene.then.iter().find(|then| then.meeting.number == quantity.impact());
    let (of, is_of_one) = match then {
        Some(then) => (then.meeting.of, then.meeting.with_wall),
        None => ([Sphere::A, Sphere::B], scene.setting.is_of_one()),
    };
    let takes_part = |sphere: &Sphere| *sphere == of[0] || *sphere == of[1] && !is_of_one;
    [Sphere::A, Sphere::B, Sphere::C].into_iter().filter(|sphere| !takes_part(sphere)).collect()
}

/// The acute angle between the path of a sphere whose speed is asked and the line of centres.
fn path(find: &Find, known: &Known<Value>) -> Option<Expr> {
    let Find::Quantity(quantity) = find else { return None };
    let along = quantity.along_the_line()?;
    let size = |axis: Axis| Some(Expr::call(Function::Abs, written(&known.number(along.along(axis))?)));
    let is_nought =
        |axis: Axis| known.number(along.along(axis)).is_some_and(|value| value.sign() == Some(Ordering::Equal));
    match (is_nought(Axis::N), is_nought(Axis::T)) {
        (true, true) => None,
        (true, false) => Some(Expr::integer(90)),
        (false, true) => Some(Expr::integer(0)),
        (false, false) => Some(Expr::call(Function::Atan, size(Axis::T)?.over(size(Axis::N)?))),
    }
}
