//! Smooth spheres exert no force across the line of centres: each keeps its component along the tangent.
//!
//! `t·v = t·u` for each sphere by itself.

use super::{Known, Law, Line, Outcome, Rule, Show, Slip, number, rule, velocity};
use crate::expr::print::plain;
use crate::expr::{Expr, written};
use crate::mechanics::Axis::T;
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Quantity, Sphere};
use crate::number::{Number, Value};

pub const NAME: &str = "perpendicular";

pub const ACCURACY: &str = "component perpendicular to the line of centres unchanged";

pub const METHOD: (&str, &str) =
    ("component perpendicular to the line of centres unchanged", "seen anywhere, on a diagram too");

pub const SLIPS: &[Slip] = &[
    Slip {
        tag: "e-on-perpendicular",
        sentence: "The spheres are smooth: no impulse acts along the tangent, so that component is unchanged; e acts only along the line of centres.",
    },
    Slip {
        tag: "perpendicular-dropped",
        sentence: "You have the component along the line of centres; combine it with the unchanged perpendicular component.",
    },
];

pub fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    for sphere in Sphere::BOTH {
        let (before, after) = (velocity(sphere, Before, T), velocity(sphere, After, T));
        rules.push(rule(Law::Perpendicular, 0, &[before], &[after], 1));
        rules.push(rule(Law::Perpendicular, 1, &[after], &[before], 1));
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Known<N>) -> Outcome<N> {
    number(known.number(rule.needs[0])?)
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let component = known.number(rule.needs[0])?;
    match slip {
        "e-on-perpendicular" => number(known.number(Quantity::Restitution)? * component),
        "perpendicular-dropped" => number(component.nought()),
        _ => None,
    }
}

/// `4 sin 30° = 2`; nothing if there is no such component.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    let Quantity::Velocity(sphere, moment, _) = rule.gives[0] else { return None };
    let known = if moment == After { Before } else { After };
    let value = show.worked(rule.needs[0]);
    if value.is_zero() { None } else { Some(component(show.across(sphere, known), &value)) }
}

/// The component as a student first writes it, and its value where that is another form.
fn component(shown: Expr, value: &Value) -> Expr {
    let exact = written(value);
    // `(2v) sin α` is no other form than `2v sin α`.
    if plain(&shown) == plain(&exact) { exact } else { Expr::equation(shown, exact) }
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    let Quantity::Velocity(sphere, moment, _) = rule.gives[0] else { return Vec::new() };
    let known = if moment == After { Before } else { After };
    let name = Expr::name(sphere.name());
    let value = show.worked(rule.needs[0]);
    if value.is_zero() {
        let words = "{A} has no velocity perpendicular to the line of centres, and none is given to it: it moves along the line of centres.";
        return vec![Line::with(words, &[("A", name)], vec![])];
    }
    let component = component(show.across(sphere, known), &value);
    if sphere == Sphere::B && !show.worked(velocity(Sphere::A, moment, T)).is_zero() {
        // A's line has just said why.
        let words = "In the same way that of {A} does not change: it is {p m/s}.";
        return vec![Line::with(words, &[("A", name), ("p", component)], vec![])];
    }
    let words = "The spheres are smooth, so the component of the velocity of {A} perpendicular to the line of centres does not change: it is {p m/s}.";
    vec![Line::with(words, &[("A", name), ("p", component)], vec![])]
}
