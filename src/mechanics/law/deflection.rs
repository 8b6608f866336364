//! The angle through which the path of a sphere turns.
//!
//! `cross = u × v` and `dot = u · v` of the velocities before and after; the tangent of the deflection is
//! their quotient, and also `(tan β - tan α)/(1 + tan α tan β)` by the angles to the line of centres.

use super::{Datum, Known, Law, Line, Outcome, Rule, Show, Slip, number, rule, silent, velocity, first_equation};
use crate::expr::{Expr, Function, ratio, written};
use crate::mechanics::Velocity;
use crate::mechanics::formula::{difference, times};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "deflection";

pub const ACCURACY: &str = "correct expression, unsimplified";

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
            let one = alpha.one();
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
            let one = alpha.one();
            number((beta.clone() + alpha.clone()).over(&(one - alpha * beta))?)
        }
        "tangents-subtracted" => number(beta - alpha),
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match (rule.form, rule.gives[0]) {
        (BY_TANGENTS, Quantity::TanDeflection(sphere)) => by_tangents(show, sphere),
        (DOT, Quantity::DeflectionDot(sphere)) => scalar_product(show, sphere),
        (ANGLE, Quantity::Deflection(sphere)) => turned(show, sphere),
        (BY_PRODUCTS, Quantity::TanDeflection(sphere)) => by_products(show, sphere),
        _ => silent(),
    }
}

/// `tan(β - α) = (tan β - tan α)/(1 + tan α tan β)`.
fn by_tangents(show: &Show, sphere: Sphere) -> Vec<Line> {
    let value = |moment| show.value(Quantity::TOverN(sphere, moment));
    let (alpha, beta) = (value(Before), value(After));
    let left = Expr::call(Function::Tan, Expr::name("delta"));
    let product = times(beta.clone(), alpha.clone());
    let quotient = Expr::Quotient(Box::new(difference(beta, alpha)), Box::new(Expr::sum([Expr::integer(1), product])));
    let found = show.value(Quantity::TanDeflection(sphere));
    let words = "The deflection {d} of {A} is the difference of the angles that its path makes with the line of centres before and after, so";
    let formulas = [("d", Expr::name("delta")), ("A", Expr::name(sphere.name()))];
    vec![Line::with(words, &formulas, Show::chain(left, [quotient, found]))]
}

/// The scalar product of the velocities before and after, in numbers.
fn scalar_product(show: &Show, sphere: Sphere) -> Vec<Line> {
    let axes = if show.along_an_axis() || !show.scene().before.iter().flatten().any(is_components) { [N, T] } else { [X, Y] };
    let at = |moment, axis| written(&show.worked(velocity(sphere, moment, axis)));
    let terms = axes.map(|axis| match (at(Before, axis), at(After, axis)) {
        (before, after) if before == after => written(&show.exact(velocity(sphere, Before, axis)).squared()),
        (before, after) => times(before, after),
    });
    let left = Expr::name("s");
    let found = show.value(Quantity::DeflectionDot(sphere));
    let words = "The scalar product of the velocities of {A} before and after is";
    vec![Line::with(words, &[("A", Expr::name(sphere.name()))], Show::chain(left, [Expr::sum(terms), found]))]
}

fn is_components(velocity: &Velocity) -> bool {
    matches!(velocity, Velocity::Components(..))
}

/// The angle between the velocities before and after.
fn turned(show: &Show, sphere: Sphere) -> Vec<Line> {
    let Some(angle) = show.angle(Quantity::Deflection(sphere)) else { return silent() };
    let left = Expr::name("delta");
    let mut equations = Vec::new();
    let dot = show.exact(Quantity::DeflectionDot(sphere));
    let size = &show.exact(Quantity::DeflectionCross(sphere)).absolute();
    if !dot.is_zero() {
        equations.push(Expr::equation(Expr::call(Function::Tan, left.clone()), ratio(size, &dot)));
    }
    equations.push(Expr::equation(left.clone(), Show::angle_expr(&angle)));
    equations.extend(Show::approximate_angle(&left, &angle));
    let words = "The path of {A} turns through the angle {d} between its velocities before and after:";
    vec![Line::with(words, &[("A", Expr::name(sphere.name())), ("d", left)], equations)]
}

fn by_products(show: &Show, sphere: Sphere) -> Vec<Line> {
    let left = Expr::call(Function::Tan, Expr::name("delta"));
    let words = "The tangent of the deflection {d} of {A} is the cross product of the two velocities over their scalar product:";
    let formulas = [("d", Expr::name("delta")), ("A", Expr::name(sphere.name()))];
    vec![Line::with(words, &formulas, vec![Expr::equation(left, show.value(Quantity::TanDeflection(sphere)))])]
}
