//! Two equations for the two components along the line of centres.
//!
//! `p x + q y = r` and `p' x + q' y = r'` give `x = (r q' - r' q)/(p q' - p' q)` and y likewise; with the
//! equations of momentum and restitution the determinant is `m_A + m_B`. Backwards, from the
//! components after the impact to those before it, `a - b = (y - x)/e` takes the place of restitution.

use std::cmp::Ordering::Equal;

use smallvec::smallvec;

use super::{Seen, ALONG, Datum, Here, Law, Line, MASSES, Outcome, Rule, Show, Slip, rule, first_equation};
use crate::expr::{Expr, written};
use crate::mechanics::formula::multiple;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "solve";

pub const SEEN: Seen = Seen::Unknown;

pub const ACCURACY: &str = "a correct component";

pub const METHOD: (&str, &str) = ("solves the two equations for a component", "depends on both method marks before it");

pub const SLIPS: &[Slip] = &[];

const FORWARDS: u8 = 0;
const BACKWARDS: u8 = 1;
/// From here on, one component before and one after, in the order of `MIXED`.
const FIRST_MIXED: u8 = 2;

/// Pairs of unknowns, by their places in `ALONG`: A before and B after, and so on.
const MIXED: [[usize; 2]; 4] = [[0, 3], [1, 2], [0, 2], [1, 3]];

/// The two components along the line of centres that are known where those of `MIXED` are not.
fn others(unknown: [usize; 2]) -> Vec<usize> {
    (0..ALONG.len()).filter(|place| !unknown.contains(place)).collect()
}

pub fn rules() -> Vec<Rule> {
    let [a, b, x, y] = ALONG;
    let [m_a, m_b] = MASSES;
    let mut rules = vec![
        rule(Law::Solve, FORWARDS, &[Quantity::MomentumEquation, Quantity::RestitutionEquation], &[x, y], 1),
        rule(Law::Solve, BACKWARDS, &[m_a, m_b, x, y, Quantity::Restitution], &[a, b], 3),
    ];
    for (form, unknown) in (FIRST_MIXED..).zip(MIXED) {
        let mut needs = vec![m_a, m_b, Quantity::Restitution];
        needs.extend(others(unknown).into_iter().map(|place| ALONG[place]));
        rules.push(rule(Law::Solve, form, &needs, &unknown.map(|place| ALONG[place]), 4));
    }
    rules
}

/// The two unknowns of `MIXED` by Cramer's rule; no solution of that kind where the determinant is nought, as for
/// A before and B after with `m_A = e m_B`.
fn mixed<N: Number>(unknown: [usize; 2], known: &Here<N>) -> Outcome<N> {
    let [m_a, m_b, e] = known.numbers([MASSES[0], MASSES[1], Quantity::Restitution])?;
    let one = m_a.one();
    // m_A a + m_B b - m_A x - m_B y = 0 and e a - e b + x - y = 0.
    let momentum = [m_a.clone(), m_b.clone(), -m_a, -m_b];
    let restitution = [e.clone(), -e, one.clone(), -one];
    let right = |row: &[N; 4]| -> Option<N> {
        let terms: Option<Vec<N>> =
            others(unknown).into_iter().map(|place| Some(row[place].clone() * known.number(ALONG[place])?)).collect();
        terms?.into_iter().reduce(|sum, term| sum + term).map(|sum| -sum)
    };
    let (r, u) = (right(&momentum)?, right(&restitution)?);
    let [[p, q], [s, t]] = [&momentum, &restitution].map(|row| unknown.map(|place| row[place].clone()));
    let determinant = p.clone() * t.clone() - q.clone() * s.clone();
    let first = (r.clone() * t - u.clone() * q).over(&determinant)?;
    let second = (p * u - s * r).over(&determinant)?;
    Some(smallvec![Datum::Number(first), Datum::Number(second)])
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    if rule.form == FORWARDS {
        let [p, q, r] = known.equation(Quantity::MomentumEquation)?;
        let [s, t, u] = known.equation(Quantity::RestitutionEquation)?;
        let determinant = p.clone() * t.clone() - q.clone() * s.clone();
        let x = (r.clone() * t - u.clone() * q).over(&determinant)?;
        let y = (p * u - s * r).over(&determinant)?;
        return Some(smallvec![Datum::Number(x), Datum::Number(y)]);
    }
    if rule.form >= FIRST_MIXED {
        return mixed(MIXED[usize::from(rule.form - FIRST_MIXED)], known);
    }
    let [m_a, m_b, x, y, e] =
        known.numbers([MASSES[0], MASSES[1], ALONG[2], ALONG[3], Quantity::Restitution])?;
    let total = m_a.clone() + m_b.clone();
    let momentum = m_a.clone() * x.clone() + m_b.clone() * y.clone();
    let approach = (y - x).over(&e)?;
    let a = (momentum.clone() + m_b * approach.clone()).over(&total)?;
    let b = (momentum - m_a * approach).over(&total)?;
    Some(smallvec![Datum::Number(a), Datum::Number(b)])
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match slip {
        // What does change was taken not to; on one line there is nothing else.
        "wrong-axis" if rule.form == FORWARDS && !is_on_one_line(known) => {
            Some(known.numbers([ALONG[0], ALONG[1]])?.map(Datum::Number).into())
        }
        _ => None,
    }
}

