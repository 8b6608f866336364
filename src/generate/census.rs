//! All sets of numbers of a style examined, and how many each requirement turns away.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use super::variant::{Unfit, Variant, examine};
use crate::bank::{Question, Style};

/// What became of every set of numbers of a question in a style.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Census {
    /// How many sets there are.
    pub size: u64,
    /// How many are fit for print.
    pub fit: u64,
    /// How many each reason turned away, in the order in which reasons are examined.
    pub unfit: BTreeMap<Unfit, u64>,
}

impl Census {
    /// The funnel: each reason in words and how many sets it turned away.
    pub fn funnel(&self, question: &Question, style: &Style) -> Vec<(String, u64)> {
        self.unfit.iter().map(|(reason, count)| (in_words(reason, question, style), *count)).collect()
    }
}

fn in_words(reason: &Unfit, question: &Question, style: &Style) -> String {
    let requirement = |place: &usize| style.require.get(*place).map_or("", |requirement| requirement.text.as_str());
    match reason {
        Unfit::Givens(place) | Unfit::Results(place) => format!("not `{}`", requirement(place)),
        Unfit::NoValue => "a formula has no value".to_owned(),
        Unfit::Impossible => "cannot happen".to_owned(),
        Unfit::Underdetermined => "something is left open".to_owned(),
        Unfit::BeyondMethods => "beyond exam methods".to_owned(),
        Unfit::Tie(place) => {
            let find = question.parts.iter().flat_map(|part| &part.answers).nth(*place);
            let names = find.map_or(Vec::new(), |answer| answer.find.quantities());
            let names: Vec<String> = names.iter().map(|quantity| format!("`{quantity}`")).collect();
            format!("{} too near a tie to be rounded", names.join(", "))
        }
    }
}

/// How many sets a thread takes at a time.
const PORTION: u64 = 64;

/// Examines every set of numbers of a style, on all processors.
///
/// `visit` sees every variant that is fit, in no particular order, and `progress` is told now and then how many
/// sets have been examined.
pub fn enumerate(
    question: &Question,
    style: &Style,
    visit: &(dyn Fn(Variant) + Sync),
    progress: &(dyn Fn(u64) + Sync),
) -> Census {
    let size = style.size();
    let next = AtomicU64::new(0);
    let worker = || {
        let mut census = Census { size, ..Census::default() };
        loop {
            let from = next.fetch_add(PORTION, Ordering::Relaxed);
            if from >= size {
                return census;
            }
            for index in from..size.min(from.saturating_add(PORTION)) {
                match examine(question, style, index) {
                    Ok(variant) => {
                        census.fit += 1;
                        visit(variant);
                    }
                    Err(reason) => *census.unfit.entry(reason).or_default() += 1,
                }
            }
            progress(size.min(from.saturating_add(PORTION)));
        }
    };
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    let mut total = Census { size, ..Census::default() };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(worker)).collect();
        for worker in workers {
            // A panic in a worker is a bug in carom and is passed on as it is.
            let census = worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            total.fit += census.fit;
            for (reason, count) in census.unfit {
                *total.unfit.entry(reason).or_default() += count;
            }
        }
    });
    total
}
