//! The choice of letters and directions that makes a student's lines agree best.

use super::compare::any_within;
use super::examine::{Studied, context, value};
use super::linear::{Linear, Sum, difference, sum};
use super::pair::{BOTH, Convention, Departure, Laws, Matched, conventions};
use super::points::sizes;
use super::prepared::Prepared;
use super::spread::Spread;
use super::substituted::{apart, impulse_in, is_impulse, without_impulse};
use super::theirs::numbers;
use super::told_apart::{Found, told_apart, weight};
use crate::expr::Expr;
use crate::mechanics::{Axis, Law, Moment, Quantity, Setting, Sphere};

/// An equation that may be one of the two.
struct Offered {
    /// The place of its line, and which of the readings of that.
    place: usize,
    which: usize,
    /// Left minus right at every point.
    linear: Vec<Linear>,
    /// Does the speed of approach stand in it?
    shows_approach: bool,
    /// Does e?
    shows_e: bool,
    /// Does it say nothing but that the two unknowns are equal?
    says_equal: bool,
}

impl Offered {
    fn of(place: usize, which: usize, equation: &(Expr, Expr), prepared: &Prepared) -> Option<Offered> {
        let linear = differences(equation, prepared)?;
        let (shows_approach, says_equal) = (shows_approach(equation, prepared), says_equal(equation, &linear[0]));
        let shows_e = [&equation.0, &equation.1].iter().any(|side| shows_e(side, prepared));
        Some(Offered { place, which, linear, shows_approach, shows_e, says_equal })
    }

    /// Are its unknowns velocities, one or two of them?
    fn is_of_velocities(&self) -> bool {
        let unknowns = &self.linear[0].unknowns;
        (1..=2).contains(&unknowns.len()) && unknowns.iter().all(|(name, _)| may_be_velocity(name))
    }

    fn found(&self, matched: Matched) -> Found {
        Found { place: self.place, which: self.which, alone: None, matched }
    }

    /// What it may be in this convention: one of the laws as it stands, or each of them with the least change.
    fn matched(&self, laws: &Laws, convention: &Convention) -> Vec<Matched> {
        // An approach that comes to nought by a wrong sign is restitution; no approach at all is not.
        let coalesced = || Matched { equation: BOTH[1], departures: vec![Departure::Coalesced] };
        let mut either = laws.either(&self.linear, convention, self.shows_e);
        // A number alone may be anything: e is another only where it stands with the speed of approach.
        let another = || laws.with_another_restitution(&self.linear, convention);
        if let Some(another) = another().filter(|_| self.shows_approach) {
            let is_nearer = |one: &Matched| one.equation == another.equation && one.weight() <= another.weight();
            if !either.iter().any(is_nearer) {
                either.retain(|one| one.equation != another.equation);
                either.push(another);
            }
        }
        either.sort_by_key(Matched::weight);
        match either.first() {
            Some(_) if self.says_equal => vec![coalesced()],
            Some(first) if first.departures.is_empty() => vec![first.clone()],
            _ => either,
        }
    }
}

/// An equation with a bracket in the place of an unknown: with the unknown there, what the bracket says of it, and whether
/// that stands in a line of its own.
struct Substituted {
    whole: Offered,
    bracket: Offered,
    is_stated: bool,
}

impl Substituted {
    /// One law is the bracket, and the other is all the rest.
    fn matched(&self, laws: &Laws, convention: &Convention) -> Vec<Matched> {
        let mut whole = self.whole.matched(laws, convention).into_iter();
        let Some(whole) = whole.find(Matched::is_method) else { return Vec::new() };
        let mut bracket = self.bracket.matched(laws, convention).into_iter();
        match bracket.find(|bracket| bracket.equation != whole.equation) {
            None if !self.is_stated => Vec::new(),
            bracket => bracket.into_iter().chain([whole]).collect(),
        }
    }
}

