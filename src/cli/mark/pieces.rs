//! A stream of bytes in pieces of whole records, so that however long it is little of it is held.

use std::io::{self, BufRead, Cursor, Read};

/// About how many bytes a piece has.
const PIECE: usize = 1 << 15;

/// The longest record that is read; of a longer one only the beginning is kept.
const LONGEST: usize = 1 << 20;

/// How much more of one is passed over in search of its end.
const FURTHER: usize = 1 << 20;

/// How much of a record that is set aside is shown.
const SHOWN: usize = 200;

/// Records of a stream one after another.
pub struct Pieces<R> {
    input: R,
    /// What has been read and is to be read again before it.
    back: Cursor<Vec<u8>>,
    /// What parts the cells, if it is a table, in which a record may have several lines.
    table: Option<u8>,
    line: usize,
    /// The record that is being read.
    record: Vec<u8>,
}

/// The first line that is not empty.
pub struct First {
    /// Its number.
    pub line: usize,
    /// Its bytes, of one that is too long only the first.
    pub bytes: Vec<u8>,
    /// Are these all?
    pub is_whole: bool,
}

/// Some records, and what is no text among them.
#[derive(Debug, Default)]
pub struct Piece {
    /// The records.
    pub text: String,
    /// The line on which they begin.
    pub line: usize,
    /// Records that are left out: the line, the reason, and the beginning. A piece ends where one was left out, so that the
    /// lines of the others are right.
    pub broken: Option<(usize, String, String)>,
}

enum Record {
    Whole,
    /// Passed over to its end.
    TooLong,
    /// Passed over to the end of a line; its own end is nowhere near.
    NoEnd,
    End,
}

impl<R: BufRead> Pieces<R> {
    /// Records that are lines; of a table once [`Pieces::is_table`] says so.
    pub fn new(input: R) -> Pieces<R> {
        Pieces { input, back: Cursor::default(), table: None, line: 1, record: Vec::new() }
    }

    /// From here on a record may have line breaks in quotes, cells being parted by this sign.
    pub fn is_table(&mut self, delimiter: u8) {
        self.table = Some(delimiter);
    }

    /// The number of the line that comes next.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The first line that is not empty.
    pub fn first(&mut self) -> io::Result<First> {
        loop {
            let mut record = Vec::new();
            let line = self.line;
            let read = self.record(&mut record)?;
            self.line += lines(&record);
            let is_whole = !matches!(read, Record::TooLong | Record::NoEnd);
            if !is_whole || matches!(read, Record::End) || !record.trim_ascii().is_empty() {
                return Ok(First { line, bytes: record, is_whole });
            }
        }
    }

    /// The next piece; nothing at the end.
    pub fn next(&mut self) -> io::Result<Option<Piece>> {
        let mut piece = Piece { line: self.line, ..Piece::default() };
        let mut record = std::mem::take(&mut self.record);
        while piece.text.len() < PIECE {
            self.plain_lines(&mut piece.text)?;
            if piece.text.len() >= PIECE {
                break;
            }
            record.clear();
            let line = self.line;
            let read = self.record(&mut record)?;
            self.line += lines(&record);
            let begins = |record: &[u8]| String::from_utf8_lossy(&record[..record.len().min(SHOWN)]).into_owned();
            match (&read, std::str::from_utf8(&record)) {
                (Record::End, _) if piece.text.is_empty() => return Ok(None),
                (Record::End, _) => break,
                (Record::Whole, Ok(text)) => piece.text.push_str(text),
                (Record::Whole, Err(_)) => {
                    piece.broken = Some((line, "this is not in UTF-8".to_owned(), begins(&record)));
                    break;
                }
                (Record::TooLong | Record::NoEnd, _) => {
                    let next = self.line;
                    let done = match read {
                        Record::NoEnd => format!(
                            "a quote is opened and never closed, perhaps; from line {next} on rows are read as they stand"
                        ),
                        _ => format!("it is left out, and the next row is on line {next}"),
                    };
                    let reason = format!("this is longer than {LONGEST} bytes: {done}");
                    piece.broken = Some((line, reason, begins(&record)));
                    break;
                }
            }
        }
        self.record = record;
        Ok(Some(piece))
    }

