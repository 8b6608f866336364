//! `carom mark --stream`: rows in, marks out, in order and in little memory, on all processors; to a pipe or into a folder.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;

use super::super::failure::{Failure, warn};
use super::super::output::{count, say};
use super::super::text_file::{is_stdin, name_of, unread};
use super::in_order::{HandOn, in_order};
use super::pieces::{First, Piece, Pieces, has_lone_returns};
use super::tell_of_old;
use super::unfinished::{Digest, Entry, NAMES, Unfinished};
use crate::diagnostic::Source;
use crate::mark::report::{Bulk, MARKS};
use crate::mark::submissions::{Row, Rows, SetAside, Stream, sort};
use crate::mark::{AnswerKey, Profile};
use crate::table::{append, decode, delimiter};

/// Marks a file, or stdin if it is called `-`, to stdout, or into a folder. `of` is a digest of the key.
pub fn run(key: &AnswerKey, of: Digest, profile: &Profile, path: &Path, out: Option<&Path>) -> Result<(), Failure> {
    let (from_stdin, name) = (is_stdin(path), name_of(path));
    let unread = |error| unread(path, &error);
    let input: Box<dyn Read + Send> =
        if from_stdin { Box::new(io::stdin()) } else { Box::new(File::open(path).map_err(unread)?) };
    let mut input = BufReader::with_capacity(1 << 16, input);
    let is_filter = from_stdin && out.is_none();
    let is_empty = is_filter && input.fill_buf().map_err(unread)?.is_empty();
    let marked = match is_empty {
        true => Entry::default(),
        false => {
            let submissions = Submissions::begin(input, &name, out.is_some())?;
            let marking = Marking { key, profile, name: &name, as_table: submissions.stream.is_table() };
            match out {
                None => marking.fill_pipe(submissions)?,
                Some(folder) => marking.fill_folder(submissions, folder, of)?,
            }
        }
    };
    match (marked.scripts, marked.aside) {
        // What runs many filters side by side gives some of them nothing, and gets nothing.
        (0, 0) if is_filter => say("warning: stdin has no answers"),
        (0, 0) => return Err(no_answers(&name)),
        (_, 0) => {}
        (_, aside) => {
            let aside = count(aside, "row");
            say(&format!("warning: {name}: {aside} set aside; `not-marked` stands in their place, with the reason"));
        }
    }
    Ok(())
}

fn no_answers(name: &str) -> Failure {
    Failure::with_help(format!("`{name}` has no answers"), "`carom mark --help` shows a table of some")
}

/// What comes in, a block at a time.
struct Submissions<R> {
    pieces: Pieces<R>,
    stream: Stream,
    /// A block that has been read and not yet handed on.
    waiting: Option<Piece>,
    /// Of all that has come so far, where a journal is kept.
    digest: Option<Digest>,
}

/// What an earlier run has done.
struct Done {
    blocks: usize,
    last: Entry,
}

/// The rows of a block, and where it ends; the rows that are left at the end of all are of no block.
struct Block {
    rows: Rows,
    end: Option<(u64, usize)>,
}

impl<R: BufRead> Submissions<R> {
    /// Reads the names of the columns, or the first line of JSON.
    fn begin(input: R, name: &str, is_entered: bool) -> Result<Submissions<R>, Failure> {
        let mut pieces = Pieces::new(input);
        let first = pieces.first().map_err(|error| unread(Path::new(name), &error))?;
        let First { line, bytes, is_whole } = first;
        if has_lone_returns(&bytes) {
            let message =
                format!("the rows of `{name}` end in carriage returns alone, and a stream is parted by line feeds");
            return Err(Failure::with_help(message, "save it again as CSV in UTF-8, or mark it without `--stream`"));
        }
        if !is_whole {
            let message = format!("line {line} of `{name}`, which is to name the columns, is too long to be read");
            return Err(Failure::with_help(message, "`carom mark --help` shows what a table of answers looks like"));
        }
        let text =
            decode(&bytes).map_err(|fault| Failure::with_help(format!("`{name}` {}", fault.message), fault.help))?;
        let stream = Stream::new(&Source::new(name, text))?;
        warn(stream.warnings());
        let digest = is_entered.then(|| Digest::of(&bytes));
        let mut waiting = None;
        if stream.is_table() {
            pieces.is_table(delimiter(text));
        } else {
            waiting = Some(Piece { text: text.to_owned(), line, broken: None });
        }
        Ok(Submissions { pieces, stream, waiting, digest })
    }

    /// The next block: its text, and where it ends.
    fn next(&mut self) -> io::Result<Option<(Piece, Option<Digest>)>> {
        let next = match self.waiting.take() {
            Some(waiting) => Some(waiting),
            None => self.pieces.next()?,
        };
        Ok(next.map(|piece| {
            let mut digest = self.digest.clone();
            if let Some(digest) = &mut digest {
                digest.feed(piece.text.as_bytes());
                digest.feed(format!("{} {:?}", piece.line, piece.broken).as_bytes());
            }
            (piece, digest)
        }))
    }

