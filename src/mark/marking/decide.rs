//! Each mark of a scheme given or withheld.

use super::answers::is_shown;
use super::follow::Followed;
use super::withhold::{
    contradicts, drop_dependent, lacks_letter, withhold_by_luck, withhold_for_direction, withhold_from_wrong_equations,
    withhold_from_wrong_method, withhold_implied,
};
use crate::answer::Accept;
use crate::bank::{Code, EarnedFor, Find};
use crate::mark::award::{Award, Evidence, Examiner, Ground, MarkedAnswer, Place};
use crate::mark::judging::{Note, Verdict};
use crate::mark::key::{KeyedBlank, KeyedMark, KeyedPart};
use crate::mark::profile::{Charge, Profile};
use crate::mechanics::{Quantity, Seen};

/// What has been charged in this question already.
#[derive(Default)]
pub(super) struct Charged {
    inaccuracy: bool,
    units: bool,
    coordinates: bool,
}

/// What speaks for and against the marks of a part.
pub(super) struct Findings<'a> {
    /// For each mark and each blank: would the answer be another if what earns the mark were wrong?
    pub(super) needed: &'a [Vec<bool>],
    /// The answers, judged.
    pub(super) answers: &'a [MarkedAnswer],
    /// What the working shows of each mark.
    pub(super) by_working: Vec<Option<Award>>,
    /// What is right for the student's own values, a blank each.
    pub(super) followed: &'a [Option<Followed>],
    /// For each mark: does the working state another value than the one that it is for?
    pub(super) contradicted: Vec<bool>,
    /// Does it state any value that is right?
    pub(super) has_right_value: bool,
    /// Of each sphere: do the student's own equations lead elsewhere than to its right velocity?
    pub(super) denies_velocities: [bool; 2],
    /// For each mark: does a right value of it follow from velocities that are wrong?
    pub(super) by_luck: Vec<bool>,
}

/// The awards of a part, in the order of the scheme, each as if it stood alone: [`settled`] sets them side by side.
pub(super) fn awards(part: &KeyedPart, found: Findings, profile: &Profile, charged: &mut Charged) -> Vec<Award> {
    let Findings { needed, answers, by_working, followed, contradicted, has_right_value, denies_velocities, by_luck } =
        found;
    let each = part.blanks.iter().zip(answers);
    let worth: Vec<Worth> = each.map(|(blank, answer)| Worth::of(answer, blank, profile, charged)).collect();
    let mut awards: Vec<Award> = Vec::new();
    for (((mark, by_working), needed), contradicted) in part.scheme.iter().zip(by_working).zip(needed).zip(contradicted)
    {
        // Where the answer itself was given, it is the student's last word on the value.
        let own_blanks = own_blanks(mark, part);
        let own = least(own_blanks.iter().map(|place| answers[*place].judgement.verdict));
        let answered = own.is_some_and(|verdict| verdict != Verdict::Blank);
        let by_working = by_working
            .filter(|_| !answered || mark.code == Code::A1Shown)
            .map(|award| in_profile(award, mark, profile));
        let by_answers = by_answers(mark, part, &own_blanks, needed, answers, &worth)
            .filter(|award| !award.is(Ground::Implied) || !contradicted);
        let award = match (by_answers, by_working) {
            // What the working shows is better evidence than what an answer implies.
            (Some(implied), Some(shown))
                if implied.is(Ground::Implied)
                    && (shown.given || contradicts(&shown) || lacks_letter(&shown, &implied, part)) =>
            {
                shown
            }
            (Some(award), _) => award,
            (None, Some(shown)) if shown.given => shown,
            (None, shown) => by_followed(mark, part, followed)
                .or_else(|| shown.map(|shown| in_figures(shown, mark, part, profile, charged)))
                .unwrap_or_else(|| unearned(mark, own)),
        };
        awards.push(award);
    }
    imply_needed(&part.scheme, &mut awards);
    withhold_from_wrong_method(part, needed, has_right_value, &mut awards);
    withhold_from_wrong_equations(part, needed, denies_velocities, &mut awards);
    withhold_by_luck(part, &by_luck, &mut awards);
    withhold_implied(part, &mut awards);
    withhold_for_direction(part, answers, &mut awards);
    awards
}

