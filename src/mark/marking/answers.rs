//! The blanks of a part judged, whether they were filled in one by one or all on one line.

use crate::answer::{Accept, Kind};
use crate::mark::award::MarkedAnswer;
use crate::mark::judging::{Judgement, Model, Note, Verdict, judge, judge_together};
use crate::mark::key::{KeyedBlank, KeyedPart};
use crate::mark::profile::Profile;
use crate::mark::reading::{Reading, Unreadable, read_answer};
use crate::mark::script::PartScript;
use crate::number::Places;

/// A verdict for each blank, in the order of the key, and how each that was filled in by itself was read.
pub(super) fn judged(
    part: &KeyedPart,
    script: &PartScript,
    profile: &Profile,
) -> (Vec<MarkedAnswer>, Vec<Option<Vec<Reading>>>) {
    let models: Vec<Model> = part.blanks.iter().map(|blank| in_profile(&blank.model, profile)).collect();
    let named = |blank: &KeyedBlank| {
        // The last word counts where a blank was filled in twice.
        let own =
            script.answers.iter().rev().find(|(name, _)| name.as_deref().is_some_and(|name| is_called(name, blank)));
        own.map(|(_, answer)| answer.clone())
    };
    let unnamed = script.answers.iter().rev().find(|(name, _)| name.is_none()).map(|(_, answer)| answer.as_str());
    let mut alone = None;
    let together: Vec<Option<Judgement>> = match unnamed {
        None => models.iter().map(|_| None).collect(),
        Some(answer) => {
            let readings = read_answer(answer, &together_vocabulary(&models));
            match models.as_slice() {
                [model] => {
                    let judgement = judge(model, &readings);
                    alone = readings.ok();
                    vec![Some(judgement)]
                }
                several => judge_together(several, &readings).into_iter().map(Some).collect(),
            }
        }
    };
    let each = part.blanks.iter().zip(&models).zip(together);
    each.map(|((blank, model), together)| {
        let (typed, judgement, readings) = match (named(blank), together) {
            (Some(answer), _) => {
                let readings = read_answer(&answer, &model.vocabulary);
                (Some(answer), judge(model, &readings), readings.ok())
            }
            (None, Some(judgement)) => (unnamed.map(str::to_owned), judgement, alone.take()),
            (None, None) => (None, judge(model, &Err(Unreadable::Blank)), None),
        };
        let judgement = profiled(judgement, profile);
        (MarkedAnswer { name: blank.name.clone(), typed, judgement, causes: Vec::new() }, readings)
    })
    .unzip()
}

/// Is it the name of this blank, however it is spaced?
fn is_called(name: &str, blank: &KeyedBlank) -> bool {
    name.split_whitespace().eq(blank.name.split_whitespace())
}

/// All models of a part have the letters of one question; one of them may have vectors.
fn together_vocabulary(models: &[Model]) -> crate::mark::reading::Vocabulary {
    let letters = models.first().map(|model| model.vocabulary.letters.clone()).unwrap_or_default();
    let vectors = models.iter().any(|model| model.vocabulary.vectors);
    crate::mark::reading::Vocabulary { letters, vectors }
}

/// The figures that a profile asks for where the key has the usual three.
fn in_profile(model: &Model, profile: &Profile) -> Model {
    let usual = Accept::RoundsTo(Places::SignificantFigures(3));
    let accept = match &model.accept {
        accept if *accept == usual => Accept::RoundsTo(Places::SignificantFigures(profile.figures)),
        other => other.clone(),
    };
    Model { accept, ..model.clone() }
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