/// Finds the lines that are momentum or restitution, and the student's choice of letters and directions that makes them
/// agree best.
pub(super) fn take_as_laws(lines: &mut [Studied], prepared: &Prepared) -> Option<Convention> {
    let laws = prepared.laws.as_ref()?;
    // Every equation of every reading that is more than `v = 3`.
    let equations = || {
        let readings = lines.iter().enumerate().flat_map(|(place, studied)| {
            studied.line.readings.iter().enumerate().map(move |(which, reading)| (place, which, reading))
        });
        readings.flat_map(|(place, which, reading)| {
            let each = reading.equations.iter().filter(|equation| !is_value(equation));
            each.map(move |equation| (place, which, equation))
        })
    };
    let all = equations().filter_map(|(place, which, equation)| Offered::of(place, which, equation, prepared));
    let (mut offered, others): (Vec<Offered>, Vec<Offered>) = all.partition(Offered::is_of_velocities);
    offered.extend(by_impulses(&others));
    let pairs = pairs(&offered, lines);
    let substituted: Vec<Substituted> =
        equations().flat_map(|equation| substituted(equation, &pairs, lines, prepared)).collect();
    let matches = |convention: &Convention| -> Vec<Found> {
        let alone = offered.iter().enumerate().flat_map(|(number, offered)| {
            let found = move |matched| Found { alone: Some(number), ..offered.found(matched) };
            offered.matched(laws, convention).into_iter().map(found)
        });
        let within = substituted.iter().flat_map(|substituted| {
            let found = |matched| substituted.whole.found(matched);
            substituted.matched(laws, convention).into_iter().map(found)
        });
        told_apart(alone.chain(within).collect())
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
    for Found { place, which, matched, .. } in found {
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

/// What the equations with an impulse come to without it: one of a sphere and one of the other are momentum.
fn by_impulses(equations: &[Offered]) -> Vec<Offered> {
    let with_impulse: Vec<&Offered> =
        equations.iter().filter(|offered| impulse_in(&offered.linear[0]).is_some()).take(MOST_IMPULSES).collect();
    let mut found = Vec::new();
    for (number, later) in with_impulse.iter().enumerate() {
        for earlier in &with_impulse[..number] {
            let linear = without_impulse(&earlier.linear, &later.linear);
            found.extend(linear.map(|linear| Offered { linear, shows_approach: false, says_equal: false, ..**later }));
        }
    }
    found.retain(Offered::is_of_velocities);
    found
}

/// More equations with an impulse are not set beside each other.
const MOST_IMPULSES: usize = 6;

/// The ways to take an equation with one unknown for one in which a bracket stands for the other.
fn substituted(
    (place, which, equation): (usize, usize, &(Expr, Expr)),
    pairs: &[Vec<String>],
    lines: &[Studied],
    prepared: &Prepared,
) -> Vec<Substituted> {
    let mut found = Vec::new();
    for [one, other] in pairs.iter().filter_map(|pair| <&[String; 2]>::try_from(pair.as_slice()).ok()) {
        let has = |letter: &str| {
            [&equation.0, &equation.1].iter().flat_map(|side| side.names()).any(|name| name.text == letter)
        };
        let (letter, other) = match (has(one), has(other)) {
            (true, false) => (one, other),
            (false, true) => (other, one),
            _ => continue,
        };
        for [whole, bracket] in apart(equation, letter, other) {
            let is_stated =
                lines.iter().flat_map(|studied| &studied.line.readings).flat_map(|reading| &reading.equations).any(
                    |(left, right)| {
                        (left, right) == (&bracket.0, &bracket.1) || (right, left) == (&bracket.0, &bracket.1)
                    },
                );
            let both = [whole, bracket].map(|equation| {
                Offered::of(place, which, &equation, prepared)
                    .filter(|offered| offered.linear[0].unknowns.len() == 2 && offered.is_of_velocities())
            });
            if let [Some(whole), Some(bracket)] = both {
                found.push(Substituted { whole, bracket, is_stated });
            }
        }
    }
    found
}

/// May a letter stand for a velocity? Not an angle's, nor that of an impulse or an energy: `δ = β - α` is no law.
fn may_be_velocity(name: &str) -> bool {
    let is_greek = name.len() > 3 && !name.contains(['_', ' ']);
    !is_greek && !is_impulse(name) && !matches!(name, "phi" | "E")
}

/// Are both unknowns positive against i, or against j, along which the line of centres lies?
fn is_against_axes(convention: &Convention, prepared: &Prepared) -> bool {
    // Nobody speaks of i on a straight line.
    if prepared.setting == Setting::Direct {
        return false;
    }
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

/// Does e stand in a formula: by its letter, as a factor, or squared in `1 - e²`? In an energy a half is no e.
pub(super) fn shows_e(expr: &Expr, prepared: &Prepared) -> bool {
    let Some(e) = sizes(&prepared.known, Quantity::Restitution) else { return false };
    let is = |expr: &Expr, power: i32| {
        let values = value(expr, prepared, &[]).and_then(|values| numbers(&values));
        values.is_some_and(|values| {
            values.iter().zip(&e).all(|(value, e)| (value - e.powi(power)).abs() < 1e-6 * value.abs())
        })
    };
    let is_square = |inner: &Expr| matches!(inner, Expr::Power(..));
    any_within(expr, &|inner| match inner {
        Expr::Name(name) => name.text == "e",
        Expr::Product(factors) => !any_within(inner, &is_square) && factors.iter().any(|factor| is(factor, 1)),
        Expr::Sum(terms) => match terms.as_slice() {
            [one, Expr::Negative(taken)] => *one == Expr::integer(1) && is(taken, 2),
            _ => false,
        },
        _ => false,
    })
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
    // With the velocities below a line it is the wrong way up.
    let is_sum = |side: &Expr| sum(side, &context(prepared, 0)).is_some();
    is_sum(left) && is_sum(right) && (within_above(left, &is) || within_above(right, &is))
}

/// Is it so of a part of the formula? What is below a number is no part: `1/4` is e where the approach is 4.
fn within_above(expr: &Expr, is: &dyn Fn(&Expr) -> bool) -> bool {
    is(expr)
        || match expr {
            Expr::Quotient(above, _) if above.names().is_empty() => within_above(above, is),
            other => other.children().into_iter().any(|child| within_above(child, is)),
        }
}

/// Is it `v = 3` or `3 = v`?
pub(super) fn is_value((left, right): &(Expr, Expr)) -> bool {
    let is_letter = |expr: &Expr| matches!(expr, Expr::Name(_));
    (is_letter(left) && right.names().is_empty()) || (is_letter(right) && left.names().is_empty())
}

/// Pairs of unknowns that stand together in an equation, the most frequent first; else those that usually do.
fn pairs(offered: &[Offered], lines: &[Studied]) -> Vec<Vec<String>> {
    let mut counted: Vec<(Vec<String>, usize)> = Vec::new();
    for offered in offered {
        let mut names: Vec<String> = offered.linear[0].unknowns.iter().map(|(name, _)| name.clone()).collect();
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
            .chain(offered.iter().flat_map(|offered| offered.linear[0].unknowns.iter().map(|(name, _)| name.clone())))
            .collect();
        let usual = [["v_A", "v_B"], ["v_1", "v_2"], ["V_A", "V_B"], ["v", "w"], ["V", "W"], ["x", "y"]];
        let used = |pair: &&[&str; 2]| pair.iter().any(|name| letters.iter().any(|letter| letter == name));
        pairs.extend(usual.iter().find(used).map(|pair| pair.iter().map(|name| (*name).to_owned()).collect()));
    }
    pairs
}

/// Left minus right of an equation at every point; of a vector the component along the line of centres.
pub(super) fn differences(equation: &(Expr, Expr), prepared: &Prepared) -> Option<Vec<Linear>> {
    let at = |point| match difference(&equation.0, &equation.1, &context(prepared, point))? {
        Sum::Number(linear) => Some(linear),
        Sum::Vector(x, y) => {
            let line = |axis| prepared.known[point].number(Quantity::Line(axis)).map(Spread::exactly);
            Some(x.times(line(Axis::X)?).plus(&y.times(line(Axis::Y)?)))
        }
    };
    (0..prepared.points.count).map(at).collect()
}
