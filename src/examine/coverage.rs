//! A question marked as handed in by students that Carom writes itself: right ones in many notations, ones that make a
//! known mistake, ones that hand in nothing or nonsense. What each of them must earn is known, so a marker or a mark scheme
//! that gives something else is found out. A mark that nobody wins, or nobody loses, measures nothing.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::students::{ENDS_COUNTED, Expected, Student, students};
use crate::bank::Question;
use crate::expr::print;
use crate::generate::Variant;
use crate::mark::judging::{Note, Verdict};
use crate::mark::{AnswerKey, Award, KeyedQuestion, MarkedPart, Profile, mark_each};
use crate::paper::{Key, compose, key_question};

/// How often each mark of a question was won and lost, and what was marked otherwise than it must be.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// The marks of all parts, in the order of the scheme.
    pub marks: Vec<MarkCount>,
    /// How many scripts were marked.
    pub scripts: usize,
    /// Scripts that earned what they must not, or not what they must.
    pub faults: Vec<Fault>,
}

/// A script that was not marked as it must be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is amiss with its marks: `the mark A1a of part (a) is not given`.
    pub what: String,
    /// Whose it is: `a right answer in exact form`.
    pub who: String,
    /// What stands in it.
    pub wrote: String,
    /// The numbers of the variant in which it was written.
    pub with: String,
    /// The part, its list and the row there of what is amiss.
    pub row: Option<(usize, &'static str, usize)>,
    /// One thing to try, where the answers tell it.
    pub help: Option<String>,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} for {}", self.what, self.who)?;
        if !self.wrote.is_empty() {
            write!(f, ": `{}`", self.wrote)?;
        }
        if self.with.is_empty() { Ok(()) } else { write!(f, ", with {}", self.with) }
    }
}

/// A mark with how it fared.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MarkCount {
    /// The part: `a`, `b`, … or empty.
    pub part: String,
    /// The mark's id: `M1a`.
    #[serde(rename = "mark")]
    pub id: String,
    /// How many won it.
    pub won: usize,
    /// How many lost it.
    pub lost: usize,
}

impl Coverage {
    /// Marks that nobody won, or nobody lost.
    pub fn idle(&self) -> impl Iterator<Item = &MarkCount> {
        self.marks.iter().filter(|mark| mark.won == 0 || mark.lost == 0)
    }

    /// Adds what another variant of the same question showed.
    pub fn add(&mut self, other: Coverage) {
        if self.marks.is_empty() {
            self.marks = other.marks;
        } else {
            for (own, other) in self.marks.iter_mut().zip(other.marks) {
                own.won += other.won;
                own.lost += other.lost;
            }
        }
        self.scripts += other.scripts;
        self.faults.extend(other.faults);
    }
}

/// Marks every student of one variant of a question.
pub fn coverage(question: &Question, variant: &Variant) -> Coverage {
    let with = variant.parameters.iter().map(|(name, value)| format!("{name} = {}", print::plain(value)));
    let with = with.collect::<Vec<_>>().join(", ");
    let printed = compose(question, variant, 1);
    let keyed = key_question(question, variant, &printed);
    let text = serde_json::to_string(&Key::new(String::new(), None, vec![keyed.clone()])).unwrap_or_default();
    let key = match AnswerKey::read(&text) {
        Ok(key) => key,
        Err(faults) => {
            let faults = faults.into_iter().map(|fault| Fault {
                who: "anything".to_owned(),
                what: "no mark can be given".to_owned(),
                wrote: format!("the key cannot be read back, {}", fault.message),
                with: with.clone(),
                row: None,
                help: None,
            });
            return Coverage { faults: faults.collect(), ..Coverage::default() };
        }
    };
    let mut coverage = Coverage::default();
    for keyed_question in key.papers.iter().flat_map(|paper| &paper.questions) {
        coverage.add(of_question(keyed_question, &students(&printed, &keyed, keyed_question), &with));
    }
    coverage
}

fn of_question(question: &KeyedQuestion, students: &[Student], with: &str) -> Coverage {
    let profile = Profile::default();
    let mut coverage = Coverage::default();
    for part in &question.parts {
        let count = |mark: &crate::mark::KeyedMark| MarkCount {
            part: part.label.clone(),
            id: mark.id.clone(),
            won: 0,
            lost: 0,
        };
        coverage.marks.extend(part.scheme.iter().map(count));
    }
    let marked = mark_each(question, students.iter().map(|student| &student.script), &profile);
    for (student, marked) in students.iter().zip(marked) {
        let awards = marked.iter().flat_map(|part| &part.awards);
        for (count, award) in coverage.marks.iter_mut().zip(awards) {
            *(if award.given { &mut count.won } else { &mut count.lost }) += 1;
        }
        coverage.scripts += 1;
        coverage.faults.extend(fault(question, student, &marked, with));
    }
    coverage
}

