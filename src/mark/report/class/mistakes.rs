//! Which mistakes were made, and by whom.
//!
//! They come from the likeliest cause of each wrong answer, from the reason for which each mark of working was lost, and,
//! where figures are concerned, from the notes on answers. Within a part a mistake counts once, wherever it shows.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use super::entries::Class;
use crate::mark::report::MarkedUnder;
use crate::mark::slips;

/// A mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// A fixed tag: `sincos-swap`.
    pub tag: &'static str,
    /// What the student did: `left the masses out`.
    pub did: &'static str,
    /// The students who made it, as places among all, each once.
    pub students: Vec<usize>,
    /// Where it was made.
    pub places: Vec<Made>,
}

/// Where a mistake was made.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Made {
    /// The student's place among all.
    pub student: usize,
    /// The question's place among all.
    pub question: usize,
    /// The label of the part.
    pub part: String,
}

/// What is lost for its figures.
const ACCURACY: [(&str, &str); 8] = [
    ("under-accurate", "gave too few figures"),
    ("too-few-figures", "gave a single figure"),
    ("truncated", "cut a number off in place of rounding it"),
    ("early-rounding", "rounded before the last line"),
    ("near-miss", "was less than 1 % off"),
    ("exact-wanted", "gave a decimal where the exact value is wanted"),
    ("later-figures", "went on after the right figures with wrong ones"),
    ("inaccurate", "put a number that is not accurate enough into an equation"),
];

/// What lines of working show and answers do not.
const OF_WORKING: [(&str, &str); 10] = [
    ("sign-error", "wrote a wrong sign in an equation"),
    ("e-misread", "took another e than the one that is given"),
    ("number-misread", "copied a number of the question wrongly"),
    ("brackets-lost", "did not multiply a factor into all of its bracket"),
    ("weights-for-masses", "took weights for the masses"),
    ("term-missing", "left a term out of an equation"),
    ("mass-missing", "left a mass out of one term"),
    ("velocity-elsewhere", "took the velocity of another sphere, or of another moment"),
    ("letter-missing", "left out a letter of the question"),
    ("inequality-reversed", "turned an inequality the wrong way round"),
];

/// Slips, and what was lost for figures, those of the most students first.
pub(super) fn made(class: &Class) -> (Vec<Mistake>, Vec<Mistake>) {
    let mut known: BTreeMap<&'static str, &'static str> =
        slips::all().into_iter().map(|slip| (slip.tag, slip.did)).collect();
    known.extend(OF_WORKING.iter().chain(&ACCURACY).copied());
    let mut found: BTreeMap<&'static str, Mistake> = BTreeMap::new();
    for (student, entry) in class.entries.iter().enumerate() {
        let scripts = entry.scripts.iter().enumerate().filter_map(|(place, script)| Some((place, (*script)?)));
        for (question, part) in scripts.flat_map(|(place, script)| script.parts.iter().map(move |part| (place, part))) {
            let tags: BTreeSet<&str> = tags(part).collect();
            for (tag, did) in tags.iter().filter_map(|tag| known.get_key_value::<str>(tag)) {
                let mistake =
                    found.entry(tag).or_insert_with(|| Mistake { tag, did, students: Vec::new(), places: Vec::new() });
                if mistake.students.last() != Some(&student) {
                    mistake.students.push(student);
                }
                mistake.places.push(Made { student, question, part: part.marked.label.clone() });
            }
        }
    }
    let mut all: Vec<Mistake> = found.into_values().collect();
    all.sort_by_key(|mistake| (Reverse(mistake.students.len()), Reverse(mistake.places.len())));
    all.into_iter().partition(|mistake| ACCURACY.iter().all(|(tag, _)| *tag != mistake.tag))
}

/// The tags of what went wrong in a part, and of much else.
fn tags<'r>(part: &'r MarkedUnder) -> impl Iterator<Item = &'r str> {
    let answers = &part.marked.answers;
    let causes = answers.iter().filter_map(|answer| answer.causes.first()).flat_map(|cause| cause.tag.split('+'));
    // Of two marks lost for one line each may name its reason; one that is given names none that matters.
    let lost = part.marked.awards.iter().filter(|award| !award.given).filter_map(|award| award.note);
    let noted = answers.iter().filter_map(|answer| answer.judgement.note);
    causes.chain(lost).chain(noted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reason_for_which_working_loses_a_mark_is_a_mistake_in_words() {
        let page = include_str!("../../../../docs/marking.md");
        let table = page.split("| tag | reason | loses |").nth(1).unwrap().split("\n\n").next().unwrap();
        let tags: Vec<&str> = table.lines().filter_map(|row| row.strip_prefix("| `")?.split('`').next()).collect();
        assert!(tags.len() > 10, "{tags:?}");
        let slips = slips::all();
        for tag in tags {
            let is_known = OF_WORKING.iter().chain(&ACCURACY).any(|(known, _)| *known == tag);
            assert!(is_known || slips.iter().any(|slip| slip.tag == tag), "{tag}");
        }
    }

    #[test]
    fn every_note_on_figures_is_one_that_the_judge_gives() {
        use crate::mark::judging::Note;
        let of_others = [slips::EARLY_ROUNDING, "inaccurate"];
        for (tag, _) in ACCURACY {
            assert!(of_others.contains(&tag) || Note::ALL.iter().any(|note| note.tag() == tag), "{tag}");
        }
    }
}
