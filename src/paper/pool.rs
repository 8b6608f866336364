//! The pool of a question in a style: all its variants, each with what makes it like another, and how long it is to work.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashSet};
use std::sync::{Mutex, PoisonError};

use super::answer::{Size, sizes};
use crate::bank::{Question, Style, StyleName};
use crate::expr::{print, written};
use crate::generate::{Census, Shuffle, Variant, enumerate};
use crate::mechanics::{Axis, Derivation, Moment, Quantity, Sphere};
use crate::number::Places;

/// Every variant that is fit for print.
#[derive(Clone, Debug)]
pub struct Pool {
    /// What became of every set of numbers.
    pub census: Census,
    /// The variants, by their index.
    pub candidates: Vec<Candidate>,
}

/// A variant, as far as dealing it to a class is concerned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    /// Which of the style's sets of numbers it is.
    pub index: u64,
    /// What makes it like another.
    pub likeness: Likeness,
    /// How many figures are given and asked for: the measure by which sheets are equally difficult.
    pub figures: usize,
}

/// What sheets must share so that nobody has the easier one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Likeness {
    /// How *A* and *B* move along the line of centres.
    pub motion: [Motion; 2],
    /// Is there a surd among the answers?
    pub surds: bool,
    /// The coefficient of restitution, as it is written; empty if it is not determined.
    pub e: String,
}

/// What the impact does to a sphere's motion along the line of centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Motion {
    /// It goes on in the same direction.
    GoesOn,
    /// It turns back.
    Rebounds,
    /// It is left without velocity along the line.
    Stops,
    /// It had none before.
    WasAtRest,
    /// That depends on the letters.
    Depends,
}

/// How far the variants of a class are alike; in each the style is the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Alike {
    /// In the motion, the form of the answers, and e.
    Wholly,
    /// In the motion and the form of the answers.
    ButForE,
    /// In the style alone.
    InStyle,
}

/// Variants chosen for a class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chosen {
    /// Their indices, those with the fewest figures first.
    pub indices: Vec<u64>,
    /// How far they are alike.
    pub alike: Alike,
    /// The fewest figures of one, and the most.
    pub figures: (usize, usize),
}

impl Pool {
    /// Examines every set of numbers of a style, on all processors.
    pub fn of(question: &Question, style: &Style) -> Pool {
        let found = Mutex::new(Vec::new());
        let visit = |variant: Variant| {
            let candidate = Candidate::of(question, &variant);
            found.lock().unwrap_or_else(PoisonError::into_inner).extend(candidate);
        };
        let census = enumerate(question, style, &visit, &|_| ());
        let mut candidates = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        // Threads bring them in any order.
        candidates.sort_unstable_by_key(|candidate: &Candidate| candidate.index);
        Pool { census, candidates }
    }

    /// The variant with an index, if it is fit for print.
    pub fn candidate(&self, index: u64) -> Option<&Candidate> {
        let place = self.candidates.binary_search_by_key(&index, |candidate| candidate.index).ok()?;
        self.candidates.get(place)
    }

    /// So many variants that are as alike as can be, none of those that are taken; `None` if there are not so many.
    ///
    /// Of the kinds with enough variants the seed chooses one, unless the class has had one already; of that kind those
    /// whose numbers of figures are nearest to one another.
    pub fn choose(
        &self,
        count: usize,
        taken: &HashSet<u64>,
        like: Option<&Likeness>,
        order: &dyn Fn(usize, &str) -> Shuffle,
    ) -> Option<Chosen> {
        [Alike::Wholly, Alike::ButForE, Alike::InStyle].into_iter().find_map(|alike| {
            let mut kinds: BTreeMap<_, Vec<&Candidate>> = BTreeMap::new();
            for candidate in self.candidates.iter().filter(|candidate| !taken.contains(&candidate.index)) {
                kinds.entry(alike.kind(&candidate.likeness)).or_default().push(candidate);
            }
            let had = like.and_then(|like| kinds.remove(&alike.kind(like))).filter(|kind| kind.len() >= count);
            let mut large: Vec<Vec<&Candidate>> = kinds.into_values().filter(|kind| kind.len() >= count).collect();
            let kind = had.or_else(|| {
                let first = order(large.len(), "kind").next()?;
                Some(large.swap_remove(first as usize))
            })?;
            let (indices, figures) = nearest(kind, count, order);
            Some(Chosen { indices, alike, figures })
        })
    }
}

