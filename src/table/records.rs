//! A table with a header, as spreadsheets save it: commas, semicolons or tabs, cells in quotes with line breaks in them.

use csv::{ReaderBuilder, StringRecord};

use crate::diagnostic::{Diagnostic, Severity, Source, near};

/// A record. Columns that the table does not have are empty.
pub struct Record<'r, const N: usize> {
    /// The line on which it begins, from 1.
    pub line: usize,
    /// Its place in the text.
    pub start: usize,
    /// The cells, in the order of the columns that were asked for.
    pub cells: [&'r str; N],
    /// Why its cells cannot be trusted.
    pub fault: Option<String>,
}

/// Reads a table: hands its records on one by one, and says which columns look like one that was asked for and are not.
///
/// # Errors
///
/// A header that lacks a column which is needed, or has one twice.
pub fn read<const N: usize>(
    source: &Source,
    columns: &[&'static str; N],
    needed: &[&str],
    mut take: impl FnMut(Record<N>),
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let text = &*source.text;
    let mut reader =
        ReaderBuilder::new().flexible(true).has_headers(false).delimiter(delimiter(text)).from_reader(text.as_bytes());
    let mut record = StringRecord::new();
    // Reading from memory text that is UTF-8 cannot fail; the end of it is all that stops the loop.
    let mut next = |record: &mut StringRecord| reader.read_record(record).unwrap_or(false);
    // A text without any record has a header without names.
    next(&mut record);
    // A first line `sep=;` is for the spreadsheet.
    if header_start(text) > text.len() - text.trim_start().len() {
        next(&mut record);
    }
    let header = Header::read(source, &record, columns, needed)?;
    let end = text.trim_end().len();
    while next(&mut record) {
        if record.iter().all(|cell| cell.trim().is_empty()) {
            continue;
        }
        let (line, start) = begin(text, &record);
        let cell = |place: Option<usize>| place.and_then(|place| record.get(place)).unwrap_or_default();
        let cells = header.places.map(cell);
        let is_open = never_closed(&text[start.min(end)..end], &record);
        let fault = match (header.fault(&record), is_open) {
            // A row that is short for want of a quote at its end lacks the quote, and not the cells.
            (Some(short), false) => Some(short),
            (None, true) if !record.as_slice().contains('\n') => None,
            (_, is_open) => is_open
                .then(|| "a quote is opened here and never closed, so that all that follows is part of it".to_owned()),
        };
        take(Record { line, start, cells, fault });
    }
    Ok(header.warnings)
}

/// The line and the place in the text where a record begins: the reader counts empty lines before it as its own, and what
/// is left of the end of the line above.
fn begin(text: &str, record: &StringRecord) -> (usize, usize) {
    let (line, start) = record.position().map_or((1, 0), |place| (place.line() as usize, place.byte() as usize));
    let rest = text.get(start..).unwrap_or_default();
    // As nearly all begin.
    if !rest.starts_with(['\n', '\r']) {
        return (line, start);
    }
    let ends = rest.len() - rest.trim_start_matches(['\n', '\r']).len();
    (line + rest[..ends].matches('\n').count(), start + ends)
}

/// What parts the cells of the header.
pub fn delimiter(text: &str) -> u8 {
    let header = text[header_start(text)..].lines().next().unwrap_or_default();
    let count = |sign: u8| header.bytes().filter(|byte| *byte == sign).count();
    // Of equally many the last would be taken; a table of one column has commas.
    [b'\t', b';', b','].into_iter().max_by_key(|sign| count(*sign)).unwrap_or(b',')
}

/// Where the names of the columns begin: after empty lines, and after a line `sep=;`, by which spreadsheets are told.
fn header_start(text: &str) -> usize {
    let rest = text.trim_start();
    let first = rest.lines().next().unwrap_or_default();
    let told = first.get(..4).is_some_and(|word| word.eq_ignore_ascii_case("sep=")) && first.trim_end().len() <= 5;
    let rest = if told { rest[first.len()..].trim_start() } else { rest };
    text.len() - rest.len()
}

struct Header<const N: usize> {
    /// Where each column stands, if it does.
    places: [Option<usize>; N],
    /// How far a record must reach.
    least: usize,
    /// How many columns there are.
    width: usize,
    warnings: Vec<Diagnostic>,
}

impl<const N: usize> Header<N> {
    fn read(
        source: &Source,
        record: &StringRecord,
        columns: &[&'static str; N],
        needed: &[&str],
    ) -> Result<Header<N>, Vec<Diagnostic>> {
        let names: Vec<String> = record.iter().map(|name| name.trim().to_lowercase()).collect();
        let start = header_start(&source.text);
        let end = start + source.text[start..].lines().next().map_or(0, str::len);
        let mut faults = Vec::new();
        let mut warnings = Vec::new();
        let missing: Vec<&str> = needed.iter().copied().filter(|name| !names.iter().any(|n| n == name)).collect();
        let strangers = || names.iter().map(String::as_str).filter(|name| !columns.contains(name));
        let at = |name: &str| {
            let place = source.text[start..end].to_lowercase().find(name).map_or(start, |place| start + place);
            place..(place + name.len()).min(end)
        };
        if let [first, ..] = missing[..] {
            let message = match missing[..] {
                [one] => format!("no column `{one}`"),
                _ => format!("no columns {}", quoted(&missing)),
            };
            let label = format!("the first line names the columns: {}", columns.join(","));
            let fault = Diagnostic::new(message, source, start..end, label);
            // A whole line that begins with a name has other signs between its cells, and is no misspelling of it.
            let near = near(first, strangers()).filter(|near| near.len() < 2 * first.len());
            faults.push(match near {
                Some(near) => {
                    let label = format!("`{first}` is meant, perhaps");
                    Diagnostic { span: at(near), label, ..fault }.with_help(format!("write `{first}` for `{near}`"))
                }
                None if start == end => fault.with_help("the file is empty: was it saved?"),
                None => fault.with_help(format!("write {} in the first line, above the rows", quoted(&missing))),
            });
        }
        for (place, name) in names.iter().enumerate() {
            if columns.contains(&name.as_str()) && names[..place].contains(name) {
                let label = "which of them counts?";
                let fault = Diagnostic::new(format!("two columns `{name}`"), source, at(name), label);
                faults.push(fault.with_help("give one of them another name, or take it out"));
            }
        }
        for name in strangers() {
            let absent = columns.iter().copied().filter(|column| !names.iter().any(|name| name == column));
            if let Some(near) = near(name, absent) {
                let fault = Diagnostic::new(
                    format!("nobody looks at the column `{name}`"),
                    source,
                    at(name),
                    "not a column that carom knows",
                );
                warnings.push(Diagnostic { severity: Severity::Warning, ..fault.with_near(Some(near)) });
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let places = columns.map(|column| names.iter().position(|name| name == column));
        let reach = needed.iter().filter_map(|column| names.iter().position(|name| name == column));
        Ok(Header { places, least: reach.max().map_or(0, |place| place + 1), width: names.len(), warnings })
    }

    /// Cells too few or too many.
    fn fault(&self, record: &StringRecord) -> Option<String> {
        let beyond = || record.iter().skip(self.width).any(|cell| !cell.trim().is_empty());
        if record.len() > self.width && beyond() {
            return Some(format!(
                "{} cells under {} columns: a cell with a comma in it stands in quotes",
                record.len(),
                self.width
            ));
        }
        (record.len() < self.least).then(|| format!("the row ends after {} of {} cells", record.len(), self.width))
    }
}

/// Is it the last record, with a quote that is opened and never closed? That swallows all that follows, of which the blanks
/// at its end are left out here.
fn never_closed(rest: &str, record: &StringRecord) -> bool {
    // Only the last record reaches to the end of the text.
    let is_last = record.as_slice().len() + record.len() + 2 >= rest.len();
    let is_odd = || rest.bytes().filter(|byte| *byte == b'"').count() % 2 == 1;
    is_last && is_odd()
}

fn quoted(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_tells_spreadsheets_what_parts_cells_is_no_header() {
        for (text, places) in [
            ("sep=;\nname;age\nAda;1\n", vec![(3, "Ada".to_owned())]),
            ("sep=,\r\nname,age\r\nAda,1\r\n", vec![(3, "Ada".to_owned())]),
            ("name,age\nsep=,1\n", vec![(2, "sep=".to_owned())]),
        ] {
            let mut found = Vec::new();
            let take = |record: Record<2>| found.push((record.line, record.cells[0].to_owned()));
            read(&Source::new("table.csv", text), &["name", "age"], &["name"], take)
                .map_err(|faults| faults.len())
                .unwrap();
            assert_eq!(found, places, "{text:?}");
        }
    }

    #[test]
    fn carom_knows_on_which_line_a_record_begins() {
        for text in [
            "name,age\nAda,1\nBen,2\n\n\nCy,3",
            "name,age\r\nAda,1\r\nBen,2\r\n\r\n\r\nCy,3\r\n",
            "name,age\nAda,\"1\"\nBen,\"\n\n\"\nCy,3\n",
        ] {
            let source = Source::new("table.csv", text);
            let mut places: Vec<(usize, bool)> = Vec::new();
            let take =
                |record: Record<2>| places.push((record.line, text[record.start..].starts_with(record.cells[0])));
            read(&source, &["name", "age"], &["name"], take).map_err(|faults| faults.len()).unwrap();
            assert_eq!(places, [(2, true), (3, true), (6, true)], "{text:?}");
        }
    }
}
