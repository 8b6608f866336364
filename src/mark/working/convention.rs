//! The choice of letters and directions that makes a student's lines agree best.

use super::compare::any_within;
use super::examine::{Studied, context, value};
use super::linear::{Linear, Sum, difference};
use super::pair::{BOTH, Convention, Departure, Matched, conventions};
use super::points::sizes;
use super::prepared::Prepared;
use super::spread::Spread;
use super::theirs::numbers;
use crate::expr::Expr;
use crate::mechanics::{Axis, Law, Moment, Quantity, Sphere};

/// The place of a line, which of its readings, and what it is.
type Found = (usize, usize, Matched);

/// Finds the lines that are momentum or restitution, and the student's choice of letters and directions that makes them
/// agree best.
pub(super) fn take_as_laws(lines: &mut [Studied], prepared: &Prepared) -> Option<Convention> {
    let laws = prepared.laws.as_ref()?;
    // Every equation of every reading that is more than `v = 3`.
    let mut offered: Vec<(usize, usize, Vec<Linear>)> = Vec::new();
    let mut without_approach: Vec<usize> = Vec::new();
    let mut bare: Vec<(usize, usize)> = Vec::new();
    for (place, studied) in lines.iter().enumerate() {
        for (which, reading) in studied.line.readings.iter().enumerate() {
            for equation in reading.equations.iter().filter(|equation| !is_value(equation)) {
                if let Some(linear) = differences(equation, prepared)
                    && (1..=2).contains(&linear[0].unknowns.len())
                    && linear[0].unknowns.iter().all(|(name, _)| may_be_velocity(name))
                {
                    if says_equal(equation, &linear[0]) {
                        bare.push((place, which));
                    }
                    if !shows_approach(equation, prepared) {
                        without_approach.push(offered.len());
                    }
                    offered.push((place, which, linear));
                }
            }
        }
    }
    let pairs = pairs(&offered, lines);
    let matches = |convention: &Convention| -> Vec<Found> {
        let each = offered.iter().enumerate();
        let found = each.filter_map(|(number, (place, which, linear))| {
            let matched = laws.matched(linear, convention)?;
            // A number alone may be anything: e is another only where it stands with the speed of approach.
            let is_e = matched.departures != [Departure::AnotherRestitution] || !without_approach.contains(&number);
            is_e.then_some((*place, *which, matched))
        });
        found.map(|(place, which, matched)| (place, which, named(matched, bare.contains(&(place, which))))).collect()
    };
    let mut best: Option<(u32, Convention, Vec<Found>)> = None;
    for convention in pairs.iter().flat_map(|pair| conventions(pair)) {
        let found = matches(&convention);
        let is_unusual = convention.is_unusual || is_against_axes(&convention, prepared);
        let weight = weight(&found) + u32::from(is_unusual) + disagreement(lines, &convention, prepared);
        if best.as_ref().is_none_or(|(least, ..)| weight < *least) {
            best = Some((weight, convention, found));
        }
        if weight == 0 {
            break;
        }
    }
    let (_, convention, found) = best?;
    for (place, which, matched) in found {
        let studied = &mut lines[place];
        let own = studied.matched.iter().position(|before| before.equation == matched.equation);
        match own {
            Some(own) if studied.matched[own].weight() <= matched.weight() => continue,
            Some(own) => studied.matched[own] = matched,
            None => studied.matched.push(matched),
        }
        studied.reading = Some(studied.line.readings[which].clone());
    }
    for studied in lines.iter_mut() {
        studied.role = studied.matched.iter().map(role).collect::<Vec<_>>().join("; ");
    }
    Some(convention)
}

/// May a letter stand for a velocity? Not an angle's, nor that of an impulse or an energy: `δ = β - α` is no law.
fn may_be_velocity(name: &str) -> bool {
    let is_greek = name.len() > 3 && !name.contains(['_', ' ']);
    !is_greek && !matches!(name, "phi" | "I" | "J" | "E")
}

/// Are both unknowns positive against i, or against j, along which the line of centres lies?
fn is_against_axes(convention: &Convention, prepared: &Prepared) -> bool {
    let line = |axis| sizes(&prepared.known, Quantity::Line(axis)).map_or(0.0, |line| line[0]);
    let along = line(Axis::X) + line(Axis::Y);
    convention.signs.iter().all(|sign| sign * along < 0.0)
}

/// Do the values that are stated speak against this choice? Where masses are equal the two equations do not tell.
fn disagreement(lines: &[Studied], convention: &Convention, prepared: &Prepared) -> u32 {
    let disagrees = |place: usize| {
        let right = sizes(&prepared.known, Quantity::Velocity(Sphere::BOTH[place], Moment::After, Axis::N));
        let members = lines.iter().filter_map(|studied| studied.reading.as_ref()).flat_map(|reading| &reading.members);
        let mut own = members.filter(|member| member.letter.as_ref() == Some(&convention.letters[place]));
        right.is_some_and(|right| {
            own.any(|member| {
                let values = value(&member.expr, prepared, &prepared.names).and_then(|values| numbers(&values));
                let near =
                    |(own, right): (&f64, &f64)| (own * convention.signs[place] - right).abs() < 0.01 * right.abs();
                values.is_some_and(|values| !values.iter().zip(&right).all(near))
            })
        })
    };
    2 * (0..2).filter(|place| disagrees(*place)).count() as u32
}

/// What the best line of each law is short of; a law without a line costs more than any line.
fn weight(found: &[Found]) -> u32 {
    let least = |equation| {
        found.iter().filter(|(.., matched)| matched.equation == equation).map(|(.., matched)| matched.weight()).min()
    };
    let [momentum, restitution] = BOTH.map(|equation| least(equation).unwrap_or(20));
    // Signs are to be consistent with the student's momentum: of two choices that cost the same, that which keeps it.
    momentum + u32::from(momentum > 0) + restitution
}

