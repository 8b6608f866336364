//! Kinetic energy `½ m v²`, before, after and lost.
//!
//! The components across the line of centres do not change, so what a sphere loses is
//! `½ m (u_n² - v_n²)`.

use super::{Known, Law, Line, Outcome, Rule, Show, Slip, number, rule, silent, velocity, first_equation};
use crate::expr::{Expr, written};
use crate::mechanics::Moment;
use crate::mechanics::formula::times;
use crate::number::{Fraction, Value};
use crate::mechanics::Axis::{N, X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::Sphere::{A, B};
use crate::mechanics::{Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "energy";

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) =
    ("difference of kinetic energies, both spheres", "squares of components may leave out the unchanged ones on both sides");

pub const SLIPS: &[Slip] = &[
    Slip {
        tag: "energy-square-of-difference",
        sentence: "Find the KE before and after and subtract; do not square the change in velocity.",
    },
    Slip {
        tag: "energy-no-half",
        sentence: "Kinetic energy is half of mass times speed squared.",
    },
    Slip {
        tag: "fraction-remaining",
        sentence: "The question asks for the part lost out of all the KE before.",
    },
];

const OF_SPHERE: u8 = 0;
const LOST_ALONG: u8 = 1;
const LOST_IN_I_J: u8 = 2;
const LOST_BY_TOTALS: u8 = 3;
const LOST_BY_SPHERES: u8 = 4;
const TOTAL: u8 = 5;
const FRACTION: u8 = 6;
const FRACTION_BY_TOTALS: u8 = 7;
const OF_SPHERE_IN_I_J: u8 = 8;

pub fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    let totals = [Quantity::TotalEnergy(Before), Quantity::TotalEnergy(After)];
    for sphere in Sphere::BOTH {
        let mass = Quantity::Mass(sphere);
        let at = |moment, axis| velocity(sphere, moment, axis);
        for moment in [Before, After] {
            let energy = Quantity::KineticEnergy(sphere, moment);
            rules.push(rule(Law::Energy, OF_SPHERE, &[mass, Quantity::Speed(sphere, moment)], &[energy], 1));
            rules.push(rule(Law::Energy, OF_SPHERE_IN_I_J, &[mass, at(moment, X), at(moment, Y)], &[energy], 2));
        }
        let lost = Quantity::SphereEnergyLost(sphere);
        rules.push(rule(Law::Energy, LOST_ALONG, &[mass, at(Before, N), at(After, N)], &[lost], 1));
        let x_y = [mass, at(Before, X), at(Before, Y), at(After, X), at(After, Y)];
        rules.push(rule(Law::Energy, LOST_IN_I_J, &x_y, &[lost], 1));
    }
    for moment in [Before, After] {
        let both = [Quantity::KineticEnergy(A, moment), Quantity::KineticEnergy(B, moment)];
        rules.push(rule(Law::Energy, TOTAL, &both, &[Quantity::TotalEnergy(moment)], 1));
    }
    let spheres = [Quantity::SphereEnergyLost(A), Quantity::SphereEnergyLost(B)];
    rules.push(rule(Law::Energy, LOST_BY_SPHERES, &spheres, &[Quantity::EnergyLost], 1));
    rules.push(rule(Law::Energy, LOST_BY_TOTALS, &totals, &[Quantity::EnergyLost], 3));
    rules.push(rule(Law::Energy, FRACTION_BY_TOTALS, &totals, &[Quantity::FractionLost], 1));
    let lost = [Quantity::EnergyLost, Quantity::TotalEnergy(Before)];
    rules.push(rule(Law::Energy, FRACTION, &lost, &[Quantity::FractionLost], 4));
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let n = &rule.needs;
    match rule.form {
        OF_SPHERE => {
            let [mass, speed] = known.numbers([n[0], n[1]])?;
            number((mass * speed.squared()).half())
        }
        OF_SPHERE_IN_I_J => {
            let [mass, x, y] = known.numbers([n[0], n[1], n[2]])?;
            number((mass * (x.squared() + y.squared())).half())
        }
        LOST_ALONG => {
            let [mass, before, after] = known.numbers([n[0], n[1], n[2]])?;
            // As a product, which loses no figures where the two are nearly equal.
            number((mass * (before.clone() - after.clone()) * (before + after)).half())
        }
        LOST_IN_I_J => {
            let [mass, u_x, u_y, v_x, v_y] = known.numbers([n[0], n[1], n[2], n[3], n[4]])?;
            number((mass * (u_x.squared() + u_y.squared() - v_x.squared() - v_y.squared())).half())
        }
        LOST_BY_SPHERES | TOTAL => number(known.number(n[0])? + known.number(n[1])?),
        LOST_BY_TOTALS => number(known.number(n[0])? - known.number(n[1])?),
        FRACTION => number(known.number(n[0])?.over(&known.number(n[1])?)?),
        _ => {
            let [before, after] = known.numbers([n[0], n[1]])?;
            number((before.clone() - after).over(&before)?)
        }
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let n = &rule.needs;
    match (slip, rule.form) {
        ("energy-square-of-difference", LOST_ALONG) => {
            let [mass, before, after] = known.numbers([n[0], n[1], n[2]])?;
            number((mass * (before - after).squared()).half())
        }
        ("energy-no-half", OF_SPHERE | OF_SPHERE_IN_I_J | LOST_ALONG | LOST_IN_I_J) => {
            let whole = evaluate(rule, known)?.pop()?;
            let super::Datum::Number(half) = whole else { return None };
            number(half.clone() + half)
        }
        ("fraction-remaining", FRACTION_BY_TOTALS) => number(known.number(n[1])?.over(&known.number(n[0])?)?),
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match (rule.form, rule.gives[0]) {
        (TOTAL, Quantity::TotalEnergy(moment)) => total(show, moment),
        (LOST_BY_SPHERES | LOST_BY_TOTALS, _) => lost(show),
        (FRACTION | FRACTION_BY_TOTALS, _) => fraction(show),
        _ => silent(),
    }
}

/// `½ m`, the half written first.
fn half(show: &Show, sphere: Sphere) -> Expr {
    times(Expr::Number(Fraction::new(1, 2)), show.mass(sphere))
}

/// The energy of both spheres at a moment, by their speeds.
fn total(show: &Show, moment: Moment) -> Vec<Line> {
    let terms = Sphere::BOTH.map(|sphere| times(half(show, sphere), square(show, sphere, moment)));
    let (words, left) = match moment {
        Before => ("The kinetic energy before the impact, in joules, is", "E_1"),
        After => ("The kinetic energy after the impact, in joules, is", "E_2"),
    };
    vec![Line::plain(words, Show::chain(Expr::name(left), [Expr::sum(terms), show.value(Quantity::TotalEnergy(moment))]))]
}

/// The square of a speed: a speed that is a root gives its radicand.
fn square(show: &Show, sphere: Sphere, moment: Moment) -> Expr {
    let speed = show.exact(Quantity::Speed(sphere, moment));
    if speed.is_zero() { Expr::integer(0) } else { written(&speed).to_the(2) }
}

/// What both spheres lose, by the components that change.
fn lost(show: &Show) -> Vec<Line> {
    let along = show.given_along();
    let terms = Sphere::BOTH.map(|sphere| {
        let part = |moment| {
            if along {
                squared(&show.worked(velocity(sphere, moment, N)))
            } else {
                let at = |axis| size_of(&show.exact(velocity(sphere, moment, axis))).to_the(2);
                Expr::Sum(vec![at(X), at(Y)])
            }
        };
        times(half(show, sphere), difference_of(part(Before), part(After)))
    });
    let value = show.exact(Quantity::EnergyLost);
    let left = Expr::name("L");
    let mut equations = Show::chain(left.clone(), [Expr::sum(terms), written(&value)]);
    equations.extend(Show::approximately(&left, &value));
    let words = if along {
        "The components perpendicular to the line of centres do not change, so the kinetic energy lost, in joules, is"
    } else {
        "The kinetic energy lost, in joules, is"
    };
    vec![Line::plain(words, equations)]
}

fn size_of(value: &Value) -> Expr {
    written(&if value.sign() == Some(std::cmp::Ordering::Less) { -value } else { value.clone() })
}

/// The square of a component; nought is its own.
fn squared(value: &Value) -> Expr {
    if value.is_zero() { Expr::integer(0) } else { size_of(value).to_the(2) }
}

fn difference_of(before: Expr, after: Expr) -> Expr {
    if after.is_zero() {
        return before;
    }
    // A sum of two squares stays together in its bracket.
    Expr::Sum(vec![before, after.negated()])
}

fn fraction(show: &Show) -> Vec<Line> {
    let at = |moment| show.value(Quantity::TotalEnergy(moment));
    let lost = Expr::Sum(vec![at(Before), at(After).negated()]);
    let quotient = Expr::Quotient(Box::new(lost), Box::new(at(Before)));
    let rights = [quotient, show.value(Quantity::FractionLost)];
    vec![Line::plain("The fraction of the kinetic energy that is lost is", Show::chain(Expr::name("f"), rights))]
}
