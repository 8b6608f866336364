//! Do the slips that students make show in the numbers of a variant?
//!
//! A slip shows if some answer then comes out otherwise than it is, at the figures that are asked for. At 45 degrees a sine
//! taken for a cosine changes nothing, and with equal masses nothing that is wrong with a mass does: whoever makes the slip is
//! marked right. An author who means that, or cannot help it, names the slip in `hidden`.

use std::sync::OnceLock;

use super::coincidence::{Wanted, wanted};
use super::finding::Finding;
use crate::answer::Accept;
use crate::bank::{Answer, Question};
use crate::generate::{Variant, reference};
use crate::mark::slips::{Answers, Asked, acting, shown};
use crate::mechanics::Slip;
use crate::number::Places;

/// Exact values that differ by less than this part are one.
const SAME: f64 = 1e-7;

/// Which slips act on the variants of a style, and which of them show.
#[derive(Clone, Debug)]
pub struct Slips {
    /// Variants in which slips could be followed.
    variants: u64,
    /// Slips that change some value on the way in some variant, by their places.
    acting: u128,
    /// In how many variants each slip shows.
    shown: Vec<u64>,
    /// The first variant in which it does not.
    first: Vec<Option<u64>>,
    /// For each slip those that show in some variant beside it, and those that then give something else.
    beside: Vec<u128>,
    told: Vec<u128>,
    /// What each answer of the question asks for, the same in every variant.
    asked: OnceLock<Vec<Asked>>,
}

impl Default for Slips {
    fn default() -> Slips {
        let count = Slip::all().len();
        Slips {
            variants: 0,
            acting: 0,
            shown: vec![0; count],
            first: vec![None; count],
            beside: vec![0; count],
            told: vec![0; count],
            asked: OnceLock::new(),
        }
    }
}

impl Slips {
    /// Follows every slip through one variant.
    pub fn follow(&mut self, question: &Question, variant: &Variant) {
        let asked = self.asked.get_or_init(|| asked(question));
        let sought = variant.solution.sought();
        if sought.is_none() && asked.iter().all(|asked| asked.quantities().is_empty()) {
            return;
        }
        let is_exact = !variant.scene.letters.is_empty();
        let differ = |one: &Answers, other: &Answers| {
            let each = one.iter().zip(other).zip(answers(question));
            each.into_iter().any(|((one, other), answer)| match (one, other) {
                (Some(one), Some(other)) => one
                    .iter()
                    .zip(other)
                    .any(|(one, other)| !are_one(*one, *other, answer.accept(variant.style), is_exact)),
                _ => one.is_some() != other.is_some(),
            })
        };
        let Some(outcomes) = shown(variant.solution.given(), asked, sought.as_ref(), &differ) else { return };
        self.variants += 1;
        self.acting |= outcomes.iter().fold(0, |acting, outcome| acting | 1 << outcome.slip);
        let showing: Vec<(usize, &Answers)> =
            outcomes.iter().filter_map(|outcome| Some((outcome.slip, outcome.shown.as_ref()?))).collect();
        for slip in 0..self.shown.len() {
            if showing.iter().any(|(shows, _)| *shows == slip) {
                self.shown[slip] += 1;
            } else if let Some(index) = variant.index {
                self.first[slip] = Some(self.first[slip].map_or(index, |first| first.min(index)));
            }
        }
        for (place, (slip, answers)) in showing.iter().enumerate() {
            for (other, others) in &showing[place + 1..] {
                if self.told[*slip] >> other & 1 == 1 {
                    continue;
                }
                // Who finds nothing writes nothing, whatever the mistake.
                if !answers.iter().zip(*others).any(|(one, other)| one.is_some() && other.is_some()) {
                    continue;
                }
                self.beside[*slip] |= 1 << other;
                if differ(answers, others) {
                    self.told[*slip] |= 1 << other;
                }
            }
        }
    }

    /// Adds what was followed through other variants of the style.
    pub fn add(&mut self, other: Slips) {
        self.variants += other.variants;
        self.acting |= other.acting;
        for slip in 0..self.shown.len() {
            self.shown[slip] += other.shown[slip];
            self.first[slip] = self.first[slip].into_iter().chain(other.first[slip]).min();
            self.beside[slip] |= other.beside[slip];
            self.told[slip] |= other.told[slip];
        }
    }

    /// The slips that act and do not show in every variant: tag, in how many they do not, and the first of these.
    pub fn hidden(&self, acting: u128) -> Vec<(&'static str, u64, Option<u64>)> {
        let slips = Slip::all().iter().enumerate();
        let hidden = slips.filter(|(slip, _)| acting >> slip & 1 == 1 && self.shown[*slip] < self.variants);
        hidden.map(|(place, (_, slip))| (slip.tag, self.variants - self.shown[place], self.first[place])).collect()
    }

    /// The variants through which slips were followed.
    pub fn variants(&self) -> u64 {
        self.variants
    }

