//! What was seen of some sets of numbers of one style; the tallies of all threads are added up.

use std::collections::{BTreeMap, BTreeSet};

use super::finding::Finding;
use super::remark::{Remark, Weight, numbers};
use super::shows::Slips;
use super::{apart, promise, words};
use crate::bank::Style;
use crate::generate::{Census, Numbers, Sieve};
use crate::paper;

/// A remark in how many variants, and what the first of them shows.
#[derive(Clone, Debug)]
struct Seen {
    count: u64,
    first: u64,
    remark: Remark,
}

/// The count of some sets of a style.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Fit and unfit.
    pub census: Census,
    /// The sets that are fit, in any order.
    pub fit: Vec<u64>,
    /// Slips followed.
    pub slips: Slips,
    seen: BTreeMap<String, Seen>,
    heard: words::Heard,
}

impl Tally {
    /// Of nothing yet, of a style with so many sets.
    pub fn new(size: u64) -> Tally {
        Tally { census: Census::asking(size), ..Tally::default() }
    }

    /// Examines one set of numbers, and looks at it if it is fit for print in the sieve's style.
    pub fn examine(&mut self, sieve: &Sieve, numbers: &Numbers) {
        let Some(variant) = self.census.examine(sieve, numbers) else { return };
        self.fit.push(numbers.index);
        let (question, style) = (sieve.question, sieve.style);
        let mut remarks = Vec::new();
        let words = paper::words(question, style, &variant);
        words::of_variant(question, &variant, &words, &mut self.heard, &mut remarks);
        promise::broken(question, &variant, &words, &mut remarks);
        apart::alike(question, &variant, &mut remarks);
        apart::given(question, &variant, &words, &mut remarks);
        self.slips.follow(question, &variant);
        remarks.sort();
        remarks.dedup_by(|one, other| one.what == other.what);
        for remark in remarks {
            self.see(Seen { count: 1, first: numbers.index, remark });
        }
    }

    fn see(&mut self, seen: Seen) {
        match self.seen.get_mut(&seen.remark.what) {
            None => {
                self.seen.insert(seen.remark.what.clone(), seen);
            }
            Some(known) => {
                known.count += seen.count;
                if seen.first < known.first {
                    (known.first, known.remark) = (seen.first, seen.remark);
                }
            }
        }
    }

    /// Adds what was seen of other sets.
    pub fn add(&mut self, other: Tally) {
        self.census.add(other.census);
        self.fit.extend(other.fit);
        self.slips.add(other.slips);
        for seen in other.seen.into_values() {
            self.see(seen);
        }
    }

    /// What was seen amiss, each with the first variant that has it. What has a place in the words of the question is the
    /// same in every style, and told of the first.
    pub fn findings(&self, style: &Style, told: &mut BTreeSet<(String, String)>) -> Vec<Finding> {
        let found = |seen: &Seen| {
            let Remark { what, at, key, label, help, shown, weight, help_for_all } = &seen.remark;
            let is_in_all = seen.count == self.census.fit && !help_for_all.is_empty();
            let help = if is_in_all { *help_for_all } else { help.as_str() };
            let shown = if shown.is_empty() { String::new() } else { format!(": `{shown}`") };
            let message = format!(
                "{what}{shown}, in {} of {} variants of style `{}`, first with {}",
                seen.count,
                self.census.fit,
                style.name,
                numbers(style, seen.first)
            );
            let at = if at.is_empty() { format!("[style.{}]", style.name) } else { at.clone() };
            let found = Finding::new(message, at, label.as_str()).with_help(help);
            let found = key.iter().fold(found, |found, key| found.at_key(style.name, key));
            if *weight == Weight::Error { found } else { found.as_warning() }
        };
        // Nine in ten are nearly all.
        let is_told = |seen: &&Seen| {
            seen.remark.weight != Weight::InNearlyAll
                || seen.count.saturating_mul(10) >= self.census.fit.saturating_mul(9)
        };
        let is_new = |seen: &&Seen| {
            let Remark { what, at, .. } = &seen.remark;
            at.is_empty() || told.insert((what.clone(), at.clone()))
        };
        self.seen.values().filter(is_told).filter(is_new).map(found).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::shows;
    use super::*;
    use crate::bank::{Question, read_question, shipped};
    use crate::diagnostic::Source;

    /// What is said of a style's slips and variants after tallies were added up.
    fn said(question: &Question, style: &Style, tallies: impl Iterator<Item = Tally>) -> Vec<String> {
        let mut total = Tally::new(style.size());
        tallies.for_each(|tally| total.add(tally));
        let slips = [total.slips.clone()];
        let acting = shows::all_acting(question, &slips);
        let mut findings = total.findings(style, &mut BTreeSet::new());
        findings.extend(shows::findings(question, &slips, acting, &|_, index| numbers(style, index)));
        findings.into_iter().map(|finding| finding.message).collect()
    }

    #[test]
    fn what_is_found_does_not_depend_on_who_saw_what() {
        let id = "deflection/elastic";
        let (_, text) = shipped().find(|(shipped, _)| *shipped == id).unwrap();
        let question = read_question(id, &Source::new(id, text)).unwrap_or_else(|_| panic!("{id}"));
        for style in &question.styles {
            let sieve = Sieve::new(&question, style);
            let one = |index: u64| {
                let mut tally = Tally::new(style.size());
                tally.examine(&sieve, &Numbers::new(&sieve, index));
                tally
            };
            let in_order = said(&question, style, (0..style.size()).map(one));
            assert_eq!(said(&question, style, (0..style.size()).rev().map(one)), in_order);
            let mut together = Tally::new(style.size());
            (0..style.size()).for_each(|index| together.examine(&sieve, &Numbers::new(&sieve, index)));
            assert_eq!(said(&question, style, [together].into_iter()), in_order);
        }
    }
}
