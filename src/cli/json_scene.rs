//! A scene in JSON, with the place of every fault in the file.

use std::collections::BTreeMap;
use std::ops::Range;

use super::json_places::{offset, places};
use crate::bank::scene_names;
use crate::diagnostic::{Diagnostic, Source, near};
use crate::expr::Angles;
use crate::mechanics::{Scene, SceneFault, SceneText};

/// Reads a scene of the exchange format.
///
/// # Errors
///
/// What is no JSON or no scene, or every fault of its formulas.
pub fn read(source: &Source) -> Result<Scene, Vec<Diagnostic>> {
    if !source.text.trim_start().starts_with('{') {
        // A list would do for serde, its fields in order; what is no JSON at all is said below.
        if let Err(error) = serde_json::from_str::<serde_json::Value>(&source.text) {
            return Err(vec![not_a_scene(source, &error)]);
        }
        let start = source.text.len() - source.text.trim_start().len();
        let fault =
            Diagnostic::new("this is no scene", source, start..start + 1, "expected `{` and the fields of a scene");
        return Err(vec![fault.with_help("`carom solve --help` shows a scene")]);
    }
    let text: SceneText = serde_json::from_str(&source.text).map_err(|error| vec![not_a_scene(source, &error)])?;
    let places: Vec<_> =
        places(&source.text).into_iter().filter(|(_, place)| source.text[place.clone()].starts_with('"')).collect();
    if let Some(fault) = no_vector(source, &places) {
        return Err(vec![fault]);
    }
    let faults = match (Scene::read(&text, &BTreeMap::new(), Angles::Radians), scene_names(&text)) {
        (Ok(scene), amiss) if amiss.is_empty() => return Ok(scene),
        (Ok(_), amiss) => amiss,
        (Err(faults), _) => faults,
    };
    Err(faults.into_iter().map(|fault| located(source, &places, fault)).collect())
}

/// A velocity that is a list of more or fewer than two: serde would take it for a speed and an angle.
fn no_vector(source: &Source, places: &[(String, Range<usize>)]) -> Option<Diagnostic> {
    for velocity in ["before.A", "before.B", "after.A", "after.B"] {
        let below = format!("{velocity}[");
        let within: Vec<_> = places.iter().filter(|(path, _)| path.starts_with(&below)).collect();
        if let (Some((_, first)), Some((_, last))) = (within.first(), within.last())
            && within.len() != 2
        {
            let message = format!("`{velocity}` is no vector");
            let label = format!("expected two components, found {}", within.len());
            let fault = Diagnostic::new(message, source, first.start..last.end, label);
            return Some(fault.with_help("write `[\"x\", \"y\"]`, along i and along j"));
        }
    }
    None
}

/// What serde_json says, in our words where a teacher is likely to meet it.
fn not_a_scene(source: &Source, error: &serde_json::Error) -> Diagnostic {
    let at = offset(&source.text, error.line(), error.column());
    let said = error.to_string();
    let said = said.split(" at line ").next().unwrap_or_default();
    if !error.is_data() {
        return Diagnostic::new(format!("this is no JSON: {said}"), source, at..at + 1, "expected readable JSON");
    }
    if said.contains("untagged enum") {
        return Diagnostic::new("a velocity that cannot be read", source, at..at + 1, "it ends here").with_help(
            "write `[\"x\", \"y\"]`, or `{\"speed\": \"6\", \"angle_deg\": \"10\"}`, every number as a string",
        );
    }
    if let Some((what, expected)) = said.strip_prefix("invalid type: ").and_then(|rest| rest.split_once(", expected "))
    {
        let expected = expected.replace("struct Pair", "a pair `{\"A\": …, \"B\": …}`");
        let fault = Diagnostic::new(format!("{what} in a scene"), source, at..at + 1, format!("expected {expected}"));
        let is_number = what.starts_with("integer") || what.starts_with("floating");
        return if is_number { fault.with_help("write every number as a string: `\"1/2\"`") } else { fault };
    }
    if let Some((what, known)) = said.split_once(", expected ") {
        let name = what.split('`').nth(1).unwrap_or_default();
        let near = near(name, known.split('`').skip(1).step_by(2));
        return Diagnostic::new(what, source, at..at + 1, format!("expected {known}")).with_near(near);
    }
    Diagnostic::new(said, source, at..at + 1, "not as a scene has it")
}

fn located(source: &Source, places: &[(String, Range<usize>)], fault: SceneFault) -> Diagnostic {
    let SceneFault { field, fault, .. } = fault;
    let within =
        |path: &String| path.strip_prefix(&field).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']));
    let place = places.iter().find(|(path, _)| within(path));
    let span = match place {
        None => 0..0,
        Some((path, whole)) => {
            let raw = &source.text[whole.clone()];
            let start = whole.start + 1 + fault.span.start;
            let end = whole.start + 1 + fault.span.end;
            // Within a string without escapes bytes are where the fault says.
            if *path == field && end > start && end < whole.end && !raw.contains('\\') {
                start..end
            } else {
                whole.clone()
            }
        }
    };
    let message = if place.is_some() { fault.message } else { format!("`{field}`: {}", fault.message) };
    Diagnostic { help: fault.help, ..Diagnostic::new(message, source, span, fault.expected) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fault_in_a_formula_is_under_its_caret() {
        let source = Source::new("scene.json", "{\n  \"masses\": {\"A\": \"2\", \"B\": \"3 + q\"}\n}");
        let faults = read(&source).unwrap_err();
        assert_eq!(faults.len(), 1);
        assert_eq!(&source.text[faults[0].span.clone()], "q");
        for text in
            ["{\"e\": 0.5}", "{\"before\": {\"A\": [\"1\"]}}", "{\"mases\": {}}", "[1", "nonsense", "{\"e\": \"\"}"]
        {
            assert!(!read(&Source::new("scene.json", text)).unwrap_err().is_empty(), "{text}");
        }
    }
}
