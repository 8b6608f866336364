//! Judging what was read against a model answer.
//!
//! Equality is exact: refuted by certified intervals, proved by the normal form, never measured. Decimals are judged by
//! the figures that were written. Every verdict says which reading it used, and why in a tag and a sentence.

mod accuracy;
mod angle;
mod angle_at_points;
mod as_printed;
mod besides;
mod bounds;
mod called;
mod chain;
mod changes;
mod coarsest;
mod coefficients;
mod effort;
mod equation;
mod events;
mod exact;
mod finding;
mod given_values;
mod known;
mod left_side;
mod letters;
mod line;
mod measured;
mod misnamed;
mod model;
mod model_text;
mod moments;
mod multiplied;
mod note;
mod number;
mod otherwise;
mod powers;
mod quotients;
mod range;
mod ratio;
mod said_twice;
mod selection;
mod sense;
mod several;
mod shown;
mod sides;
mod sorts;
mod sources;
mod spheres;
mod statements;
mod tenths;
mod together;
mod turns;
mod units;
mod vector;
mod velocity;

use std::borrow::Cow;

use crate::answer::Kind;
use crate::mechanics::Setting;

use super::reading::{Reading, Said, Unreadable, is_strange};
pub(super) use as_printed::has_fraction_within;
pub(super) use called::{is_named, is_of_a_part, may_be_named, words_fit};
pub(super) use chain::{is_nearly_rounding, is_rounding};
use finding::Finding;
pub(super) use left_side::is_made_of_others;
pub use model::Model;
pub use model_text::ModelOptions;
pub use note::Note;
pub(super) use shown::is_printed_value;
pub(super) use spheres::named_spheres;
pub use together::judge_together;
pub(super) use units::dimension;

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

impl Verdict {
    /// As it stands in files: `correct`, `partial`, `wrong`, `unreadable`, `blank`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Correct => "correct",
            Verdict::Partial => "partial",
            Verdict::Wrong => "wrong",
            Verdict::Unreadable => "unreadable",
            Verdict::Blank => "blank",
        }
    }
}

/// A verdict with its reasons.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// The reading that was used, in the notation of a terminal.
    pub reading: Option<String>,
    /// A fixed tag, free of the question's numbers: `under-accurate`, `truncated`, `unit-wrong`.
    pub note: Option<&'static str>,
    /// What a teacher would say.
    pub feedback: String,
}

impl Judgement {
    /// The same of an answer that is wrong, and nothing more to be said of its figures.
    pub(crate) fn simply_wrong(self) -> Judgement {
        Judgement {
            verdict: Verdict::Wrong,
            note: None,
            feedback: note::plain_sentence(Verdict::Wrong).to_owned(),
            ..self
        }
    }

    /// The same in the words of a setting: what is the common tangent of two spheres is a wall for one.
    pub(crate) fn in_setting(self, setting: Setting) -> Judgement {
        let said = |words: String| match setting.say(&words) {
            Cow::Owned(said) => said,
            Cow::Borrowed(_) => words,
        };
        Judgement { reading: self.reading.map(said), feedback: said(self.feedback), ..self }
    }
}

/// Judges an answer where one thing is asked.
///
/// Every reading is one that a person might see; the first of those that fare best is used, and named.
pub fn judge(model: &Model, readings: &Result<Vec<Reading>, Unreadable>) -> Judgement {
    let readings = match readings {
        Ok(readings) => readings,
        Err(unreadable) => return refused(unreadable),
    };
    let mut said = 0;
    let first_readings = readings.iter().take_while(|reading| {
        let before = said;
        said += count_said(reading);
        before < MOST_SAID
    });
    let found = first_readings.map(|reading| (one(model, reading), reading));
    let best = found.reduce(|best, next| if best.0.or_better(next.0) == best.0 { best } else { next });
    match best {
        // `8,540` for 8.544: rightly rounded it would be a decimal comma; so it may be thousands.
        Some((finding, reading)) if finding.note == Some(Note::LaterFigures) && reading.has_decimal_comma() => {
            report(Finding::unreadable(Note::CannotBeRead), Some(reading))
        }
        Some((finding, reading)) => report(finding, Some(reading)),
        None => report(Finding::unreadable(Note::CannotBeRead), None),
    }
}

