//! From a scene to what is known: the quantities that it gives, and the line of centres turned so that
//! it points from A to B.

use std::cmp::Ordering;

use super::later::{Meeting, row};
use super::law::{Datum, Known};
use super::refusal::Refusal;
use super::scene::{Contact, Scene, Then, Velocity};
use super::setting::Setting;
use super::{Axis, Derivation, Moment, Quantity, Sphere};
use crate::number::Value;

/// The quantities that a scene gives, of all its impacts.
///
/// # Errors
///
/// Spheres that do not approach, that miss each other, or that overlap from the start.
pub fn pose(scene: &Scene) -> Result<Known<Value>, Refusal> {
    let mut known = one(scene, &Carried::default())?;
    if scene.setting == Setting::Direct && !scene.then.is_empty() {
        put(&mut known, Quantity::InALine, &Value::ONE);
    }
    if scene.setting == Setting::Wall && !scene.then.is_empty() {
        put(&mut known, Quantity::Meeting(Meeting::FIRST_WITH_WALL), &Value::ONE);
    }
    for then in &scene.then {
        later(then, scene.setting == Setting::Direct, &mut known).map_err(|refusal| refusal.at(then.meeting))?;
    }
    Ok(known)
}

/// The components along i and j that spheres have kept from an earlier impact.
type Carried = [Option<(Value, Value)>; 2];

/// Adds what a later impact gives. Which way its line of centres points depends on the velocities that the earlier ones
/// left, so these are derived for that; they are known only by being carried over.
fn later(then: &Then, in_a_line: bool, known: &mut Known<Value>) -> Result<(), Refusal> {
    let meeting = then.meeting;
    let mut derived = known.clone();
    let scene = &then.scene;
    let is_carried = |part: &Sphere| scene.before[*part as usize].is_none();
    let mut carried = Carried::default();
    for part in Sphere::BOTH.into_iter().filter(is_carried) {
        let sphere = meeting.sphere(part);
        let Some(last) = meeting.last_of(sphere, &Meeting::said(known.0.keys())) else { continue };
        let there = last.part(sphere).unwrap_or(part);
        let left = [Axis::X, Axis::Y].map(|axis| last.quantity(Quantity::Velocity(there, Moment::After, axis)));
        Derivation::carry_out(&mut derived, &left);
        carried[part as usize] = derived.numbers(left).map(|[x, y]| (x, y));
    }
    let mut here = one(scene, &carried)?;
    if in_a_line && scene.setting == Setting::Wall {
        let along = velocity_before(scene, &carried, Sphere::A).map(|(along, _)| along);
        reaches_the_wall(along, meeting, &Meeting::all(known.0.keys()))?;
        along_one_line(&mut here);
    }
    for part in Sphere::BOTH.into_iter().filter(is_carried) {
        for axis in [Axis::X, Axis::Y, Axis::N] {
            here.0.remove(&Quantity::Velocity(part, Moment::Before, axis));
        }
    }
    known.0.insert(Quantity::Meeting(meeting), Datum::Number(Value::ONE));
    known.0.extend(here.0.into_pairs().map(|(quantity, datum)| (meeting.quantity(quantity), datum)));
    Ok(())
}

/// On one line a sphere strikes a wall only if no other lies between.
fn reaches_the_wall(along: Option<Value>, meeting: Meeting, before: &[Meeting]) -> Result<(), Refusal> {
    let row = row(before);
    let way = along.and_then(|velocity| velocity.sign());
    let place = row.iter().position(|sphere| *sphere == meeting.of[0]);
    let between = match (way, place) {
        (Some(Ordering::Greater), Some(place)) => row.get(place + 1),
        (Some(Ordering::Less), Some(place)) => place.checked_sub(1).and_then(|before| row.get(before)),
        _ => None,
    };
    match between {
        None => Ok(()),
        Some(other) => {
            let (own, other) = (meeting.of[0].name(), other.name());
            Err(Refusal::impossible_at(
                meeting,
                &format!("{own} moves towards {other}, which lies between it and the wall"),
            )
            .try_this(format!("put the impact of {own} and {other} in before this one")))
        }
    }
}

/// Nearly always an impact gives no more quantities than these.
const MOST_GIVEN: usize = 16;

