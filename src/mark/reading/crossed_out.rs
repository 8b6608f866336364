//! What is crossed out: `~~3.08~~ 2.78`, or with a stroke through each sign. It counts only if nothing stands in its place.

use super::characters::Glyph;

/// The stroke through the sign before it.
pub(super) const STROKE: char = '\u{336}';

/// The signs without those that are crossed out, or without the strokes alone if nothing else would be left.
pub(super) fn without_crossed_out(glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let is_wave = |at: usize| glyphs[at..].len() > 1 && glyphs[at].sign == '~' && glyphs[at + 1].sign == '~';
    let mut strokes = vec![false; glyphs.len()];
    let mut crossed = vec![false; glyphs.len()];
    let mut at = 0;
    while at < glyphs.len() {
        if glyphs[at].sign == STROKE {
            strokes[at] = true;
            // A sign such as `½` is several here.
            let under = glyphs[..at].iter().rposition(|glyph| glyph.sign != STROKE).map(|under| glyphs[under].place);
            for before in (0..at).rev().take_while(|before| Some(glyphs[*before].place) == under) {
                crossed[before] = true;
            }
        } else if is_wave(at)
            && let Some(end) = (at + 3..glyphs.len()).find(|end| is_wave(*end))
        {
            strokes[at..at + 2].fill(true);
            crossed[at + 2..end].fill(true);
            strokes[end..end + 2].fill(true);
            at = end + 1;
        }
        at += 1;
    }
    let is_left = |at: usize| !crossed[at] && !strokes[at] && glyphs[at].sign.is_alphanumeric();
    let is_replaced = (0..glyphs.len()).any(is_left);
    let is_dropped = |at: usize| strokes[at] || (is_replaced && crossed[at]);
    (0..glyphs.len()).filter(|at| !is_dropped(*at)).map(|at| glyphs[at]).collect()
}
