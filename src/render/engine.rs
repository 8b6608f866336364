//! What the template engine finds wrong, in the words and pictures of our own faults.
//!
//! Tera gives a place with each mistake of syntax. Names of filters, tests, functions and files it looks up only when it
//! knows all templates, and then it gives a finished report; its first two lines say what and where.

use std::collections::BTreeMap;
use std::ops::Range;

use tera::ErrorKind;

use super::code::{Code, Word, read};
use super::fault::listed;
use super::manifest::Marks;
use crate::diagnostic::{Diagnostic, Source, near};

/// The words with which a block may begin.
const TAGS: [&str; 20] = [
    "if",
    "elif",
    "else",
    "endif",
    "for",
    "endfor",
    "break",
    "continue",
    "set",
    "set_global",
    "endset",
    "include",
    "extends",
    "block",
    "endblock",
    "filter",
    "endfilter",
    "component",
    "endcomponent",
    "raw",
];

const FILTERS: [&str; 37] = [
    "abs",
    "capitalize",
    "default",
    "escape",
    "escape_html",
    "escape_xml",
    "first",
    "float",
    "get",
    "group_by",
    "indent",
    "int",
    "join",
    "keys",
    "last",
    "length",
    "lower",
    "newlines_to_br",
    "nth",
    "pairs",
    "pluralize",
    "replace",
    "reverse",
    "round",
    "safe",
    "sort",
    "split",
    "str",
    "title",
    "trim",
    "trim_end",
    "trim_start",
    "truncate",
    "unique",
    "upper",
    "values",
    "wordcount",
];

const TESTS: [&str; 17] = [
    "array",
    "bool",
    "containing",
    "defined",
    "divisible_by",
    "ending_with",
    "even",
    "float",
    "integer",
    "iterable",
    "map",
    "none",
    "number",
    "odd",
    "starting_with",
    "string",
    "undefined",
];

const FUNCTIONS: [&str; 3] = ["range", "super", "throw"];

const LOOP: [&str; 5] = ["first", "index", "index0", "last", "length"];

/// The templates of a folder, as the engine was given them.
pub(super) struct Templates<'a> {
    /// The name of the folder, with which the names of its templates begin.
    pub folder: &'a str,
    /// The files by their paths in the folder.
    pub files: &'a BTreeMap<String, Source>,
    /// What sets code apart.
    pub marks: &'a Marks,
}