/// A right answer implies whatever its own mark depends on, where nothing else was seen of it.
fn imply_needed(scheme: &[KeyedMark], awards: &mut [Award]) {
    for place in (0..scheme.len()).rev() {
        let by_answer = awards[place].given
            && matches!(&awards[place].evidence, Some(Evidence { place: Place::Answer(_), .. }))
            && !awards[place].is(Ground::FollowThrough);
        for needed in scheme[place].depends.iter().copied().filter(|_| by_answer) {
            if !awards[needed].given && awards[needed].evidence.is_none() {
                awards[needed] = Award {
                    given: true,
                    note: Some(Ground::Implied.tag()),
                    evidence: awards[place].evidence.clone(),
                    feedback: "implied by what follows from it".to_owned(),
                    ..withheld(&scheme[needed])
                };
            }
        }
    }
}

/// The awards of a part once those have fallen that depend on others, and printed results have been looked at.
///
/// Nothing is changed of what a person has decided.
pub(super) fn settled(part: &KeyedPart, answers: &[MarkedAnswer], found: &[Award]) -> Vec<Award> {
    let mut awards = found.to_vec();
    drop_dependent(&part.scheme, &mut awards);
    for place in 0..awards.len() {
        if part.scheme[place].code == Code::A1Shown && awards[place].by == Examiner::Marker {
            awards[place] = shown(place, part, answers, &awards);
        }
    }
    awards
}

/// What a board condones that others do not.
fn in_profile(award: Award, mark: &KeyedMark, profile: &Profile) -> Award {
    let condones = match award.note {
        Some("masses-omitted") => profile.masses_omitted,
        Some("not-resolved") => profile.unresolved,
        _ => false,
    };
    let is_momentum = matches!(mark.earned_for, EarnedFor::Law(law, _) if law.gives(Quantity::MomentumEquation));
    let given = award.given || condones && is_momentum && !mark.code.is_accuracy();
    Award { given, ..award }
}

/// A value on the way with too few figures, for which they are enough, or which have been charged already.
fn in_figures(award: Award, mark: &KeyedMark, part: &KeyedPart, profile: &Profile, charged: &mut Charged) -> Award {
    let is = |notes: &[Note]| notes.iter().any(|note| award.note == Some(note.tag()));
    let must_be_exact = own_blanks(mark, part).iter().any(|place| wants_exact(&part.blanks[*place]));
    let is_value = !mark.earned_for.quantities().is_empty() && !must_be_exact;
    let is_enough = is(&[Note::UnderAccurate]) && profile.figures <= ENOUGH;
    let costs = is(&[Note::UnderAccurate, Note::Truncated]) && !is_enough;
    let given =
        is_value && (is_enough || costs && charge(profile.inaccuracy, &mut charged.inaccuracy) == Worth::Everything);
    Award { given: award.given || given, ..award }
}

/// Where the exact value is wanted, no decimal is enough, however many figures it has.
fn wants_exact(blank: &KeyedBlank) -> bool {
    blank.model.accept == Accept::Exact
}

/// The fewest figures that are right as far as they go: one is no evidence.
pub(super) const ENOUGH: u32 = 2;

/// A mark for an answer that is right for what the student had found before.
fn by_followed(mark: &KeyedMark, part: &KeyedPart, followed: &[Option<Followed>]) -> Option<Award> {
    let mut each = mark.blanks.iter().filter_map(|place| Some((*place, followed[*place].as_ref()?)));
    each.find_map(|(place, followed)| by_one_followed(mark, part, place, followed))
}

