//! Files that people write in a spreadsheet or an editor: texts in UTF-8, from the disk or from stdin.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::failure::Failure;
use crate::diagnostic::Source;
use crate::table::decode;

/// No class writes more than this, nor a list of one.
const LONGEST: u64 = 1 << 28;

/// The text of a file, or of stdin if it is called `-`.
pub fn text(path: &Path) -> Result<Source, Failure> {
    let from_stdin = path == Path::new("-");
    let name = if from_stdin { "stdin".to_owned() } else { path.display().to_string() };
    let bytes = if from_stdin { limited(io::stdin().lock()) } else { file(path) };
    let bytes = bytes.map_err(|error| Failure::said(format!("`{name}` cannot be read: {error}")))?;
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

fn file(path: &Path) -> io::Result<Vec<u8>> {
    if path.is_dir() {
        return Err(io::Error::other("it is a folder"));
    }
    limited(File::open(path)?)
}

fn limited(from: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(LONGEST + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
