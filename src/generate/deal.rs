//! Variants dealt one after another, none twice, until there are no more.

use std::collections::HashSet;

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
    /// The sets that are fit, where they are known.
    fit: Option<HashSet<u64>>,
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
        Deal::by(Sieve::new(question, style), seed, None)
    }

    /// The same deal where it is known which sets of numbers are fit: no other is solved.
    pub fn knowing(question: &'q Question, style: &'q Style, seed: u64, fit: impl Iterator<Item = u64>) -> Deal<'q> {
        Deal::by(Sieve::for_one(question, style), seed, Some(fit.collect()))
    }

    fn by(sieve: Sieve<'q>, seed: u64, fit: Option<HashSet<u64>>) -> Deal<'q> {
        let order = Shuffle::new(sieve.style.size(), seed, &sieve.question.id, sieve.style.name.name());
        Deal { sieve, order, fit, examined: 0, dealt: 0, end: None }
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
            if self.fit.as_ref().is_some_and(|fit| !fit.contains(&index)) {
                continue;
            }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;

    #[test]
    fn whoever_knows_what_is_fit_deals_the_same() {
        let id = "walls/velocity-in-i-and-j";
        let (_, text) = shipped().find(|(shipped, _)| *shipped == id).unwrap();
        let question = read_question(id, &Source::new(id, text)).unwrap_or_else(|_| panic!("{id}"));
        for style in &question.styles {
            let dealt: Vec<u64> = Deal::new(&question, style, 1).filter_map(|variant| variant.index).collect();
            let known = Deal::knowing(&question, style, 1, dealt.iter().rev().copied());
            assert_eq!(known.filter_map(|variant| variant.index).collect::<Vec<_>>(), dealt);
            assert!(dealt.len() > 1);
        }
    }
}
