//! Momentum is conserved as a vector.
//!
//! `m_A u_A + m_B u_B = m_A v_A + m_B v_B`. Three velocities and the masses give the fourth velocity; four
//! velocities give the ratio of the masses.

use super::{Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, number, rule, velocity, first_equation, with_inputs};
use crate::mechanics::formula::times;
use crate::expr::Expr;
use crate::mechanics::Axis::{X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::Sphere::{A, B};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "vector momentum";

pub const SEEN: Seen = Seen::VectorEquation;

pub const ACCURACY: &str = "correct equation, unsimplified";

pub const METHOD: (&str, &str) = ("conservation of momentum as a vector equation, four terms", "condone sign errors");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 44,
        tag: "division-forgotten",
        did: "did not divide by the mass of the sphere",
        sentence: "That is the momentum of the sphere: divide by its mass for its velocity.",
        also: &[],
        condoned: true,
    },
];

const STATES: [(Sphere, Moment); 4] = [(A, Before), (B, Before), (A, After), (B, After)];

/// Forms 0 to 3 find a velocity, in the order of `STATES`; these find a mass, the totals the momentum.
const MASS_OF_A: u8 = 4;
const MASS_OF_B: u8 = 5;
const TOTAL: u8 = 6;
const OF_ONE: u8 = 7;

fn both(state: (Sphere, Moment)) -> [Quantity; 2] {
    [velocity(state.0, state.1, X), velocity(state.0, state.1, Y)]
}

