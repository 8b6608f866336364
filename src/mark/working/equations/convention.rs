//! The choice of letters and directions that makes a student's lines agree best.

use super::brackets_lost::with_brackets_lost;
use super::conventions::{Convention, conventions};
use super::critical::noughts;
use super::departure::Departure;
use super::misread::{Misread, with_number_misread};
use super::offered::{Offered, differences};
use super::pair::{Laws, Matched};
use super::substituted::{apart, impulse_in, put_back, without_impulse};
use super::told_apart::{Found, told_apart, weight, weight_of_stated, without_one_for_both};
use super::two_lines;
use super::unusual::of_velocities;
use crate::expr::Expr;
use crate::mark::working::examine::Studied;
use crate::mark::working::letters::false_number;
use crate::mark::working::lines::ReadLine;
use crate::mark::working::numbers::{Linear, Spread, any_within, sizes};
use crate::mark::working::prepared::Prepared;
use crate::mechanics::{Axis, Law, Moment, Quantity, Setting, Sphere};

/// An equation with a bracket in the place of an unknown: with the unknown there, what the bracket says of it, and whether
/// that stands in a line of its own.
struct Substituted {
    whole: Offered,
    bracket: Offered,
    is_stated: bool,
    /// Is it put back as if a factor had not been multiplied into all of what was said?
    is_lost: bool,
}

impl Substituted {
    /// One law is the bracket, and the other is all the rest.
    fn matched(&self, laws: &Laws, convention: &Convention) -> Vec<Matched> {
        let mut whole = self.whole.matched(laws, convention).into_iter();
        let Some(mut whole) = whole.find(Matched::is_method) else { return Vec::new() };
        if self.is_lost {
            if !whole.departures.is_empty() {
                return Vec::new();
            }
            whole.departures.push(Departure::BracketsLost);
        }
        let mut bracket = self.bracket.matched(laws, convention).into_iter();
        match bracket.find(|bracket| bracket.equation != whole.equation) {
            None if !self.is_stated => Vec::new(),
            bracket => bracket.into_iter().chain([whole]).collect(),
        }
    }
}

