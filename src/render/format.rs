//! One format: its manifest and its compiled templates.

use std::collections::{BTreeMap, BTreeSet};

use tera::{Context, ErrorKind, Tera};

use super::manifest::Manifest;
use super::{Notation, RenderFault, RenderedFile, names, page, plain_text};
use crate::paper::Paper;

/// A format whose templates have been read and whose names have been checked.
#[derive(Clone)]
pub(super) struct Format {
    name: String,
    manifest: Manifest,
    tera: Tera,
}

impl std::fmt::Debug for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Format").field("name", &self.name).field("manifest", &self.manifest).finish_non_exhaustive()
    }
}

impl Format {
    /// The format in the folder `name`, from the files in it.
    pub fn load(name: &str, mut files: BTreeMap<String, String>) -> Result<Format, RenderFault> {
        let Some(text) = files.remove("format.toml") else {
            return Err(RenderFault::NoManifest { format: name.to_owned() });
        };
        let unfit = |message: String| RenderFault::Manifest { file: format!("{name}/format.toml"), message };
        let manifest = Manifest::read(&text).map_err(unfit)?;
        if let Some(template) = manifest.templates().find(|template| !files.contains_key(*template)) {
            return Err(unfit(format!("there is no template `{template}` in the folder")));
        }
        let tera = compile(name, &manifest, &files, unfit)?;
        for (file, template) in &files {
            names::check(&format!("{name}/{file}"), template, &manifest.delimiters)?;
        }
        let format = Format { name: name.to_owned(), manifest, tera };
        format.check_documents()?;
        Ok(format)
    }

    /// The sentence that its manifest says about it.
    pub fn about(&self) -> &str {
        &self.manifest.about
    }

    /// Every document of a paper.
    pub fn render(&self, paper: &Paper) -> Result<Vec<RenderedFile>, RenderFault> {
        let context = self.context(paper)?;
        self.manifest
            .documents
            .iter()
            .map(|document| {
                let contents = self.fill(&document.template, &context, self.manifest.line_length)?;
                Ok(RenderedFile { name: document.file.clone(), contents })
            })
            .collect()
    }

    /// The page for a preview, its lines of this length if they have one at all; nothing if the format has no such page.
    pub fn preview(&self, paper: &Paper, line_length: usize) -> Result<Option<String>, RenderFault> {
        let Some(template) = &self.manifest.preview else { return Ok(None) };
        let line_length = self.manifest.line_length.map(|_| line_length);
        self.fill(template, &self.context(paper)?, line_length).map(Some)
    }

    fn context(&self, paper: &Paper) -> Result<Context, RenderFault> {
        let page = page::page(paper, self.manifest.notation);
        Context::from_serialize(&page).map_err(|fault| template_fault(&self.path("format.toml"), &fault))
    }

    fn fill(&self, template: &str, context: &Context, line_length: Option<usize>) -> Result<String, RenderFault> {
        let path = self.path(template);
        let filled = self.tera.render(&path, context).map_err(|fault| template_fault(&path, &fault))?;
        Ok(match self.manifest.notation {
            Notation::Unicode => plain_text::set(&filled, line_length),
            Notation::Latex | Notation::Html => filled,
        })
    }

    /// Refuses a document that uses a name by itself which no page has, also where no page would come to it.
    ///
    /// Included templates are left to rendering: they may stand in a loop and use the names of the loop.
    fn check_documents(&self) -> Result<(), RenderFault> {
        let variables =
            |path: &str| self.tera.get_template_variables(path).map_err(|fault| template_fault(path, &fault));
        let documents: Vec<String> = self.manifest.templates().map(|template| self.path(template)).collect();
        let mut of_included = BTreeSet::new();
        for path in self.tera.get_template_names().filter(|path| !documents.iter().any(|document| document == path)) {
            of_included.extend(variables(path)?);
        }
        for document in &documents {
            let mut unknown = variables(document)?;
            unknown.retain(|name| !names::is_of_page(name) && !of_included.contains(name));
            if let Some(name) = unknown.into_iter().min() {
                return Err(names::unknown(document, "", name));
            }
        }
        Ok(())
    }

    fn path(&self, file: &str) -> String {
        format!("{}/{file}", self.name)
    }
}

/// Reads the templates of a folder; all plain words that they print are escaped for the notation.
fn compile(
    name: &str,
    manifest: &Manifest,
    files: &BTreeMap<String, String>,
    unfit: impl Fn(String) -> RenderFault,
) -> Result<Tera, RenderFault> {
    let mut tera = Tera::new();
    tera.set_delimiters(manifest.delimiters.clone().into()).map_err(|fault| unfit(message(&fault)))?;
    // every name ends with nothing, so that no template escapes the escaping
    tera.autoescape_on([""]);
    tera.set_escape_fn(manifest.notation.escape());
    // an include names its neighbour as it is called in the folder
    tera.set_fallback_prefixes([format!("{name}/")]).map_err(|fault| unfit(message(&fault)))?;
    tera.add_raw_templates(files.iter().map(|(file, text)| (format!("{name}/{file}"), text.as_str())))
        .map_err(|fault| template_fault(name, &fault))?;
    Ok(tera)
}

/// The fault of a template: where the engine knows of one that was included, it is that one.
fn template_fault(path: &str, fault: &tera::Error) -> RenderFault {
    let file = match fault.kind() {
        ErrorKind::SyntaxError(report) | ErrorKind::RenderingError(report) => report.filename(),
        _ => path,
    };
    RenderFault::Template { file: file.to_owned(), message: message(fault) }
}

/// What the engine says, without the word `error` that our own report begins with.
fn message(fault: &tera::Error) -> String {
    let text = fault.to_string();
    text.strip_prefix("error: ").unwrap_or(&text).trim_end().to_owned()
}
