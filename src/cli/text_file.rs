//! Files that people write in a spreadsheet or an editor: texts in UTF-8, from the disk or from stdin.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::failure::Failure;
use crate::diagnostic::{Source, near, why_unread};
use crate::table::decode;

/// No class writes more than this, nor a list of one.
const LONGEST: u64 = 1 << 28;

/// The text of a file that is usually called so: if a folder is named, that is the one in it which was meant.
pub fn usually(path: &Path, called: &str) -> Result<Source, Failure> {
    let within = path.join(called);
    if path.is_dir() && within.is_file() {
        let message = format!("`{}` cannot be read: it is a folder", name_of(path));
        return Err(Failure::with_help(message, format!("did you mean `{}`?", within.display())));
    }
    text(path)
}

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
    let why = match path {
        path if path.is_dir() => "it is a folder".to_owned(),
        path if leads_nowhere(path) => "it is a link that leads to no file".to_owned(),
        _ => why_unread(error),
    };
    if error.kind() != io::ErrorKind::NotFound || is_stdin(path) || leads_nowhere(path) {
        let help = match error.kind() {
            _ if path.is_dir() => "give the file in it that you mean",
            _ if leads_nowhere(path) => "give the file itself",
            io::ErrorKind::PermissionDenied => "put a copy of it in a folder of your own",
            io::ErrorKind::IsADirectory => "give the file in it that you mean",
            io::ErrorKind::NotADirectory => "look at the path",
            _ => "look at its name, and whether you may open it",
        };
        return Failure::with_help(format!("`{name}` cannot be read: {why}"), help);
    }
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let there: Vec<String> =
        folder.read_dir().into_iter().flatten().flatten().map(|entry| last_of(&entry.path())).collect();
    let help = match near(&last_of(path), there.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{}`?", path.with_file_name(near).display()),
        None if !folder.is_dir() => format!("there is no folder `{}` either: look at the path", folder.display()),
        None => "look at its name, and in which folder you are".to_owned(),
    };
    Failure::with_help(format!("`{name}` cannot be read: {why}"), help)
}

/// Is it a link, and nothing there to which it leads?
pub fn leads_nowhere(path: &Path) -> bool {
    path.is_symlink() && !path.exists()
}

fn last_of(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}