/// Finds the lines that are momentum or restitution, and the student's choice of letters and directions that makes them
/// agree best.
pub(in crate::mark::working) fn take_as_laws(lines: &mut [Studied], prepared: &Prepared) -> Option<Convention> {
    let laws = prepared.laws.as_ref()?;
    let readings = lines.iter().enumerate().flat_map(|(place, studied)| {
        // `2/3(w - v)` is two thirds of it, and nothing over it.
        let is_plain = |reading: &ReadLine| !has_unknown_below(reading, prepared);
        let has_plain = studied.line.readings.iter().any(|reading| is_plain(reading));
        let readings = studied.line.readings.iter().enumerate();
        let likely = readings.filter(move |(_, reading)| !has_plain || is_plain(reading));
        likely.map(move |(which, reading)| (place, which, reading))
    });
    let said: Vec<(usize, usize, (Expr, Expr))> = readings
        .flat_map(|(place, which, reading)| {
            in_numbers(&reading.equations, prepared).into_iter().map(move |equation| (place, which, equation))
        })
        .collect();
    let all = said.iter().map(|(place, which, equation)| (*place, *which, equation));
    let equations = || all.clone().filter(|(.., equation)| !is_value(equation));
    let offers = equations().filter_map(|(place, which, equation)| Offered::of(place, which, equation, prepared));
    let (mut offered, others) = of_velocities(offers.collect());
    offered.extend(by_impulses(&others));
    let on_two_lines =
        two_lines::momentum(lines).and_then(|(place, which, equation)| Offered::of(place, which, &equation, prepared));
    offered.extend(on_two_lines.filter(Offered::is_of_velocities));
    let pairs = pairs(&offered, lines);
    let substituted: Vec<Substituted> =
        equations().flat_map(|equation| substituted(equation, &pairs, lines, prepared)).collect();
    let noughts = noughts(lines);
    let matches = |convention: &Convention| -> Vec<Found> {
        let alone = offered.iter().enumerate().flat_map(|(number, offered)| {
            let critical = offered.critical(prepared.critical.as_ref(), convention, &noughts);
            offered.found(number, critical.unwrap_or(laws), convention)
        });
        let within = substituted.iter().flat_map(|substituted| {
            let found = |matched| substituted.whole.found_as(matched);
            substituted.matched(laws, convention).into_iter().map(found)
        });
        told_apart(without_one_for_both(alone.chain(within).collect()))
    };
    let mut best: Option<(u32, Convention, Vec<Found>)> = None;
    for convention in pairs.iter().flat_map(|pair| conventions(pair)) {
        let found = matches(&convention);
        let short = weight(&found);
        if convention.is_against_numbers && short > 0 {
            continue;
        }
        let is_unusual = convention.is_unusual || is_against_axes(&convention, prepared);
        let is_shown = weight_of_stated(&found) == 0 || parts_the_spheres(&convention, &found);
        let is_doubtful = convention.is_unusual && (prepared.has_equal_masses() || !is_shown);
        let of_letters = if is_doubtful { EXCHANGED } else { 0 };
        let weight = short + u32::from(is_unusual) + of_letters + disagreement(lines, &convention, prepared);
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
    for (place, which, equation) in &said {
        let studied = &mut lines[*place];
        // Of two mistakes in one line and one number that is copied wrongly, that is likelier.
        let is_unlikely = studied.matched.iter().all(|one| !one.is_method() && one.departures.len() > 1);
        if is_unlikely && let Some(law) = with_brackets_lost(equation, laws, &convention, prepared) {
            (studied.reading, studied.matched) = (Some(studied.line.readings[*which].clone()), vec![law]);
        } else if is_unlikely && let Some((law, misread)) = with_number_misread(equation, laws, &convention, prepared) {
            studied.misread = misread;
            (studied.reading, studied.matched) = (Some(studied.line.readings[*which].clone()), vec![law]);
        }
        let is_another = |one: &Matched| one.departures == [Departure::AnotherRestitution];
        if studied.matched.iter().any(is_another)
            && let Some(given) = &prepared.restitution
            && let Some(line) = differences(equation, prepared)
            && let Some(written) = laws.another_restitution(&line, &convention)
        {
            studied.misread = Some(Misread::of_restitution(given.clone(), written));
        }
    }
    for studied in lines.iter_mut() {
        studied.role = studied.matched.iter().map(role).collect::<Vec<_>>().join("; ");
    }
    Some(convention)
}

/// What it costs to take the first letter for B where nothing shows that it is: more than masses on the wrong spheres, for
/// they would be right with the letters exchanged; and so would every wrong sign where the masses are equal.
const EXCHANGED: u32 = 7;

/// Does restitution say by itself which letter is of the sphere in front: `v - w = e u` with v for B?
fn parts_the_spheres(convention: &Convention, found: &[Found]) -> bool {
    let restitution = Matched { equation: Quantity::RestitutionEquation, departures: Vec::new() };
    convention.signs == [1.0, 1.0] && found.iter().any(|found| found.matched == restitution)
}

/// The equations of a line, where a law in general letters is passed over between two sides: in
/// `w - v = e u_A = ⅓(4 cos 30°)` the number is what the difference of the velocities is.
fn in_numbers(equations: &[(Expr, Expr)], prepared: &Prepared) -> Vec<(Expr, Expr)> {
    let is_known = |name: &str| matches!(name, "i" | "j") || prepared.gives(name);
    // In `30 = 4x + y = 30` and `e = (w - v)/6 = ½` there is no other side for it.
    let is_general = |side: &Expr, beside: &[&Expr]| {
        if beside.iter().all(|other| other.names().iter().all(|name| is_known(&name.text))) {
            return false;
        }
        let stands = |name: &str| beside.iter().any(|other| other.names().iter().any(|known| known.text == name));
        side.names().iter().any(|name| !is_known(&name.text) && !stands(&name.text))
    };
    let mut found: Vec<(Expr, Expr)> = Vec::new();
    for (left, right) in equations.iter().filter(|(left, right)| left != right) {
        let beside = match found.last_mut() {
            Some((first, middle)) if middle == left && is_general(left, &[&*first, right]) => {
                *middle = right.clone();
                continue;
            }
            // In `12 cos 25° = 11.89 = 3v + 2w` the number is worked out wrongly, and not what is resolved.
            Some((first, middle)) if middle == left && false_number(first, middle, prepared).is_some() => {
                Some((first.clone(), right.clone()))
            }
            _ => None,
        };
        found.push((left.clone(), right.clone()));
        found.extend(beside);
    }
    found
}

/// Does a reading have a letter that is to be found below a line?
fn has_unknown_below(reading: &ReadLine, prepared: &Prepared) -> bool {
    let is_unknown = |name: &str| !prepared.gives(name);
    let is_below = |inner: &Expr| match inner {
        Expr::Quotient(_, below) => below.names().iter().any(|name| is_unknown(&name.text)),
        _ => false,
    };
    reading.equations.iter().any(|(left, right)| any_within(left, &is_below) || any_within(right, &is_below))
}

/// What the equations with an impulse come to without it: one of a sphere and one of the other are momentum.
fn by_impulses(equations: &[Offered]) -> Vec<Offered> {
    let with_impulse: Vec<&Offered> =
        equations.iter().filter(|offered| impulse_in(&offered.linear[0]).is_some()).take(MOST_IMPULSES).collect();
    let mut found = Vec::new();
    for (number, later) in with_impulse.iter().enumerate() {
        for earlier in &with_impulse[..number] {
            let linear = without_impulse(&earlier.linear, &later.linear);
            found.extend(linear.map(|linear| later.with(linear)));
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
        found.extend(multiplied_out((place, which, equation), [letter, other], lines, prepared));
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
                found.push(Substituted { whole, bracket, is_stated, is_lost: false });
            }
        }
    }
    found
}

