//! The angle through which the path of a sphere turns.
//!
//! `cross = u × v` and `dot = u · v` of the velocities before and after; the tangent of the deflection is
//! their quotient, and also `(tan β - tan α)/(1 + tan α tan β)` by the angles to the line of centres.

use smallvec::smallvec;

use super::{Shape, Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, components, first_equation, number, rule, silent, velocity, with_sign_of};
use crate::expr::{Expr, Function, ratio, written};
use crate::mechanics::Velocity;
use crate::mechanics::formula::{difference, times};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Axis, Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "deflection";

pub const SEEN: Seen = Seen::Value(
    &[
        Quantity::Deflection(Sphere::A),
        Quantity::Deflection(Sphere::B),
        Quantity::TanDeflection(Sphere::A),
        Quantity::TanDeflection(Sphere::B),
        Quantity::DeflectionDot(Sphere::A),
        Quantity::DeflectionDot(Sphere::B),
    ],
    Shape::Any,
);

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) =
    ("deflection as a difference of directions, expanded or by scalar product", "either order of the difference");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 24,
        tag: "direction-for-deflection",
        did: "gave the direction after the impact",
        sentence: "That is the direction after the impact; the deflection is how far the path turned from the old direction.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 26,
        tag: "deflection-added",
        did: "added the angles before and after the impact",
        sentence: "Draw both velocities from one point: the angle between them is not the sum of their angles with the line of centres.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 27,
        tag: "rebound-missed",
        did: "subtracted the angles although the sphere turns back along the line of centres",
        sentence: "The sphere turns back along the line of centres: draw both velocities from one point before you take the angle between them.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 28,
        tag: "tangents-subtracted",
        did: "subtracted the tangents of the angles",
        sentence: "The tangent of a difference is not the difference of the tangents: use the compound-angle formula.",
        also: &[],
        condoned: false,
    },
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

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
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
            Some(smallvec![Datum::Direction { y, x: dot }])
        }
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let (Quantity::Deflection(sphere) | Quantity::SignedDeflection(sphere) | Quantity::TanDeflection(sphere)) =
        rule.gives[0]
    else {
        return None;
    };
    let [before, after] = [components(known, sphere, Before)?, components(known, sphere, After)?];
    let ([a, p], [x, y]) = (before.clone().map(|part| part.size()), after.clone().map(|part| part.size()));
    let (turned_y, turned_x) = match slip {
        // The old direction is given, and is not worked out from the components.
        "sincos-swap" => {
            let [across, along] = before;
            let one = across.one();
            let a = with_sign_of(&along, &across, &one);
            let p = with_sign_of(&across, &along, &one);
            let [x, y] = after;
            let cross = a.clone() * y.clone() - p.clone() * x.clone();
            (if rule.gives[0] == Quantity::Deflection(sphere) { cross.size() } else { cross }, a * x + p * y)
        }
        "direction-for-deflection" => (y, x),
        "deflection-added" => (p.clone() * x.clone() + a.clone() * y.clone(), a * x - p * y),
        "rebound-missed" => ((a.clone() * y.clone() - p.clone() * x.clone()).size(), a * x + p * y),
        "tangents-subtracted" => {
            let [[a, p], [x, y]] = [before, after];
            let difference = y.over(&x)? - p.over(&a)?;
            let one = difference.one();
            (if rule.gives[0] == Quantity::Deflection(sphere) { difference.size() } else { difference }, one)
        }
        _ => return None,
    };
    if turned_y.is_nought() && turned_x.is_nought() {
        return None;
    }
    match rule.gives[0] {
        Quantity::TanDeflection(_) => number(turned_y.over(&turned_x)?),
        _ => Some(smallvec![Datum::Direction { y: turned_y, x: turned_x }]),
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    match rule.gives[0] {
        // The cosine of the angle has it.
        Quantity::DeflectionDot(sphere) if show.is_asked(Quantity::Deflection(sphere)) => None,
        _ => first_equation(&lines(rule, show)),
    }
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match (rule.form, rule.gives[0]) {
        (BY_TANGENTS, Quantity::TanDeflection(sphere)) => by_tangents(show, sphere),
        (DOT, Quantity::DeflectionDot(sphere)) => scalar_product(show, sphere),
        (ANGLE, Quantity::Deflection(sphere)) => turned(show, sphere),
        (BY_PRODUCTS, Quantity::TanDeflection(sphere)) => by_products(show, sphere),
        (_, quantity) => show.statement(quantity),
    }
}

