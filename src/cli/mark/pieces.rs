//! A stream of bytes in pieces of whole records, so that however long it is little of it is held.

use std::io::{self, BufRead, Read};

/// About how many bytes a piece has.
const PIECE: usize = 1 << 15;

/// The longest record that is read; of a longer one only the beginning is kept.
const LONGEST: usize = 1 << 20;

/// How much of a record that is set aside is shown.
const SHOWN: usize = 200;

/// Records of a stream one after another.
pub struct Pieces<R> {
    input: R,
    /// What parts the cells, if it is a table, in which a record may have several lines.
    table: Option<u8>,
    line: usize,
    /// The record that is being read.
    record: Vec<u8>,
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
    TooLong,
    End,
}

impl<R: BufRead> Pieces<R> {
    /// Records that are lines; of a table once [`Pieces::is_table`] says so.
    pub fn new(input: R) -> Pieces<R> {
        Pieces { input, table: None, line: 1, record: Vec::new() }
    }

    /// From here on a record may have line breaks in quotes, cells being parted by this sign.
    pub fn is_table(&mut self, delimiter: u8) {
        self.table = Some(delimiter);
    }

    /// The number of the line that comes next.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The first line that is not empty: its number and its bytes. Of one that is too long the number alone.
    pub fn first(&mut self) -> io::Result<Result<(usize, Vec<u8>), usize>> {
        loop {
            let mut record = Vec::new();
            let line = self.line;
            let read = self.record(&mut record)?;
            self.line += lines(&record);
            if matches!(read, Record::TooLong) {
                return Ok(Err(line));
            }
            if matches!(read, Record::End) || !record.trim_ascii().is_empty() {
                return Ok(Ok((line, record)));
            }
        }
    }

    /// The next piece; nothing at the end.
    pub fn next(&mut self) -> io::Result<Option<Piece>> {
        let mut piece = Piece { line: self.line, ..Piece::default() };
        let mut record = std::mem::take(&mut self.record);
        while piece.text.len() < PIECE {
            record.clear();
            let line = self.line;
            let read = self.record(&mut record)?;
            self.line += lines(&record);
            let begins = |record: &[u8]| String::from_utf8_lossy(&record[..record.len().min(SHOWN)]).into_owned();
            match (read, std::str::from_utf8(&record)) {
                (Record::End, _) if piece.text.is_empty() => return Ok(None),
                (Record::End, _) => break,
                (Record::Whole, Ok(text)) => piece.text.push_str(text),
                (Record::Whole, Err(_)) => {
                    piece.broken = Some((line, "this is not in UTF-8".to_owned(), begins(&record)));
                    break;
                }
                (Record::TooLong, _) => {
                    let reason =
                        format!("this is longer than {LONGEST} bytes: a quote is opened and never closed, perhaps");
                    piece.broken = Some((line, reason, begins(&record)));
                    break;
                }
            }
        }
        self.record = record;
        Ok(Some(piece))
    }

    /// Reads a record. One that is too long is read to the end of a line, and only as much of it kept as shows that it is.
    fn record(&mut self, record: &mut Vec<u8>) -> io::Result<Record> {
        let (mut in_quotes, mut cell_begins, mut was_quote) = (false, true, false);
        loop {
            let start = record.len();
            let room = (LONGEST + 1 - start) as u64;
            if self.input.by_ref().take(room).read_until(b'\n', record)? == 0 {
                return Ok(if record.is_empty() { Record::End } else { Record::Whole });
            }
            if record.len() > LONGEST {
                if !record.ends_with(b"\n") && self.input.skip_until(b'\n')? > 0 {
                    self.line += 1;
                }
                return Ok(Record::TooLong);
            }
            let Some(delimiter) = self.table else { return Ok(Record::Whole) };
            if !in_quotes && !record[start..].contains(&b'"') {
                return Ok(Record::Whole);
            }
            for byte in &record[start..] {
                // As in the tables of spreadsheets: a quote opens at the beginning of a cell, and two within are one.
                let is_quote = *byte == b'"';
                if in_quotes {
                    in_quotes = !is_quote;
                } else if is_quote {
                    in_quotes = cell_begins || was_quote;
                }
                was_quote = is_quote && !in_quotes;
                cell_begins = *byte == delimiter || *byte == b'\n';
            }
            if !in_quotes {
                return Ok(Record::Whole);
            }
        }
    }
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
        // A quote that is never closed swallows no more than that.
        let lines = format!("a,b\nc,\"d\n{}", "e,f\n".repeat(LONGEST / 2));
        let (text, broken) = all(lines.as_bytes());
        assert_eq!(broken, [2]);
        assert!(text.len() > LONGEST / 2, "{}", text.len());
    }
}
