//! `{25 \over 7}`: TeX's own fraction, whose command stands between its parts.

use super::characters::{CLOSE, Glyph, OPEN};

/// What `\over` leaves behind until its group has been read; nobody can type it.
pub(super) const OVER: char = '\u{f8ff}';

/// The glyphs of a group from a place on with the parts of its `\over` set as a fraction. Outside braces it reaches as
/// far as the next equals sign or comma on either side.
pub(super) fn set(out: &mut Vec<Glyph>, start: usize) {
    let ends = |glyph: &Glyph| matches!(glyph.sign, '=' | '≈' | '<' | '>' | '≤' | '≥' | ',' | ';' | '\n' | '⇒' | '$');
    let Some(over) = (start..out.len()).find(|at| out[*at].sign == OVER) else { return };
    let first = (start..over).rev().find(|at| ends(&out[*at])).map_or(start, |at| at + 1);
    let last = (over..out.len()).find(|at| ends(&out[*at])).unwrap_or(out.len());
    let (above, below) = (part(&out[first..over]), part(&out[over + 1..last]));
    let edge = |sign: char, glyph: Glyph| Glyph { sign, ..glyph };
    let middle = edge('/', out[over]);
    let fraction: Vec<Glyph> =
        [vec![edge(OPEN, out[first])], above, vec![middle], below, vec![edge(CLOSE, out[last - 1])]].concat();
    out.splice(first..last, fraction);
}

/// A part of a fraction without the blanks around it; digits alone need no group.
fn part(glyphs: &[Glyph]) -> Vec<Glyph> {
    let is_blank = |glyph: &Glyph| glyph.sign == ' ';
    let from = glyphs.iter().position(|glyph| !is_blank(glyph)).unwrap_or(glyphs.len());
    let to = glyphs.iter().rposition(|glyph| !is_blank(glyph)).map_or(from, |last| last + 1);
    let inner = &glyphs[from..to];
    match (inner.first(), inner.last()) {
        (Some(first), Some(last)) if !inner.iter().all(|glyph| glyph.sign.is_ascii_digit()) => {
            let (open, close) = (Glyph { sign: OPEN, ..*first }, Glyph { sign: CLOSE, ..*last });
            [vec![open], inner.to_vec(), vec![close]].concat()
        }
        _ => inner.to_vec(),
    }
}
