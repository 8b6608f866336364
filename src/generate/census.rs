//! All sets of numbers of a style examined, and how many each requirement turns away.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use super::form::Form;
use super::variant::{Unfit, Variant, examine_further};
use crate::bank::{Question, Style};

/// What became of every set of numbers of a question in a style.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Census {
    /// How many sets there are.
    pub size: u64,
    /// How many of them have been examined: all, unless there are more than [`MOST_SETS`].
    pub examined: u64,
    /// How many are fit for print.
    pub fit: u64,
    /// How many each reason turned away, in the order in which reasons are examined.
    pub unfit: BTreeMap<Unfit, u64>,
    /// How many of these nothing else would have turned away.
    pub alone: BTreeMap<Unfit, u64>,
    /// The first set that each reason turned away.
    pub first: BTreeMap<Unfit, u64>,
    /// In how many variants each answer, in the order of the question, has which form.
    pub forms: Vec<BTreeMap<Form, u64>>,
}

/// The most sets of numbers of one style that are examined. Nobody waits for more; of a style that has more the first are.
pub const MOST_SETS: u64 = 500_000;

/// Out of how many sets something was counted: `144`, or `the first 500000 of 900000`.
pub fn out_of(examined: u64, size: u64) -> String {
    if examined < size { format!("the first {examined} of {size}") } else { size.to_string() }
}

impl Census {
    /// The funnel: each reason in words and how many sets it turned away.
    pub fn funnel(&self, question: &Question, style: &Style) -> Vec<(String, u64)> {
        self.unfit.iter().map(|(reason, count)| (in_words(reason, question, style), *count)).collect()
    }

    /// Counts one set.
    pub fn count(&mut self, question: &Question, index: u64, examined: &Result<Variant, (Unfit, bool)>) {
        self.examined += 1;
        match examined {
            Ok(variant) => {
                self.fit += 1;
                let answers = question.parts.iter().flat_map(|part| &part.answers);
                for (place, answer) in answers.enumerate() {
                    if self.forms.len() <= place {
                        self.forms.resize_with(place + 1, BTreeMap::new);
                    }
                    if let Some(form) = Form::of_answer(answer, &variant.solution) {
                        *self.forms[place].entry(form).or_default() += 1;
                    }
                }
            }
            Err((reason, is_alone)) => {
                *self.unfit.entry(reason.clone()).or_default() += 1;
                if *is_alone {
                    *self.alone.entry(reason.clone()).or_default() += 1;
                }
                let first = self.first.entry(reason.clone()).or_insert(index);
                *first = index.min(*first);
            }
        }
    }

    /// Adds what was counted of other sets of the same style.
    pub fn add(&mut self, other: Census) {
        self.examined += other.examined;
        self.fit += other.fit;
        add(&mut self.unfit, other.unfit);
        add(&mut self.alone, other.alone);
        for (reason, index) in other.first {
            let first = self.first.entry(reason).or_insert(index);
            *first = index.min(*first);
        }
        self.forms.resize_with(self.forms.len().max(other.forms.len()), BTreeMap::new);
        for (own, other) in self.forms.iter_mut().zip(other.forms) {
            add(own, other);
        }
    }
}

fn add<K: Ord>(own: &mut BTreeMap<K, u64>, other: BTreeMap<K, u64>) {
    for (key, count) in other {
        *own.entry(key).or_default() += count;
    }
}

impl Unfit {
    /// The place of the requirement that turned the set away, if one did.
    pub fn requirement(&self) -> Option<usize> {
        match self {
            Unfit::Givens(place) | Unfit::Results(place) => Some(*place),
            _ => None,
        }
    }
}

/// The requirement as it was written.
fn requirement(reason: &Unfit, style: &Style) -> String {
    let found = reason.requirement().and_then(|place| style.require.get(place));
    found.map_or_else(String::new, |requirement| requirement.text.clone())
}

fn in_words(reason: &Unfit, question: &Question, style: &Style) -> String {
    match reason {
        Unfit::Givens(_) | Unfit::Results(_) => format!("not `{}`", requirement(reason, style)),
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

/// Examines every set of numbers of a style, or the first [`MOST_SETS`], on all processors.
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
    let most = size.min(MOST_SETS);
    let next = AtomicU64::new(0);
    let worker = || {
        let mut census = Census { size, ..Census::default() };
        loop {
            let from = next.fetch_add(PORTION, Ordering::Relaxed);
            if from >= most {
                return census;
            }
            for index in from..most.min(from.saturating_add(PORTION)) {
                let examined = examine_further(question, style, index);
                census.count(question, index, &examined);
                if let Ok(variant) = examined {
                    visit(variant);
                }
            }
            progress(most.min(from.saturating_add(PORTION)));
        }
    };
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    let mut total = Census { size, ..Census::default() };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(worker)).collect();
        for worker in workers {
            // A panic in a worker is a bug in carom and is passed on as it is.
            total.add(worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
    });
    total
}
