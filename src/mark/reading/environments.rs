//! Environments of LaTeX: a column vector, and lines below one another.

use super::Unreadable;
use super::characters::{CLOSE, Glyph, OPEN};
use super::latex::{DEEPEST, Rewriter};

impl Rewriter<'_> {
    /// A column vector, or lines below one another.
    pub(super) fn environment(&mut self, from: Glyph) -> Result<(), Unreadable> {
        let name = self.words_in_braces(from)?;
        let column = matches!(
            name.trim_end_matches('*'),
            "pmatrix" | "bmatrix" | "matrix" | "array" | "smallmatrix" | "Bmatrix" | "psmallmatrix"
        );
        let lines = matches!(
            name.trim_end_matches('*'),
            "align" | "aligned" | "equation" | "gather" | "gathered" | "split" | "math" | "displaymath"
        );
        if !column && !lines {
            return Err(self.fault(from.place, format!("unknown environment `{name}`")));
        }
        if name == "array" && self.sign() == Some('{') {
            self.words_in_braces(from)?;
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.fault(from.place, "the answer is nested too deeply"));
        }
        self.columns += usize::from(column);
        if column {
            self.put(OPEN, from);
        }
        let start = self.out.len();
        loop {
            let rest: String = self.glyphs[self.at..].iter().take(5).map(|glyph| glyph.sign).collect();
            if rest.starts_with("\\end{") {
                self.at += 4;
                break;
            }
            match self.sign() {
                None => return Err(self.fault(from.place, format!("`\\begin{{{name}}}` is never ended"))),
                Some('&') if !column => self.at += 1,
                Some(_) => self.one()?,
            }
        }
        if self.words_in_braces(from)? != name {
            return Err(self.fault(from.place, format!("`\\begin{{{name}}}` is ended by another name")));
        }
        if column {
            // `4\\1\\` has no third row.
            while self.out.len() > start && matches!(self.out.last().map(|last| last.sign), Some(';' | ' ' | '\n')) {
                self.out.pop();
            }
            self.put(CLOSE, self.just_read());
        }
        self.columns -= usize::from(column);
        self.depth -= 1;
        Ok(())
    }

    /// The text of `{name}`, which it passes over.
    fn words_in_braces(&mut self, from: Glyph) -> Result<String, Unreadable> {
        let rest = &self.glyphs[self.at.min(self.glyphs.len())..];
        let closed = rest.iter().position(|glyph| glyph.sign == '}');
        match (rest.first().map(|glyph| glyph.sign), closed) {
            (Some('{'), Some(length)) => {
                self.at += length + 1;
                Ok(rest[1..length].iter().map(|glyph| glyph.sign).collect())
            }
            _ => Err(self.fault(from.place, "the name of an environment is missing")),
        }
    }
}