    /// The rows of students who are over.
    fn rows(&mut self, piece: Piece) -> Rows {
        let mut rows = self.stream.take(&piece.text, piece.line);
        rows.set_aside
            .extend(piece.broken.map(|(line, reason, answer)| SetAside { row: Row::unread(line, &answer), reason }));
        rows
    }

    /// Reads as much as an earlier run has marked, and says so.
    fn pass_over(&mut self, unfinished: &Unfinished, name: &str) -> Result<Done, Failure> {
        let mut done = Done { blocks: 0, last: Entry::default() };
        let mut is_changed = false;
        for entry in unfinished.entries() {
            let next = self.next().map_err(|error| unread(Path::new(name), &error))?;
            let piece = match next {
                Some((piece, digest)) if so_far(&digest) == entry.submissions => {
                    self.digest = digest;
                    piece
                }
                other => {
                    self.waiting = other.map(|(piece, _)| piece);
                    is_changed = true;
                    break;
                }
            };
            self.rows(piece);
            done = Done { blocks: done.blocks + 1, last: entry };
        }
        if unfinished.is_of_another() {
            say("an earlier run that did not end had another key, profile or version of Carom: all is marked afresh");
        }
        if done.blocks > 0 {
            let scripts = count(done.last.scripts, "script");
            say(&format!("{scripts} marked by an earlier run that did not end; going on at line {}", done.last.line));
        }
        if is_changed {
            say(&format!(
                "the submissions have changed since: from line {} all is marked afresh",
                done.last.line.max(1)
            ));
        }
        Ok(done)
    }

    /// Hands all that is left to be marked on.
    fn hand_on(mut self, hand_on: &HandOn<Block>) -> io::Result<()> {
        while let Some((piece, digest)) = self.next()? {
            self.digest = digest;
            let rows = self.rows(piece);
            let end = Some((so_far(&self.digest), self.pieces.line()));
            if !hand_on(Block { rows, end }) {
                return Ok(());
            }
        }
        hand_on(Block { rows: self.stream.end(), end: None });
        Ok(())
    }
}

fn so_far(digest: &Option<Digest>) -> u64 {
    digest.as_ref().map_or(0, Digest::so_far)
}

/// What answers are marked by, and what comes of it.
struct Marking<'k> {
    key: &'k AnswerKey,
    profile: &'k Profile,
    name: &'k str,
    as_table: bool,
}

impl Marking<'_> {
    fn header(&self) -> String {
        if self.as_table { append([MARKS.map(str::to_owned)].into_iter()) } else { String::new() }
    }

    fn fill_pipe(&self, submissions: Submissions<impl BufRead + Send>) -> Result<Entry, Failure> {
        let mut stdout = io::stdout();
        stdout.write_all(self.header().as_bytes())?;
        let marked = self.rest(submissions, Entry::default(), |marks, _| Ok(stdout.write_all(marks.as_bytes())?))?;
        stdout.flush()?;
        Ok(marked)
    }

    fn fill_folder(
        &self,
        mut submissions: Submissions<impl BufRead + Send>,
        folder: &Path,
        mut of: Digest,
    ) -> Result<Entry, Failure> {
        let file = NAMES[usize::from(!self.as_table)];
        of.feed(format!("{:?}", self.profile).as_bytes());
        let mut unfinished = Unfinished::open(folder, file, of.so_far())?;
        let done = submissions.pass_over(&unfinished, self.name)?;
        unfinished.keep(done.blocks)?;
        if done.blocks == 0 {
            unfinished.write(&self.header())?;
        }
        let marked = self.rest(submissions, done.last, |marks, entry| {
            unfinished.write(marks)?;
            entry.map_or(Ok(()), |entry| unfinished.enter(entry))
        })?;
        match (marked.scripts, marked.aside) {
            (0, 0) => unfinished.give_up(),
            (scripts, _) => {
                let place = unfinished.finish()?;
                say(&format!("{} marked in `{}`", count(scripts, "script"), place.display()));
                tell_of_old(folder, &[file]);
            }
        }
        Ok(marked)
    }

    /// Marks all that is left. `write` gets the marks of each block, with the entry that follows them in the journal.
    fn rest<R: BufRead + Send>(
        &self,
        submissions: Submissions<R>,
        done: Entry,
        mut write: impl FnMut(&str, Option<Entry>) -> Result<(), Failure>,
    ) -> Result<Entry, Failure> {
        let unread = |error: io::Error| unread(Path::new(self.name), &error);
        let worker = || {
            let mut bulk = Bulk::new(self.profile, self.as_table);
            move |block: Block| {
                let sorted = sort(self.key, block.rows);
                (bulk.marks(&sorted), sorted.scripts.len(), sorted.set_aside.len(), block.end)
            }
        };
        let mut so_far = done;
        in_order(
            |hand_on| submissions.hand_on(hand_on).map_err(unread),
            worker,
            |(marks, scripts, aside, end)| {
                so_far.scripts += scripts;
                so_far.aside += aside;
                if let Some((submissions, line)) = end {
                    so_far = Entry { submissions, line, ..so_far };
                }
                write(&marks, end.map(|_| so_far))
            },
        )?;
        Ok(so_far)
    }
}
