//! Files that people write in a spreadsheet or an editor: texts in UTF-8, from the disk or from stdin.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::failure::Failure;
use crate::diagnostic::{Source, near};
use crate::table::decode;

/// No class writes more than this, nor a list of one.
const LONGEST: u64 = 1 << 28;

/// The text of a file, or of stdin if it is called `-`.
pub fn text(path: &Path) -> Result<Source, Failure> {
    let name = name_of(path);
    let bytes = bytes(path, LONGEST)?;
    if bytes.len() as u64 > LONGEST {
        return Err(Failure::with_help(
            format!("`{name}` is too long: more than {} million bytes", LONGEST / 1_000_000),
            "divide it and mark the pieces into different folders",
        ));
    }
    match decode(&bytes) {
        Ok(text) => Ok(Source::new(name, text)),
        Err(fault) => Err(Failure::with_help(format!("`{name}` {}", fault.message), fault.help)),
    }
}

/// The bytes of a file, or of stdin if it is called `-`; of what is longer one more than so many.
pub fn bytes(path: &Path, longest: u64) -> Result<Vec<u8>, Failure> {
    let limited = |from: &mut dyn Read| {
        let mut bytes = Vec::new();
        from.take(longest + 1).read_to_end(&mut bytes).map(|_| bytes)
    };
    let bytes = match is_stdin(path) {
        true => limited(&mut io::stdin().lock()),
        false if path.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        false => File::open(path).and_then(|mut file| limited(&mut file)),
    };
    bytes.map_err(|error| unread(path, &error))
}

/// Is it no file, but what is piped in?
pub fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// What a file is called in messages.
pub fn name_of(path: &Path) -> String {
    if is_stdin(path) { "stdin".to_owned() } else { path.display().to_string() }
}

/// A file that cannot be read, why not, and which may have been meant.
pub fn unread(path: &Path, error: &io::Error) -> Failure {
    let name = name_of(path);
    if path.is_dir() {
        let key = path.join("key.json");
        let help = match key.is_file() {
            true => format!("did you mean `{}`?", key.display()),
            false => "give the file in it that you mean".to_owned(),
        };
        return Failure::with_help(format!("`{name}` cannot be read: it is a folder"), help);
    }
    if error.kind() != io::ErrorKind::NotFound {
        return Failure::with_help(format!("`{name}` cannot be read: {error}"), "look whether you may open it");
    }
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let there: Vec<String> =
        folder.read_dir().into_iter().flatten().flatten().map(|entry| last_of(&entry.path())).collect();
    let help = match near(&last_of(path), there.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{}`?", path.with_file_name(near).display()),
        None if !folder.is_dir() => format!("there is no folder `{}` either: look at the path", folder.display()),
        None => "look at its name, and in which folder you are".to_owned(),
    };
    Failure::with_help(format!("`{name}` cannot be read: there is no such file"), help)
}

fn last_of(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}
