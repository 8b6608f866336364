//! LaTeX commands into the small alphabet: `\frac{\sqrt{61}}{6}v` becomes `⟦⟦√⟦61⟧⟧/⟦6⟧⟧v`.

use super::Unreadable;
use super::characters::{CLOSE, Glyph, OPEN, RECURS};
use super::commands::{bare_fraction, is_fraction, is_mathematics, simple, spelt};
use super::infix_fraction;

/// Deeper nesting than any answer has.
pub(super) const DEEPEST: usize = 40;

/// The glyphs without commands, dollars and braces.
pub(super) fn without_latex(glyphs: &[Glyph]) -> Result<Vec<Glyph>, Unreadable> {
    if !glyphs.iter().any(|glyph| matches!(glyph.sign, '\\' | '{' | '}' | '$')) {
        return Ok(glyphs.to_vec());
    }
    let mut rewriter = Rewriter { glyphs, at: 0, out: Vec::new(), depth: 0, columns: 0 };
    while rewriter.at < glyphs.len() {
        rewriter.one()?;
    }
    infix_fraction::set(&mut rewriter.out, 0);
    match rewriter.out.iter().find(|glyph| glyph.sign == infix_fraction::OVER) {
        Some(again) => Err(rewriter.fault(again.place, "`\\over` twice in one group")),
        None => Ok(rewriter.out),
    }
}

pub(super) struct Rewriter<'a> {
    pub(super) glyphs: &'a [Glyph],
    pub(super) at: usize,
    pub(super) out: Vec<Glyph>,
    pub(super) depth: usize,
    /// How many column vectors stand open.
    pub(super) columns: usize,
}

