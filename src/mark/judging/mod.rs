//! Judging what was read against a model answer.

use crate::answer::{Accept, Kind};
use crate::expr::Expr;

use super::reading::Vocabulary;

/// What is right, and how near an answer must come.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The exact value.
    pub value: Expr,
    /// Its kind.
    pub kind: Kind,
    /// The rule of acceptance.
    pub accept: Accept,
    /// The letters of the question.
    pub vocabulary: Vocabulary,
}

/// How an answer fares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every mark for the answer.
    Correct,
    /// The method is there and the accuracy is not, or the form is not what was asked.
    Partial,
    /// Something else.
    Wrong,
    /// Nobody but a person can tell what is meant.
    Unreadable,
    /// There is nothing.
    Blank,
}

/// A verdict with its reasons.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// The reading that was used, in the notation of a terminal.
    pub reading: Option<String>,
    /// A fixed tag, free of the question's numbers: `under-accurate`, `truncated`, `unit-missing`.
    pub note: Option<&'static str>,
    /// What a teacher would say.
    pub feedback: String,
}
