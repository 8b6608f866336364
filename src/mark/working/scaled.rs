//! Letters of the question that a student sets equal to one: `let u = 1 and m = 1`. What is worked out so is right but for
//! them, and they are put back in the answer.

use super::examine::{Examined, examine_one};
use super::lines::typed;
use super::theirs::Theirs;
use crate::bank::EarnedFor;
use crate::mark::award::Place;
use crate::mark::key::{KeyedMark, KeyedPart, KeyedQuestion};
use crate::mechanics::Quantity;
use crate::number::Range;

/// What stands in the place of a line that only chooses: it says nothing.
const CHOICE: &str = "let";

/// Words with which a letter is chosen.
const CHOOSE: [&str; 12] =
    ["let", "set", "take", "taking", "put", "putting", "letting", "setting", "suppose", "choose", "assume", "wlog"];

impl Examined {
    /// With the steps that are right where the letters are one that the student has set so. The marks of answers stay: they
    /// want their letters.
    pub(super) fn follow_scale(
        &mut self,
        question: &KeyedQuestion,
        part: &KeyedPart,
        working: &[String],
        before: &Theirs,
    ) {
        let letters = set_to_one(working, question);
        if letters.is_empty() {
            return;
        }
        let Some(own) = question.scaled(&letters) else { return };
        let Some(own_part) = own.parts.iter().find(|other| other.label == part.label) else { return };
        let chosen = |line: &str| !chosen_letters(line).is_empty();
        // The choice is no value.
        let blanked: Vec<String> =
            working.iter().map(|line| if chosen(line) { CHOICE.to_owned() } else { line.clone() }).collect();
        let scaled = examine_one(&own, own_part, &blanked, before, &[]);
        for ((mark, award), other) in part.scheme.iter().zip(&mut self.awards).zip(scaled.awards) {
            let is_choice = award.as_ref().and_then(|award| award.evidence.as_ref()).is_some_and(|evidence| {
                matches!(evidence.place, Place::Line(line) if line.checked_sub(1).and_then(|line| working.get(line)).is_some_and(|line| chosen(line)))
            });
            if is_choice || !is_of_an_answer(part, mark) && other.as_ref().is_some_and(|other| other.given) {
                *award = other;
            }
        }
        for line in &mut self.lines {
            if chosen(&line.typed) {
                line.role = String::new();
            } else if let Some(other) =
                scaled.lines.iter().find(|other| other.typed == line.typed && !other.role.is_empty())
            {
                line.role.clone_from(&other.role);
            }
        }
        let denies = self.denied.iter_mut().zip(scaled.denied);
        denies.for_each(|(denied, other)| *denied &= other);
        let denies = self.denies_velocities.iter_mut().zip(scaled.denies_velocities);
        denies.for_each(|(denied, other)| *denied &= other);
        self.denies_what_is_found &= scaled.denies_what_is_found;
        // What was found is something else until the letters are put back.
        self.theirs.values.clear();
        (self.end, self.followed, self.solution) = (None, None, None);
    }
}

/// Is the mark for a value that a blank asks for?
fn is_of_an_answer(part: &KeyedPart, mark: &KeyedMark) -> bool {
    let asked: Vec<Quantity> = part.blanks.iter().flat_map(|blank| blank.find.quantities()).collect();
    match &mark.earned_for {
        EarnedFor::Unknown(_) => true,
        earned_for => earned_for.quantities().iter().any(|own| asked.contains(own)),
    }
}

/// The letters of masses and speeds that are given which the working sets equal to one.
fn set_to_one(working: &[String], question: &KeyedQuestion) -> Vec<String> {
    let all = typed(working).flat_map(chosen_letters);
    let mut found: Vec<String> = all
        .filter(|letter| {
            question.given_letters.iter().any(|own| own.name() == *letter && own.range() == Range::Positive)
        })
        .map(str::to_owned)
        .collect();
    found.dedup();
    found
}

/// The letters that a line sets equal to one, `let v = 1, m = 1`; none if it says anything else too.
fn chosen_letters(line: &str) -> Vec<&str> {
    let is_chosen = |word: &str| CHOOSE.contains(&word.to_lowercase().as_str());
    let mut found = Vec::new();
    let mut is_begun = false;
    for clause in line.trim().trim_end_matches('.').split([',', ';', '&']).flat_map(|clause| clause.split(" and ")) {
        let Some((before, value)) = clause.split_once('=') else { return Vec::new() };
        let mut words = before.split_whitespace().rev();
        let Some(letter) = words.next() else { return Vec::new() };
        is_begun |= before.split_whitespace().any(is_chosen);
        let value = value.trim();
        if !is_begun
            || !words.all(|word| is_chosen(word) || word == "we")
            || !(value == "1" || value.starts_with("1 for "))
        {
            return Vec::new();
        }
        found.push(letter);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::chosen_letters;

    #[test]
    fn letters_are_set_to_one_in_so_many_words() {
        assert_eq!(chosen_letters("Let v = 1, m = 1"), ["v", "m"]);
        assert_eq!(chosen_letters("set u=1 and m=1 for simplicity."), ["u", "m"]);
        for other in ["v = 1", "let v = 2", "let v = 1, w = 2v", "let v be 1", "Let e = 1/2", ""] {
            assert!(chosen_letters(other).is_empty(), "{other}");
        }
    }
}