/// The ways to take an equation with one unknown for one in which what was said of the other has been multiplied out.
fn multiplied_out(
    (place, which, (left, right)): (usize, usize, &(Expr, Expr)),
    [letter, other]: [&String; 2],
    lines: &[Studied],
    prepared: &Prepared,
) -> Vec<Substituted> {
    let terms = |side: &Expr| match side {
        Expr::Sum(terms) => terms.clone(),
        one => vec![one.clone()],
    };
    let all: Vec<Expr> = terms(left).into_iter().chain(terms(right).into_iter().map(Expr::negated)).collect();
    let linear = |expr: &Expr| differences(&(expr.clone(), Expr::integer(0)), prepared);
    if all.len() < 4 {
        return Vec::new();
    }
    // `w = v + 1.5`, or `w - v = 1.5` of which that is left to the reader.
    let has = |equation: &(Expr, Expr), own: &String| {
        [&equation.0, &equation.1].iter().any(|side| side.names().iter().any(|name| name.text == *own))
    };
    let is_solved = |(left, right): &(Expr, Expr)| {
        let is_other = matches!(left, Expr::Name(name) if name.text == *other);
        is_other && right.names().iter().all(|name| name.text != *other)
    };
    let readings = lines[..=place].iter().flat_map(|studied| &studied.line.readings);
    let mut said: Vec<&(Expr, Expr)> = readings
        .flat_map(|reading| &reading.equations)
        .filter(|equation| has(equation, letter) && has(equation, other))
        .collect();
    said.sort_by_key(|equation| !is_solved(equation));
    said.truncate(MOST_SAID);
    if said.is_empty() {
        return Vec::new();
    }
    let Some(terms) = all.iter().map(linear).collect::<Option<Vec<_>>>() else { return Vec::new() };
    let put = said.into_iter().flat_map(|said| {
        let solved = differences(said, prepared).and_then(|both| solved_for(both, other));
        let back = |lost: Option<f64>| {
            let all = solved.as_ref().map(|said| put_back(&terms, said, [letter, other], lost)).unwrap_or_default();
            all.into_iter().map(move |linear| (linear, lost.is_some()))
        };
        let ways = [None, Some(1.0), Some(-1.0)].map(back);
        ways.into_iter().flatten().filter_map(move |(linear, is_lost)| {
            let bracket = Offered::of(place, which, said, prepared)?;
            let whole = bracket.with(linear);
            let is_open = whole.is_of_velocities() && whole.linear[0].unknowns.len() == 2;
            is_open.then_some(Substituted { whole, bracket, is_stated: true, is_lost })
        })
    });
    put.collect()
}

/// So many equations with both unknowns are tried for what has been put into another.
const MOST_SAID: usize = 3;

/// What an equation, all on one side, says of an unknown, at every point.
fn solved_for(both: Vec<Linear>, unknown: &str) -> Option<Vec<Linear>> {
    let at = |mut whole: Linear| {
        let below = whole.before(unknown);
        whole.unknowns.retain(|(name, _)| name != unknown);
        Some(whole.times(Spread::exactly(-1.0).over(below)?))
    };
    both.into_iter().map(at).collect()
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
                let values = prepared.sizes_of(&member.expr);
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

/// Is it `v = 3` or `3 = v`?
pub(in crate::mark::working) fn is_value((left, right): &(Expr, Expr)) -> bool {
    let is_letter = |expr: &Expr| matches!(expr, Expr::Name(_));
    (is_letter(left) && right.names().is_empty()) || (is_letter(right) && left.names().is_empty())
}

/// Pairs of unknowns that stand together in an equation, the most frequent first; else those that usually do.
fn pairs(offered: &[Offered], lines: &[Studied]) -> Vec<Vec<String>> {
    let mut counted: Vec<(Vec<String>, usize)> = Vec::new();
    for offered in offered {
        let mut names: Vec<String> = offered.linear[0].unknowns.iter().map(|(name, _)| name.clone()).collect();
        // By custom w is of *B*, whatever the other is called.
        names.sort_by_key(|name| (matches!(name.as_str(), "w" | "W"), name.clone()));
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