/// `tan(β - α) = (tan β - tan α)/(1 + tan α tan β)`.
fn by_tangents(show: &Show, sphere: Sphere) -> Vec<Line> {
    let value = |moment| show.value(Quantity::TOverN(sphere, moment));
    let (alpha, beta) = (value(Before), value(After));
    let left = Expr::call(Function::Tan, show.name("delta"));
    let product = times(beta.clone(), alpha.clone());
    let quotient = Expr::Quotient(Box::new(difference(beta, alpha)), Box::new(Expr::sum([Expr::integer(1), product])));
    let found = show.value(Quantity::TanDeflection(sphere));
    let words = "The deflection {d} of {A} is the difference of the angles that its path makes with the line of centres before and after, so";
    let formulas = [("d", show.name("delta")), ("A", Expr::name(sphere.name()))];
    vec![Line::with(words, &formulas, Show::chain(left, [quotient, found]))]
}

/// The axes in which the velocities are multiplied: those of the components that are given, if the velocity afterwards has been
/// found in them.
fn axes(show: &Show, sphere: Sphere) -> [Axis; 2] {
    let is_by_line = show.along_an_axis() || !show.scene().before.iter().flatten().any(is_components);
    let is_found = |axis| show.has(velocity(sphere, Before, axis)) && show.has(velocity(sphere, After, axis));
    if is_by_line || ![X, Y].into_iter().all(is_found) { [N, T] } else { [X, Y] }
}

/// The scalar product of the velocities before and after, in numbers.
fn scalar_product(show: &Show, sphere: Sphere) -> Vec<Line> {
    let at = |moment, axis| written(&show.worked(velocity(sphere, moment, axis)));
    let terms = axes(show, sphere).map(|axis| match (at(Before, axis), at(After, axis)) {
        (before, after) if before == after => written(&show.exact(velocity(sphere, Before, axis)).squared()),
        (before, after) => times(before, after),
    });
    let left = show.name("s");
    let found = show.value(Quantity::DeflectionDot(sphere));
    let words = "The scalar product of the velocities of {A} before and after is";
    vec![Line::with(words, &[("A", Expr::name(sphere.name()))], Show::chain(left, [Expr::sum(terms), found]))]
}

fn is_components(velocity: &Velocity) -> bool {
    matches!(velocity, Velocity::Components(..))
}

/// The angle between the velocities before and after, by its cosine.
fn turned(show: &Show, sphere: Sphere) -> Vec<Line> {
    let Some(angle) = show.angle(Quantity::Deflection(sphere)) else { return silent() };
    let left = show.name("delta");
    let dot = show.exact(Quantity::DeflectionDot(sphere));
    let mut found = vec![Expr::equation(left.clone(), Show::angle_expr(&angle))];
    found.extend(Show::approximate_angle(&left, &angle));
    let name = ("A", Expr::name(sphere.name()));
    let is_known = angle.whole_degrees().is_some() || matches!(Show::angle_expr(&angle), Expr::Name(_));
    let sizes = [Before, After].map(|moment| {
        let [first, second] = axes(show, sphere).map(|axis| show.exact(velocity(sphere, moment, axis)));
        (first.squared() + second.squared()).root()
    });
    let [Some(before), Some(after)] = sizes else {
        let words = "The path of {A} turns through the angle {d} between its velocities before and after:";
        return vec![Line::with(words, &[name, ("d", left)], found)];
    };
    let product = &before * &after;
    let quotient = Expr::Quotient(Box::new(written(&dot)), Box::new(times(written(&before), written(&after))));
    let cosine = ratio(&dot, &product);
    if !is_known {
        // Who has found the cosine goes on from it, whatever the answer is written with.
        found[0] = Expr::equation(left.clone(), Expr::call(Function::Acos, cosine.clone()));
    }
    let cosine = Show::chain(Expr::call(Function::Cos, left.clone()), [quotient, cosine]);
    let words = "The path of {A} turns through the angle {d} between these velocities, of magnitudes {p m/s} and {q m/s}:";
    let formulas = [name, ("d", left), ("p", written(&before)), ("q", written(&after))];
    vec![Line::with(words, &formulas, [cosine, found].concat())]
}

fn by_products(show: &Show, sphere: Sphere) -> Vec<Line> {
    let left = Expr::call(Function::Tan, show.name("delta"));
    let words = "The tangent of the deflection {d} of {A} is the cross product of the two velocities over their scalar product:";
    let formulas = [("d", show.name("delta")), ("A", Expr::name(sphere.name()))];
    vec![Line::with(words, &formulas, vec![Expr::equation(left, show.value(Quantity::TanDeflection(sphere)))])]
}
