//! Questions examined, every set of numbers of every style, on all processors.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::coverage::{Coverage, Fault as CoverageFault, MarkCount, coverage};
use super::finding::Finding;
use super::remark::numbers;
use super::report::{Report, StyleReport};
use super::shows;
use super::tally::Tally;
use super::{again, author, scheme, suggested, unprinted, words};
use crate::bank::{Givens, Posed, Question, Requirement, Style, Unposed};
use crate::diagnostic::Severity;
use crate::generate::{
    Deal, MOST_SETS, Numbers, Sieve, Unfit, Variant, on_all_processors, out_of, portions, reference,
};

/// How many variants of each style are marked as handed in by students whose marks are known, beside the reference
/// numbers. To mark one costs as much as to examine hundreds, and what a student of theirs can show is in the scheme, which
/// all variants of a question share.
pub const MARKED: usize = 3;

/// In how many variants of each style what the words say is compared with the scene.
const HEARD: usize = 12;

/// So many sets of numbers are tried to see which requirements exclude each other.
const MOST_TRIED: u64 = 20_000;

/// A style and which of its variants; none for the reference numbers.
type Dealt = Option<(usize, usize)>;

/// Sets of numbers of some styles that have the same, by their indices: a piece of the work, done by one thread.
struct Sets {
    family: usize,
    indices: Range<u64>,
}

/// Styles of a question whose sets of numbers are the same: each set is solved once for all of them.
struct Family<'q> {
    question: usize,
    /// Each with the place of its style.
    sieves: Vec<(usize, Sieve<'q>)>,
}

/// What has been done since it was last told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// So many sets of numbers have been examined; [`work`] says how many there are.
    Sets(u64),
    /// The variants of one style more have been marked, or the reference numbers of one question, of so many in all.
    Marked {
        /// All that are to be marked.
        of: u64,
    },
}

/// How many sets of numbers there are to examine.
pub fn work<'q>(questions: impl IntoIterator<Item = &'q Question>) -> u64 {
    questions.into_iter().flat_map(|question| &question.styles).map(|style| style.size().min(MOST_SETS)).sum()
}

/// Examines questions; `progress` is told of each step.
pub fn survey(questions: &[&Question], progress: &(dyn Fn(Step) + Sync)) -> Vec<Report> {
    let families = families(questions);
    let empty = || -> Vec<Done> { questions.iter().map(|question| Done::new(question)).collect() };
    let mut total = empty();
    let examine = |done: &mut Vec<Done>, Sets { family, indices }: &Sets| {
        let Family { question, sieves } = &families[*family];
        for index in indices.clone() {
            let numbers = Numbers::new(&sieves[0].1, index);
            for (style, sieve) in sieves {
                done[*question].tallies[*style].examine(sieve, &numbers);
            }
        }
        progress(Step::Sets((indices.end - indices.start) * sieves.len() as u64));
    };
    for done in on_all_processors(&sets(&families), &empty, &examine) {
        total.iter_mut().zip(done).for_each(|(total, done)| total.add(done));
    }
    // Only then is it known which variants can be dealt.
    let tallies = |question: usize| &total[question].tallies;
    let looked_at = looked_at(questions);
    let exercises = scheme::exercises();
    let look = |done: &mut Vec<Done>, (question, style): &(usize, Option<usize>)| {
        let of = questions[*question];
        if style.is_none() {
            done[*question].itself = Itself::of(of, &exercises);
        }
        for (dealt, variant) in dealt_variants(of, *style, tallies(*question)) {
            if dealt.is_none_or(|(_, nth)| nth < MARKED) {
                done[*question].coverage.push((dealt, coverage(of, &variant)));
            }
            if let Some((style, _)) = dealt {
                done[*question].said.push((dealt, words::contradicted(of, &of.styles[style], &variant)));
            }
        }
        progress(Step::Marked { of: looked_at.len() as u64 });
    };
    for done in on_all_processors(&looked_at, &empty, &look) {
        total.iter_mut().zip(done).for_each(|(total, done)| total.add(done));
    }
    questions.iter().zip(total).map(|(question, done)| done.report(question)).collect()
}