/// The quantities that one impact gives, and the velocities that are kept from an earlier one.
fn one(scene: &Scene, carried: &Carried) -> Result<Known<Value>, Refusal> {
    let mut known = Known::default();
    known.0.reserve(MOST_GIVEN);
    for sphere in Sphere::BOTH {
        if let Some(mass) = scene.mass(sphere) {
            if mass.value.sign().is_some_and(Ordering::is_le) {
                return Err(Refusal::impossible(format!("the mass of {} is not positive", sphere.name())));
            }
            put(&mut known, Quantity::Mass(sphere), &mass.value);
        }
    }
    if let [Some(a), Some(b)] = Sphere::BOTH.map(|sphere| scene.mass(sphere)) {
        // As k - 1 and 1 - k, whose signs nobody knows.
        if (&a.value + &b.value).sign().is_some_and(Ordering::is_le) {
            return Err(Refusal::impossible("the masses of A and B are not both positive"));
        }
    }
    if let Some(e) = &scene.restitution {
        put(&mut known, Quantity::Restitution, &e.value);
    }
    for moment in [Moment::Before, Moment::After] {
        for sphere in Sphere::BOTH {
            match scene.velocity(sphere, moment) {
                None => {}
                Some(Velocity::Components(x, y)) => {
                    put(&mut known, Quantity::Velocity(sphere, moment, Axis::X), &x.value);
                    put(&mut known, Quantity::Velocity(sphere, moment, Axis::Y), &y.value);
                }
                Some(Velocity::Polar { speed, cos, sin, .. }) => {
                    put(&mut known, Quantity::Speed(sphere, moment), &speed.value);
                    let direction = Datum::Direction { y: sin.clone(), x: cos.clone() };
                    known.0.insert(Quantity::GivenDirection(sphere, moment), direction);
                }
            }
        }
    }
    for (sphere, velocity) in Sphere::BOTH.into_iter().zip(carried) {
        for (axis, component) in [Axis::X, Axis::Y].into_iter().zip(velocity.iter().flat_map(|(x, y)| [x, y])) {
            put(&mut known, Quantity::Velocity(sphere, Moment::Before, axis), component);
        }
    }
    contact(scene, carried, &mut known)?;
    of_setting(scene, &mut known);
    let is_open = || scene.before.iter().zip(carried).any(|(given, carried)| given.is_none() && carried.is_none());
    if matches!(scene.contact, Some(Contact::Along(_, _, None))) && is_open() {
        turn_to_approach(&mut known);
    }
    Ok(known)
}

/// What is known because of what the impact is between.
fn of_setting(scene: &Scene, known: &mut Known<Value>) {
    let nought = |known: &mut Known<Value>, quantity| put(known, quantity, &Value::ZERO);
    match scene.setting {
        Setting::Oblique => {}
        Setting::Direct => along_one_line(known),
        Setting::Wall => {
            for moment in [Moment::Before, Moment::After] {
                nought(known, Quantity::Velocity(Sphere::B, moment, Axis::N));
                nought(known, Quantity::Velocity(Sphere::B, moment, Axis::T));
            }
            without_energy_of_b(known);
        }
        Setting::Impulse => {
            for (axis, given) in [Axis::X, Axis::Y].into_iter().zip(scene.impulse.iter().flatten()) {
                put(known, Quantity::GivenImpulse(axis), &given.value);
                put(known, Quantity::Impulse(Sphere::A, axis), &given.value);
            }
            without_energy_of_b(known);
        }
    }
}

/// Along the line is along i, and nothing is across it.
fn along_one_line(known: &mut Known<Value>) {
    for (sphere, moment) in Sphere::BOTH.into_iter().flat_map(|of| [(of, Moment::Before), (of, Moment::After)]) {
        put(known, Quantity::Velocity(sphere, moment, Axis::T), &Value::ZERO);
        // No vectors: what is along i is the velocity itself.
        known.0.remove(&Quantity::Velocity(sphere, moment, Axis::Y));
        if let Some(Datum::Number(along)) = known.0.remove(&Quantity::Velocity(sphere, moment, Axis::X)) {
            let n = known.number(Quantity::Line(Axis::X)).unwrap_or(Value::ONE);
            put(known, Quantity::Velocity(sphere, moment, Axis::N), &(&along * &n));
        }
    }
}

/// What does not move has no kinetic energy, and loses none.
fn without_energy_of_b(known: &mut Known<Value>) {
    for moment in [Moment::Before, Moment::After] {
        put(known, Quantity::KineticEnergy(Sphere::B, moment), &Value::ZERO);
    }
    put(known, Quantity::SphereEnergyLost(Sphere::B), &Value::ZERO);
    put(known, Quantity::SphereEnergyGained(Sphere::B), &Value::ZERO);
}

/// Where no sense of the line of centres is given and a velocity before has first to be found, the line is turned
/// so that the spheres approach before, or else part after the impact.
fn turn_to_approach(known: &mut Known<Value>) {
    let mut derived = known.clone();
    let asked = [Quantity::Approach, Quantity::Separation];
    Derivation::carry_out(&mut derived, &asked);
    let mut signs =
        asked.into_iter().filter_map(|quantity| derived.number(quantity)?.sign()).filter(|sign| sign.is_ne());
    if signs.next() == Some(Ordering::Less) {
        for axis in [Axis::X, Axis::Y] {
            if let Some(component) = known.number(Quantity::Line(axis)) {
                put(known, Quantity::Line(axis), &-&component);
            }
        }
    }
}

fn put(known: &mut Known<Value>, quantity: Quantity, value: &Value) {
    known.0.insert(quantity, Datum::Number(value.clone()));
}

/// Components along i and j, however the velocity was given.
fn components(velocity: &Velocity) -> (Value, Value) {
    match velocity {
        Velocity::Components(x, y) => (x.value.clone(), y.value.clone()),
        Velocity::Polar { speed, cos, sin, .. } => (&speed.value * cos, &speed.value * sin),
    }
}