/// Words beside a value that take it back.
const DENIALS: [&str; 8] = ["not", "isn't", "isnt", "never", "wrong", "incorrect", "false", "except"];
/// Words that turn the direction beside them into another.
const TURNS: [&str; 7] = ["perpendicular", "perp", "normal", "right angles", "opposite", "reverse", "reversed"];
/// Words that leave the length of the vector beside them open.
const MULTIPLES: [&str; 5] = ["multiple", "prop", "∝", "parallel", "same direction"];
/// Words that turn the sense beside them round.
const OPPOSITES: [&str; 3] = ["opposite", "reverse", "backwards"];

/// Do the words beside a value change what it says? Then only a person can tell what is meant.
fn is_turned_by_words(model: &Model, reading: &Reading) -> bool {
    let is_direction = matches!(model.kind, Kind::Vector | Kind::Velocity | Kind::Line | Kind::Angle)
        && !velocity::is_told_by_components(model, reading);
    // A component has a sense of its own, and words may turn that too.
    let is_signed = number::has_a_sense(model.quantity);
    let mut remarks = reading.remarks();
    remarks.any(|remark| {
        let mut words = remark.split(|letter: char| !letter.is_alphanumeric() && letter != '\'');
        // `as no impulse acts across it`: without figures a reason says why, and not what.
        let is_reason = ["because ", "since ", "as no ", "as there is no "].iter().any(|why| remark.starts_with(why))
            && !remark.contains(|sign: char| sign.is_ascii_digit());
        let turned = is_direction && !is_reason && TURNS.iter().any(|turn| remark.contains(turn));
        let opposite = is_signed && OPPOSITES.iter().any(|turn| remark.contains(turn));
        let is_multiple = model.kind == Kind::Vector && MULTIPLES.iter().any(|word| remark.contains(word));
        let is_denied = words.any(|word| DENIALS.contains(&word)) && !is_reason && !events::denies_a_meeting(remark);
        // `7 (nonsense)`
        turned || is_multiple || opposite || is_strange(remark.trim()) || is_denied
    })
}

/// An answer that says more things than this is a list for a person to look through. Once its readings say so many
/// together, no further reading is judged.
const MOST_SAID: usize = 16;

fn count_said(reading: &Reading) -> usize {
    reading.statements.iter().map(|statement| statement.said.len().max(1)).sum()
}

/// Judges one reading.
fn one(model: &Model, reading: &Reading) -> Finding {
    if count_said(reading) > MOST_SAID {
        return Finding::unreadable(Note::TooLong);
    }
    let reading = &*spheres::each_to_its_own(reading);
    let (reading, is_from_unknown) = &measured::from_named_lines(model, reading);
    let whole = &**reading;
    if selection::rejects_by_description(reading) {
        return Finding::unreadable(Note::CannotBeCompared);
    }
    if events::is_of_another_meeting(model, reading) {
        return Finding::unreadable(Note::CannotBeCompared);
    }
    if spheres::are_mixed_up(reading) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let Some(reading) = &selection::counted(model, reading) else {
        return Finding::unreadable(Note::CannotBeCompared);
    };
    if let Some(finding) = range::out_of_place(model, reading) {
        return finding;
    }
    let finding = match sense::is_beside_the_path(model, whole) {
        true => by_kind(model, reading).at_most_partial(Note::DirectionUnchecked),
        false => by_kind(model, reading),
    };
    if finding.verdict == Verdict::Wrong && given_values::come_to_the_answer(model, reading) {
        return Finding::unreadable(Note::CannotBeCompared);
    }
    if finding.is_credited() && *is_from_unknown {
        return Finding::unreadable(Note::ReferenceUnchecked);
    }
    if finding.is_credited() && is_turned_by_words(model, reading) {
        return Finding::unreadable(Note::CannotBeCompared);
    }
    if finding.is_credited() && misnamed::is_of_something_else(model, reading) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    // Where north is, no question says.
    let is_of_angle = matches!(model.kind, Kind::Angle | Kind::Velocity);
    let is_open = is_of_angle && finding.verdict != Verdict::Unreadable;
    if is_open && reading.statements.iter().any(called::is_a_bearing) {
        return Finding::unreadable(Note::ReferenceUnchecked);
    }
    // After the impact the spheres move away from each other, in whichever sense each of them moves.
    let is_away = |said: &Said| said.remarks.iter().any(|remark| remark.contains("away from"));
    let is_of_sense = matches!(finding.note, Some(Note::Sign | Note::Supplement | Note::DirectionWrong));
    if is_of_sense && reading.statements.iter().flat_map(|statement| &statement.said).any(is_away) {
        return Finding::unreadable(Note::DirectionUnchecked);
    }
    finding
}