fn by_one_followed(mark: &KeyedMark, part: &KeyedPart, blank: usize, followed: &Followed) -> Option<Award> {
    let Followed { judgement, is_marked } = followed;
    let asked = part.blanks[blank].find.quantities();
    let is_value = mark.earned_for.quantities().iter().any(|quantity| asked.contains(quantity));
    // The method that leads to it is implied, and what follows on the way; what stands before the student's own value is not.
    let is_on_the_way = matches!(mark.earned_for, EarnedFor::Law(law, _) if matches!(law.seen(), Seen::Value(..)));
    // Nor is there another way to it where the scheme has one method alone.
    let is_only_method = || part.scheme.iter().filter(|other| other.code.is_method()).count() == 1;
    let is_method = mark.code.is_method()
        && (*is_marked || is_on_the_way || is_only_method())
        && part.scheme.iter().any(|other| {
            let is_own =
                if *is_marked { other.code == Code::A1FollowThrough } else { is_own(other, &part.blanks[blank]) };
            is_own && other.blanks.contains(&blank) && other.depends.iter().any(|id| part.scheme[*id].id == mark.id)
        });
    let follows = is_method || (mark.code == Code::A1FollowThrough && (is_value || is_on_the_way));
    follows.then(|| Award {
        given: true,
        note: Some(Ground::FollowThrough.tag()),
        evidence: Some(Evidence {
            place: Place::Answer(blank),
            reading: judgement.reading.clone().unwrap_or_default(),
        }),
        feedback: "followed through from your own values".to_owned(),
        ..withheld(mark)
    })
}

/// The mark for a printed result: every mark before it earned, and the result at the end.
fn shown(place: usize, part: &KeyedPart, answers: &[MarkedAnswer], awards: &[Award]) -> Award {
    let mark = &part.scheme[place];
    // A false line on the way, or the result at the end of the working, though its blank is empty.
    let by_working =
        Some(&awards[place]).filter(|award| matches!(&award.evidence, Some(Evidence { place: Place::Line(_), .. })));
    let ends = answers.iter().position(|answer| answer.judgement.note == Some(Note::Restated.tag()));
    let missing = awards[..place].iter().find(|award| !award.given);
    let broken = awards[..place].iter().any(|award| award.is(Ground::FollowThrough));
    match (ends, missing) {
        (_, None) if by_working.is_some_and(|award| !award.given) => awards[place].clone(),
        (None, None) if by_working.is_some() && !broken => awards[place].clone(),
        (Some(_), None) if broken => Award {
            note: Some(Ground::NotShown.tag()),
            feedback: "a value on the way is wrong, so the result does not follow from it".to_owned(),
            ..withheld(mark)
        },
        (Some(blank), None) => Award {
            given: true,
            evidence: Some(Evidence {
                place: Place::Answer(blank),
                reading: answers[blank].judgement.reading.clone().unwrap_or_default(),
            }),
            ..withheld(mark)
        },
        (_, Some(missing)) if ends.is_some() || by_working.is_some_and(|award| award.given) => {
            let feedback = format!("the result is printed in the question: it earns nothing without {}", missing.id);
            Award { note: Some(Ground::NotShown.tag()), feedback, ..withheld(mark) }
        }
        _ => {
            let feedback = "the working must show every step and end with the result as it is printed".to_owned();
            Award { feedback, ..withheld(mark) }
        }
    }
}

/// What a final answer is worth.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Worth {
    /// All marks that lead to it.
    Everything,
    /// All but the last: the value is there, its accuracy, its form or its unit is not.
    Method,
    /// All but the last and what the last step of the method earns: that step is missing.
    BeforeLastStep,
    /// Nothing by itself.
    Nothing,
}

/// Answers that come of the whole method, though the last mark is not theirs: the value is right and its form is not, or the
/// condition is there and not what it comes to.
const NOT_FINISHED: [Note; 11] = [
    Note::ExactWanted,
    Note::DirectionMissing,
    Note::GradientUnstated,
    Note::Sign,
    Note::LetterMissing,
    Note::RatioOfAngle,
    Note::RadiansUnstated,
    Note::RatioForNumber,
    Note::SquareLeft,
    Note::Unsolved,
    Note::RangeUnsolved,
];