    /// Takes whatever whole lines there are that need no closer look, all at once, up to the one that fills a piece.
    fn plain_lines(&mut self, text: &mut String) -> io::Result<()> {
        let has_quotes = self.table.is_some();
        let mut source = self.source();
        let there = source.fill_buf()?;
        // A line that is longer than this is not taken.
        let there = &there[..there.len().min(LONGEST)];
        let wanted = PIECE.saturating_sub(text.len() + 1);
        let fills = there.get(wanted..).and_then(|rest| rest.iter().position(|byte| *byte == b'\n'));
        let there = &there[..fills.map_or(there.len(), |more| wanted + more + 1)];
        let valid = std::str::from_utf8(there).or_else(|error| std::str::from_utf8(&there[..error.valid_up_to()]));
        let valid = valid.unwrap_or_default();
        let plain = valid.find('"').filter(|_| has_quotes).map_or(valid, |quote| &valid[..quote]);
        let plain = plain.rfind('\n').map_or("", |last| &plain[..=last]);
        let (bytes, lines) = (plain.len(), plain.bytes().filter(|byte| *byte == b'\n').count());
        text.push_str(plain);
        source.consume(bytes);
        drop(source);
        self.line += lines;
        Ok(())
    }

    /// Reads a record; of one that is too long only as much is kept as shows that it is.
    fn record(&mut self, record: &mut Vec<u8>) -> io::Result<Record> {
        let mut quotes = Quotes::of(self.table);
        loop {
            let start = record.len();
            let room = (LONGEST + 1 - start) as u64;
            if self.source().take(room).read_until(b'\n', record)? == 0 {
                return Ok(if record.is_empty() { Record::End } else { Record::Whole });
            }
            quotes.pass(&record[start..]);
            if record.len() > LONGEST {
                return self.pass_over(quotes, record.ends_with(b"\n"));
            }
            if !quotes.are_open {
                return Ok(Record::Whole);
            }
        }
    }

    /// Passes over what is left of a record: to its end, if that is not far; else to the end of a line, so that a quote that
    /// is never closed takes no other rows with it.
    fn pass_over(&mut self, mut quotes: Quotes, ended: bool) -> io::Result<Record> {
        let mut ahead = Vec::new();
        let mut line_ended = ended;
        while quotes.are_open || !line_ended {
            let start = ahead.len();
            let read = self.source().take((FURTHER - start) as u64).read_until(b'\n', &mut ahead)?;
            if read == 0 && (quotes.are_open || start == FURTHER) {
                self.begin_again(ahead, ended)?;
                return Ok(Record::NoEnd);
            }
            quotes.pass(&ahead[start..]);
            line_ended = read == 0 || ahead.ends_with(b"\n");
        }
        self.line += lines(&ahead);
        Ok(Record::TooLong)
    }

    /// Goes back to the line that follows the first of these.
    fn begin_again(&mut self, mut ahead: Vec<u8>, ended: bool) -> io::Result<()> {
        if !ended {
            match ahead.iter().position(|byte| *byte == b'\n') {
                Some(end) => drop(ahead.drain(..=end)),
                None => {
                    ahead.clear();
                    self.source().skip_until(b'\n')?;
                }
            }
            self.line += 1;
        }
        self.back.read_to_end(&mut ahead)?;
        self.back = Cursor::new(ahead);
        Ok(())
    }

    /// What is read again, and then what has not been read.
    fn source(&mut self) -> impl BufRead + '_ {
        (&mut self.back).chain(&mut self.input)
    }
}

/// Whether the quotes of a record are open, as in the tables of spreadsheets: one opens at the beginning of a cell, and two
/// within are one.
struct Quotes {
    /// What parts the cells; nothing where quotes mean nothing.
    delimiter: Option<u8>,
    are_open: bool,
    cell_begins: bool,
    was_quote: bool,
}

impl Quotes {
    fn of(delimiter: Option<u8>) -> Quotes {
        Quotes { delimiter, are_open: false, cell_begins: true, was_quote: false }
    }

    /// Reads on.
    fn pass(&mut self, bytes: &[u8]) {
        let Some(delimiter) = self.delimiter else { return };
        let begins_cell = |byte: &u8| *byte == delimiter || matches!(byte, b'\n' | b'\r');
        if !self.are_open && !bytes.contains(&b'"') {
            self.was_quote = false;
            self.cell_begins = bytes.last().map_or(self.cell_begins, begins_cell);
            return;
        }
        for byte in bytes {
            let is_quote = *byte == b'"';
            if self.are_open {
                self.are_open = !is_quote;
            } else if is_quote {
                self.are_open = self.cell_begins || self.was_quote;
            }
            self.was_quote = is_quote && !self.are_open;
            self.cell_begins = begins_cell(byte);
        }
    }
}

