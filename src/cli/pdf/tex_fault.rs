//! An error of TeX as a fault in a file: which line, what is wrong with it, what to try.

use std::env::consts::OS;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::super::failure::Failure;
use super::package;
use super::tex_log::{TexError, first_error};
use crate::diagnostic::{Diagnostic, Source};
use crate::render::TemplateFile;

/// The templates of a teacher, who can mend them, and their folder.
#[derive(Clone, Debug, Default)]
pub struct OwnTemplates {
    /// As the teacher calls it.
    pub folder: PathBuf,
    /// The files in it.
    pub files: Vec<TemplateFile>,
}

impl OwnTemplates {
    /// The template and the line of it from which a line of a document comes, if only one can be meant.
    fn origin(&self, line: &str) -> Option<String> {
        let lines = self.files.iter().filter(|file| file.path.starts_with("latex/")).flat_map(|file| {
            file.contents.lines().enumerate().map(move |(index, template)| (file, index + 1, template))
        });
        let mut found = lines.filter(|(_, _, template)| becomes(template, line));
        let (file, number, _) = found.next()?;
        let path = Path::new(&self.folder).join(&file.path);
        found.next().is_none().then(|| format!("`{}`, line {number}", path.display()))
    }
}

/// Whether a line of a template becomes a line of a document: the words between its marks stand there in their order.
fn becomes(template: &str, line: &str) -> bool {
    let words = words(template);
    if words.iter().map(|word| word.len()).sum::<usize>() < 3 {
        return false;
    }
    let mut rest = line;
    words.iter().all(|word| match rest.find(word) {
        Some(at) => {
            rest = &rest[at + word.len()..];
            true
        }
        None => false,
    })
}

/// What a line of a template prints as it stands: all but `<<name>>`, `<% if %>` and `<# remark #>`.
fn words(template: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = template;
    loop {
        let marks = [("<<", ">>"), ("<%", "%>"), ("<#", "#>")];
        let first = marks.iter().filter_map(|(open, close)| Some((rest.find(open)?, close))).min();
        let (end, after) = match first {
            None => (rest.len(), ""),
            Some((start, close)) => {
                (start, rest[start..].find(close).map_or("", |length| &rest[start + length + close.len()..]))
            }
        };
        words.push(rest[..end].trim());
        if after.is_empty() {
            break;
        }
        rest = after;
    }
    words.retain(|word| !word.is_empty());
    words
}

/// What an error is in a person's words.
struct Meaning {
    message: String,
    /// What in the line is meant, if it has a name.
    name: Option<String>,
    label: String,
    help: Option<String>,
}

/// What TeX waits for.
const END: &str = r"\end{document}";

/// What TeX has said against a document.
pub fn fault(said: &str, document: &Source, engine: &str, own: &OwnTemplates) -> Failure {
    let Some(error) = first_error(said) else {
        let file = Path::new(&*document.file).file_name().unwrap_or_default().to_string_lossy();
        return Failure::with_help(
            format!("`{engine}` failed on `{file}` without saying why"),
            "run it on the file yourself, or print with a browser instead: `CAROM_TEX=none`",
        );
    };
    if error.message.contains("format file") {
        return Failure::with_help(
            format!("`{engine}` is not fully installed: its format file is missing"),
            format!("install LaTeX for it; {}", package::install("amsmath.sty", OS).trim_start_matches("install it: ")),
        );
    }
    if error.line == 0 && !document.text.contains(END) {
        let end = document.text.trim_end().len();
        let fault = Diagnostic::new("the document has no end", document, end..end, format!("expected `{END}`"));
        return Failure::Faults(vec![fault.with_help(format!("put `{END}` at the end of the template"))]);
    }
    let meaning = meaning(&error, said, engine);
    let (source, span) = place(&error, document, meaning.name.as_deref());
    let line = line_at(&source.text, span.start);
    let help = match (meaning.help, own.origin(line)) {
        (Some(help), None) => help,
        (Some(help), Some(origin)) => format!("{help}; the line comes from {origin}"),
        (None, Some(origin)) => format!("mend the line where it comes from: {origin}"),
        (None, None) => "print with a browser instead: `CAROM_TEX=none`".to_owned(),
    };
    Failure::Faults(vec![Diagnostic::new(meaning.message, &source, span, meaning.label).with_help(help)])
}

