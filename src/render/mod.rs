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
//! page would not have come to it, is a fault shown in the teacher's file, and then there are no files at all.
//! Templates hold words and layout: every formula arrives printed in the notation of the format, so they do no
//! arithmetic. The names they may use are listed in `templates/README.md`. The room never touches the disk.

mod chart;
mod check;
mod code;
mod engine;
mod expression;
mod fault;
mod feedback;
mod format;
mod lookup;
mod manifest;
mod names;
mod notation;
mod page;
mod plain_text;
mod report;
mod scope;
mod shipped;

use std::collections::BTreeMap;

pub use fault::RenderFault;
pub use notation::Notation;

use crate::diagnostic::{Diagnostic, Severity, Source, near};
use crate::mark::report::{ClassReport, Feedback};
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
    /// The path by which its owner knows it, for faults: `my-templates/latex/mark-scheme.tex`.
    pub place: String,
    /// What stands in it.
    pub contents: String,
}

/// The formats in which papers can be rendered.
#[derive(Clone, Debug)]
pub struct Formats {
    formats: BTreeMap<String, Format>,
    warnings: Vec<Diagnostic>,
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
    /// Any file called `README.md` is left alone. Of files that nothing uses [`Formats::warnings`] tells.
    pub fn with(own: impl IntoIterator<Item = TemplateFile>) -> Result<Formats, RenderFault> {
        let mut folders: BTreeMap<String, BTreeMap<String, Source>> = BTreeMap::new();
        for (path, contents) in shipped::FILES {
            if let Some((folder, file)) = path.split_once('/') {
                let source = Source::new(format!("shipped {path}"), *contents);
                folders.entry(folder.to_owned()).or_default().insert(file.to_owned(), source);
            }
        }
        let mut owned = Vec::new();
        for TemplateFile { path, place, contents } in own {
            if path == "README.md" || path.ends_with("/README.md") {
                continue;
            }
            owned.push((path.clone(), place.clone()));
            if let Some((folder, file)) = path.split_once('/') {
                folders.entry(folder.to_owned()).or_default().insert(file.to_owned(), Source::new(place, contents));
            }
        }
        let mut formats = BTreeMap::new();
        let mut faults = Vec::new();
        for (name, mut files) in folders {
            let loaded = match files.remove("format.toml") {
                Some(manifest) => Format::load(&name, &manifest, files),
                None => Err(files.values().next().map(|file| no_format(&name, file)).into_iter().collect()),
            };
            match loaded {
                Ok(format) => drop(formats.insert(name, format)),
                Err(found) => faults.extend(found),
            }
        }
        if !faults.is_empty() {
            return Err(RenderFault::Templates(faults));
        }
        let mut formats = Formats { formats, warnings: Vec::new() };
        formats.warnings = owned.iter().filter_map(|(path, place)| formats.unused(path, place)).collect();
        Ok(formats)
    }

    /// Files of a teacher's own that nothing uses: a name misspelt, most likely.
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }

    /// The warning about an own file, if nothing uses it.
    fn unused(&self, path: &str, place: &str) -> Option<Diagnostic> {
        let warning = |message: String, help: String| {
            let fault = Diagnostic::new(message, &Source::new(place, ""), 0..0, "").with_help(help);
            Some(Diagnostic { severity: Severity::Warning, ..fault })
        };
        let Some((folder, file)) = path.split_once('/') else {
            let folder = self.formats.iter().find(|(_, format)| format.near_file(path).is_some());
            let folder = folder.map_or("latex", |(name, _)| name);
            let message = format!("nothing uses `{path}`: it is in the folder of no format");
            return warning(message, format!("put it into a folder named after its format: `{folder}/{path}`"));
        };
        let format = self.formats.get(folder)?;
        format.unused().find(|unused| *unused == file)?;
        let help = match format.near_file(file) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "a file is used if a document of `format.toml` names it or a template includes it".to_owned(),
        };
        warning(format!("nothing uses `{path}`"), help)
    }

    /// The formats by name, with the sentence that each says about itself.
    pub fn list(&self) -> impl Iterator<Item = (&str, &str)> {
        self.formats.iter().map(|(name, format)| (name.as_str(), format.about()))
    }

    /// The names of the files that papers become, in all formats.
    pub fn pages(&self) -> impl Iterator<Item = &str> {
        self.formats.values().flat_map(Format::pages)
    }

    /// The files of a paper in one format, in the order in which its manifest lists them.
    pub fn render(&self, format: &str, paper: &Paper) -> Result<Vec<RenderedFile>, RenderFault> {
        self.named(format)?.render(paper)
    }

    /// The files of a class in one format: in each of them the papers of all students, one after another. `None` if the
    /// format's manifest names no documents for a class.
    pub fn class(&self, format: &str, papers: &[Paper]) -> Result<Option<Vec<RenderedFile>>, RenderFault> {
        let files = self.named(format)?.class(papers)?;
        Ok(Some(files).filter(|files| !files.is_empty()))
    }

    /// The one page that a preview shows of a paper, plain text in lines of `line_length`; `None` if the format's
    /// manifest names no template for it.
    pub fn preview(&self, format: &str, paper: &Paper, line_length: usize) -> Result<Option<String>, RenderFault> {
        self.named(format)?.preview(paper, line_length)
    }

    /// The page that a student gets back; `None` if the format's manifest names no template for it.
    pub fn feedback(&self, format: &str, feedback: &Feedback) -> Result<Option<RenderedFile>, RenderFault> {
        self.named(format)?.feedback(feedback)
    }

    /// The report on a class; `None` if the format's manifest names no template for it.
    pub fn report(&self, format: &str, class: &ClassReport) -> Result<Option<RenderedFile>, RenderFault> {
        self.named(format)?.report(class)
    }

    fn named(&self, format: &str) -> Result<&Format, RenderFault> {
        self.formats.get(format).ok_or_else(|| RenderFault::UnknownFormat {
            format: format.to_owned(),
            available: self.formats.keys().cloned().collect(),
        })
    }
}

/// A folder that is no format, shown at one of its files.
fn no_format(folder: &str, file: &Source) -> Diagnostic {
    let shipped = shipped::FILES.iter().filter_map(|(path, _)| Some(path.split_once('/')?.0));
    let help = match near(folder, shipped) {
        Some(name) => format!("did you mean the folder `{name}`?"),
        None => "for a new format copy the `format.toml` of a shipped one".to_owned(),
    };
    let message = format!("`{folder}` is no format: there is no `format.toml` in the folder");
    Diagnostic::new(message, &Source::new(file.file.clone(), ""), 0..0, "").with_help(help)
}
