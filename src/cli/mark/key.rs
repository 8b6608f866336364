//! A key from a file, its faults shown where they stand.

use std::path::Path;

use super::super::failure::Failure;
use super::super::json_places::{offset, place_of};
use super::super::text_file;
use super::unfinished::Digest;
use crate::cli::sheet::from_code;
use crate::diagnostic::{Diagnostic, Source};
use crate::mark::{AnswerKey, KeyFault};
use crate::paper::{CodeFault, Key, SheetCode};

/// Reads a key, and its digest; the code of a sheet in place of a file is the key of that sheet.
pub fn read(path: &Path, bank: Option<&Path>) -> Result<(AnswerKey, Digest), Failure> {
    if let Some(code) = code(path) {
        if SheetCode::read(code) == Err(CodeFault::Mistyped) {
            return Err(neither(code));
        }
        let contents = super::super::bank::open(bank)?;
        let sheet = from_code(code, &contents)?;
        let json = serde_json::to_string(&Key::of_sheet(contents.name, None, &sheet));
        let json = json.map_err(|error| Failure::said(error.to_string()))?;
        let unread = |faults: Vec<KeyFault>| Failure::said(faults.first().map_or("", |fault| &fault.message));
        return AnswerKey::read(&json).map(|key| (key, Digest::of(json.as_bytes()))).map_err(unread);
    }
    let source = text_file::usually(path, "key.json")?;
    if source.text.trim().is_empty() {
        let message = format!("this is no key: nothing stands in `{}`", source.file);
        return Err(Failure::with_help(message, "`carom sheet` writes a `key.json` beside its sheets"));
    }
    AnswerKey::read(&source.text)
        .map(|key| (key, Digest::of(source.text.as_bytes())))
        .map_err(|faults| Failure::Faults(faults.into_iter().map(|fault| located(&source, fault)).collect()))
}

/// Is it a code in place of a file?
pub fn is_code(path: &Path) -> bool {
    code(path).is_some()
}

/// What stands in place of a file, if it can only be a code.
fn code(path: &Path) -> Option<&str> {
    let text = path.to_str().filter(|text| !path.exists() && !text.contains(['.', '/', '\\']) && *text != "-")?;
    let is_code = |fault: &CodeFault| matches!(fault, CodeFault::Mistyped | CodeFault::Long | CodeFault::NamesOnly);
    match SheetCode::read(text) {
        Ok(_) => Some(text),
        Err(fault) => is_code(&fault).then_some(text),
    }
}

/// What is no file, and would be a code if another character stood in it.
fn neither(text: &str) -> Failure {
    let fault = CodeFault::Mistyped;
    let message = format!("there is no file `{}`, and if it is the code of a sheet, {fault}", text.escape_debug());
    let help = "give the `key.json` beside the sheets; a code stands below the heading of its sheet: compare them";
    Failure::with_help(message, help)
}

fn located(source: &Source, fault: KeyFault) -> Diagnostic {
    let span = match fault.place {
        Some((line, column)) => {
            let at = offset(&source.text, line, column);
            at..at + 1
        }
        None => place_of(&source.text, &fault.path).unwrap_or(0..1),
    };
    let message = if fault.path.is_empty() { fault.message } else { format!("`{}`: {}", fault.path, fault.message) };
    let whole = fault.path.is_empty();
    let diagnostic = Diagnostic::new(message, source, span, fault.expected);
    if !fault.help.is_empty() {
        return diagnostic.with_help(fault.help);
    }
    if whole { diagnostic.with_help("`carom mark KEY.json SUBMISSIONS` takes the key first") } else { diagnostic }
}