fn meaning(error: &TexError, said: &str, engine: &str) -> Meaning {
    let stopped = || format!("`{engine}` stopped here");
    let text = error.message.trim_end_matches('.');
    let text = text.strip_prefix("LaTeX Error: ").unwrap_or(text);
    if text == "Undefined control sequence" {
        let command = unknown_command(error);
        let label = if error.read.trim_end().ends_with(&command) { "no such command" } else { "leads to it" };
        let message = format!("unknown command `{command}`");
        return Meaning { message, name: Some(command), label: label.into(), help: None };
    }
    if let Some(name) = between(text, "Environment ", " undefined") {
        let message = format!("unknown environment `{name}`");
        return Meaning { message, name: Some(name), label: "no such environment".into(), help: None };
    }
    if let Some(file) = between(text, "File `", "' not found") {
        // LaTeX tries the name with its ending last; that is the name it reports.
        if said.contains(&format!("Not reading from {}", file.trim_end_matches(".tex"))) {
            let label = "a paper is printed without looking at other files".into();
            let help = Some("put the words into the template itself".into());
            let file = file.trim_end_matches(".tex").to_owned();
            return Meaning { message: format!("`{file}` may not be read"), name: Some(file), label, help };
        }
        let name = file.trim_end_matches(".sty").to_owned();
        let kind = if name.len() < file.len() { "package" } else { "file" };
        let help = Some(package::install(&file, OS));
        return Meaning {
            message: format!("the LaTeX {kind} `{name}` is not installed"),
            name: Some(name.split('.').next().unwrap_or(&name).to_owned()),
            label: "needed here".into(),
            help,
        };
    }
    if let Some(file) = between(text, "I can't write on file `", "'") {
        let label = "a paper is printed without touching other files".into();
        return Meaning { message: format!("`{file}` may not be written"), name: Some(file), label, help: None };
    }
    if let Some(letter) = between(text, "Unicode character ", " not set up") {
        let name = letter.split(' ').next().map(str::to_owned);
        let help = Some("leave it out, or print with a browser, which has more letters: `CAROM_TEX=none`".into());
        return Meaning { message: format!("`{engine}` has no letter {letter}"), name, label: stopped(), help };
    }
    if let Some((package, words)) = text.strip_prefix("Package ").and_then(|rest| rest.split_once(" Error: ")) {
        let (message, name) = (format!("package `{package}`: {}", lower(words)), Some(package.to_owned()));
        return Meaning { message, name, label: stopped(), help: None };
    }
    Meaning { message: lower(text), name: None, label: stopped(), help: None }
}

/// The words with a small first letter, as all our messages begin; `TeX` and `I` stay as they are.
fn lower(text: &str) -> String {
    let mut letters = text.chars();
    let Some(first) = letters.next() else { return String::new() };
    let word = letters.as_str().split(' ').next().unwrap_or_default();
    let is_a_word = !word.is_empty() && word.chars().all(char::is_lowercase);
    if is_a_word { first.to_lowercase().chain(letters).collect() } else { text.to_owned() }
}

/// The command that TeX does not know: where the error is inside another, the last that was met there.
fn unknown_command(error: &TexError) -> String {
    let last = |text: &str| text.rfind('\\').map(|at| text[at..].trim_end().to_owned());
    // Names with @ are the inside of LaTeX, and nobody's mistake: what led there is.
    let inside = error.inside.as_deref().and_then(last).filter(|name| !name.contains('@'));
    inside.or_else(|| last(&error.read)).unwrap_or_else(|| error.read.trim().to_owned())
}

fn between(text: &str, before: &str, after: &str) -> Option<String> {
    let rest = &text[text.find(before)? + before.len()..];
    Some(rest[..rest.find(after)?].to_owned())
}

