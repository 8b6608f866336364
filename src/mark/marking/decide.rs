//! Each mark of a scheme given or withheld.

use super::answers::is_shown;
use crate::bank::{Code, EarnedFor};
use crate::mark::award::{Award, Evidence, Examiner, MarkedAnswer, Place};
use crate::mark::judging::{Note, Verdict};
use crate::mark::key::{KeyedMark, KeyedPart};
use crate::mark::profile::{Charge, Profile};

/// What has been charged in this question already.
#[derive(Default)]
pub(super) struct Charged {
    inaccuracy: bool,
    units: bool,
}

/// The awards of a part, in the order of the scheme.
pub(super) fn awards(
    part: &KeyedPart,
    answers: &[MarkedAnswer],
    profile: &Profile,
    charged: &mut Charged,
) -> Vec<Award> {
    let worth: Vec<Worth> = answers.iter().map(|answer| Worth::of(answer, profile, charged)).collect();
    let mut awards: Vec<Award> = Vec::new();
    for mark in &part.scheme {
        awards.push(by_answers(mark, part, answers, &worth).unwrap_or_else(|| withheld(mark)));
    }
    drop_dependent(&part.scheme, &mut awards);
    awards
}

/// What a final answer is worth.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Worth {
    /// All marks that lead to it.
    Everything,
    /// All but the last: the value is there, its accuracy or its unit is not.
    Method,
    /// Nothing by itself.
    Nothing,
}

impl Worth {
    fn of(answer: &MarkedAnswer, profile: &Profile, charged: &mut Charged) -> Worth {
        let is = |notes: &[Note]| notes.iter().any(|note| answer.judgement.note == Some(note.tag()));
        match answer.judgement.verdict {
            Verdict::Correct => Worth::Everything,
            Verdict::Partial if is(&[Note::UnderAccurate, Note::Truncated]) => {
                charge(profile.inaccuracy, &mut charged.inaccuracy)
            }
            Verdict::Partial if is(&[Note::UnitWrong]) => charge(profile.units, &mut charged.units),
            // The value is right and its form is not.
            Verdict::Partial
                if is(&[Note::ExactWanted, Note::Coordinates, Note::DirectionMissing, Note::GradientUnstated]) =>
            {
                Worth::Method
            }
            _ => Worth::Nothing,
        }
    }
}

fn charge(how_often: Charge, charged: &mut bool) -> Worth {
    let costs = match how_often {
        Charge::Never => false,
        Charge::Once => !std::mem::replace(charged, true),
        Charge::Always => true,
    };
    if costs { Worth::Method } else { Worth::Everything }
}

/// A mark that final answers earn.
fn by_answers(mark: &KeyedMark, part: &KeyedPart, answers: &[MarkedAnswer], worth: &[Worth]) -> Option<Award> {
    let is_value = |place: usize| match &mark.earned_for {
        EarnedFor::Quantity(quantity) => part.blanks[place].find.quantities().contains(quantity),
        EarnedFor::Unknown(name) => part.blanks[place].find == crate::bank::Find::Unknown(name.clone()),
        _ => false,
    };
    let mut candidates = mark.blanks.iter().copied().filter(|place| !is_shown(&part.blanks[*place]));
    let earned = candidates.find(|place| match worth[*place] {
        Worth::Everything => mark.code != Code::A1Shown,
        Worth::Method => !is_value(*place) && mark.code != Code::A1Shown,
        Worth::Nothing => false,
    })?;
    let judgement = &answers[earned].judgement;
    let reading = judgement.reading.clone().unwrap_or_default();
    let (note, feedback) = match is_value(earned) {
        true => (judgement.note, judgement.feedback.clone()),
        false => (Some("implied"), format!("implied by the {}", answers[earned].name)),
    };
    Some(Award {
        id: mark.id.clone(),
        code: mark.code,
        given: true,
        by: Examiner::Marker,
        note,
        evidence: Some(Evidence { place: Place::Answer(earned), reading }),
        feedback,
    })
}

fn withheld(mark: &KeyedMark) -> Award {
    Award {
        id: mark.id.clone(),
        code: mark.code,
        given: false,
        by: Examiner::Marker,
        note: None,
        evidence: None,
        feedback: String::new(),
    }
}

/// Marks without those on which they depend fall too; a person's word stands.
pub(super) fn drop_dependent(scheme: &[KeyedMark], awards: &mut [Award]) {
    for (place, mark) in scheme.iter().enumerate() {
        let missing = mark.depends.iter().find(|needed| !awards[**needed].given).copied();
        if let Some(missing) = missing
            && awards[place].given
            && awards[place].by == Examiner::Marker
        {
            let needed = awards[missing].id.clone();
            let award = &mut awards[place];
            award.given = false;
            award.note = Some("depends");
            award.feedback = format!("depends on {needed}");
        }
    }
}
