//! Methods compared: speed against accuracy, and maps of where each arrangement of a formula fails.

mod chart;
mod claim;
mod double;
mod exam_grid;
mod impacts;
mod map;
mod quantities;
mod report;
mod times;
mod tolerance;
mod velocities;
mod work;

use crate::diagnostic::{Source, render_all};

pub use chart::*;
pub use claim::{Claim, Claims, CountClaim, claims, try_all};
pub use double::{BITS, Outcome, ROUNDOFF, fraction};
pub use exam_grid::{Bounds, Census, Count, SMALL, WHOLE, blocks, census, methods};
pub use impacts::{REGIMES, Regime};
pub use map::{Arrangement, Dealer, Map, Row, Subject};
pub use quantities::QUANTITIES;
pub use report::Study;
pub use times::{read_times, write_times};
pub use tolerance::{CHAINS, Chain, Spread, spread};
pub use velocities::{Scale, mapped, ordinary_error, outcome, promised, regime, regime_map};
pub use work::{Cost, Effort, KINDS, Kind, costs, steps, work_of};

/// What a study is to do.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// How long to time.
    pub effort: Effort,
    /// Times of an earlier study, in place of new ones.
    pub times: Option<Vec<Cost>>,
    /// Times of other programs, beside new ones.
    pub peers: Vec<Cost>,
}

/// Scenes in each cell of a map, and for each chain of working: enough that more change no claim.
const SCENES: usize = 100;
const WORKINGS: usize = 1000;

/// How many steps a study reports.
pub fn length(plan: &Plan) -> u64 {
    let maps = QUANTITIES.len() + REGIMES.len();
    let timing = if plan.times.is_none() { steps(plan.effort) } else { 0 };
    maps as u64 + blocks(WHOLE) + 2 * CHAINS.len() as u64 + timing
}

/// Carries it out. `now` is a clock in nanoseconds, and `step` is called [`length`] times with what is going on.
///
/// # Errors
///
/// The reason, if the table of claims that is built in cannot be read.
pub fn run(plan: &Plan, now: &dyn Fn() -> u64, step: &mut dyn FnMut(&'static str)) -> Result<Study, String> {
    let claims = claims()?;
    let mut quantities = Vec::new();
    for subject in QUANTITIES {
        quantities.push(subject.map(SCENES));
        step("maps of quantities");
    }
    let mut velocities = Vec::new();
    for regime in REGIMES {
        velocities.push(regime_map(regime, SCENES));
        step("maps of velocities");
    }
    let census = census(WHOLE, &methods(), &mut || step("the exam grid"));
    let mut spreads = Vec::new();
    for chain in CHAINS {
        for figures in [3, 4] {
            spreads.push(spread(chain, figures, WORKINGS));
            step("rounding on the way");
        }
    }
    let costs = match &plan.times {
        Some(times) => times.clone(),
        None => {
            let mut costs = costs(plan.effort, now, &mut || step("times"));
            costs.extend(plan.peers.iter().cloned());
            // As the table has them, so that the charts are what the table draws.
            read_times(&Source::new("times.csv", write_times(&costs))).map_err(|faults| render_all(&faults, false))?
        }
    };
    let maps: Vec<Map> = quantities.iter().chain(&velocities).cloned().collect();
    let mut broken = try_all(&claims.claim, &maps);
    broken.extend(claims.count.iter().filter_map(|claim| claim.tried(&census)));
    Ok(Study { quantities, velocities, claims, broken, census, spreads, costs })
}
