//! Submissions as one JSON array of the objects that JSON lines have, as other programs export them.

use serde_json::{Deserializer, Value as Json};

use super::{Rows, json_lines};
use crate::diagnostic::{Diagnostic, Source, why_no_json};

/// Reads every object of an array.
///
/// # Errors
///
/// What is no JSON, with its place: after that nobody knows where the next object begins, so nothing is read in part.
pub(super) fn read(source: &Source) -> Result<Rows, Vec<Diagnostic>> {
    let text = &*source.text;
    let mut rows = Rows::default();
    let mut at = text.find('[').map_or(text.len(), |open| open + 1);
    let (mut line, mut counted) = (1, 0);
    let mut is_first = true;
    loop {
        at = past_blanks(text, at);
        let begins = at;
        match text[at..].chars().next() {
            Some(']') => {
                let rest = past_blanks(text, at + 1);
                return if rest == text.len() {
                    Ok(rows)
                } else {
                    Err(fault(source, rest, "something follows the list"))
                };
            }
            Some(',') if !is_first => at = past_blanks(text, at + 1),
            Some(_) if is_first => {}
            Some(_) => return Err(fault(source, at, "two answers without a comma between them")),
            None => return Err(fault(source, at, "the list is not closed")),
        }
        if !is_first && text[at..].starts_with(']') {
            return Err(fault(source, begins, "a comma without an answer after it"));
        }
        line += text[counted..at].matches('\n').count();
        counted = at;
        let mut values = Deserializer::from_str(&text[at..]).into_iter::<Json>();
        let end = match values.next() {
            Some(Ok(fields)) => {
                let end = at + values.byte_offset();
                rows.place(json_lines::row(line, &fields, &text[at..end]), line, &text[at..end]);
                end
            }
            Some(Err(error)) if !error.is_eof() => {
                let before: usize = text[at..].split_inclusive('\n').take(error.line() - 1).map(str::len).sum();
                let message = format!("this is no JSON: {}", why_no_json(&error));
                return Err(fault(source, at + before + error.column().saturating_sub(1), &message));
            }
            _ => return Err(fault(source, text.len(), "the list is not closed")),
        };
        at = end;
        is_first = false;
    }
}

fn past_blanks(text: &str, at: usize) -> usize {
    text.len() - text[at..].trim_ascii_start().len()
}

fn fault(source: &Source, at: usize, message: &str) -> Vec<Diagnostic> {
    let at = at.min(source.text.trim_end().len().saturating_sub(1));
    let label = "expected a list in brackets, of objects with commas between them";
    let help = "mend it here and mark again, or write one object a line, without brackets and commas: \
                `{\"student\": \"Ada\", \"question\": 1, \"answer\": \"2.78\"}`";
    vec![Diagnostic::new(message, source, at..at + 1, label).with_help(help)]
}
