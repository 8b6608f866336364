//! Newton's law of restitution along the line of centres: separation = e × approach.
//!
//! `y - x = e (a - b)` for the components a, b before and x, y after, all positive from A to B.

use super::{ALONG, Datum, Known, Law, Line, Outcome, Rule, Show, Slip, number, rule, first_equation};
use crate::expr::Expr;
use crate::mechanics::Quantity;
use crate::mechanics::formula::difference;
use crate::number::Number;

pub const NAME: &str = "restitution";

pub const ACCURACY: &str = "correct equation, unsimplified";

pub const METHOD: (&str, &str) =
    ("Newton's law of restitution along the line of centres", "*e* on the correct side; condone sign errors");

pub const SLIPS: &[Slip] = &[
    Slip {
        tag: "e-wrong-side",
        sentence: "e multiplies the approach speed: separation = e x approach, so the spheres separate more slowly than they met.",
    },
    Slip {
        tag: "approach-subtracted",
        sentence: "They move towards each other, so the approach speed is the sum of the two components.",
    },
    Slip {
        tag: "separation-added",
        sentence: "Your two equations use different positive directions after the impact. Draw the arrows once and use them in both.",
    },
    Slip {
        tag: "restitution-reversed",
        sentence: "Check which sphere is in front: after the impact B must leave A, so w - v, not v - w.",
    },
    Slip {
        tag: "restitution-ignores-b",
        sentence: "B is moving too: include its component in both equations.",
    },
    Slip { tag: "e-taken-as-1", sentence: "'Elastic' in the chapter title does not mean e = 1: use the given coefficient." },
    Slip { tag: "coalesce", sentence: "They separate after the impact; use the impact law as well as momentum." },
];

/// The forms: an equation for two unknowns, or the one unknown, in the order a, b, x, y, e.
const EQUATION: u8 = 0;

pub fn rules() -> Vec<Rule> {
    let [a, b, x, y] = ALONG;
    let e = Quantity::Restitution;
    let all = [a, b, x, y, e];
    let mut rules = vec![rule(Law::Restitution, EQUATION, &[e, a, b], &[Quantity::RestitutionEquation], 1)];
    for (index, unknown) in all.into_iter().enumerate() {
        let needs: Vec<Quantity> = all.into_iter().filter(|quantity| *quantity != unknown).collect();
        rules.push(rule(Law::Restitution, index as u8 + 1, &needs, &[unknown], 2));
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Known<N>) -> Outcome<N> {
    let at = |quantity| known.number(quantity);
    let [a, b, x, y] = ALONG;
    let e = Quantity::Restitution;
    match rule.form {
        EQUATION => equation(known, |a, b, e| e * (a - b), true),
        1 => number(at(b)? + (at(y)? - at(x)?).over(&at(e)?)?),
        2 => number(at(a)? - (at(y)? - at(x)?).over(&at(e)?)?),
        3 => number(at(y)? - at(e)? * (at(a)? - at(b)?)),
        4 => number(at(x)? + at(e)? * (at(a)? - at(b)?)),
        _ => number((at(y)? - at(x)?).over(&(at(a)? - at(b)?))?),
    }
}

/// `y - x = r` (or `x - y = r`), with `r` made from a, b and e.
fn equation<N: Number>(known: &Known<N>, right: impl Fn(N, N, N) -> N, b_leads: bool) -> Outcome<N> {
    let [a, b, e] = known.numbers([ALONG[0], ALONG[1], Quantity::Restitution])?;
    let approach = a.clone() - b.clone();
    let one = approach.one();
    let (p, q) = if b_leads { (-one.clone(), one) } else { (one.clone(), -one) };
    Some(vec![Datum::Equation([p, q, right(a, b, e)])])
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Known<N>) -> Outcome<N> {
    if rule.form != EQUATION {
        return None;
    }
    match slip {
        "e-wrong-side" => {
            let e = known.number(Quantity::Restitution)?;
            if e.is_nought() {
                return None;
            }
            equation(known, |a, b, e| (a.clone() - b.clone()).over(&e).unwrap_or(a - b), true)
        }
        "approach-subtracted" => equation(known, |a, b, e| e * (a + b), true),
        "restitution-reversed" => equation(known, |a, b, e| e * (a - b), false),
        "restitution-ignores-b" => equation(known, |a, _, e| e * a, true),
        "e-taken-as-1" => equation(known, |a, b, _| a - b, true),
        "coalesce" => equation(known, |a, _, _| a.nought(), true),
        "separation-added" => {
            let outcome = equation(known, |a, b, e| e * (a - b), true)?;
            let Datum::Equation([p, q, r]) = outcome.into_iter().next()? else { return None };
            Some(vec![Datum::Equation([-p, q, r])])
        }
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    if rule.form == EQUATION {
        let equation = Expr::equation(show.separation(), show.e_times_approach());
        let words = "By Newton's law of restitution:";
        return vec![Line::numbered(words, show.with_simplified(equation, Quantity::RestitutionEquation))];
    }
    let unknown = rule.gives[0];
    if unknown == Quantity::Restitution {
        let [a, b, x, y] = ALONG.map(|quantity| show.shown_value(quantity));
        let quotient = Expr::Quotient(Box::new(difference(y, x)), Box::new(difference(a, b)));
        let chain = Show::chain(Expr::name("e"), [quotient, show.shown_value(unknown)]);
        return vec![Line::plain("By Newton's law of restitution, separation over approach along the line of centres:", chain)];
    }
    let equation = Expr::equation(show.separation(), show.e_times_approach());
    vec![Line::plain("By Newton's law of restitution:", vec![equation, Expr::equation(show.symbol(unknown), show.shown_value(unknown))])]
}
