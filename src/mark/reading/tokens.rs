//! The small alphabet into tokens: numbers, words and signs, with the places where they stand.

use super::Unreadable;
use super::characters::{CLOSE, Glyph, OPEN};
use super::choices::Choices;
use super::digits::{self, number};
use super::phrases::Phrase;
use super::spelling::mended;
use crate::expr::{Expr, Function};
use crate::number::Letter;

/// One token.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// A number without sign.
    Number(Expr),
    /// Letters that have not been told apart yet.
    Word(String),
    /// A Greek letter, by its name.
    Greek(&'static str),
    /// A letter of the question, or in a label anything.
    Letter(String),
    /// `i` or `j` as a unit vector.
    Along(char),
    /// A function by its name.
    Function(Function),
    /// One over a function, `cot` for the tangent; for the arctangent it is `arccot`, the angle of one over.
    Reciprocal(Function),
    /// The sign or word of a square root, or of a cube root.
    Root { cube: bool },
    /// Half a turn.
    Pi,
    /// Words that have been understood.
    Phrase(Phrase),
    /// Any other sign.
    Sign(char),
}

/// A token and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Placed {
    pub token: Token,
    /// First byte in the text as typed.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
    /// Does a blank stand before it?
    pub spaced: bool,
}

impl Placed {
    /// Is it this sign?
    pub(super) fn is(&self, sign: char) -> bool {
        self.token == Token::Sign(sign)
    }
}

/// Greek letters by name, small and capital.
const GREEK: [(char, &str); 34] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('ς', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Ξ', "Xi"),
    ('Π', "Pi"),
    ('Σ', "Sigma"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
];

/// Is it the name of a Greek letter, in any case?
pub(super) fn is_greek(word: &str) -> bool {
    GREEK.iter().any(|(_, name)| name.eq_ignore_ascii_case(word))
}

/// Abbreviations that are written with full stops.
const DOTTED: [&str; 14] = [
    "s.f", "d.p", "l.o.c", "i.e", "e.g", "w.r.t", "k.e", "c.o.r", "c.o.m", "p.c.l.m", "c.l.m", "n.e.l", "n.l.r",
    "n.l.i",
];

/// The most tokens that an answer may have.
const MOST_TOKENS: usize = 400;

/// The longest run of letters that is read as one word.
const LONGEST_WORD: usize = 40;

/// Every token of the glyphs.
pub(super) fn tokens(glyphs: &[Glyph], letters: &[Letter], choices: &mut Choices) -> Result<Vec<Placed>, Unreadable> {
    let glyphs = digits::repaired(glyphs, letters, choices);
    let mut lexer = Lexer { glyphs: &glyphs, letters, at: 0, depth: 0, out: Vec::new() };
    while lexer.at < glyphs.len() {
        choices.step(glyphs[lexer.at].place)?;
        lexer.one(choices)?;
        if lexer.out.len() > MOST_TOKENS {
            return Err(Unreadable::Sign(glyphs[lexer.at - 1].place, "the answer is too long".to_owned()));
        }
    }
    Ok(lexer.out)
}

/// What was typed from one byte to another, a closing brace of LaTeX included.
pub(super) fn excerpt(text: &str, start: usize, end: usize) -> &str {
    let slice = text.get(start..end).unwrap_or_default();
    let count = |brace: char| slice.chars().filter(|sign| *sign == brace).count();
    let missing = count('{').saturating_sub(count('}'));
    let rest = text.get(end..).unwrap_or_default();
    let closing = rest.bytes().take(missing).take_while(|byte| *byte == b'}').count();
    text.get(start..end + closing).unwrap_or_default().trim()
}

struct Lexer<'a> {
    glyphs: &'a [Glyph],
    letters: &'a [Letter],
    at: usize,
    /// How many brackets stand open: in `(4,1)` the comma is none of a number's.
    depth: usize,
    out: Vec<Placed>,
}

