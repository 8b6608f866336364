//! What is amiss with a question.

use std::ops::Range;

use crate::bank::{StyleName, key_span, row_span};
use crate::diagnostic::{Diagnostic, Severity, Source};

/// Something amiss, with all that a person needs to mend it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// How bad it is.
    pub severity: Severity,
    /// What it is, in one sentence.
    pub message: String,
    /// What stands in the file at the place where it can be mended; empty if no place is better than another.
    pub at: String,
    /// Or the key of a style, as a rule one of its parameters, at which it can be mended.
    pub key: Option<(StyleName, String)>,
    /// Or the row of a part: the place of the part, its list `answers` or `marks`, the place in that.
    pub row: Option<(usize, &'static str, usize)>,
    /// Or the bytes of the file within which it stands.
    pub within: Option<Range<usize>>,
    /// What was expected there.
    pub label: String,
    /// One thing to try.
    pub help: Option<String>,
}

impl Finding {
    /// A finding that must be mended.
    pub fn new(message: impl Into<String>, at: impl Into<String>, label: impl Into<String>) -> Finding {
        let (message, at, label) = (message.into(), at.into(), label.into());
        let (key, row, within) = (None, None, None);
        Finding { severity: Severity::Error, message, at, key, row, within, label, help: None }
    }

    /// A finding at the key of a parameter, which must be mended.
    pub fn at_parameter(message: impl Into<String>, style: StyleName, name: &str, label: &str) -> Finding {
        Finding::new(message, "", label).at_key(style, name)
    }

    /// At a key of a style.
    pub fn at_key(self, style: StyleName, name: &str) -> Finding {
        Finding { key: Some((style, name.to_owned())), ..self }
    }

    /// At a row of a part.
    pub fn at_row(self, part: usize, list: &'static str, row: usize) -> Finding {
        Finding { row: Some((part, list, row)), ..self }
    }

    /// As one that stops nothing.
    pub fn as_warning(self) -> Finding {
        Finding { severity: Severity::Warning, ..self }
    }

    /// With one thing to try.
    pub fn with_help(self, help: impl Into<String>) -> Finding {
        Finding { help: Some(help.into()), ..self }
    }

    /// The finding in the file of its question.
    pub fn diagnostic(&self, id: &str, source: &Source) -> Diagnostic {
        let key = self.key.as_ref().and_then(|(style, name)| key_span(&source.text, *style, name));
        let row = self.row.and_then(|(part, list, row)| row_span(&source.text, part, list, row));
        let within = self.within.clone().unwrap_or(0..source.text.len());
        let text = source.text.get(within.clone()).unwrap_or_default();
        // What is asked for may be named in the scene and in the marks too.
        let asked = |list: &str| {
            if self.at.starts_with('"') { place(text, &format!("find = {list}{}", self.at)) } else { None }
        };
        // A number may stand in the file in another form than it is told in.
        let before_number =
            || place(text, self.at.rsplit_once('{').map(|(before, _)| before).filter(|at| !at.trim().is_empty())?);
        let words = || {
            let both = [self.at.clone(), begun(&self.at)];
            both.iter().filter_map(|at| place(text, at)).min_by_key(|place| remote(text, place))
        };
        let found = asked("").or_else(|| asked("[")).or_else(words).or_else(before_number);
        let found = found.map(|place| within.start + place.start..within.start + place.end);
        let found = found.or(self.within.clone());
        let span = key.or(row).or(found);
        let label = if span.is_some() { self.label.as_str() } else { "" };
        let fault = Diagnostic::new(format!("`{id}`: {}", self.message), source, span.unwrap_or(0..0), label);
        Diagnostic { severity: self.severity, help: self.help.as_ref().map(|help| typed(help, id, source)), ..fault }
    }
}

