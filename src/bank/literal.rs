//! From a place inside a string to its place in the file, whatever quotes and escapes it is written with.

use std::ops::Range;

use toml::Spanned;

use crate::expr::Span;

/// A string of a bank file; its span holds the quotes too.
pub type Words = Spanned<String>;

/// Where in the file a part of the string's text stands.
pub fn place(file: &str, words: &Words, part: Span) -> Range<usize> {
    let span = words.span();
    let Some(raw) = file.get(span.clone()) else { return span };
    let start = span.start + raw_offset(raw, words.get_ref(), part.start);
    let end = span.start + raw_offset(raw, words.get_ref(), part.end);
    start..end.max(start)
}

/// The byte of the written literal at which byte `wanted` of its text begins.
fn raw_offset(raw: &str, text: &str, wanted: usize) -> usize {
    let quote = ["'''", "\"\"\"", "'", "\""].into_iter().find(|quote| raw.starts_with(quote)).unwrap_or("");
    let mut at = quote.len();
    if quote.len() == 3 {
        // The line break after the opening quotes is not part of the text.
        let after = &raw[at..];
        at += if after.starts_with("\r\n") { 2 } else { usize::from(after.starts_with('\n')) };
    }
    let escapes = quote.starts_with('"');
    let mut read = 0;
    while read < wanted.min(text.len()) {
        let rest = &raw[at..];
        let Some(first) = rest.chars().next() else { break };
        if first == '\\' && escapes {
            let (written, meant) = escape(rest);
            at += written;
            read += meant;
        } else if first == '\r' && text[read..].starts_with('\n') {
            at += 1;
        } else {
            at += first.len_utf8();
            read += first.len_utf8();
        }
    }
    at
}

/// How many bytes an escape takes as it is written, and in the text.
fn escape(rest: &str) -> (usize, usize) {
    let hexadecimal = |digits: usize| {
        let code = rest.get(2..2 + digits).and_then(|code| u32::from_str_radix(code, 16).ok());
        (2 + digits, code.and_then(char::from_u32).map_or(1, char::len_utf8))
    };
    match rest.as_bytes().get(1) {
        Some(b'x') => hexadecimal(2),
        Some(b'u') => hexadecimal(4),
        Some(b'U') => hexadecimal(8),
        // A backslash at the end of a line takes away all space up to the next word.
        Some(b' ' | b'\t' | b'\n' | b'\r') => (1 + rest[1..].len() - rest[1..].trim_start().len(), 0),
        Some(_) => (2, 1),
        None => (1, 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_a_string_is_found_again_in_the_file() {
        let literals = [
            "'one/two'",
            "\"one/two\"",
            "'''\none/two'''",
            "'''\r\none/\r\ntwo'''",
            "\"\"\"\none\\\n   /two\"\"\"",
            "\"\\u00e9one\\\\/\\ttwo\"",
            "\"\\x41\\n\\\"\\U0001F600 one two\"",
            "'θ one two'",
        ];
        for literal in literals {
            let file = format!("a = 1\nx = {literal}\n");
            let table: std::collections::BTreeMap<String, Spanned<toml::Value>> =
                toml::from_str(&file).unwrap_or_else(|error| panic!("{literal}: {error}"));
            let span = table["x"].span();
            let text = table["x"].get_ref().as_str().unwrap().to_owned();
            let words = Spanned::new(span, text.clone());
            for wanted in ["one", "two"] {
                let start = text.find(wanted).unwrap();
                let found = place(&file, &words, Span { start, end: start + wanted.len() });
                assert_eq!(&file[found], wanted, "{literal}");
            }
            let end = place(&file, &words, Span { start: text.len(), end: text.len() });
            assert!(end.start < words.span().end, "{literal}");
        }
    }
}
