//! A script marked: answers judged, working looked through, every mark of the scheme given or withheld.
//!
//! In the order of an examiner. Each blank is judged. A right answer earns all marks that lead to it, but never those of
//! a result that was to be shown. What is still open is looked for in the working, and an answer that follows from the
//! student's own earlier values is followed through. Then marks that depend on others fall with them, and what costs a
//! mark only once in a question is charged once.

mod answers;
mod beside;
mod by_lines;
mod causes;
mod components;
mod decide;
mod exchanged;
mod follow;
mod given_masses;
mod last_lines;
mod last_word;
mod left;
mod luck;
mod memory;
mod misread;
mod overrule;
mod rounded;
mod withhold;

pub use follow::from_own_values;
use memory::Lines;
pub(super) use memory::Memory;
pub use overrule::{Word, overrule};

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::award::{Award, Evidence, MarkedAnswer, MarkedLine, MarkedPart, Place};
use super::judging::Verdict;
use super::key::{KeyedMark, KeyedPart, KeyedQuestion};
use super::profile::Profile;
use super::script::{PartScript, Script};
use super::working::{Misread, Theirs, examine};
use crate::bank::{Code, Find};
use crate::expr::Expr;
use crate::mechanics::{Axis, Quantity};

/// Marks what a student handed in for a question: a [`MarkedPart`] for each part, in the order of the key.
///
/// What the script has under a label that the question does not have is not looked at.
pub fn mark(question: &KeyedQuestion, script: &Script, profile: &Profile) -> Vec<MarkedPart> {
    mark_remembering(question, script, profile, &mut Memory::default())
}

/// The same for the scripts of many students; what was found of an answer is remembered.
pub fn mark_each<'s>(
    question: &KeyedQuestion,
    scripts: impl IntoIterator<Item = &'s Script>,
    profile: &Profile,
) -> Vec<Vec<MarkedPart>> {
    let mut memory = Memory::default();
    scripts.into_iter().map(|script| mark_remembering(question, script, profile, &mut memory)).collect()
}

/// The same by one who remembers what was found of the answers before, all of them by this profile.
pub(super) fn mark_remembering(
    question: &KeyedQuestion,
    script: &Script,
    profile: &Profile,
    memory: &mut Memory,
) -> Vec<MarkedPart> {
    or_for_a_person(script, |script| looked_through(question, script, profile, memory))
}

/// Marks a script, or what stands in its place if the marker itself breaks: that is a fault of Carom, and for one answer
/// a class is not left without marks. Every answer is then one that cannot be read, and goes to a person.
fn or_for_a_person(script: &Script, mut mark: impl FnMut(&Script) -> Vec<MarkedPart>) -> Vec<MarkedPart> {
    /// What nobody can read.
    const UNREADABLE: &str = "\u{fffd}";
    // What is remembered is whole at any moment: an answer is entered when all is known of it.
    if let Ok(marked) = catch_unwind(AssertUnwindSafe(|| mark(script))) {
        return marked;
    }
    let mut blotted = script.clone();
    for part in &mut blotted.parts {
        part.answers.iter_mut().for_each(|(_, answer)| UNREADABLE.clone_into(answer));
        part.working.clear();
    }
    let mut marked = mark(&blotted);
    for part in &mut marked {
        let handed_in = together(script, &part.label);
        let line = |typed: &String| MarkedLine { typed: typed.clone(), reading: None, role: String::new() };
        part.lines = handed_in.working.iter().map(line).collect();
        for answer in part.answers.iter_mut().filter(|answer| answer.typed.is_some()) {
            let named =
                |name: &Option<String>| name.as_deref().is_none_or(|name| answers::is_name_of(name, &answer.name));
            let typed = handed_in.answers.iter().rev().find(|(name, _)| named(name));
            answer.typed = typed.map(|(_, typed)| typed.clone());
        }
    }
    marked
}

/// Everything in the order of an examiner, and once more where a number of the question was copied wrongly.
fn looked_through(
    question: &KeyedQuestion,
    script: &Script,
    profile: &Profile,
    memory: &mut Memory,
) -> Vec<MarkedPart> {
    let (mut marked, misread) = as_printed(question, script, profile, memory);
    if let Some(misread) = misread {
        misread::follow(question, script, profile, &misread, &mut marked);
    }
    marked
}