pub fn rules() -> Vec<Rule> {
    let masses = [Quantity::Mass(A), Quantity::Mass(B)];
    let mut rules = Vec::new();
    for (index, unknown) in STATES.into_iter().enumerate() {
        let mut needs = masses.to_vec();
        needs.extend(STATES.into_iter().filter(|state| *state != unknown).flat_map(both));
        rules.push(rule(Law::VectorMomentum, index as u8, &needs, &both(unknown), 2));
    }
    for (form, given, unknown) in [(MASS_OF_A, masses[1], masses[0]), (MASS_OF_B, masses[0], masses[1])] {
        let mut needs = vec![given];
        needs.extend(STATES.into_iter().flat_map(both));
        rules.push(rule(Law::VectorMomentum, form, &needs, &[unknown], 2));
    }
    for axis in [X, Y] {
        for (sphere, moment) in STATES {
            let needs = [Quantity::Mass(sphere), velocity(sphere, moment, axis)];
            rules.push(rule(Law::VectorMomentum, OF_ONE, &needs, &[Quantity::SphereMomentum(sphere, moment, axis)], 1));
        }
        for moment in [Before, After] {
            let needs = [Quantity::SphereMomentum(A, moment, axis), Quantity::SphereMomentum(B, moment, axis)];
            let cost = if moment == Before { 1 } else { 2 };
            rules.push(rule(Law::VectorMomentum, TOTAL, &needs, &[Quantity::TotalMomentum(axis)], cost));
        }
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match rule.form {
        OF_ONE => number(known.number(rule.needs[0])? * known.number(rule.needs[1])?),
        TOTAL => number(known.number(rule.needs[0])? + known.number(rule.needs[1])?),
        MASS_OF_A => mass(A, known),
        MASS_OF_B => mass(B, known),
        form => {
            let (sphere, moment) = STATES[form as usize];
            [X, Y].into_iter().map(|axis| component(sphere, moment, axis, known).map(Datum::Number)).collect()
        }
    }
}

/// The component of the one velocity that is not known.
fn component<N: Number>(sphere: Sphere, moment: Moment, axis: Axis, known: &Here<N>) -> Option<N> {
    let other = if moment == Before { After } else { Before };
    let beside = sphere.other();
    let [own, mass] = known.numbers([Quantity::Mass(sphere), Quantity::Mass(beside)])?;
    let [same, a, b] =
        known.numbers([velocity(sphere, other, axis), velocity(beside, other, axis), velocity(beside, moment, axis)])?;
    Some(same + (mass * (a - b)).over(&own)?)
}

/// The mass of a sphere from the changes of both velocities, along whichever axis they change.
fn mass<N: Number>(sphere: Sphere, known: &Here<N>) -> Outcome<N> {
    let change = |sphere: Sphere, axis| -> Option<N> {
        let [before, after] = known.numbers([velocity(sphere, Before, axis), velocity(sphere, After, axis)])?;
        Some(after - before)
    };
    let other = sphere.other();
    let given = known.number(Quantity::Mass(other))?;
    for axis in [X, Y] {
        let own = change(sphere, axis)?;
        if !own.is_nought() {
            return number(-(given * change(other, axis)?).over(&own)?);
        }
    }
    None
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match (slip, rule.form) {
        ("division-forgotten", form @ 0..=3) => {
            let sphere = STATES[form as usize].0;
            let [own, other] = known.numbers([Quantity::Mass(sphere), Quantity::Mass(sphere.other())])?;
            // A letter that both masses have is gone from the equation before: of *m* and 2*m* there is left 2.
            let own = own.over(&other)? * other.coefficient();
            let components = evaluate(rule, known)?;
            let multiplied = components.into_iter().map(|datum| match datum {
                Datum::Number(value) => Datum::Number(value * own.clone()),
                other => other,
            });
            Some(multiplied.collect())
        }
        ("masses-swapped", 0..=3) => {
            let [m_a, m_b] = known.numbers([Quantity::Mass(A), Quantity::Mass(B)])?;
            with_inputs(rule, known, &[(Quantity::Mass(A), m_b), (Quantity::Mass(B), m_a)])
        }
        ("masses-omitted", 0..=3) => {
            let one = known.number(Quantity::Mass(A))?.one();
            with_inputs(rule, known, &[(Quantity::Mass(A), one.clone()), (Quantity::Mass(B), one)])
        }
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match rule.form {
        form @ 0..=3 => {
            let (sphere, moment) = STATES[form as usize];
            let name = Expr::name(show.vector_letter(sphere, moment));
            let unknown = Some((sphere, moment));
            let equation = Expr::equation(total(show, Before, unknown), total(show, After, unknown));
            vec![
                Line::plain("Momentum is conserved:", vec![equation]),
                found(show, sphere, moment, name),
            ]
        }
        MASS_OF_A | MASS_OF_B => {
            let equation = Expr::equation(total(show, Before, None), total(show, After, None));
            let found = Expr::equation(show.symbol(rule.gives[0]), show.shown_value(rule.gives[0]));
            vec![Line::plain("Momentum is conserved:", vec![equation, found])]
        }
        _ => show.statement(rule.gives[0]),
    }
}

/// The velocity with its unit; one that is only on the way needs no words.
fn found(show: &Show, sphere: Sphere, moment: Moment, name: Expr) -> Line {
    let mut equations = vec![Expr::equation(name.clone(), show.vector(sphere, moment))];
    equations.extend(show.approximate_velocity(&name, sphere, moment));
    let asked = [X, Y].iter().any(|axis| show.is_asked(velocity(sphere, moment, *axis)));
    let unit = show.in_units(&show.exact(velocity(sphere, moment, X)), "metres per second");
    let words = if asked { format!("So the velocity of {{A}} {moment} the impact{unit} is") } else { String::new() };
    Line::with(&words, &[("A", Expr::name(sphere.name()))], equations)
}

/// The total momentum at a moment, the velocity to be found under its letter.
fn total(show: &Show, moment: Moment, unknown: Option<(Sphere, Moment)>) -> Expr {
    Expr::sum(Sphere::BOTH.map(|sphere| {
        let velocity = if unknown == Some((sphere, moment)) {
            Expr::name(show.vector_letter(sphere, moment))
        } else {
            show.vector(sphere, moment)
        };
        times(show.mass(sphere), velocity)
    }))
}