/// Commands that name a question as it is found from where the person is: in a bank of one's own by its file.
fn typed(help: &str, id: &str, source: &Source) -> String {
    let is_shipped = *source.file == format!("question_bank/{id}.toml");
    let plain = |sign: char| sign.is_alphanumeric() || "-_./\\:~+".contains(sign);
    let file = if source.file.chars().all(plain) { source.file.to_string() } else { format!("\"{}\"", source.file) };
    let commands = ["explain", "preview"].into_iter().filter(|_| !is_shipped);
    commands.fold(help.to_owned(), |help, command| {
        help.replace(&format!("`carom {command} {id}`"), &format!("`carom {command} {file}`"))
    })
}

/// The same words where a sentence begins with them.
fn begun(words: &str) -> String {
    let mut signs = words.chars();
    signs.next().map_or_else(String::new, |first| first.to_uppercase().chain(signs).collect())
}

/// Where words stand in a text, which may break the line between any two of them; not in a comment or the title, if they
/// stand elsewhere.
fn place(text: &str, words: &str) -> Option<Range<usize>> {
    let mut rest = words.split_whitespace();
    let first = rest.next()?;
    let rest: Vec<&str> = rest.collect();
    let found = |(start, _): (usize, &str)| {
        let mut end = start + first.len();
        for word in &rest {
            let after = &text[end..];
            let next = after.trim_start();
            if next.len() == after.len() || !next.starts_with(word) {
                return None;
            }
            end = text.len() - next.len() + word.len();
        }
        Some(start..end)
    };
    text.match_indices(first).filter_map(found).min_by_key(|place| remote(text, place))
}

/// Is it in a comment? Is it in the title?
fn remote(text: &str, place: &Range<usize>) -> (bool, bool) {
    let line = text[..place.start].rfind('\n').map_or(0, |end| end + 1);
    let is_after = |start: &str| text[line..].trim_start().starts_with(start);
    (is_after("#"), is_after("title"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_name_the_file_of_a_bank_of_ones_own() {
        let help = "`carom preview walls/q` shows its marks";
        let of = |file: &str| typed(help, "walls/q", &Source::new(file, ""));
        assert_eq!(of("question_bank/walls/q.toml"), help);
        assert_eq!(of("mine/walls/q.toml"), "`carom preview mine/walls/q.toml` shows its marks");
        assert_eq!(of("my bank/walls/q.toml"), "`carom preview \"my bank/walls/q.toml\"` shows its marks");
    }

    #[test]
    fn a_place_is_no_comment_and_an_answer_is_where_it_is_asked_for() {
        let text = "# A second [[part]] or none.\ne = \"e\"\n[[part]]\nanswers = [{ find = \"e\" }]\n";
        let source = Source::new("q.toml", text);
        let line = |at: &str| Finding::new("it", at, "here").diagnostic("q", &source).to_string();
        assert!(line("[[part]]").contains("q.toml:3:1"), "{}", line("[[part]]"));
        assert!(line("\"e\"").contains("q.toml:4:14"), "{}", line("\"e\""));
        let text = "title = \"Turned through a right angle\"\nstem = \"The sphere turns through a right angle.\"\n";
        let source = Source::new("q.toml", text);
        let line = |at: &str| Finding::new("it", at, "here").diagnostic("q", &source).to_string();
        assert!(line("through a right").contains("q.toml:2:26"), "{}", line("through a right"));
        assert!(line("the sphere").contains("q.toml:2:9"), "{}", line("the sphere"));
        assert!(line("Turned").contains("q.toml:1:10"), "{}", line("Turned"));
        let source = Source::new("q.toml", "# B is the heavier.\nstem = \"The heavier is *A*.\"\n");
        let found = Finding::new("it", "the heavier", "here").diagnostic("q", &source).to_string();
        assert!(found.contains("q.toml:2:9"), "{found}");
    }

    #[test]
    fn words_are_found_across_the_ends_of_lines_and_only_whole() {
        let text = "The sphere *A* has mass 2.\nThe mass of\n  *A of it.";
        for (words, found) in [
            ("mass of *A of", Some("mass of\n  *A of")),
            ("sphere *A*", Some("sphere *A*")),
            ("masses of", None),
            ("mass  2.", Some("mass 2.")),
            ("", None),
        ] {
            assert_eq!(place(text, words).map(|place| &text[place]), found, "{words}");
        }
    }
}