/// A script marked by the question as it is printed, and a number that was copied wrongly out of it.
fn as_printed(
    question: &KeyedQuestion,
    script: &Script,
    profile: &Profile,
    memory: &mut Memory,
) -> (Vec<MarkedPart>, Option<Misread>) {
    let mut charged = decide::Charged::default();
    let mut theirs = Theirs::default();
    let mut is_unknown_wrong = false;
    let mut by_lines = by_lines::ByLines::default();
    let mut marked = Vec::new();
    let mut misread = None;
    for part in &question.parts {
        let mut handed_in = together(script, &part.label);
        take_derivation(part, &mut handed_in);
        let mut examined = examine(question, part, &handed_in.working, &theirs);
        let lines = Lines::of(question);
        let (mut answers, judged) = answers::judged(part, &handed_in, profile, memory, &examined, &lines);
        last_word::contradict(question, part, &handed_in, &examined, &lines, &mut answers);
        let read = beside::HandedIn { script: &handed_in, lines: &lines, judged: &judged };
        beside::point_out(question, part, &read, &theirs, &examined, &mut answers);
        let readings = judged.iter().map(|judged| judged.readings.as_deref());
        last_word::take_figures_from_working(part, &handed_in, &examined, &lines, &mut answers);
        examined.see_in_answers(question, part, &theirs, readings);
        let followed = follow::answers(question, part, &answers, &judged, &examined);
        follow::say(&mut answers, &followed);
        by_lines = by_lines.go_on(question, part, &examined);
        let is_wrong_before = theirs.wrong(question).next().is_some();
        let seen = causes::Seen { by_lines: &by_lines, is_wrong_before, is_unknown_wrong, followed: &followed };
        causes::name(question, part, &mut answers, &judged, &examined, &seen);
        exchanged::name_first(part, &mut answers, &judged);
        let is_unknown = |place: usize| matches!(part.blanks[place].find, Find::Unknown(_));
        let is_wrong = |answer: &MarkedAnswer| answer.judgement.verdict == Verdict::Wrong;
        is_unknown_wrong |= answers.iter().enumerate().any(|(place, answer)| is_unknown(place) && is_wrong(answer));
        let by_working = std::mem::take(&mut examined.awards);
        let needed = question.needed(part);
        let contradicted = contradicted(question, part, &theirs, &examined.theirs);
        let wrong = examined.theirs.wrong(question).count();
        let has_right_value = examined.theirs.values.len() > wrong;
        let by_luck = luck::is_by_luck(question, part, &examined);
        let found = decide::Findings {
            needed,
            answers: &answers,
            by_working,
            followed: &followed,
            contradicted,
            has_right_value,
            denies_velocities: examined.denies_velocities,
            by_luck,
        };
        let found = decide::awards(part, found, profile, &mut charged);
        let awards = decide::settled(part, &answers, &found);
        say_shown(part, &awards, &mut answers);
        without_marks_lost(&awards, &mut answers);
        let all_right = awards.iter().all(|award| award.given);
        let own = if all_right { Vec::new() } else { examined.theirs.to_go_on_from(question) };
        theirs = examined.theirs;
        theirs.take_answers(question, part, judged.iter().map(|judged| judged.readings.as_deref()));
        misread = misread.or(examined.misread);
        let (label, lines) = (part.label.clone(), examined.lines);
        marked.push(MarkedPart { label, answers, lines, awards, found, own });
    }
    (marked, misread)
}

/// Of a mark that a line has lost it is not said that it was probably earned.
fn without_marks_lost(awards: &[Award], answers: &mut [MarkedAnswer]) {
    let is_lost = |id: &String| {
        let lost =
            |award: &&Award| !award.given && matches!(&award.evidence, Some(Evidence { place: Place::Line(_), .. }));
        awards.iter().filter(lost).any(|award| award.id == *id)
    };
    for cause in answers.iter_mut().flat_map(|answer| &mut answer.causes) {
        cause.probable.retain(|id| !is_lost(id));
    }
}

/// Who has shown a result is not told that it is only the printed line written once more.
fn say_shown(part: &KeyedPart, awards: &[Award], answers: &mut [MarkedAnswer]) {
    let shown = part.scheme.iter().zip(awards).filter(|(mark, award)| mark.code == Code::A1Shown && award.given);
    for place in shown.flat_map(|(mark, _)| mark.blanks.iter().copied()) {
        if answers::is_shown(&part.blanks[place]) {
            let judgement = &mut answers[place].judgement;
            (judgement.verdict, judgement.note) = (Verdict::Correct, None);
            judgement.feedback = "Right.".to_owned();
            answers[place].causes.clear();
        }
    }
}

