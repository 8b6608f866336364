//! A key from a file, its faults shown where they stand.

use std::path::Path;

use super::super::failure::Failure;
use super::super::json_places::{offset, place_of};
use super::files;
use crate::diagnostic::{Diagnostic, Source};
use crate::mark::{AnswerKey, KeyFault};

/// Reads a key.
pub fn read(path: &Path) -> Result<AnswerKey, Failure> {
    let source = files::text(path)?;
    AnswerKey::read(&source.text)
        .map_err(|faults| Failure::Faults(faults.into_iter().map(|fault| located(&source, fault)).collect()))
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
    let diagnostic = Diagnostic::new(message, source, span, format!("expected {}", fault.expected));
    if whole { diagnostic.with_help("`carom mark KEY.json SUBMISSIONS` takes the key first") } else { diagnostic }
}
