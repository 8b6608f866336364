//! What is wrong with a file that is no TOML, in the words of somebody who has never heard of it.
//!
//! The reader of TOML goes on after a fault and finds more, which after a bracket that is never closed are the rest of
//! the file. So one fault is told for each line, and none after one that leaves open where things end.

use std::ops::Range;

use toml::de::Error;

use super::document::Faults;

/// One fault as it is told.
struct Told {
    span: Range<usize>,
    message: String,
    label: String,
    help: String,
    /// Does nothing after it mean anything?
    is_last: bool,
}

/// No more than these are told of one file: whoever has so many sees what is amiss.
const MOST: usize = 20;

/// Reports why a text is no TOML.
pub fn report(errors: &[Error], faults: &mut Faults) {
    let text = faults.source.text.clone();
    let mut errors: Vec<&Error> = errors.iter().collect();
    errors.sort_by_key(|error| error.span().unwrap_or_default().start);
    let mut last_line = None;
    for error in errors {
        let span = error.span().unwrap_or_default();
        let span = text.floor_char_boundary(span.start)..text.floor_char_boundary(span.end);
        let line = text[..span.start].matches('\n').count();
        if last_line == Some(line) {
            continue;
        }
        last_line = Some(line);
        let told = told(&text, span, error.message(), faults.model);
        faults.report(told.span, told.message, told.label, told.help);
        if told.is_last || faults.found.len() >= MOST {
            return;
        }
    }
}

fn told(text: &str, span: Range<usize>, message: &str, model: &str) -> Told {
    let (what, expected) = message.split_once(", expected ").unwrap_or((message, "readable TOML"));
    let one = |message: &str, label: &str, help: &str| Told {
        span: span.clone(),
        message: message.to_owned(),
        label: label.to_owned(),
        help: help.to_owned(),
        is_last: false,
    };
    let found = text.get(span.clone()).unwrap_or_default();
    if what == "duplicate key" {
        if let Some(told) = one_pair_of_brackets(text, span.start) {
            return told;
        }
        let message = format!("`{found}` stands here for the second time");
        return one(&message, "it already has a value", "keep one of the two");
    }
    if what.starts_with("invalid multi-line") {
        return never_ends(text, span.start);
    }
    if what == "invalid basic string" || what == "invalid literal string" {
        return match text[span.start..].chars().next() {
            None | Some('\n' | '\r') => one(
                "a text in quotes does not end on its line",
                &format!("expected {expected}"),
                "close it; a text of several lines stands between `'''` and `'''`",
            ),
            Some(_) => one("a character that cannot be seen", "expected letters, figures and signs", "delete it"),
        };
    }
    if what.contains("escape") {
        let help = "write `\\\\` for a backslash, or put the text between single quotes: `'…'`";
        return one(
            "a backslash in a text in quotes",
            "it begins a special character, and there is none like this",
            help,
        );
    }
    if what == "unclosed table" || what == "unclosed array table" {
        let label = format!("expected {expected}");
        return one("a heading in brackets is not closed", &label, "close it as in `[scene]` or `[[part]]`");
    }
    if let Some((open, bracket)) = open_bracket(text, span.start)
        && (closes_another(bracket, &text[span.start..]) || begins_anew(text, span.start))
    {
        let (thing, close) = if bracket == '[' { ("a list", ']') } else { ("a table in braces", '}') };
        let line = text[..span.start].matches('\n').count() + 1;
        return Told {
            span: open..open + 1,
            message: format!("{thing} is not closed"),
            label: format!("expected its `{close}` before line {line}, column {}", column(text, span.start)),
            help: format!("write `{close}` where it ends"),
            is_last: true,
        };
    }
    if what.starts_with("missing comma") {
        return one(
            "two things without a comma between them",
            "expected `,` before this",
            "write a comma between them",
        );
    }
    let value = value_at(text, span.start);
    if what == "string values must be quoted" && found.trim().is_empty() {
        let help = "write its text in quotes after the `=`, or take the line out";
        return Told { is_last: true, ..one("a key without a value", "expected a value after the `=`", help) };
    }
    // Or one of several in a list or a table in braces.
    let value = value.filter(|value| !text[value.clone()].starts_with(['"', '\'', '[', '{', '=']));
    let value = value.or_else(|| one_of_several(text, span.start).filter(|_| what == "string values must be quoted"));
    if let Some(value) = value {
        let written = text[value.clone()].trim_matches(['“', '”', '„', '‘', '’', '"', '\'']).to_owned();
        let curly = text[value.clone()].starts_with(['“', '”', '„', '‘', '’']);
        let message = if curly { "a text in curly quotes" } else { "a value without quotes" };
        let label = if curly { "expected straight quotes" } else { "expected text in quotes" };
        return Told { span: value, ..one(message, label, &format!("write `\"{written}\"`")) };
    }
    let line = text[text[..span.start].rfind('\n').map_or(0, |before| before + 1)..].lines().next().unwrap_or_default();
    let sign = text[span.start..].chars().next().unwrap_or_default();
    match what {
        _ if line.trim_start().starts_with("//") => {
            one("a note that begins with `//`", "a note begins with `#`", "write `#` in place of `//`")
        }
        "invalid unquoted key" if sign == ':' => {
            one("a `:` after a key", "expected `=`", "write `=` in place of `:`, as in `{ A = \"u\", B = \"w\" }`")
        }
        "unexpected key or value" if matches!(sign, ';' | ',' | '.') => {
            one(&format!("`{sign}` after a value"), "expected the end of the line", &format!("take the `{sign}` out"))
        }
        "extra `=`" => one("a second `=`", "expected a value", "write one `=` between a key and its value"),
        "key with no value" => Told {
            is_last: true,
            ..one(
                "a line that is no `key = value`",
                "expected `=` after the key",
                "words belong in quotes, and a note begins with `#`; or is a text above not closed?",
            )
        },
        _ => {
            let label =
                if expected == "nothing" { "expected nothing here".to_owned() } else { format!("expected {expected}") };
            one(&format!("the file cannot be read from here on: {what}"), &label, model)
        }
    }
}

