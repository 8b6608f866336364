//! The manifest of a format: `format.toml` in its folder.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::Deserialize;
use tera::Delimiters;
use toml::Spanned;

use super::Notation;
use super::fault::listed;
use crate::diagnostic::{Diagnostic, Source, near, of_another_kind};

/// What a `format.toml` says.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    /// A sentence for the list of formats.
    pub about: String,
    /// How formulas and words are printed, and by it what is escaped.
    pub notation: Notation,
    /// What sets a template's own marks apart from its text; those of Tera if left out.
    #[serde(default)]
    pub delimiters: Marks,
    /// The length to which lines of plain text are set; without it they are left as the templates have them.
    pub line_length: Option<usize>,
    /// The template of the one page that `carom preview` shows of a question.
    pub preview: Option<Spanned<String>>,
    /// The template of the page that a student gets back.
    pub feedback: Option<Spanned<String>>,
    /// The template of the report on a class.
    pub report: Option<Spanned<String>>,
    /// The files that a paper becomes.
    pub documents: Vec<Document>,
    /// The files that the papers of a class become, all of them in each.
    #[serde(default)]
    pub class: Vec<Document>,
}

/// What a template that is rendered by itself can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sees {
    /// The names of a paper.
    Paper,
    /// The one name `class`.
    Class,
    /// The one name `feedback`.
    Feedback,
    /// The one name `report`.
    Report,
}

/// One file that a paper becomes.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document {
    /// Its name.
    pub file: Spanned<String>,
    /// The template that makes it.
    pub template: Spanned<String>,
}

/// The opening and closing marks of a template, two characters each.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Marks {
    /// Around a name to be printed.
    pub variable: [String; 2],
    /// Around `if`, `for` and the like.
    pub block: [String; 2],
    /// Around what is left out.
    pub comment: [String; 2],
}

impl Default for Marks {
    fn default() -> Marks {
        let pair = |open: &str, close: &str| [open.to_owned(), close.to_owned()];
        Marks { variable: pair("{{", "}}"), block: pair("{%", "%}"), comment: pair("{#", "#}") }
    }
}

impl From<Marks> for Delimiters {
    fn from(marks: Marks) -> Delimiters {
        let [variable_start, variable_end] = marks.variable.map(Cow::Owned);
        let [block_start, block_end] = marks.block.map(Cow::Owned);
        let [comment_start, comment_end] = marks.comment.map(Cow::Owned);
        Delimiters { block_start, block_end, variable_start, variable_end, comment_start, comment_end }
    }
}

impl Manifest {
    /// The templates that are rendered by themselves, each with what it sees.
    pub fn templates(&self) -> impl Iterator<Item = (&Spanned<String>, Sees)> {
        let of_paper = self.documents.iter().map(|document| &document.template).chain(&self.preview);
        let of_class = self.class.iter().map(|document| (&document.template, Sees::Class));
        let of_script = self.feedback.iter().map(|template| (template, Sees::Feedback));
        let of_marks = self.report.iter().map(|template| (template, Sees::Report));
        of_paper.map(|template| (template, Sees::Paper)).chain(of_class).chain(of_script).chain(of_marks)
    }

    /// Reads a manifest and holds it to the files of its folder.
    pub fn read(source: &Source, files: &BTreeMap<String, Source>) -> Result<Manifest, Vec<Diagnostic>> {
        let manifest: Manifest = toml::from_str(&source.text).map_err(|fault| vec![unread(source, &fault)])?;
        let faults: Vec<Diagnostic> = [manifest.marks_fault(source)]
            .into_iter()
            .flatten()
            .chain(manifest.document_faults(source, files))
            .collect();
        if faults.is_empty() { Ok(manifest) } else { Err(faults) }
    }

    /// Marks that cannot be told from one another, or that are too long.
    fn marks_fault(&self, source: &Source) -> Option<Diagnostic> {
        let Marks { variable, block, comment } = &self.delimiters;
        let unfit = [variable, block, comment].into_iter().flatten().find(|mark| mark.len() != 2);
        let message = match unfit {
            Some(mark) => format!("the mark `{mark}` has not two characters"),
            None if variable[0] == block[0] || block[0] == comment[0] || variable[0] == comment[0] => {
                "two kinds of code have the same opening mark".to_owned()
            }
            None => return None,
        };
        let start = source.text.find("[delimiters]").or(source.text.find("delimiters")).unwrap_or(0);
        let label = "the shipped formats have `{{`, `{%`, `{#` or `<<`, `<%`, `<#`";
        Some(Diagnostic::new(message, source, start..start + "[delimiters]".len(), label))
    }

    fn document_faults(&self, source: &Source, files: &BTreeMap<String, Source>) -> Vec<Diagnostic> {
        let names: Vec<&str> = files.keys().map(String::as_str).collect();
        let mut faults = Vec::new();
        let documents: Vec<&Document> = self.documents.iter().chain(&self.class).collect();
        for (index, Document { file, .. }) in documents.iter().enumerate() {
            let name = file.get_ref();
            let mut at_file = |message: String, label: &str| {
                faults.push(Diagnostic::new(message, source, file.span(), label));
            };
            if name.is_empty() || name.starts_with('.') || name.contains(['/', '\\', ':']) {
                at_file(
                    format!("`{name}` is not the name of a file"),
                    "a name without a folder, as `question-sheet.tex`",
                );
            }
            if documents[..index].iter().any(|earlier| earlier.file.get_ref() == name) {
                at_file(format!("two documents are called `{name}`"), "one would be written over the other");
            }
        }
        let templates = self.templates().map(|(template, _)| template);
        for template in templates.filter(|template| !files.contains_key(template.get_ref())) {
            let message = format!("there is no template `{}`", template.get_ref());
            let label = format!("the folder has {}", listed(&names));
            let fault = Diagnostic::new(message, source, template.span(), label);
            faults.push(fault.with_near(near(template.get_ref(), names.iter().copied())));
        }
        faults
    }
}

/// What is no manifest at all. The reader of TOML names what it found and then what it knows, between backticks.
fn unread(source: &Source, fault: &toml::de::Error) -> Diagnostic {
    let message =
        fault.message().replace("unknown field", "unknown key").replace("unknown variant", "unknown notation");
    let message = message.replace("missing field", "missing key");
    let message = message.lines().next().unwrap_or_default();
    let span = fault.span().unwrap_or(0..0);
    let help = "`templates/README.md` says what stands in a `format.toml`";
    if let Some((found, expected)) = of_another_kind(message) {
        let label = format!("expected {expected}");
        return Diagnostic::new(format!("{found} where it cannot stand"), source, span, label).with_help(help);
    }
    let (found, expected) = message.split_once(", ").unwrap_or((message, ""));
    let between = |text: &str| text.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    let (name, known) = (between(found), between(expected));
    let near = name.first().and_then(|name| near(name, known.iter().map(String::as_str)));
    let label = if expected.is_empty() { "not as a format has it" } else { expected };
    Diagnostic::new(found, source, span, label).with_help(help).with_near(near)
}