/// For each mark: does the working of this part state another value than the one that it is for? Then no answer implies it.
fn contradicted(question: &KeyedQuestion, part: &KeyedPart, before: &Theirs, now: &Theirs) -> Vec<bool> {
    let wrong: Vec<Quantity> = now.wrong(question).map(|(quantity, _)| quantity).collect();
    let is_stated = |quantity| wrong.contains(&quantity) && !before.values.contains_key(&quantity);
    let is_another = |quantity: &Quantity| is_stated(*quantity) || is_stated(question.prepared().along(*quantity));
    // Of a vector either component may be another.
    let is_beside = |own: &Quantity, other: &Quantity| match (own.of_its_impact(), other.of_its_impact()) {
        (Quantity::Velocity(sphere, moment, Axis::X), beside) => {
            own.impact() == other.impact() && beside == Quantity::Velocity(sphere, moment, Axis::Y)
        }
        _ => false,
    };
    let is_vector = |mark: &KeyedMark| match &mark.equation {
        Some(Expr::Relation(_, _, right)) => matches!(**right, Expr::Vector(..)),
        equation => matches!(equation, Some(Expr::Vector(..))),
    };
    let has_another_beside = |own: &Quantity| wrong.iter().any(|other| is_beside(own, other) && is_stated(*other));
    let states_another = |mark: &KeyedMark| {
        let quantities = mark.earned_for.quantities();
        quantities.iter().any(is_another) || is_vector(mark) && quantities.iter().any(has_another_beside)
    };
    part.scheme.iter().map(states_another).collect()
}

/// All that was handed in under a label.
fn together(script: &Script, label: &str) -> PartScript {
    let mut all = PartScript { label: label.to_owned(), ..PartScript::default() };
    for part in script.parts.iter().filter(|part| part.label.trim().trim_matches(['(', ')']) == label) {
        all.answers.extend(part.answers.iter().cloned());
        all.working.extend(part.working.iter().cloned());
    }
    all
}

/// What leads to a result that is to be shown is working, though it was typed in the place of the result: a chain, or several
/// steps.
fn take_derivation(part: &KeyedPart, handed_in: &mut PartScript) {
    let shown = || part.blanks.iter().filter(|blank| answers::is_shown(blank));
    let is_of_shown = |name: &Option<String>| {
        shown().any(|blank| name.as_deref().is_none_or(|name| answers::is_name_of(name, &blank.name)))
    };
    let is_derivation = |typed: &str| typed.matches('=').count() > 1;
    let derivations = handed_in.answers.iter().filter(|(name, typed)| is_of_shown(name) && is_derivation(typed));
    let derivations: Vec<String> = derivations.map(|(_, typed)| typed.clone()).collect();
    handed_in.working.extend(derivations);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_breaks_the_marker_goes_to_a_person_and_no_farther() {
        let key = crate::mark::shipped_key("rest/speeds-and-directions", 1);
        let question = &key.papers[0].questions[0];
        let name = &question.parts[0].blanks[0].name;
        let part = PartScript {
            answers: vec![(Some(name.clone()), "3".to_owned()), (Some(name.clone()), "breaks".to_owned())],
            working: vec!["v = 3".to_owned()],
            ..PartScript::default()
        };
        let script = Script { parts: vec![part], ..Script::default() };
        let breaks = |script: &Script| script.parts[0].answers.iter().any(|(_, typed)| typed == "breaks");
        let marked = or_for_a_person(&script, |script| {
            assert!(!breaks(script), "on purpose");
            mark(question, script, &Profile::default())
        });
        let [first, rest @ ..] = marked[0].answers.as_slice() else { panic!("no blanks") };
        assert_eq!((first.typed.as_deref(), first.judgement.verdict), (Some("breaks"), Verdict::Unreadable));
        assert!(rest.iter().all(|answer| answer.typed.is_none() && answer.judgement.verdict == Verdict::Blank));
        assert_eq!(marked[0].lines.iter().map(|line| line.typed.as_str()).collect::<Vec<_>>(), ["v = 3"]);
        assert!(marked[0].awards.iter().all(|award| !award.given));
    }
}
