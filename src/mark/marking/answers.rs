//! The blanks of a part judged, whether they were filled in one by one or all on one line.

use std::borrow::Cow;
use std::rc::Rc;

use super::memory::{Judged, Memory};
use crate::answer::{Accept, Kind};
use crate::expr::Expr;
use crate::mark::award::MarkedAnswer;
use crate::mark::judging::{Judgement, Model, Note, Verdict, judge, judge_together};
use crate::mark::key::{KeyedBlank, KeyedPart};
use crate::mark::profile::Profile;
use crate::mark::reading::{Unreadable, read_answer};
use crate::mark::script::PartScript;
use crate::number::Places;

/// A verdict for each blank, in the order of the key, and what was found of each answer that was given to it alone.
pub(super) fn judged(
    part: &KeyedPart,
    script: &PartScript,
    profile: &Profile,
    memory: &mut Memory,
) -> (Vec<MarkedAnswer>, Vec<Rc<Judged>>) {
    let unnamed = script.answers.iter().rev().find(|(name, _)| name.is_none()).map(|(_, answer)| answer.as_str());
    let all_at_once = |answer: &str| {
        let models: Vec<Model> =
            part.blanks.iter().map(|blank| in_profile(&blank.model, profile).into_owned()).collect();
        judge_together(&models, &read_answer(answer, &together_vocabulary(&models)))
    };
    let is_right = |judgement: &Judgement| judgement.verdict == Verdict::Correct;
    let last_line = || {
        let line = script.working.iter().flat_map(|cell| cell.lines()).rfind(|line| !line.trim().is_empty());
        line.filter(|line| script.answers.is_empty() && all_at_once(line).iter().all(is_right))
    };
    let unnamed = unnamed.or_else(|| if part.blanks.len() > 1 { last_line() } else { None });
    let mut together = match (unnamed, part.blanks.as_slice()) {
        (None, _) | (Some(_), [_]) => Vec::new(),
        (Some(answer), _) => all_at_once(answer),
    }
    .into_iter();
    let each = part.blanks.iter().map(|blank| {
        // The last word counts where a blank was filled in twice.
        let own = script
            .answers
            .iter()
            .rev()
            .find(|(name, _)| name.as_deref().is_some_and(|name| is_name_of(name, &blank.name)));
        let alone = own.map(|(_, answer)| answer.as_str()).or(unnamed.filter(|_| part.blanks.len() == 1));
        let alone = alone.or_else(|| left_in_working(blank, part, script, profile).filter(|_| unnamed.is_none()));
        let together = together.next();
        let found = match (alone, together) {
            (Some(answer), _) => memory.judged(blank, answer, || {
                let model = in_profile(&blank.model, profile);
                let readings = read_answer(answer, &model.vocabulary);
                Judged::new(profiled(judge(&model, &readings), profile).in_setting(part.setting), readings.ok())
            }),
            (None, Some(together)) => Judged::new(profiled(together, profile).in_setting(part.setting), None),
            (None, None) => Judged::new(judge(&blank.model, &Err(Unreadable::Blank)), None),
        };
        let typed = alone.or(unnamed).map(str::to_owned);
        let (name, judgement) = (blank.name.clone(), found.judgement.clone());
        (MarkedAnswer { name, typed, judgement, causes: Vec::new() }, found)
    });
    each.unzip()
}

/// A right answer that was left where the working ends, and not filled in: one of the last lines, as many as there are
/// blanks. What is not right there may be a step on the way.
fn left_in_working<'s>(
    blank: &KeyedBlank,
    part: &KeyedPart,
    script: &'s PartScript,
    profile: &Profile,
) -> Option<&'s str> {
    let lines = script.working.iter().flat_map(|cell| cell.lines()).map(str::trim).filter(|line| !line.is_empty());
    let last = lines.collect::<Vec<_>>().into_iter().rev().take(part.blanks.len());
    let model = in_profile(&blank.model, profile);
    let is_right = |line: &&str| {
        let readings = read_answer(line, &model.vocabulary);
        let Some(statements) = readings.as_ref().ok().and_then(|all| all.first()).map(|one| &one.statements) else {
            return false;
        };
        // `v = 3, w = 5` is for two blanks, and not the second value for either; `w − v = 3` is for none.
        let is_alone = part.blanks.len() == 1 || statements.len() == 1;
        let is_equation = |typed: &str| typed.contains(['+', '-', '−', '*', '×', '/', '(']);
        let is_result = statements.iter().filter_map(|one| one.label.as_ref()).all(|label| !is_equation(&label.typed));
        is_alone && is_result && profiled(judge(&model, &readings), profile).verdict == Verdict::Correct
    };
    // Nought may be anything's: that a sphere is at rest is often given.
    let is_wanted = !is_shown(blank) && blank.model.value != Expr::integer(0);
    last.filter(|_| is_wanted).find(is_right)
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

/// The figures that a profile asks for where the key has the usual three.
fn in_profile<'m>(model: &'m Model, profile: &Profile) -> Cow<'m, Model> {
    const USUAL: Accept = Accept::RoundsTo(Places::SignificantFigures(3));
    if model.accept != USUAL || profile.figures == 3 {
        return Cow::Borrowed(model);
    }
    Cow::Owned(Model { accept: Accept::RoundsTo(Places::SignificantFigures(profile.figures)), ..model.clone() })
}

/// A verdict that is right for this profile, though partly right for another.
fn profiled(judgement: Judgement, profile: &Profile) -> Judgement {
    let condoned = match judgement.note {
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
