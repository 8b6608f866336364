//! Marks withheld though something earned them: for a wrong direction, after a wrong method, without those on which they
//! depend.

use super::decide::{is_own, own_blanks, withheld};
use crate::answer::Kind;
use crate::bank::{EarnedFor, Find};
use crate::mark::award::{Award, Evidence, Examiner, Ground, MarkedAnswer, Place};
use crate::mark::judging::{Note, Verdict};
use crate::mark::key::{KeyedBlank, KeyedMark, KeyedPart};
use crate::mechanics::{Quantity, Seen, Sphere};

/// A mark for a speed is for the direction too, where the scheme has none for that: a wrong direction costs it.
pub(super) fn withhold_for_direction(part: &KeyedPart, answers: &[MarkedAnswer], awards: &mut [Award]) {
    for (place, blank) in part.blanks.iter().enumerate() {
        let Find::Quantity(direction) = blank.find else { continue };
        let is_marked = part.scheme.iter().any(|mark| is_own(mark, blank));
        if is_marked || answers[place].judgement.verdict != Verdict::Wrong {
            continue;
        }
        let speeds = part.scheme.iter().zip(awards.iter_mut());
        for (mark, award) in
            speeds.filter(|(mark, _)| mark.code.is_accuracy() && mark.earned_for.is_speed_beside(direction))
        {
            let feedback = format!("this mark is for the {} as well, which is wrong", blank.name);
            *award = Award { note: Some(Ground::Depends.tag()), feedback, ..withheld(mark) };
        }
    }
}

/// A value that is right after a method that it needs is plainly wrong has not come from it. Nor has a letter that was to be
/// found, if an equation is wrong but for its method and no line after it is right: some slips lead to the same letter.
pub(super) fn withhold_from_wrong_method(
    part: &KeyedPart,
    needed: &[Vec<bool>],
    has_right_value: bool,
    awards: &mut [Award],
) {
    let is_wrong = |place: &usize| !awards[*place].given && contradicts(&awards[*place]);
    let wrong: Vec<usize> = (0..awards.len()).filter(is_wrong).collect();
    for (place, mark) in part.scheme.iter().enumerate() {
        let own = own_blanks(mark, part);
        let by_answer = matches!(&awards[place].evidence, Some(Evidence { place: Place::Answer(_), .. }));
        // What is worked out with the letter has come of the same luck.
        let is_letter = |blank: &KeyedBlank| match blank.find {
            Find::Unknown(_) => true,
            // A mass comes of one equation.
            Find::Quantity(quantity) => matches!(quantity.of_its_impact(), Quantity::Mass(_)),
            Find::Vector(..) => false,
        };
        let is_range = own.iter().any(|blank| part.blanks[*blank].model.kind == Kind::Range);
        let is_to_be_found = part.blanks.iter().any(is_letter) || is_range;
        let is_by_luck = is_to_be_found && !has_right_value;
        let counts = |wrong: &usize| part.scheme[*wrong].code.is_method() || is_by_luck;
        let leads = |wrong: usize, blank: usize| needed[wrong][blank] && part.scheme[wrong].blanks.contains(&blank);
        let is_before = |wrong: &usize| own.iter().any(|blank| leads(*wrong, *blank));
        let missing = wrong.iter().find(|wrong| counts(wrong) && is_before(wrong));
        if let Some(missing) = missing
            && awards[place].given
            && by_answer
            && !awards[place].is(Ground::FollowThrough)
        {
            let feedback = format!("the value is right, but does not follow without {}", part.scheme[*missing].id);
            awards[place] = Award { note: Some(Ground::Depends.tag()), feedback, ..withheld(mark) };
        }
    }
}

