//! The dealer of a sheet: for each question one set of numbers after another, no two of them equal.

use std::collections::{BTreeMap, BTreeSet};

use crate::bank::{Question, StyleName};
use crate::expr::print;
use crate::generate::{Deal, Shuffle, Variant};

/// Deals variants of questions in the order that a seed decides.
pub struct Dealer<'q> {
    seed: u64,
    style: Option<StyleName>,
    hands: BTreeMap<&'q str, Hand<'q>>,
}

/// What has been dealt of one question.
struct Hand<'q> {
    /// One deal a style, in the order that the seed decides.
    deals: Vec<Deal<'q>>,
    /// How often the question has been asked for.
    turn: usize,
    seen: BTreeSet<String>,
}

impl<'q> Dealer<'q> {
    /// A dealer for a seed; all in one style, or each in a style that the seed chooses.
    pub fn new(seed: u64, style: Option<StyleName>) -> Dealer<'q> {
        Dealer { seed, style, hands: BTreeMap::new() }
    }

    /// The next variant of a question; `None` once there are no more.
    pub fn next(&mut self, question: &'q Question) -> Option<Variant> {
        let (seed, style) = (self.seed, self.style);
        let hand = self.hands.entry(question.id.as_str()).or_insert_with(|| {
            let order = Shuffle::new(question.styles.len() as u64, seed, &question.id, "style");
            let styles = order.map(|place| &question.styles[place as usize]);
            let styles = styles.filter(|offered| style.is_none_or(|style| offered.name == style));
            let deals = styles.map(|style| Deal::new(question, style, seed)).collect();
            Hand { deals, turn: 0, seen: BTreeSet::new() }
        });
        hand.next()
    }
}

impl Hand<'_> {
    fn next(&mut self) -> Option<Variant> {
        let styles = self.deals.len();
        let first = self.turn;
        self.turn += 1;
        for place in (first..).take(styles) {
            for variant in &mut self.deals[place % styles] {
                // Two styles may hold the same numbers.
                if self.seen.insert(numbers(&variant)) {
                    return Some(variant);
                }
            }
        }
        None
    }
}

fn numbers(variant: &Variant) -> String {
    let each = |(name, value): &(String, crate::expr::Expr)| format!("{name}={};", print::plain(value));
    variant.parameters.iter().map(each).collect()
}