/// The styles of all questions, those together that are solved together.
fn families<'q>(questions: &[&'q Question]) -> Vec<Family<'q>> {
    let mut families: Vec<Family> = Vec::new();
    for (question, asked) in questions.iter().enumerate() {
        for (place, style) in asked.styles.iter().enumerate() {
            let sieve = Sieve::new(asked, style);
            let same = |family: &&mut Family| family.question == question && family.sieves[0].1.has_sets_of(&sieve);
            match families.iter_mut().find(same) {
                Some(family) => family.sieves.push((place, sieve)),
                None => families.push(Family { question, sieves: vec![(place, sieve)] }),
            }
        }
    }
    families
}

/// The sets of numbers of all styles, in portions.
fn sets(families: &[Family]) -> Vec<Sets> {
    let of_one = |(family, of): (usize, &Family)| {
        portions(of.sieves[0].1.style.size()).map(move |indices| Sets { family, indices })
    };
    families.iter().enumerate().flat_map(of_one).collect()
}

/// Of each question the styles whose variants are looked at one by one, and the reference numbers.
fn looked_at(questions: &[&Question]) -> Vec<(usize, Option<usize>)> {
    let styles = |question: &Question| std::iter::once(None).chain((0..question.styles.len()).map(Some));
    questions
        .iter()
        .enumerate()
        .flat_map(|(place, question)| styles(question).map(move |style| (place, style)))
        .collect()
}

/// The variants of a style that are looked at one by one, or the reference numbers.
fn dealt_variants(question: &Question, style: Option<usize>, tallies: &[Tally]) -> Vec<(Dealt, Variant)> {
    let Some(place) = style else {
        return reference(question).ok().map(|variant| (None, variant)).into_iter().collect();
    };
    let (style, tally) = (&question.styles[place], &tallies[place]);
    let deal = match tally.census.examined < tally.census.size {
        true => Deal::new(question, style, 1),
        false => Deal::knowing(question, style, 1, tally.fit.iter().copied()),
    };
    deal.take(HEARD).enumerate().map(|(nth, variant)| (Some((place, nth)), variant)).collect()
}

/// What is amiss with a question whatever its numbers are.
#[derive(Default)]
struct Itself {
    findings: Vec<Finding>,
    /// The rows of marks that nobody can earn.
    unearnable: Vec<(usize, &'static str, usize)>,
}

impl Itself {
    fn of(question: &Question, exercises: &[String]) -> Itself {
        let mut findings = again::reference_faults(question);
        findings.extend(author::disagreements(question));
        findings.extend(words::of_question(question));
        let unrewarded = scheme::unrewarded(question);
        let unearnable = unrewarded.iter().filter_map(|found| found.row).collect();
        findings.extend(unrewarded);
        findings.extend(scheme::paid_twice(question));
        findings.extend(scheme::unknown_exercise(question, exercises));
        Itself { findings, unearnable }
    }

    fn add(&mut self, other: Itself) {
        self.findings.extend(other.findings);
        self.unearnable.extend(other.unearnable);
    }
}

/// What has been seen of a question so far.
struct Done {
    itself: Itself,
    tallies: Vec<Tally>,
    coverage: Vec<(Dealt, Coverage)>,
    /// What the words say and is not so in the variants that are looked at one by one.
    said: Vec<(Dealt, Vec<Finding>)>,
}

impl Done {
    fn new(question: &Question) -> Done {
        let tallies = question.styles.iter().map(|style| Tally::new(style.size()));
        Done { itself: Itself::default(), tallies: tallies.collect(), coverage: Vec::new(), said: Vec::new() }
    }

    fn add(&mut self, other: Done) {
        self.itself.add(other.itself);
        for (own, other) in self.tallies.iter_mut().zip(other.tallies) {
            own.add(other);
        }
        self.coverage.extend(other.coverage);
        self.said.extend(other.said);
    }

