//! Submissions as JSON lines: an object a line, with the names of the columns.

use std::collections::BTreeSet;
use std::fmt;

use serde::de::{Deserialize, Deserializer, IgnoredAny, MapAccess, Visitor};
use serde_json::{Map, Value as Json};

use super::{COLUMNS, Row, Rows};
use crate::diagnostic::{near, why_no_json};

/// Reads every line that is not empty.
pub(super) fn read(text: &str) -> Rows {
    let mut rows = Rows::default();
    for (line, text) in (1..).zip(text.lines()) {
        if text.trim().is_empty() {
            continue;
        }
        let fields = serde_json::from_str(text).map_err(|error| reason(&error));
        rows.place(fields.and_then(|fields| row(line, &fields, text)), line, text);
    }
    rows
}

fn reason(error: &serde_json::Error) -> String {
    let layout = "each object stands on one line, without commas between them, or all in one list `[{…}, {…}]`";
    match why_no_json(error).as_str() {
        "trailing characters" => format!("something follows the object on its line; {layout}"),
        why if error.is_eof() => format!("this is no JSON: {why}; {layout}"),
        why => format!("this is no JSON: {why}"),
    }
}

/// An object as a row, and its text.
pub(super) fn row(line: usize, fields: &Json, text: &str) -> Result<Row, String> {
    let fields = fields.as_object().ok_or("this is no JSON object: write one for each answer, a line each")?;
    if let Ok(GivenTwice(Some(name))) = serde_json::from_str(text) {
        return Err(format!("`{name}` is given twice"));
    }
    let question = match fields.get("question") {
        Some(Json::Number(number)) => number.to_string(),
        _ => needed(fields, "question")?,
    };
    let working = match fields.get("working") {
        Some(Json::Array(lines)) => {
            let each = lines.iter().map(|line| line.as_str().ok_or("`working` is a list of something but strings"));
            each.collect::<Result<Vec<_>, _>>()?.join("\n")
        }
        _ => words(fields, "working")?.unwrap_or_default(),
    };
    let answer = match words(fields, "answer")? {
        Some(answer) => answer,
        None if !working.trim().is_empty() => String::new(),
        None => needed(fields, "answer")?,
    };
    let student = needed(fields, "student")?;
    let part = words(fields, "part")?.unwrap_or_default();
    let blank = words(fields, "blank")?.unwrap_or_default();
    Ok(Row::new(line, [&student, &question, &part, &blank, &answer, &working]))
}

fn needed(fields: &Map<String, Json>, name: &str) -> Result<String, String> {
    let strangers = || fields.keys().map(String::as_str).filter(|field| !COLUMNS.contains(field));
    words(fields, name)?.ok_or_else(|| match near(name, strangers()) {
        Some(near) => format!("`{name}` is missing: is `{near}` meant for it?"),
        None => format!("`{name}` is missing"),
    })
}

fn words(fields: &Map<String, Json>, name: &str) -> Result<Option<String>, String> {
    match fields.get(name) {
        None | Some(Json::Null) => Ok(None),
        Some(Json::String(words)) => Ok(Some(words.clone())),
        // 2.80 and 2.8 would be the same number, and they are not the same answer.
        Some(Json::Number(_)) if name == "answer" => {
            Err("`answer` is a number: write it as a string, so that it keeps its figures".to_owned())
        }
        Some(_) => Err(format!("`{name}` is not a string")),
    }
}

/// The first name that an object has twice. A map of what was read would only have the last of them.
struct GivenTwice(Option<String>);

impl<'de> Deserialize<'de> for GivenTwice {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<GivenTwice, D::Error> {
        deserializer.deserialize_map(Names)
    }
}

struct Names;

impl<'de> Visitor<'de> for Names {
    type Value = GivenTwice;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<GivenTwice, A::Error> {
        let (mut names, mut twice) = (BTreeSet::new(), None);
        while let Some((name, IgnoredAny)) = map.next_entry::<String, IgnoredAny>()? {
            if let Some(name) = names.replace(name) {
                twice.get_or_insert(name);
            }
        }
        Ok(GivenTwice(twice))
    }
}