    /// Pairs that show beside each other and never come out otherwise than each other.
    fn alike(&self) -> Vec<(&'static str, &'static str)> {
        let all = Slip::all();
        let pairs = (0..all.len()).flat_map(|one| (one + 1..all.len()).map(move |other| (one, other)));
        let alike = pairs.filter(|(one, other)| (self.beside[*one] & !self.told[*one]) >> other & 1 == 1);
        alike.map(|(one, other)| (all[one].1.tag, all[other].1.tag)).collect()
    }
}

/// The answers of a question.
fn answers(question: &Question) -> impl Iterator<Item = &Answer> {
    question.parts.iter().flat_map(|part| &part.answers)
}

/// What each of them asks for.
fn asked(question: &Question) -> Vec<Asked> {
    answers(question).map(|answer| Asked::of(&answer.find, answer.kind)).collect()
}

/// The slips that act: those that change a value in some variant, and those that would if no number of the question
/// happened to equal another, by its reference numbers.
pub fn all_acting(question: &Question, styles: &[Slips]) -> u128 {
    let followed = styles.iter().fold(0, |all, slips| all | slips.acting);
    let by_reference = || -> Option<Vec<usize>> {
        let solution = reference(question).ok()?.solution;
        Some(acting(solution.given(), &asked(question), solution.sought().as_ref()))
    };
    by_reference().unwrap_or_default().into_iter().fold(followed, |all, slip| all | 1 << slip)
}

/// Would the two be written alike at the figures that are asked for?
fn are_one(one: f64, other: f64, accept: &Accept, is_exact: bool) -> bool {
    let size = one.abs().max(other.abs());
    if (one - other).abs() <= SAME * size.max(1e-6) {
        return true;
    }
    let unit = match accept.places() {
        _ if is_exact => return false,
        None => return false,
        // Two numbers that are written alike are not further apart than one in the last figure, which is a tenth at most.
        Some(Places::SignificantFigures(2..)) if (one - other).abs() > size / 10.0 => return false,
        Some(Places::SignificantFigures(figures)) => {
            10_f64.powi(size.log10().floor() as i32 + 1 - (*figures).clamp(1, 15) as i32)
        }
        Some(Places::DecimalPlaces(places)) => 10_f64.powi(-((*places).min(15) as i32)),
        Some(Places::Nearest(step)) => step.decimal().to_string().parse().unwrap_or(1.0),
    };
    (one / unit).round() == (other / unit).round()
}

/// A slip that does not show in some variants.
struct Hidden {
    tag: &'static str,
    /// How many variants of each style hide it.
    variants: Vec<String>,
    /// The numbers of the first of these.
    first: String,
}

/// Slips that do not show, against the list of the question: one finding, and with the list as it should be where several
/// are amiss.
fn undeclared(question: &Question, acting: u128, hidden: &[Hidden]) -> Option<Finding> {
    let missing: Vec<&Hidden> =
        hidden.iter().filter(|slip| !question.hidden.iter().any(|known| known == slip.tag)).collect();
    let idle = |tag: &&str| !hidden.iter().any(|slip| slip.tag == *tag);
    let needless: Vec<&str> = question.hidden.iter().map(String::as_str).filter(idle).collect();
    match (missing.as_slice(), needless.as_slice()) {
        ([], []) => None,
        ([slip], []) => Some(one_undeclared(question, acting, slip)),
        ([], [tag]) => {
            let message = format!("the slip `{tag}` is declared hidden, and shows in every variant");
            Some(Finding::new(message, format!("\"{tag}\""), "not needed").with_help("take it out of `hidden`"))
        }
        (missing, needless) => Some(several_amiss(question, acting, hidden, missing, needless)),
    }
}

fn one_undeclared(question: &Question, acting: u128, Hidden { tag, variants, first }: &Hidden) -> Finding {
    let did = Slip::all().iter().find(|(_, slip)| slip.tag == *tag).map_or("", |(_, slip)| slip.did);
    let message = format!("the slip `{tag}` does not show in {}, first with {first}", variants.join(", "));
    let require = wanted(question, acting, &[tag]).in_words().unwrap_or_else(|| "require other numbers".to_owned());
    let help = format!("{require}, or add `\"{tag}\"` to the list `hidden = [ … ]` of the question");
    Finding::new(message, "[[part]]", format!("a student who {did} is marked right")).with_help(help)
}

