//! Equations in which what one unknown is has been put in its place, or an impulse has been eliminated.
//!
//! `8 = 4v + 3(v + 1.5)` is momentum with what restitution says of w: with w for the bracket it is `8 = 4v + 3w`, and the
//! bracket says `w = v + 1.5`. So is `8 = 4v + 3v + 4.5` where that has been said before. `J = 2(w + 2)` and `-J = v - 3` are momentum, once for each sphere.

use crate::expr::Expr;
use crate::mark::working::numbers::{Linear, Spread};

/// The equations that are in one in which a bracket with one unknown stands for another: with the other in the place of
/// the bracket, and what the bracket says it is.
pub(super) fn apart((left, right): &(Expr, Expr), letter: &str, other: &str) -> Vec<[(Expr, Expr); 2]> {
    let mut found: Vec<&Expr> = Vec::new();
    collect_brackets(left, letter, &mut found);
    collect_brackets(right, letter, &mut found);
    let with = |bracket: &Expr| {
        let put = |side: &Expr| with_name(side, bracket, other);
        [(put(left), put(right)), (Expr::name(other), bracket.clone())]
    };
    found.into_iter().take(MOST_BRACKETS).map(with).collect()
}

/// Nobody writes more brackets into one of the two equations.
const MOST_BRACKETS: usize = 6;

/// Sums with the letter in them, and such sums over a number.
fn collect_brackets<'e>(expr: &'e Expr, letter: &str, found: &mut Vec<&'e Expr>) {
    let is_bracket = match expr {
        Expr::Sum(_) => true,
        Expr::Quotient(above, _) => matches!(**above, Expr::Sum(_)),
        _ => false,
    };
    let has_letter = |expr: &Expr| expr.names().iter().any(|name| name.text == letter);
    if is_bracket && has_letter(expr) && !found.contains(&expr) {
        found.push(expr);
    }
    expr.children().into_iter().for_each(|child| collect_brackets(child, letter, found));
}

fn with_name(expr: &Expr, bracket: &Expr, name: &str) -> Expr {
    match expr == bracket {
        true => Expr::name(name),
        false => expr.map_children(&mut |child| with_name(child, bracket, name)),
    }
}

/// An equation in one unknown, brackets multiplied out, with the other put back for what was said of it, at every point:
/// once for each term in the unknown that may have come of the bracket. `terms` are all on one side. If brackets were
/// lost, the factor stands before the unknown alone, and 1 or -1 before the rest: `3v + 3` came of `3(v + 3)`.
pub(super) fn put_back(
    terms: &[Vec<Linear>],
    said: &[Linear],
    [letter, other]: [&str; 2],
    lost: Option<f64>,
) -> Vec<Vec<Linear>> {
    let is_of_letter =
        |term: &&Vec<Linear>| term.iter().all(|at| !at.is_number() && at.constant == Spread::exactly(0.0));
    let of_letter: Vec<&Vec<Linear>> = terms.iter().filter(is_of_letter).collect();
    // Gathered up it could be anything's.
    if of_letter.len() < 2 || terms.len() > MOST_TERMS {
        return Vec::new();
    }
    let nothing = || Linear::number(Spread::exactly(0.0));
    let whole = |point: usize| terms.iter().fold(nothing(), |sum, term| sum.plus(&term[point]));
    let put = |term: &Vec<Linear>| {
        let at = |(point, said): (usize, &Linear)| {
            let times = term[point].before(letter).over(said.before(letter))?;
            let back = Linear::unknown(other).times(times);
            let factor_of_rest = lost.map_or(-times, Spread::exactly);
            let rest = Linear::number(said.constant * factor_of_rest);
            let unknown = Linear::unknown(letter).times(-(times * said.before(letter)));
            Some(whole(point).plus(&unknown).plus(&rest).plus(&back))
        };
        said.iter().enumerate().map(at).collect::<Option<Vec<Linear>>>()
    };
    of_letter.into_iter().filter_map(put).collect()
}

/// Nobody writes more terms into such an equation.
const MOST_TERMS: usize = 8;

/// Is it a letter for an impulse?
pub(super) fn is_impulse(name: &str) -> bool {
    matches!(name, "I" | "J")
}

/// The impulse that an equation has beside a velocity.
pub(super) fn impulse_in(linear: &Linear) -> Option<&str> {
    let [(one, _), (other, _)] = linear.unknowns.as_slice() else { return None };
    match (is_impulse(one), is_impulse(other)) {
        (true, false) => Some(one),
        (false, true) => Some(other),
        _ => None,
    }
}

/// Two equations with the same impulse and different velocities, the impulse eliminated.
pub(super) fn without_impulse(one: &[Linear], other: &[Linear]) -> Option<Vec<Linear>> {
    let impulse = impulse_in(&one[0]).filter(|impulse| impulse_in(&other[0]) == Some(impulse))?;
    let at = |(one, other): (&Linear, &Linear)| {
        let (of_one, of_other) = (one.before(impulse), other.before(impulse));
        let both = one.clone().times(of_other).plus(&other.clone().times(-of_one));
        (both.unknowns.len() == 2 && both.unknowns.iter().all(|(name, _)| name != impulse)).then_some(both)
    };
    one.iter().zip(other).map(at).collect()
}