impl Worth {
    fn of(answer: &MarkedAnswer, blank: &KeyedBlank, profile: &Profile, charged: &mut Charged) -> Worth {
        let is = |notes: &[Note]| notes.iter().any(|note| answer.judgement.note == Some(note.tag()));
        let is_inaccurate = is(&[Note::UnderAccurate, Note::Truncated]);
        match answer.judgement.verdict {
            Verdict::Correct => Worth::Everything,
            Verdict::Partial if is_inaccurate && wants_exact(blank) => Worth::Method,
            Verdict::Partial if is_inaccurate => charge(profile.inaccuracy, &mut charged.inaccuracy),
            // What is rounded too early costs its mark every time.
            Verdict::Partial if is(&[Note::EarlyRounding]) => Worth::Method,
            Verdict::Partial if is(&[Note::UnitWrong, Note::UnitNotNeeded]) => {
                charge(profile.units, &mut charged.units)
            }
            // One who writes coordinates writes them throughout.
            Verdict::Partial if is(&[Note::Coordinates]) => charge(Charge::Once, &mut charged.coordinates),
            Verdict::Partial if is(&NOT_FINISHED) => Worth::Method,
            Verdict::Partial if is(&[Note::VectorForScalar, Note::ComponentsLeft]) => Worth::BeforeLastStep,
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

/// The blanks whose values the mark is for.
pub(super) fn own_blanks(mark: &KeyedMark, part: &KeyedPart) -> Vec<usize> {
    (0..part.blanks.len()).filter(|place| is_own(mark, &part.blanks[*place])).collect()
}

/// Is the mark for the value of a blank?
pub(super) fn is_own(mark: &KeyedMark, blank: &KeyedBlank) -> bool {
    match &mark.earned_for {
        EarnedFor::Unknown(name) => matches!(&blank.find, Find::Unknown(own) if own == name),
        // The line of centres as it is asked for is the answer itself.
        EarnedFor::Law(law, _) if law.seen() == Seen::AlongLine && mark.code.is_accuracy() => {
            blank.find.quantities().iter().any(|quantity| law.gives(*quantity))
        }
        values => values.quantities().iter().any(|quantity| blank.find.asks_for(*quantity)),
    }
}

/// Of several verdicts the one that is furthest from right; a blank says less than a wrong answer.
fn least(verdicts: impl Iterator<Item = Verdict>) -> Option<Verdict> {
    const FROM_RIGHT: [Verdict; 5] =
        [Verdict::Correct, Verdict::Partial, Verdict::Unreadable, Verdict::Wrong, Verdict::Blank];
    verdicts.max_by_key(|verdict| FROM_RIGHT.iter().position(|known| known == verdict))
}

/// A mark that final answers earn.
fn by_answers(
    mark: &KeyedMark,
    part: &KeyedPart,
    own: &[usize],
    needed: &[bool],
    answers: &[MarkedAnswer],
    worth: &[Worth],
) -> Option<Award> {
    let is_value = |place: usize| own.contains(&place);
    let mut candidates = mark
        .blanks
        .iter()
        .copied()
        .filter(|place| (needed[*place] || is_value(*place)) && !is_shown(&part.blanks[*place]));
    let earns = |place: &usize| match worth[*place] {
        Worth::Everything => mark.code != Code::A1Shown,
        Worth::Method => !is_value(*place) && mark.code != Code::A1Shown,
        Worth::BeforeLastStep => {
            !is_value(*place) && mark.code != Code::A1Shown && !is_last_step(mark, &part.blanks[*place])
        }
        Worth::Nothing => false,
    };
    // One right answer implies one value, and not the other as well.
    if matches!(mark.earned_for, EarnedFor::Both(_)) && !candidates.clone().all(|place| earns(&place)) {
        return None;
    }
    let earned = candidates.find(earns)?;
    let judgement = &answers[earned].judgement;
    let reading = judgement.reading.clone().unwrap_or_default();
    let (note, feedback) = match is_value(earned) {
        true => (judgement.note, judgement.feedback.clone()),
        false => (Some(Ground::Implied.tag()), format!("implied by the {}", answers[earned].name)),
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

/// Is the mark for the law that gives the value of a blank itself, as Pythagoras gives a speed?
fn is_last_step(mark: &KeyedMark, blank: &KeyedBlank) -> bool {
    let EarnedFor::Law(law, _) = mark.earned_for else { return false };
    blank.find.quantities().iter().any(|quantity| law.gives(quantity.of_its_impact()))
}

/// A mark that nothing earns: where it is for an answer that was given, the verdict on that is the reason.
fn unearned(mark: &KeyedMark, own: Option<Verdict>) -> Award {
    let feedback = match own {
        Some(Verdict::Partial) => "the answer is only partly right",
        Some(Verdict::Wrong) => "the answer is not right",
        Some(Verdict::Unreadable) => "the answer cannot be read",
        _ => "",
    };
    Award { feedback: feedback.to_owned(), ..withheld(mark) }
}

pub(super) fn withheld(mark: &KeyedMark) -> Award {
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
