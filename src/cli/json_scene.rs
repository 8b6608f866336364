//! A scene in JSON, with the place of every fault in the file.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, Source, near};
use crate::expr::Angles;
use crate::mechanics::{Scene, SceneFault, SceneText};

/// Reads a scene of the exchange format.
///
/// # Errors
///
/// What is no JSON or no scene, or every fault of its formulas.
pub fn read(source: &Source) -> Result<Scene, Vec<Diagnostic>> {
    let text: SceneText = serde_json::from_str(&source.text).map_err(|error| vec![not_a_scene(source, &error)])?;
    let places = places(&source.text);
    if let Some(fault) = no_vector(source, &places) {
        return Err(vec![fault]);
    }
    let faults = match Scene::read(&text, &BTreeMap::new(), Angles::Radians) {
        Ok(scene) => return Ok(scene),
        Err(faults) => faults,
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

/// The byte before a line and column, which serde_json counts from 1 and gives of the last byte it read.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    (before + column.saturating_sub(1)).min(text.len().saturating_sub(1))
}

fn located(source: &Source, places: &[(String, Range<usize>)], fault: SceneFault) -> Diagnostic {
    let SceneFault { field, fault } = fault;
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

/// The place of every string in a JSON text that has been read already, quotes included, by its path:
/// `before.A.speed`, `line_of_centres[0]`.
fn places(text: &str) -> Vec<(String, Range<usize>)> {
    let mut walk = Walk { text, at: 0, found: Vec::new() };
    walk.value("");
    walk.found
}

struct Walk<'t> {
    text: &'t str,
    at: usize,
    found: Vec<(String, Range<usize>)>,
}

impl Walk<'_> {
    fn peek(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().take_while(|byte| byte.is_ascii_whitespace() || matches!(byte, b',' | b':')).count();
        self.text.as_bytes().get(self.at).copied()
    }

    /// A string; its place, quotes included.
    fn string(&mut self) -> Range<usize> {
        let start = self.at;
        let mut escaped = false;
        for (index, byte) in self.text.as_bytes()[start + 1..].iter().enumerate() {
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = true,
                b'"' => {
                    self.at = start + index + 2;
                    return start..self.at;
                }
                _ => {}
            }
        }
        self.at = self.text.len();
        start..self.at
    }

    fn value(&mut self, path: &str) {
        match self.peek() {
            Some(b'{') => {
                self.at += 1;
                while self.peek() == Some(b'"') {
                    let key = self.string();
                    let key = self.text[key].trim_matches('"').to_owned();
                    let below = if path.is_empty() { key } else { format!("{path}.{key}") };
                    self.value(&below);
                }
                self.at += 1;
            }
            Some(b'[') => {
                self.at += 1;
                let mut index = 0;
                while self.peek().is_some_and(|byte| byte != b']') {
                    self.value(&format!("{path}[{index}]"));
                    index += 1;
                }
                self.at += 1;
            }
            Some(b'"') => {
                let place = self.string();
                self.found.push((path.to_owned(), place));
            }
            _ => {
                let rest = &self.text.as_bytes()[self.at..];
                self.at +=
                    rest.iter().take_while(|byte| byte.is_ascii_alphanumeric() || b"+-.".contains(byte)).count().max(1);
                self.at = self.at.min(self.text.len());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_where_each_string_stands() {
        let text = r#"{ "masses": {"A": "2", "B": null}, "before": {"A": ["x\"", "1"], "B": {"speed": "u"}} }"#;
        let found: Vec<(String, &str)> = places(text).into_iter().map(|(path, place)| (path, &text[place])).collect();
        let expected = [
            ("masses.A", r#""2""#),
            ("before.A[0]", r#""x\"""#),
            ("before.A[1]", r#""1""#),
            ("before.B.speed", r#""u""#),
        ];
        assert_eq!(found, expected.map(|(path, text)| (path.to_owned(), text)));
    }

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
