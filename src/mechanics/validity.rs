//! Could it happen? Approach before, signed separation after, 0 ≤ e ≤ 1, and every law kept.
//!
//! Energy does not tell: spheres that pass through each other lose energy too. Only the *signed*
//! separation along the line of centres shows that they do.

use std::cmp::Ordering;

use super::later::Meeting;
use super::law::{ALONG, Here, Known, MASSES, Rule, all_rules};
use super::refusal::Refusal;
use super::{Axis, Derivation, Moment, Quantity, Sphere};
use crate::expr::{print, written};
use crate::number::{Letter, Value};

/// Refuses what cannot happen, as far as what is given determines it; all that was derived on the way.
///
/// # Errors
///
/// The first reason found.
pub fn check(given: &Known<Value>) -> Result<Known<Value>, Refusal> {
    check_on(given, given.clone())
}

/// The same where what is given is the beginning of what is known, and some of what follows has been derived already.
///
/// # Errors
///
/// The first reason found.
pub fn check_on(given: &Known<Value>, mut known: Known<Value>) -> Result<Known<Value>, Refusal> {
    let impacts = [Meeting::FIRST].into_iter().chain(Meeting::all(given.0.keys()));
    for meeting in impacts {
        let here = Here::at(meeting, given);
        let sides = sides(&here).into_iter().map(|quantity| meeting.quantity(quantity));
        Derivation::carry_on(&mut known, given.0.len(), &sides.collect::<Vec<_>>());
        // The line of a later impact goes from the one sphere to the other wherever the earlier one has left them.
        let line_is_given =
            meeting.number > 0 || here.knows(Quantity::Line(Axis::X)) || here.knows(Quantity::ContactSine);
        let checked = one(&Here::at(meeting, &known), here.knows(Quantity::Restitution), line_is_given);
        checked.map_err(|refusal| if meeting.number > 0 { refusal.at(meeting) } else { refusal })?;
    }
    Ok(known)
}

/// One impact, of which the coefficient of restitution and the line of centres may be given or have come out.
fn one(known: &Here<Value>, e_is_given: bool, line_is_given: bool) -> Result<(), Refusal> {
    impulse_given(known)?;
    masses(known)?;
    approach(known, line_is_given)?;
    restitution(known, e_is_given)?;
    kept(known)
}

fn is_nought(known: &Here<Value>, quantity: Quantity) -> bool {
    known.number(quantity).is_some_and(|value| value.is_written_zero())
}

fn sign(known: &Here<Value>, quantity: Quantity) -> Option<Ordering> {
    known.number(quantity)?.sign()
}

fn show(value: &Value) -> String {
    print::unicode(&written(value))
}

fn masses(known: &Here<Value>) -> Result<(), Refusal> {
    for (mass, name) in MASSES.into_iter().zip(["A", "B"]) {
        if sign(known, mass).is_some_and(Ordering::is_le) {
            let value = known.number(mass).map_or(String::new(), |value| show(&value));
            return Err(Refusal::impossible(format!("the mass of {name} would be {value}, which is not positive")));
        }
    }
    if sign(known, Quantity::MassRatio).is_some_and(Ordering::is_le) {
        return Err(Refusal::impossible(
            "along the line of centres the velocities of A and B change the same way: no positive masses conserve momentum",
        ));
    }
    Ok(())
}

/// A sphere whose velocity is given before and after, and is the same, was not struck; and an impulse changes no velocity
/// against itself.
fn impulse_given(known: &Here<Value>) -> Result<(), Refusal> {
    for sphere in Sphere::BOTH {
        // A wall has no mass, and stands still.
        if !known.knows(Quantity::Mass(sphere)) && known.knows(Quantity::SphereEnergyLost(sphere)) {
            continue;
        }
        if let Some([x, y]) = change(known, sphere)
            && x.is_zero()
            && y.is_zero()
        {
            let name = sphere.name();
            return Err(Refusal::impossible(format!(
                "the velocity of {name} is the same before and after: no impulse acted, so there was no impact"
            )));
        }
    }
    if let (Some([p, q]), Some([x, y])) = (given_impulse(known), change(known, Sphere::A))
        && (&(&p * &x) + &(&q * &y)).sign() == Some(Ordering::Less)
    {
        return Err(Refusal::impossible(
            "the impulse is opposite to the change of the velocity of A: no positive mass does that",
        ));
    }
    Ok(())
}

/// The impulse as it is given, along i and j.
fn given_impulse(known: &Here<Value>) -> Option<[Value; 2]> {
    known.numbers([Axis::X, Axis::Y].map(Quantity::GivenImpulse))
}

/// The change of a sphere's velocity, along i and j.
fn change(known: &Here<Value>, sphere: Sphere) -> Option<[Value; 2]> {
    let at = |moment, axis| known.number(Quantity::Velocity(sphere, moment, axis));
    let along = |axis| Some(&at(Moment::After, axis)? - &at(Moment::Before, axis)?);
    Some([along(Axis::X)?, along(Axis::Y)?])
}

