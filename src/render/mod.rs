//! Rendering: a [`Paper`] becomes files, by the templates of a format.
//!
//! A format is a folder, and nothing else knows of it:
//!
//! ```text
//! templates/latex/format.toml           its notation, delimiters and documents
//! templates/latex/question-sheet.tex    one template a document
//! templates/latex/mark-scheme.tex
//! templates/latex/preamble.tex          whatever the documents include
//! ```
//!
//! To add a format, add a folder to `templates/`: every file of it is inside the binary once that is built.
//!
//! A file of a teacher's own folder takes the place of the shipped one of the same path; the others stay.
//!
//! Everything is rendered in memory. A name that a template asks for and that no page has, even where the
//! page would not have come to it, is a fault, and then there are no files at all.
//! Templates hold words and layout: every formula arrives printed in the notation of the format, so they do no
//! arithmetic. The names they may use are listed in `templates/README.md`. The room never touches the disk.

mod fault;
mod format;
mod manifest;
mod names;
mod notation;
mod page;
mod plain_text;
mod shipped;

use std::collections::BTreeMap;

pub use fault::RenderFault;
pub use notation::Notation;

use crate::paper::Paper;
use format::Format;

/// A file ready to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RenderedFile {
    /// Its name, without a folder: `mark-scheme.tex`.
    pub name: String,
    /// What stands in it.
    pub contents: String,
}

/// A file of a folder of formats: a manifest or a template.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TemplateFile {
    /// Path from the folder of formats, with `/` between its parts: `latex/mark-scheme.tex`.
    pub path: String,
    /// What stands in it.
    pub contents: String,
}

/// The formats in which papers can be rendered.
#[derive(Clone, Debug)]
pub struct Formats {
    formats: BTreeMap<String, Format>,
}

impl Formats {
    /// The formats inside the binary: `html`, `latex` and `text`.
    ///
    /// ```
    /// use carom::paper::Paper;
    /// use carom::render::Formats;
    ///
    /// let paper = Paper {
    ///     title: "Oblique impact & restitution".into(),
    ///     seed: Some(7),
    ///     ..Paper::default()
    /// };
    /// let files = Formats::shipped()?.render("latex", &paper)?;
    /// assert_eq!(files[0].name, "question-sheet.tex");
    /// assert!(files[0].contents.contains(r"Oblique impact \& restitution"));
    /// # Ok::<(), carom::render::RenderFault>(())
    /// ```
    pub fn shipped() -> Result<Formats, RenderFault> {
        Formats::with([])
    }

    /// The shipped formats with a teacher's files in place of those of the same path, and with new ones.
    ///
    /// Files outside a format's folder, and any called `README.md`, are left alone.
    pub fn with(own: impl IntoIterator<Item = TemplateFile>) -> Result<Formats, RenderFault> {
        let mut folders: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
        let shipped = shipped::FILES.iter().map(|(path, contents)| (path.to_string(), contents.to_string()));
        for (path, contents) in shipped.chain(own.into_iter().map(|file| (file.path, file.contents))) {
            match path.split_once('/') {
                Some((folder, file)) if !path.ends_with("/README.md") => {
                    folders.entry(folder.to_owned()).or_default().insert(file.to_owned(), contents);
                }
                _ => {}
            }
        }
        let formats = folders
            .into_iter()
            .map(|(name, files)| Ok((name.clone(), Format::load(&name, files)?)))
            .collect::<Result<_, RenderFault>>()?;
        Ok(Formats { formats })
    }

    /// The formats by name, with the sentence that each says about itself.
    pub fn list(&self) -> impl Iterator<Item = (&str, &str)> {
        self.formats.iter().map(|(name, format)| (name.as_str(), format.about()))
    }

    /// The files of a paper in one format, in the order in which its manifest lists them.
    pub fn render(&self, format: &str, paper: &Paper) -> Result<Vec<RenderedFile>, RenderFault> {
        self.named(format)?.render(paper)
    }

    /// The one page that a preview shows of a paper, plain text in lines of `line_length`; `None` if the format's
    /// manifest names no template for it.
    pub fn preview(&self, format: &str, paper: &Paper, line_length: usize) -> Result<Option<String>, RenderFault> {
        self.named(format)?.preview(paper, line_length)
    }

    fn named(&self, format: &str) -> Result<&Format, RenderFault> {
        self.formats.get(format).ok_or_else(|| RenderFault::UnknownFormat {
            format: format.to_owned(),
            available: self.formats.keys().cloned().collect(),
        })
    }
}
