//! The derivation: the short list of steps from what is given to what is asked.
//!
//! It is planned backwards from what is asked, by the least cost, so a step that nobody needs does
//! not exist; then it can be evaluated in any kind of number.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;

use smallvec::SmallVec;

use super::later::Meeting;
use super::law::{Datum, Known, Outcome, Rule, all_rules};
use super::plan::Plan;
use super::{Quantities, Quantity, Sphere};
use crate::number::Number;

/// Steps in the order in which a solution takes them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Derivation {
    /// Each step needs only what is given and what earlier steps gave.
    pub steps: Vec<&'static Rule>,
}

/// A step whose result does not exist for these numbers: its place in the derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DeadEnd(pub usize);

/// A way that students go to what is asked: a slip may show on one of them and not on another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Road {
    /// The fewest steps.
    Shortest,
    /// Kinetic energies from full speeds, before and after, and not from what changes alone.
    BySpeeds,
    /// The impulse from the sphere A.
    ByA,
}

impl Road {
    /// Every road, the shortest first.
    pub const ALL: [Road; 3] = [Road::Shortest, Road::BySpeeds, Road::ByA];

    fn avoids(self, rule: &Rule) -> bool {
        use Quantity::{Impulse, KineticEnergy, Mass, SphereEnergyGained, SphereEnergyLost, Velocity};
        let (gives, needs) = (rule.gives[0], &rule.needs);
        match self {
            Road::Shortest => false,
            Road::BySpeeds => {
                let from_components = || needs.iter().any(|need| matches!(need, Velocity(..)));
                matches!(gives, SphereEnergyLost(_) | SphereEnergyGained(_))
                    || (matches!(gives, KineticEnergy(..)) && from_components())
            }
            Road::ByA => matches!(gives, Impulse(Sphere::B, _)) && needs.contains(&Mass(Sphere::B)),
        }
    }
}

impl Derivation {
    /// The cheapest derivation of those asked quantities that follow from the given ones; and the asked quantities that do
    /// not follow.
    pub fn plan(given: &BTreeSet<Quantity>, asked: &[Quantity]) -> (Derivation, Vec<Quantity>) {
        let plan = Plan::on(Road::Shortest, given.iter().map(|quantity| (*quantity, quantity.place())), asked, &[]);
        (plan.derivation.clone(), plan.missing.clone())
    }

    /// The plan itself, made anew.
    pub(super) fn planned(
        road: Road,
        given: &BTreeSet<Quantity>,
        asked: &[Quantity],
        banned: &[&Rule],
    ) -> (Derivation, Vec<Quantity>) {
        let rules = all_rules(&Meeting::said(given));
        let mut best: Quantities<(u32, Option<usize>)> = given.iter().map(|quantity| (*quantity, (0, None))).collect();
        let mut changed = true;
        while changed {
            changed = false;
            for (index, rule) in rules.iter().enumerate() {
                let mut needs = rule.needs.iter();
                let sum = needs.try_fold(rule.cost, |sum, need| best.get(need).map(|(cost, _)| sum + cost));
                let Some(cost) = sum else { continue };
                for quantity in &rule.gives {
                    let better = best.get(quantity).is_none_or(|(known, _)| cost < *known);
                    if better && !road.avoids(rule) && !banned.contains(&rule) {
                        best.insert(*quantity, (cost, Some(index)));
                        changed = true;
                    }
                }
            }
        }
        let mut needed = BTreeSet::new();
        let mut open: Vec<Quantity> = asked.to_vec();
        while let Some(quantity) = open.pop() {
            if let Some((_, Some(index))) = best.get(&quantity)
                && needed.insert(*index)
            {
                open.extend(&rules[*index].needs);
            }
        }
        let missing = asked.iter().filter(|quantity| !best.contains_key(quantity)).copied().collect();
        (Derivation { steps: in_order(given, needed.into_iter().map(|index| &rules[index]).collect()) }, missing)
    }

    /// Adds what the steps give to what is known.
    ///
    /// # Errors
    ///
    /// The first step whose result does not exist; what earlier steps gave is known all the same.
    pub fn evaluate<N: Number>(&self, known: &mut Known<N>) -> Result<(), DeadEnd> {
        self.evaluate_with(&Known::default(), known)
    }

    /// The same, where some of the results have been computed already: a step that gives only such is taken, and its
    /// results are not computed again.
    ///
    /// # Errors
    ///
    /// As for [`Derivation::evaluate`].
    pub fn evaluate_with<N: Number>(&self, computed: &Known<N>, known: &mut Known<N>) -> Result<(), DeadEnd> {
        known.0.reserve(self.steps.iter().map(|step| step.gives.len()).sum());
        for (place, step) in self.steps.iter().enumerate() {
            let there: SmallVec<[&Datum<N>; 2]> =
                step.gives.iter().map_while(|quantity| computed.0.get(quantity)).collect();
            if there.len() == step.gives.len() {
                enter(step, there.into_iter().cloned(), known);
                continue;
            }
            let Some(found) = step.evaluate(known) else { return Err(DeadEnd(place)) };
            enter(step, found, known);
        }
        Ok(())
    }