/// Does a text go on with the bracket that closes something else?
fn closes_another(open: char, text: &str) -> bool {
    text.starts_with(if open == '[' { '}' } else { ']' })
}

fn column(text: &str, at: usize) -> usize {
    text[..at].rsplit('\n').next().unwrap_or_default().chars().count() + 1
}

/// A heading in one pair of brackets before others of its name in two, or after them.
fn one_pair_of_brackets(text: &str, at: usize) -> Option<Told> {
    let from = text[..at].rfind('\n').map_or(0, |before| before + 1);
    let second = text[from..].lines().next()?.trim_end();
    let heading = second.trim_matches(['[', ']']);
    let (single, double) = (format!("[{heading}]"), format!("[[{heading}]]"));
    let (own, other) = if second == single { (&single, &double) } else { (&double, &single) };
    let mut lines = text[..from].split_inclusive('\n').scan(0, |end, line| {
        *end += line.len();
        Some((*end - line.len(), line))
    });
    let (before, _) = lines.find(|(_, line)| second == own && line.trim_end() == other)?;
    let start = if *own == single { from } else { before };
    Some(Told {
        span: start..start + single.len(),
        message: format!("`{single}` in one pair of brackets"),
        label: format!("there are several, and each begins with `[[{heading}]]`"),
        help: format!("write `[[{heading}]]`"),
        is_last: false,
    })
}

/// A text between three quotes that never ends: told where it begins; or with a sign in it that no text may have.
fn never_ends(text: &str, at: usize) -> Told {
    let before = &text[..at.min(text.len())];
    let start = before.rfind("'''").max(before.rfind("\"\"\"")).unwrap_or(0);
    let quotes = &text[start..(start + 3).min(text.len())];
    let inside = text[start + quotes.len()..].split(quotes).next().unwrap_or_default();
    let is_strange = |sign: char| sign.is_control() && !matches!(sign, '\n' | '\r' | '\t');
    if let Some(place) = inside.find(is_strange) {
        let place = start + quotes.len() + place;
        return Told {
            span: place..place + text[place..].chars().next().map_or(1, char::len_utf8),
            message: "a character that cannot be seen".to_owned(),
            label: "expected letters, figures and signs".to_owned(),
            help: "delete it".to_owned(),
            is_last: false,
        };
    }
    Told {
        span: start..start + quotes.len(),
        message: "a text of several lines is not closed".to_owned(),
        label: format!("its closing `{quotes}` is missing"),
        help: format!("write `{quotes}` on a line of its own where the text ends"),
        is_last: true,
    }
}

