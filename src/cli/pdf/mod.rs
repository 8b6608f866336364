//! PDF: printed from the LaTeX or the HTML with whatever this machine has.
//!
//! `pdf` is no folder of templates. A TeX engine makes it from the files of the format `latex`, or a browser from those
//! of the format `html`, so that a teacher's own templates count here as they do there.

mod browser;
mod machine;
mod package;
mod process;
mod repeatable;
mod scratch;
mod tex;
mod tex_fault;
mod tex_log;

use std::env;
use std::fs;
use std::io::Read;
use std::path::Path;
use std::time::Duration;

use super::failure::Failure;
use super::write::{OutputFile, no_scratch};
use crate::render::RenderedFile;

pub use machine::{Engine, Letters, engines, nothing};
pub use tex_fault::OwnTemplates;

impl Engine {
    /// The format of which it makes the pages.
    pub fn format(&self) -> &'static str {
        match self {
            Engine::Tex(_) => "latex",
            Engine::Browser(_) => "html",
        }
    }

    /// A PDF for each document among the files of its format, or for none.
    ///
    /// Faults point into the files as they are called in the folder `out`.
    pub fn print(&self, files: &[RenderedFile], out: &Path, own: &OwnTemplates) -> Result<Vec<OutputFile>, Failure> {
        let limit = time_limit()?;
        let scratch =
            scratch::Scratch::new().map_err(|error| no_scratch("no folder can be made to print in", &error))?;
        match self {
            Engine::Tex(program) => tex::Press { program, scratch: &scratch, limit, out, own }.print(files),
            Engine::Browser(program) => browser::print(program, files, &scratch, limit),
        }
    }
}

/// How long one run of an engine may take.
///
/// A paper takes a second or two, a class of thirty perhaps ten. But the first run of all may look through every font of
/// the machine, which takes a minute; whoever waits longer than two has been forgotten.
const TIME_LIMIT: Duration = Duration::from_secs(120);

/// For machines that are slower than that.
const TIME_LIMIT_VARIABLE: &str = "CAROM_PDF_SECONDS";

fn time_limit() -> Result<Duration, Failure> {
    let Some(value) = env::var_os(TIME_LIMIT_VARIABLE).filter(|value| !value.is_empty()) else {
        return Ok(TIME_LIMIT);
    };
    match value.to_str().and_then(|value| value.parse::<u32>().ok()).filter(|seconds| *seconds > 0) {
        Some(seconds) => Ok(Duration::from_secs(seconds.into())),
        None => Err(Failure::with_help(
            format!("`{TIME_LIMIT_VARIABLE}` is `{}`, which is no number of seconds", value.to_string_lossy()),
            format!("unset it: without it the limit is {} seconds", TIME_LIMIT.as_secs()),
        )),
    }
}

/// Runs an engine, which must come to an end by itself; what it said, and whether it was content.
fn run(program: &Path, command: std::process::Command, file: &str, limit: Duration) -> Result<(bool, String), Failure> {
    let engine = machine::name(program);
    match process::run(command, limit) {
        Ok((process::Ended::Well, said)) => Ok((true, said)),
        Ok((process::Ended::Badly, said)) => Ok((false, said)),
        Ok((process::Ended::TooLate, _)) => Err(Failure::with_help(
            format!("`{engine}` was stopped: it was still at work on `{file}` after {} s", limit.as_secs()),
            format!("if this machine is only slow, give it more seconds: `{TIME_LIMIT_VARIABLE}=600`"),
        )),
        Ok((process::Ended::TooMuch, _)) => Err(Failure::with_help(
            format!("`{engine}` was stopped: on `{file}` it would not stop printing messages"),
            "look in your templates for a loop without an end",
        )),
        Err(error) => Err(Failure::said(format!("`{}` cannot be run: {error}", program.display()))),
    }
}

/// No paper comes near this, and what goes beyond has come out of a loop.
const MOST_BYTES: u64 = 256 << 20;

/// The PDF that an engine has left at a path, if it is one, and whole.
fn finished(path: &Path) -> Option<Vec<u8>> {
    // A link would lead to somebody else's file.
    let data = fs::symlink_metadata(path).ok()?;
    if !data.is_file() || data.len() > MOST_BYTES {
        return None;
    }
    let mut pdf = Vec::with_capacity(data.len() as usize);
    fs::File::open(path).ok()?.take(MOST_BYTES).read_to_end(&mut pdf).ok()?;
    let end = &pdf[pdf.len().saturating_sub(1024)..];
    let whole = pdf.starts_with(b"%PDF-") && end.windows(5).any(|word| word == b"%%EOF");
    whole.then_some(pdf)
}

/// The files of a format that are documents, with the name that each has without its ending.
fn documents<'f>(files: &'f [RenderedFile], ending: &str) -> Vec<(&'f RenderedFile, &'f str)> {
    files.iter().filter_map(|file| Some((file, file.name.strip_suffix(ending)?))).collect()
}

/// That a format has no document from which this engine could make a PDF.
fn no_documents(format: &str, ending: &str) -> Failure {
    Failure::said(format!(
        "the format `{format}` has no document whose name ends in `{ending}`: there is no PDF to make"
    ))
}
