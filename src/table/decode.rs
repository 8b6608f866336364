//! From bytes to text: UTF-8 and nothing else, and a clear word where it is something else.

/// Why bytes are not read as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Undecoded {
    /// What they seem to be.
    pub message: String,
    /// What to do about it.
    pub help: String,
}

/// The text of a file, without the mark with which some programs begin it.
///
/// ```
/// use carom::table::decode;
/// assert_eq!(decode(b"\xef\xbb\xbfstudent"), Ok("student"));
/// assert!(decode(b"\xff\xfes\0t\0").unwrap_err().message.contains("UTF-16"));
/// assert!(decode(b"PK\x03\x04...").unwrap_err().message.contains("a workbook"));
/// assert!(decode(b"Zo\xeb").unwrap_err().message.contains("line 1"));
/// assert!(decode(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR").unwrap_err().message.contains("no text"));
/// ```
pub fn decode(bytes: &[u8]) -> Result<&str, Undecoded> {
    let help = "save it as UTF-8: in Excel as `CSV UTF-8`, in LibreOffice with the character set `Unicode (UTF-8)`";
    let undecoded = |message: String| Undecoded { message, help: help.to_owned() };
    if let Some((_, kind)) = NO_TEXT.iter().find(|(begins, _)| bytes.starts_with(begins)) {
        return Err(undecoded(format!("is {kind}, and no text")));
    }
    if is_utf_16(bytes) {
        return Err(undecoded("is in UTF-16, not in UTF-8".to_owned()));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(_) if bytes.iter().any(|byte| is_of_no_text(*byte)) => Err(Undecoded {
            message: "is no text: it has bytes that stand in none, as pictures and programs have them".to_owned(),
            help: "look at its name, and give the file that you mean: a `key.json`, or a table saved as CSV".to_owned(),
        }),
        Err(error) => {
            let line = 1 + bytes[..error.valid_up_to()].iter().filter(|byte| **byte == b'\n').count();
            Err(undecoded(format!("is not in UTF-8: line {line} has a letter in another encoding, Latin-1 perhaps")))
        }
    }
}

/// How files begin that people give in place of the text they were to save, and what they are.
const NO_TEXT: [(&[u8], &str); 3] = [
    (b"PK\x03\x04", "a workbook of a spreadsheet program, or something else that is packed"),
    (b"\xd0\xcf\x11\xe0", "a workbook of a spreadsheet program"),
    (b"%PDF-", "a PDF"),
];

/// A control character that is in no text of any encoding.
fn is_of_no_text(byte: u8) -> bool {
    matches!(byte, 0..=8 | 14..=26 | 28..=31)
}

/// By its mark, or since every other byte of its beginning is nought.
fn is_utf_16(bytes: &[u8]) -> bool {
    let begins = &bytes[..bytes.len().min(64)];
    let noughts = |first: usize| begins.len() > 7 && begins.iter().skip(first).step_by(2).all(|byte| *byte == 0);
    bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) || noughts(0) || noughts(1)
}
