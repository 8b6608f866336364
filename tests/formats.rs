//! The pages on exchange formats say what the program does: quantities, fields of a scene, and the examples of both.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use carom::mechanics::{Quantity, SceneText};
use serde_json::Value;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect(path)
}

fn schema(name: &str) -> Value {
    serde_json::from_str(&read(&format!("docs/schema/{name}.schema.json"))).expect(name)
}

/// The words between backticks.
fn quoted(line: &str) -> Vec<String> {
    line.split('`').skip(1).step_by(2).map(str::to_string).collect()
}

/// `X.M.speed` for both spheres, before and after.
fn each(name: &str) -> Vec<String> {
    let spheres = if name.starts_with("X.") { vec!["A.", "B."] } else { vec![""] };
    let rest = name.strip_prefix("X.").unwrap_or(name);
    let moments = if rest.starts_with("M.") { vec!["before.", "after."] } else { vec![""] };
    let rest = rest.strip_prefix("M.").unwrap_or(rest);
    spheres.iter().flat_map(|x| moments.iter().map(move |m| format!("{x}{m}{rest}"))).collect()
}

#[test]
fn carom_documents_every_quantity_with_its_unit() {
    let page = read("docs/exchange-formats.md");
    let section = page.split("\n## Quantities\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let mut documented = BTreeSet::new();
    for row in section.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<&str> = row.split(" | ").collect();
        let unit = cells.last().unwrap().trim_matches([' ', '|']);
        for name in quoted(cells[0]).iter().flat_map(|name| each(name)) {
            let quantity: Quantity = name.parse().unwrap_or_else(|_| panic!("`{name}` is no quantity"));
            assert_eq!(quantity.unit().plain(), unit, "{name}");
            documented.insert(name);
        }
    }
    let all: BTreeSet<String> = Quantity::all().iter().map(Quantity::to_string).collect();
    assert_eq!(documented, all);
}

#[test]
fn carom_documents_every_field_of_a_scene() {
    // The reader names the fields that it knows when it meets one that it does not.
    let fault = serde_json::from_str::<SceneText>(r#"{ "mases": {} }"#).unwrap_err().to_string();
    let known: BTreeSet<String> = quoted(&fault).into_iter().filter(|name| name != "mases").collect();
    let fields = schema("scene")["properties"].as_object().unwrap().keys().cloned().collect();
    assert_eq!(known, fields);
    let page = read("docs/exchange-formats.md");
    let section = page.split("\n## Scene\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let rows = section.lines().filter(|line| line.starts_with("| `"));
    let explained: BTreeSet<String> = rows.flat_map(|row| quoted(row.split(" | ").next().unwrap())).collect();
    assert_eq!(explained, fields);
}

#[test]
fn carom_reads_the_scene_of_every_reference_exercise() {
    let data: Value = serde_json::from_str(&read("tests/data/seed-cases.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 17);
    for case in cases {
        let scene: Result<SceneText, _> = serde_json::from_value(case["scene"].clone());
        assert!(scene.is_ok(), "{}: {:?}", case["id"], scene.err());
    }
}

#[test]
fn carom_documents_the_fields_of_a_solution_and_a_key() {
    let page = read("docs/exchange-formats.md");
    let fields = |at: &Value| -> Vec<String> { at["properties"].as_object().unwrap().keys().cloned().collect() };
    let (solution, key) = (schema("solution"), schema("key"));
    let mut named = fields(&solution);
    named.extend(fields(&solution["$defs"]["quantity"]));
    named.extend(fields(&key));
    for part in ["blank", "mark", "part", "question"] {
        named.extend(fields(&key["$defs"][part]));
    }
    for name in named {
        let (code, json) = (format!("`{name}`"), format!("\"{name}\":"));
        assert!(page.contains(&code) || page.contains(&json), "docs/exchange-formats.md does not show `{name}`");
    }
}
