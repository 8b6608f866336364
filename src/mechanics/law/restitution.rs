//! Newton's law of restitution along the line of centres: separation = e × approach.
//!
//! `y - x = e (a - b)` for the components a, b before and x, y after, all positive from A to B.

use smallvec::smallvec;

use super::{Seen, ALONG, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, components, first_equation, is_at_rest_before, is_at_wall, number, rule, unresolved, velocity, with_inputs};
use crate::expr::{Expr, written};
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};
use crate::mechanics::formula::{difference, times};
use crate::number::Number;

pub const NAME: &str = "restitution";

pub const SEEN: Seen = Seen::Equation;

pub const ACCURACY: &str = "correct equation, unsimplified";

pub const METHOD: (&str, &str) =
    ("Newton's law of restitution along the line of centres", "*e* on the correct side; condone sign errors");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 3,
        tag: "restitution-not-resolved",
        did: "put the full speeds into the law of restitution, though momentum was resolved",
        sentence: "Your momentum is along the line of centres but your law of restitution is not: use the same components in both.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 4,
        tag: "e-wrong-side",
        did: "put e with the speed of separation",
        sentence: "e multiplies the speed of approach: the spheres part more slowly than they met.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 5,
        tag: "approach-subtracted",
        did: "took the component of B before the impact with the other sign in the speed of approach",
        sentence: "Spheres that move towards each other close at the sum of the two components, and those that move the same way at the difference.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 6,
        tag: "separation-added",
        did: "added the components after the impact in the law of restitution",
        sentence: "Your two equations do not agree on which way is positive after the impact: draw one arrow for each unknown and keep to it.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 7,
        tag: "restitution-reversed",
        did: "took the velocities after the impact in the wrong order",
        sentence: "B is in front: it must move away from A, so the separation is the velocity of B less that of A.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 9,
        tag: "restitution-ignores-b",
        did: "left the velocity of B before the impact out of the law of restitution",
        sentence: "B was moving before the impact too, so it has a part in the speed of approach.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 15,
        tag: "right-angle-assumed",
        did: "assumed that the paths after the impact are at right angles",
        sentence: "That the paths part at right angles is no law: it needs a special value of e. Use the law of restitution.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 18,
        tag: "e-taken-as-1",
        did: "took e as 1",
        sentence: "The impact is not perfectly elastic: use the coefficient that is given.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 19,
        tag: "coalesce",
        did: "let the spheres move on together along the line of centres",
        sentence: "The spheres do not stick together: the law of restitution says how fast they part.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 48,
        tag: "e-full-speeds",
        did: "divided the full relative speeds",
        sentence: "e compares velocities along the line of centres alone: resolve all four along it first.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 49,
        tag: "e-reciprocal",
        did: "divided the speed of approach by that of separation",
        sentence: "e is separation over approach: it lies between 0 and 1.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 50,
        tag: "e-unsigned",
        did: "took the components along the line of centres without their signs",
        sentence: "Keep the signs of all four components: one that points the other way is negative.",
        also: &[],
        condoned: true,
    },
];

/// The forms: an equation for two unknowns, or the one unknown, in the order a, b, x, y, e.
const EQUATION: u8 = 0;
const OF_E: u8 = 5;

/// Where the line of centres is known from the velocities alone: e from components along the change of A's velocity,
/// each times the length of that change, which cancels. Its numbers stay short where a unit vector's do not.
const OF_E_ALONG_CHANGE: u8 = 6;

/// More than any other way to e costs, so that this is the last.
const LAST: u32 = 1000;

