//! Two equations for the two components along the line of centres.
//!
//! `p x + q y = r` and `p' x + q' y = r'` give `x = (r q' - r' q)/(p q' - p' q)` and y likewise; with the
//! equations of momentum and restitution the determinant is `m_A + m_B`. Backwards, from the
//! components after the impact to those before it, `a - b = (y - x)/e` takes the place of restitution.

use super::{ALONG, Datum, Known, Law, Line, MASSES, Outcome, Rule, Show, Slip, rule};
use crate::mechanics::Quantity;
use crate::number::Number;

pub const NAME: &str = "solve";

pub const METHOD: (&str, &str) = ("solves the two equations for a component", "depends on both method marks before it");

pub const SLIPS: &[Slip] = &[];

const FORWARDS: u8 = 0;
const BACKWARDS: u8 = 1;

pub fn rules() -> Vec<Rule> {
    let [a, b, x, y] = ALONG;
    let [m_a, m_b] = MASSES;
    vec![
        rule(Law::Solve, FORWARDS, &[Quantity::MomentumEquation, Quantity::RestitutionEquation], &[x, y], 1),
        rule(Law::Solve, BACKWARDS, &[m_a, m_b, x, y, Quantity::Restitution], &[a, b], 3),
    ]
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Known<N>) -> Outcome<N> {
    if rule.form == FORWARDS {
        let [p, q, r] = known.equation(Quantity::MomentumEquation)?;
        let [s, t, u] = known.equation(Quantity::RestitutionEquation)?;
        let determinant = p.clone() * t.clone() - q.clone() * s.clone();
        let x = (r.clone() * t - u.clone() * q).over(&determinant)?;
        let y = (p * u - s * r).over(&determinant)?;
        return Some(vec![Datum::Number(x), Datum::Number(y)]);
    }
    let [m_a, m_b, x, y, e] =
        known.numbers([MASSES[0], MASSES[1], ALONG[2], ALONG[3], Quantity::Restitution])?;
    let total = m_a.clone() + m_b.clone();
    let momentum = m_a.clone() * x.clone() + m_b.clone() * y.clone();
    let approach = (y - x).over(&e)?;
    let a = (momentum.clone() + m_b * approach.clone()).over(&total)?;
    let b = (momentum - m_a * approach).over(&total)?;
    Some(vec![Datum::Number(a), Datum::Number(b)])
}

pub fn slipped<N: Number>(_: &str, _: &Rule, _: &Known<N>) -> Outcome<N> {
    None
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    if rule.form == FORWARDS {
        return show.solved_pair();
    }
    vec![Line::plain(
        "Momentum and restitution along the line of centres give the components before the impact:",
        rule.gives.iter().map(|quantity| crate::expr::Expr::equation(show.symbol(*quantity), show.shown_value(*quantity))).collect(),
    )]
}