/// Has neither sphere a component across?
fn is_on_one_line<N: Number>(known: &Here<N>) -> bool {
    let across = |sphere| known.number(Quantity::Velocity(sphere, Moment::Before, Axis::T));
    Sphere::BOTH.into_iter().all(|sphere| across(sphere).is_some_and(|across| across.is_nought()))
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    if rule.form == FORWARDS {
        return solved(show);
    }
    let words = if rule.form == BACKWARDS {
        "Momentum and restitution along the line of centres give the components before the impact:"
    } else {
        "Momentum and restitution along the line of centres are two equations for the two components:"
    };
    vec![Line::plain(
        words,
        rule.gives.iter().map(|quantity| Expr::equation(show.symbol(*quantity), show.shown_value(*quantity))).collect(),
    )]
}

/// Eliminates w, finds v, then w from the second equation.
fn solved(show: &Show) -> Vec<Line> {
    let [x, y] = [ALONG[2], ALONG[3]];
    let (v, w) = (show.symbol(x), show.symbol(y));
    let (Some([p, q, r]), Some([_, _, s])) =
        (show.equation(Quantity::MomentumEquation), show.equation(Quantity::RestitutionEquation))
    else {
        return Vec::new();
    };
    let left = &p + &q;
    let right = &r - &(&q * &s);
    let value = show.shown_value(x);
    let mut equations = Vec::new();
    if !left.equals(&crate::number::Value::ONE) {
        equations.push(Expr::equation(multiple(&left, v.clone()), written(&right)));
    }
    equations.push(Expr::equation(v.clone(), value));
    equations.extend(decimal(show, x));
    let eliminated = if q.equals(&crate::number::Value::ONE) {
        Line::plain("Subtracting equation (2) from equation (1):", equations)
    } else {
        Line::with("Subtracting {q} times equation (2) from equation (1):", &[("q", written(&q))], equations)
    };
    let mut second = vec![Expr::equation(w, show.shown_value(y))];
    second.extend(decimal(show, y));
    let mut lines = vec![eliminated, Line::plain("Then from equation (2):", second)];
    lines.extend(remarks(show));
    lines.extend(components_asked(show));
    lines
}

/// The decimal of a component in sines and cosines of given degrees.
fn decimal(show: &Show, quantity: Quantity) -> Option<Expr> {
    let value = show.worked(quantity);
    Show::approximately(&show.symbol(quantity), &value).filter(|_| Show::has_degrees(&value))
}

/// Both components of a velocity, where they are what is asked for.
fn components_asked(show: &Show) -> Vec<Line> {
    let both = |sphere| [Axis::N, Axis::T].map(|axis| Quantity::Velocity(sphere, Moment::After, axis));
    let asked = Sphere::BOTH.into_iter().filter(|sphere| both(*sphere).iter().all(|component| show.is_asked(*component)));
    let words = "So the components of the velocity of {A} after the impact are {v m/s} along the line of centres and {p m/s} perpendicular to it.";
    let line = |sphere: Sphere| {
        let [along, across] = both(sphere).map(|component| Show::stated(&show.worked(component)));
        Line::with(words, &[("A", Expr::name(sphere.name())), ("v", along), ("p", across)], vec![])
    };
    asked.map(line).collect()
}

/// What the signs say of the directions, of each sphere that was moving along the line of centres.
fn remarks(show: &Show) -> Vec<Line> {
    let sign = |sphere, moment| show.exact(Quantity::Velocity(sphere, moment, Axis::N)).sign();
    let is_stopped = |sphere: &Sphere| {
        sign(*sphere, Moment::After) == Some(Equal) && sign(*sphere, Moment::Before) != Some(Equal)
    };
    let is_turned = |sphere: &Sphere| {
        let signs = sign(*sphere, Moment::Before).zip(sign(*sphere, Moment::After));
        signs.is_some_and(|(before, after)| before != Equal && after == before.reverse())
    };
    let line = |words: &str, of: &[Sphere]| {
        let names: Vec<(&str, Expr)> = of.iter().map(|sphere| (sphere.name(), Expr::name(sphere.name()))).collect();
        Line::with(words, &names, vec![])
    };
    let stopped = Sphere::BOTH.into_iter().filter(is_stopped);
    let mut lines: Vec<Line> = stopped
        .map(|of| line(&format!("{{{}}} has no velocity left along the line of centres.", of.name()), &[of]))
        .collect();
    let turned: Vec<Sphere> = Sphere::BOTH.into_iter().filter(is_turned).collect();
    let who = match turned.as_slice() {
        [] => return lines,
        [one] => format!("{{{}}} turns", one.name()),
        _ => "{A} and {B} turn".to_owned(),
    };
    let words = format!("The signs differ before and after: {who} back along the line of centres.");
    lines.push(line(&words, &turned));
    lines
}
