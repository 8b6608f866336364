//! A derivation carried out, and carried out again where something goes another way: with slips, or from a value of the
//! student's own. Only what depends on that is worked out again.

use super::derivation::{Derivation, Road};
use super::law::{Datum, Known, Outcome};
use super::{Law, Quantity};
use crate::number::Number;

/// A derivation with all that it gave.
#[derive(Clone, Debug)]
pub struct Carried<N> {
    derivation: Derivation,
    known: Known<N>,
    /// Of what each step gives, what is entered: not what was given, or what an earlier step gave.
    entered: Vec<Vec<bool>>,
    missing: Vec<Quantity>,
}

/// A set of steps, by their places in the derivation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Steps(u128);

impl Steps {
    fn with(self, place: usize) -> Steps {
        // A derivation of all quantities together may be longer; its last steps are for none of them alone.
        Steps(self.0 | 1_u128.checked_shl(place as u32).unwrap_or(0))
    }

    /// Is the step in the set?
    pub fn has(self, place: usize) -> bool {
        self.0.checked_shr(place as u32).unwrap_or(0) & 1 == 1
    }

    /// Is there no step in it?
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The steps of both.
    pub fn and(self, other: Steps) -> Steps {
        Steps(self.0 | other.0)
    }

    /// Do the two have a step in common?
    pub fn meets(self, other: Steps) -> bool {
        self.0 & other.0 != 0
    }
}

/// What became of the steps when the derivation was carried out again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// The steps at which a slip took the place of the law.
    pub slipped: Steps,
    /// The steps that had something else to start from.
    pub affected: Steps,
}

impl<N: Number + PartialEq> Carried<N> {
    /// Carries out the derivation of what is asked on a road, as far as there is one.
    pub fn on(road: Road, given: &Known<N>, asked: &[Quantity]) -> Carried<N> {
        let mut known = given.clone();
        let (derivation, missing) = Derivation::carry_out_on(road, &mut known, asked);
        let mut there: Vec<Quantity> = given.0.keys().copied().collect();
        let entered = derivation.steps.iter().map(|step| {
            let new: Vec<bool> = step.gives.iter().map(|quantity| !there.contains(quantity)).collect();
            there.extend(&step.gives);
            new
        });
        let entered = entered.collect();
        Carried { derivation, known, entered, missing }
    }

    /// The steps.
    pub fn derivation(&self) -> &Derivation {
        &self.derivation
    }

    /// All that is known.
    pub fn known(&self) -> &Known<N> {
        &self.known
    }

    /// What was asked and does not follow.
    pub fn missing(&self) -> &[Quantity] {
        &self.missing
    }

    /// The laws of the derivation, each once.
    pub fn laws(&self) -> Vec<Law> {
        let mut laws: Vec<Law> = self.derivation.steps.iter().map(|step| step.law).collect();
        laws.sort();
        laws.dedup();
        laws
    }

    /// Carries it out again with slips, by their tags, and with other data in place of what was found or given; looks at
    /// what is known then, and puts everything back. `None` if a step has no result.
    pub fn again<R>(
        &mut self,
        slips: &[&str],
        other: &[(Quantity, Datum<N>)],
        look: impl FnOnce(&Known<N>, Trace) -> R,
    ) -> Option<R> {
        let mut before: Vec<(Quantity, Option<Datum<N>>)> = Vec::new();
        let mut trace = Trace::default();
        for (quantity, datum) in other {
            let old = self.known.0.insert(*quantity, datum.clone());
            before.push((*quantity, old));
        }
        let mut possible = true;
        for (place, step) in self.derivation.steps.iter().enumerate() {
            let slipped: Outcome<N> = slips.iter().find_map(|slip| step.slipped(slip, &self.known));
            let affected = step.needs.iter().any(|need| before.iter().any(|(changed, _)| changed == need));
            if slipped.is_some() {
                trace.slipped = trace.slipped.with(place);
            }
            if affected {
                trace.affected = trace.affected.with(place);
            } else if slipped.is_none() {
                continue;
            }
            let Some(found) = slipped.or_else(|| step.evaluate(&self.known)) else {
                possible = false;
                break;
            };
            for ((quantity, datum), entered) in step.gives.iter().zip(found).zip(&self.entered[place]) {
                let same = self.known.0.get(quantity) == Some(&datum);
                if *entered && !same && !other.iter().any(|(kept, _)| kept == quantity) {
                    let old = self.known.0.insert(*quantity, datum);
                    before.push((*quantity, old));
                }
            }
        }
        let seen = possible.then(|| look(&self.known, trace));
        for (quantity, old) in before.into_iter().rev() {
            match old {
                Some(datum) => self.known.0.insert(quantity, datum),
                None => self.known.0.remove(&quantity),
            };
        }
        seen
    }

    /// Of each step after slips: would its method mark and its accuracy mark be given? `lost` are the steps whose method
    /// is not condoned; with it goes that of solving the equations they spoilt.
    pub fn marks(&self, trace: Trace, lost: Steps) -> Vec<(bool, bool)> {
        let mut spoilt: Vec<Quantity> = Vec::new();
        let mut marks = Vec::new();
        for (place, step) in self.derivation.steps.iter().enumerate() {
            let method = !lost.has(place) && !step.needs.iter().any(|need| spoilt.contains(need));
            if !method {
                spoilt.extend(step.gives.iter().filter(|quantity| quantity.is_equation()));
            }
            marks.push((method, !trace.slipped.has(place) && !trace.affected.has(place)));
        }
        marks
    }
}
