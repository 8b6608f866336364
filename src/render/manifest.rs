//! The manifest of a format: `format.toml` in its folder.

use std::borrow::Cow;

use serde::Deserialize;
use tera::Delimiters;

use super::Notation;

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
    pub preview: Option<String>,
    /// The files that a paper becomes.
    pub documents: Vec<Document>,
}

/// One file that a paper becomes.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document {
    /// Its name.
    pub file: String,
    /// The template that makes it.
    pub template: String,
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
    /// The templates that are rendered by themselves.
    pub fn templates(&self) -> impl Iterator<Item = &String> {
        self.documents.iter().map(|document| &document.template).chain(&self.preview)
    }

    /// Reads a manifest; the message says what is wrong with it.
    pub fn read(text: &str) -> Result<Manifest, String> {
        let manifest: Manifest = toml::from_str(text).map_err(|fault| fault.to_string().trim_end().to_owned())?;
        for (index, document) in manifest.documents.iter().enumerate() {
            let file = &document.file;
            if file.is_empty() || file.starts_with('.') || file.contains(['/', '\\', ':']) {
                return Err(format!("`{file}` is not the name of a file without a folder"));
            }
            if manifest.documents[..index].iter().any(|earlier| earlier.file == *file) {
                return Err(format!("two documents are called `{file}`"));
            }
        }
        Ok(manifest)
    }
}