/// Do the rows of a table end in carriage returns alone, so that it has one line? These are its first bytes.
pub fn has_lone_returns(begins: &[u8]) -> bool {
    let Some(end) = begins.trim_ascii_start().iter().position(|byte| *byte == b'\r') else { return false };
    let (names, rest) = begins.trim_ascii_start().split_at(end);
    let is_in_quotes = names.iter().filter(|byte| **byte == b'"').count() % 2 == 1;
    !rest.starts_with(b"\r\n") && !rest.trim_ascii().is_empty() && !is_in_quotes && !names.starts_with(b"{")
}

/// How many lines a record ends; most have one, at their end.
fn lines(record: &[u8]) -> usize {
    match record.strip_suffix(b"\n") {
        Some(line) if !line.contains(&b'\n') => 1,
        _ => record.iter().filter(|byte| **byte == b'\n').count(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The texts of all pieces, and the lines of what was left out.
    fn all(input: &[u8]) -> (String, Vec<usize>) {
        let mut pieces = Pieces::new(input);
        pieces.is_table(b',');
        let (mut text, mut broken) = (String::new(), Vec::new());
        while let Some(piece) = pieces.next().unwrap() {
            text.push_str(&piece.text);
            broken.extend(piece.broken.map(|(line, ..)| line));
        }
        (text, broken)
    }

    #[test]
    fn records_are_whole_and_what_is_no_text_is_left_out() {
        for whole in ["", "a,b\nc,d\n", "a,\"b\nc\"\nd", "a,5\" pipe\nb,c\n", "a,\"say \"\"b\nc\"\"\"\nd,e\n"] {
            assert_eq!(all(whole.as_bytes()), (whole.to_owned(), Vec::new()), "{whole:?}");
        }
        assert_eq!(all(b"a,b\nZo\xeb,c\nd,e\n"), ("a,b\nd,e\n".to_owned(), vec![2]));
        let long = [b"a,b\nc,\"".to_vec(), vec![b'x'; LONGEST], b"\nd,e\nf,g\n".to_vec()].concat();
        assert_eq!(all(&long), ("a,b\nd,e\nf,g\n".to_owned(), vec![2]));
        // With its closing quote a long cell is left out whole, whatever rows seem to stand in it.
        for closed in ["\n\"\"d,e\n\",f\n", "\nd,e\n\"\r\n"] {
            let long = [b"a,b\nc,\"".to_vec(), vec![b'x'; LONGEST], closed.into(), b"g,h\n".to_vec()].concat();
            assert_eq!(all(&long), ("a,b\ng,h\n".to_owned(), vec![2]), "{closed:?}");
        }
        // A quote that is never closed swallows no more than that.
        let lines = format!("a,b\nc,\"d\n{}", "e,f\n".repeat(LONGEST / 2));
        let (text, broken) = all(lines.as_bytes());
        assert_eq!(broken, [2]);
        assert!(text.len() > LONGEST / 2, "{}", text.len());
    }

    #[test]
    fn what_was_done_with_a_record_that_is_too_long_is_said() {
        let closed = [b"c,\"".to_vec(), vec![b'x'; LONGEST], b"\nd,e\n\",f\ng,h\n".to_vec()].concat();
        let open = [b"c,\"".to_vec(), vec![b'x'; LONGEST], b"\nd,e\ng,h\n".to_vec()].concat();
        let plain = [vec![b'x'; LONGEST + FURTHER + 9], b"\ng,h\n".to_vec()].concat();
        for (input, said, next) in [
            (closed, "it is left out, and the next row is on line 4", 4),
            (open, "never closed, perhaps; from line 2 on", 2),
            (plain, "from line 2 on rows are read", 2),
        ] {
            let mut pieces = Pieces::new(input.as_slice());
            pieces.is_table(b',');
            let (line, reason, begins) = pieces.next().unwrap().unwrap().broken.unwrap();
            assert!(line == 1 && reason.contains(said) && begins.len() <= SHOWN, "{reason}");
            let rest = pieces.next().unwrap().unwrap();
            assert!(rest.line == next && rest.text.ends_with("g,h\n"), "{}: {}", rest.line, rest.text);
        }
    }

    #[test]
    fn rows_that_end_in_carriage_returns_alone_are_known() {
        for (table, expected) in [
            ("a,b\rc,d\r", true),
            ("\r\ra,b\rc,d", true),
            ("a,b\r\nc,d\r\n", false),
            ("a,b\nc,d\n", false),
            ("a,b\r", false),
            ("a,\"b\rc\"\n", false),
            ("{\"a\": 1}\r{}", false),
        ] {
            assert_eq!(has_lone_returns(table.as_bytes()), expected, "{table:?}");
        }
    }
}