/// The value of the `key = value` in whose line this is, if it is in the value and the value ends with the line.
fn value_at(text: &str, at: usize) -> Option<Range<usize>> {
    let from = text[..at].rfind('\n').map_or(0, |before| before + 1);
    let to = text[at..].find(['\n', '\r', '#']).map_or(text.len(), |length| at + length);
    let line = &text[from..to];
    let equals = line.find('=')?;
    let key = line[..equals].trim();
    let is_key = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-.\"".contains(c));
    let after = &line[equals + 1..];
    let start = from + equals + 1 + (after.len() - after.trim_start().len());
    let end = from + line.trim_end().len();
    (is_key && start <= at && start < end).then_some(start..end)
}

/// The value that begins at a place within brackets or braces: all before the comma or bracket that ends it.
fn one_of_several(text: &str, at: usize) -> Option<Range<usize>> {
    open_bracket(text, at)?;
    let length = text[at..].find([',', ']', '}', '\n', '\r', '#']).unwrap_or(text.len() - at);
    let value = text[at..at + length].trim_end();
    (!value.is_empty()).then(|| at..at + value.len())
}

/// Does a new `key =` or `[heading]` begin at this place, or has it just begun?
fn begins_anew(text: &str, at: usize) -> bool {
    let from = text[..at].rfind('\n').map_or(0, |before| before + 1);
    if text[from..at].contains(['=', '"', '\'']) {
        return false;
    }
    let line = text[from..].lines().next().unwrap_or_default();
    let key = line.split('=').next().unwrap_or_default().trim();
    let is_key = line.contains('=') && !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-.".contains(c));
    is_key || (line.starts_with('[') && !line.contains(['"', '\'']))
}

/// The last bracket or brace that is open at a place; brackets in texts and notes do not count.
fn open_bracket(text: &str, until: usize) -> Option<(usize, char)> {
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    while at < until.min(text.len()) {
        let rest = &text[at..];
        if let Some(quote) = ["'''", "\"\"\"", "'", "\""].into_iter().find(|quote| rest.starts_with(quote)) {
            at += quote.len();
            at += inside(&text[at..], quote);
            continue;
        }
        let Some(first) = rest.chars().next() else { break };
        match first {
            '#' => {
                at += rest.find('\n').unwrap_or(rest.len());
                continue;
            }
            '[' | '{' => open.push((at, first)),
            ']' | '}' => drop(open.pop()),
            _ => {}
        }
        at += first.len_utf8();
    }
    open.pop()
}

/// How long a text and its closing quotes are; one in single or double quotes ends with its line at the latest.
fn inside(rest: &str, quote: &str) -> usize {
    let mut at = 0;
    while at < rest.len() {
        let here = &rest[at..];
        if here.starts_with(quote) {
            return at + quote.len();
        }
        if quote.len() == 1 && here.starts_with('\n') {
            return at;
        }
        let escaped = quote.starts_with('"') && here.starts_with('\\');
        at += here.chars().take(if escaped { 2 } else { 1 }).map(char::len_utf8).sum::<usize>();
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bracket_that_is_open_is_found() {
        let table = [
            ("a = [\"x\", ", Some((4, '['))),
            ("a = [\"]\"", Some((4, '['))),
            ("a = [ # ]\n", Some((4, '['))),
            ("a = [{ b = '}' ", Some((5, '{'))),
            ("a = [{ b = 1 }", Some((4, '['))),
            ("[a]\nb = '''[\n'''\n", None),
            ("a = \"\\\"[\"\n", None),
            ("", None),
        ];
        for (text, expected) in table {
            assert_eq!(open_bracket(text, text.len()), expected, "{text}");
        }
    }
}
