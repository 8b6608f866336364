//! A class dealt: a sheet for each student, no two alike in numbers, all alike in kind and of about as many figures.

use std::collections::{BTreeMap, HashSet};

use super::pool::{Alike, Chosen, Pool};
use crate::bank::{Question, StyleName};
use crate::generate::{Shuffle, Variant, examine};

/// The variants of a student, one for each question of the sheet.
pub type Hand = Vec<Variant>;

/// What a class is dealt.
#[derive(Clone, Debug)]
pub struct Class {
    /// The hand of each student, in the order of the class.
    pub hands: Vec<Hand>,
    /// How each question of the sheet was dealt.
    pub places: Vec<PlaceDealt>,
}

/// How a question of the sheet was dealt.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaceDealt {
    /// The question.
    pub question: String,
    /// The style that all have.
    pub style: StyleName,
    /// How far the variants are alike.
    pub alike: Alike,
    /// How many different answers they have, without those that others hold already.
    pub different: usize,
    /// The fewest figures in one of them, and the most.
    pub figures: (usize, usize),
}

/// A question has fewer variants than there are students.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TooFew {
    /// The question.
    pub question: String,
    /// Of the styles that may be used that with the most variants, and how many it has.
    pub style: StyleName,
    /// How many it has that nobody has yet.
    pub left: usize,
    /// How many are needed.
    pub needed: usize,
    /// What turns away most sets of numbers, and how many of how many.
    pub costliest: Option<(String, u64, u64)>,
}

/// Deals a class its sheets.
///
/// All students have the same questions in the same order and style. Of each question no two have the same numbers, nor
/// the same answers while there are others, and nobody has any of `had`, the hands that others hold already. `had` also says
/// which style and kind the class has.
///
/// # Errors
///
/// The first question with too few variants.
pub fn deal(
    questions: &[&Question],
    students: usize,
    seed: u64,
    style: Option<StyleName>,
    had: &[Vec<(StyleName, u64)>],
) -> Result<Class, TooFew> {
    let mut pools: BTreeMap<(&str, StyleName), Pool> = BTreeMap::new();
    let mut taken: BTreeMap<(&str, StyleName), HashSet<u64>> = BTreeMap::new();
    for (place, question) in questions.iter().enumerate() {
        for (style, index) in had.iter().filter_map(|hand| hand.get(place)) {
            taken.entry((question.id.as_str(), *style)).or_default().insert(*index);
        }
    }
    let mut hands: Vec<Hand> = vec![Hand::new(); students];
    let mut totals = vec![0; students];
    let mut places = Vec::new();
    for (place, question) in questions.iter().enumerate() {
        let first = had.first().and_then(|hand| hand.get(place));
        let order = |size: usize, what: &str| Shuffle::new(size as u64, seed, &question.id, &format!("{what} {place}"));
        let turn = questions[..place].iter().filter(|earlier| earlier.id == question.id).count();
        let wanted = first.map(|(style, _)| *style).or(style);
        let styles = styles(question, wanted, seed, turn);
        let found = styles.iter().find_map(|style| {
            let id = (question.id.as_str(), *style);
            let pool = pools.entry(id).or_insert_with(|| match question.style(*style) {
                Some(style) => Pool::of(question, style),
                None => Pool { census: Default::default(), candidates: Vec::new() },
            });
            let like = first.and_then(|(_, index)| pool.candidate(*index));
            let taken = taken.entry(id).or_default();
            let chosen = pool.choose(students, taken, like.map(|one| &one.likeness), &order)?;
            taken.extend(&chosen.indices);
            Some((*style, chosen))
        });
        let Some((style, chosen)) = found else {
            return Err(too_few(question, &styles, students, &pools, &taken));
        };
        // Who has had most figures so far gets the fewest now.
        let mut turns: Vec<usize> = order(students, "student").map(|student| student as usize).collect();
        turns.sort_by_key(|student| std::cmp::Reverse(totals[*student]));
        let pool = &pools[&(question.id.as_str(), style)];
        for (student, index) in turns.into_iter().zip(&chosen.indices) {
            totals[student] += pool.candidate(*index).map_or(0, |candidate| candidate.figures);
            let style = question.style(style);
            hands[student].extend(style.and_then(|style| examine(question, style, *index).ok()));
        }
        let Chosen { alike, different, figures, .. } = chosen;
        places.push(PlaceDealt { question: question.id.clone(), style, alike, different, figures });
    }
    Ok(Class { hands, places })
}

/// The styles in which a question may be dealt, in the order that the seed decides, another first each time it is asked.
fn styles(question: &Question, wanted: Option<StyleName>, seed: u64, turn: usize) -> Vec<StyleName> {
    if let Some(style) = wanted {
        return vec![style];
    }
    let order = Shuffle::new(question.styles.len() as u64, seed, &question.id, "style");
    let mut styles: Vec<StyleName> = order.map(|place| question.styles[place as usize].name).collect();
    let styles_there_are = styles.len().max(1);
    styles.rotate_left(turn % styles_there_are);
    styles
}

fn too_few(
    question: &Question,
    styles: &[StyleName],
    needed: usize,
    pools: &BTreeMap<(&str, StyleName), Pool>,
    taken: &BTreeMap<(&str, StyleName), HashSet<u64>>,
) -> TooFew {
    let id = question.id.as_str();
    let left = |style: StyleName| {
        let all = pools.get(&(id, style)).map_or(0, |pool| pool.candidates.len());
        all.saturating_sub(taken.get(&(id, style)).map_or(0, HashSet::len))
    };
    let style = styles.iter().copied().max_by_key(|style| left(*style)).unwrap_or(StyleName::Friendly);
    let costliest = question.style(style).zip(pools.get(&(id, style))).and_then(|(style, pool)| {
        let (reason, count) = pool.census.funnel(question, style).into_iter().max_by_key(|(_, count)| *count)?;
        Some((reason, count, pool.census.examined))
    });
    TooFew { question: question.id.clone(), style, left: left(style), needed, costliest }
}