/// So many of them, the most figures of one as few as can be above the fewest.
fn nearest(
    mut kind: Vec<&Candidate>,
    count: usize,
    order: &dyn Fn(usize, &str) -> Shuffle,
) -> (Vec<u64>, (usize, usize)) {
    let shuffled: Vec<&Candidate> = order(kind.len(), "variant").map(|place| kind[place as usize]).collect();
    kind = shuffled;
    // Stable: among those with equally many figures the order is that of the seed.
    kind.sort_by_key(|candidate| candidate.figures);
    let most = |start: usize| kind.get(start + count.max(1) - 1).map_or(0, |candidate| candidate.figures);
    let spread = |start: &usize| most(*start) - kind.get(*start).map_or(0, |candidate| candidate.figures);
    let starts = 0..kind.len() - count.max(1) + 1;
    let least = starts.clone().map(|start| spread(&start)).min().unwrap_or(0);
    let starts: Vec<usize> = starts.filter(|start| spread(start) == least).collect();
    let start = order(starts.len(), "figures").next().map_or(0, |place| starts[place as usize]);
    let indices = kind.iter().skip(start).take(count).map(|candidate| candidate.index).collect();
    (indices, (most(start) - least, most(start)))
}

impl Alike {
    /// What is alike, of a likeness.
    fn kind(self, likeness: &Likeness) -> (Option<([Motion; 2], bool)>, Option<&str>) {
        let kind = (self != Alike::InStyle).then_some((likeness.motion, likeness.surds));
        (kind, (self == Alike::Wholly).then_some(likeness.e.as_str()))
    }
}

impl Candidate {
    /// What there is to know of a variant; `None` of the reference numbers, which are not dealt.
    pub fn of(question: &Question, variant: &Variant) -> Option<Candidate> {
        let along = |sphere, moment| Quantity::Velocity(sphere, moment, Axis::N);
        let moments = [Moment::Before, Moment::After];
        let sides = Sphere::BOTH.into_iter().flat_map(|sphere| moments.map(|moment| along(sphere, moment)));
        let asked: Vec<Quantity> = sides.chain([Quantity::Restitution]).collect();
        let mut known = variant.solution.known().clone();
        Derivation::carry_out(&mut known, &asked);
        let sign = |sphere, moment| known.number(along(sphere, moment))?.sign();
        let motion = Sphere::BOTH.map(|sphere| match moments.map(|moment| sign(sphere, moment)) {
            [Some(Ordering::Equal), _] => Motion::WasAtRest,
            [_, Some(Ordering::Equal)] => Motion::Stops,
            [Some(before), Some(after)] if before == after => Motion::GoesOn,
            [Some(_), Some(_)] => Motion::Rebounds,
            _ => Motion::Depends,
        });
        let e = known.number(Quantity::Restitution).map_or(String::new(), |e| print::plain(&written(&e)));
        let answers: Vec<Size> =
            question.parts.iter().flat_map(|part| &part.answers).flat_map(|answer| sizes(answer, variant)).collect();
        let surds = answers.iter().any(|size| matches!(size, Size::Number(_)) && text(size).contains("sqrt"));
        let given = variant.parameters.iter().map(|(_, value)| figures(&print::plain(value)));
        let asked = answers.iter().map(|size| figures(&answered(size, variant.style)));
        let figures = given.chain(asked).sum();
        Some(Candidate { index: variant.index?, likeness: Likeness { motion, surds, e }, figures })
    }
}

fn text(size: &Size) -> String {
    print::plain(&size.exact())
}

/// What a student writes down: angles and the answers of a calculator are rounded.
fn answered(size: &Size, style: StyleName) -> String {
    let is_rounded = style == StyleName::Calculator || matches!(size, Size::Angle(_));
    let rounded = || size.rounded(&Places::SignificantFigures(3)).map(|decimal| decimal.to_string());
    is_rounded.then(rounded).flatten().unwrap_or_else(|| text(size))
}

fn figures(text: &str) -> usize {
    text.bytes().filter(u8::is_ascii_digit).count()
}
