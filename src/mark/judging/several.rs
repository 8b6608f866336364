//! How several values of one answer go together: which is of which sphere, which is made or chosen from the others, and which
//! is the same again.

use crate::expr::Expr;
use crate::mark::enclosure::about;
use crate::mark::reading::{Form, Said, Statement};
use crate::mechanics::{Axis, Quantity, Sphere};

use super::bounds::rounds_to;
use super::chain::is_bare_number;
use super::spheres::sphere;
use super::statements::is_rival;
use super::{Model, called, sorts};

/// `speeds 5 and 3`, where one of them is asked: which is of which sphere is not said.
pub(super) fn are_of_both_spheres(model: &Model, statements: &[&Statement]) -> bool {
    let [first, second] = statements else { return false };
    let is_plural = |word: &str| matches!(&*word.to_lowercase(), "speeds" | "velocities" | "angles");
    let are_named = first.label.as_ref().is_some_and(|label| sorts::words(&label.typed).any(is_plural));
    let any_rival = statements.iter().flat_map(|statement| &statement.said).any(is_rival);
    model.quantity.and_then(sphere).is_some() && are_named && second.label.is_none() && !any_rival
}

/// `k = 8 or −14, k = 8`: is the last of them, under its name, one between which somebody chooses?
pub(super) fn is_chosen_from_the_others(statements: &[&Statement]) -> bool {
    let Some((last, others)) = statements.split_last() else { return false };
    let form = |statement: &Statement| statement.said.last().map(|said| said.form.clone());
    let any_rival = others.iter().flat_map(|other| &other.said).any(is_rival);
    let is_it = |other: &&Statement| form(other) == form(last);
    any_rival && last.label.is_some() && !last.said.iter().any(is_rival) && others.iter().any(is_it)
}

/// `v = 4, w = 5`, `v1 = 4, v2 = 5` where the speed of one of two spheres is asked, `m1 = 2, m2 = 3` where its mass is: by custom
/// the first letter is of *A*.
pub(super) fn by_custom<'s>(model: &Model, statements: &[&'s Statement]) -> Option<&'s Statement> {
    const SPEEDS: [[&str; 2]; 3] = [["v", "w"], ["v1", "v2"], ["v_1", "v_2"]];
    const MASSES: [[&str; 2]; 2] = [["m1", "m2"], ["m_1", "m_2"]];
    let [first, second] = statements else { return None };
    let typed = |statement: &Statement| Some(statement.label.as_ref()?.typed.trim().to_lowercase());
    let names = [typed(first)?, typed(second)?];
    let is_pair = |pair: &[&str; 2]| pair.iter().all(|name| names.iter().any(|own| own == name));
    // What happens in a later impact, or to one sphere twice, has no such custom.
    let is_of_both =
        |asked: &Quantity| asked.impact() == 0 && !Sphere::BOTH.iter().any(|own| model.strangers.contains(own));
    let asked = model.quantity.filter(is_of_both)?;
    let pairs: &[[&str; 2]] = match asked {
        Quantity::Speed(..) | Quantity::Velocity(_, _, Axis::N) => &SPEEDS,
        Quantity::Mass(_) => &MASSES,
        _ => return None,
    };
    let pair = pairs.iter().find(|pair| is_pair(pair))?;
    let at = sphere(asked)? as usize;
    let own = names.iter().position(|name| Some(&name.as_str()) == pair.get(at))?;
    let any_rival = statements.iter().flat_map(|statement| &statement.said).any(is_rival);
    statements.get(own).filter(|_| !any_rival).copied()
}

/// Two bare numbers, of which the second is drawn from the first, where a loss or an impulse is asked.
pub(super) fn is_from_one_to_another(model: &Model, statements: &[&Statement]) -> bool {
    let is_change = |asked: Quantity| {
        sorts::is_of_change(asked) || matches!(asked, Quantity::Impulse(..) | Quantity::ImpulseMagnitude)
    };
    let is_bare = |statement: &&Statement| matches!(statement.said.as_slice(), [only] if is_bare_number(only));
    let [first, last] = statements else { return false };
    model.quantity.map(Quantity::of_its_impact).is_some_and(is_change)
        && is_bare(first)
        && is_bare(last)
        && last.label.is_none()
        && !called::is_named(model, first)
}

/// `58.0 before, 46.8 after, total 104.8`, `37.5 lost, 7.5 gained, 30 lost`: does the last of three come of the two before it,
/// as their sum, their difference, or the hypotenuse?
pub(super) fn is_made_of_the_others(statements: &[&Statement]) -> bool {
    /// Of figures that were rounded to three.
    const NEAR: f64 = 3e-3;
    let said: Vec<&Said> = statements.iter().filter_map(|statement| statement.said.last()).collect();
    let [one, other, last] = said.as_slice() else { return false };
    if statements.len() != 3 || said.iter().any(|said| is_rival(said)) {
        return false;
    }
    let is = |last: f64, made: f64| (last - made).abs() <= NEAR * made.abs();
    let number = |expr: &Expr| about(expr, &[]);
    match (&one.form, &other.form, &last.form) {
        (Form::Value(one), Form::Value(other), Form::Value(last)) => {
            let (Some(one), Some(other), Some(last)) = (number(one), number(other), number(last)) else { return false };
            [one + other, one - other, other - one, one.hypot(other)].into_iter().any(|made| is(last, made))
        }
        (Form::Vector(a, b, _), Form::Vector(c, d, _), Form::Vector(x, y, _)) => {
            let sum = |one: &Expr, other: &Expr| Some(number(one)? + number(other)?);
            let is_sum = |one, other, last| sum(one, other).zip(number(last)).is_some_and(|(sum, last)| is(last, sum));
            is_sum(a, c, x) && is_sum(b, d, y)
        }
        _ => false,
    }
}

/// `1/14 i.e. 0.07`, `1/14 or 0.07`: is it a decimal without a name, to which an exact value rounds?
pub(super) fn is_rounded_from(exact: &Statement, rounded: &Statement) -> bool {
    let ([exact], [said]) = (exact.said.as_slice(), rounded.said.as_slice()) else { return false };
    let (Form::Value(exact), Form::Value(decimal)) = (&exact.form, &said.form) else { return false };
    rounded.label.is_none() && matches!(exact, Expr::Quotient(..) | Expr::Call(..)) && rounds_to(exact, decimal)
}
