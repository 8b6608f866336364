//! Marks on their way into a folder: whatever ends a run, what was marked is kept, and the next run goes on from there.
//!
//! Until everything is marked, marks stand in the folder `unfinished` beside a journal; then they are moved to their place,
//! whole. A line of the journal is written after the marks of a block of submissions. It has the digest of all submissions
//! so far, how many bytes of marks there are and their digest, and what was counted. The next run believes nothing of it
//! that the files do not bear out: it reads the submissions again from the beginning, which is quick, and marks from the
//! first block that is not as the journal has it.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::super::failure::Failure;
use super::super::write::{make_folder, refusal, unwritten};

/// The folder within that of the marks.
const UNFINISHED: &str = "unfinished";

/// What marks are called: of a table, and of JSON lines.
pub const NAMES: [&str; 2] = ["marks.csv", "marks.jsonl"];

/// A digest of bytes, FNV-1a: it finds what has changed, and is no lock against malice.
#[derive(Clone)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Digest {
        Digest(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// The digest of these bytes.
    pub fn of(bytes: &[u8]) -> Digest {
        let mut digest = Digest::default();
        digest.feed(bytes);
        digest
    }

    /// More bytes.
    pub fn feed(&mut self, bytes: &[u8]) {
        let next = |digest: u64, byte: &u8| (digest ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        self.0 = bytes.iter().fold(self.0, next);
    }

    /// The digest so far.
    pub fn so_far(&self) -> u64 {
        self.0
    }
}

/// What there is after a block of submissions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Entry {
    /// The digest of the submissions up to its end.
    pub submissions: u64,
    /// The line after its last.
    pub line: usize,
    /// How many scripts have been marked.
    pub scripts: usize,
    /// How many rows have been set aside.
    pub aside: usize,
}

/// What is whole after a block: the bytes of marks, and their digest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Whole {
    bytes: u64,
    digest: u64,
}

/// Marks that are being written.
pub struct Unfinished {
    folder: PathBuf,
    name: &'static str,
    marks: File,
    journal: File,
    /// What the journal says and the marks bear out, in order.
    entries: Vec<(Entry, Whole)>,
    bytes: u64,
    digest: Digest,
    /// Is there a journal of a run with another key or profile?
    is_of_another: bool,
    /// Has the folder been made for these marks?
    is_new: bool,
}

impl Unfinished {
    /// Opens what there is of marks with this name in a folder, or begins. `of` is a digest of all that the marks depend
    /// on beside the submissions.
    ///
    /// # Errors
    ///
    /// What cannot be written, or another run that is writing it.
    pub fn open(folder: &Path, name: &'static str, of: u64) -> Result<Unfinished, Failure> {
        let within = folder.join(UNFINISHED);
        let cannot = |path: &Path, error: io::Error| unwritten(path, &error);
        let target = folder.join(name);
        if target.is_dir() {
            let help = "name another folder with `--out`, or move this one away";
            return Err(Failure::with_help(format!("`{}` cannot be written: it is a folder", target.display()), help));
        }
        let is_new = !folder.exists();
        make_folder(&within)?;
        let open = |path: PathBuf| {
            let file = File::options().read(true).write(true).create(true).truncate(false).open(&path);
            file.map_err(|error| cannot(&path, error))
        };
        let mut journal = open(within.join("journal"))?;
        // A system that has no locks does without.
        if let Err(TryLockError::WouldBlock) = journal.try_lock() {
            let message = format!("another `carom mark` is writing into `{}`", folder.display());
            return Err(Failure::with_help(message, "wait until it is done, or name another folder with `--out`"));
        }
        let mut marks = open(within.join(name))?;
        let mut read = || -> io::Result<_> {
            let mut text = String::new();
            // A line that was not written to its end is none.
            let whole =
                journal.read_to_string(&mut text).is_ok().then_some(&*text).and_then(|text| text.rsplit_once('\n'));
            let mut lines = whole.map_or("", |(whole, _)| whole).lines();
            let is_ours = lines.next() == Some(&*first_line(name, of));
            let said: Vec<_> = if is_ours { lines.map_while(entry).collect() } else { Vec::new() };
            Ok((borne_out(&mut marks, said)?, !text.is_empty() && !is_ours))
        };
        let (entries, is_of_another) = read().map_err(|error| cannot(&within, error))?;
        let mut unfinished = Unfinished {
            folder: folder.to_owned(),
            name,
            marks,
            journal,
            entries,
            bytes: 0,
            digest: Digest::default(),
            is_of_another,
            is_new,
        };
        if unfinished.entries.is_empty() {
            unfinished.begin(of).map_err(|error| cannot(&within, error))?;
        }
        Ok(unfinished)
    }

    /// What an earlier run has marked, block by block.
    pub fn entries(&self) -> impl ExactSizeIterator<Item = Entry> {
        self.entries.iter().map(|(entry, _)| *entry)
    }

    /// Did an earlier run have another key or profile, or another version of Carom?
    pub fn is_of_another(&self) -> bool {
        self.is_of_another
    }

