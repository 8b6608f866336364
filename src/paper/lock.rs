//! The lock of a class: who got which sheet, so that the same command prints the same sheets again.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use super::series::{is_of_later_series, series};
use crate::bank::{Question, StyleName};
use crate::diagnostic::why_no_json;
use crate::generate::{Variant, examine};

/// Who got which sheet.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Lock {
    /// The version of carom that wrote it.
    #[serde(deserialize_with = "version")]
    pub carom: String,
    /// The bank the questions come from.
    pub bank: String,
    /// The seed by which the sheets were dealt.
    pub seed: u64,
    /// Every sheet that was ever printed for the class; also of students who have left, for theirs are not dealt again.
    pub sheets: Vec<Locked>,
}

fn version<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    let said = String::deserialize(deserializer)?;
    match series(&said) {
        Some(_) => Ok(said),
        None => Err(D::Error::custom(format!("`{}` is no version of carom", said.escape_debug()))),
    }
}

/// The sheet of a student.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Locked {
    /// The student, as the class list has it.
    pub student: String,
    /// The name; empty if there is none.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// The code of the sheet, by which a bank that was edited since is noticed.
    pub code: String,
    /// The questions in the order of the sheet.
    pub questions: Vec<LockedQuestion>,
}

/// A question with its numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LockedQuestion {
    /// Its id in the bank.
    pub id: String,
    /// The style of its numbers.
    pub style: String,
    /// Which of the style's sets of numbers it has.
    pub index: u64,
}

/// Why a text is no lock.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LockFault {
    /// What is wrong.
    pub message: String,
    /// Line and column.
    pub place: (usize, usize),
}

impl Lock {
    /// Reads a lock.
    ///
    /// # Errors
    ///
    /// What is wrong with the text, and where.
    pub fn read(text: &str) -> Result<Lock, LockFault> {
        serde_json::from_str(text).map_err(|error| LockFault {
            message: why_no_json(&error),
            place: (error.line().max(1), error.column().max(1)),
        })
    }

    /// Was it written by a later series, such as 0.2 where this is 0.1?
    pub fn is_later(&self) -> bool {
        is_of_later_series(&self.carom)
    }

    /// The sheet of a student, if there is one.
    pub fn of(&self, student: &str) -> Option<&Locked> {
        self.sheets.iter().find(|sheet| sheet.student == student)
    }
}

impl Locked {
    /// What was dealt: the style and the index of each question.
    pub fn hand(&self) -> Vec<(StyleName, u64)> {
        let style = |name: &str| StyleName::ALL.into_iter().find(|style| style.name() == name);
        self.questions.iter().filter_map(|question| Some((style(&question.style)?, question.index))).collect()
    }

    /// The variants, of these questions in their order; `None` if they are not those of the sheet.
    pub fn variants(&self, questions: &[&Question]) -> Option<Vec<Variant>> {
        let hand = self.hand();
        if hand.len() != questions.len() || self.questions.len() != questions.len() {
            return None;
        }
        let each = questions.iter().zip(&self.questions).zip(hand).map(|((question, locked), (style, index))| {
            let style = question.style(style).filter(|style| question.id == locked.id && index < style.size())?;
            examine(question, style, index).ok()
        });
        each.collect()
    }
}
