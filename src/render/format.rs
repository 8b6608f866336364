//! One format: its manifest and its compiled templates.

use std::collections::{BTreeMap, BTreeSet};

use tera::{Context, ErrorKind, Tera};

use super::manifest::Manifest;
use super::{RenderFault, RenderedFile, names, page};
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
        if let Some(document) = manifest.documents.iter().find(|document| !files.contains_key(&document.template)) {
            return Err(unfit(format!("there is no template `{}` in the folder", document.template)));
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
        let page = page::page(paper, self.manifest.notation);
        let context =
            Context::from_serialize(&page).map_err(|fault| template_fault(&self.path("format.toml"), &fault))?;
        self.manifest
            .documents
            .iter()
            .map(|document| {
                let path = self.path(&document.template);
                let contents = self.tera.render(&path, &context).map_err(|fault| template_fault(&path, &fault))?;
                Ok(RenderedFile { name: document.file.clone(), contents })
            })
            .collect()
    }

    /// Refuses a document that uses a name by itself which no page has, also where no page would come to it.
    ///
    /// Included templates are left to rendering: they may stand in a loop and use the names of the loop.
    fn check_documents(&self) -> Result<(), RenderFault> {
        let variables =
            |path: &str| self.tera.get_template_variables(path).map_err(|fault| template_fault(path, &fault));
        let documents: Vec<String> =
            self.manifest.documents.iter().map(|document| self.path(&document.template)).collect();
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
