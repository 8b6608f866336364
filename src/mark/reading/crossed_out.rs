//! What is crossed out: `~~3.08~~ 2.78`, `\cancel{3.08} 2.78`, or with a stroke through each sign. It counts only if nothing
//! stands in its place.

use super::characters::{self, Glyph};

/// The stroke through the sign before it.
pub(super) const STROKE: char = '\u{336}';

/// Commands of LaTeX that cross out what stands in the braces after them.
const COMMANDS: [&str; 6] = ["cancel", "bcancel", "xcancel", "sout", "xout", "st"];

/// What crosses out, and what is crossed out.
struct Struck<'a> {
    glyphs: &'a [Glyph],
    strokes: Vec<bool>,
    crossed: Vec<bool>,
}

/// The signs without those that are crossed out, or without the strokes alone if nothing else would be left.
pub(super) fn without_crossed_out(glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let struck = Struck::of(&glyphs);
    let is_replaced = struck.is_replaced();
    let is_dropped = |at: usize| struck.strokes[at] || (is_replaced && struck.crossed[at]);
    (0..glyphs.len()).filter(|at| !is_dropped(*at)).map(|at| glyphs[at]).collect()
}

/// Is all that is said crossed out, and nothing in its place?
pub(super) fn is_withdrawn(text: &str) -> bool {
    let Ok(glyphs) = characters::glyphs(text) else { return false };
    let struck = Struck::of(&glyphs);
    struck.crossed.contains(&true) && !struck.is_replaced()
}

impl<'a> Struck<'a> {
    fn of(glyphs: &'a [Glyph]) -> Struck<'a> {
        let mut struck = Struck { glyphs, strokes: vec![false; glyphs.len()], crossed: vec![false; glyphs.len()] };
        let mut at = 0;
        while at < glyphs.len() {
            at = struck.from(at);
        }
        struck
    }

    /// Marks what is crossed out from a sign on, and goes to the sign after it.
    fn from(&mut self, at: usize) -> usize {
        let glyphs = self.glyphs;
        let is_wave = |at: usize| glyphs[at..].len() > 1 && glyphs[at].sign == '~' && glyphs[at + 1].sign == '~';
        match glyphs[at].sign {
            STROKE => {
                self.strokes[at] = true;
                // A sign such as `½` is several here.
                let under =
                    glyphs[..at].iter().rposition(|glyph| glyph.sign != STROKE).map(|under| glyphs[under].place);
                for before in (0..at).rev().take_while(|before| Some(glyphs[*before].place) == under) {
                    self.crossed[before] = true;
                }
            }
            '~' if is_wave(at) => {
                if let Some(end) = (at + 3..glyphs.len()).find(|end| is_wave(*end)) {
                    self.strike(at, at + 2, end, end + 2);
                    return end + 2;
                }
            }
            '\\' => {
                if let Some((open, close)) = self.command(at) {
                    self.strike(at, open + 1, close, close + 1);
                    return close + 1;
                }
            }
            _ => {}
        }
        at + 1
    }

    /// Crosses out what stands between two marks.
    fn strike(&mut self, start: usize, inside: usize, after: usize, end: usize) {
        self.strokes[start..inside].fill(true);
        self.crossed[inside..after].fill(true);
        self.strokes[after..end].fill(true);
    }

    /// The braces of a command that begins here, if it is one that crosses out.
    fn command(&self, at: usize) -> Option<(usize, usize)> {
        let sign = |at: &usize| self.glyphs[*at].sign;
        let letters = (at + 1..self.glyphs.len()).take_while(|at| sign(at).is_ascii_alphabetic());
        let name: String = letters.map(|at| sign(&at)).collect();
        let open = at + 1 + name.len();
        let is_command = COMMANDS.contains(&name.as_str()) && self.glyphs.get(open)?.sign == '{';
        let mut depth = 0_i32;
        let close = (open..self.glyphs.len()).filter(|_| is_command).find(|at| {
            depth += i32::from(sign(at) == '{') - i32::from(sign(at) == '}');
            depth == 0
        })?;
        Some((open, close))
    }

    /// Does anything stand beside what is crossed out?
    fn is_replaced(&self) -> bool {
        let is_left = |at: usize| !self.crossed[at] && !self.strokes[at] && self.glyphs[at].sign.is_alphanumeric();
        (0..self.glyphs.len()).any(is_left)
    }
}
