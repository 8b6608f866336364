//! A scene in JSON, with the place of every fault in the file.

use std::collections::HashSet;
use std::ops::Range;

use super::json_places::{offset, places};
use crate::bank::scene_names;
use crate::diagnostic::{Diagnostic, Source, near, why_no_json};
use crate::expr::{Angles, Fault, Span};
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
            return Err(vec![not_a_scene(source, &[], &error)]);
        }
        let start = source.text.len() - source.text.trim_start().len();
        let fault =
            Diagnostic::new("this is no scene", source, start..start + 1, "expected `{` and the fields of a scene");
        return Err(vec![fault.with_help("`carom solve --help` shows a scene")]);
    }
    let of_all = places(&source.text);
    let text: SceneText = serde_json::from_str(&source.text).map_err(|error| {
        let is_json = serde_json::from_str::<serde_json::Value>(&source.text).is_ok();
        // What serde takes for the end of a list that goes on is a list of too many.
        let known = || twice(source, &of_all).or_else(|| no_vector(source, &of_all));
        vec![is_json.then(known).flatten().unwrap_or_else(|| not_a_scene(source, &of_all, &error))]
    })?;
    let is_words = |place: &Range<usize>| source.text[place.clone()].starts_with('"');
    if let Some(fault) = twice(source, &of_all).or_else(|| no_vector(source, &of_all)) {
        return Err(vec![fault]);
    }
    let places: Vec<_> = of_all.iter().filter(|(_, place)| is_words(place)).cloned().collect();
    let faults = match (Scene::read(&text, &(), Angles::Radians), scene_names(&text)) {
        (Ok(scene), amiss) if amiss.is_empty() => {
            let weightless = weightless(&scene, &text);
            if weightless.is_empty() {
                return Ok(scene);
            }
            weightless
        }
        (Ok(_), amiss) => amiss,
        (Err(faults), _) => faults,
    };
    Err(faults.into_iter().map(|fault| located(source, &places, &of_all, fault)).collect())
}

/// What is given twice, of which JSON itself would take the last.
fn twice(source: &Source, places: &[(String, Range<usize>)]) -> Option<Diagnostic> {
    let mut known = HashSet::new();
    let (path, place) = places.iter().find(|(path, _)| !known.insert(path))?;
    let fault = Diagnostic::new(format!("`{path}` is given twice"), source, place.clone(), "expected it once");
    Some(fault.with_help("keep one of the two"))
}

/// Masses that are nought or below it, whatever the letters are.
fn weightless(scene: &Scene, text: &SceneText) -> Vec<SceneFault> {
    let masses = [("A", &text.masses.a), ("B", &text.masses.b)].into_iter().zip(&scene.masses);
    let faults = masses.filter_map(|((sphere, written), mass)| {
        let (written, mass) = (written.as_ref()?, mass.as_ref()?);
        let span = Span { start: 0, end: written.len() };
        let fault = Fault::new(format!("the mass of {sphere} is not positive"), span, "a mass in kg, above 0");
        let fault = fault.try_this("leave the mass out if it is not given");
        mass.value.sign()?.is_le().then(|| SceneFault {
            field: format!("masses.{sphere}"),
            fault,
            is_of_the_form: false,
        })
    });
    faults.collect()
}