impl Templates<'_> {
    /// The faults behind an error of the engine; `file` is the template that it was busy with.
    pub fn faults(&self, error: &tera::Error, file: &str) -> Vec<Diagnostic> {
        match error.kind() {
            ErrorKind::SyntaxError(report) | ErrorKind::RenderingError(report) => {
                let source = self.source(report.filename());
                vec![self.mistake(report.message(), &source, report.span().range.clone())]
            }
            ErrorKind::CircularInclude { tpl, include_chain: chain }
            | ErrorKind::CircularExtend { tpl, inheritance_chain: chain } => {
                vec![self.circle(tpl, chain)]
            }
            ErrorKind::MissingParent { current, parent } => {
                let source = self.source(current);
                let span = self.names_of_files(&source).find(|word| word.quoted() == Some(parent.as_str()));
                vec![self.unknown("template", parent, &source, span.map_or(0..0, |word| word.span()))]
            }
            ErrorKind::Msg(message) => {
                let reports = message.split("\n\n").map(|report| self.reported(report));
                reports.collect::<Option<Vec<_>>>().unwrap_or_else(|| vec![self.unplaced(message, file)])
            }
            _ => vec![self.unplaced(&error.to_string(), file)],
        }
    }

    /// The text of a template by the name that the engine has for it.
    fn source(&self, name: &str) -> Source {
        let path = name.strip_prefix(self.folder).and_then(|rest| rest.strip_prefix('/')).unwrap_or(name);
        self.files.get(path).cloned().unwrap_or_else(|| Source::new(name, ""))
    }

    fn unplaced(&self, message: &str, file: &str) -> Diagnostic {
        let first = message.lines().next().unwrap_or_default();
        Diagnostic::new(lower(first), &self.source(file), 0..0, "found when all templates had been read")
    }

    /// A mistake that the engine has found at a place.
    fn mistake(&self, message: &str, source: &Source, span: Range<usize>) -> Diagnostic {
        let found = source.text.get(span.clone()).unwrap_or_default();
        if message == "Unknown tag" {
            if TAGS.contains(&found) {
                return Diagnostic::new(format!("`{found}` closes nothing"), source, span, "nothing is open here");
            }
            let fault = Diagnostic::new(format!("unknown tag `{found}`"), source, span, "no block begins so");
            return fault.with_near(near(found, TAGS));
        }
        if message.starts_with("Unexpected end of input") {
            return match unclosed(&read(&source.text, self.marks)) {
                Some(word) => {
                    let closing = word.text.trim_end_matches("_global");
                    let label = format!("the template ends without an `end{closing}`");
                    Diagnostic::new(format!("`{}` without an end", word.text), source, word.span(), label)
                }
                None => {
                    let end = span.end..span.end;
                    Diagnostic::new("the template ends too early", source, end, "something is open here")
                }
            };
        }
        if message.starts_with("Found invalid field of `loop`") {
            let label = format!("`loop` has {}", listed(&LOOP));
            let fault = Diagnostic::new(format!("unknown name `{found}` of `loop`"), source, span, label);
            return fault.with_near(near(found, LOOP));
        }
        if message == "Unexpected character" {
            let letter = source.text.get(span.start..).and_then(|rest| rest.chars().next());
            let message = letter.map_or_else(|| lower(message), |letter| format!("unexpected `{letter}` in code"));
            return Diagnostic::new(message, source, span, "perhaps a mark before it was never closed");
        }
        let ours = self.in_our_marks(message);
        let parts = [" but expected ", " but was expecting "].into_iter().find_map(|but| ours.split_once(but));
        match parts {
            Some((found, expected)) => {
                let expected = match expected.trim_end_matches('.') {
                    "identifier" => "a name",
                    // what the engine lists is everything with which a value may begin
                    list if list.starts_with("one of: integer") => "a name, a number or words in quotes",
                    other => other,
                };
                Diagnostic::new(lower(found), source, span, format!("expected {expected}"))
            }
            None => Diagnostic::new(lower(&ours), source, span, "here"),
        }
    }

    /// The engine speaks of its own marks, whatever marks a format has.
    fn in_our_marks(&self, message: &str) -> String {
        let Marks { variable, block, .. } = self.marks;
        let usual = [("{{", &variable[0]), ("}}", &variable[1]), ("{%", &block[0]), ("%}", &block[1])];
        usual.iter().fold(message.to_owned(), |message, (theirs, ours)| message.replace(theirs, ours))
    }

    /// A report such as ``error: Unknown filter `shout` `` with ` --> latex/preamble.tex:3:10` below it.
    fn reported(&self, report: &str) -> Option<Diagnostic> {
        let mut lines = report.lines();
        let message = lines.next()?.strip_prefix("error: ")?;
        let mut place = lines.next()?.trim_start().strip_prefix("--> ")?.rsplitn(3, ':');
        let (column, line) = (place.next()?.parse::<usize>().ok()?, place.next()?.parse::<usize>().ok()?);
        let source = self.source(place.next()?);
        let start = offset(&source.text, line, column)?;
        let (what, name) = message.strip_prefix("Unknown ")?.strip_suffix('`')?.split_once(" `")?;
        let quotes = usize::from(source.text[start..].starts_with(['"', '\'', '`'])) * 2;
        Some(self.unknown(what, name, &source, start..start + name.len() + quotes))
    }

    /// A name of which Tera or the folder knows nothing.
    fn unknown(&self, what: &str, name: &str, source: &Source, span: Range<usize>) -> Diagnostic {
        let files: Vec<&str> = self.files.keys().map(String::as_str).collect();
        let (label, names) = match what {
            "filter" => ("Tera has no filter of that name".to_owned(), &FILTERS[..]),
            "test" => (format!("the tests are {}", listed(&TESTS)), &TESTS[..]),
            "function" => (format!("the functions are {}", listed(&FUNCTIONS)), &FUNCTIONS[..]),
            "template" => (format!("the folder has {}", listed(&files)), &files[..]),
            _ => ("no template defines it".to_owned(), &[][..]),
        };
        let fault = Diagnostic::new(format!("unknown {what} `{name}`"), source, span, label);
        fault.with_near(near(name, names.iter().copied()))
    }

    /// Templates that include or extend each other in a circle.
    fn circle(&self, first: &str, chain: &[String]) -> Diagnostic {
        let source = self.source(first);
        let in_folder =
            |name: &str| name.strip_prefix(self.folder).map_or(name.to_owned(), |rest| rest[1..].to_owned());
        let chain: Vec<String> = chain.iter().map(|name| in_folder(name)).collect();
        let mut words = self.names_of_files(&source);
        let span = words.find(|word| word.quoted().is_some_and(|name| chain.contains(&in_folder(name))));
        let label = format!("{} lead in a circle", listed(&chain.iter().map(String::as_str).collect::<Vec<_>>()));
        let message = format!("template `{}` leads back to itself", in_folder(first));
        Diagnostic::new(message, &source, span.map_or(0..0, |word| word.span()), label)
    }

    /// What stands after `include` and `extends`.
    fn names_of_files<'s>(&self, source: &'s Source) -> impl Iterator<Item = Word<'s>> {
        read(&source.text, self.marks).into_iter().filter_map(|code| match code {
            Code::Block(words) if matches!(words.first()?.text, "include" | "extends") => words.get(1).copied(),
            _ => None,
        })
    }
}

