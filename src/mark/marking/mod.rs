//! A script marked: answers judged, working looked through, every mark of the scheme given or withheld.
//!
//! In the order of an examiner. Each blank is judged. A right answer earns all marks that lead to it, but never those of
//! a result that was to be shown. What is still open is looked for in the working, and an answer that follows from the
//! student's own earlier values is followed through. Then marks that depend on others fall with them, and what costs a
//! mark only once in a question is charged once.

mod answers;
mod causes;
mod decide;
mod follow;
mod memory;
mod overrule;

pub(super) use memory::Memory;
pub use overrule::{Word, overrule};

use super::award::MarkedPart;
use super::key::KeyedQuestion;
use super::profile::Profile;
use super::script::{PartScript, Script};
use super::working::{Theirs, examine};

/// Marks what a student handed in for a question: a [`MarkedPart`] for each part, in the order of the key.
///
/// What the script has under a label that the question does not have is not looked at.
pub fn mark(question: &KeyedQuestion, script: &Script, profile: &Profile) -> Vec<MarkedPart> {
    mark_remembering(question, script, profile, &mut Memory::default(), Solutions::Written)
}

/// Is the rest written out as it follows from the student's own values, where marks are followed through?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Solutions {
    /// For whoever reads a page about it.
    Written,
    /// A table of marks has no place for them.
    LeftOut,
}

/// The same by one who remembers what was found of the answers before, all of them by this profile.
pub(super) fn mark_remembering(
    question: &KeyedQuestion,
    script: &Script,
    profile: &Profile,
    memory: &mut Memory,
    solutions: Solutions,
) -> Vec<MarkedPart> {
    let mut charged = decide::Charged::default();
    let mut theirs = Theirs::default();
    let mut marked = Vec::new();
    for part in &question.parts {
        let handed_in = together(script, &part.label);
        let (mut answers, judged) = answers::judged(part, &handed_in, profile, memory);
        let mut examined = examine(question, part, &handed_in.working, &theirs);
        let followed = follow::answers(question, part, &answers, &judged, &examined);
        follow::say(&mut answers, &followed);
        causes::name(question, part, &mut answers, &judged, &examined);
        let by_working = std::mem::take(&mut examined.awards);
        let needed = question.needed(part);
        let found = decide::Findings { needed, answers: &answers, by_working, followed: &followed };
        let found = decide::awards(part, found, profile, &mut charged);
        let awards = decide::settled(part, &answers, &found);
        let all_right = awards.iter().all(|award| award.given);
        let solution = match solutions {
            Solutions::Written if !all_right => follow::solution(question, part, &examined),
            _ => Vec::new(),
        };
        theirs = examined.theirs;
        theirs.take_answers(question, part, judged.iter().map(|judged| judged.readings.as_deref()));
        let (label, lines) = (part.label.clone(), examined.lines);
        marked.push(MarkedPart { label, answers, lines, awards, found, followed: solution });
    }
    marked
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