/// A vector that is a list of more or fewer than two; of a velocity serde would take that for a speed and an angle.
fn no_vector(source: &Source, places: &[(String, Range<usize>)]) -> Option<Diagnostic> {
    const VECTORS: [&str; 9] = [
        "before.A",
        "before.B",
        "after.A",
        "after.B",
        "line_of_centres",
        "impulse",
        "wall",
        "positions.A",
        "positions.B",
    ];
    for vector in VECTORS {
        let below = format!("{vector}[");
        let is_component =
            |path: &str| path.strip_prefix(&below).is_some_and(|rest| !rest.trim_end_matches(']').contains(['[', '.']));
        let within: Vec<_> = places.iter().filter(|(path, _)| is_component(path)).collect();
        if let Some((_, place)) = within.iter().find(|(_, place)| &source.text[place.clone()] == "null") {
            let fault = Diagnostic::new("null in a vector", source, place.clone(), "expected a component");
            return Some(fault.with_help("leave out the whole vector if it is not given"));
        }
        if let Some((_, place)) = within.iter().find(|(_, place)| source.text[place.clone()].starts_with(['[', '{'])) {
            let fault = Diagnostic::new("a list in a vector", source, place.clone(), "expected a component in quotes");
            return Some(fault.with_help("write `[\"x\", \"y\"]`, along i and along j"));
        }
        if let (Some((_, first)), Some((_, last))) = (within.first(), within.last())
            && within.len() != 2
        {
            let message = format!("`{vector}` is no vector");
            let label = format!("expected two components, found {}", within.len());
            let fault = Diagnostic::new(message, source, first.start..last.end, label);
            return Some(fault.with_help("write `[\"x\", \"y\"]`, along i and along j"));
        }
    }
    None
}

/// What serde_json says, in our words where a teacher is likely to meet it.
fn not_a_scene(source: &Source, places: &[(String, Range<usize>)], error: &serde_json::Error) -> Diagnostic {
    let at = offset(&source.text, error.line(), error.column());
    let said = error.to_string();
    let said = said.split(" at line ").next().unwrap_or_default();
    // Of a word that stands for a choice serde asks for a string as JSON does.
    let is_json = || serde_json::from_str::<serde_json::Value>(&source.text).is_ok();
    if !error.is_data() && !is_json() {
        let message = format!("this is no JSON: {}", why_no_json(error));
        let fault = Diagnostic::new(message, source, at..at + 1, "expected readable JSON");
        return fault.with_help("`carom solve --help` shows a scene");
    }
    // It is told of once the value has been read: the place of its last byte, or just behind it.
    let ends = |(_, place): &&(String, Range<usize>)| place.end == at + 1 || place.end == at;
    let value = match error.is_data() {
        true => places.iter().filter(ends).max_by_key(|(_, place)| place.end),
        false => places.iter().find(|(field, _)| field == "sense"),
    };
    let (field, span) = match value {
        Some((field, place)) => (field.as_str(), place.clone()),
        None => ("", at..at + 1),
    };
    if said.contains("untagged enum") {
        return Diagnostic::new("a velocity that cannot be read", source, span, "not as a velocity is written")
            .with_help(
                "write `[\"x\", \"y\"]`, or `{\"speed\": \"6\", \"angle_deg\": \"10\"}`, every number as a string",
            );
    }
    if field == "sense" {
        let help = "turn the line of centres round for the other sense: write its components with the other signs";
        let written = &source.text[span.clone()];
        let fault = Diagnostic::new(format!("no sense {written}"), source, span, "expected `A_to_B` or `either`");
        return fault.with_help(help);
    }
    if field.starts_with("positions[") {
        let help =
            "write `{\"A\": [\"0\", \"0\"], \"B\": [\"3\", \"4\"]}`, the components of each centre along i and along j";
        let fault = Diagnostic::new("no centre of a sphere", source, span, "expected a vector for A and one for B");
        return fault.with_help(help);
    }
    if let Some((what, expected)) = said.strip_prefix("invalid type: ").and_then(|rest| rest.split_once(", expected "))
    {
        let expected = match expected {
            "struct Pair" => "a pair `{\"A\": …, \"B\": …}`",
            "struct ThenText" => "an impact `{\"of\": […], …}`",
            "an array of length 2" => "a vector `[\"x\", \"y\"]`",
            "a sequence" => "a list",
            "a map" => "a list of letters `{\"u\": \"positive\"}`",
            other => other,
        };
        let help = match what {
            _ if what.starts_with("integer") || what.starts_with("floating") => {
                let written = source.text.get(span.clone()).unwrap_or_default();
                format!("write every number as a string: `\"{written}\"`")
            }
            "null" => "leave out what is not given".to_owned(),
            _ => "`carom solve --help` shows a scene".to_owned(),
        };
        let what = match what.split_once(' ') {
            None if what == "map" => "an object",
            None if what == "sequence" => "a list",
            Some(("string", _)) => "a text",
            Some(("integer" | "floating", _)) => "a bare number",
            _ => what,
        };
        let fault = Diagnostic::new(format!("{what} in a scene"), source, span, format!("expected {expected}"));
        return fault.with_help(help);
    }
    if let Some((what, known)) = said.split_once(", expected ") {
        let name = what.split('`').nth(1).unwrap_or_default();
        let near = near(name, known.split('`').skip(1).step_by(2));
        let key = || source.text[..at + 1].rfind(&format!("\"{name}\""));
        let span = match what.starts_with("unknown field").then(key).flatten() {
            Some(start) => start + 1..start + 1 + name.len(),
            None => span,
        };
        let help = match name {
            "C" => {
                "a third sphere comes in a later impact, `\"then\": [{\"of\": [\"B\", \"C\"], \"mass\": …, \"before\": …}]`"
            }
            _ => "`carom solve --help` shows a scene",
        };
        let fault = Diagnostic::new(what, source, span, format!("expected {known}"));
        return fault.with_help(help).with_near(near.filter(|_| name != "C"));
    }
    Diagnostic::new(said, source, span, "not as a scene has it")
}