    fn report(mut self, question: &Question) -> Report {
        let Itself { mut findings, unearnable } = self.itself;
        self.said.sort_by_key(|(dealt, _)| *dealt);
        let mut said: Vec<Finding> = Vec::new();
        for finding in self.said.into_iter().flat_map(|(_, findings)| findings) {
            // What is said in one place is the same in every variant and style.
            if !said.iter().any(|other| (&other.at, &other.help) == (&finding.at, &finding.help)) {
                said.push(finding);
            }
        }
        findings.extend(said);
        findings.extend(needless(question, &self.tallies));
        findings.extend(unprinted::signs(question, &self.tallies));
        let mut told = BTreeSet::new();
        for (style, tally) in question.styles.iter().zip(&self.tallies) {
            findings.extend(unposed(question, style, tally));
            findings.extend(tally.findings(style, &mut told));
        }
        let slips: Vec<_> = self.tallies.iter().map(|tally| tally.slips.clone()).collect();
        let shown = |place: usize, index| numbers(&question.styles[place], index);
        let acting = shows::all_acting(question, &slips);
        findings.extend(shows::findings(question, &slips, acting, &shown));
        // Threads finish out of order.
        self.coverage.sort_by_key(|(dealt, _)| *dealt);
        let mut coverage = Coverage::default();
        for (_, one) in self.coverage {
            coverage.add(one);
        }
        // Of a mark that nobody can earn it has been told why.
        let is_new = |found: &Finding| found.row.is_none_or(|row| row.1 != "marks" || !unearnable.contains(&row));
        findings.extend(idle(question, &coverage).into_iter().filter(is_new));
        let styles = question.styles.iter().zip(&self.tallies);
        let styles =
            styles.map(|(style, tally)| StyleReport::new(question, style, &tally.census, &tally.slips, acting));
        Report { styles: styles.collect(), findings, coverage }
    }
}

/// A style without variants, and sets of numbers that no requirement turns away but mechanics.
fn unposed(question: &Question, style: &Style, tally: &Tally) -> Vec<Finding> {
    let census = &tally.census;
    let at = format!("[style.{}]", style.name);
    let mut findings = Vec::new();
    if census.size > MOST_SETS {
        let message = format!("style `{}` has {} sets of numbers, too many to examine", style.name, census.size);
        let label = format!("the first {MOST_SETS} have been examined");
        let found = Finding::new(message, at.as_str(), label).with_help("give its parameters fewer values");
        findings.push(Finding { severity: Severity::Warning, ..found });
    }
    if census.fit == 0 {
        let message = format!("style `{}` has no variant", style.name);
        let help = match Sieve::new(question, style).exclusive(style.size().min(MOST_TRIED)) {
            Some([one, other]) => format!("take out `{one}` or `{other}`, of which no set of numbers meets both"),
            None => match census.last_requirement(style) {
                Some((last, count)) => {
                    format!("mend `{last}`, or take it out: it turns away all {count} that are left when it is tried")
                }
                None => format!("`carom explain {}` says what turns the numbers away", question.id),
            },
        };
        findings.push(Finding::new(message, at.as_str(), "nothing of it can be printed").with_help(help));
    }
    for (reason, what) in [
        (Unfit::Impossible, "cannot happen"),
        (Unfit::Underdetermined, "leave something open"),
        (Unfit::BeyondMethods, "need more than exam methods"),
        (Unfit::NoValue, "give a formula no value"),
    ] {
        let (Some(count), Some(first)) = (census.unfit.get(&reason), census.first.get(&reason)) else { continue };
        let message = format!(
            "{count} of {} sets of numbers of style `{}` are turned away by no requirement and {what}, first {}",
            out_of(census.examined, census.size),
            style.name,
            numbers(style, *first)
        );
        let (named, why) = refusal(question, style, *first);
        let message = format!("{message}{}", why.as_ref().map_or_else(String::new, |why| format!(": {why}")));
        let (label, help) = match reason {
            Unfit::NoValue => ("of no value there", "require what gives it one: below a line `a - b` wants `a != b`"),
            Unfit::Underdetermined if why.as_ref().is_some_and(|why| why.contains("whatever")) => (
                "they are never dealt, and every deal has to try them",
                "require numbers with which some values meet the conditions and others do not",
            ),
            Unfit::Underdetermined => (
                "they are never dealt, and every deal has to try them",
                "require what determines it: a sphere that is at rest has no direction, and `A.after.speed > 0` says that \
                 it is not",
            ),
            _ => (
                "they are never dealt, and every deal has to try them",
                "require what makes the collision possible, in `require`",
            ),
        };
        let help = suggested::help(question, style, &reason).unwrap_or_else(|| help.to_owned());
        let key = named.map(|name| (style.name, name));
        let found = Finding { key, ..Finding::new(message, at.as_str(), label) };
        findings.push(found.with_help(help).as_warning());
    }
    findings
}

/// Requirements on what is given that turn no set of numbers away in any style that has them. What is required of results
/// guards against numbers that may be given later.
fn needless(question: &Question, tallies: &[Tally]) -> Vec<Finding> {
    // Of a style that was not examined to its end, or has no variant, nothing can be said.
    if tallies.iter().any(|tally| tally.census.examined < tally.census.size || tally.census.fit == 0) {
        return Vec::new();
    }
    let mut demands: BTreeMap<&str, bool> = BTreeMap::new();
    for (style, tally) in question.styles.iter().zip(tallies) {
        let is_given = |name: &str| question.is_given(style, name);
        let on_results = |demand: &Requirement| demand.is_on_results(&question.scene.unknowns, &is_given);
        for (place, requirement) in style.require.iter().enumerate().filter(|(_, demand)| !on_results(demand)) {
            let turns = tally.census.unfit.keys().any(|reason| reason.requirement() == Some(place));
            *demands.entry(requirement.text.as_str()).or_default() |= turns;
        }
    }
    let idle = demands.into_iter().filter(|(_, turns)| !turns);
    let found = |text: &str| {
        let message = format!("`{text}` turns no set of numbers away");
        let help = "take it out; or mend it, if it was meant to turn some away";
        Finding::new(message, format!("\"{text}\""), "nothing changes without it").with_help(help).as_warning()
    };
    idle.map(|(text, _)| found(text)).collect()
}

/// Why a set of numbers makes no collision, in words of mechanics; or which name has no value, and why.
fn refusal(question: &Question, style: &Style, index: u64) -> (Option<String>, Option<String>) {
    let posed = match Givens::new(style, &style.parameters_at(index), &question.scene) {
        Ok(givens) => Posed::new(question, style, givens),
        Err((name, fault)) => Err(Unposed::Given(name, fault)),
    };
    match posed {
        Err(Unposed::Refused(refusal)) => (None, Some(refusal.reason)),
        Err(Unposed::Given(name, fault)) => {
            let why = format!("`{name}`, {}", fault.message);
            (Some(name), Some(why))
        }
        _ => (None, None),
    }
}

/// Marks that measure nothing, and students who earn what is not due.
fn idle(question: &Question, coverage: &Coverage) -> Vec<Finding> {
    let name = |mark: &MarkCount| match mark.part.as_str() {
        "" => format!("the mark {}", mark.id),
        part => format!("the mark {} of part ({part})", mark.id),
    };
    let marks = coverage.idle().map(|mark| match mark.won {
        0 => at_mark(question, mark, format!("{} is never won, not even by the model solution", name(mark))),
        _ => {
            let message = format!("{} is never lost, not even by a student who hands in nothing", name(mark));
            at_mark(question, mark, message)
        }
    });
    let look =
        format!("`carom preview {}` shows its marks: does each stand for a step that the answers need?", question.id);
    let mut faults: Vec<(&CoverageFault, usize)> = Vec::new();
    for fault in &coverage.faults {
        match faults.iter_mut().find(|(first, _)| first.what == fault.what) {
            Some((_, more)) => *more += 1,
            None => faults.push((fault, 0)),
        }
    }
    let faults = faults.into_iter().map(|(fault, more)| {
        let more = match more {
            0 => String::new(),
            1 => "; one other fares the same".to_owned(),
            more => format!("; {more} others fare the same"),
        };
        let found = Finding::new(format!("{fault}{more}"), "marks", "not as this scheme is meant");
        let found = found.with_help(fault.help.as_deref().unwrap_or(look.as_str()));
        match fault.row {
            Some((part, list, row)) => found.at_row(part, list, row),
            None => found,
        }
    });
    marks.chain(faults).collect()
}

/// A finding at the row of a mark.
fn at_mark(question: &Question, mark: &MarkCount, message: String) -> Finding {
    let found = Finding::new(message, "", "it tells no student from another");
    let found = found.with_help("name the step that earns it with `for`, or take the row out");
    let Some(part) = question.parts.iter().position(|part| part.label == mark.part) else { return found };
    match question.parts[part].marks.iter().position(|row| row.id == mark.id) {
        Some(row) => found.at_row(part, "marks", row),
        None => found,
    }
}
