//! One number of the question copied wrongly, and then used throughout: the script is marked as if the question had it so,
//! and that costs no more accuracy marks than the profile says.
//!
//! The board's rule is for a misreading that makes the question no easier. What earns a mark of the question as it was
//! printed keeps it; of the marks that only the question as it was read gives, so many for accuracy are lost, the first.

use super::as_printed;
use super::decide::settled;
use super::memory::Memory;
use crate::bank::Code;
use crate::mark::award::{Award, Evidence, MarkedAnswer, MarkedPart, Place};
use crate::mark::judging::Verdict;
use crate::mark::key::KeyedQuestion;
use crate::mark::profile::Profile;
use crate::mark::script::Script;
use crate::mark::working::Misread;

/// The note of what is right for the number as it was copied.
const NOTE: &str = "number-misread";

/// Gives what the script earns by the question as the student has read it, but for the marks that this costs.
pub(super) fn follow(
    question: &KeyedQuestion,
    script: &Script,
    profile: &Profile,
    misread: &Misread,
    marked: &mut Vec<MarkedPart>,
) {
    let as_read = question.with_misread(misread).into_iter().map(|own| {
        let as_read = as_printed(&own, script, profile, &mut Memory::default()).0;
        joined(question, profile, marked, &as_read)
    });
    let best = as_read.flatten().max_by_key(|parts| parts.iter().map(MarkedPart::marks).sum::<usize>());
    let now = marked.iter().map(MarkedPart::marks).sum::<usize>();
    if let Some(best) = best.filter(|best| best.iter().map(MarkedPart::marks).sum::<usize>() > now) {
        *marked = best;
    }
}

/// Both together; nothing if a line that is right as the question is printed is not right as it was read, for then the number
/// was not copied wrongly throughout.
fn joined(
    question: &KeyedQuestion,
    profile: &Profile,
    printed: &[MarkedPart],
    read: &[MarkedPart],
) -> Option<Vec<MarkedPart>> {
    let is_of_line = |award: &Award| {
        award.given
            && matches!(award.evidence, Some(Evidence { place: Place::Line(_), .. }))
            && award.note != Some(NOTE)
    };
    let mut both = printed.iter().zip(read).flat_map(|(one, other)| one.found.iter().zip(&other.found));
    if both.any(|(one, other)| is_of_line(one) && !other.given) {
        return None;
    }
    let mut lost = 0;
    let each = question.parts.iter().zip(printed.iter().zip(read)).map(|(part, (one, other))| {
        let award = |(own, other): (&Award, &Award)| {
            if own.given || !other.given || own.code == Code::A1Shown {
                return own.clone();
            }
            if !own.code.is_method() && lost < profile.misread {
                lost += 1;
                return Award { note: Some(NOTE), ..own.clone() };
            }
            let feedback = "right for the number as you have copied it".to_owned();
            Award { note: Some(NOTE), feedback, ..other.clone() }
        };
        let found: Vec<Award> = one.found.iter().zip(&other.found).map(award).collect();
        let answers: Vec<MarkedAnswer> = one.answers.iter().zip(&other.answers).map(answer).collect();
        let awards = settled(part, &answers, &found);
        MarkedPart { answers, awards, found, ..one.clone() }
    });
    Some(each.collect())
}

/// An answer that is right for the number as it was copied says so, and what else is amiss with it.
fn answer((own, other): (&MarkedAnswer, &MarkedAnswer)) -> MarkedAnswer {
    let feedback = match (own.judgement.verdict, other.judgement.verdict) {
        (Verdict::Correct, _) => return own.clone(),
        (_, Verdict::Correct) => "Right for the number of the question as you have copied it.".to_owned(),
        (Verdict::Partial, _) => return own.clone(),
        (_, Verdict::Partial) => {
            let mut signs = other.judgement.feedback.chars();
            let first = signs.next().map(|first| first.to_ascii_lowercase());
            let rest: String = first.into_iter().chain(signs).collect();
            format!("For the number of the question as you have copied it: {rest}")
        }
        _ => return own.clone(),
    };
    let mut answer = own.clone();
    answer.judgement.verdict = Verdict::Partial;
    answer.judgement.note = Some(NOTE);
    answer.judgement.feedback = feedback;
    answer.causes.clear();
    answer
}