fn approach(known: &Here<Value>, line_is_given: bool) -> Result<(), Refusal> {
    let Some(approach) = known.number(Quantity::Approach) else { return Ok(()) };
    match approach.sign() {
        Some(Ordering::Less) => Err(Refusal::impossible(format!(
            "the spheres do not approach: along the line of centres from A to B, A moves {} slower than B, so there is no impact",
            show(&-&approach)
        ))
        .try_this(match line_is_given {
            true => "check the direction of the line of centres, or leave out `sense`",
            false => "check the velocities after the impact: the impulse on A is away from B",
        })),
        Some(Ordering::Equal) => Err(Refusal::impossible(
            "the spheres have equal velocities along the line of centres: they do not approach, so there is no impact",
        )
        .try_this("turn a velocity that is given")),
        _ => Ok(()),
    }
}

fn restitution(known: &Here<Value>, e_is_given: bool) -> Result<(), Refusal> {
    let separation = known.number(Quantity::Separation);
    let e = known.number(Quantity::Restitution);
    if let Some(e) = e.as_ref().filter(|_| e_is_given) {
        let beyond = match (e.sign(), (e - &Value::ONE).sign()) {
            (Some(Ordering::Less), _) => "negative",
            (_, Some(Ordering::Greater)) => "above 1",
            _ => "",
        };
        if !beyond.is_empty() {
            let reason = format!("the coefficient of restitution is given as {}, which is {beyond}", show(e));
            return Err(Refusal::impossible(reason).try_this("give a number from 0 to 1"));
        }
    }
    if let Some(separation) = &separation
        && separation.sign() == Some(Ordering::Less)
    {
        // Not the one that is given, which is another.
        let would_be = known.number(Quantity::Approach).and_then(|approach| separation.divided_by(&approach));
        let energy_falls = would_be.as_ref().is_some_and(|e| (e + &Value::ONE).sign() == Some(Ordering::Greater));
        return Err(Refusal::impossible(format!(
            "after the impact A would still be moving into B: the separation along the line of centres is {}, which is negative{}; the spheres would pass through each other{}",
            show(separation),
            would_be.map_or(String::new(), |e| format!(" (e would be {})", show(&e))),
            if energy_falls { ", though kinetic energy falls" } else { "" }
        )));
    }
    let Some(e) = e else { return Ok(()) };
    if e.sign() == Some(Ordering::Less) {
        return Err(Refusal::impossible(format!(
            "the coefficient of restitution would be {}, which is negative: the spheres would pass through each other",
            show(&e)
        )));
    }
    if (&e - &Value::ONE).sign() == Some(Ordering::Greater) {
        return Err(Refusal::impossible(format!(
            "the coefficient of restitution would be {}, which is above 1: the impact would create kinetic energy",
            show(&e)
        )));
    }
    Ok(())
}

/// Where more is given than is needed, the laws must agree with all of it.
fn kept(derived: &Here<Value>) -> Result<(), Refusal> {
    match broken(derived).into_iter().next() {
        Some(broken) => Err(Refusal::impossible(broken.reason)),
        None => Ok(()),
    }
}

/// A law of which everything is known and which is not kept.
#[derive(Debug)]
pub struct Broken {
    /// The equation that the law gives of two velocities after the impact, if it is momentum or restitution.
    pub equation: Option<Quantity>,
    /// What is wrong.
    pub reason: String,
    /// By how much.
    pub difference: Value,
}

/// Each law that is not kept.
pub fn broken_laws(known: &Known<Value>) -> Vec<Broken> {
    let mut all = known.clone();
    Derivation::carry_out(&mut all, &sides(&Here::at(Meeting::FIRST, known)));
    broken(&Here::at(Meeting::FIRST, &all))
}

/// The laws that determine unknowns where more is given than is needed, each as the rule that would find a mass or *e* by it.
pub fn demanding(unknowns: &[Letter], broken: &[Broken]) -> Vec<&'static Rule> {
    let is_open = |law: &&Broken| law.difference.has_letter(|letter| unknowns.contains(letter));
    let equations = broken.iter().filter(is_open).filter_map(|law| law.equation);
    let rule = |equation: Quantity| {
        all_rules(&[]).iter().find(|rule| {
            let is_of_it = rule.law.gives(equation) && ALONG.iter().all(|along| rule.needs.contains(along));
            is_of_it && matches!(rule.gives[..], [Quantity::Mass(Sphere::B) | Quantity::Restitution])
        })
    };
    equations.filter_map(rule).collect()
}