/// The last block that is opened and not closed.
fn unclosed<'t>(codes: &[Code<'t>]) -> Option<Word<'t>> {
    let mut open: Vec<Word<'t>> = Vec::new();
    for code in codes {
        let Code::Block(words) = code else { continue };
        let Some(first) = words.first() else { continue };
        match first.text {
            "if" | "for" | "block" | "filter" | "component" => open.push(*first),
            "set" | "set_global" if !words.iter().any(|word| word.text == "=") => open.push(*first),
            closing if closing.starts_with("end") => {
                open.pop();
            }
            _ => {}
        }
    }
    open.pop()
}

/// Where a line and a column of it begin, both from 1, the column in characters.
fn offset(text: &str, line: usize, column: usize) -> Option<usize> {
    let start: usize = text.split_inclusive('\n').take(line.checked_sub(1)?).map(str::len).sum();
    let rest = text.get(start..)?;
    let within = rest.char_indices().map(|(at, _)| at).chain([rest.len()]).nth(column.checked_sub(1)?)?;
    Some(start + within)
}

/// As our messages are: the first letter small, no full stop.
fn lower(message: &str) -> String {
    let mut letters = message.trim_end_matches('.').chars();
    let first = letters.next().map(|letter| letter.to_lowercase().to_string()).unwrap_or_default();
    first + letters.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_the_filters_tests_and_functions_of_the_engine() {
        let compiles = |template: String| tera::Tera::new().add_raw_template("t", &template).is_ok();
        assert!(FILTERS.iter().all(|name| compiles(format!("{{{{ x | {name} }}}}"))));
        assert!(TESTS.iter().all(|name| compiles(format!("{{{{ x is {name} }}}}"))));
        assert!(FUNCTIONS.iter().all(|name| compiles(format!("{{{{ {name}() }}}}"))));
        assert!(!compiles("{{ x | shout }}{{ x is loud }}{{ cry() }}".to_owned()));
    }

    #[test]
    fn carom_finds_the_place_of_a_line_and_column() {
        assert_eq!(offset("ab\nθc\n", 2, 2), Some(5));
        assert_eq!(offset("ab", 1, 3), Some(2));
        assert_eq!(offset("ab", 1, 4), None);
        assert_eq!(offset("ab", 0, 1), None);
    }
}
