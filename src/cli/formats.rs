//! The formats that a person asks for, PDF among them, and a paper in each of them.

use std::path::Path;

use super::failure::{Failure, warn};
use super::output::{listed, say};
use super::pdf::{self, Engine, Letters, OwnTemplates};
use super::template_folder::own_templates;
use super::write::OutputFile;
use crate::expr::print::{latex_lacks, words_unicode};
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

impl<'p> Work<'p> {
    /// The names and other words of its pages' heads that LaTeX cannot print with its own fonts, without repeats.
    fn lacked_by_latex(self) -> Vec<&'p str> {
        let papers = match self {
            Work::Sheet(paper) => std::slice::from_ref(paper),
            Work::Class(papers) => papers,
        };
        let mut lacked = Vec::new();
        for words in papers.iter().flat_map(|paper| [&paper.student, &paper.title, &paper.school, &paper.date]) {
            if latex_lacks(words) && !lacked.contains(&words.as_str()) {
                lacked.push(words.as_str());
            }
        }
        lacked
    }
}

/// That some of the words stand in question marks, and what to do.
pub fn question_marks(place: &str, lacked: &[&str]) -> String {
    let (names, verb) = (first_of(lacked), if lacked.len() == 1 { "has" } else { "have" });
    format!(
        "warning: {names} {verb} letters that LaTeX's own fonts lack: in {place} each is a `?`; the HTML has \
         them all, and Chrome, Chromium or Edge prints it"
    )
}

/// The first few of some names: of a class that would be too many for a line.
fn first_of(names: &[&str]) -> String {
    const TOLD: usize = 5;
    let told =
        listed(names.iter().take(TOLD).map(|name| words_unicode(name)).collect::<Vec<_>>().iter().map(String::as_str));
    match names.len().saturating_sub(TOLD) {
        0 => told,
        more => format!("{told} and {more} more"),
    }
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

    /// Says what the folders of single students will lack: a PDF is made once, of the whole class.
    pub fn has_for_each_student(&self) -> Result<(), Failure> {
        match (self.pdf, self.names.as_slice()) {
            (true, []) => Err(Failure::with_help(
                "the PDF is of the whole class, so `--per-student` has nothing for the folder of a student",
                "add `html`, as in `--format html,pdf`, or leave out `--per-student`",
            )),
            (true, names) => {
                let names = listed(names.iter().map(String::as_str));
                say(&format!("the PDF is of the whole class; the folder of each student has {names}"));
                Ok(())
            }
            (false, _) => Ok(()),
        }
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
        let lacked = work.lacked_by_latex();
        if !lacked.is_empty() && self.names.iter().any(|name| name == "latex") {
            say(&question_marks("the LaTeX", &lacked));
        }
        if !self.pdf {
            return Ok(Printed { files, missing: None });
        }
        // A teacher's own templates for LaTeX are not passed over for the sake of a name.
        let others = !lacked.is_empty() && !self.own.files.iter().any(|file| file.path.starts_with("latex/"));
        let missing = match pdf::engines(if others { Letters::Others } else { Letters::OfTex }) {
            Ok(engines) if !engines.is_empty() => self.print_with(&engines, work, &lacked, out, &mut files)?,
            unfound => {
                self.instead("html", work, &mut files)?;
                Some(unfound.err().unwrap_or_else(pdf::nothing))
            }
        };
        Ok(Printed { files, missing })
    }

    /// Prints with the first of the engines that can.
    fn print_with(
        &self,
        engines: &[Engine],
        work: Work,
        lacked: &[&str],
        out: &Path,
        files: &mut Vec<OutputFile>,
    ) -> Result<Option<Failure>, Failure> {
        let mut last = None;
        for (at, engine) in engines.iter().enumerate() {
            let format = engine.format();
            say(&format!("PDF by `{}`, {}", engine.name(), engine.program().display()));
            let sources = self.rendered(format, work)?;
            match engine.print(&sources, out, &self.own) {
                Ok(pdf) => {
                    match (engine, lacked) {
                        (_, []) => {}
                        (Engine::Tex(_), _) => say(&question_marks("the PDF", lacked)),
                        (Engine::Browser(_), _) => say(&format!(
                            "{} in the letters that this machine has: look whether they are all there",
                            first_of(lacked)
                        )),
                    }
                    files.extend(pdf);
                    return Ok(None);
                }
                // The letters are worth a try; that it failed does not cost the PDF.
                Err(_) if at + 1 < engines.len() => say(&format!("`{}` made none", engine.name())),
                Err(failure) => last = Some((format, failure)),
            }
        }
        let Some((format, failure)) = last else { return Ok(None) };
        self.instead(format, work, files)?;
        Ok(Some(failure))
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
