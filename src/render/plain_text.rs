//! Plain text set to a line length: words wrapped, columns aligned, formulas kept whole.
//!
//! A template says in which order things stand; how wide they come out is known only here.
//!
//! - A line that is too long goes on below, as far to the right as it began.
//! - `¦` begins a column and `¦¦` one whose text stands at the column's right; if that is the last one, it ends at the
//!   right margin, on the last line of its row. Rows up to the next empty line share their columns, and so does what
//!   is above and below a row of `¦` alone, which is an empty line in print. Spaces beside the bars are kept.
//! - `¶` ends a line within a paragraph or a column.
//! - If a row is too long its widest columns give way.
//! - A line of `─` is drawn as long as a line is.

/// What parts columns.
pub(super) const BAR: char = '¦';

/// The end of a line within a paragraph or a column.
pub(super) const BREAK: char = '¶';

/// A space at which no line ends: those within formulas.
pub(super) const TIE: char = '\u{a0}';

/// The page, set to the line length; without one, as its template has it.
pub(super) fn set(page: &str, line_length: Option<usize>) -> String {
    let set = match line_length {
        Some(length) => set_to(page, length),
        None => page.replace(BREAK, "\n"),
    };
    set.replace(TIE, " ")
}

fn set_to(page: &str, length: usize) -> String {
    let lines: Vec<&str> = page.lines().map(|line| line.trim_end_matches(' ')).collect();
    let mut out = String::new();
    for block in lines.split(|line| line.is_empty()).filter(|block| !block.is_empty()) {
        if !out.is_empty() {
            out.push('\n');
        }
        for line in set_block(block, length) {
            out.push_str(line.trim_end_matches([' ', TIE]));
            out.push('\n');
        }
    }
    out
}

/// Lines without an empty one between them.
fn set_block(block: &[&str], length: usize) -> Vec<String> {
    let rows: Vec<Vec<Cell>> = block.iter().map(|line| cells(line)).collect();
    let mut natural: Vec<usize> = Vec::new();
    for (column, cell) in rows.iter().filter(|row| row.len() > 1).flat_map(|row| row.iter().enumerate()) {
        natural.resize(natural.len().max(column + 1), 0);
        natural[column] = natural[column].max(cell.width());
    }
    let widths = fitted(&natural, length);
    let mut out = Vec::new();
    for row in rows {
        match row.as_slice() {
            [only] if !only.text.is_empty() && only.text.chars().all(|letter| letter == '─') => {
                out.push("─".repeat(length));
            }
            [only] => out.extend(set_row(&[only.clone()], &[length], length)),
            cells => out.extend(set_row(cells, &widths, length)),
        }
    }
    out
}

/// What stands in a column of a row.
#[derive(Clone, Debug)]
struct Cell {
    text: String,
    /// Does it stand at the right of its column?
    pushed: bool,
}

impl Cell {
    /// The text, and how many spaces are kept free to the right of it.
    fn text(&self) -> (&str, usize) {
        let text = self.text.trim_end_matches(' ');
        (text.trim_end_matches([' ', BREAK]), self.text.len() - text.len())
    }

    fn width(&self) -> usize {
        let (text, gap) = self.text();
        text.split(BREAK).map(|line| wide(line) + gap).max().unwrap_or(0)
    }
}

fn wide(text: &str) -> usize {
    text.chars().count()
}

fn cells(line: &str) -> Vec<Cell> {
    let mut cells = Vec::new();
    let mut rest = line;
    let mut pushed = false;
    if let Some(after) = rest.strip_prefix("¦¦") {
        (pushed, rest) = (true, after);
    }
    while let Some((text, after)) = rest.split_once(BAR) {
        cells.push(Cell { text: text.to_owned(), pushed });
        pushed = after.starts_with(BAR);
        rest = after.strip_prefix(BAR).unwrap_or(after);
    }
    cells.push(Cell { text: rest.to_owned(), pushed });
    cells
}

/// The widths of columns within the line: the widest give way, as much as they must.
fn fitted(natural: &[usize], length: usize) -> Vec<usize> {
    let under = |cap: usize| natural.iter().map(move |width| *width.min(&cap));
    let cap = (1..=length).rev().find(|cap| under(*cap).sum::<usize>() <= length).unwrap_or(1);
    under(cap).collect()
}

fn set_row(cells: &[Cell], widths: &[usize], length: usize) -> Vec<String> {
    let mut columns: Vec<(usize, usize, Vec<String>)> = Vec::new();
    let mut start = 0;
    for (place, (cell, width)) in cells.iter().zip(widths).enumerate() {
        let at_margin = cell.pushed && place + 1 == cells.len();
        let width = if at_margin { length.saturating_sub(start) } else { *width };
        let (text, gap) = cell.text();
        let lines = wrapped(text, width.saturating_sub(gap));
        let pad = |line: String| {
            if cell.pushed { format!("{line:>0$}{1:2$}", width.saturating_sub(gap), "", gap) } else { line }
        };
        columns.push((start, usize::from(at_margin), lines.into_iter().map(pad).collect()));
        start += width;
    }
    let height = columns.iter().map(|(.., lines)| lines.len()).max().unwrap_or(0);
    let mut out = vec![String::new(); height];
    for (start, at_margin, lines) in columns {
        let first = at_margin * (height - lines.len());
        for (row, line) in out[first..].iter_mut().zip(lines) {
            let gap = start.saturating_sub(wide(row));
            row.extend(std::iter::repeat_n(' ', gap));
            row.push_str(&line);
        }
    }
    out
}

/// The text in lines of the width, or longer ones where a formula cannot be parted.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut out = Vec::new();
    for line in text.split(BREAK) {
        let body = line.trim_start_matches(' ');
        let indent = line.len() - body.len();
        let room = width.saturating_sub(indent);
        let mut set = String::new();
        for word in body.split(' ').filter(|word| !word.is_empty()).flat_map(|word| parted(word, room)) {
            if !set.is_empty() && wide(&set) + 1 + wide(word) > room {
                out.push(" ".repeat(indent) + &set);
                set.clear();
            }
            if !set.is_empty() {
                set.push(' ');
            }
            set.push_str(word);
        }
        out.push(" ".repeat(indent) + &set);
    }
    out
}

/// A word that is wider than the room, a formula, is parted before its signs: those outside brackets, and if that is
/// not enough, those within.
fn parted(word: &str, room: usize) -> Vec<&str> {
    if wide(word) <= room {
        return vec![word];
    }
    let outside = at_signs(word, false);
    outside
        .into_iter()
        .flat_map(|piece| if wide(piece) <= room { vec![piece] } else { at_signs(piece, true) })
        .collect()
}

/// A formula parted before its signs.
fn at_signs(formula: &str, within_brackets: bool) -> Vec<&str> {
    let mut pieces = Vec::new();
    let (mut begin, mut depth) = (0, 0_usize);
    for (at, letter) in formula.char_indices() {
        match letter {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            TIE if depth == 0 || within_brackets => {
                let after = &formula[at + TIE.len_utf8()..];
                if after.starts_with(['+', '−', '=', '≠', '<', '≤', '>', '≥', '⇒', '≈']) {
                    pieces.push(&formula[begin..at]);
                    begin = formula.len() - after.len();
                }
            }
            _ => {}
        }
    }
    pieces.push(&formula[begin..]);
    pieces
}
