//! A person's word on single marks, and what follows from it for the marks that depend on them.

use super::decide::settled;
use crate::mark::award::{Examiner, MarkedPart};
use crate::mark::key::KeyedPart;

/// A person's word on one mark of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The place of the mark in the scheme.
    pub mark: usize,
    /// Is it given?
    pub given: bool,
    /// Why; may be empty.
    pub comment: String,
}

/// Gives and withholds marks as a person says; of several words on the same mark the last counts.
///
/// Dependent marks follow: one that was withheld only for want of a mark that is given now is given too, and one falls
/// with the mark on which it depends. A mark on which a person has spoken is as that person says.
pub fn overrule(part: &KeyedPart, marked: &mut MarkedPart, words: &[Word]) {
    for word in words {
        let Some(award) = marked.found.get_mut(word.mark) else { continue };
        award.given = word.given;
        award.by = Examiner::Person;
        award.note = None;
        award.feedback = word.comment.clone();
    }
    marked.awards = settled(part, &marked.answers, &marked.found);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mark::key::AnswerKey;
    use crate::mark::{PartScript, Profile, Script, mark};

    /// Scheme: B1a M1a A1a M1b A1b M1c A1c A1d M1d A1e A1f, where A1a needs M1a, A1b M1b, M1c both, A1c and A1d M1c, A1e and
    /// A1f M1d.
    fn key() -> AnswerKey {
        crate::mark::shipped_key("rest/speeds-and-directions", 1)
    }

    #[test]
    fn marks_that_depend_on_a_persons_word_follow_it() {
        let key = key();
        let question = &key.papers[0].questions[0];
        let part = &question.parts[0];
        let script = Script { parts: vec![PartScript::default()], ..Script::default() };
        // What the marker found mark by mark, a person's words, and what stands in the end.
        let cases = [
            ("", "", ""),
            ("A1a", "", ""),
            ("A1a", "M1a+", "M1a A1a"),
            ("A1a A1b A1c", "M1a+ M1c+", "M1a A1a M1c A1c"),
            ("M1c A1c A1d", "M1a+", "M1a"),
            ("M1c A1c A1d", "M1a+ M1b+", "M1a M1b M1c A1c A1d"),
            ("M1a A1a M1b A1b M1c A1c", "M1a-", "M1b A1b"),
            ("M1a A1a M1b A1b M1c A1c", "M1a- A1c+", "M1b A1b A1c"),
            ("M1a A1a", "M1a- M1a+", "M1a A1a"),
            ("M1d A1e A1f", "A1f-", "M1d A1e"),
        ];
        for (found, said, expected) in cases {
            let mut marked = mark(question, &script, &Profile::default()).remove(0);
            for award in &mut marked.found {
                award.given = found.split_whitespace().any(|id| id == award.id);
            }
            let place = |id: &str| part.scheme.iter().position(|mark| mark.id == id).unwrap();
            let words = said.split_whitespace().map(|word| {
                let (id, given) = word.split_at(word.len() - 1);
                Word { mark: place(id), given: given == "+", comment: "seen".to_owned() }
            });
            overrule(part, &mut marked, &words.collect::<Vec<_>>());
            let given = marked.awards.iter().filter(|award| award.given);
            let given: Vec<&str> = given.map(|award| award.id.as_str()).collect();
            assert_eq!(given.join(" "), expected, "{found} and {said}");
            let by_person = |award: &crate::mark::Award| award.by == Examiner::Person;
            assert!(marked.awards.iter().filter(|award| by_person(award)).all(|award| award.feedback == "seen"));
            assert_eq!(marked.awards.iter().any(by_person), !said.is_empty());
        }
    }
}
