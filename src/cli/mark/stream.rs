//! `carom mark --stream`: rows in, marks out, in order and in little memory, on all processors.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;

use super::super::failure::Failure;
use super::super::output::say;
use super::pieces::{Piece, Pieces};
use crate::diagnostic::Source;
use crate::mark::report::{MARKS, in_bulk};
use crate::mark::submissions::{Row, Rows, SetAside, Stream, sort};
use crate::mark::{AnswerKey, Profile};
use crate::table::{append, decode, delimiter};

/// Marks a file, or stdin if it is called `-`, to stdout.
pub fn run(key: &AnswerKey, profile: &Profile, path: &Path) -> Result<(), Failure> {
    let from_stdin = path == Path::new("-");
    let name = if from_stdin { "stdin".to_owned() } else { path.display().to_string() };
    let unread = |error| Failure::said(format!("`{name}` cannot be read: {error}"));
    let input: Box<dyn Read> =
        if from_stdin { Box::new(io::stdin().lock()) } else { Box::new(File::open(path).map_err(unread)?) };
    let (marked, aside) = stream(key, profile, BufReader::new(input), io::stdout().lock(), &name)?;
    match (marked, aside) {
        (0, 0) => {
            Err(Failure::with_help(format!("`{name}` has no answers"), "`carom mark --help` shows a table of some"))
        }
        (_, 0) => Ok(()),
        (_, aside) => {
            say(&format!(
                "warning: {name}: {aside} rows set aside; `not-marked` stands in their place, with the reason"
            ));
            Ok(())
        }
    }
}

/// Marks what comes in; how many scripts were marked, and how many rows set aside.
fn stream(
    key: &AnswerKey,
    profile: &Profile,
    input: impl BufRead,
    output: impl Write,
    name: &str,
) -> Result<(usize, usize), Failure> {
    let unread = |error: io::Error| Failure::said(format!("`{name}` cannot be read: {error}"));
    let mut output = BufWriter::new(output);
    let mut pieces = Pieces::new(input);
    let (line, first) = pieces.first().map_err(unread)?;
    let text = decode(&first).map_err(|fault| Failure::with_help(format!("`{name}` {}", fault.message), fault.help))?;
    let mut stream = Stream::new(&Source::new(name, text))?;
    let mut counts = (0, 0);
    let mut write = |rows: Rows, output: &mut dyn Write| -> Result<(), Failure> {
        let sorted = sort(key, rows);
        counts.0 += sorted.scripts.len();
        counts.1 += sorted.set_aside.len();
        Ok(output.write_all(in_bulk(&sorted, profile, !text.trim_start().starts_with('{')).as_bytes())?)
    };
    if stream.is_table() {
        pieces.is_table(delimiter(text));
        output.write_all(append([MARKS.map(str::to_owned)].into_iter()).as_bytes())?;
    } else {
        let rows = stream.take(text, line);
        write(rows, &mut output)?;
    }
    while let Some(Piece { text, line, broken }) = pieces.next().map_err(unread)? {
        let mut rows = stream.take(&text, line);
        rows.set_aside.extend(broken.map(|(line, reason, answer)| {
            let row = Row { line, answer, ..Row::default() };
            SetAside { row, reason }
        }));
        write(rows, &mut output)?;
    }
    write(stream.end(), &mut output)?;
    output.flush()?;
    Ok(counts)
}
