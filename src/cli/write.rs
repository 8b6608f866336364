//! Files written all or none: first beside their places under other names, then moved there.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::failure::Failure;
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
/// Until every file has been written whole, none of those that stood there before is touched.
pub fn write_all(folder: &Path, files: &[OutputFile]) -> Result<Vec<PathBuf>, Failure> {
    fs::create_dir_all(folder)
        .map_err(|error| Failure::said(format!("the folder `{}` cannot be made: {error}", folder.display())))?;
    let mut waiting: Vec<(PathBuf, PathBuf)> = Vec::new();
    let outcome = place(folder, files, &mut waiting);
    if outcome.is_err() {
        for (temporary, _) in &waiting {
            // What is left over is only our own half-written file.
            let _ = fs::remove_file(temporary);
        }
    }
    outcome?;
    Ok(waiting.into_iter().map(|(_, path)| path).collect())
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

fn place(folder: &Path, files: &[OutputFile], waiting: &mut Vec<(PathBuf, PathBuf)>) -> Result<(), Failure> {
    let cannot = |path: &Path, error| Failure::said(format!("`{}` cannot be written: {error}", path.display()));
    let mut names = HashSet::new();
    for file in files {
        let path = folder.join(&file.name);
        if path.is_dir() {
            return Err(Failure::said(format!("`{}` cannot be written: it is a folder", path.display())));
        }
        if !names.insert(&file.name) {
            return Err(Failure::with_help(
                format!("two of the formats write `{}`", file.name),
                "ask for one of them, or give the file another name in one `format.toml`",
            ));
        }
        let (inner, name) = file.name.rsplit_once('/').unwrap_or(("", &file.name));
        let inner = folder.join(inner);
        fs::create_dir_all(&inner).map_err(|error| cannot(&path, error))?;
        let temporary = inner.join(format!(".{name}.{}", std::process::id()));
        waiting.push((temporary.clone(), path.clone()));
        fs::write(&temporary, &file.contents).map_err(|error| cannot(&path, error))?;
    }
    for (temporary, path) in waiting.iter() {
        fs::rename(temporary, path).map_err(|error| cannot(path, error))?;
    }
    Ok(())
}
