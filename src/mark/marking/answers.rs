//! The blanks of a part judged, whether they were filled in one by one or all on one line.

use std::borrow::Cow;
use std::rc::Rc;

use super::decide::ENOUGH;
use super::left::Left;
use super::memory::{Judged, Lines, Memory};
use super::rounded::rounded_from;
use crate::answer::{Accept, Kind};
use crate::mark::award::MarkedAnswer;
use crate::mark::judging::{Judgement, Model, Note, Verdict, judge, judge_together};
use crate::mark::key::{KeyedBlank, KeyedPart};
use crate::mark::profile::Profile;
use crate::mark::reading::{Reading, Unreadable, read_answer};
use crate::mark::script::PartScript;
use crate::mark::working::Examined;
use crate::number::Places;

/// A verdict for each blank, in the order of the key, and what was found of each answer that was given to it alone.
pub(super) fn judged(
    part: &KeyedPart,
    script: &PartScript,
    profile: &Profile,
    memory: &mut Memory,
    examined: &Examined,
    lines: &Lines,
) -> (Vec<MarkedAnswer>, Vec<Rc<Judged>>) {
    let unnamed = script.answers.iter().rev().find(|(name, _)| name.is_none()).map(|(_, answer)| answer.as_str());
    let all_at_once = |answer: &str| {
        let models: Vec<Model> =
            part.blanks.iter().map(|blank| in_profile(&blank.model, profile).into_owned()).collect();
        judge_together(&models, &read_answer(answer, &together_vocabulary(&models)))
    };
    let left = Left::of(part, script, examined);
    let unnamed = unnamed.or_else(|| left.for_all(&all_at_once).filter(|_| script.answers.is_empty()));
    let unnamed = unnamed.or_else(|| all_in_one(part, script).filter(|answer| are_all_credited(&all_at_once(answer))));
    let mut together = match (unnamed, part.blanks.as_slice()) {
        (None, _) | (Some(_), [_]) => Vec::new(),
        (Some(answer), _) => all_at_once(answer),
    }
    .into_iter();
    let each = part.blanks.iter().enumerate().map(|(place, blank)| {
        // The last word counts where a blank was filled in twice.
        let own = script
            .answers
            .iter()
            .rev()
            .find(|(name, _)| name.as_deref().is_some_and(|name| is_name_of(name, &blank.name)));
        let own = own.map(|(_, answer)| answer.as_str()).filter(|own| unnamed != Some(own));
        let alone = own.or(unnamed.filter(|_| part.blanks.len() == 1));
        let together = together.next();
        let is_typed = alone.or(unnamed).is_some();
        let model = in_profile(&blank.model, profile);
        let verdict = |readings: &Result<Vec<Reading>, Unreadable>| {
            profiled(judge_for(profile, &model, readings), &model, profile).in_setting(part.setting)
        };
        let mut judged = |answer: &str| {
            memory.judged(blank, answer, || {
                // Every blank may look at every line, and nobody else at an answer.
                let readings = match is_typed {
                    true => Rc::new(lines.read_answer(answer, &model.vocabulary)),
                    false => lines.read(answer, &model.vocabulary),
                };
                Judged::new(verdict(&readings), Rc::unwrap_or_clone(readings).ok())
            })
        };
        let stated = || {
            let (line, readings) = left.stated(place)?;
            let readings = Ok(readings);
            Some((line, Judged::new(verdict(&readings), readings.ok())))
        };
        let left = match is_typed {
            true => None,
            false => left.for_one(place, lines, &mut judged).or_else(stated),
        };
        let typed = alone.or(unnamed).or(left.as_ref().map(|(line, _)| *line)).map(str::to_owned);
        let found = match (alone, left, together) {
            (Some(answer), ..) => {
                let found = judged(answer);
                // What looks cut off may be a value of the working, rounded: then that is what is right or wrong.
                let is_cut_off = found.judgement.note == Some(Note::Truncated.tag());
                let readings = found.readings.as_deref().filter(|_| is_cut_off);
                let longer = readings.and_then(|readings| rounded_from(part, place, readings, script, lines));
                longer.map_or(found, |longer| judged(&longer))
            }
            (None, Some((_, found)), _) => found,
            (None, None, Some(together)) => {
                Judged::new(profiled(together, &blank.model, profile).in_setting(part.setting), None)
            }
            (None, None, None) => Judged::new(judge(&blank.model, &Err(Unreadable::Blank)), None),
        };
        let (name, judgement) = (blank.name.clone(), found.judgement.clone());
        (MarkedAnswer { name, typed, judgement, causes: Vec::new() }, found)
    });
    each.unzip()
}

