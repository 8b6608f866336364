//! `carom compare --stream`: JSON lines in, one verdict line for each out, in order, whatever comes.

use std::collections::VecDeque;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;

use serde_json::{Map, Value as Json, json};

use super::compare::{Asked, accept, as_json, declared, kind};
use super::failure::Failure;
use super::text_file::unread;
use crate::mark::judging::{Model, ModelOptions, judge};
use crate::mark::reading::read_answer;

/// The longest line that is looked at, in bytes; of a longer one nothing is kept.
const LONGEST: u64 = 1 << 16;

/// Answers every line until the input ends.
pub fn run(input: impl Read, output: impl Write) -> Result<(), Failure> {
    let mut input = BufReader::new(input);
    let mut output = BufWriter::new(output);
    let mut line = Vec::new();
    let mut number = 0_u64;
    let mut models = Models::default();
    let unread = |error: io::Error| unread(Path::new("-"), &error);
    while read_line(&mut input, &mut line).map_err(unread)? {
        number += 1;
        let verdict = verdict(&line, &mut models).unwrap_or_else(|reason| {
            let feedback = format!("line {number}: {reason}");
            json!({"verdict": "unreadable", "reading": null, "note": "broken-line", "feedback": feedback})
        });
        writeln!(output, "{verdict}")?;
        // Whoever waits for an answer before sending more gets it; a long file is written in large pieces.
        if input.buffer().is_empty() {
            output.flush()?;
        }
    }
    output.flush()?;
    Ok(())
}

/// Reads the next line without its end; one that is too long is read on and cut, so that it is seen to be.
fn read_line(input: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    line.clear();
    if input.by_ref().take(LONGEST + 1).read_until(b'\n', line)? == 0 {
        return Ok(false);
    }
    if line.ends_with(b"\n") {
        line.pop();
    } else if line.len() as u64 > LONGEST {
        input.skip_until(b'\n')?;
    }
    Ok(true)
}

/// The verdict on one line, or what is wrong with it.
fn verdict(line: &[u8], models: &mut Models) -> Result<Json, String> {
    if line.len() as u64 > LONGEST {
        return Err(format!("longer than {LONGEST} bytes"));
    }
    let text = std::str::from_utf8(line).map_err(|_| "not in UTF-8".to_owned())?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let fields: Json = serde_json::from_str(text).map_err(|error| format!("not JSON: {error}"))?;
    let fields = fields.as_object().ok_or("not a JSON object")?;
    let wrong = |wrong: super::compare::Wrong| format!("{}; {}", wrong.message, wrong.help);
    let model = required(fields, "model")?;
    let answer = required(fields, "answer")?;
    let mut letters = Vec::new();
    if let Some(symbols) = fields.get("symbols").filter(|symbols| !symbols.is_null()) {
        for (name, range) in symbols.as_object().ok_or("`symbols` is not an object")? {
            let range = range.as_str().ok_or_else(|| format!("the range of `{name}` is not a string"))?;
            letters.push(declared(name, range).map_err(wrong)?);
        }
    }
    let find = names(fields, "find")?;
    let asked = find.map(|find| Asked::read(&find, &letters)).transpose().map_err(wrong)?.unwrap_or_default();
    let options = ModelOptions {
        kind: optional(fields, "kind")?.map(kind).transpose().map_err(wrong)?,
        accept: optional(fields, "accept")?.map(accept).transpose().map_err(wrong)?,
        letters,
        quantity: asked.quantity,
        letter: asked.letter,
    };
    let model = models.read(model, options)?;
    Ok(as_json(&judge(model, &read_answer(answer, &model.vocabulary))))
}

/// How many models are remembered: those of a sheet.
const REMEMBERED: usize = 16;

/// The models of the last lines, the latest first: a class's answers to one question are judged by one model.
#[derive(Default)]
struct Models(VecDeque<(String, ModelOptions, Model)>);

impl Models {
    /// The model with this text and these options, read if it is not remembered.
    fn read(&mut self, text: &str, options: ModelOptions) -> Result<&Model, String> {
        let is_it = |(known, with, _): &(String, ModelOptions, Model)| known == text && *with == options;
        let remembered = self.0.iter().position(is_it).and_then(|place| self.0.remove(place));
        let latest = match remembered {
            Some(latest) => latest,
            None => {
                let model = Model::read(text, &options).map_err(|fault| format!("model: {}", fault.message))?;
                (text.to_owned(), options, model)
            }
        };
        self.0.truncate(REMEMBERED - 1);
        self.0.push_front(latest);
        Ok(&self.0[0].2)
    }
}

fn required<'a>(fields: &'a Map<String, Json>, name: &str) -> Result<&'a str, String> {
    optional(fields, name)?.ok_or_else(|| format!("`{name}` is missing"))
}

/// A string, or a list of them with commas between, as a key has both components of a vector.
fn names(fields: &Map<String, Json>, name: &str) -> Result<Option<String>, String> {
    let Some(Json::Array(all)) = fields.get(name) else { return Ok(optional(fields, name)?.map(str::to_owned)) };
    let all: Option<Vec<&str>> = all.iter().map(Json::as_str).collect();
    all.map(|all| Some(all.join(","))).ok_or_else(|| format!("`{name}` is neither a string nor a list of strings"))
}

fn optional<'a>(fields: &'a Map<String, Json>, name: &str) -> Result<Option<&'a str>, String> {
    match fields.get(name) {
        None | Some(Json::Null) => Ok(None),
        Some(value) => value.as_str().map(Some).ok_or_else(|| format!("`{name}` is not a string")),
    }
}
