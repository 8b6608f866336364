//! Variants dealt one after another, none twice, until there are no more.

use super::numbers::{Further, Numbers};
use super::shuffle::Shuffle;
use super::sieve::Sieve;
use super::variant::Variant;
use crate::bank::{Question, Style};

/// So many sets of numbers in a row that are unfit, and the deal is given up.
///
/// A bank whose every style has been enumerated never comes near it; a style whose requirements nothing
/// meets would else keep a teacher waiting for ever.
pub const PATIENCE: u64 = 100_000;

/// The variants of a question in a style, in the order that a seed decides.
///
/// Only what is dealt is examined, so the first variants come at once from however large a set.
pub struct Deal<'q> {
    sieve: Sieve<'q>,
    order: Shuffle,
    examined: u64,
    dealt: u64,
    end: Option<End>,
}

/// Why no more variants come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every set of numbers has been dealt or was unfit.
    Exhausted,
    /// Very many in a row were unfit: see [`PATIENCE`].
    GaveUp,
}

impl<'q> Deal<'q> {
    /// Begins a deal.
    pub fn new(question: &'q Question, style: &'q Style, seed: u64) -> Deal<'q> {
        let order = Shuffle::new(style.size(), seed, &question.id, style.name.name());
        Deal { sieve: Sieve::new(question, style), order, examined: 0, dealt: 0, end: None }
    }

    /// How many sets of numbers have been examined so far.
    pub fn examined(&self) -> u64 {
        self.examined
    }

    /// How many variants have been dealt so far.
    pub fn dealt(&self) -> u64 {
        self.dealt
    }

    /// Why no more come; `None` while more may.
    pub fn end(&self) -> Option<End> {
        self.end
    }
}

impl Iterator for Deal<'_> {
    type Item = Variant;

    fn next(&mut self) -> Option<Variant> {
        if self.end.is_some() {
            return None;
        }
        for _ in 0..PATIENCE {
            let Some(index) = self.order.next() else {
                self.end = Some(End::Exhausted);
                return None;
            };
            self.examined += 1;
            let examined = Numbers::new(&self.sieve, index).examine(&self.sieve, Further::Never);
            if let Ok(variant) = examined {
                self.dealt += 1;
                return Some(variant);
            }
        }
        self.end = Some(End::GaveUp);
        None
    }
}
