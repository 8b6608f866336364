//! Awards: each mark of a scheme given or withheld, with the evidence and the reason.

use super::judging::Judgement;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mechanics::Quantity;

/// A part marked.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkedPart {
    /// `a`, `b`, … or empty.
    pub label: String,
    /// How each blank of the part was answered, in the order of the key.
    pub answers: Vec<MarkedAnswer>,
    /// How each line of working was read and what it is, in order.
    pub lines: Vec<MarkedLine>,
    /// One award for each mark of the scheme, in its order.
    pub awards: Vec<Award>,
    /// The same before marks fell with those on which they depend.
    pub found: Vec<Award>,
    /// Where marks were lost and values are wrong: what the student had found, as it was written. The solution of the rest
    /// from there is [`from_own_values`](super::from_own_values).
    pub own: Vec<(Quantity, Expr)>,
}

/// A blank as it was answered.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkedAnswer {
    /// What it is called: `speed of A`.
    pub name: String,
    /// What was typed; nothing if the blank was left empty.
    pub typed: Option<String>,
    /// The verdict on it.
    pub judgement: Judgement,
    /// Where a mistake explains a wrong answer: every mistake that does, the most common first.
    pub causes: Vec<Cause>,
}

/// A mistake that would lead to what the student wrote.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cause {
    /// A fixed tag: `sincos-swap`; two joined by `+` if there were two.
    pub tag: String,
    /// What a good teacher says.
    pub sentence: String,
    /// Ids of the marks that the student has probably earned on the way; shown, not given, where there is no working.
    pub probable: Vec<String>,
}

/// A line of working as it was understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarkedLine {
    /// What was typed.
    pub typed: String,
    /// The reading that was used, in the notation of a terminal; none if it could not be read.
    pub reading: Option<String>,
    /// What it is: `momentum, with sine and cosine exchanged`; empty if it plays no part.
    pub role: String,
}

/// One mark, given or not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Award {
    /// Its id within the part: `M1a`.
    pub id: String,
    /// Its code.
    pub code: Code,
    /// Is it given?
    pub given: bool,
    /// Who decided.
    pub by: Examiner,
    /// A fixed tag: `follow-through`, `implied`, `sincos-swap`, `depends`.
    pub note: Option<&'static str>,
    /// Where in the script it was earned, or lost.
    pub evidence: Option<Evidence>,
    /// What a teacher would say.
    pub feedback: String,
}

/// Why a mark or an answer stands or falls, where no mistake says why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ground {
    /// Right for the student's own values.
    FollowThrough,
    /// Earned by what comes of it.
    Implied,
    /// Missing between other lines.
    NotShown,
    /// Withheld with another mark.
    Depends,
    /// Right beside working that comes to another value.
    Contradicted,
    /// Right beside working that ends with a number that may be another value for it.
    EndsElsewhere,
}

impl Ground {
    /// Its note.
    pub(super) fn tag(self) -> &'static str {
        match self {
            Ground::FollowThrough => "follow-through",
            Ground::Implied => "implied",
            Ground::NotShown => "not-shown",
            Ground::Depends => "depends",
            Ground::Contradicted => "contradicted",
            Ground::EndsElsewhere => "ends-elsewhere",
        }
    }
}

/// Who decided on a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Examiner {
    /// The marker.
    Marker,
    /// A person, who has the last word.
    Person,
}

/// A place in a script.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Evidence {
    /// Which place.
    pub place: Place,
    /// How it was read.
    pub reading: String,
}

/// Where in a part something stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A line of working, from 1.
    Line(usize),
    /// The answer to a blank, from 0.
    Answer(usize),
}

impl Award {
    /// As it is written in a list of codes: `M1`, or `M0` where it is not given.
    ///
    /// ```
    /// use carom::bank::Code;
    /// use carom::mark::{Award, Examiner};
    /// let award = |code, given| Award {
    ///     id: "A1a".into(), code, given, by: Examiner::Marker, note: None, evidence: None, feedback: String::new(),
    /// };
    /// assert_eq!(award(Code::DependentM1, false).printed(), "dM0");
    /// assert_eq!(award(Code::A1FollowThrough, true).printed(), "A1ft");
    /// ```
    pub fn printed(&self) -> String {
        if self.given { self.code.name().to_owned() } else { self.code.name().replacen('1', "0", 1) }
    }

    /// Is it withheld because another mark is, on which it depends?
    pub fn falls_with_another(&self) -> bool {
        self.by == Examiner::Marker && self.is(Ground::Depends)
    }

    /// Is this why?
    pub(super) fn is(&self, ground: Ground) -> bool {
        self.note == Some(ground.tag())
    }
}

impl MarkedPart {
    /// How many marks are given.
    pub fn marks(&self) -> usize {
        self.awards.iter().filter(|award| award.given).count()
    }
}
