//! The formats that a person asks for, PDF among them, and a paper in each of them.

use std::path::Path;

use super::failure::{Failure, warn};
use super::output::say;
use super::pdf::{self, Engine, OwnTemplates};
use super::template_folder::own_templates;
use super::write::OutputFile;
use crate::paper::Paper;
use crate::render::{Formats, RenderFault, RenderedFile};

/// What `--format` calls the pages that are made of the LaTeX or the HTML.
const PDF: &str = "pdf";

/// Formats that there are, and those of them that are asked for.
pub struct FormatsAsked {
    formats: Formats,
    own: OwnTemplates,
    /// Folders of templates, without repeats.
    names: Vec<String>,
    pdf: bool,
}

/// What is to be printed.
#[derive(Clone, Copy)]
pub enum Work<'p> {
    /// A sheet.
    Sheet(&'p Paper),
    /// The sheets of a class, all in the same files.
    Class(&'p [Paper]),
}

/// A paper in the formats asked for.
pub struct Printed {
    /// What there is to be written.
    pub files: Vec<OutputFile>,
    /// Why the PDF is not among it.
    pub missing: Option<Failure>,
}

impl FormatsAsked {
    /// The formats by their names, with a person's own templates in place of those of the same path.
    pub fn new(names: &[String], templates: Option<&Path>) -> Result<FormatsAsked, Failure> {
        let own = match templates {
            Some(folder) => OwnTemplates { folder: folder.to_owned(), files: own_templates(templates)? },
            None => OwnTemplates::default(),
        };
        let formats = Formats::with(own.files.iter().cloned())?;
        warn(formats.warnings());
        let there_are: Vec<&str> = formats.list().map(|(name, _)| name).collect();
        if there_are.contains(&PDF) {
            return Err(Failure::with_help(
                "a format of your own is called `pdf`, which is the name of the pages made of the LaTeX or the HTML",
                "give its folder another name",
            ));
        }
        let mut asked: Vec<String> = Vec::new();
        for name in names.iter().map(|name| name.trim()) {
            if name != PDF && !there_are.contains(&name) {
                let mut available: Vec<String> = there_are.iter().copied().chain([PDF]).map(str::to_owned).collect();
                available.sort();
                return Err(RenderFault::UnknownFormat { format: name.to_owned(), available }.into());
            }
            if !asked.iter().any(|earlier| earlier == name) {
                asked.push(name.to_owned());
            }
        }
        let pdf = asked.iter().any(|name| name == PDF);
        asked.retain(|name| name != PDF);
        Ok(FormatsAsked { formats, own, names: asked, pdf })
    }

    /// The names that pages of any format have, of a sheet and of a class.
    pub fn pages(&self) -> Vec<String> {
        self.formats.pages().map(str::to_owned).collect()
    }

    /// The files of a work in the formats asked for that are folders of templates.
    pub fn render(&self, work: Work) -> Result<Vec<OutputFile>, Failure> {
        let mut files = Vec::new();
        for name in &self.names {
            files.extend(self.rendered(name, work)?.into_iter().map(OutputFile::from));
        }
        Ok(files)
    }

    fn rendered(&self, format: &str, work: Work) -> Result<Vec<RenderedFile>, Failure> {
        match work {
            Work::Sheet(paper) => Ok(self.formats.render(format, paper)?),
            Work::Class(papers) => self.formats.class(format, papers)?.ok_or_else(|| {
                let message = format!("the format `{format}` has no documents for a class");
                let help = format!("name them in `{format}/format.toml`: [[class]], with `file` and `template`");
                Failure::with_help(message, help)
            }),
        }
    }

    /// The files of a work, as they will be called in the folder `out`.
    ///
    /// A template that is at fault is a failure. That PDF cannot be made is none yet: the other files are whole.
    pub fn print(&self, work: Work, out: &Path) -> Result<Printed, Failure> {
        let mut files = self.render(work)?;
        if !self.pdf {
            return Ok(Printed { files, missing: None });
        }
        let missing = match pdf::engine() {
            Ok(Some(engine)) => self.print_with(&engine, work, out, &mut files)?,
            unfound => {
                self.instead("html", work, &mut files)?;
                Some(unfound.err().unwrap_or_else(pdf::nothing))
            }
        };
        Ok(Printed { files, missing })
    }

    fn print_with(
        &self,
        engine: &Engine,
        work: Work,
        out: &Path,
        files: &mut Vec<OutputFile>,
    ) -> Result<Option<Failure>, Failure> {
        say(&format!("PDF by `{}`, {}", engine.name(), engine.program().display()));
        let sources = self.rendered(engine.format(), work)?;
        match engine.print(&sources, out, &self.own) {
            Ok(pdf) => {
                files.extend(pdf);
                Ok(None)
            }
            Err(failure) => {
                self.instead(engine.format(), work, files)?;
                Ok(Some(failure))
            }
        }
    }

    /// Where PDF alone was asked for and there is none: that of which it would have been made, to be looked at or
    /// printed by hand.
    fn instead(&self, format: &str, work: Work, files: &mut Vec<OutputFile>) -> Result<(), Failure> {
        if !self.names.is_empty() {
            return Ok(());
        }
        files.extend(self.rendered(format, work)?.into_iter().map(OutputFile::from));
        say(match format {
            "html" => "the HTML is written instead: open it in any browser and print it from there",
            _ => "the LaTeX is written instead, so that you can look at it",
        });
        Ok(())
    }
}
