//! What the givens of a style turn away, each requirement tried once for all sets of numbers that it cannot tell apart.
//!
//! `e != f` looks at two parameters of six, and most sets differ in the other four. So each requirement on givens has a
//! table, with an entry for every choice of values of those parameters on which it depends, and an entry is filled in when
//! the first set with these values comes along. The same is done for the question whether a derived name has a value.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Arc, OnceLock};

use super::numbers::Numbers;
use super::variant::Unfit;
use crate::bank::{GivenNames, Question, Requirement, Style};
use crate::expr::{Expr, Meaning, evaluate};
use crate::mechanics::Quantity;

/// A table with more entries is not made: it would be filled in hardly faster than it is looked up.
const MOST_ENTRIES: u64 = 1 << 16;

/// A style, ready for its sets of numbers to be examined; all threads may share it.
pub struct Sieve<'q> {
    /// The question.
    pub question: &'q Question,
    /// One of its styles.
    pub style: &'q Style,
    /// What must be solved for.
    pub(super) wanted: Vec<Quantity>,
    /// What the style gives.
    pub(super) names: Arc<GivenNames>,
    /// Has a name a value? Parameters, then derived names.
    named: Vec<(&'q str, Table)>,
    /// Does a requirement hold? None where it is on results.
    holds: Vec<Option<Table>>,
    /// The requirements on results, with their places and the quantities that they name.
    on_results: Vec<(usize, &'q Requirement, Vec<Quantity>)>,
    /// What the values of each parameter mean, worked out when they are first met; none where that depends on others.
    meanings: Vec<(Digit, Vec<OnceLock<Option<Meaning>>>)>,
}

impl<'q> Sieve<'q> {
    /// For many sets of numbers of a style.
    pub fn new(question: &'q Question, style: &'q Style) -> Sieve<'q> {
        Sieve::with_tables(question, style, MOST_ENTRIES)
    }

    /// For one set of numbers: nothing is remembered.
    pub fn for_one(question: &'q Question, style: &'q Style) -> Sieve<'q> {
        Sieve::with_tables(question, style, 0)
    }

    fn with_tables(question: &'q Question, style: &'q Style, most: u64) -> Sieve<'q> {
        let depends = Depends::new(style);
        let all = style.parameters.iter().map(|(name, _)| name).chain(style.lets.iter().map(|(name, _)| name));
        let named = all.map(|name| (name.as_str(), depends.table([name.as_str()], most))).collect();
        let is_given = |name: &str| question.is_given(style, name);
        let table = |requirement: &Requirement| {
            let on_results = requirement.is_on_results(&question.scene.unknowns, &is_given);
            let names = requirement.names().map(|name| name.text.as_str());
            (!on_results).then(|| depends.table(names, most))
        };
        let holds: Vec<Option<Table>> = style.require.iter().map(table).collect();
        let of_results = holds.iter().zip(&style.require).enumerate().filter(|(_, (table, _))| table.is_none());
        let on_results = of_results
            .map(|(place, (_, requirement))| (place, requirement, requirement.quantities(&is_given).collect()))
            .collect();
        let meanings = depends.digits.iter().zip(&style.parameters).map(|(digit, (_, domain))| {
            let is_kept = digit.size <= most && domain.formulas().iter().all(|formula| formula.names().is_empty());
            (*digit, (0..if is_kept { digit.size } else { 0 }).map(|_| OnceLock::new()).collect())
        });
        let (wanted, meanings) = (question.wanted(style), meanings.collect());
        let names = Arc::new(GivenNames::of(style, style.parameters.iter().map(|(name, _)| name), &question.scene));
        Sieve { question, style, wanted, names, named, holds, on_results, meanings }
    }

    /// Are the sets of another style the same, and solved for the same?
    pub fn has_sets_of(&self, other: &Sieve) -> bool {
        let (own, others) = (self.style, other.style);
        let same_wanted = self.wanted.len() == other.wanted.len()
            && self.wanted.iter().all(|quantity| other.wanted.contains(quantity));
        own.parameters == others.parameters && own.lets == others.lets && same_wanted
    }

    /// Has every name a value?
    pub(super) fn has_values(&self, numbers: &Numbers) -> bool {
        let mut are_all_known = true;
        for (_, table) in &self.named {
            match table.known(numbers.index) {
                Some(true) => {}
                Some(false) => return false,
                None => are_all_known = false,
            }
        }
        if are_all_known {
            return true;
        }
        match numbers.givens() {
            Ok(_) => self.named.iter().for_each(|(_, table)| table.enter(numbers.index, true)),
            Err(without) => {
                let found = self.named.iter().find(|(name, _)| *name == without);
                found.into_iter().for_each(|(_, table)| table.enter(numbers.index, false));
            }
        }
        numbers.givens().is_ok()
    }

    /// What a parameter of a set means, by its place, if that is remembered.
    pub(super) fn meaning(&self, index: u64, place: usize, value: &Expr) -> Option<Meaning> {
        let (digit, meanings) = self.meanings.get(place)?;
        let meaning = meanings.get(usize::try_from(digit.of(index)).ok()?)?;
        meaning.get_or_init(|| evaluate(value, &|_| None).ok()).clone()
    }

    /// The requirements on givens that do not hold, in their order. They are tried as they are asked for.
    pub(super) fn givens_refused(&self, numbers: &Numbers) -> impl Iterator<Item = Unfit> {
        let tables = self.holds.iter().enumerate().filter_map(|(place, table)| Some((place, table.as_ref()?)));
        let refused = tables.filter(move |(place, table)| {
            !table.known(numbers.index).unwrap_or_else(|| {
                let holds = match numbers.givens() {
                    Ok(givens) => self.style.require[*place].holds(&|name| givens.meaning(name)).unwrap_or(false),
                    Err(_) => false,
                };
                table.enter(numbers.index, holds);
                holds
            })
        });
        refused.map(|(place, _)| Unfit::Givens(place))
    }

    /// Two requirements on what is given that exclude each other: of so many sets none meets both, though some meet the one
    /// and some the other. Their texts.
    pub fn exclusive(&self, sets: u64) -> Option<[&'q str; 2]> {
        let places = || (0..self.holds.len()).filter(|place| self.holds[*place].is_some());
        let mut pairs: Vec<[usize; 2]> = places()
            .flat_map(|one| places().filter(move |other| one < *other).map(move |other| [one, other]))
            .collect();
        let mut met = BTreeSet::new();
        for index in 0..sets {
            let refused: BTreeSet<Unfit> = self.givens_refused(&Numbers::new(self, index)).collect();
            let is_met = |place: usize| !refused.contains(&Unfit::Givens(place));
            met.extend(places().filter(|place| is_met(*place)));
            pairs.retain(|pair| !pair.iter().all(|place| is_met(*place)));
        }
        let pair = pairs.into_iter().find(|pair| pair.iter().all(|place| met.contains(place)))?;
        Some(pair.map(|place| self.style.require[place].text.as_str()))
    }

    /// The requirements on results, with their places and the quantities that they name.
    pub(super) fn on_results(&self) -> impl Iterator<Item = (usize, &'q Requirement, &[Quantity])> {
        self.on_results.iter().map(|(place, requirement, quantities)| (*place, *requirement, quantities.as_slice()))
    }
}