/// The document and where in it the error is; another file if TeX was reading one that no line of the document names.
fn place(error: &TexError, document: &Source, name: Option<&str>) -> (Source, Range<usize>) {
    let called = |path: &str| Path::new(path).file_name().map(|name| name.to_string_lossy().into_owned());
    let is_document = error.file.is_empty() || called(&error.file) == called(&document.file);
    let text = &*document.text;
    if is_document && error.line > 0 {
        let start = line_start(text, error.line);
        let line = line_at(text, start);
        let stop = stopped_at(line, &error.read);
        // What TeX misses has been asked for in the line, or, if it is a package, above.
        let named = name.filter(|name| !name.is_empty());
        let in_line = named.and_then(|name| line[..stop].rfind(name).or_else(|| line.find(name)).map(|at| (at, name)));
        if let Some((at, name)) = in_line {
            return (document.clone(), start + at..start + at + name.len());
        }
        let loaded = named.and_then(|name| loading(&text[..start], name));
        let last = || start + last_word(&line[..stop])..start + stop;
        return (document.clone(), loaded.unwrap_or_else(last));
    }
    let stem = Path::new(&error.file).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    match stem.and_then(|stem| loading(text, name.unwrap_or(&stem)).or_else(|| loading(text, &stem))) {
        Some(span) => (document.clone(), span),
        None if error.line == 0 => (document.clone(), 0..0),
        None => (Source::new(format!("{}:{}", error.file, error.line), ""), 0..0),
    }
}

/// Where a package, a class or a file is asked for.
fn loading(text: &str, name: &str) -> Option<Range<usize>> {
    let asks = ["\\usepackage", "\\RequirePackage", "\\documentclass", "\\input", "\\include", "\\usetikzlibrary"];
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if let Some(at) = line.rfind(name).filter(|_| asks.iter().any(|ask| line.contains(ask))) {
            return Some(start + at..start + at + name.len());
        }
        start += line.len();
    }
    None
}

/// How far a line had been read, in bytes; all of it where TeX's words do not say.
fn stopped_at(line: &str, read: &str) -> usize {
    let read = read.trim_start_matches("...").trim();
    let whole = line.trim_end().len();
    if read.is_empty() { whole } else { line.find(read).map_or(whole, |at| at + read.len()) }
}

/// Where the last word begins: a command with its backslash, else a single letter.
fn last_word(read: &str) -> usize {
    let letters = read.trim_end_matches(|letter: char| letter.is_ascii_alphabetic() || letter == '@');
    if letters.ends_with('\\') { letters.len() - 1 } else { read.char_indices().next_back().map_or(0, |(at, _)| at) }
}

fn line_start(text: &str, number: usize) -> usize {
    text.split_inclusive('\n').take(number.saturating_sub(1)).map(str::len).sum()
}

/// The line in which a place is.
fn line_at(text: &str, place: usize) -> &str {
    let start = text[..place].rfind('\n').map_or(0, |at| at + 1);
    text[start..].lines().next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_known_by_what_its_template_prints_as_it_stands() {
        for (template, line, expected) in [
            (r"\section{<<title>>} % x", r"\section{Oblique & so on} % x", true),
            (r"<% if marks %>\total{<<marks>>}<% endif %>", r"\total{20}", true),
            (r"\section{<<title>>}", r"\heading{Oblique}", false),
            ("<<paragraph>>", "any words at all", false),
            ("}", "}", false),
            (r"\a <<b", r"\a ", false),
            (r"\alpha <<b", r"\alpha ", true),
        ] {
            assert_eq!(becomes(template, line), expected, "{template}");
        }
    }

    #[test]
    fn a_template_is_named_only_if_one_line_can_be_meant() {
        let file = |path: &str, contents: &str| TemplateFile {
            path: path.into(),
            place: path.into(),
            contents: contents.into(),
        };
        let own = OwnTemplates {
            folder: "mine".into(),
            files: vec![
                file("latex/preamble.tex", "\\wrong\n\\twice\n"),
                file("latex/question-sheet.tex", "\\twice\n"),
                file("html/page.html", "\\elsewhere\n"),
            ],
        };
        let path = Path::new("mine").join("latex/preamble.tex");
        assert_eq!(own.origin(r"\wrong"), Some(format!("`{}`, line 1", path.display())));
        assert_eq!(own.origin(r"\twice"), None);
        assert_eq!(own.origin(r"\elsewhere"), None);
    }

    #[test]
    fn no_words_of_tex_make_it_panic() {
        let own = OwnTemplates::default();
        for said in
            ["", "! ", "!x", "a.tex:0: x\nl.0 y", "./sheet.tex:99: x\nl.99 é", "! Undefined control sequence.\nl.2 é"]
        {
            for text in ["", "é", "\\é\n\\begin\n"] {
                match fault(said, &Source::new("sheet.tex", text), "pdflatex", &own) {
                    Failure::Faults(faults) => assert_eq!(faults.len(), 1),
                    Failure::Said(message, help) => assert!(message.contains("pdflatex") && help.is_some()),
                    _ => panic!("another failure"),
                }
            }
        }
    }
}