impl Rewriter<'_> {
    pub(super) fn sign(&self) -> Option<char> {
        self.glyphs.get(self.at).map(|glyph| glyph.sign)
    }

    /// The place of what is being read.
    fn here(&self) -> Glyph {
        let last = self.glyphs.last().copied().unwrap_or(Glyph { sign: ' ', place: 0, end: 0 });
        self.glyphs.get(self.at).copied().unwrap_or(Glyph { place: last.end, ..last })
    }

    pub(super) fn fault(&self, place: usize, message: impl Into<String>) -> Unreadable {
        Unreadable::Sign(place, message.into())
    }

    pub(super) fn put(&mut self, sign: char, from: Glyph) {
        self.out.push(Glyph { sign, ..from });
    }

    /// The last glyph that was passed.
    pub(super) fn just_read(&self) -> Glyph {
        self.glyphs[self.at.clamp(1, self.glyphs.len()) - 1]
    }

    fn put_all(&mut self, signs: &str, from: Glyph) {
        signs.chars().for_each(|sign| self.put(sign, from));
    }

    /// One sign, command or group.
    pub(super) fn one(&mut self) -> Result<(), Unreadable> {
        let from = self.here();
        if let Some(command) = bare_fraction(self.glyphs, self.at) {
            self.at += command.len();
            return self.fraction(&command, from);
        }
        match from.sign {
            '\\' => self.command(),
            '$' => {
                self.at += 1;
                Ok(())
            }
            // `2{,}78`: braces keep a comma from being set as the end of a clause.
            '{' if matches!(
                self.glyphs[self.at + 1..],
                [Glyph { sign: ',' | '.', .. }, Glyph { sign: '}', .. }, ..]
            ) =>
            {
                self.at += 3;
                self.put(',', from);
                Ok(())
            }
            '{' => self.group(),
            '}' => Err(self.fault(from.place, "`}` closes nothing")),
            '^' if self.raises_degrees() => {
                self.put('°', from);
                Ok(())
            }
            '&' if self.columns > 0 => {
                self.at += 1;
                self.put(';', from);
                Ok(())
            }
            '_' => self.subscript(),
            '~' => {
                self.at += 1;
                self.put(' ', from);
                Ok(())
            }
            sign => {
                self.at += 1;
                self.put(sign, from);
                Ok(())
            }
        }
    }

    /// `^\circ` and `^{\circ}`, which it passes over.
    fn raises_degrees(&mut self) -> bool {
        let rest: String = self.glyphs[self.at..].iter().take(12).map(|glyph| glyph.sign).collect();
        let bare: String = rest.chars().filter(|sign| *sign != ' ').collect();
        let Some(inside) = ["^\\circ", "^{\\circ}", "^\\degree", "^{\\degree}", "^{°}", "^{o}"]
            .into_iter()
            .find(|spelling| bare.starts_with(spelling))
        else {
            return false;
        };
        let mut left = inside.chars().count();
        while left > 0 {
            left -= usize::from(self.sign() != Some(' '));
            self.at += 1;
        }
        true
    }

    /// `{…}` as a group.
    fn group(&mut self) -> Result<(), Unreadable> {
        let (from, start) = (self.here(), self.out.len());
        self.put(OPEN, from);
        self.inside()?;
        self.put(CLOSE, self.just_read());
        // `{4 \over 7}` is one group and not two, so that it can be part of a mixed number; `{}` is none.
        let inner = &self.out[start + 1..self.out.len() - 1];
        if inner.iter().all(|glyph| glyph.sign == ' ') {
            self.out.truncate(start);
        } else if is_one_group(inner) {
            self.out.remove(start);
            self.out.pop();
        }
        Ok(())
    }

    /// What stands in braces, without them.
    fn inside(&mut self) -> Result<(), Unreadable> {
        let (opened, start) = (self.here(), self.out.len());
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.fault(opened.place, "the answer is nested too deeply"));
        }
        self.at += 1;
        while self.sign() != Some('}') {
            if self.sign().is_none() {
                return Err(self.fault(opened.place, "`{` is never closed"));
            }
            self.one()?;
        }
        infix_fraction::set(&mut self.out, start);
        self.at += 1;
        self.depth -= 1;
        Ok(())
    }

    fn blanks(&mut self) {
        while self.sign() == Some(' ') {
            self.at += 1;
        }
    }

    /// What an argument holds: braces, or the next sign or command.
    fn argument(&mut self, command: &str) -> Result<Vec<Glyph>, Unreadable> {
        self.blanks();
        let start = self.out.len();
        match self.sign() {
            Some('{') => self.inside()?,
            None | Some('}') => {
                return Err(self.fault(self.here().place, format!("`\\{command}` lacks an argument")));
            }
            Some(_) => {
                self.depth += 1;
                if self.depth > DEEPEST {
                    return Err(self.fault(self.here().place, "the answer is nested too deeply"));
                }
                self.one()?;
                self.depth -= 1;
            }
        }
        Ok(self.out.split_off(start))
    }

    /// `_A`, `_{A}`, `_\mathrm{A}`: the letters and digits of a subscript.
    fn subscript(&mut self) -> Result<(), Unreadable> {
        let from = self.here();
        self.at += 1;
        self.put('_', from);
        if matches!(self.sign(), Some('{' | '\\')) {
            let below = self.argument("_")?;
            self.out.extend(below.into_iter().filter(|glyph| glyph.sign.is_alphanumeric()));
            self.put(' ', from);
        }
        Ok(())
    }

    fn command(&mut self) -> Result<(), Unreadable> {
        let from = self.here();
        self.at += 1;
        let letters = spelt(&self.glyphs[self.at..]);
        if letters.is_empty() {
            let Some(sign) = self.sign() else { return Err(self.fault(from.place, "`\\` without a command")) };
            // `\\\\frac{25}{7}`: a stroke twice, as programs write it, and no new line.
            let next = spelt(&self.glyphs[self.at + 1..]);
            if sign == '\\' && is_mathematics(&next) {
                return self.command();
            }
            self.at += 1;
            match sign {
                '\\' if self.columns > 0 => self.put(';', from),
                '\\' => self.put('\n', from),
                '(' | ')' | '[' | ']' => {}
                ',' | ';' | ':' | ' ' | '!' | '>' => self.put(' ', from),
                '{' => self.put('(', from),
                '}' => self.put(')', from),
                '%' | '_' => self.put(sign, from),
                '&' => self.put_all(" and ", from),
                '|' => self.put('|', from),
                _ => return Err(self.fault(from.place, format!("unknown command `\\{sign}`"))),
            }
            return Ok(());
        }
        self.at += letters.len();
        let from = Glyph { end: self.glyphs[self.at - 1].end, ..from };
        if let Some(signs) = simple(&letters) {
            self.put_all(signs, from);
            return Ok(());
        }
        match letters.as_str() {
            fraction if is_fraction(fraction) => self.fraction(&letters, from),
            "sqrt" => self.root(from),
            "over" => {
                self.put(infix_fraction::OVER, from);
                Ok(())
            }
            "text" | "mathrm" | "textrm" | "textbf" | "textit" | "mbox" | "operatorname" | "rm" | "textnormal"
            | "boxed" | "fbox" => {
                let inside = self.argument(&letters)?;
                self.put(' ', from);
                self.out.extend(inside);
                self.put(' ', from);
                Ok(())
            }
            "mathbf" | "boldsymbol" | "bm" | "vec" | "hat" | "underline" | "mathit" | "mathsf" | "overrightarrow"
            | "utilde" | "pmb" | "symbf" | "mathbfit" | "bf" | "ensuremath" | "displaylines" => {
                let inside = self.argument(&letters)?;
                self.out.extend(inside);
                Ok(())
            }
            "cr" => {
                self.put(if self.columns > 0 { ';' } else { '\n' }, from);
                Ok(())
            }
            "left" | "right" => {
                if self.sign() == Some('.') {
                    self.at += 1;
                }
                Ok(())
            }
            "binom" | "dbinom" | "tbinom" => {
                let (above, below) = (self.argument(&letters)?, self.argument(&letters)?);
                self.put('(', from);
                self.out.extend(above);
                self.put(';', from);
                self.out.extend(below);
                self.put(')', from);
                Ok(())
            }
            // siunitx: a number, an angle, and a number with its unit
            "num" | "ang" | "SI" | "qty" | "unit" | "si" => {
                let inside = self.argument(&letters)?;
                self.out.extend(inside);
                if letters == "ang" {
                    self.put('°', from);
                } else if matches!(letters.as_str(), "SI" | "qty") {
                    let unit = self.argument(&letters)?;
                    self.put(' ', from);
                    self.out.extend(unit);
                    self.put(' ', from);
                }
                Ok(())
            }
            "dot" | "overline" | "bar" => self.recurring(&letters, from),
            "begin" => self.environment(from),
            "end" => Err(self.fault(from.place, "`\\end` without its `\\begin`")),
            _ => Err(self.fault(from.place, format!("unknown command `\\{letters}`"))),
        }
    }

    fn fraction(&mut self, command: &str, from: Glyph) -> Result<(), Unreadable> {
        let (above, below) = (self.argument(command)?, self.argument(command)?);
        if [letters(&above), letters(&below)] == ["m", "s"] {
            // a unit after its number, which has no brackets
            self.put_all(" m/s ", Glyph { end: self.just_read().end, ..from });
            return Ok(());
        }
        self.put(OPEN, from);
        for (place, part) in [above, below].into_iter().enumerate() {
            if place == 1 {
                self.put('/', from);
            }
            // A fraction of digits alone may be part of a mixed number, as `½` may.
            let digits = !part.is_empty() && part.iter().all(|glyph| glyph.sign.is_ascii_digit());
            if !digits {
                self.put(OPEN, from);
            }
            self.out.extend(part);
            if !digits {
                self.put(CLOSE, self.just_read());
            }
        }
        self.put(CLOSE, self.just_read());
        Ok(())
    }

    fn root(&mut self, from: Glyph) -> Result<(), Unreadable> {
        let mut sign = '√';
        if let Some('[') = self.sign() {
            let rest = &self.glyphs[self.at + 1..];
            let Some(length) = rest.iter().position(|glyph| glyph.sign == ']') else {
                return Err(self.fault(self.here().place, "`[` is never closed"));
            };
            let index: String = rest[..length].iter().map(|glyph| glyph.sign).collect();
            sign = match index.trim() {
                "" | "2" => '√',
                "3" => '∛',
                _ => return Err(self.fault(from.place, "only square and cube roots are read")),
            };
            self.at += length + 2;
        }
        self.blanks();
        // `\\sqrt13` is meant to be the root of thirteen.
        let digits = self.glyphs[self.at..].iter().take_while(|glyph| glyph.sign.is_ascii_digit()).count();
        let inside = match digits {
            0 => self.argument("sqrt")?,
            _ => self.glyphs[self.at..self.at + digits].to_vec(),
        };
        self.at += digits;
        self.put(sign, from);
        self.put(OPEN, from);
        self.out.extend(inside);
        self.put(CLOSE, self.just_read());
        Ok(())
    }

    /// `\dot{3}` and `\overline{36}`: digits that recur.
    fn recurring(&mut self, command: &str, from: Glyph) -> Result<(), Unreadable> {
        let digits = self.argument(command)?;
        if digits.is_empty() || digits.iter().any(|glyph| !glyph.sign.is_ascii_digit()) {
            return Err(self.fault(from.place, format!("`\\{command}` over something that is no digit")));
        }
        let last = digits.len() - 1;
        for (place, digit) in digits.into_iter().enumerate() {
            self.out.push(digit);
            if place == 0 || place == last {
                self.put(RECURS, digit);
            }
        }
        Ok(())
    }
}

/// Is it a group, and nothing beside it?
fn is_one_group(glyphs: &[Glyph]) -> bool {
    let mut depth = 0;
    let closes = glyphs.iter().position(|glyph| {
        depth += i32::from(glyph.sign == OPEN) - i32::from(glyph.sign == CLOSE);
        depth == 0
    });
    glyphs.first().is_some_and(|first| first.sign == OPEN) && closes == Some(glyphs.len() - 1)
}

/// The signs of an argument without blanks.
fn letters(glyphs: &[Glyph]) -> String {
    glyphs.iter().map(|glyph| glyph.sign).filter(|sign| *sign != ' ').collect()
}