/// A parameter's place in the index of a set: the index over the stride, modulo the size, is the place of its value.
#[derive(Clone, Copy)]
struct Digit {
    stride: u64,
    size: u64,
}

impl Digit {
    fn of(self, index: u64) -> u64 {
        index / self.stride % self.size
    }
}

/// The parameters of a style, and on which of them each name depends, by their places.
struct Depends<'q> {
    digits: Vec<Digit>,
    of: BTreeMap<&'q str, BTreeSet<usize>>,
}

impl<'q> Depends<'q> {
    fn new(style: &'q Style) -> Depends<'q> {
        let mut depends = Depends { digits: Vec::new(), of: BTreeMap::new() };
        // As in `Style::parameters_at` the last parameter varies fastest.
        let mut stride = style.size();
        for (place, (name, domain)) in style.parameters.iter().enumerate() {
            stride /= domain.size();
            depends.digits.push(Digit { stride, size: domain.size() });
            let mut places = depends.places(domain.formulas().iter().flat_map(names));
            places.insert(place);
            depends.of.insert(name, places);
        }
        for (name, formula) in &style.lets {
            let places = depends.places(names(formula));
            depends.of.insert(name, places);
        }
        depends
    }

    /// Those on which some names depend together.
    fn places<'n>(&self, names: impl IntoIterator<Item = &'n str>) -> BTreeSet<usize> {
        names.into_iter().filter_map(|name| self.of.get(name)).flatten().copied().collect()
    }

    fn table<'n>(&self, names: impl IntoIterator<Item = &'n str>, most: u64) -> Table {
        let digits: Vec<Digit> = self.places(names).into_iter().map(|place| self.digits[place]).collect();
        let size = digits.iter().fold(1, |size: u64, digit| size.saturating_mul(digit.size));
        let entries = if size <= most { size } else { 0 };
        Table { digits, entries: (0..entries).map(|_| AtomicU8::new(UNKNOWN)).collect() }
    }
}

fn names(formula: &Expr) -> impl Iterator<Item = &str> {
    formula.names().into_iter().map(|name| name.text.as_str())
}

const UNKNOWN: u8 = 0;
const NO: u8 = 1;
const YES: u8 = 2;

/// An answer for every choice of values of some parameters; without entries nothing is remembered.
struct Table {
    digits: Vec<Digit>,
    entries: Vec<AtomicU8>,
}

impl Table {
    fn entry(&self, index: u64) -> Option<&AtomicU8> {
        let place = self.digits.iter().fold(0, |place, digit| place * digit.size + digit.of(index));
        self.entries.get(usize::try_from(place).ok()?)
    }

    fn known(&self, index: u64) -> Option<bool> {
        match self.entry(index)?.load(Ordering::Relaxed) {
            UNKNOWN => None,
            known => Some(known == YES),
        }
    }

    fn enter(&self, index: u64, holds: bool) {
        if let Some(entry) = self.entry(index) {
            entry.store(if holds { YES } else { NO }, Ordering::Relaxed);
        }
    }
}