/// The components before the impact of a sphere, given or kept from an earlier one.
fn velocity_before(scene: &Scene, carried: &Carried, sphere: Sphere) -> Option<(Value, Value)> {
    let given = scene.velocity(sphere, Moment::Before).map(components);
    given.or_else(|| carried[sphere as usize].clone())
}

/// The velocity of A relative to B before the impact, where both are given.
pub(super) fn relative(scene: &Scene) -> Option<(Value, Value)> {
    relative_with(scene, &Carried::default())
}

fn relative_with(scene: &Scene, carried: &Carried) -> Option<(Value, Value)> {
    let [a, b] = Sphere::BOTH.map(|sphere| velocity_before(scene, carried, sphere));
    let ((a_x, a_y), (b_x, b_y)) = (a?, b?);
    Some((&a_x - &b_x, &a_y - &b_y))
}

fn contact(scene: &Scene, carried: &Carried, known: &mut Known<Value>) -> Result<(), Refusal> {
    let relative = relative_with(scene, carried);
    if let Some((x, y)) = &relative
        && x.is_zero()
        && y.is_zero()
    {
        let same = "A and B have the same velocity before, so neither approaches the other: there is no impact";
        return Err(Refusal::impossible(same).try_this(match scene.setting {
            Setting::Wall => "give A a velocity towards the wall",
            _ => "give A a velocity with which it comes nearer to B",
        }));
    }
    match &scene.contact {
        None => Ok(()),
        Some(Contact::Along(x, y, sense)) => {
            let speed = relative.map(|(u, v)| &(&u * x) + &(&v * y));
            let approaching = match (&speed, sense) {
                (Some(speed), _) if speed.is_zero() => Err(Refusal::impossible(
                    "the velocities of A and B have equal components along the line of centres: the spheres do not approach, so there is no impact",
                )
                .try_this(match scene.setting {
                    Setting::Wall => "turn the velocity or the wall: `wall` is a vector along it, and not across it",
                    Setting::Direct => "give A the greater velocity, positive from A to B",
                    _ => "turn a velocity or `line_of_centres`, which goes from the one centre to the other",
                })),
                (Some(speed), None) => Ok(speed.sign() != Some(Ordering::Less)),
                _ => Ok(true),
            }?;
            let size = (&(x * x) + &(y * y)).square_root().unwrap_or(Value::ONE);
            let unit = |component: &Value| -> Value {
                let unit = component.divided_by(&size).unwrap_or(Value::ZERO);
                if approaching { unit } else { -unit }
            };
            line(known, unit(x), unit(y));
            Ok(())
        }
        Some(Contact::Offset { offset, sum, .. }) => sine(known, &offset.value, &sum.value),
        Some(Contact::Apart(x, y, sum)) => {
            let distance = (&(x * x) + &(y * y)).square_root().unwrap_or(Value::ZERO);
            match (&distance - sum).sign() {
                Some(Ordering::Less) => Err(Refusal::impossible(
                    "the centres are closer together than the sum of the radii: the spheres overlap before the impact",
                )
                .try_this("give `positions` that are at least the sum of the `radii` apart")),
                Some(Ordering::Equal) => {
                    let unit = |component: &Value| component.divided_by(&distance).unwrap_or(Value::ZERO);
                    line(known, unit(x), unit(y));
                    Ok(())
                }
                _ => {
                    let Some((u, v)) = relative else {
                        return Err(Refusal::underdetermined(
                            "the spheres do not touch in these positions, and without both velocities before it is open where they will",
                        ));
                    };
                    if (&(&u * x) + &(&v * y)).sign().is_some_and(Ordering::is_le) {
                        return Err(Refusal::impossible(
                            "from these positions the spheres move apart: there is no impact",
                        ));
                    }
                    let speed = (&(&u * &u) + &(&v * &v)).square_root().unwrap_or(Value::ONE);
                    let offset = (&(&u * y) - &(&v * x)).divided_by(&speed).unwrap_or(Value::ZERO);
                    sine(known, &offset, sum)
                }
            }
        }
    }
}

fn line(known: &mut Known<Value>, x: Value, y: Value) {
    known.0.insert(Quantity::Line(Axis::X), Datum::Number(x));
    known.0.insert(Quantity::Line(Axis::Y), Datum::Number(y));
}

fn sine(known: &mut Known<Value>, offset: &Value, sum: &Value) -> Result<(), Refusal> {
    let sine = offset.divided_by(sum).unwrap_or(Value::ZERO);
    if (&(&sine * &sine) - &Value::ONE).sign().is_some_and(Ordering::is_ge) {
        return Err(Refusal::impossible(
            "the path of A passes B at a distance of at least the sum of the radii: the spheres miss each other",
        )
        .try_this("give a smaller `impact_parameter`, or larger `radii`"));
    }
    known.0.insert(Quantity::ContactSine, Datum::Number(sine));
    Ok(())
}
