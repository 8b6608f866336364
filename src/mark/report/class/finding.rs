//! What looks wrong with a question: too hard, too easy, marks that the weak win and the strong do not, answers that cannot
//! be read, one wrong value from many.

use super::entries::Class;
use super::question::{MarkFigures, QuestionFigures};
use super::same_value;
use crate::mark::slips;

/// With fewer scripts nothing is said of how hard a question was.
const FEWEST: usize = 5;

/// At most so much of a question is earned where it is too hard, in per cent; at least so much where it is too easy.
const HARD: usize = 15;
const EASY: usize = 95;

/// So many students at least cannot be chance.
const SEVERAL: usize = 3;

/// Something that looks wrong with a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// A fixed tag: `unanswered`, `hard`, `easy`, `never-won`, `against`, `unreadable`, `same-value`.
    pub tag: &'static str,
    /// The question's place among all.
    pub question: usize,
    /// What was found, in a sentence.
    pub sentence: String,
}

/// All that was found, by question.
pub(super) fn all(class: &Class, questions: &[QuestionFigures]) -> Vec<Finding> {
    let of_one = |(place, question): (usize, &QuestionFigures)| {
        let mut said: Vec<(&'static str, String)> = Vec::new();
        said.extend(unanswered(question));
        said.extend(level(question));
        said.extend(never_won(question));
        said.extend(against(question));
        said.extend(unreadable(question));
        let least = SEVERAL.max(question.scripts.div_ceil(10));
        said.extend(same_value::all(class, place, least).into_iter().map(|same| ("same-value", same.in_words())));
        said.into_iter().map(move |(tag, sentence)| Finding { tag, question: place, sentence })
    };
    questions.iter().enumerate().flat_map(of_one).collect()
}

/// A question that nobody wrote anything for says nothing of the students, and nothing of itself.
fn unanswered(question: &QuestionFigures) -> Option<(&'static str, String)> {
    let is_said = question.scripts >= FEWEST && question.answered == 0;
    is_said.then(|| ("unanswered", "Nobody wrote anything for it: are the answers filled in?".to_owned()))
}

fn level(question: &QuestionFigures) -> Option<(&'static str, String)> {
    let facility = question.facility();
    let all = question.scripts;
    if all < FEWEST || question.available == 0 || question.answered == 0 {
        return None;
    }
    if facility <= HARD {
        let won = if question.marks == 0 { "None".to_owned() } else { format!("Only {facility}%") };
        return Some(("hard", format!("{won} of its marks were won: is it too hard, or is it misread?")));
    }
    let is_easy = facility >= EASY;
    is_easy.then(|| ("easy", format!("{facility}% of its marks were won: it tells nobody from anybody.")))
}

/// Marks that nobody won, though the question was not too hard as a whole.
fn never_won(question: &QuestionFigures) -> Option<(&'static str, String)> {
    if question.scripts < FEWEST || question.facility() <= HARD {
        return None;
    }
    let marks = named(question, |mark| mark.won == 0)?;
    Some(("never-won", format!("Nobody won {marks}.")))
}

fn against(question: &QuestionFigures) -> Option<(&'static str, String)> {
    let marks = named(question, |mark| mark.discrimination.is_against(question.scripts))?;
    Some(("against", format!("Won more by those who earned less elsewhere: {marks}. Look at its wording and its key.")))
}

fn unreadable(question: &QuestionFigures) -> Option<(&'static str, String)> {
    let count = question.unreadable;
    let many = count >= SEVERAL && 5 * count >= question.scripts;
    let all = question.scripts;
    many.then(|| {
        (
            "unreadable",
            format!("{count} of {all} students wrote something that cannot be read: say what form is wanted."),
        )
    })
}

/// The marks of a question that are of some kind: `A1a and M1b of (a), B1a of (b)`.
fn named(question: &QuestionFigures, is_it: impl Fn(&MarkFigures) -> bool) -> Option<String> {
    let mut parts: Vec<(&str, Vec<&str>)> = Vec::new();
    for mark in question.scheme.iter().filter(|mark| is_it(mark)) {
        match parts.last_mut() {
            Some((part, marks)) if *part == mark.part => marks.push(&mark.id),
            _ => parts.push((&mark.part, vec![&mark.id])),
        }
    }
    let each = parts.iter().map(|(part, marks)| match part.is_empty() {
        true => marks.join(", "),
        false => format!("{} of ({part})", marks.join(", ")),
    });
    let all = each.collect::<Vec<_>>().join("; ");
    (!all.is_empty()).then_some(all)
}

impl same_value::SameValue {
    fn in_words(&self) -> String {
        let part = if self.part.is_empty() { String::new() } else { format!("({}) ", self.part) };
        let (students, value, blank, right) = (self.students, &self.value, &self.blank, &self.right);
        let mistakes = slips::all();
        let did: Vec<&str> = self
            .cause
            .split('+')
            .filter_map(|tag| mistakes.iter().find(|slip| slip.tag == tag).map(|slip| slip.did))
            .collect();
        let why = match did.is_empty() {
            true => "no known mistake leads there, so look at the question and its key".to_owned(),
            false => format!("they probably {}", did.join(", and ")),
        };
        format!("{part}{students} students gave {value} for {blank}, where {right} is right: {why}.")
    }
}