/// All that is amiss with the list, and what it should be.
fn several_amiss(
    question: &Question,
    acting: u128,
    hidden: &[Hidden],
    missing: &[&Hidden],
    needless: &[&str],
) -> Finding {
    let is_kept = |tag: &&str| question.hidden.iter().any(|known| known == tag);
    let (kept, new): (Vec<&str>, Vec<&str>) = hidden.iter().map(|slip| slip.tag).partition(is_kept);
    let tags: Vec<&str> = missing.iter().map(|slip| slip.tag).collect();
    let wanted = if tags.is_empty() { Wanted::default() } else { wanted(question, acting, &tags) };
    let left = new.into_iter().filter(|tag| !wanted.shows.contains(tag));
    let whole: Vec<String> = kept.into_iter().chain(left).map(|tag| format!("\"{tag}\"")).collect();
    let list = format!("`hidden = [{}]`", whole.join(", "));
    let (label, help) = match (missing.is_empty(), whole.is_empty()) {
        (true, true) => ("not needed", "take the whole list out".to_owned()),
        (true, false) => ("not all of it is needed", format!("write {list}")),
        _ => {
            let help = match (wanted.in_words(), whole.is_empty()) {
                (None, _) => format!("require other numbers, or write {list}"),
                (Some(require), true) => require,
                (Some(require), false) => format!("{require}, and write {list}"),
            };
            ("a student who makes a hidden slip is marked right", help)
        }
    };
    let at = if question.hidden.is_empty() { "[[part]]" } else { "hidden" };
    Finding::new(amiss_in_words(missing, needless), at, label).with_help(help)
}

/// The slips that are amiss; those that the same numbers hide together, since these say which requirement is wanted.
fn amiss_in_words(missing: &[&Hidden], needless: &[&str]) -> String {
    let list = |tags: &[&str]| {
        let names: Vec<String> = tags.iter().map(|tag| format!("`{tag}`")).collect();
        format!("the {} {}", if tags.len() == 1 { "slip" } else { "slips" }, names.join(", "))
    };
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for slip in missing {
        match groups.iter_mut().find(|(known, _)| *known == slip.first) {
            Some((_, tags)) => tags.push(slip.tag),
            None => groups.push((&slip.first, vec![slip.tag])),
        }
    }
    let mut said = Vec::new();
    for (first, tags) in groups {
        let verb = if tags.len() == 1 { "does" } else { "do" };
        said.push(format!("{} {verb} not show in some variants, first with {first}", list(&tags)));
    }
    if !needless.is_empty() {
        let verb = if needless.len() == 1 { "is declared hidden, and shows" } else { "are declared hidden, and show" };
        said.push(format!("{} {verb} in every variant", list(needless)));
    }
    said.join("; ")
}

/// Pairs that no variant tells apart, against the list of the question: one finding, with what is to be written where it can
/// stand, for there is one list, and it stands above the first heading.
fn undeclared_pairs(question: &Question, pairs: &[(&str, &str)]) -> Option<Finding> {
    let ((one, other), rest) = pairs.split_first()?;
    let further = match rest.len() {
        0 => String::new(),
        1 => ", and one pair more".to_owned(),
        more => format!(", and {more} pairs more"),
    };
    let message = format!("the slips `{one}` and `{other}` come to the same in every variant{further}");
    let written: Vec<String> = pairs.iter().map(|(one, other)| format!("\"{one} = {other}\"")).collect();
    let written = written.join(", ");
    let (at, help) = match question.alike.is_empty() {
        true => ("[[part]]", format!("ask for something more, or write `alike = [{written}]` above the first heading")),
        false => ("alike", format!("ask for something more, or add `{written}` to the list `alike` of the question")),
    };
    Some(Finding::new(message, at, "a student who makes one is told of both").with_help(help))
}

/// What a question's numbers hide and do not say, and what it says without need.
pub fn findings(
    question: &Question,
    styles: &[Slips],
    acting: u128,
    numbers: &dyn Fn(usize, u64) -> String,
) -> Vec<Finding> {
    // Where no style has a variant nothing has been followed, and nothing can be said.
    if styles.iter().all(|slips| slips.variants() == 0) {
        return Vec::new();
    }
    let mut findings = Vec::new();
    let mut hidden: Vec<Hidden> = Vec::new();
    for (place, slips) in styles.iter().enumerate() {
        for (tag, count, first) in slips.hidden(acting) {
            let of = format!("{count} of {} variants of style `{}`", slips.variants(), question.styles[place].name);
            match hidden.iter_mut().find(|slip| slip.tag == tag) {
                Some(slip) => slip.variants.push(of),
                None => {
                    let first = first.map_or_else(String::new, |first| numbers(place, first));
                    hidden.push(Hidden { tag, variants: vec![of], first });
                }
            }
        }
    }
    findings.extend(undeclared(question, acting, &hidden));
    let mut all = Slips::default();
    for slips in styles {
        all.add(slips.clone());
    }
    let alike = all.alike();
    let is_pair = |pair: &(String, String), one: &str, other: &str| {
        (pair.0 == one && pair.1 == other) || (pair.0 == other && pair.1 == one)
    };
    let is_new = |(one, other): &&(&str, &str)| !question.alike.iter().any(|pair| is_pair(pair, one, other));
    findings.extend(undeclared_pairs(question, &alike.iter().filter(is_new).copied().collect::<Vec<_>>()));
    for (one, other) in &question.alike {
        if !alike.iter().any(|(a, b)| is_pair(&(one.clone(), other.clone()), a, b)) {
            let message =
                format!("the slips `{one}` and `{other}` are declared alike, and some variant tells them apart");
            let label = "not needed";
            findings.push(Finding::new(message, one.as_str(), label).with_help("take the pair out of `alike`"));
        }
    }
    findings
}
