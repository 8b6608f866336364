//! From a question file to a question, with every fault of the file.

mod declared;
mod marks;
mod names;
mod parts;
mod quantities;
mod reference;
mod scene;
mod shown;
mod solvable;
mod styles;
mod values;

use super::document::Faults;
use super::file::{self, QuestionFile};
use super::question::Question;
use crate::diagnostic::{Diagnostic, Severity, Source};
use declared::Asked;
use names::NamesUsed;

/// Reads and checks a question file. `id` is its path in the bank without `.toml`.
///
/// # Errors
///
/// Every fault of the file, each with its line, in the order of the file.
pub fn read_question(id: &str, source: &Source) -> Result<Question, Vec<Diagnostic>> {
    let mut faults = Faults::new(source.clone());
    let question = file::read(&mut faults).and_then(|file| check(id, &file, &mut faults));
    let mut found = faults.found;
    found.sort_by_key(|fault| fault.span.start);
    // What every style finds wrong with what they share is wrong once.
    found.dedup();
    let usable = found.iter().all(|fault| fault.severity == Severity::Warning);
    match question {
        Some(question) if usable => Ok(question),
        _ => Err(found),
    }
}

fn check(id: &str, file: &QuestionFile, faults: &mut Faults) -> Option<Question> {
    let mut used = NamesUsed::default();
    let (styles, scopes) = styles::styles(file, &mut used, faults);
    if let Some(scene) = &file.scene {
        scene::scene(scene, &mut used, faults);
    }
    values::values(file, faults);
    let parts = parts::parts(file, &mut used, faults);
    shown::shown(&parts, file, faults);
    let (reference, reference_style) = reference::reference(file, &styles, &mut used, faults);
    let asked = Asked { styles: &styles, parts: &parts, reference: &reference, reference_style };
    let declared = declared::declared(file, &asked, &mut used, faults);
    let letters = file.scene.as_ref().map(|scene| scene.letters()).unwrap_or_default();
    used.resolve(&scopes, &letters, faults);
    if !faults.found.is_empty() {
        return None;
    }
    let question = Question {
        id: id.to_owned(),
        title: file.title.as_ref()?.get_ref().clone(),
        mirrors: file.mirrors.as_ref().map(|words| words.get_ref().clone()),
        topic: file.topic.as_ref()?.get_ref().clone(),
        styles,
        scene: file.scene.as_ref()?.text.clone(),
        parts,
        reference,
        reference_style,
        erratum: file.erratum.as_ref().map(|words| words.get_ref().clone()),
        hidden: declared.hidden,
        alike: declared.alike,
        tests: declared.tests,
    };
    solvable::solvable(&question, file, faults);
    Some(question)
}