/// The same, once everything has been derived. A law that is kept needs no words, and gets none.
fn broken(known: &Here<Value>) -> Vec<Broken> {
    let mut broken = Vec::new();
    let mut compare_in = |equation: Option<Quantity>, one: &Value, other: &Value, reason: &dyn Fn() -> String| {
        if one == other {
            return;
        }
        let difference = other - one;
        if !difference.is_zero() {
            broken.push(Broken { equation, reason: reason(), difference });
        }
    };
    let mut compare = |one: &Value, other: &Value, reason: &dyn Fn() -> String| compare_in(None, one, other, reason);
    // Of a given impulse the line of centres is only the direction: it, and not the line, says what changes.
    let is_given = given_impulse(known).is_some();
    for (axis, name) in [(Axis::X, "i"), (Axis::Y, "j")] {
        let at = |moment| Quantity::Velocity(Sphere::A, moment, axis);
        let needs = [Quantity::GivenImpulse(axis), MASSES[0], at(Moment::Before), at(Moment::After)];
        if let Some([impulse, mass, before, after]) = known.numbers(needs) {
            let change = &mass * &(&after - &before);
            compare(&impulse, &change, &|| {
                format!(
                    "along {name} the impulse is {}, but the momentum of A changes by {}",
                    show(&impulse),
                    show(&change)
                )
            });
        }
    }
    if let (None, Some([p, q]), Some([x, y])) =
        (known.number(MASSES[0]), given_impulse(known), change(known, Sphere::A))
    {
        compare(&(&p * &y), &(&q * &x), &|| {
            "the impulse is not parallel to the change of the velocity of A".to_owned()
        });
    }
    for sphere in Sphere::BOTH.into_iter().filter(|_| !is_given) {
        let at = |moment| known.number(Quantity::Velocity(sphere, moment, Axis::T));
        if let (Some(before), Some(after)) = (at(Moment::Before), at(Moment::After)) {
            compare(&before, &after, &|| {
                format!(
                    "the component of {}'s velocity perpendicular to the line of centres would change from {} to {}, but smooth spheres exert no force that way",
                    sphere.name(),
                    show(&before),
                    show(&after)
                )
            });
        }
    }
    let [a, b, x, y] = ALONG;
    let [m_a, m_b] = MASSES;
    if let Some([m_a, m_b, a, b, x, y]) = known.numbers([m_a, m_b, a, b, x, y]) {
        let before = &(&m_a * &a) + &(&m_b * &b);
        let after = &(&m_a * &x) + &(&m_b * &y);
        compare_in(Some(Quantity::MomentumEquation), &before, &after, &|| {
            format!(
                "momentum along the line of centres would change from {} to {}, but no outside force acts",
                show(&before),
                show(&after)
            )
        });
    }
    if let Some([e, a, b, x, y]) = known.numbers([Quantity::Restitution, a, b, x, y]) {
        let (expected, separation) = (&e * &(&a - &b), &y - &x);
        compare_in(Some(Quantity::RestitutionEquation), &expected, &separation, &|| {
            format!(
                "the separation along the line of centres is {}, but e times the approach is {}",
                show(&separation),
                show(&expected)
            )
        });
    }
    broken
}

/// The laws speak of no more quantities than these.
const MOST_SIDES: usize = 18;

/// What the laws speak of, and can be at odds with what is given.
fn sides(known: &Here<Value>) -> Vec<Quantity> {
    let moments = [Moment::Before, Moment::After];
    let mut asked = Vec::with_capacity(MOST_SIDES);
    if is_of_an_impulse(known) {
        asked.push(MASSES[0]);
        for axis in [Axis::X, Axis::Y] {
            asked.extend(moments.map(|moment| Quantity::Velocity(Sphere::A, moment, axis)));
        }
        return asked;
    }
    asked.extend([Quantity::Approach, Quantity::Separation, Quantity::Restitution, MASSES[0]]);
    // Of what stands still before and after, as a wall does, no mass follows; and of masses that are given no ratio is asked.
    let stands_still = || ALONG.into_iter().skip(1).step_by(2).all(|along| is_nought(known, along));
    if !MASSES.into_iter().all(|mass| known.knows(mass)) && !stands_still() {
        asked.extend([MASSES[1], Quantity::MassRatio]);
    }
    asked.extend(ALONG);
    // Where nothing is given of how a sphere moves after the impact, it is known only because nothing changes across the line.
    for sphere in Sphere::BOTH.into_iter().filter(|sphere| is_given_after(known, *sphere)) {
        asked.extend(moments.map(|moment| Quantity::Velocity(sphere, moment, Axis::T)));
    }
    asked
}

/// An impulse on one body, from nothing that moves: no line of centres and no *e*, only a momentum that changes.
fn is_of_an_impulse(given: &Here<Value>) -> bool {
    let of_b = Quantity::Velocity(Sphere::B, Moment::Before, Axis::N);
    given.knows(Quantity::SphereEnergyLost(Sphere::B)) && !given.knows(of_b)
}

fn is_given_after(given: &Here<Value>, sphere: Sphere) -> bool {
    let after = Moment::After;
    let components = [Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, after, axis));
    [Quantity::Speed(sphere, after), Quantity::GivenDirection(sphere, after)]
        .into_iter()
        .chain(components)
        .any(|quantity| given.knows(quantity))
}
