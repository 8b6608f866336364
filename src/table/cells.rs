//! Cells of a table that a spreadsheet opens: no text of a student is ever run as a formula.

use std::borrow::Cow;

/// A cell as it is written. One that begins like a formula gets an apostrophe in front; a number keeps its sign.
///
/// Characters that command a terminal or turn the direction of writing are left out; line breaks within a cell stay.
///
/// ```
/// use carom::table::harmless;
/// assert_eq!(harmless("=HYPERLINK(\"x\")"), "'=HYPERLINK(\"x\")");
/// assert_eq!(harmless("-1.92"), "-1.92");
/// assert_eq!(harmless("-1.92u"), "'-1.92u");
/// ```
pub fn harmless(text: &str) -> Cow<'_, str> {
    // As most cells are: letters, digits and signs that no spreadsheet minds.
    let is_plain = |byte: u8| matches!(byte, b' '..=b'~');
    let begins_plainly = !matches!(text.as_bytes().first(), Some(b' ' | b'=' | b'+' | b'-' | b'@'));
    if begins_plainly && text.bytes().all(is_plain) {
        return Cow::Borrowed(text);
    }
    let is_shown = |c: char| !is_hidden(c) || c == '\n';
    let text = match text.chars().all(is_shown) {
        true => Cow::Borrowed(text),
        false => {
            let shown = |c: char| if matches!(c, '\t' | '\r') { Some(' ') } else { is_shown(c).then_some(c) };
            // What began with a tab or a return still begins with a blank.
            Cow::Owned(text.chars().filter_map(shown).collect())
        }
    };
    // Some programs take the wide forms of these signs for the signs, and some skip blanks before them.
    let begins = |sign: char| matches!(sign, '=' | '+' | '-' | '@' | '＝' | '＋' | '－' | '＠');
    match text.trim_start().starts_with(begins) && !is_number(&text) {
        true => Cow::Owned(format!("'{text}")),
        false => text,
    }
}

/// What stood in a cell before [`harmless`] put an apostrophe in front; or what is in the quotes of a formula by which a
/// spreadsheet keeps the noughts of a number.
///
/// ```
/// use carom::table::{harmless, meant};
/// assert_eq!(meant(&harmless("=1+1")), "=1+1");
/// assert_eq!(meant("=\"0012\""), "0012");
/// assert_eq!(meant("'Ada'"), "'Ada'");
/// ```
pub fn meant(cell: &str) -> &str {
    let quoted = cell.strip_prefix("=\"").and_then(|rest| rest.strip_suffix('"'));
    if let Some(text) = quoted.filter(|text| !text.contains('"')) {
        return text;
    }
    cell.strip_prefix('\'').filter(|text| harmless(text) == cell).unwrap_or(cell)
}

/// A text on one line, without characters that command a terminal or turn the direction of writing.
///
/// ```
/// assert_eq!(carom::table::visible(" Ada\u{202e}\n Lovelace"), "Ada Lovelace");
/// ```
pub fn visible(text: &str) -> String {
    one_line(text).chars().filter(|c| !is_hidden(*c)).collect::<String>().trim().to_owned()
}

/// Digits, perhaps with a sign in front and a point among them.
fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.') && digits.parse::<f64>().is_ok()
}

fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// A table with a header, every cell harmless, in quotes where it must be.
pub fn write<const N: usize>(header: [&str; N], rows: impl Iterator<Item = [String; N]>) -> String {
    append(std::iter::once(header.map(str::to_owned)).chain(rows))
}

/// The rows of a table, all of one width, whose header is written already or is the first of them.
pub fn append(rows: impl Iterator<Item = impl AsRef<[String]>>) -> String {
    let mut text = String::new();
    for row in rows {
        for (place, cell) in row.as_ref().iter().enumerate() {
            text.push_str(if place == 0 { "" } else { "," });
            push_cell(&mut text, cell);
        }
        text.push('\n');
    }
    text
}

/// Adds a cell to a row of several: harmless, in quotes where it must be.
pub fn push_cell(row: &mut String, cell: &str) {
    let cell = harmless(cell);
    if cell.contains([',', '"', '\n', '\r']) {
        row.push('"');
        row.push_str(&cell.replace('"', "\"\""));
        row.push('"');
    } else {
        row.push_str(&cell);
    }
}

/// A text on one line.
pub fn one_line(text: &str) -> String {
    let is_plain = |byte: u8| matches!(byte, b' '..=b'~');
    if text.bytes().all(is_plain) && !text.starts_with(' ') && !text.ends_with(' ') && !text.contains("  ") {
        return text.to_owned();
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_in_quotes_where_a_reader_of_tables_needs_them() {
        let cells =
            ["", "2.78", "a,b", "say \"b\"", "two\nlines", "=1+1", " =1", "'", "4√39/9", "\tx", "a  b", "x\u{202e}y"];
        for one in cells {
            for other in cells {
                let row = [one.to_owned(), other.to_owned()];
                let mut by_csv = csv::Writer::from_writer(Vec::new());
                by_csv.write_record(row.each_ref().map(|cell| harmless(cell).into_owned())).unwrap();
                let text = append(std::iter::once(row.clone()));
                assert_eq!(text.as_bytes(), by_csv.into_inner().unwrap());
                let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
                let read = reader.records().next().map(Result::unwrap).unwrap_or_default();
                assert_eq!(read.iter().collect::<Vec<_>>(), row.each_ref().map(|cell| harmless(cell).into_owned()));
            }
        }
    }

    #[test]
    fn what_is_plain_is_left_as_it_is() {
        for (text, line) in
            [("a b", "a b"), (" a", "a"), ("a  b", "a b"), ("a\u{2003}b ", "a b"), ("", ""), ("~ ~", "~ ~")]
        {
            assert_eq!(one_line(text), line);
        }
        for (text, cell) in
            [(" -1", "' -1"), (" -x", "' -x"), ("-1", "-1"), ("a\u{7f}", "a"), ("@", "'@"), ("＝", "'＝")]
        {
            assert_eq!(harmless(text), cell);
        }
    }
}