pub fn rules() -> Vec<Rule> {
    let [a, b, x, y] = ALONG;
    let e = Quantity::Restitution;
    let all = [a, b, x, y, e];
    let mut rules = vec![rule(Law::Restitution, EQUATION, &[e, a, b], &[Quantity::RestitutionEquation], 1)];
    for (index, unknown) in all.into_iter().enumerate() {
        let needs: Vec<Quantity> = all.into_iter().filter(|quantity| *quantity != unknown).collect();
        rules.push(rule(Law::Restitution, index as u8 + 1, &needs, &[unknown], 2));
    }
    let full: Vec<Quantity> = Sphere::BOTH.into_iter().flat_map(both_moments).flatten().collect();
    rules.push(rule(Law::Restitution, OF_E_ALONG_CHANGE, &full, &[e], LAST));
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let at = |quantity| known.number(quantity);
    let [a, b, x, y] = ALONG;
    let e = Quantity::Restitution;
    match rule.form {
        EQUATION => {
            let [a, b, e] = known.numbers([a, b, e])?;
            let one = e.one();
            Some(smallvec![Datum::Equation([-one.clone(), one, e * (a - b)])])
        }
        1 => number(at(b)? + (at(y)? - at(x)?).over(&at(e)?)?),
        2 => number(at(a)? - (at(y)? - at(x)?).over(&at(e)?)?),
        3 => number(at(y)? - at(e)? * (at(a)? - at(b)?)),
        4 => number(at(x)? + at(e)? * (at(a)? - at(b)?)),
        OF_E_ALONG_CHANGE => number(along_change(known)?),
        _ => number(evaluate_e(known)?),
    }
}

/// The components of a sphere's velocity before the impact, and those after it.
fn both_moments(sphere: Sphere) -> [[Quantity; 2]; 2] {
    [Moment::Before, Moment::After].map(|moment| [Axis::X, Axis::Y].map(|axis| velocity(sphere, moment, axis)))
}

fn along_change<N: Number>(known: &Here<N>) -> Option<N> {
    let [[a, x], [b, y]] = Sphere::BOTH.map(both_moments);
    let [a, b, x, y] = [known.numbers(a)?, known.numbers(b)?, known.numbers(x)?, known.numbers(y)?];
    let less = |[p, q]: &[N; 2], [r, s]: &[N; 2]| [p.clone() - r.clone(), q.clone() - s.clone()];
    let change = less(&x, &a);
    let along = |[p, q]: [N; 2]| p * change[0].clone() + q * change[1].clone();
    along(less(&y, &x)).over(&along(less(&a, &b)))
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let [a, b, x, y] = ALONG;
    let e = Quantity::Restitution;
    let at = |quantity| known.number(quantity);
    match slip {
        "not-resolved" | "restitution-not-resolved" if rule.form == EQUATION => {
            with_inputs(rule, known, &unresolved(known)?)
        }
        "e-wrong-side" => with_inputs(rule, known, &[(e, at(e)?.one().over(&at(e)?)?)]),
        "approach-subtracted" => with_inputs(rule, known, &[(b, -at(b)?)]),
        "separation-added" if rule.form == EQUATION => {
            let outcome = evaluate(rule, known)?;
            let [Datum::Equation([p, q, r])] = outcome.as_slice() else { return None };
            Some(smallvec![Datum::Equation([-p.clone(), q.clone(), r.clone()])])
        }
        "separation-added" => with_inputs(rule, known, &[(x, -at(x)?)]),
        "restitution-reversed" if rule.form == OF_E => number(-evaluate_e(known)?),
        "restitution-reversed" => with_inputs(rule, known, &[(e, -at(e)?)]),
        "restitution-ignores-b" => with_inputs(rule, known, &[(b, at(b)?.nought())]),
        "right-angle-assumed"
            if rule.form == EQUATION && is_at_rest_before(known, Sphere::B) && !is_along_line_before(known) =>
        {
            // A has no velocity left along the line of centres, which is the path of B.
            let one = at(a)?.one();
            Some(smallvec![Datum::Equation([one.clone(), one.nought(), one.nought()])])
        }
        // The component that a wall turns back was taken to stay.
        "wrong-axis" if rule.gives[0] == x && is_at_wall(known) => number(at(a)?),
        "e-taken-as-1" => with_inputs(rule, known, &[(e, at(e)?.one())]),
        "coalesce" => with_inputs(rule, known, &[(e, at(e)?.nought())]),
        "e-full-speeds" if rule.form == OF_E => {
            let between = |moment| {
                let [a, b] = [components(known, Sphere::A, moment)?, components(known, Sphere::B, moment)?];
                let [[a_1, a_2], [b_1, b_2]] = [a, b];
                ((a_1 - b_1).squared() + (a_2 - b_2).squared()).root()
            };
            number(between(Moment::After)?.over(&between(Moment::Before)?)?)
        }
        "e-reciprocal" if rule.form == OF_E => number(at(a)?.one().over(&evaluate_e(known)?)?),
        "e-unsigned" if rule.form == OF_E => {
            let [a, b, x, y] = known.numbers([a, b, x, y])?.map(|component| component.size());
            number((y - x).over(&(a - b))?.size())
        }
        _ => None,
    }
}