    /// The same with slips, by their tags, wherever they apply: a slip may replace several steps.
    ///
    /// # Errors
    ///
    /// As for [`Derivation::evaluate`].
    pub fn evaluate_slipped<N: Number>(&self, slips: &[&str], known: &mut Known<N>) -> Result<(), DeadEnd> {
        for (place, step) in self.steps.iter().enumerate() {
            let slipped: Outcome<N> = slips.iter().find_map(|slip| step.slipped(slip, known));
            let Some(found) = slipped.or_else(|| step.evaluate(known)) else { return Err(DeadEnd(place)) };
            enter(step, found, known);
        }
        Ok(())
    }

    /// Derives more from what is given, the first so many entries of what is known. What was derived earlier stands after it; it
    /// is not derived again, and does not decide by which steps.
    pub fn carry_on<N: Number>(known: &mut Known<N>, given: usize, asked: &[Quantity]) {
        Derivation::carry_on_with(known, given, asked, &mut |_, _| {});
    }

    /// The same, where `otherwise` may add what a step would give before that is taken.
    pub fn carry_on_with<N: Number>(
        known: &mut Known<N>,
        given: usize,
        asked: &[Quantity],
        otherwise: &mut dyn FnMut(&Rule, &mut Known<N>),
    ) {
        let is_there = |step: &Rule, known: &Known<N>| step.gives.iter().all(|quantity| known.0.contains_key(quantity));
        let mut banned = Vec::new();
        loop {
            let plan = Plan::on(Road::Shortest, known.0.placed_as_entered().take(given), asked, &banned);
            let is_dead_end = |step: &&&'static Rule| {
                if !is_there(step, known) {
                    otherwise(step, known);
                }
                if is_there(step, known) {
                    return false;
                }
                let found = step.evaluate(known);
                let is_none = found.is_none();
                found.into_iter().for_each(|found| enter(step, found, known));
                is_none
            };
            let Some(step) = plan.derivation.steps.iter().find(is_dead_end) else { return };
            banned.push(*step);
        }
    }

    /// Plans and evaluates, going round steps whose results do not exist. Returns the derivation and
    /// the asked quantities that are not to be had.
    pub fn carry_out<N: Number>(known: &mut Known<N>, asked: &[Quantity]) -> (Derivation, Vec<Quantity>) {
        Derivation::carry_out_with(known, &Known::default(), asked)
    }

    /// The same, where some of the results have been computed already: see [`Derivation::evaluate_with`].
    pub fn carry_out_with<N: Number>(
        known: &mut Known<N>,
        computed: &Known<N>,
        asked: &[Quantity],
    ) -> (Derivation, Vec<Quantity>) {
        let plan = Derivation::carry_out_by(Road::Shortest, known, computed, asked);
        (plan.derivation.clone(), plan.missing.clone())
    }

    /// The same on a road, with all that is remembered of the plan.
    pub(super) fn carry_out_by<N: Number>(
        road: Road,
        known: &mut Known<N>,
        computed: &Known<N>,
        asked: &[Quantity],
    ) -> Arc<Plan> {
        // What is found is entered after it.
        let given = known.0.len();
        let mut banned = Vec::new();
        // A step before a dead end stays what it is on the way round it, and is not taken twice.
        let mut computed = Cow::Borrowed(computed);
        loop {
            let plan = Plan::on(road, known.0.placed_as_entered().take(given), asked, &banned);
            let Err(DeadEnd(place)) = plan.derivation.evaluate_with(&computed, known) else { return plan };
            banned.push(plan.derivation.steps[place]);
            let there = computed.to_mut();
            for (place, (quantity, datum)) in std::mem::take(&mut known.0).into_pairs().enumerate() {
                if place < given {
                    known.0.insert(quantity, datum);
                } else {
                    there.0.insert_new(quantity, datum);
                }
            }
        }
    }
}

/// What a step gives is entered unless it is known already: a rule may give two things of which one is.
fn enter<N: Number>(step: &Rule, found: impl IntoIterator<Item = Datum<N>>, known: &mut Known<N>) {
    for (quantity, datum) in step.gives.iter().zip(found) {
        known.0.insert_new(*quantity, datum);
    }
}

/// Each step as soon as it can be taken, earlier laws of the list first.
fn in_order(given: &BTreeSet<Quantity>, mut rest: Vec<&'static Rule>) -> Vec<&'static Rule> {
    rest.sort_by_key(|rule| rule.law);
    let mut known = given.clone();
    let mut steps = Vec::new();
    while let Some(place) = rest.iter().position(|rule| rule.needs.iter().all(|need| known.contains(need))) {
        let rule = rest.remove(place);
        known.extend(&rule.gives);
        steps.push(rule);
    }
    steps
}
