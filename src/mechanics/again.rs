//! A derivation carried out, and carried out again where something goes another way: with slips, or from a value of the
//! student's own. Only what depends on that is worked out again.

use std::sync::Arc;

use super::derivation::{Derivation, Road};
use super::law::{Datum, Known, Outcome};
use super::plan::Plan;
use super::{Law, Quantities, Quantity, Rule, Slip};
use crate::number::Number;

/// A derivation with all that it gave.
#[derive(Clone, Debug)]
pub struct Carried<N> {
    plan: Arc<Plan>,
    order: Arc<Order>,
    known: Known<N>,
    /// Room for what is put back, each with the place of its quantity among all quantities.
    before: Vec<(Quantity, usize, Option<Datum<N>>)>,
}

/// A slip that is made in the place of the law that owns it.
#[derive(Clone, Copy, Debug)]
pub struct MadeSlip<'s> {
    law: Law,
    slip: &'s Slip,
    impact: Option<u8>,
}

impl<'s> MadeSlip<'s> {
    /// At every impact.
    pub fn everywhere((law, slip): (Law, &'s Slip)) -> MadeSlip<'s> {
        MadeSlip { law, slip, impact: None }
    }

    /// At the impact with this number alone.
    pub fn at((law, slip): (Law, &'s Slip), impact: u8) -> MadeSlip<'s> {
        MadeSlip { law, slip, impact: Some(impact) }
    }

    /// May it take the place of the law at this step?
    fn is_at(&self, step: &Rule) -> bool {
        let is_law = self.law == step.law || self.slip.also.contains(&step.law);
        is_law && self.impact.is_none_or(|impact| impact == step.impact())
    }
}

/// Which steps of a derivation depend on which quantities, whatever the numbers are.
#[derive(Debug)]
pub(super) struct Order {
    /// All that is known, each with a place of its own.
    places: Quantities<usize>,
    /// What each step needs.
    needs: Vec<Set>,
    /// Of what each step gives the places, where it is entered: not what was given, or what an earlier step gave. First that
    /// among all that is known here, then that among all quantities.
    gives: Vec<Vec<Option<(usize, usize)>>>,
    /// All that some step gives and that another needs, or that was asked.
    of_use: Set,
    /// At which steps each slip, by its place, may take the place of the law.
    slips: Vec<Set>,
}

/// A set of steps or of quantities, by their places. Of so many that they do not fit the last share a place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Set(u128);

impl Set {
    fn with(self, place: usize) -> Set {
        Set(self.0 | 1 << place.min(127))
    }

    fn has(self, place: usize) -> bool {
        self.0 >> place.min(127) & 1 == 1
    }

    fn or(self, other: Set) -> Set {
        Set(self.0 | other.0)
    }

    fn meets(self, other: Set) -> bool {
        self.0 & other.0 != 0
    }
}

/// A set of steps, by their places in the derivation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steps(Set);

impl Steps {
    /// Every step there is.
    pub const ALL: Steps = Steps(Set(u128::MAX));

    /// Is the step in the set?
    pub fn has(self, place: usize) -> bool {
        self.0.has(place)
    }

    /// Is there no step in it?
    pub fn is_empty(self) -> bool {
        self == Steps::default()
    }

    /// The steps of both.
    pub fn and(self, other: Steps) -> Steps {
        Steps(self.0.or(other.0))
    }

    /// Do the two have a step in common?
    pub fn meets(self, other: Steps) -> bool {
        self.0.meets(other.0)
    }
}

/// What became of the steps when the derivation was carried out again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// The steps at which a slip took the place of the law.
    pub slipped: Steps,
    /// The steps that had something else to start from.
    pub affected: Steps,
    /// What has another value.
    changed: Set,
}

impl Order {
    /// Of a derivation from what is given to what is asked.
    pub(super) fn of(derivation: &Derivation, given: impl Iterator<Item = Quantity>, asked: &[Quantity]) -> Order {
        let mut places: Quantities<usize> = Quantities::default();
        for quantity in given {
            places.insert(quantity, places.len());
        }
        let mut gives = Vec::new();
        for step in &derivation.steps {
            let mut new = |quantity: &Quantity| {
                let place = places.len();
                let is_new = !places.contains_key(quantity);
                places.insert_new(*quantity, place);
                is_new.then_some((place, quantity.place()))
            };
            gives.push(step.gives.iter().map(&mut new).collect());
        }
        let place_of = |quantity: &Quantity| places.get(quantity).copied();
        let all = |needs: &[Quantity]| needs.iter().filter_map(place_of).fold(Set::default(), Set::with);
        let needs = derivation.steps.iter().map(|step| all(&step.needs)).collect();
        let given = derivation.steps.iter().fold(Set::default(), |given, step| given.or(all(&step.gives)));
        let needed = derivation.steps.iter().fold(all(asked), |needed, step| needed.or(all(&step.needs)));
        let of_use = Set(given.0 & needed.0);
        let mut slips = vec![Set::default(); 1 + Slip::all().last().map_or(0, |(_, last)| usize::from(last.place))];
        for owned in Slip::all() {
            let made = MadeSlip::everywhere(*owned);
            let steps = derivation.steps.iter().enumerate().filter(|(_, step)| made.is_at(step));
            slips[usize::from(owned.1.place)] = steps.fold(Set::default(), |at, (step, _)| at.with(step));
        }
        Order { places, needs, gives, of_use, slips }
    }

    /// The steps at which a slip may take the place of the law.
    fn at(&self, slip: &Slip) -> Set {
        self.slips[usize::from(slip.place)]
    }
}

impl<N: Number + PartialEq> Carried<N> {
    /// Carries out the derivation of what is asked on a road, as far as there is one.
    pub fn on(road: Road, given: &Known<N>, asked: &[Quantity]) -> Carried<N> {
        let mut known = given.clone();
        let plan = Derivation::carry_out_by(road, &mut known, &Known::default(), asked);
        let order = plan.order(given.0.keys().copied(), asked);
        Carried { plan, order, known, before: Vec::new() }
    }

    /// Is this the derivation that a road leads to?
    pub fn is_of(&self, road: Road, given: &Known<N>, asked: &[Quantity]) -> bool {
        let steps = &Plan::on(road, given.0.placed_as_entered(), asked, &[]).derivation.steps;
        // A rule stands at one place as long as the program runs.
        let is_one = |(one, other): (&&Rule, &&Rule)| std::ptr::eq(*one, *other);
        steps.len() == self.plan.derivation.steps.len() && steps.iter().zip(&self.plan.derivation.steps).all(is_one)
    }

    /// The steps.
    pub fn derivation(&self) -> &Derivation {
        &self.plan.derivation
    }

    /// All that is known.
    pub fn known(&self) -> &Known<N> {
        &self.known
    }

    /// What was asked and does not follow.
    pub fn missing(&self) -> &[Quantity] {
        &self.plan.missing
    }

    /// The laws of the derivation, each once.
    pub fn laws(&self) -> Vec<Law> {
        let mut laws: Vec<Law> = self.plan.derivation.steps.iter().map(|step| step.law).collect();
        laws.sort();
        laws.dedup();
        laws
    }

    /// Has the quantity another value than before?
    pub fn is_changed(&self, quantity: Quantity, trace: Trace) -> bool {
        self.order.places.get(&quantity).is_some_and(|place| trace.changed.has(*place))
    }

    /// Has anything that a step gives another value than before? Not what nobody needs.
    pub fn is_anything_changed(&self, trace: Trace) -> bool {
        self.order.of_use.meets(trace.changed)
    }

    /// May a slip take the place of a law at some step?
    pub fn has_law_of(&self, slip: &Slip) -> bool {
        self.order.at(slip) != Set::default()
    }

    /// The impacts at which it has a law that the slip may take the place of, each once.
    pub fn impacts_of(&self, owned: (Law, &Slip)) -> Vec<u8> {
        let made = MadeSlip::everywhere(owned);
        let steps = self.plan.derivation.steps.iter().filter(|step| made.is_at(step));
        let mut impacts: Vec<u8> = steps.map(|step| step.impact()).collect();
        impacts.sort_unstable();
        impacts.dedup();
        impacts
    }

    /// The steps that lead to some quantities.
    pub fn steps_to(&self, quantities: &[Quantity]) -> Steps {
        let places = quantities.iter().filter_map(|quantity| self.order.places.get(quantity));
        let mut needed = places.fold(Set::default(), |needed, place| needed.with(*place));
        let mut steps = Set::default();
        for (step, gives) in self.order.gives.iter().enumerate().rev() {
            if gives.iter().flatten().any(|(entered, _)| needed.has(*entered)) {
                steps = steps.with(step);
                needed = needed.or(self.order.needs[step]);
            }
        }
        Steps(steps)
    }

    /// Carries it out again with slips, and with other data in place of what was found or
    /// given; looks at what is known then, and puts everything back. What has no result any more, as the direction of a sphere
    /// that is brought to rest, is not known then.
    pub fn again<R>(
        &mut self,
        slips: &[MadeSlip],
        other: &[(Quantity, Datum<N>)],
        look: impl FnOnce(&Carried<N>, Trace) -> R,
    ) -> R {
        self.again_by(Steps::ALL, slips, other, look)
    }

    /// The same by some of the steps alone: what the others give stays as it was.
    pub fn again_by<R>(
        &mut self,
        steps: Steps,
        slips: &[MadeSlip],
        other: &[(Quantity, Datum<N>)],
        look: impl FnOnce(&Carried<N>, Trace) -> R,
    ) -> R {
        let mut before = std::mem::take(&mut self.before);
        let mut trace = Trace::default();
        for (quantity, datum) in other {
            let place = quantity.place();
            before.push((*quantity, place, self.known.0.insert_at(place, *quantity, datum.clone())));
            trace.changed = self.order.places.get(quantity).map_or(trace.changed, |place| trace.changed.with(*place));
        }
        let kept = trace.changed;
        let of_slips = slips.iter().fold(Set::default(), |all, made| all.or(self.order.at(made.slip)));
        for (place, step) in self.plan.derivation.steps.iter().enumerate() {
            let is_affected = self.order.needs[place].meets(trace.changed);
            if !(is_affected || of_slips.has(place)) || !steps.has(place) {
                continue;
            }
            let mut tried = slips.iter().filter(|made| made.is_at(step));
            let slipped: Outcome<N> = tried.find_map(|made| step.slipped(made.slip.tag, &self.known));
            if slipped.is_some() {
                trace.slipped = Steps(trace.slipped.0.with(place));
            }
            if is_affected {
                trace.affected = Steps(trace.affected.0.with(place));
            } else if slipped.is_none() {
                continue;
            }
            let found = slipped.or_else(|| step.evaluate(&self.known));
            let mut found = found.unwrap_or_default().into_iter();
            for (quantity, entered) in step.gives.iter().zip(&self.order.gives[place]) {
                let datum = found.next();
                let Some((entered, place)) = entered.filter(|(entered, _)| !kept.has(*entered)) else { continue };
                let old = match (self.known.0.at_mut(place), datum) {
                    (Some(old), Some(datum)) if *old != datum => Some(std::mem::replace(old, datum)),
                    (Some(_), None) => self.known.0.remove_at(place),
                    (None, Some(datum)) => self.known.0.insert_at(place, *quantity, datum),
                    _ => continue,
                };
                before.push((*quantity, place, old));
                trace.changed = trace.changed.with(entered);
            }
        }
        let seen = look(self, trace);
        for (quantity, place, old) in before.drain(..).rev() {
            match old {
                Some(datum) => self.known.0.insert_at(place, quantity, datum),
                None => self.known.0.remove_at(place),
            };
        }
        self.before = before;
        seen
    }

    /// Of each step after slips: would its method mark and its accuracy mark be given? `lost` are the steps whose method
    /// is not condoned; with it goes that of solving the equations they spoilt.
    pub fn marks(&self, trace: Trace, lost: Steps) -> Vec<(bool, bool)> {
        let mut spoilt: Vec<Quantity> = Vec::new();
        let mut marks = Vec::new();
        for (place, step) in self.plan.derivation.steps.iter().enumerate() {
            let method = !lost.has(place) && !step.needs.iter().any(|need| spoilt.contains(need));
            if !method {
                spoilt.extend(step.gives.iter().filter(|quantity| quantity.is_equation()));
            }
            marks.push((method, !trace.slipped.has(place) && !trace.affected.has(place)));
        }
        marks
    }
}
