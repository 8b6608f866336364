//! Answers beside working that says another thing: a right one has not come from where another value was found, and one with too
//! few figures has lost nothing that a line has.

use super::decide::is_own;
use super::memory::Lines;
use crate::bank::Find;
use crate::mark::award::{Award, Evidence, Ground, MarkedAnswer, Place};
use crate::mark::enclosure::about;
use crate::mark::judging::{Judgement, Note, Verdict, judge};
use crate::mark::key::{KeyedBlank, KeyedMark, KeyedPart, KeyedQuestion};
use crate::mark::reading::{Form, Reading, Statement};
use crate::mark::script::PartScript;
use crate::mark::working::{Examined, typed_lines};
use crate::mechanics::{Axis, Moment, Quantity, Setting, Sphere};

/// Of answers that are right though the working has found nothing but another value for them, or its equations deny them, says
/// so: they are partly right, and imply nothing.
pub(super) fn contradict(
    question: &KeyedQuestion,
    part: &KeyedPart,
    script: &PartScript,
    examined: &Examined,
    lines: &Lines,
    answers: &mut [MarkedAnswer],
) {
    for (place, (blank, answer)) in part.blanks.iter().zip(answers).enumerate() {
        let is_typed = script.answers.iter().any(|(_, typed)| Some(typed) == answer.typed.as_ref());
        let is_denied = || match &blank.find {
            Find::Unknown(_) => examined.denies_what_is_found,
            Find::Quantity(quantity) if question.prepared().letter_of(*quantity).is_some() => {
                examined.denies_what_is_found || examined.denied.get(place) == Some(&true)
            }
            Find::Quantity(quantity) if is_denied_by_one_equation(question, examined, *quantity) => true,
            _ => examined.denied.get(place) == Some(&true),
        };
        let is_stated_otherwise = || {
            // Of a letter that is to be found there may be a root that is left out.
            let is_value = !matches!(blank.find, Find::Unknown(_));
            let stated = examined.stated.get(place).and_then(Option::as_ref);
            let stated = stated.filter(|stated| is_value && stated.is_never_right);
            stated
                .is_some_and(|stated| judge(&blank.model, &Ok(vec![stated.reading.clone()])).verdict == Verdict::Wrong)
        };
        // An answer that was left in the working is what that comes to.
        let is_contradicted =
            || is_denied() || is_typed && (comes_to_another(blank, script, lines) || is_stated_otherwise());
        let is_taken = is_typed || answer.typed.is_some();
        if answer.judgement.verdict == Verdict::Correct && is_taken && is_contradicted() {
            answer.judgement.verdict = Verdict::Partial;
            answer.judgement.note = Some(Ground::Contradicted.tag());
            answer.judgement.feedback = "This is the right value, but your working comes to another.".to_owned();
        }
    }
}

/// Is it, in a straight line, the one velocity after the impact that is not given, and is it no root of any equation that the lines have for it?
fn is_denied_by_one_equation(question: &KeyedQuestion, examined: &Examined, asked: Quantity) -> bool {
    let (Quantity::Speed(of, Moment::After) | Quantity::Velocity(of, Moment::After, _)) = asked else { return false };
    let along = [Axis::X, Axis::N].map(|axis| Quantity::Velocity(of.other(), Moment::After, axis));
    let is_other_given = along.iter().any(|velocity| question.given.0.contains_key(velocity));
    question.scene.setting == Setting::Direct
        && is_other_given
        && Sphere::BOTH.iter().zip(examined.denies_velocities).any(|(sphere, denied)| *sphere == of && denied)
}

/// An answer with too few figures says no less than the working does, where a line has the value in all of them: what is rounded
/// after that is let pass.
pub(super) fn take_figures_from_working(
    part: &KeyedPart,
    script: &PartScript,
    examined: &Examined,
    lines: &Lines,
    answers: &mut [MarkedAnswer],
) {
    for (place, (blank, answer)) in part.blanks.iter().zip(answers).enumerate() {
        let is_shown = |(mark, award): (&KeyedMark, &Option<Award>)| {
            let by_line = |award: &Award| {
                let is_line = matches!(&award.evidence, Some(Evidence { place: Place::Line(_), .. }));
                award.given && award.note.is_none() && is_line
            };
            mark.code.is_accuracy() && is_own(mark, blank) && award.as_ref().is_some_and(by_line)
        };
        let is_stated = |line: &str| {
            let readings = lines.read(line, &blank.model.vocabulary);
            let reading = readings.as_ref().as_ref().ok().and_then(|readings| readings.first());
            let mut statements = reading.into_iter().flat_map(|reading| &reading.statements);
            statements.any(|statement| {
                statement.label.is_some() && part.calls(place, statement) && is_right(blank, statement)
            })
        };
        let is_short = answer.judgement.note == Some(Note::UnderAccurate.tag());
        let is_found =
            || part.scheme.iter().zip(&examined.awards).any(is_shown) || typed_lines(&script.working).any(is_stated);
        if is_short && is_found() {
            answer.judgement.verdict = Verdict::Correct;
            answer.judgement.note = None;
            answer.judgement.feedback = "Right.".to_owned();
        }
    }
}

/// Is all that the working says of a letter that is to be found plainly another number? Any other name may be of something
/// else, a formula is no value yet, and a number of the other sign may be the root that is left out.
fn comes_to_another(blank: &KeyedBlank, script: &PartScript, lines: &Lines) -> bool {
    let Find::Unknown(letter) = &blank.find else { return false };
    let Some(right) = about(&blank.model.value, &[]) else { return false };
    let typed = script.working.iter().flat_map(|cell| cell.lines());
    let mut is_another = false;
    for line in typed {
        let readings = lines.read(line, &blank.model.vocabulary);
        let Some(reading) = readings.as_ref().as_ref().ok().and_then(|readings| readings.first()) else { continue };
        let is_of_it = |label: &str| label.trim() == letter;
        let own = |statement: &&Statement| statement.label.as_ref().is_some_and(|label| is_of_it(&label.typed));
        for statement in reading.statements.iter().filter(own).flat_map(each) {
            if verdict(blank, &statement) != Verdict::Wrong {
                return false;
            }
            let stated = statement.said.last().and_then(|said| match &said.form {
                Form::Value(value) => about(value, &[]),
                _ => None,
            });
            is_another |= stated.is_some_and(|stated| stated * right > 0.0);
        }
    }
    is_another
}

/// What a statement says, a value each.
fn each(statement: &Statement) -> impl Iterator<Item = Statement> + '_ {
    statement.said.iter().map(|said| Statement { said: vec![said.clone()], ..statement.clone() })
}

/// The verdict on a value by itself.
fn verdict(blank: &KeyedBlank, statement: &Statement) -> Verdict {
    alone(blank, statement).verdict
}

/// Is a value by itself right, and nothing to be said of its figures?
fn is_right(blank: &KeyedBlank, statement: &Statement) -> bool {
    let judgement = alone(blank, statement);
    judgement.verdict == Verdict::Correct && judgement.note.is_none()
}

fn alone(blank: &KeyedBlank, statement: &Statement) -> Judgement {
    let reading = Reading { statements: vec![statement.clone()], printed: String::new(), decided: Vec::new() };
    judge(&blank.model, &Ok(vec![reading]))
}