/// A fault at the words that it is about; what is missing is told of at what it is missing in.
fn located(
    source: &Source,
    places: &[(String, Range<usize>)],
    of_all: &[(String, Range<usize>)],
    fault: SceneFault,
) -> Diagnostic {
    let SceneFault { field, fault, .. } = fault;
    let within =
        |path: &String| path.strip_prefix(&field).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']));
    let place = places.iter().find(|(path, _)| within(path));
    let span = match place {
        None => around(of_all, &field),
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

/// Where the value with this path begins, or else the nearest around it.
fn around(places: &[(String, Range<usize>)], field: &str) -> Range<usize> {
    let mut path = field;
    loop {
        if let Some((_, place)) = places.iter().find(|(known, _)| known == path) {
            return place.start..place.start + 1;
        }
        let Some(shorter) = path.rfind(['.', '[']) else { return 0..0 };
        path = &path[..shorter];
    }
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

    #[test]
    fn what_is_wrong_in_a_scene_is_under_its_caret_with_one_thing_to_try() {
        let scene = |line: &str| {
            format!(
                "{{\"masses\": {{\"A\": \"2\", \"B\": \"4\"}}, \"before\": {{\"A\": [\"1\", \"0\"], \"B\": [\"0\", \"0\"]}}, {line}}}"
            )
        };
        let rows = [
            (r#""line_of_centres": ["1", "0", "0"]"#, r#""1", "0", "0""#, "write `[\"x\", \"y\"]`"),
            (r#""sense": "B_to_A""#, r#""B_to_A""#, "turn the line of centres round"),
            (r#""e": "10^(-400)""#, "10^(-400)", ""),
            (r#""e": "5e-1""#, "e", "write a power of ten as `5*10^2`"),
            (r#""e": "1e300""#, "e300", "write a power of ten"),
            (r#""e": "0,5""#, "0,5", "write `0.5`"),
            (r#""e": "2 kg""#, "kg", "leave the unit out"),
            (r#""e": "2 q""#, "q", "declare letters in `symbols`"),
            (r#""e": "k""#, "k", "declare letters in `symbols`"),
            (r#""e": true"#, "true", "shows a scene"),
            (r#""e": 0.5, "sense": "A_to_B""#, "0.5", "write every number as a string: `\"0.5\"`"),
            (r#""after": null, "e": "1""#, "null", "leave out what is not given"),
            (r#""after": {"A": ["3", null]}, "e": "1""#, "null", "leave out the whole vector"),
            (r#""positions": [1, 2], "e": "1""#, "1", "the components of each centre"),
            (r#""positions": {"A": ["0"], "B": ["3", "4"]}"#, r#""0""#, "write `[\"x\", \"y\"]`"),
            (r#""e": "1", "symbols": {"pi": "positive"}"#, r#""positive""#, "call the letter something else"),
            (r#""e": "e", "unknowns": ["e", "e"], "conditions": ["e = 1"]"#, "e", "take it out here"),
            (r#""unknowns": ["e"], "maximise": "A.after.sped""#, "A.after.sped", "did you mean `A.after.speed`?"),
            (r#""unknowns": ["e"], "conditions": ["B.x = 3"]"#, "B.x", "did you mean `B.after.x` or `B.before.x`?"),
            (r#""unknowns": ["e"], "conditions": ["A.after.x != 3"]"#, "A.after.x != 3", "write `<` or `>`"),
            (r#""unknowns": ["e"], "conditions": ["A.after.x"]"#, "A.after.x", "write what it is equal to"),
            (r#""e": "sqrt(2,3)""#, "sqrt(2,3)", "write one number in the brackets"),
            (r#""e": "sqrt()""#, "sqrt()", "write `sqrt(x)`"),
            (r#""e": "2*()""#, "()", "write what belongs between them"),
            (r#""e": "2^(1/3)""#, "2^(1/3)", "write what the power comes to as a decimal"),
            (r#""e": "tan(90*deg)""#, "tan(90*deg)", "give another angle"),
            (
                r#""line_of_centres": ["sqrt(2)+sqrt(3)+sqrt(5)", "sqrt(7)+sqrt(11)+sqrt(13)"]"#,
                "sqrt(7)+sqrt(11)+sqrt(13)",
                "as a decimal",
            ),
            (r#""e": "sine(30*deg)""#, "sine", "did you mean `sin`?"),
            (r#""e": "cosine(30*deg)""#, "cosine", "did you mean `cos`?"),
            (r#""e": "gcd(1/2)""#, "gcd", "say it with those"),
            (r#""e": "cos(1/2°)""#, "cos(1/2°)", "put brackets round a fraction"),
            (r#""after": {"A": {"speed": "3", "cos": "3/5"}}"#, "3", "add `sin`"),
            (r#""after": {"A": {"speed": "3"}}"#, "3", "add `angle_deg`"),
            (r#""after": {"A": "4,1"}"#, "4,1", "as a list of two texts"),
            (r#""after": {"A": [["4"], "1"]}"#, r#""4""#, "write `[\"x\", \"y\"]`"),
            (r#""symbols": {"u": "positive", "u": "unit"}"#, r#""unit""#, "keep one of the two"),
            (r#""e": "1", "e": "1/2""#, r#""1/2""#, "keep one of the two"),
            (r#""α": "1""#, "α", "shows a scene"),
            (r#""q": "1""#, "q", "shows a scene"),
            (r#""impact_parameter": "1""#, r#""1""#, "add `radii`"),
            (r#""then": [{"of": []}]"#, "", "write `of = [\"A\", \"B\"]`"),
            (r#""then": [{"of": ["B", "C"], "before": ["0", "0"]}]"#, "{", "add `mass`"),
        ];
        for (line, at, help) in rows {
            let faults = read(&Source::new("scene.json", scene(line))).unwrap_err();
            let found = faults[0].source.text[faults[0].span.clone()].trim_matches(['[', ']']);
            assert_eq!(found, at, "{line}");
            assert!(faults[0].help.clone().unwrap_or_default().contains(help), "{line}: {:?}", faults[0].help);
        }
        let third = r#"{"masses": {"A": "1", "B": "1", "C": "1"}}"#;
        let faults = read(&Source::new("scene.json", third)).unwrap_err();
        assert!(faults[0].help.clone().unwrap_or_default().contains("in a later impact"), "{faults:?}");
        let list = read(&Source::new("scene.json", r#"{"masses": ["1", "2"], "e": {"a": "1"}}"#)).unwrap_err();
        assert!(list[0].message.ends_with("in a scene") && !list[0].message.contains("map"), "{list:?}");
        for mass in ["0", "-2"] {
            let text = format!("{{\"masses\": {{\"A\": \"{mass}\", \"B\": \"1\"}}}}");
            let faults = read(&Source::new("scene.json", text)).unwrap_err();
            assert_eq!(faults[0].message, "the mass of A is not positive");
            assert_eq!(&faults[0].source.text[faults[0].span.clone()], mass);
        }
    }
}
