//! The pages that students get back, in the formats asked for, and the report on the class.

use std::path::Path;

use super::super::failure::{Failure, warn};
use super::super::formats::question_marks;
use super::super::output::say;
use super::super::template_folder::own_templates;
use super::super::write::OutputFile;
use crate::expr::print::latex_lacks;
use crate::mark::report::{ClassReport, Feedback, MarkReport, marks_table, mistakes_table, students_table};
use crate::render::{Formats, RenderFault};

/// What `--feedback` calls no pages at all.
const NONE: &str = "none";

/// The format of the report.
const REPORT: &str = "html";

/// Formats that there are, and those of them that are asked for.
pub struct FeedbackAsked {
    formats: Formats,
    names: Vec<String>,
}

impl FeedbackAsked {
    /// The formats by their names, with a person's own templates in place of those of the same path.
    pub fn new(names: &[String], templates: Option<&Path>) -> Result<FeedbackAsked, Failure> {
        let formats = Formats::with(own_templates(templates)?)?;
        warn(formats.warnings());
        let mut asked: Vec<String> = Vec::new();
        for name in names.iter().map(|name| name.trim()).filter(|name| *name != NONE) {
            if !formats.list().any(|(known, _)| known == name) {
                if name == "pdf" {
                    let help = "ask for html and print it from a browser, or for latex and run `pdflatex` on it";
                    return Err(Failure::with_help("feedback is not printed as PDF", help));
                }
                let available = formats.list().map(|(known, _)| known.to_owned()).chain([NONE.to_owned()]).collect();
                return Err(RenderFault::UnknownFormat { format: name.to_owned(), available }.into());
            }
            if !asked.iter().any(|earlier| earlier == name) {
                asked.push(name.to_owned());
            }
        }
        Ok(FeedbackAsked { formats, names: asked })
    }

    /// The report on the class: a page, and its figures as tables.
    pub fn report(&self, class: &ClassReport) -> Result<Vec<OutputFile>, Failure> {
        let table =
            |name: &str, contents: String| OutputFile { name: name.to_owned(), contents: contents.into_bytes() };
        let mut files = vec![
            table("report.csv", students_table(class)),
            table("report-marks.csv", marks_table(class)),
            table("report-mistakes.csv", mistakes_table(class)),
        ];
        files.extend(self.formats.report(REPORT, class)?.map(OutputFile::from));
        Ok(files)
    }

    /// A page for each student in each format, in the folder `feedback`.
    pub fn pages(&self, report: &MarkReport) -> Result<Vec<OutputFile>, Failure> {
        let mut files = Vec::new();
        let students = if self.names.is_empty() { Vec::new() } else { Feedback::of(report) };
        if self.names.iter().any(|name| name == "latex") {
            let shown = students.iter().map(|feedback| feedback.shown.as_str());
            let lacked: Vec<&str> = shown.filter(|student| latex_lacks(student)).collect();
            if !lacked.is_empty() {
                say(&question_marks("the LaTeX", &lacked));
            }
        }
        for feedback in &students {
            for name in &self.names {
                let Some(page) = self.formats.feedback(name, feedback)? else {
                    return Err(Failure::with_help(
                        format!("the format `{name}` has no page of feedback"),
                        format!("name its template in `{name}/format.toml`: feedback = \"feedback.txt\""),
                    ));
                };
                let page = OutputFile::from(page);
                files.push(OutputFile { name: format!("feedback/{}", page.name), ..page });
            }
        }
        Ok(files)
    }
}
