//! What Carom writes satisfies the schemas that it documents, as Python's jsonschema judges.

use std::io::Write;
use std::process::{Command, Stdio};

use carom::bank::Contents;
use carom::generate::{Deal, reference};
use carom::paper::{Key, Sheet};
use serde_json::{Value as Json, json};

/// Reads `{"schemas": …, "files": [[schema, name, contents], …]}`; says of each file what is wrong with it.
const JUDGE: &str = "
import json, sys
from jsonschema import Draft202012Validator as Validator
from referencing import Registry, Resource
whole = json.load(sys.stdin)
known = [(schema['$id'], Resource.from_contents(schema)) for schema in whole['schemas']]
registry = Registry().with_resources(known + [(name.rsplit('/', 1)[-1], resource) for name, resource in known])
by_name = {schema['$id'].rsplit('/', 1)[-1]: schema for schema in whole['schemas']}
for schema, name, contents in whole['files']:
    for fault in Validator(by_name[schema], registry=registry).iter_errors(contents):
        print(name, fault.json_path, fault.message[:300])
";

fn faults(files: &[(&str, String, Json)]) -> String {
    let page = |name: &str| -> Json {
        let mut schema: Json =
            serde_json::from_str(&std::fs::read_to_string(format!("docs/schema/{name}")).unwrap()).unwrap();
        schema["$id"] = name.into();
        schema
    };
    let schemas = ["key.schema.json", "scene.schema.json"].map(page);
    let whole = json!({"schemas": schemas, "files": files});
    let mut python = Command::new("python3")
        .args(["-c", JUDGE])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("python3 with jsonschema");
    python.stdin.take().unwrap().write_all(whole.to_string().as_bytes()).unwrap();
    let output = python.wait_with_output().unwrap();
    assert!(output.status.success(), "python3 with jsonschema is needed");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
#[ignore = "needs Python's jsonschema, which `.ci/run` installs"]
fn the_key_of_every_shipped_question_satisfies_the_schema_of_keys() {
    let contents = Contents::shipped();
    let mut files = Vec::new();
    for heading in &contents.headings {
        let question = heading.question().unwrap_or_else(|faults| panic!("{faults:?}"));
        let dealt = question.styles.iter().filter_map(|style| Deal::new(&question, style, 1).next());
        for variant in reference(&question).into_iter().chain(dealt) {
            let sheet = Sheet::new(&contents, [(&question, &variant)]);
            let key = serde_json::to_value(Key::of_sheet("shipped".to_owned(), Some(1), &sheet)).unwrap();
            files.push(("key.schema.json", question.id.clone(), key));
        }
    }
    let wrong = ("key.schema.json", "wrong".to_owned(), json!({"carom": 7}));
    assert!(faults(&[wrong]).contains("wrong"), "it judges");
    assert_eq!(faults(&files), "");
}