/// Values that are right though the equations from which they must come lead elsewhere: a sign is wrong in one of them, which
/// costs its accuracy, and theirs too.
pub(super) fn withhold_from_wrong_equations(
    part: &KeyedPart,
    needed: &[Vec<bool>],
    denied: [bool; 2],
    awards: &mut [Award],
) {
    let scheme = &part.scheme;
    let is_wrong = |place: &usize| {
        let is_law = matches!(scheme[*place].earned_for, EarnedFor::Law(law, _) if law.seen() == Seen::Equation);
        is_law && !awards[*place].given && contradicts(&awards[*place])
    };
    let wrong: Vec<usize> = (0..awards.len()).filter(is_wrong).collect();
    for (place, mark) in scheme.iter().enumerate() {
        // An energy is of both spheres.
        let is_denied = |quantity: &Quantity| match quantity.sphere() {
            Some(of) => Sphere::BOTH.iter().zip(denied).any(|(sphere, denied)| *sphere == of && denied),
            None => denied.contains(&true),
        };
        let is_value = mark.code.is_accuracy() && mark.earned_for.quantities().iter().any(is_denied);
        let own = own_blanks(mark, part);
        let comes_from = |wrong: &usize| {
            let leads = |blank: &usize| needed[*wrong][*blank] && scheme[*wrong].blanks.contains(blank);
            own.iter().any(leads) || depends_on(scheme, place, &|other| other.earned_for == scheme[*wrong].earned_for)
        };
        if is_value && awards[place].given && !awards[place].is(Ground::FollowThrough) && wrong.iter().any(comes_from) {
            let feedback = "the value is right, but does not follow from your equations".to_owned();
            awards[place] = Award { note: Some(Ground::Depends.tag()), feedback, ..withheld(mark) };
        }
    }
}

/// A right value that follows from wrong velocities is one by luck.
pub(super) fn withhold_by_luck(part: &KeyedPart, by_luck: &[bool], awards: &mut [Award]) {
    for ((mark, award), by_luck) in part.scheme.iter().zip(awards).zip(by_luck) {
        if *by_luck && award.given && !award.is(Ground::FollowThrough) {
            let feedback = "the value is right, but it follows from velocities that are not".to_owned();
            *award = Award { note: Some(Ground::Depends.tag()), feedback, ..withheld(mark) };
        }
    }
}

/// An answer that does not follow from the working implies neither of the two equations; who was wrong in one of them has left
/// the component across as it is, and put both together, for all that.
pub(super) fn withhold_implied(part: &KeyedPart, awards: &mut [Award]) {
    let is_denied = |blank: &KeyedBlank| {
        let own =
            || part.scheme.iter().zip(&*awards).filter(|(mark, _)| mark.code.is_accuracy() && is_own(mark, blank));
        own().next().is_some() && own().all(|(_, award)| !award.given && award.is(Ground::Depends))
    };
    let denied: Vec<bool> = part.blanks.iter().map(is_denied).collect();
    for (mark, award) in part.scheme.iter().zip(awards) {
        let by_denied = matches!(&award.evidence, Some(Evidence { place: Place::Answer(blank), .. }) if denied[*blank]);
        let is_equation = matches!(mark.earned_for, EarnedFor::Law(law, _) if law.seen() == Seen::Equation);
        if is_equation && award.given && award.is(Ground::Implied) && by_denied {
            let feedback = "the answer that would imply it does not follow from your working".to_owned();
            *award = Award { note: Some(Ground::Depends.tag()), feedback, ..withheld(mark) };
        }
    }
}

/// Does a mark depend on one like this, by itself or by another?
fn depends_on(scheme: &[KeyedMark], place: usize, is: &dyn Fn(&KeyedMark) -> bool) -> bool {
    scheme[place].depends.iter().any(|other| is(&scheme[*other]) || depends_on(scheme, *other, is))
}

/// Is a step written wrongly, so that the answer cannot have come from it? What is true of the right values is no such line.
pub(super) fn contradicts(shown: &Award) -> bool {
    let wrong = [
        "sign-error",
        Ground::Contradicted.tag(),
        "sincos-swap",
        "wrong-axis",
        "e-wrong-side",
        "e-taken-as-1",
        "masses-swapped",
        "masses-omitted",
        "not-resolved",
        "term-missing",
        "mass-missing",
        "velocity-elsewhere",
        "coalesce",
        "e-misread",
        "number-misread",
        "brackets-lost",
        "inequality-reversed",
        "energy-square-of-difference",
        "energy-components-added",
        // A value that is stated, and is another though not by much.
        "near-miss",
    ];
    shown.note.is_some_and(|note| wrong.contains(&note))
}

/// Is a letter left out of a step, and put back in the answer that would imply it? From an answer without letters it cancels.
pub(super) fn lacks_letter(shown: &Award, implied: &Award, part: &KeyedPart) -> bool {
    let is_in_letters = |evidence: &Evidence| match evidence.place {
        Place::Answer(blank) => part.blanks[blank].model.kind == Kind::Expression,
        Place::Line(_) => false,
    };
    shown.note == Some(Note::LetterMissing.tag()) && implied.evidence.as_ref().is_some_and(is_in_letters)
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
            award.note = Some(Ground::Depends.tag());
            award.feedback = format!("depends on {needed}");
        }
    }
}
