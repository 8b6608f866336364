//! Smooth spheres exert no force across the line of centres: each keeps its component along the tangent.
//!
//! `t·v = t·u` for each sphere by itself.

use super::{Seen, Here, Law, Line, MASSES, Outcome, Rule, Show, Slip, is_at_wall, number, rule, velocity};
use crate::expr::print::plain;
use crate::expr::{Expr, written};
use crate::mechanics::Axis::T;
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Moment, Quantity, Setting, Sphere};
use crate::number::Number;

pub const NAME: &str = "perpendicular";

pub const SEEN: Seen = Seen::Unchanged;

pub const ACCURACY: &str = "component perpendicular to the line of centres unchanged";

pub const METHOD: (&str, &str) =
    ("component perpendicular to the line of centres unchanged", "seen anywhere, on a diagram too");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 11,
        tag: "e-on-perpendicular",
        did: "multiplied the component across the line of centres by e as well",
        sentence: "Smooth spheres push each other along the line of centres alone: the component perpendicular to the line of centres is unchanged, and e has no part in it.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 12,
        tag: "perpendicular-dropped",
        did: "left out the component across the line of centres after the impact",
        sentence: "That is only the part along the line of centres: the component perpendicular to the line of centres is unchanged, and both belong together.",
        also: &[Law::Speed, Law::Direction],
        condoned: false,
    },
    Slip {
        place: 13,
        tag: "perpendicular-shared",
        did: "gave both spheres one component across the line of centres, as if momentum across were shared",
        sentence: "Across the line of centres each sphere keeps its own component; nothing passes from one to the other.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 20,
        tag: "wrong-axis",
        did: "let the components across the line of centres change and kept those along it",
        sentence: "It is along the line of centres that velocities change; the components perpendicular to the line of centres are unchanged.",
        also: &[Law::Solve, Law::Restitution, Law::Impulse],
        condoned: false,
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

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    number(known.number(rule.needs[0])?)
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let component = known.number(rule.needs[0])?;
    let Quantity::Velocity(sphere, After, _) = rule.gives[0] else { return None };
    match slip {
        "e-on-perpendicular" => number(known.number(Quantity::Restitution)? * component),
        "perpendicular-dropped" => number(component.nought()),
        "perpendicular-shared" => number(shared(known)?),
        // Turned back along the wall.
        "wrong-axis" if is_at_wall(known) => number(-(known.number(Quantity::Restitution)? * component)),
        "wrong-axis" => {
            // The impact as it would be along the tangent.
            let across = Sphere::BOTH.map(|sphere| velocity(sphere, Before, T));
            let [e, own, p, q] =
                known.numbers([Quantity::Restitution, Quantity::Mass(sphere.other()), across[0], across[1]])?;
            let total = known.number(MASSES[0])? + known.number(MASSES[1])?;
            let separation = if sphere == Sphere::A { e * (q - p) } else { e * (p - q) };
            number(shared(known)? + (own * separation).over(&total)?)
        }
        _ => None,
    }
}

/// The common component that both would have if they moved on together across the line of centres.
fn shared<N: Number>(known: &Here<N>) -> Option<N> {
    let across = Sphere::BOTH.map(|sphere| velocity(sphere, Before, T));
    let [m_a, m_b, p, q] = known.numbers([MASSES[0], MASSES[1], across[0], across[1]])?;
    (m_a.clone() * p + m_b.clone() * q).over(&(m_a + m_b))
}

/// `4 sin 30° = 2`; nothing if there is no such component.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    let Quantity::Velocity(sphere, moment, _) = rule.gives[0] else { return None };
    let known = if moment == After { Before } else { After };
    let value = show.worked(rule.needs[0]);
    if value.is_zero() { None } else { Some(component(show, sphere, known)) }
}

/// The component as a student first writes it, and its value where that is another form.
fn component(show: &Show, sphere: Sphere, known: Moment) -> Expr {
    let value = show.worked(velocity(sphere, known, T));
    if show.setting() == Setting::Wall && !show.along_an_axis() {
        // Along a wall that slants it counts in the sense in which the sphere moves.
        return written(&value.absolute());
    }
    let (shown, exact) = (show.across(sphere, known), written(&value));
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
    let component = component(show, sphere, known);
    if sphere == Sphere::B && !show.worked(velocity(Sphere::A, moment, T)).is_zero() {
        // A's line has just said why.
        let words = "In the same way that of {A} does not change: it is {p m/s}.";
        return vec![Line::with(words, &[("A", name), ("p", component)], vec![])];
    }
    let words = "The spheres are smooth, so the component of the velocity of {A} perpendicular to the line of centres does not change: it is {p m/s}.";
    vec![Line::with(words, &[("A", name), ("p", component)], vec![])]
}