/// Is A known to move along the line of centres? Then there are no paths at an angle.
fn is_along_line_before<N: Number>(known: &Here<N>) -> bool {
    known.number(Quantity::Velocity(Sphere::A, Moment::Before, Axis::T)).is_some_and(|across| across.is_nought())
}

fn evaluate_e<N: Number>(known: &Here<N>) -> Option<N> {
    let [a, b, x, y] = known.numbers(ALONG)?;
    (y - x).over(&(a - b))
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    if show.setting() == Setting::Wall {
        return at_wall(rule, show);
    }
    if rule.form == EQUATION {
        let equation = Expr::equation(show.separation(), show.e_times_approach());
        let words = "By Newton's law of restitution:";
        return vec![Line::numbered(words, show.with_simplified(equation, Quantity::RestitutionEquation))];
    }
    let unknown = rule.gives[0];
    if rule.form == OF_E_ALONG_CHANGE {
        let [[a, x], [b, y]] = Sphere::BOTH.map(both_moments).map(|moments| moments.map(|both| both.map(|one| show.shown_value(one))));
        let less = |[p, q]: &[Expr; 2], [r, s]: &[Expr; 2]| [difference(p.clone(), r.clone()), difference(q.clone(), s.clone())];
        let change = less(&x, &a);
        let along = |[p, q]: [Expr; 2]| Expr::sum([times(p, change[0].clone()), times(q, change[1].clone())]);
        let quotient = Expr::Quotient(Box::new(along(less(&y, &x))), Box::new(along(less(&a, &b))));
        let chain = Show::chain(Expr::name("e"), [quotient, show.shown_value(unknown)]);
        let words = "By Newton's law of restitution, separation over approach along the line of centres, to which the change of the velocity of A is parallel:";
        return vec![Line::plain(words, chain)];
    }
    if unknown == Quantity::Restitution {
        let [a, b, x, y] = ALONG.map(|quantity| show.shown_value(quantity));
        let quotient = Expr::Quotient(Box::new(difference(y, x)), Box::new(difference(a, b)));
        let mut chain = Show::chain(Expr::name("e"), [quotient, show.shown_value(unknown)]);
        chain.extend(Show::approximately(&Expr::name("e"), &show.exact(unknown)));
        return vec![Line::plain("By Newton's law of restitution, separation over approach along the line of centres:", chain)];
    }
    let equation = Expr::equation(show.separation(), show.e_times_approach());
    vec![Line::plain("By Newton's law of restitution:", vec![equation, Expr::equation(show.symbol(unknown), show.shown_value(unknown))])]
}

/// `v = e u` in sizes: towards the wall before, away from it after.
fn at_wall(rule: &Rule, show: &Show) -> Vec<Line> {
    let [a, _, x, _] = ALONG;
    let size = |quantity| show.worked(quantity).absolute();
    let unsigned = |expr: Expr| match expr {
        Expr::Negative(inner) => *inner,
        Expr::Number(number) if number.sign().is_lt() => Expr::Number(-number),
        other => other,
    };
    let before = match rule.gives[0] == a {
        true => show.symbol(a),
        false => unsigned(show.along(Sphere::A, Moment::Before)),
    };
    let after = match show.scene().velocity(Sphere::A, Moment::After) {
        Some(_) => unsigned(show.along(Sphere::A, Moment::After)),
        None => show.symbol(x),
    };
    let unknown = rule.gives[0];
    if unknown == Quantity::Restitution {
        let quotient = Expr::Quotient(Box::new(after), Box::new(before));
        let chain = Show::chain(Expr::name("e"), [quotient, show.shown_value(unknown)]);
        return vec![Line::plain("By Newton's law of restitution, perpendicular to the wall:", chain)];
    }
    let equation = Expr::equation(after, times(show.restitution(), before));
    let found = Expr::equation(show.symbol(unknown), written(&size(unknown)));
    let words = if unknown == x {
        "By Newton's law of restitution, with {v} the component perpendicular to the wall after the impact, away from it:"
    } else {
        "By Newton's law of restitution, perpendicular to the wall:"
    };
    let mut equations = vec![equation];
    equations.extend(Some(found).filter(|found| found != &equations[0]));
    vec![Line::with(words, &[("v", show.symbol(x))], equations)]
}