impl Lexer<'_> {
    fn sign(&self, ahead: usize) -> Option<char> {
        self.glyphs.get(self.at + ahead).map(|glyph| glyph.sign)
    }

    fn put(&mut self, token: Token, length: usize) {
        let (first, last) = (self.glyphs[self.at], self.glyphs[self.at + length - 1]);
        let spaced = self.at > 0 && matches!(self.glyphs[self.at - 1].sign, ' ' | '\n');
        self.out.push(Placed { token, start: first.place, end: last.end, spaced });
        self.at += length;
    }

    fn one(&mut self, choices: &mut Choices) -> Result<(), Unreadable> {
        let Some(sign) = self.sign(0) else { return Ok(()) };
        let place = self.glyphs[self.at].place;
        if sign == ' ' {
            self.at += 1;
            return Ok(());
        }
        let after_digit = self.at > 0 && self.glyphs[self.at - 1].sign.is_ascii_digit();
        let digit_next = self.sign(1).is_some_and(|next| next.is_ascii_digit());
        // `mu²·9`: a raised point after a power or a bracket is a sign.
        let after_group = self.at > 0 && matches!(self.glyphs[self.at - 1].sign, CLOSE | ')' | ']');
        let point = sign == '.' || (sign == '·' && !after_group);
        let point_first = point && digit_next && !after_digit;
        if sign.is_ascii_digit() || (point_first && !self.follows_letter()) {
            let (value, length) = number(self.glyphs, self.at, self.depth, self.letters, choices)?;
            self.put(Token::Number(value), length);
            return Ok(());
        }
        // `81.9o`, where two digits at least stand before it: `3o` may be thirty.
        let after_two = self.at > 1 && matches!(self.glyphs[self.at - 2].sign, '0'..='9' | '.');
        let ends = !self.sign(1).is_some_and(char::is_alphanumeric);
        if sign == 'o' && after_digit && after_two && ends && !self.is_letter("o") {
            self.put(Token::Sign('°'), 1);
            return Ok(());
        }
        if sign.is_ascii_alphabetic() {
            return self.word();
        }
        if sign == 'π' {
            self.put(Token::Pi, 1);
            return Ok(());
        }
        if let Some((_, name)) = GREEK.iter().find(|(letter, _)| *letter == sign) {
            self.greek(name);
            return Ok(());
        }
        let next = self.sign(1).unwrap_or(' ');
        let ends_word = !self.sign(2).is_some_and(char::is_alphanumeric);
        let (token, length) = match (sign, next) {
            // Radians as a raised letter.
            ('^', 'c') if ends_word && !self.is_letter("c") => {
                self.put(Token::Word("rad".to_owned()), 2);
                return Ok(());
            }
            ('*', '*') => ('^', 2),
            ('=', '=') | (':', '=') => ('=', 2),
            ('!', '=') => ('≠', 2),
            ('<', '=') | ('=', '<') => ('≤', 2),
            ('=', '>') | ('-', '>') => ('⇒', 2),
            ('>', '=') => ('≥', 2),
            ('/', '/') => ('¦', 2),
            // The circle of degrees, as a letter.
            ('^', 'o') if ends_word => ('°', 2),
            ('.', '.') if self.sign(2) == Some('.') => ('…', 3),
            ('.', '.') => return Err(Unreadable::Sign(place, "two points, one after the other".to_owned())),
            _ => (sign, 1),
        };
        match token {
            '(' | '[' | '{' | OPEN => self.depth += 1,
            // `]2,5[` opens with it.
            ']' if self.depth == 0 => self.depth = 1,
            ')' | ']' | '}' | CLOSE => self.depth = self.depth.saturating_sub(1),
            '√' | '∛' => {
                self.put(Token::Root { cube: token == '∛' }, 1);
                return Ok(());
            }
            '.' if self.sign(1) == Some(' ') && self.stands_in_a_number() => {
                return Err(Unreadable::Sign(place, "a blank inside a number".to_owned()));
            }
            // `m.v`: a point between letters of the question is a sign of multiplication.
            '.' if self.stands_between_letters() => {
                self.put(Token::Sign('*'), 1);
                return Ok(());
            }
            '!' if !matches!(self.out.last().map(|last| &last.token), Some(Token::Word(_))) => {
                return Err(Unreadable::Sign(place, "`!` after a value".to_owned()));
            }
            '&' => {
                self.put(Token::Word("and".to_owned()), 1);
                return Ok(());
            }
            '~' => {
                self.put(Token::Sign('≈'), 1);
                return Ok(());
            }
            '+' | '-' | '*' | '/' | '^' | '|' | ',' | ';' | ':' | '=' | '<' | '>' | '%' | '°' | '\'' | '.' | '\n'
            | '?' | '!' | '≠' | '≤' | '≥' | '≈' | '⇒' | '¦' | '…' | '"' | '∈' | '∞' | '÷' => {}
            '·' | '⋅' => {
                self.put(Token::Sign('*'), 1);
                return Ok(());
            }
            // `±(2i - j)`: the line along it.
            // `±(i - 3j)`, `±1/√10(i - 3j)`
            '±' if self.sign(1) == Some('(') || self.glyphs.last().is_some_and(|last| last.sign == ')') => {}
            '±' | '∓' => return Err(Unreadable::Sign(place, format!("`{token}` says two things at once"))),
            _ => return Err(Unreadable::Sign(place, format!("`{token}` has no meaning here"))),
        }
        self.put(Token::Sign(token), length);
        Ok(())
    }

    /// Does a letter stand straight before it?
    fn follows_letter(&self) -> bool {
        self.at > 0 && self.glyphs[self.at - 1].sign.is_alphabetic()
    }

    /// `2. 78`: a point after a digit, a blank, a digit.
    fn stands_in_a_number(&self) -> bool {
        let digit = |glyph: Option<&Glyph>| glyph.is_some_and(|glyph| glyph.sign.is_ascii_digit());
        self.at > 0 && digit(self.glyphs.get(self.at - 1)) && digit(self.glyphs.get(self.at + 2))
    }

    /// Is what stands straight before it made of letters of the question, and does one, or a function, follow straight after it?
    fn stands_between_letters(&self) -> bool {
        let is_one = |sign: char| self.letters.iter().any(|letter| base(letter).chars().eq([sign]));
        let before = match self.out.last() {
            Some(Placed { token: Token::Word(word), end, .. }) if *end == self.glyphs[self.at].place => word,
            _ => return false,
        };
        let is_made_of_letters = self.is_letter(before) || before.chars().all(is_one);
        let is_function =
            |name: &str| self.glyphs[self.at + 1..].iter().map(|glyph| glyph.sign).take(3).eq(name.chars());
        is_made_of_letters
            && (self.sign(1).is_some_and(is_one) || ["sin", "cos", "tan"].iter().any(|name| is_function(name)))
    }

    /// Letters, and a subscript if there is one.
    fn word(&mut self) -> Result<(), Unreadable> {
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
        if let Some(mended) = mended(&word) {
            word = mended.to_owned();
        }
        let digits: String = rest().skip(length).take_while(char::is_ascii_digit).collect();
        if self.sign(length) == Some('_') {
            let below: String = rest().skip(length + 1).take_while(|sign| sign.is_alphanumeric()).collect();
            let below = self.subscript(&word, below);
            length += 1 + below.chars().count();
            word = format!("{word}_{below}");
        } else if !digits.is_empty() && self.ends_with_letter(&word, &digits) {
            length += digits.len();
            word.push_str(&digits);
        }
        let mut whole = length;
        // `perp.` and `approx.` end in a stop that ends no sentence.
        if self.sign(length) == Some('.') && ABBREVIATED.contains(&word.to_ascii_lowercase().as_str()) {
            whole += 1;
        }
        // `4surd39`
        let figure_next = self.sign(whole).is_some_and(|next| next.is_ascii_digit() || next == '(');
        match word.to_ascii_lowercase().as_str() {
            "surd" if figure_next => self.put(Token::Root { cube: false }, whole),
            "deg" | "degs" | "degree" | "degrees" => self.put(Token::Sign('°'), whole),
            _ => self.put(Token::Word(word), whole),
        }
        Ok(())
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
    fn greek(&mut self, name: &'static str) {
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

    fn is_letter(&self, name: &str) -> bool {
        self.letters.iter().any(|letter| letter.name().bytes().filter(|sign| *sign != b'_').eq(name.bytes()))
    }
}

/// A letter of the question without its index.
fn base(letter: &Letter) -> &str {
    let name = letter.name();
    name.split_once('_').map_or(name.trim_end_matches(|sign: char| sign.is_ascii_digit()), |(base, _)| base)
}

/// Words that are cut short by a full stop.
const ABBREVIATED: [&str; 10] = ["perp", "approx", "deg", "ans", "vel", "dir", "cor", "ke", "mag", "loc"];
