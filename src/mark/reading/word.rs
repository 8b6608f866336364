//! One word of an answer as a token: letters with their index, what is cut short by a full stop, Greek letters.

use super::Unreadable;
use super::spelling::mended;
use super::tokens::{Lexer, Token, base};
use crate::number::Letter;

/// Abbreviations that are written with full stops.
const DOTTED: [&str; 14] = [
    "s.f", "d.p", "l.o.c", "i.e", "e.g", "w.r.t", "k.e", "c.o.r", "c.o.m", "p.c.l.m", "c.l.m", "n.e.l", "n.l.r",
    "n.l.i",
];

/// Is it one of them, with or without its last full stop?
pub(crate) fn is_dotted(word: &str) -> bool {
    DOTTED.contains(&word.trim_end_matches('.').to_ascii_lowercase().as_str())
}

/// The longest run of letters that is read as one word.
const LONGEST_WORD: usize = 40;

impl Lexer<'_> {
    /// Letters, and a subscript if there is one.
    pub(super) fn word(&mut self) -> Result<(), Unreadable> {
        let rest = || self.glyphs[self.at..].iter().map(|glyph| glyph.sign);
        let start: String = rest().take(8).collect::<String>().to_ascii_lowercase();
        if let Some(dotted) = DOTTED.iter().find(|dotted| start.starts_with(**dotted)) {
            let whole = dotted.len() + usize::from(start[dotted.len()..].starts_with('.'));
            self.put(Token::Word(dotted.replace('.', "")), whole);
            return Ok(());
        }
        let mut word: String = rest().take_while(char::is_ascii_alphabetic).collect();
        if word.len() > LONGEST_WORD {
            let place = self.glyphs[self.at].place;
            return Err(Unreadable::Sign(place, format!("a word of more than {LONGEST_WORD} letters")));
        }
        // `1/3rd`
        let after_digit = self.at > 0 && self.glyphs[self.at - 1].sign.is_ascii_digit();
        let is_below = matches!(self.out.as_slice(), [.., stroke, _] if stroke.is('/'));
        if after_digit && is_below && matches!(word.as_str(), "rd" | "rds" | "th" | "ths") {
            self.at += word.len();
            return Ok(());
        }
        // The apostrophe of `doesn't`.
        if self.sign(word.len()) == Some('\'') && self.sign(word.len() + 1) == Some('t') {
            word.push_str("'t");
        }
        let mut length = word.len();
        // `A's speed`
        let apart = |sign: Option<char>| sign.is_none_or(|sign| !sign.is_alphanumeric());
        if self.sign(length) == Some('\'') && self.sign(length + 1) == Some('s') && apart(self.sign(length + 2)) {
            self.put(Token::Word(word), length + 2);
            return Ok(());
        }
        // `the spheres' centres`
        if SEVERAL.contains(&word.to_ascii_lowercase().as_str())
            && self.sign(length) == Some('\'')
            && apart(self.sign(length + 1))
        {
            self.put(Token::Word(word), length + 1);
            return Ok(());
        }
        if let Some(mended) = mended(&word) {
            word = mended.to_owned();
        }
        let digits: String = rest().skip(length).take_while(char::is_ascii_digit).collect();
        if let Some(sphere) = self.sphere_in_brackets(&word) {
            length += 3;
            word = format!("{word}_{sphere}");
        } else if self.sign(length) == Some('_') {
            let below: String = rest().skip(length + 1).take_while(|sign| sign.is_alphanumeric()).collect();
            let below = self.subscript(&word, below);
            length += 1 + below.chars().count();
            word = format!("{word}_{below}");
        } else if word == "E" && digits.len() == 1 && !after_digit && !self.is_letter("E") {
            // `E1 − E2`: energies, and no powers of e.
            length += 1;
            word = format!("E_{digits}");
        } else if !digits.is_empty() && self.ends_with_letter(&word, &digits) {
            length += digits.len();
            word.push_str(&digits);
        }
        let primes = self.primes(&word, length);
        length += primes;
        word.extend(std::iter::repeat_n('\'', primes));
        let mut whole = length;
        // `perp.` and `approx.` end in a stop that ends no sentence.
        if self.sign(length) == Some('.') && ABBREVIATED.contains(&word.to_ascii_lowercase().as_str()) {
            whole += 1;
        }
        // `4surd39`, `surd 39`
        let after = (whole..).find(|ahead| self.sign(*ahead) != Some(' ')).and_then(|ahead| self.sign(ahead));
        let figure_next = after.is_some_and(|next| next.is_ascii_digit() || next == '(');
        match word.to_ascii_lowercase().as_str() {
            "surd" if figure_next => self.put(Token::Root { cube: false }, whole),
            "deg" | "degs" | "degree" | "degrees" => self.put(Token::Sign('°'), whole),
            _ => self.put(Token::Word(word), whole),
        }
        Ok(())
    }

    /// `v' = 2.4`, `3v'` where that is a letter: how many primes after a word are part of its name.
    fn primes(&self, word: &str, length: usize) -> usize {
        let count = (length..).take_while(|ahead| self.sign(*ahead) == Some('\'')).count();
        let primed = format!("{word}{}", "'".repeat(count));
        let ends_so = |letter: &Letter| letter.name().ends_with('\'') && primed.ends_with(letter.name());
        let after = (length + count..).find(|ahead| self.sign(*ahead) != Some(' '));
        let is_named = after.and_then(|ahead| self.sign(ahead)) == Some('=');
        let is_name = is_named || self.is_letter(&primed.replace('_', "")) || self.letters.iter().any(ends_so);
        if is_name { count } else { 0 }
    }

    /// `v(A)`: the name of a sphere in brackets after one letter is an index, unless the question has such a letter.
    fn sphere_in_brackets(&self, word: &str) -> Option<char> {
        let sphere = self.sign(2).filter(|sign| matches!(sign, 'A' | 'B' | 'C' | 'P' | 'Q'))?;
        let is_index = word.len() == 1 && self.sign(1) == Some('(') && self.sign(3) == Some(')');
        (is_index && !self.is_letter(&sphere.to_string())).then_some(sphere)
    }

    /// The subscript of a letter of the question, where more letters follow it: `v_Au`; else all of it.
    fn subscript(&self, word: &str, below: String) -> String {
        let known = self.letters.iter().filter_map(|letter| {
            let (base, own) = letter.name().split_once('_')?;
            (word.ends_with(base) && below.starts_with(own)).then(|| own.to_owned())
        });
        known.max_by_key(String::len).unwrap_or(below)
    }

    /// A Greek letter, with its subscript.
    pub(super) fn greek(&mut self, name: &'static str) {
        if self.sign(1) != Some('_') {
            self.put(Token::Greek(name), 1);
            return;
        }
        let below: String = self.glyphs[self.at + 2..]
            .iter()
            .map(|glyph| glyph.sign)
            .take_while(|sign| sign.is_alphanumeric())
            .collect();
        let length = 2 + below.chars().count();
        self.put(Token::Word(format!("{name}_{below}")), length);
    }

    /// Do a word and figures end with a letter of the question, and is the rest made of others: `mv1`?
    fn ends_with_letter(&self, word: &str, digits: &str) -> bool {
        let is_one = |sign: char| self.letters.iter().any(|letter| letter.name().chars().eq([sign]));
        let front = |letter: &Letter| {
            let base = base(letter);
            let has_digits = letter.name()[base.len()..].trim_start_matches('_') == digits;
            word.strip_suffix(base).filter(|_| has_digits)
        };
        self.letters.iter().filter_map(front).any(|front| front.chars().all(is_one))
    }
}

/// Of several: an apostrophe after these is no sign.
const SEVERAL: [&str; 4] = ["spheres", "balls", "particles", "centres"];

/// Words that are cut short by a full stop.
const ABBREVIATED: [&str; 12] =
    ["perp", "approx", "deg", "ans", "vel", "dir", "cor", "ke", "mag", "loc", "coeff", "coef"];
