//! Banks: all questions of a folder, or those that are shipped.

use std::io;
use std::path::{Path, PathBuf};

use super::question::Question;
use super::{read_question, shipped};
use crate::diagnostic::{Diagnostic, Source, near};

/// Questions that have been checked, sorted by id.
#[derive(Clone, Debug, Default)]
pub struct Bank {
    /// The questions, sorted by id.
    pub questions: Vec<Question>,
}

impl Bank {
    /// The bank inside the binary.
    ///
    /// # Errors
    ///
    /// None that a test has not found before; kept as they are for the caller to print.
    pub fn shipped() -> Result<Bank, Vec<Diagnostic>> {
        let files = shipped().map(|(id, text)| (id.to_string(), Source::new(format!("question_bank/{id}.toml"), text)));
        Bank::read(files)
    }

    /// Every `.toml` file in a folder and the folders in it. An id is the path within the folder without `.toml`.
    ///
    /// # Errors
    ///
    /// Every fault of every file, those that cannot be opened among them.
    pub fn read_folder(folder: &Path) -> Result<Bank, Vec<Diagnostic>> {
        let unreadable = |path: &Path, error: &io::Error| {
            let source = Source::new(path.display().to_string(), "");
            Diagnostic::new(format!("`{}` cannot be read: {error}", path.display()), &source, 0..0, "")
        };
        let files = question_files(folder).map_err(|error| vec![unreadable(folder, &error)])?;
        if files.is_empty() {
            let source = Source::new(folder.display().to_string(), "");
            let message = format!("no questions in `{}`", folder.display());
            return Err(vec![Diagnostic::new(message, &source, 0..0, "").with_help("a question is a file `….toml`")]);
        }
        let mut faults = Vec::new();
        let mut sources = Vec::new();
        for (id, path) in files {
            match std::fs::read_to_string(&path) {
                Ok(text) => sources.push((id, Source::new(path.display().to_string(), text))),
                Err(error) => faults.push(unreadable(&path, &error)),
            }
        }
        match Bank::read(sources) {
            Ok(bank) if faults.is_empty() => Ok(bank),
            Ok(_) => Err(faults),
            Err(more) => Err(faults.into_iter().chain(more).collect()),
        }
    }

    /// Files with their ids.
    fn read(files: impl IntoIterator<Item = (String, Source)>) -> Result<Bank, Vec<Diagnostic>> {
        let (mut questions, mut faults) = (Vec::new(), Vec::new());
        for (id, source) in files {
            match read_question(&id, &source) {
                Ok(question) => questions.push(question),
                Err(more) => faults.extend(more),
            }
        }
        questions.sort_by(|a: &Question, b: &Question| a.id.cmp(&b.id));
        if faults.is_empty() { Ok(Bank { questions }) } else { Err(faults) }
    }

    /// The question with an id, or with the exercise that it mirrors (`5C-2`) if only one does.
    ///
    /// # Errors
    ///
    /// The nearest id, if there is a near one.
    pub fn find(&self, id: &str) -> Result<&Question, Option<&str>> {
        if let Some(question) = self.questions.iter().find(|question| question.id == id) {
            return Ok(question);
        }
        let mut mirrors = self.questions.iter().filter(|question| question.mirrors.as_deref() == Some(id));
        match (mirrors.next(), mirrors.next()) {
            (Some(question), None) => Ok(question),
            _ => Err(near(id, self.questions.iter().map(|question| question.id.as_str()))),
        }
    }
}

/// Id and path of every question file in a folder and the folders in it, sorted by id.
pub(crate) fn question_files(folder: &Path) -> io::Result<Vec<(String, PathBuf)>> {
    let mut found = Vec::new();
    collect(folder, "", &mut found)?;
    found.sort();
    Ok(found)
}

fn collect(folder: &Path, prefix: &str, found: &mut Vec<(String, PathBuf)>) -> io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let kind = entry.file_type()?;
        if kind.is_dir() {
            collect(&entry.path(), &format!("{prefix}{name}/"), found)?;
        } else if let Some(stem) = name.strip_suffix(".toml") {
            found.push((format!("{prefix}{stem}"), entry.path()));
        }
    }
    Ok(())
}
