//! Derivations that have been planned, remembered: all variants of a question have one.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

use foldhash::fast::FixedState;

use super::Quantity;
use super::again::Order;
use super::derivation::{Derivation, Road};
use super::law::Rule;

/// How many plans are remembered at once.
const MOST_PLANS: usize = 1 << 11;

/// A derivation, with what follows from its steps alone, whatever the numbers are.
#[derive(Debug)]
pub(super) struct Plan {
    pub(super) derivation: Derivation,
    /// What was asked and does not follow.
    pub(super) missing: Vec<Quantity>,
    /// Worked out when it is first carried out to be carried out again.
    order: OnceLock<Arc<Order>>,
}

/// Enters all on which a plan depends as a row of numbers, which can be looked up without being copied. A rule stands at
/// one address as long as the program runs.
fn enter(
    road: Road,
    given: impl Iterator<Item = (Quantity, usize)>,
    asked: &[Quantity],
    banned: &[&'static Rule],
    row: &mut Vec<usize>,
) {
    row.clear();
    row.extend([road as usize, asked.len(), banned.len()]);
    row.extend(asked.iter().copied().map(Quantity::place));
    row.extend(banned.iter().map(|rule| std::ptr::from_ref(*rule).addr()));
    row.extend(given.map(|(_, place)| place));
}

impl Plan {
    /// The cheapest plan on a road to those asked quantities that follow from the given ones, each with its place, without the
    /// banned rules.
    pub(super) fn on(
        road: Road,
        given: impl Iterator<Item = (Quantity, usize)> + Clone,
        asked: &[Quantity],
        banned: &[&'static Rule],
    ) -> Arc<Plan> {
        #[derive(Default)]
        struct Plans {
            known: HashMap<Vec<usize>, Arc<Plan>, FixedState>,
            /// Room for the row that is looked up.
            row: Vec<usize>,
        }
        thread_local!(static PLANS: RefCell<Plans> = RefCell::default());
        PLANS.with_borrow_mut(|Plans { known, row }| {
            enter(road, given.clone(), asked, banned, row);
            if let Some(plan) = known.get(row.as_slice()) {
                return plan.clone();
            }
            // A stream of scenes of all kinds must not fill the memory.
            if known.len() >= MOST_PLANS {
                known.clear();
            }
            let (derivation, missing) =
                Derivation::planned(road, &given.map(|(quantity, _)| quantity).collect(), asked, banned);
            let plan = Arc::new(Plan { derivation, missing, order: OnceLock::new() });
            known.insert(row.clone(), plan.clone());
            plan
        })
    }

    /// In what order its steps and quantities depend on each other, given what it was planned from and for.
    pub(super) fn order(&self, given: impl Iterator<Item = Quantity>, asked: &[Quantity]) -> Arc<Order> {
        self.order.get_or_init(|| Arc::new(Order::of(&self.derivation, given, asked))).clone()
    }
}
