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
    let mut widths = natural(&rows, length);
    if widths.iter().sum::<usize>() > length {
        widths = fitted(&natural(&rows, standing_out(length)), length);
    }
    let mut out = Vec::new();
    for row in rows {
        match row.as_slice() {
            [only] if !only.text.is_empty() && only.text.chars().all(|letter| letter == '─') => {
                out.push("─".repeat(length));
            }
            [only] => out.extend(set_row(std::slice::from_ref(only), &[length], length)),
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

/// How wide each column would be, leaving out texts pushed to the right that are wider than `most`.
fn natural(rows: &[Vec<Cell>], most: usize) -> Vec<usize> {
    let mut widths: Vec<usize> = Vec::new();
    for row in rows.iter().filter(|row| row.len() > 1) {
        widths.resize(widths.len().max(row.len()), 0);
        for (place, (width, cell)) in widths.iter_mut().zip(row).enumerate() {
            let last = place + 1 == row.len();
            if !cell.pushed || last || cell.width() <= most {
                *width = cell.width().max(*width);
            }
        }
    }
    widths
}

/// Of a line that is too short for all, a text pushed to the right may have this much; one that is wider, as the left
/// side of a long equation, stands out of its column.
fn standing_out(length: usize) -> usize {
    length * 2 / 5
}

/// The widths of columns within the line: the widest give way, as much as they must.
fn fitted(natural: &[usize], length: usize) -> Vec<usize> {
    let under = |cap: usize| natural.iter().map(move |width| *width.min(&cap));
    let cap = (1..=length).rev().find(|cap| under(*cap).sum::<usize>() <= length).unwrap_or(1);
    under(cap).collect()
}

/// The widths of the columns in one row: what stands out of its column takes its room from the others.
fn in_row(cells: &[Cell], widths: &[usize], length: usize) -> Vec<usize> {
    let own = |(place, cell): (usize, &Cell)| {
        let stands_out = cell.pushed && place + 1 < cells.len() && cell.width() > widths[place];
        if stands_out { cell.width() } else { 0 }
    };
    let standing_out: Vec<usize> = cells.iter().enumerate().map(own).collect();
    let others: Vec<usize> =
        widths.iter().zip(&standing_out).map(|(width, own)| if *own > 0 { 0 } else { *width }).collect();
    let others = match standing_out.iter().sum() {
        0 => others,
        taken => fitted(&others, length.saturating_sub(taken)),
    };
    others.iter().zip(standing_out).map(|(other, own)| other + own).collect()
}

fn set_row(cells: &[Cell], widths: &[usize], length: usize) -> Vec<String> {
    let mut columns: Vec<(usize, usize, Vec<String>)> = Vec::new();
    let mut start = 0;
    for (place, (cell, width)) in cells.iter().zip(&in_row(cells, widths, length)).enumerate() {
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
        // A line does not end with the sign between two forms of an answer.
        let body = body.replace("≈ ", "≈\u{a0}");
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

/// A word that is wider than the room is a formula: it is parted before its signs, those outside brackets first.
fn parted(word: &str, room: usize) -> Vec<&str> {
    let mut pieces = vec![word];
    for brackets in 0..4 {
        let fits = |piece: &&str| wide(piece) <= room;
        if pieces.iter().all(fits) {
            break;
        }
        let within = |piece| if fits(&piece) { vec![piece] } else { at_signs(piece, brackets) };
        pieces = pieces.into_iter().flat_map(within).collect();
    }
    pieces
}

/// A formula parted before the signs that stand within so many brackets or fewer.
fn at_signs(formula: &str, brackets: usize) -> Vec<&str> {
    let mut pieces = Vec::new();
    let (mut begin, mut depth) = (0, 0_usize);
    for (at, letter) in formula.char_indices() {
        match letter {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            TIE if depth <= brackets => {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn tied(text: &str) -> String {
        text.replace('~', "\u{a0}")
    }

    #[test]
    fn lines_are_wrapped_as_far_to_the_right_as_they_began() {
        let cases = [
            ("one two three", 9, "one two\nthree\n"),
            ("  one two three", 9, "  one two\n  three\n"),
            ("one~two three", 9, "one two\nthree\n"),
            ("the mass is 2~kg", 15, "the mass is\n2 kg\n"),
            ("a\n\n\n\nb   \n\n", 9, "a\n\nb\n"),
            ("unbreakable", 4, "unbreakable\n"),
            ("Show that¶    x~=~1¶", 20, "Show that\n    x = 1\n"),
            ("──", 5, "─────\n"),
            ("", 5, ""),
        ];
        for (page, length, expected) in cases {
            assert_eq!(set(&tied(page), Some(length)), expected, "{page}");
        }
        assert_eq!(set(&tied("a long line, 2~kg¶end"), None), "a long line, 2 kg\nend");
    }

    #[test]
    fn a_formula_is_parted_only_if_it_must_be_and_outside_its_brackets_first() {
        let formula = tied("w~=~4(u~+~v)~+~2(u~−~v)");
        assert_eq!(parted(&formula, 30), [formula.as_str()]);
        assert_eq!(parted(&formula, 12), ["w", "=~4(u~+~v)", "+~2(u~−~v)"].map(tied));
        assert_eq!(parted(&tied("(u~+~v)~+~(u~+~(v~+~w))"), 10), ["(u~+~v)", "+~(u", "+~(v~+~w))"].map(tied));
        assert_eq!(set(&tied("so w~=~1 and v~=~2"), Some(8)), "so w = 1\nand\nv = 2\n");
    }

    #[test]
    fn columns_are_as_wide_as_what_stands_in_them() {
        let cases = [
            // equations, aligned at the relation, with a number at the margin
            ("¦¦2v~+~3w ¦= ¦6¦¦(1)\nSo\n¦¦v ¦= ¦3¦¦", 16, "2v + 3w = 6  (1)\nSo\n      v = 3\n"),
            // a part with its marks on its last line
            ("(a) ¦Find the speed. ¦¦(4)", 16, "(a) Find the\n    speed.   (4)\n"),
            // the widest column gives way; an empty row keeps the columns
            ("ab cd ef gh ¦M1 ¦x\n¦\nab ¦A1 ¦yy", 11, "ab cd M1 x\nef gh\n\nab    A1 yy\n"),
            // an empty line ends them
            ("long ¦x\n\na ¦y", 20, "long x\n\na y\n"),
            ("a¦¦b", 5, "a   b\n"),
            ("¦¦b", 5, "    b\n"),
        ];
        for (page, length, expected) in cases {
            assert_eq!(set(&tied(page), Some(length)), expected, "{page}");
        }
    }

    #[test]
    fn no_length_and_no_text_is_too_much() {
        for page in ["", "¦", "¦¦", "¦¦¦¦", "a¦¦¦b¦¦c d e", "¶¶ ¶", "(((~+~", "¦¶¦¦¶a", "─¦─"]
        {
            for length in [0, 1, 2, 7] {
                set(&tied(page), Some(length));
            }
        }
    }
}
