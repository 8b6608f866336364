//! The pool of a question in a style: all its variants, each with what makes it like another, and how long it is to work.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::{Mutex, PoisonError};

use super::answer::{self, Size, sizes};
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
    /// The answers of all its parts, as they are written: where they are equal one student can copy from the other.
    pub answers: String,
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
    /// How many different answers they have, without those that are held already.
    pub different: usize,
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
    /// Of the kinds with enough variants, and of these with the most different answers, the seed chooses one, unless the
    /// class has had one already; of that kind those whose numbers of figures are nearest to one another. Answers come
    /// twice only where a kind has no others, and rather than that e is not the same for all.
    pub fn choose(
        &self,
        count: usize,
        taken: &HashSet<u64>,
        like: Option<&Likeness>,
        order: &dyn Fn(usize, &str) -> Shuffle,
    ) -> Option<Chosen> {
        let mut held: HashMap<&str, usize> = HashMap::new();
        for candidate in taken.iter().filter_map(|index| self.candidate(*index)) {
            *held.entry(candidate.answers.as_str()).or_default() += 1;
        }
        let free: Vec<&Candidate> =
            self.candidates.iter().filter(|candidate| !taken.contains(&candidate.index)).collect();
        let of = |alike: Alike| {
            let kind = alike.kind_for(count, &free, &held, like, order)?;
            Some((fresh(&kind, &held).min(count), alike, kind))
        };
        let (wholly, but_for_e) = (of(Alike::Wholly), of(Alike::ButForE));
        let best = match (&wholly, &but_for_e) {
            (Some(alike), Some(other)) if other.0 > alike.0 => but_for_e,
            (None, _) => but_for_e,
            _ => wholly,
        };
        let (different, alike, kind) = best.or_else(|| of(Alike::InStyle))?;
        let (indices, figures) = match different < count {
            true => most_different(kind, count, &held, order),
            false => nearest(kind, count, &held, order),
        };
        Some(Chosen { indices, alike, different, figures })
    }
}

/// How many answers there are among some variants that nobody holds.
fn fresh(kind: &[&Candidate], held: &HashMap<&str, usize>) -> usize {
    let answers = kind.iter().map(|candidate| candidate.answers.as_str());
    answers.filter(|answers| !held.contains_key(answers)).collect::<HashSet<_>>().len()
}

/// So many of them with different answers that nobody holds, the most figures of one as few as can be above the fewest.
fn nearest(
    kind: Vec<&Candidate>,
    count: usize,
    held: &HashMap<&str, usize>,
    order: &dyn Fn(usize, &str) -> Shuffle,
) -> (Vec<u64>, (usize, usize)) {
    let shuffled = order(kind.len(), "variant").map(|place| kind[place as usize]);
    let mut kind: Vec<&Candidate> = shuffled.filter(|one| !held.contains_key(one.answers.as_str())).collect();
    // Stable: among those with equally many figures the order is that of the seed.
    kind.sort_by_key(|candidate| candidate.figures);
    let runs = runs(&kind, count.max(1));
    let range = |(start, end): &(usize, usize)| (kind[*start].figures, kind[*end - 1].figures);
    let spread = |run: &(usize, usize)| range(run).1 - range(run).0;
    let least = runs.iter().map(spread).min().unwrap_or(0);
    let runs: Vec<(usize, usize)> = runs.into_iter().filter(|run| spread(run) == least).collect();
    let Some(run) = order(runs.len(), "figures").next().map(|place| runs[place as usize]) else {
        return Default::default();
    };
    let mut dealt = HashSet::new();
    let chosen = kind[run.0..run.1].iter().filter(|candidate| dealt.insert(candidate.answers.as_str()));
    (chosen.take(count).map(|candidate| candidate.index).collect(), range(&run))
}