fn role(matched: &Matched) -> String {
    let law = Law::ALL.iter().find(|law| law.gives(matched.equation)).map_or("", |law| law.name());
    match matched.departures.as_slice() {
        [] => law.to_owned(),
        departures => {
            let reasons: Vec<&str> = departures.iter().map(|departure| departure.sentence()).collect();
            format!("{law}: {}", reasons.join("; "))
        }
    }
}

/// Is it `v = w` or `w - v = 0`, with nothing of the approach in it?
fn says_equal((left, right): &(Expr, Expr), linear: &Linear) -> bool {
    let [(one, v), (other, w)] = linear.unknowns.as_slice() else { return false };
    let is_bare = |expr: &Expr| {
        let names = expr.names();
        *expr == Expr::integer(0)
            || (!any_within(expr, &|inner| matches!(inner, Expr::Number(_) | Expr::Decimal(_)))
                && names.iter().all(|name| name.text == *one || name.text == *other))
    };
    is_bare(left) && is_bare(right) && (v.middle() + w.middle()).abs() < 1e-9
}

/// Does the speed of approach stand in the equation: as a number, a product, or a factor of one?
fn shows_approach((left, right): &(Expr, Expr), prepared: &Prepared) -> bool {
    let along = |sphere| sizes(&prepared.known, Quantity::Velocity(sphere, Moment::Before, Axis::N));
    let Some((a, b)) = along(Sphere::A).zip(along(Sphere::B)) else { return false };
    let is_approach = |expr: &Expr| {
        let values = value(expr, prepared, &prepared.names).and_then(|values| numbers(&values));
        values.is_some_and(|values| {
            values
                .iter()
                .zip(a.iter().zip(&b))
                .all(|(value, (a, b))| (value.abs() - (a - b).abs()).abs() < 0.005 * value.abs())
        })
    };
    let has_factors = |factors: &[Expr]| {
        (1..1_usize << factors.len().min(6)).any(|chosen| {
            let some = factors.iter().enumerate().filter(|(place, _)| chosen >> place & 1 == 1);
            is_approach(&Expr::Product(some.map(|(_, factor)| factor.clone()).collect()))
        })
    };
    let is = |inner: &Expr| match inner {
        Expr::Product(factors) => has_factors(factors),
        other => is_approach(other),
    };
    within_above(left, &is) || within_above(right, &is)
}

/// Is it so of a part of the formula? What is below a number is no part: `1/4` is e where the approach is 4.
fn within_above(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expr)
        || match expr {
            Expr::Quotient(above, _) if above.names().is_empty() => within_above(above, is),
            other => other.children().into_iter().any(|child| within_above(child, is)),
        }
}

/// An approach that comes to nought by a wrong sign is restitution; no approach at all is not.
fn named(matched: Matched, says_equal: bool) -> Matched {
    match says_equal {
        true => Matched { equation: Quantity::RestitutionEquation, departures: vec![Departure::Coalesced] },
        false => matched,
    }
}

/// Is it `v = 3` or `3 = v`?
pub(super) fn is_value((left, right): &(Expr, Expr)) -> bool {
    let is_letter = |expr: &Expr| matches!(expr, Expr::Name(_));
    (is_letter(left) && right.names().is_empty()) || (is_letter(right) && left.names().is_empty())
}

/// Pairs of unknowns that stand together in an equation, the most frequent first; else those that usually do.
fn pairs(offered: &[(usize, usize, Vec<Linear>)], lines: &[Studied]) -> Vec<Vec<String>> {
    let mut counted: Vec<(Vec<String>, usize)> = Vec::new();
    for (.., linear) in offered {
        let mut names: Vec<String> = linear[0].unknowns.iter().map(|(name, _)| name.clone()).collect();
        names.sort();
        if names.len() == 2 {
            match counted.iter_mut().find(|(known, _)| *known == names) {
                Some((_, count)) => *count += 1,
                None => counted.push((names, 1)),
            }
        }
    }
    counted.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let mut pairs: Vec<Vec<String>> = counted.into_iter().map(|(names, _)| names).take(2).collect();
    if pairs.is_empty() {
        let letters: Vec<String> = lines
            .iter()
            .filter_map(|studied| studied.reading.as_ref())
            .flat_map(|reading| reading.members.iter().filter_map(|member| member.letter.clone()))
            .chain(offered.iter().flat_map(|(.., linear)| linear[0].unknowns.iter().map(|(name, _)| name.clone())))
            .collect();
        let usual = [["v_A", "v_B"], ["v_1", "v_2"], ["V_A", "V_B"], ["v", "w"], ["V", "W"], ["x", "y"]];
        let used = |pair: &&[&str; 2]| pair.iter().any(|name| letters.iter().any(|letter| letter == name));
        pairs.extend(usual.iter().find(used).map(|pair| pair.iter().map(|name| (*name).to_owned()).collect()));
    }
    pairs
}

/// Left minus right of an equation at every point; of a vector the component along the line of centres.
fn differences(equation: &(Expr, Expr), prepared: &Prepared) -> Option<Vec<Linear>> {
    let at = |point| match difference(&equation.0, &equation.1, &context(prepared, point))? {
        Sum::Number(linear) => Some(linear),
        Sum::Vector(x, y) => {
            let line = |axis| prepared.known[point].number(Quantity::Line(axis)).map(Spread::exactly);
            Some(x.times(line(Axis::X)?).plus(&y.times(line(Axis::Y)?)))
        }
    };
    (0..prepared.points.count).map(at).collect()
}