/// Is it marked as it must be?
fn fault(question: &KeyedQuestion, student: &Student, marked: &[MarkedPart], with: &str) -> Option<Fault> {
    let unlike = |is_due: bool, skips: &dyn Fn(&MarkedPart) -> bool| {
        let parts = marked.iter().enumerate().filter(|(_, part)| !skips(part));
        let rows = parts.flat_map(|(at, part)| (0..part.awards.len()).map(move |row| (at, row)));
        rows.filter(|(part, row)| marked[*part].awards[*row].given != is_due).collect::<Vec<_>>()
    };
    let name = |(part, row): (usize, usize)| of_part(&marked[part].awards[row].id, &marked[part].label);
    let marks = |rows: &[(usize, usize)]| {
        let names: Vec<String> = rows.iter().copied().map(name).collect();
        format!("the mark{} {}", if rows.len() > 1 { "s" } else { "" }, names.join(", "))
    };
    let are = |rows: &[(usize, usize)]| if rows.len() > 1 { "are" } else { "is" };
    let answer = |part: usize, blank: usize| &marked[part].answers[blank];
    let (rows, what) = match &student.expected {
        Expected::Everything | Expected::AllButShown => {
            let is_everything = student.expected == Expected::Everything;
            let lost = unlike(true, &|part| !is_everything && is_about_shown(part));
            let what = (!lost.is_empty()).then(|| format!("{} {} not given", marks(&lost), are(&lost)));
            (lost, what)
        }
        Expected::Nothing => {
            let won = unlike(false, &|_| false);
            let what = (!won.is_empty()).then(|| format!("{} {} given", marks(&won), are(&won)));
            (won, what)
        }
        Expected::Mistake { part, blank, tag } => {
            let answer = answer(*part, *blank);
            // A note says it too: of a wrong sign, or of an angle in radians.
            let named = answer.causes.iter().any(|cause| cause.tag == *tag) || answer.judgement.note.is_some();
            let what = match answer.judgement.verdict {
                Verdict::Correct => Some(RIGHT.to_owned()),
                _ if !named => Some("no mistake is named".to_owned()),
                _ => None,
            };
            (Vec::new(), what)
        }
        Expected::Wrong { part, blank } => {
            let won = |award: &Award| award.given && award.code.is_accuracy();
            let what = match answer(*part, *blank).judgement.verdict {
                Verdict::Correct => Some(RIGHT.to_owned()),
                _ => marked[*part].awards.iter().any(won).then(|| "an accuracy mark is given".to_owned()),
            };
            (Vec::new(), what)
        }
        Expected::ExactWanted { part, blank } => {
            let is_told = answer(*part, *blank).judgement.note == Some(Note::ExactWanted.tag());
            (Vec::new(), (!is_told).then(|| "no demand of exact form is made".to_owned()))
        }
        Expected::FollowThrough { part, id } => {
            let row = marked[*part].awards.iter().position(|award| award.id == *id && !award.given);
            let what = format!("the mark {} is not given", of_part(id, &marked[*part].label));
            (row.map(|row| (*part, row)).into_iter().collect(), row.map(|_| what))
        }
    };
    let row = match &student.expected {
        Expected::Wrong { part, blank } | Expected::Mistake { part, blank, .. } => Some((*part, "answers", *blank)),
        _ => rows.first().map(|(part, row)| (*part, "marks", *row)),
    };
    // The lines of the model solution are many; that which was to earn the mark is one.
    let line_of =
        |(part, row): &(usize, usize)| question.parts[*part].scheme[*row].equation.as_ref().map(print::unicode);
    let wrote = match student.expected {
        Expected::Everything => rows.iter().find_map(line_of).unwrap_or_default(),
        _ => student.wrote(),
    };
    let (who, with) = (student.who.clone(), with.to_owned());
    what.map(|what| Fault { help: help(question, student, &what), what, who, wrote, with, row })
}

/// What is amiss where a wrong answer earns what a right one does.
const RIGHT: &str = "full credit is given";

/// A mark, and of which part if there are several.
fn of_part(id: &str, label: &str) -> String {
    if label.is_empty() { id.to_owned() } else { format!("{id} of part ({label})") }
}

/// What an author can do, where that is known.
fn help(question: &KeyedQuestion, student: &Student, what: &str) -> Option<String> {
    match &student.expected {
        Expected::Wrong { part, blank } if what == RIGHT && student.who == ENDS_COUNTED => {
            let letter = question.parts.get(*part)?.blanks.get(*blank)?.find.name();
            Some(format!(
                "whether an end of all that `{letter}` can be is counted costs nobody a mark: require numbers with which the \
                 range ends elsewhere"
            ))
        }
        _ => None,
    }
}

/// Is the part one whose result is printed? Its marks are for the working.
fn is_about_shown(part: &MarkedPart) -> bool {
    part.awards.iter().any(|award| award.code == crate::bank::Code::A1Shown)
}