/// From each place on the shortest run with so many different answers: where it begins, and where the next would.
fn runs(kind: &[&Candidate], count: usize) -> Vec<(usize, usize)> {
    let mut within: HashMap<&str, usize> = HashMap::new();
    let mut runs = Vec::new();
    let mut end = 0;
    for (start, first) in kind.iter().enumerate() {
        while within.len() < count {
            let Some(next) = kind.get(end) else { return runs };
            *within.entry(&next.answers).or_default() += 1;
            end += 1;
        }
        runs.push((start, end));
        let left = within.get(first.answers.as_str()).copied().unwrap_or(0);
        match left {
            0 | 1 => within.remove(first.answers.as_str()),
            _ => within.insert(&first.answers, left - 1),
        };
    }
    runs
}

/// So many of them where answers must come twice: each answer that there is before any comes again, and of those with the
/// same answers first those whose number of figures is nearest to the middle.
fn most_different(
    kind: Vec<&Candidate>,
    count: usize,
    held: &HashMap<&str, usize>,
    order: &dyn Fn(usize, &str) -> Shuffle,
) -> (Vec<u64>, (usize, usize)) {
    let mut kind: Vec<&Candidate> = order(kind.len(), "variant").map(|place| kind[place as usize]).collect();
    let mut figures: Vec<usize> = kind.iter().map(|candidate| candidate.figures).collect();
    figures.sort_unstable();
    let middle = figures[figures.len() / 2];
    kind.sort_by_key(|candidate| candidate.figures.abs_diff(middle));
    let mut times = held.clone();
    let mut in_turn: Vec<(usize, &Candidate)> = Vec::new();
    for candidate in kind {
        let times = times.entry(&candidate.answers).or_default();
        in_turn.push((*times, candidate));
        *times += 1;
    }
    in_turn.sort_by_key(|(turn, _)| *turn);
    in_turn.truncate(count);
    in_turn.sort_by_key(|(_, candidate)| candidate.figures);
    let figures = |one: Option<&(usize, &Candidate)>| one.map_or(0, |(_, candidate)| candidate.figures);
    let range = (figures(in_turn.first()), figures(in_turn.last()));
    (in_turn.into_iter().map(|(_, candidate)| candidate.index).collect(), range)
}

impl Alike {
    /// What is alike, of a likeness.
    fn kind(self, likeness: &Likeness) -> (Option<([Motion; 2], bool)>, Option<&str>) {
        let kind = (self != Alike::InStyle).then_some((likeness.motion, likeness.surds));
        (kind, (self == Alike::Wholly).then_some(likeness.e.as_str()))
    }

    /// The kind of which so many are dealt, if one is large enough: that which the class has had, else of those with the
    /// most answers that nobody holds the one that the seed chooses.
    fn kind_for<'c>(
        self,
        count: usize,
        free: &[&'c Candidate],
        held: &HashMap<&str, usize>,
        like: Option<&Likeness>,
        order: &dyn Fn(usize, &str) -> Shuffle,
    ) -> Option<Vec<&'c Candidate>> {
        let mut kinds: BTreeMap<_, Vec<&Candidate>> = BTreeMap::new();
        for candidate in free {
            kinds.entry(self.kind(&candidate.likeness)).or_default().push(candidate);
        }
        kinds.retain(|_, kind| kind.len() >= count);
        if let Some(had) = like.and_then(|like| kinds.remove(&self.kind(like))) {
            return Some(had);
        }
        let different = |kind: &Vec<&Candidate>| fresh(kind, held).min(count);
        let most = kinds.values().map(different).max()?;
        let mut large: Vec<Vec<&Candidate>> = kinds.into_values().filter(|kind| different(kind) == most).collect();
        let first = order(large.len(), "kind").next()?;
        Some(large.swap_remove(first as usize))
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
        let exact = |answer| answer::exact(answer, variant).as_ref().map_or_else(String::new, print::plain);
        let all: Vec<String> = question.parts.iter().flat_map(|part| &part.answers).map(exact).collect();
        let (likeness, answers) = (Likeness { motion, surds, e }, all.join("; "));
        Some(Candidate { index: variant.index?, likeness, answers, figures })
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
