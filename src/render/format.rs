//! One format: its manifest and its compiled templates.

use std::collections::{BTreeMap, BTreeSet};

use tera::{Context, Tera};

use super::check::{Checked, check};
use super::engine::Templates;
use super::manifest::{Document, Manifest, Sees};
use super::page::{self, Wanted};
use super::{Notation, RenderFault, RenderedFile, feedback, plain_text, report};
use crate::diagnostic::{Diagnostic, Source, near};
use crate::mark::report::{ClassReport, Feedback};
use crate::paper::Paper;

/// A format whose templates have been read and whose names have been checked.
#[derive(Clone)]
pub(super) struct Format {
    name: String,
    manifest: Manifest,
    files: BTreeMap<String, Source>,
    tera: Tera,
    reached: BTreeSet<String>,
    wanted: Wanted,
}

impl std::fmt::Debug for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Format").field("name", &self.name).field("manifest", &self.manifest).finish_non_exhaustive()
    }
}

impl Format {
    /// The format in the folder `name`, from its manifest and its other files.
    pub fn load(name: &str, manifest: &Source, files: BTreeMap<String, Source>) -> Result<Format, Vec<Diagnostic>> {
        let manifest = Manifest::read(manifest, &files)?;
        let templates = Templates { folder: name, files: &files, marks: &manifest.delimiters };
        let tera = compile(&templates, &manifest)?;
        let documents = manifest.templates().map(|(template, sees)| (template.get_ref().as_str(), sees));
        let documents: Vec<(&str, Sees)> = documents.collect();
        let Checked { faults, used, reached } = check(&files, name, &documents, &manifest.delimiters);
        if !faults.is_empty() {
            return Err(faults);
        }
        let wanted = Wanted::new(used.as_ref());
        Ok(Format { name: name.to_owned(), manifest, files, tera, reached, wanted })
    }

    /// The sentence that its manifest says about it.
    pub fn about(&self) -> &str {
        &self.manifest.about
    }

    /// The files that no document comes to.
    pub fn unused(&self) -> impl Iterator<Item = &str> {
        self.files.keys().map(String::as_str).filter(|file| !self.reached.contains(*file))
    }

    /// The file that was probably meant by one that no document comes to.
    pub fn near_file(&self, file: &str) -> Option<&str> {
        near(file, self.reached.iter().map(String::as_str))
    }

    /// The names of the files that a paper and those of a class become.
    pub fn pages(&self) -> impl Iterator<Item = &str> {
        self.manifest.documents.iter().chain(&self.manifest.class).map(|document| document.file.get_ref().as_str())
    }

    /// Every document of a paper.
    pub fn render(&self, paper: &Paper) -> Result<Vec<RenderedFile>, RenderFault> {
        self.documents(&self.manifest.documents, &self.context(paper))
    }

    /// Every document of a class; none if the format has no documents for one.
    pub fn class(&self, papers: &[Paper]) -> Result<Vec<RenderedFile>, RenderFault> {
        self.documents(&self.manifest.class, &page::class(papers, self.manifest.notation, &self.wanted))
    }

    fn documents(&self, documents: &[Document], context: &Context) -> Result<Vec<RenderedFile>, RenderFault> {
        let each = documents.iter().map(|document| {
            let contents = self.fill(document.template.get_ref(), context, self.manifest.line_length)?;
            Ok(RenderedFile { name: document.file.get_ref().clone(), contents })
        });
        each.collect()
    }

    /// The page for a preview, its lines of this length if they have one at all; nothing if the format has no such page.
    pub fn preview(&self, paper: &Paper, line_length: usize) -> Result<Option<String>, RenderFault> {
        let Some(template) = &self.manifest.preview else { return Ok(None) };
        let line_length = self.manifest.line_length.map(|_| line_length);
        self.fill(template.get_ref(), &self.context(paper), line_length).map(Some)
    }

    /// The page that a student gets back, under the student's name; nothing if the format has no such page.
    pub fn feedback(&self, feedback: &Feedback) -> Result<Option<RenderedFile>, RenderFault> {
        let Some(template) = self.manifest.feedback.as_ref().map(|template| template.get_ref()) else {
            return Ok(None);
        };
        let context = feedback::page(feedback, self.manifest.notation, &self.wanted);
        let contents = self.fill(template, &context, self.manifest.line_length)?;
        Ok(Some(RenderedFile { name: format!("{}.{}", feedback.file, ending(template)), contents }))
    }

    /// The report on a class; nothing if the format has no such page.
    pub fn report(&self, class: &ClassReport) -> Result<Option<RenderedFile>, RenderFault> {
        let Some(template) = self.manifest.report.as_ref().map(|template| template.get_ref()) else {
            return Ok(None);
        };
        let context = report::page(class, self.manifest.notation, &self.wanted);
        let contents = self.fill(template, &context, self.manifest.line_length)?;
        Ok(Some(RenderedFile { name: format!("report.{}", ending(template)), contents }))
    }

    fn context(&self, paper: &Paper) -> Context {
        page::page(paper, self.manifest.notation, &self.wanted)
    }

    fn fill(&self, template: &str, context: &Context, line_length: Option<usize>) -> Result<String, RenderFault> {
        let path = format!("{}/{template}", self.name);
        let filled = self.tera.render(&path, context).map_err(|error| {
            let templates = Templates { folder: &self.name, files: &self.files, marks: &self.manifest.delimiters };
            RenderFault::Templates(templates.faults(&error, &path))
        })?;
        Ok(match self.manifest.notation {
            Notation::Unicode => plain_text::set(&filled, line_length),
            Notation::Latex | Notation::Html => filled,
        })
    }
}

/// The ending of a template's name, which its pages have too.
fn ending(template: &str) -> &str {
    template.rsplit_once('.').map_or("txt", |(_, ending)| ending)
}

/// Reads the templates of a folder; all plain words that they print are escaped for the notation.
fn compile(templates: &Templates, manifest: &Manifest) -> Result<Tera, Vec<Diagnostic>> {
    let named = |file: &str| format!("{}/{file}", templates.folder);
    let mut tera = Tera::new();
    let unfit = |error: tera::Error| templates.faults(&error, "format.toml");
    tera.set_delimiters(manifest.delimiters.clone().into()).map_err(unfit)?;
    // every name ends with nothing, so that no template escapes the escaping
    tera.autoescape_on([""]);
    tera.set_escape_fn(manifest.notation.escape());
    // an include names its neighbour as it is called in the folder
    tera.set_fallback_prefixes([named("")]).map_err(unfit)?;
    let texts = templates.files.iter().map(|(file, source)| (named(file), &*source.text));
    match tera.add_raw_templates(texts) {
        Ok(()) => Ok(tera),
        Err(error) => {
            // the engine stops at the first template that it cannot read; there may be more
            let alone = templates.files.iter().filter_map(|(file, source)| {
                let mut tera = Tera::new();
                tera.set_delimiters(manifest.delimiters.clone().into()).ok()?;
                let error = tera.add_raw_template(&named(file), &source.text).err()?;
                matches!(error.kind(), tera::ErrorKind::SyntaxError(_)).then(|| templates.faults(&error, &named(file)))
            });
            let unread: Vec<Diagnostic> = alone.flatten().collect();
            Err(if unread.is_empty() { templates.faults(&error, "format.toml") } else { unread })
        }
    }
}
