//! Files written all or none: first beside their places under other names, then moved there.

use std::collections::HashSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::text_file::leads_nowhere;
use crate::render::RenderedFile;

/// A file ready to be written: text or PDF, to the disk it is bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// Its name, perhaps with a folder below that of all: `mark-scheme.pdf`, `feedback/ada.html`.
    pub name: String,
    /// What stands in it.
    pub contents: Vec<u8>,
}

impl From<RenderedFile> for OutputFile {
    fn from(file: RenderedFile) -> OutputFile {
        OutputFile { name: file.name, contents: file.contents.into_bytes() }
    }
}

/// Writes files into a folder, which is made if need be, and returns their paths.
///
/// Until every file has been written whole, none of those that stood there before is touched; and no folder is left that was
/// made for nothing.
pub fn write_all(folder: &Path, files: &[OutputFile]) -> Result<Vec<PathBuf>, Failure> {
    let mut made = make_folder(folder)?;
    let mut waiting: Vec<(PathBuf, PathBuf)> = Vec::new();
    let outcome = place(folder, files, &mut waiting, &mut made);
    if outcome.is_err() {
        for (temporary, _) in &waiting {
            // What is left over is only our own half-written file.
            let _ = fs::remove_file(temporary);
        }
        remove(&made);
    }
    outcome?;
    Ok(waiting.into_iter().map(|(_, path)| path).collect())
}

/// Makes a folder and those above it, all or none; those that were not there before.
///
/// # Errors
///
/// What [`can_be`] finds, or whatever else the disk has against it.
pub fn make_folder(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    can_be(folder)?;
    let above = folder.ancestors().filter(|above| !above.as_os_str().is_empty());
    let mut missing: Vec<PathBuf> = above.take_while(|above| !above.exists()).map(Path::to_owned).collect();
    missing.reverse();
    match fs::create_dir_all(folder) {
        Ok(()) => Ok(missing),
        Err(error) => {
            remove(&missing);
            let (why, help) = refusal(&error);
            Err(Failure::with_help(format!("the folder `{}` cannot be made: {why}", folder.display()), help))
        }
    }
}

/// Takes folders away that were made for nothing, the innermost of which is the last. One in which something stands stays.
pub fn remove(made: &[PathBuf]) {
    made.iter().rev().for_each(|folder| drop(fs::remove_dir(folder)));
}

/// Looks whether a folder may be there or be made, before much work is done for what is to stand in it.
///
/// # Errors
///
/// A file in its place or above it.
pub fn can_be(folder: &Path) -> Result<(), Failure> {
    if let Some(link) = folder.ancestors().find(|above| leads_nowhere(above)) {
        return Err(Failure::with_help(
            format!(
                "the folder `{}` cannot be made: `{}` is a link that leads nowhere",
                folder.display(),
                link.display()
            ),
            "name another folder, or take the link away",
        ));
    }
    match folder.ancestors().find(|above| above.exists()) {
        Some(there) if !there.is_dir() => Err(Failure::with_help(
            format!("the folder `{}` cannot be made: `{}` is a file", folder.display(), there.display()),
            "name another folder, or move the file away",
        )),
        _ => Ok(()),
    }
}

/// That a file cannot be written, and why.
pub fn unwritten(path: &Path, error: &io::Error) -> Failure {
    let (why, help) = refusal(error);
    Failure::with_help(format!("`{}` cannot be written: {why}", path.display()), help)
}

/// That no folder for the work of a moment can be made where the machine keeps such things.
pub fn no_scratch(message: &str, error: &io::Error) -> Failure {
    let place = std::env::temp_dir();
    let help = "name a folder in which you may write in the variable TMPDIR (TEMP on Windows)";
    Failure::with_help(format!("{message}, in `{}`: {}", place.display(), refusal(error).0), help)
}

/// What the disk has against it in words of a person, and one thing to try.
pub fn refusal(error: &io::Error) -> (String, &'static str) {
    let (why, help) = match error.kind() {
        ErrorKind::PermissionDenied => ("you may not write there", "name another folder, such as one in your own"),
        ErrorKind::ReadOnlyFilesystem => ("what is there can be read and not written", "name a folder on another disk"),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            ("the disk is full", "make room on it, or name a folder on another disk")
        }
        ErrorKind::NotFound => ("nothing can be made there", "name another folder"),
        ErrorKind::InvalidFilename => ("the name is too long, or no name", "name a shorter one"),
        ErrorKind::NotADirectory => {
            ("a file is where a folder should be", "name another folder, or move the file away")
        }
        _ => return (error.to_string(), "name another folder"),
    };
    (why.to_owned(), help)
}

/// Makes sure that none of the files stands there already, in a folder where `nothing_says` that they are Carom's.
pub fn spares(folder: &Path, files: &[OutputFile], nothing_says: &str) -> Result<(), Failure> {
    match files.iter().map(|file| folder.join(&file.name)).find(|path| path.is_file()) {
        None => Ok(()),
        Some(path) => Err(Failure::with_help(
            format!("`{}` would be written over, and {nothing_says}", path.display()),
            "name another folder with `--out`, or move the file away",
        )),
    }
}

fn place(
    folder: &Path,
    files: &[OutputFile],
    waiting: &mut Vec<(PathBuf, PathBuf)>,
    made: &mut Vec<PathBuf>,
) -> Result<(), Failure> {
    let mut names = HashSet::new();
    for file in files {
        let path = folder.join(&file.name);
        if path.is_dir() {
            let help = "name another folder, or move this one away";
            return Err(Failure::with_help(format!("`{}` cannot be written: it is a folder", path.display()), help));
        }
        if !names.insert(&file.name) {
            return Err(Failure::with_help(
                format!("two of the formats write `{}`", file.name),
                "ask for one of them, or give the file another name in one `format.toml`",
            ));
        }
        let (inner, name) = match file.name.rsplit_once('/') {
            None => (folder.to_owned(), &*file.name),
            Some((inner, name)) => (folder.join(inner), name),
        };
        if !inner.is_dir() {
            made.extend(make_folder(&inner)?);
        }
        let temporary = inner.join(format!(".{name}.{}", std::process::id()));
        waiting.push((temporary.clone(), path.clone()));
        fs::write(&temporary, &file.contents).map_err(|error| unwritten(&path, &error))?;
    }
    for (temporary, path) in waiting.iter() {
        fs::rename(temporary, path).map_err(|error| unwritten(path, &error))?;
    }
    Ok(())
}