fn by_kind(model: &Model, reading: &Reading) -> Finding {
    match model.kind {
        Kind::Velocity => velocity::judge(model, reading),
        Kind::Equation => equation::judge(model, reading),
        Kind::Range => range::judge(model, reading),
        Kind::Shown => shown::judge(model, reading),
        Kind::Number | Kind::Expression => {
            // `2 to 3` for 2/3, as `2 : 3`
            let ratio = ratio::of_its_terms(reading).filter(|(_, label)| !ratio::is_a_list(reading, label.as_ref()));
            let as_ratio = ratio.map(|(said, _)| number::judge(model, &said, None)).filter(|found| found.is_credited());
            let as_number = || statements::judge(model, reading, &|said, label| number::judge(model, said, label));
            as_ratio.unwrap_or_else(as_number)
        }
        Kind::Angle => statements::judge(model, reading, &|said, label| angle::judge(model, said, label)),
        Kind::Vector => match vector::of_its_components(model, reading) {
            Some(said) => vector::judge(model, &said),
            None if vector::is_unsolved_for_its_components(reading) => Finding::unreadable(Note::CannotBeCompared),
            None => vector::is_of_size_and_angle(model, reading)
                .or_else(|| vector::is_of_components_by_a_line(model, reading))
                .unwrap_or_else(|| statements::judge(model, reading, &|said, _| vector::judge(model, said))),
        },
        Kind::Ratio => match ratio::of_its_terms(reading) {
            Some((said, label)) => {
                let finding = ratio::judge(model, &said, label.as_ref());
                let is_open = finding.is_credited() && ratio::is_a_list(reading, label.as_ref());
                if is_open { Finding::unreadable(Note::CannotBeCompared) } else { finding }
            }
            None => statements::judge(model, reading, &|said, label| ratio::judge(model, said, label)),
        },
        Kind::Line if reading.statements.iter().all(|statement| statement.label.is_some()) => {
            match vector::of_its_components(model, reading) {
                Some(said) => line::judge(model, &said, None),
                None => statements::judge(model, reading, &|said, label| line::judge(model, said, label)),
            }
        }
        Kind::Line => statements::judge(model, reading, &|said, label| line::judge(model, said, label)),
    }
}

/// Nothing was said of it.
const BLANK: Finding = Finding { verdict: Verdict::Blank, note: Some(Note::Blank), exact: false };

fn refused(unreadable: &Unreadable) -> Judgement {
    match unreadable {
        Unreadable::Blank => report(BLANK, None),
        Unreadable::TooLong => report(Finding::unreadable(Note::TooLong), None),
        Unreadable::Sign(..) => report(Finding::unreadable(Note::CannotBeRead), None),
    }
}

fn report(finding: Finding, reading: Option<&Reading>) -> Judgement {
    Judgement {
        verdict: finding.verdict,
        reading: reading.map(|reading| reading.printed.clone()),
        note: finding.note.map(Note::tag),
        feedback: finding.note.map_or(note::plain_sentence(finding.verdict), Note::sentence).to_owned(),
    }
}

#[cfg(test)]
mod effort_tests;
#[cfg(test)]
mod kinds_tests;
#[cfg(test)]
mod left_side_tests;
#[cfg(test)]
mod question_tests;
#[cfg(test)]
mod range_tests;
#[cfg(test)]
mod rivals_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod typed_tests;
