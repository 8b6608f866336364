//! The angle through which the path of a sphere turns.
//!
//! `cross = u × v` and `dot = u · v` of the velocities before and after; the tangent of the deflection is
//! their quotient, and also `(tan β - tan α)/(1 + tan α tan β)` by the angles to the line of centres.

use super::{Datum, Known, Law, Line, Outcome, Rule, Show, Slip, number, rule, silent, velocity};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "deflection";

pub const METHOD: (&str, &str) =
    ("deflection as a difference of directions, expanded or by scalar product", "either order of the difference");

pub const SLIPS: &[Slip] = &[
    Slip {
        tag: "deflection-added",
        sentence: "Sketch both arrows from one point: is the angle between them the sum, the difference, or 180 minus the sum?",
    },
    Slip { tag: "tangents-subtracted", sentence: "Use the compound-angle formula." },
];

const CROSS: u8 = 0;
const DOT: u8 = 1;
const BY_TANGENTS: u8 = 2;
const BY_PRODUCTS: u8 = 3;
const ANGLE: u8 = 4;
const SIGNED: u8 = 5;

pub fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    for sphere in Sphere::BOTH {
        let (cross, dot) = (Quantity::DeflectionCross(sphere), Quantity::DeflectionDot(sphere));
        for axes in [[N, T], [X, Y]] {
            let at = |moment| axes.map(|axis| velocity(sphere, moment, axis));
            let needs = [at(Before), at(After)].concat();
            rules.push(rule(Law::Deflection, CROSS, &needs, &[cross], 1));
            rules.push(rule(Law::Deflection, DOT, &needs, &[dot], 1));
        }
        let tangents = [Quantity::TOverN(sphere, Before), Quantity::TOverN(sphere, After)];
        let tangent = Quantity::TanDeflection(sphere);
        rules.push(rule(Law::Deflection, BY_TANGENTS, &tangents, &[tangent], 1));
        rules.push(rule(Law::Deflection, BY_PRODUCTS, &[cross, dot], &[tangent], 5));
        rules.push(rule(Law::Deflection, ANGLE, &[cross, dot], &[Quantity::Deflection(sphere)], 1));
        rules.push(rule(Law::Deflection, SIGNED, &[cross, dot], &[Quantity::SignedDeflection(sphere)], 1));
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let n = &rule.needs;
    match rule.form {
        CROSS => {
            let [a, b, c, d] = known.numbers([n[0], n[1], n[2], n[3]])?;
            number(a * d - b * c)
        }
        DOT => {
            let [a, b, c, d] = known.numbers([n[0], n[1], n[2], n[3]])?;
            number(a * c + b * d)
        }
        BY_TANGENTS => {
            let [alpha, beta] = known.numbers([n[0], n[1]])?;
            // x/x is one; a path along the line of centres has no tangent to divide by.
            if alpha.is_nought() {
                return number(beta);
            }
            let one = alpha.over(&alpha)?;
            number((beta.clone() - alpha.clone()).over(&(one + alpha * beta))?)
        }
        BY_PRODUCTS => {
            let [cross, dot] = known.numbers([n[0], n[1]])?;
            number(cross.over(&dot)?)
        }
        form => {
            let [cross, dot] = known.numbers([n[0], n[1]])?;
            if cross.is_nought() && dot.is_nought() {
                return None;
            }
            let y = if form == ANGLE { cross.size() } else { cross };
            Some(vec![Datum::Direction { y, x: dot }])
        }
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Known<N>) -> Outcome<N> {
    if rule.form != BY_TANGENTS {
        return None;
    }
    let [alpha, beta] = known.numbers([rule.needs[0], rule.needs[1]])?;
    match slip {
        "deflection-added" => {
            let one = alpha.over(&alpha)?;
            number((beta.clone() + alpha.clone()).over(&(one - alpha * beta))?)
        }
        "tangents-subtracted" => number(beta - alpha),
        _ => None,
    }
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match (rule.form, rule.gives[0]) {
        (BY_TANGENTS, Quantity::TanDeflection(sphere)) => show.tangent_of_deflection(sphere),
        (DOT, Quantity::DeflectionDot(sphere)) => show.product_before_and_after(sphere),
        (ANGLE, Quantity::Deflection(sphere)) => show.deflection(sphere),
        (BY_PRODUCTS, Quantity::TanDeflection(sphere)) => show.tangent_by_products(sphere),
        _ => silent(),
    }
}