    fn begin(&mut self, of: u64) -> io::Result<()> {
        // What a run left that wrote another kind of marks.
        for other in NAMES.iter().filter(|other| **other != self.name) {
            let _ = fs::remove_file(self.folder.join(UNFINISHED).join(other));
        }
        self.journal.set_len(0)?;
        self.journal.rewind()?;
        self.journal.write_all(format!("{}\n", first_line(self.name, of)).as_bytes())
    }

    /// Keeps the marks of so many blocks and forgets the rest.
    pub fn keep(&mut self, blocks: usize) -> Result<(), Failure> {
        self.cut(blocks).map_err(|error| self.cannot(error))
    }

    fn cut(&mut self, blocks: usize) -> io::Result<()> {
        let kept = blocks.checked_sub(1).and_then(|last| self.entries.get(last));
        self.bytes = kept.map_or(0, |(_, whole)| whole.bytes);
        self.marks.set_len(self.bytes)?;
        self.digest = Digest::default();
        self.marks.rewind()?;
        digest_of(&mut self.marks, &mut self.digest, self.bytes)?;
        self.journal.rewind()?;
        let mut text = String::new();
        self.journal.read_to_string(&mut text)?;
        let length: usize = text.split_inclusive('\n').take(1 + blocks).map(str::len).sum();
        self.journal.set_len(length as u64)?;
        self.journal.seek(SeekFrom::End(0))?;
        Ok(())
    }

    /// Writes marks that are not yet those of a whole block.
    pub fn write(&mut self, marks: &str) -> Result<(), Failure> {
        self.marks.write_all(marks.as_bytes()).map_err(|error| self.cannot(error))?;
        self.digest.feed(marks.as_bytes());
        self.bytes += marks.len() as u64;
        Ok(())
    }

    /// Says in the journal that the marks of a block are whole.
    pub fn enter(&mut self, entry: Entry) -> Result<(), Failure> {
        let Entry { submissions, line, scripts, aside } = entry;
        let (bytes, digest) = (self.bytes, self.digest.so_far());
        let line = format!("{submissions:016x} {line} {scripts} {aside} {bytes} {digest:016x}\n");
        self.journal.write_all(line.as_bytes()).map_err(|error| self.cannot(error))
    }

    fn cannot(&self, error: io::Error) -> Failure {
        let message = format!("`{}` cannot be written: {}", self.folder.join(UNFINISHED).display(), refusal(&error).0);
        Failure::with_help(message, "what has been marked is kept: the same command goes on from there")
    }

    /// Moves the marks, which are whole, to their place.
    pub fn finish(self) -> Result<PathBuf, Failure> {
        let within = self.folder.join(UNFINISHED);
        let place = self.folder.join(self.name);
        self.marks.sync_all().map_err(|error| self.cannot(error))?;
        fs::rename(within.join(self.name), &place).map_err(|error| unwritten(&place, &error))?;
        // What is left over is of no use any more, and in nobody's way.
        let _ = fs::remove_file(within.join("journal"));
        drop(self);
        let _ = fs::remove_dir(within);
        Ok(place)
    }

    /// Forgets marks of nothing.
    pub fn give_up(self) {
        // What is left over is of no use, and in nobody's way.
        let _ = fs::remove_dir_all(self.folder.join(UNFINISHED));
        if self.is_new {
            let _ = fs::remove_dir(&self.folder);
        }
    }
}

fn first_line(name: &str, of: u64) -> String {
    format!("carom {} {name} {of:016x}", env!("CARGO_PKG_VERSION"))
}

/// A line of the journal.
fn entry(line: &str) -> Option<(Entry, Whole)> {
    let mut words = line.split(' ');
    let hexadecimal = |word: Option<&str>| u64::from_str_radix(word?, 16).ok();
    let submissions = hexadecimal(words.next())?;
    let mut number = || words.next()?.parse::<u64>().ok();
    let (line, scripts, aside, bytes) = (number()?, number()?, number()?, number()?);
    let digest = hexadecimal(words.next())?;
    let [line, scripts, aside] = [line, scripts, aside].map(|number| usize::try_from(number).ok());
    let entry = Entry { submissions, line: line?, scripts: scripts?, aside: aside? };
    words.next().is_none().then_some((entry, Whole { bytes, digest }))
}

/// The entries up to the first that the marks do not bear out.
fn borne_out(marks: &mut File, said: Vec<(Entry, Whole)>) -> io::Result<Vec<(Entry, Whole)>> {
    marks.rewind()?;
    let mut marks = BufReader::new(marks);
    let (mut digest, mut read) = (Digest::default(), 0);
    let mut borne_out = Vec::new();
    for (entry, whole) in said {
        let Some(more) = whole.bytes.checked_sub(read) else { break };
        if digest_of(&mut marks, &mut digest, more)? != more || digest.so_far() != whole.digest {
            break;
        }
        read = whole.bytes;
        borne_out.push((entry, whole));
    }
    Ok(borne_out)
}

/// Feeds a digest with so many bytes; how many there were.
fn digest_of(from: impl Read, digest: &mut Digest, bytes: u64) -> io::Result<u64> {
    let mut from = BufReader::with_capacity(1 << 16, from.take(bytes));
    let mut read = 0;
    loop {
        let found = from.fill_buf()?;
        if found.is_empty() {
            return Ok(read);
        }
        digest.feed(found);
        let length = found.len();
        read += length as u64;
        from.consume(length);
    }
}
