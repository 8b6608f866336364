//! A question looked at with one variant: what is amiss that needs no other variant to be seen.

use super::finding::Finding;
use super::{again, author, promise, words};
use crate::bank::Question;
use crate::diagnostic::Severity;
use crate::generate::Variant;
use crate::paper;

/// What must be mended of the words, of the author's own tests and of this variant. [`survey`](super::survey) finds it too,
/// and what shows in other variants and in scripts of students; this takes no time, and is for whoever writes the question.
pub fn glance(question: &Question, variant: &Variant) -> Vec<Finding> {
    let mut findings = again::reference_faults(question);
    findings.extend(author::disagreements(question));
    findings.extend(words::of_question(question));
    // The numbers of the exercise itself need not be those of a style.
    if let (Some(style), Some(_)) = (question.style(variant.style), variant.index) {
        findings.extend(words::contradicted(question, style, variant));
        let mut remarks = Vec::new();
        let words = paper::words(question, style, variant);
        words::of_variant(question, variant, &words, &mut words::Heard::default(), &mut remarks);
        promise::broken(question, variant, &words, &mut remarks);
        findings.extend(remarks.iter().map(|remark| remark.in_variant(style, variant.index)));
    }
    findings.retain(|finding| finding.severity == Severity::Error);
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};
    use crate::generate::{Deal, reference};

    #[test]
    fn nothing_is_amiss_with_a_sound_question() {
        for (id, _) in crate::bank::shipped() {
            let question = edited(id, &[]);
            let found = glance(&question, &reference(&question).unwrap());
            assert!(found.is_empty(), "{id}: {found:?}");
        }
    }

    #[test]
    fn what_one_variant_shows_is_found_at_once() {
        let id = "direct/one-sphere-catches-the-other";
        let table: [(Edits, &str); 4] = [
            (&[], ""),
            (&[("{mA kg} and {mB kg}", "{mB kg} and {mA kg}")], "give `*A*` the mass `mB`"),
            (
                &[("in the same direction", "towards each other")],
                "a direction that is not so: `B moves towards A`, with mA =",
            ),
            (&[("Find the speed of *B* immediately", "Find the speed of *A* immediately")], "ask of `*A*`"),
        ];
        for (edits, words) in table {
            let question = edited(id, edits);
            let variant = Deal::new(&question, &question.styles[0], 1).next().unwrap();
            let said: String = glance(&question, &variant).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{edits:?}: {said}");
        }
    }
}