/// `1 and 2` in one of two blanks, and nothing in the other: what may be the answer to both.
fn all_in_one<'s>(part: &KeyedPart, script: &'s PartScript) -> Option<&'s str> {
    match script.answers.as_slice() {
        [(Some(_), answer)] if part.blanks.len() > 1 && is_list(answer) => Some(answer),
        _ => None,
    }
}

fn is_list(answer: &str) -> bool {
    answer.contains([',', ';', '&', '\n']) || answer.contains(" and ")
}

fn are_all_credited(judgements: &[Judgement]) -> bool {
    judgements.iter().all(|judgement| matches!(judgement.verdict, Verdict::Correct | Verdict::Partial))
}

/// Is what was written the name of this blank, however it is spaced?
pub(super) fn is_name_of(written: &str, blank: &str) -> bool {
    written.split_whitespace().eq(blank.split_whitespace())
}

/// All models of a part have the letters of one question; one of them may have vectors.
fn together_vocabulary(models: &[Model]) -> crate::mark::reading::Vocabulary {
    let letters = models.first().map(|model| model.vocabulary.letters.clone()).unwrap_or_default();
    let vectors = models.iter().any(|model| model.vocabulary.vectors);
    crate::mark::reading::Vocabulary { letters, vectors }
}

/// What a key asks for as a rule.
const USUAL: Accept = Accept::RoundsTo(Places::SignificantFigures(FIGURES));
const FIGURES: u32 = 3;

/// More figures than the usual three of a key, where a profile asks for them; fewer are fewer figures, and no other value.
fn in_profile<'m>(model: &'m Model, profile: &Profile) -> Cow<'m, Model> {
    match model.accept == USUAL && profile.figures > FIGURES {
        true => Cow::Owned(with_figures(model, profile.figures)),
        false => Cow::Borrowed(model),
    }
}

fn with_figures(model: &Model, figures: u32) -> Model {
    Model { accept: Accept::RoundsTo(Places::SignificantFigures(figures)), ..model.clone() }
}

/// The verdict on an answer. Where one figure is enough, that is looked at which is no evidence elsewhere.
fn judge_for(profile: &Profile, model: &Model, readings: &Result<Vec<Reading>, Unreadable>) -> Judgement {
    let judgement = judge(model, readings);
    let is_one_figure = judgement.note == Some(Note::TooFewFigures.tag());
    match is_one_figure && model.accept == USUAL && profile.figures < ENOUGH {
        true => judge(&with_figures(model, profile.figures), readings),
        false => judgement,
    }
}

/// A verdict that is right for this profile, though partly right for another. Where two figures are enough, 4.4 is right for
/// 4.384 and 4.35 is not: who writes three has them right.
fn profiled(judgement: Judgement, model: &Model, profile: &Profile) -> Judgement {
    let condoned = match judgement.note {
        Some(note) if note == Note::UnderAccurate.tag() => model.accept == USUAL && profile.figures <= ENOUGH,
        Some(note) if note == Note::Coordinates.tag() => profile.coordinates,
        Some(note) if note == Note::RadiansUnstated.tag() => profile.radians,
        _ => false,
    };
    if condoned { Judgement { verdict: Verdict::Correct, ..judgement } } else { judgement }
}

/// Is the blank one whose final line earns nothing by itself?
pub(super) fn is_shown(blank: &KeyedBlank) -> bool {
    blank.model.kind == Kind::Shown
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mark::judging::ModelOptions;

    #[test]
    fn fewer_figures_than_three_are_fewer_figures_and_no_other_value() {
        let model =
            Model::read("4*sqrt(39)/9", &ModelOptions { accept: Some(USUAL), ..ModelOptions::default() }).unwrap();
        let verdict = |figures: u32, typed: &str| {
            let profile = Profile { figures, ..Profile::default() };
            let model = in_profile(&model, &profile);
            let readings = read_answer(typed, &model.vocabulary);
            profiled(judge_for(&profile, &model, &readings), &model, &profile).verdict
        };
        for (typed, of_four, of_three, of_two, of_one) in [
            ("2.776", "correct", "correct", "correct", "correct"),
            ("2.78", "partial", "correct", "correct", "correct"),
            ("2.8", "partial", "partial", "correct", "correct"),
            ("3", "wrong", "wrong", "wrong", "correct"),
            ("2", "wrong", "wrong", "wrong", "wrong"),
            ("2.5", "wrong", "wrong", "wrong", "wrong"),
            ("2.74", "wrong", "wrong", "wrong", "wrong"),
        ] {
            let found = [4, 3, 2, 1].map(|figures| verdict(figures, typed).name());
            assert_eq!(found, [of_four, of_three, of_two, of_one], "{typed}");
        }
    }
}
