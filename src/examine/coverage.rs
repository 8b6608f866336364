//! A question marked as handed in by students that Carom writes itself: right ones in many notations, ones that make a
//! known mistake, ones that hand in nothing or nonsense. What each of them must earn is known, so a marker or a mark scheme
//! that gives something else is found out. A mark that nobody wins, or nobody loses, measures nothing.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::students::{Expected, Student, students};
use crate::bank::Question;
use crate::generate::Variant;
use crate::mark::judging::{Note, Verdict};
use crate::mark::{AnswerKey, KeyedQuestion, MarkedPart, Profile, mark};
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
    /// Who wrote it.
    pub who: String,
    /// What is amiss with its marks.
    pub what: String,
    /// What stands in it.
    pub wrote: String,
    /// The part and the row of the first mark that is amiss, if one is.
    pub mark: Option<(usize, usize)>,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}: {}", self.who, self.what, self.wrote)
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
    let printed = compose(question, variant, 1);
    let keyed = key_question(question, variant, &printed);
    let text = serde_json::to_string(&Key::new(String::new(), None, vec![keyed.clone()])).unwrap_or_default();
    let key = match AnswerKey::read(&text) {
        Ok(key) => key,
        Err(faults) => {
            let faults = faults.into_iter().map(|fault| Fault {
                who: "anything".to_owned(),
                what: "meets a key that cannot be read back".to_owned(),
                wrote: fault.message,
                mark: None,
            });
            return Coverage { faults: faults.collect(), ..Coverage::default() };
        }
    };
    let mut coverage = Coverage::default();
    for keyed_question in key.papers.iter().flat_map(|paper| &paper.questions) {
        coverage.add(of_question(keyed_question, &students(&printed, &keyed, keyed_question)));
    }
    coverage
}

fn of_question(question: &KeyedQuestion, students: &[Student]) -> Coverage {
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
    for student in students {
        let marked = mark(question, &student.script, &profile);
        let awards = marked.iter().flat_map(|part| &part.awards);
        for (count, award) in coverage.marks.iter_mut().zip(awards) {
            *(if award.given { &mut count.won } else { &mut count.lost }) += 1;
        }
        coverage.scripts += 1;
        coverage.faults.extend(fault(student, &marked));
    }
    coverage
}

/// Is it marked as it must be?
fn fault(student: &Student, marked: &[MarkedPart]) -> Option<Fault> {
    let awards = || marked.iter().flat_map(|part| part.awards.iter().map(move |award| (part, award)));
    let name = |part: &MarkedPart, id: &str| {
        if part.label.is_empty() { id.to_owned() } else { format!("({}) {id}", part.label) }
    };
    let found = match &student.expected {
        Expected::Everything => {
            let lost: Vec<String> =
                awards().filter(|(_, award)| !award.given).map(|(part, award)| name(part, &award.id)).collect();
            (!lost.is_empty()).then(|| format!("does not earn {}", lost.join(", ")))
        }
        Expected::AllButShown => {
            let lost: Vec<String> = awards()
                .filter(|(part, award)| !award.given && !is_about_shown(part))
                .map(|(part, award)| name(part, &award.id))
                .collect();
            (!lost.is_empty()).then(|| format!("does not earn {}", lost.join(", ")))
        }
        Expected::Nothing => {
            let won: Vec<String> =
                awards().filter(|(_, award)| award.given).map(|(part, award)| name(part, &award.id)).collect();
            (!won.is_empty()).then(|| format!("earns {}", won.join(", ")))
        }
        Expected::Mistake { part, blank, tag } => {
            let answer = &marked[*part].answers[*blank];
            // A note says it too: of a wrong sign, or of an angle in radians.
            let named = answer.causes.iter().any(|cause| cause.tag == *tag) || answer.judgement.note.is_some();
            match answer.judgement.verdict {
                Verdict::Correct => Some("is taken for right".to_owned()),
                _ if !named => Some("is not recognised".to_owned()),
                _ => None,
            }
        }
        Expected::Wrong { part, blank } => {
            let won = |part: &MarkedPart| part.awards.iter().any(|award| award.given && award.code.is_accuracy());
            match marked[*part].answers[*blank].judgement.verdict {
                Verdict::Correct => Some("is taken for right".to_owned()),
                _ => won(&marked[*part]).then(|| "earns an accuracy mark".to_owned()),
            }
        }
        Expected::ExactWanted { part, blank } => {
            let judgement = &marked[*part].answers[*blank].judgement;
            (judgement.note != Some(Note::ExactWanted.tag())).then(|| "is not told that it must be exact".to_owned())
        }
        Expected::FollowThrough { part, id } => {
            let award = marked[*part].awards.iter().find(|award| award.id == *id);
            award.is_none_or(|award| !award.given).then(|| format!("does not earn {id}"))
        }
    };
    found.map(|what| Fault { mark: amiss(student, marked), who: student.who.clone(), what, wrote: student.wrote() })
}

/// The place of the first mark that was lost and must be won, or the other way round.
fn amiss(student: &Student, marked: &[MarkedPart]) -> Option<(usize, usize)> {
    let is_due = match student.expected {
        Expected::Everything | Expected::AllButShown => true,
        Expected::Nothing => false,
        _ => return None,
    };
    let skips = |part: &MarkedPart| matches!(student.expected, Expected::AllButShown) && is_about_shown(part);
    let parts = marked.iter().enumerate().filter(|(_, part)| !skips(part));
    let place = |part: &MarkedPart| part.awards.iter().position(|award| award.given != is_due);
    parts.filter_map(|(at, part)| Some((at, place(part)?))).next()
}

/// Is the part one whose result is printed? Its marks are for the working.
fn is_about_shown(part: &MarkedPart) -> bool {
    part.awards.iter().any(|award| award.code == crate::bank::Code::A1Shown)
}
