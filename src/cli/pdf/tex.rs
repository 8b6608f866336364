//! LaTeX to PDF with a TeX engine.

use std::fs;
use std::panic::resume_unwind;
use std::path::Path;
use std::process::Command;
use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

use super::super::failure::Failure;
use super::super::write::OutputFile;
use super::scratch::Scratch;
use super::tex_fault::{OwnTemplates, fault};
use super::{documents, finished, machine, no_documents, run};
use crate::diagnostic::{Diagnostic, Source};
use crate::render::RenderedFile;

/// Pages are counted in the first run and printed in the second; columns of tables may ask for a third.
const MOST_RUNS: usize = 4;

/// A TeX engine and all that it needs for its work.
pub struct Press<'a> {
    /// The engine.
    pub program: &'a Path,
    /// Where it works.
    pub scratch: &'a Scratch,
    /// How long one run may take.
    pub limit: Duration,
    /// Where the teacher will find the documents.
    pub out: &'a Path,
    /// What the teacher can mend.
    pub own: &'a OwnTemplates,
}

impl Press<'_> {
    /// A PDF for each document of the format; the documents are set side by side.
    pub fn print(&self, files: &[RenderedFile]) -> Result<Vec<OutputFile>, Failure> {
        let papers = documents(files, ".tex");
        if papers.is_empty() {
            return Err(no_documents("latex", ".tex"));
        }
        for file in files {
            fs::write(self.scratch.folder().join(&file.name), &file.contents)?;
        }
        let outcomes = thread::scope(|scope| {
            let one = |(file, stem)| scope.spawn(move || self.print_one(file, stem));
            let threads: Vec<_> = papers.into_iter().map(one).collect();
            let joined = |thread: ScopedJoinHandle<'_, _>| thread.join().unwrap_or_else(|panic| resume_unwind(panic));
            threads.into_iter().map(joined).collect()
        });
        gathered(outcomes)
    }

    fn print_one(&self, file: &RenderedFile, stem: &str) -> Result<OutputFile, Failure> {
        let folder = self.scratch.folder();
        let engine = machine::name(self.program);
        let mut before = None;
        for _ in 0..MOST_RUNS {
            let (content, said) = run(self.program, self.command(&engine, file, stem), &file.name, self.limit)?;
            if !content {
                let source = Source::new(self.out.join(&file.name).display().to_string(), file.contents.as_str());
                return Err(fault(&said, &source, &engine, self.own));
            }
            let after = fs::read(folder.join(format!("{stem}.aux"))).ok();
            if before.as_ref() == Some(&after) {
                break;
            }
            before = Some(after);
        }
        let name = format!("{stem}.pdf");
        match finished(&folder.join(&name)) {
            Some(contents) => Ok(OutputFile { name, contents }),
            None => Err(Failure::with_help(
                format!("`{engine}` made no PDF of `{}`, and did not say why", file.name),
                "run it on the file yourself, or print with a browser instead: `CAROM_TEX=none`",
            )),
        }
    }

    fn command(&self, engine: &str, file: &RenderedFile, stem: &str) -> Command {
        let folder = self.scratch.folder();
        let mut tex = Command::new(self.program);
        tex.current_dir(folder);
        tex.args(["-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "-no-shell-escape"]);
        tex.arg(format!("-jobname={stem}"));
        tex.arg(format!(r"{}\input{{{}}}", without_the_time(engine), file.name));
        // What a template says reaches no file but those of this folder and TeX's own.
        tex.env("openin_any", "p").env("openout_any", "p").env("TEXMFOUTPUT", folder);
        // Each message in one line, however long.
        tex.env("max_print_line", "1000").env("error_line", "254").env("half_error_line", "238");
        // The time of printing is no part of a paper. `\today` is left alone: whoever writes it means it.
        if std::env::var_os("SOURCE_DATE_EPOCH").is_none() {
            tex.env("SOURCE_DATE_EPOCH", "0");
        }
        tex
    }
}

/// All papers, or the faults of all; one and the same fault of a template that several papers include is told once.
fn gathered(outcomes: Vec<Result<OutputFile, Failure>>) -> Result<Vec<OutputFile>, Failure> {
    let mut set = Vec::new();
    let mut faults: Vec<Diagnostic> = Vec::new();
    for outcome in outcomes {
        match outcome {
            Ok(file) => set.push(file),
            Err(Failure::Faults(found)) => {
                let line = |fault: &Diagnostic| fault.source.text.lines().nth(fault.line() - 1).map(str::to_owned);
                for fault in found {
                    if !faults.iter().any(|known| known.message == fault.message && line(known) == line(&fault)) {
                        faults.push(fault);
                    }
                }
            }
            Err(other) => return Err(other),
        }
    }
    if faults.is_empty() { Ok(set) } else { Err(Failure::Faults(faults)) }
}

/// What an engine must be told so that the same paper is the same file, at any time and in any folder.
fn without_the_time(engine: &str) -> &'static str {
    if engine.contains("lua") {
        // every entry of the PDF that may be left out, its time and number among them
        r"\pdfvariable suppressoptionalinfo 1023\relax"
    } else if engine.contains("xe") {
        r"\AtBeginDvi{\special{pdf:docinfo << /Creator (XeTeX) >>}}"
    } else {
        r"\pdfinfoomitdate=1 \pdftrailerid{}"
    }
}
