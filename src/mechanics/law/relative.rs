//! Velocities relative to each other: approach and separation along the line of centres, angles between.
//!
//! `approach = a - b` and `separation = y - x`, positive when the spheres near, and when they part.

use smallvec::smallvec;

use super::{Shape, Seen, ALONG, Datum, Here, Law, Line, MASSES, Outcome, Rule, Show, Slip, number, rule, silent, velocity, first_equation};
use crate::expr::Expr;
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::Quantity;
use crate::mechanics::Sphere::{A, B};
use crate::number::Number;

pub const NAME: &str = "relative";

pub const SEEN: Seen = Seen::Value(&[Quantity::Approach, Quantity::Separation], Shape::Any);

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) = ("relative velocity along the line of centres", "condone the order of the difference");

pub const SLIPS: &[Slip] = &[];

const APPROACH: u8 = 0;
const SEPARATION: u8 = 1;
const MASS_RATIO: u8 = 2;
const BETWEEN: u8 = 3;
const ALPHA: u8 = 4;

pub fn rules() -> Vec<Rule> {
    let [a, b, x, y] = ALONG;
    let mut rules = vec![
        rule(Law::Relative, APPROACH, &[a, b], &[Quantity::Approach], 1),
        rule(Law::Relative, SEPARATION, &[y, x], &[Quantity::Separation], 1),
        rule(Law::Relative, MASS_RATIO, &[MASSES[1], MASSES[0]], &[Quantity::MassRatio], 1),
    ];
    for moment in [Before, After] {
        for axes in [[N, T], [X, Y]] {
            let needs = [A, B].map(|sphere| axes.map(|axis| velocity(sphere, moment, axis))).concat();
            rules.push(rule(Law::Relative, BETWEEN, &needs, &[Quantity::AngleBetween(moment)], 2));
        }
    }
    let needs = [a, velocity(A, Before, T), b, velocity(B, Before, T)];
    rules.push(rule(Law::Relative, ALPHA, &needs, &[Quantity::Alpha], 2));
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let n = &rule.needs;
    match rule.form {
        APPROACH | SEPARATION => number(known.number(n[0])? - known.number(n[1])?),
        MASS_RATIO => number(known.number(n[0])?.over(&known.number(n[1])?)?),
        BETWEEN => {
            let [a, b, c, d] = known.numbers([n[0], n[1], n[2], n[3]])?;
            if (a.is_nought() && b.is_nought()) || (c.is_nought() && d.is_nought()) {
                return None;
            }
            let y = (a.clone() * d.clone() - b.clone() * c.clone()).size();
            Some(smallvec![Datum::Direction { y, x: a * c + b * d }])
        }
        _ => {
            let [a, p, b, q] = known.numbers([n[0], n[1], n[2], n[3]])?;
            Some(smallvec![Datum::Direction { y: (p - q).size(), x: (a - b).size() }])
        }
    }
}

pub fn slipped<N: Number>(_: &str, _: &Rule, _: &Here<N>) -> Outcome<N> {
    None
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    let words = match rule.form {
        APPROACH => "Along the line of centres the spheres approach at {v m/s}.",
        SEPARATION => "Along the line of centres they separate at {v m/s}.",
        MASS_RATIO => "The mass of *B* over the mass of *A* is {v}.",
        _ => return show.statement(rule.gives[0]),
    };
    if !show.is_asked(rule.gives[0]) {
        return silent();
    }
    vec![Line::with(words, &[("v", show.value(rule.gives[0]))], vec![])]
}
