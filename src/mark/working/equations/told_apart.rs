//! Momentum told from restitution: an equation is one of the two, and which of them is seen from all of them together.

use super::departure::Departure;
use super::pair::{BOTH, Matched};
use crate::mechanics::Quantity;

/// What an equation may be.
#[derive(Clone)]
pub(super) struct Found {
    /// The place of its line, and which of the readings of that.
    pub(super) place: usize,
    pub(super) which: usize,
    /// Which of the equations it is, where that is one law alone; in some there is a bracket with the other.
    pub(super) alone: Option<usize>,
    pub(super) matched: Matched,
    /// Is it restitution with a mass in it? Nobody puts one there.
    pub(super) has_needless_mass: bool,
}

impl Found {
    /// How unlikely it is to be meant.
    pub(in crate::mark::working) fn weight(&self) -> u32 {
        let needless = if self.has_needless_mass { NEEDLESS } else { 0 };
        let unlikely = if self.which > 0 { UNLIKELY } else { 0 };
        self.matched.weight() + needless + unlikely
    }
}

/// What a mass in the law of restitution costs.
const NEEDLESS: u32 = 3;

/// What a reading costs that is not the likeliest: more than a wrong sign. `2/3(4/3 - 5/3)` is two thirds of the bracket, and
/// wrong, though two over three times the bracket be right.
const UNLIKELY: u32 = 4;

/// What it costs if neither of the two laws is as it should be.
const NONE_EXACT: u32 = 2;

/// What a law costs of which there is no line: more than any line.
const MISSING: u32 = 20;

/// Each equation as one law: of the two that it may be that which leaves the best line for the other.
pub(super) fn told_apart(found: Vec<Found>) -> Vec<Found> {
    let chosen = best(&found).1;
    let is_chosen = |place: usize| chosen.contains(&Some(place));
    // What is written once more is what it was.
    let is_again = |one: &Found| chosen.iter().flatten().any(|place| found[*place].matched == one.matched);
    let keeps = |(place, one): (usize, &Found)| {
        let is_same = |(_, other): &(usize, &Found)| one.alone.is_some() && other.alone == one.alone;
        let rivals = || found.iter().enumerate().filter(is_same).filter(|(other, _)| *other != place);
        is_chosen(place)
            || rivals().all(|(other, rival)| {
                !is_chosen(other)
                    && (is_again(one) || !is_again(rival) && (one.weight(), place) <= (rival.weight(), other))
            })
    };
    found.iter().enumerate().filter(|(place, one)| keeps((*place, one))).map(|(_, one)| one.clone()).collect()
}

/// Without one velocity for both spheres where another line is momentum with one for each: `7v = 9` is what comes of `15 = 4v + 3w`.
/// With masses that are exchanged it comes of it as well, where restitution stands there for two velocities.
pub(super) fn without_one_for_both(mut found: Vec<Found>) -> Vec<Found> {
    let coalesced = [Departure::Coalesced];
    let is_together = |one: &Found| one.alone.is_none() && one.matched.departures == coalesced;
    let together: Vec<usize> = found.iter().filter(|one| is_together(one)).map(|one| one.place).collect();
    let is_apart = |one: &&Found| !together.contains(&one.place);
    let is_of = |one: &Found, law: Quantity| one.matched.equation == law;
    let is_restitution = |one: &Found| {
        is_of(one, Quantity::RestitutionEquation) && !one.matched.departures.contains(&Departure::Coalesced)
    };
    let parts_them = found.iter().filter(is_apart).any(is_restitution);
    let is_momentum = |one: &Found| is_of(one, Quantity::MomentumEquation) && (parts_them || one.matched.is_method());
    if !together.is_empty() && found.iter().filter(is_apart).any(is_momentum) {
        found.retain(|one| one.alone.is_some() || !together.contains(&one.place));
    }
    found
}

/// What the best line of each law is short of.
pub(in crate::mark::working) fn weight(found: &[Found]) -> u32 {
    best(found).0
}

/// The same of the lines that are one law alone, where both laws have such: what comes of putting one into the other may come
/// out right of wrong letters too.
pub(in crate::mark::working) fn weight_of_stated(found: &[Found]) -> u32 {
    let stated: Vec<Found> = found.iter().filter(|one| one.alone.is_some()).cloned().collect();
    let has = |law| stated.iter().any(|one| one.matched.equation == law);
    if BOTH.into_iter().all(has) { weight(&stated) } else { weight(found) }
}

/// The equations that are the two laws with the least change, and what that is.
fn best(found: &[Found]) -> (u32, [Option<usize>; 2]) {
    let [momentum, restitution] = BOTH.map(|equation| {
        let of_law = (0..found.len()).filter(move |place| found[*place].matched.equation == equation);
        std::iter::once(None).chain(of_law.map(Some))
    });
    let cost = |place: Option<usize>| place.map_or(MISSING, |place| found[place].weight());
    let both = momentum.flat_map(|one| restitution.clone().map(move |other| [one, other]));
    let are_two = |[one, other]: &[Option<usize>; 2]| match (one, other) {
        (Some(one), Some(other)) => {
            let (one, other) = (&found[*one], &found[*other]);
            // Nor is one line read in two ways both.
            let is_one_reading = one.place != other.place || one.which == other.which;
            is_one_reading && (one.alone.is_none() || one.alone != other.alone)
        }
        _ => true,
    };
    // Signs are to be consistent with the student's momentum: of two choices that cost the same, that which keeps it.
    let total = |[one, other]: [Option<usize>; 2]| {
        let neither = if cost(one) > 0 && cost(other) > 0 { NONE_EXACT } else { 0 };
        cost(one) + u32::from(cost(one) > 0) + cost(other) + neither
    };
    both.filter(are_two)
        .map(|pair| (total(pair), pair))
        .min_by_key(|(total, _)| *total)
        .unwrap_or((2 * MISSING, [None; 2]))
}
