//! Why an answer is wrong, in words and in marks.

use crate::mechanics::{Carried, Law, Quantity, Slip, ordinal};

use super::calculator;
use super::last_step::{self, OF_FORM};
use super::sample::Sample;
use super::{Origin, Way};

/// Something that leads to the answer that was given.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// The tag of the slip; of a pair of slips both.
    pub tags: Vec<&'static str>,
    /// The laws in whose place the slips stand; none for a slip of the calculator or of the last line.
    pub laws: Vec<Law>,
    /// What a teacher would say.
    pub sentence: String,
    /// What each step of the derivation would earn, in its order.
    pub steps: Vec<StepMarks>,
}

/// What a step would earn of a student who made the slips and no other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepMarks {
    /// The law that it applies.
    pub law: Law,
    /// What it gives.
    pub gives: Vec<Quantity>,
    /// Is its method mark earned?
    pub method: bool,
    /// Is its accuracy mark earned?
    pub accuracy: bool,
}

impl Cause {
    /// Is the method mark of a law earned, at every step that applies it? True of a law that is not needed.
    pub fn earns_method(&self, law: Law) -> bool {
        self.steps.iter().filter(|step| step.law == law).all(|step| step.method)
    }

    /// Is the accuracy mark of a law earned, at every step that applies it? True of a law that is not needed.
    pub fn earns_accuracy(&self, law: Law) -> bool {
        self.steps.iter().filter(|step| step.law == law).all(|step| step.accuracy)
    }

    /// Is the value of a quantity still the right one?
    pub fn keeps(&self, quantity: Quantity) -> bool {
        self.steps.iter().filter(|step| step.gives.contains(&quantity)).all(|step| step.accuracy)
    }
}

impl Way {
    /// Likely ways first: what is right but for its form, single slips, what is something else, pairs.
    pub(super) fn rank(&self) -> (u8, usize) {
        let place = |slip: usize| usize::from(Slip::all()[slip].1.place);
        match &self.origin {
            Origin::Slips(slip, None) | Origin::SlipAt(slip, _) => (1, place(*slip)),
            Origin::Calculator(slip) => (1, usize::from(calculator::SLIPS[*slip].place)),
            Origin::LastStep(step) => match last_step::ALL.iter().position(|other| other == step).unwrap_or_default() {
                form if form < OF_FORM => (0, form),
                other => (2, other),
            },
            // Of pairs the likeliest is the one of two likely slips.
            Origin::Slips(one, Some(two)) => {
                let (one, two) = (place(*one), place(*two));
                (3, (one + two) * 256 + one)
            }
        }
    }

    pub(super) fn is_single(&self) -> bool {
        !matches!(self.origin, Origin::Slips(_, Some(_)))
    }

    pub(super) fn tags(&self) -> Vec<&'static str> {
        match &self.origin {
            Origin::Slips(one, two) => std::iter::once(*one).chain(*two).map(|slip| Slip::all()[slip].1.tag).collect(),
            Origin::SlipAt(slip, _) => vec![Slip::all()[*slip].1.tag],
            Origin::Calculator(slip) => vec![calculator::SLIPS[*slip].tag],
            Origin::LastStep(step) => vec![step.tag],
        }
    }

    pub(super) fn cause(&self, road: &Carried<Sample>) -> Cause {
        let sentence = match &self.origin {
            Origin::Slips(one, None) => Slip::all()[*one].1.sentence.to_owned(),
            Origin::Slips(one, Some(two)) => [one, two].map(|slip| Slip::all()[*slip].1.sentence).join(" "),
            Origin::SlipAt(slip, impact) => {
                let sentence = Slip::all()[*slip].1.sentence;
                format!("{sentence} So it is in the {} impact only.", ordinal(*impact))
            }
            Origin::Calculator(slip) => calculator::SLIPS[*slip].sentence.to_owned(),
            Origin::LastStep(step) => step.sentence.to_owned(),
        };
        let steps = road.derivation().steps.iter();
        let mut laws: Vec<Law> =
            steps.clone().enumerate().filter(|(place, _)| self.trace.slipped.has(*place)).map(|(_, s)| s.law).collect();
        laws.sort();
        laws.dedup();
        let marks = road.marks(self.trace, self.lost);
        let steps = steps.zip(marks).map(|(step, (method, accuracy))| StepMarks {
            law: step.law,
            gives: step.gives.clone(),
            method,
            accuracy,
        });
        Cause { tags: self.tags(), laws, sentence, steps: steps.collect() }
    }
}
