//! Banks: all questions of a folder, or those that are shipped.

use std::io;
use std::path::{Path, PathBuf};

use super::question::Question;
use super::{read_question, shipped};
use crate::diagnostic::{Diagnostic, Source, near, why_unread};

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
        let Files { sources, unreadable } = read_files(folder)?;
        match Bank::read(sources) {
            Ok(bank) if unreadable.is_empty() => Ok(bank),
            Ok(_) => Err(unreadable),
            Err(more) => Err(unreadable.into_iter().chain(more).collect()),
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

/// The files of a bank.
pub(super) struct Files {
    /// By their ids.
    pub sources: Vec<(String, Source)>,
    /// A fault for each that cannot be read.
    pub unreadable: Vec<Diagnostic>,
}

/// Reads the files of a bank.
///
/// # Errors
///
/// A fault if there is no such folder, or no question in it.
pub(super) fn read_files(folder: &Path) -> Result<Files, Vec<Diagnostic>> {
    let shown = folder.display();
    let nowhere = |message: String, help: String| {
        vec![Diagnostic::new(message, &Source::new(shown.to_string(), ""), 0..0, "").with_help(help)]
    };
    if folder.exists() && !folder.is_dir() {
        let message = format!("`{shown}` is a file, and a bank is a folder");
        let is_question = folder.extension().is_some_and(|ending| ending == "toml");
        let look = format!(", or look at this one question: `carom preview {shown}`");
        let help = format!("name the folder in which it is{}", if is_question { &look } else { "" });
        return Err(nowhere(message, help));
    }
    if !folder.exists() {
        let message = format!("there is no folder `{shown}`");
        return Err(nowhere(message, format!("`carom new-bank {shown}` starts a bank there")));
    }
    let files = question_files(folder).map_err(|error| {
        nowhere(format!("`{shown}` cannot be read: {}", why_unread(&error)), "may you read this folder?".to_owned())
    })?;
    if files.is_empty() {
        let help = format!(
            "a question is a file that ends in `.toml`: `carom new-question {shown}/my-question.toml` starts one"
        );
        return Err(nowhere(format!("no questions in `{shown}`"), help));
    }
    let mut found = Files { sources: Vec::new(), unreadable: Vec::new() };
    for (id, path) in files {
        if let Some(fault) = misnamed(&id, &path) {
            found.unreadable.push(fault);
            continue;
        }
        match read_source(&path) {
            Ok(source) => found.sources.push((id, source)),
            Err(faults) => found.unreadable.extend(faults),
        }
    }
    Ok(found)
}

/// A fault of a name that cannot be printed or typed.
fn misnamed(id: &str, path: &Path) -> Option<Diagnostic> {
    let is_unprintable = |sign: char| sign.is_control() || sign == char::REPLACEMENT_CHARACTER;
    let shown: String = path.display().to_string().chars().filter(|sign| !sign.is_control()).collect();
    let message = format!("the name of `{shown}` has signs in it that cannot be printed");
    let fault = Diagnostic::new(message, &Source::new(shown.as_str(), ""), 0..0, "");
    let help = "give the file a name of letters, digits, `-` and `_`: it is typed and printed";
    id.contains(is_unprintable).then(|| fault.with_help(help))
}

/// The text of a question file, without the mark that some editors put at its beginning.
///
/// # Errors
///
/// A fault if it cannot be read, or is not in UTF-8.
pub fn read_source(path: &Path) -> Result<Source, Vec<Diagnostic>> {
    let shown = path.display().to_string();
    let fault = |message: String| Diagnostic::new(message, &Source::new(shown.as_str(), ""), 0..0, "");
    let unreadable = |error: io::Error| {
        let fault = fault(format!("`{shown}` cannot be read: {}", why_unread(&error)));
        let help = match error.kind() {
            _ if path.is_symlink() && !path.exists() => {
                "it is a link to a file that is not there: take it out, or put the file back".to_owned()
            }
            io::ErrorKind::NotFound => format!("`carom new-question {shown}` starts a question there"),
            io::ErrorKind::PermissionDenied => "may you read this file?".to_owned(),
            _ => "take it out of the bank, or put a copy of it in its place".to_owned(),
        };
        vec![fault.with_help(help)]
    };
    // A pipe or a device may have no end.
    let found = std::fs::metadata(path).map_err(unreadable)?;
    if !found.is_file() {
        let help = "a question is a text file that ends in `.toml`";
        return Err(vec![fault(format!("`{shown}` is no file")).with_help(help)]);
    }
    if found.len() > LONGEST {
        let help = "a question is a page of text; is it another file under this name?";
        return Err(vec![fault(format!("`{shown}` is longer than {LONGEST} bytes")).with_help(help)]);
    }
    decoded(&shown, &std::fs::read(path).map_err(unreadable)?)
}

/// No question is longer than this.
const LONGEST: u64 = 100_000;

/// A text from its bytes.
fn decoded(shown: &str, bytes: &[u8]) -> Result<Source, Vec<Diagnostic>> {
    let help = "save it as UTF-8: most editors ask for the encoding under 'Save as'";
    // Half of the bytes of plain letters are nought in UTF-16, with the mark at its beginning or without it.
    let noughts = bytes.iter().filter(|byte| **byte == 0).count();
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) || 4 * noughts > bytes.len() {
        let message = format!("`{shown}` is saved as UTF-16");
        return Err(vec![Diagnostic::new(message, &Source::new(shown, ""), 0..0, "").with_help(help)]);
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(Source::new(shown, text.strip_prefix('\u{feff}').unwrap_or(text))),
        Err(error) => {
            let source = Source::new(shown, String::from_utf8_lossy(bytes).into_owned());
            // What stands before is as long as it was.
            let at = error.valid_up_to();
            let span = at..at + char::REPLACEMENT_CHARACTER.len_utf8();
            let fault = Diagnostic::new("the file is not saved as UTF-8", &source, span, "expected a letter in UTF-8");
            Err(vec![fault.with_help(help)])
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_read_whatever_editor_saved_it_or_the_place_is_named() {
        let read = |bytes: &[u8]| decoded("q.toml", bytes);
        assert_eq!(&*read(b"\xef\xbb\xbftitle = 'x'\n").unwrap().text, "title = 'x'\n");
        assert_eq!(&*read("α\r\n".as_bytes()).unwrap().text, "α\r\n");
        let picture = read(b"a = 'x'\nb = 'r\xe9st'\n").unwrap_err()[0].to_string();
        assert!(picture.contains("q.toml:2:7") && picture.contains("UTF-8"), "{picture}");
        for bytes in [b"\xff\xfea\0".as_slice(), b"a\0=\x001\0", b"\0a\0=\x001"] {
            assert!(read(bytes).unwrap_err()[0].message.contains("UTF-16"));
        }
    }
}
