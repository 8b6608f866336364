//! The small alphabet into tokens: numbers, words and signs, with the places where they stand.

use super::Unreadable;
use super::characters::{CLOSE, Glyph, OPEN};
use super::choices::Choices;
use super::digits::{self, number};
use super::phrases::Phrase;
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

/// The Greek letter of this name, and its name.
pub(crate) fn greek(name: &str) -> Option<(char, &'static str)> {
    GREEK.iter().copied().find(|(_, known)| *known == name)
}

/// The name of a Greek letter that is typed as it is or by its name, `\lambda`.
pub(crate) fn greek_name(typed: &str) -> Option<&'static str> {
    let is_it = |(sign, name): &&(char, &str)| typed == *name || typed.chars().eq([*sign]);
    GREEK.iter().find(is_it).map(|(_, name)| *name)
}

/// Is it the name of a Greek letter, in any case?
pub(super) fn is_greek(word: &str) -> bool {
    GREEK.iter().any(|(_, name)| name.eq_ignore_ascii_case(word))
}

/// The most tokens that an answer may have.
const MOST_TOKENS: usize = 400;

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

pub(super) struct Lexer<'a> {
    pub(super) glyphs: &'a [Glyph],
    pub(super) letters: &'a [Letter],
    pub(super) at: usize,
    /// How many brackets stand open: in `(4,1)` the comma is none of a number's.
    depth: usize,
    pub(super) out: Vec<Placed>,
}

impl Lexer<'_> {
    pub(super) fn sign(&self, ahead: usize) -> Option<char> {
        self.glyphs.get(self.at + ahead).map(|glyph| glyph.sign)
    }

    pub(super) fn put(&mut self, token: Token, length: usize) {
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
        // `½.2`: nor is any point straight behind a fraction that of a decimal.
        let after_fraction = self.at > 0 && self.glyphs[self.at - 1].sign == CLOSE;
        if sign == '.' && after_fraction && digit_next {
            self.put(Token::Sign('*'), 1);
            return Ok(());
        }
        let point = sign == '.' || (sign == '·' && !after_group);
        let point_first = point && digit_next && !after_digit;
        if sign.is_ascii_digit() || (point_first && !self.follows_letter()) {
            // `]0,6 ; 1]`: what a semicolon parts, a comma does not.
            let is_parted = self.depth == 1 && self.glyphs.iter().any(|glyph| glyph.sign == ';');
            let depth = if is_parted { 0 } else { self.depth };
            let (value, length) = number(self.glyphs, self.at, depth, self.letters, choices)?;
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
            // The hat of a unit vector.
            ('^', _) if self.follows_unit_vector() => {
                self.at += 1;
                return Ok(());
            }
            ('*', '*') => ('^', 2),
            ('=', '=') | (':', '=') => ('=', 2),
            ('!', '=') => ('≠', 2),
            ('<', '=') | ('=', '<') => ('≤', 2),
            // `e => 1/3`: from a letter by itself nothing follows.
            ('=', '>') if matches!(self.out.as_slice(), [Placed { token: Token::Word(_) | Token::Greek(_), .. }]) => {
                ('≥', 2)
            }
            ('=', '>') | ('-', '>') => ('⇒', 2),
            ('>', '=') => ('≥', 2),
            ('<', _) if let Some(length) = self.or_equal() => ('≤', length),
            ('>', _) if let Some(length) = self.or_equal() => ('≥', length),
            ('/', '/') => ('¦', 2),
            ('\'', '\'') => ('"', 2),
            // The circle of degrees, as a letter.
            ('^', 'o') if ends_word => ('°', 2),
            // The circle as a nought: nobody raises a decimal to that power.
            ('^', '0') if ends_word && self.sign(2) != Some('.') && self.is_after_a_measure() => ('°', 2),
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
            '!' if !self.is_exclaimed() => {
                return Err(Unreadable::Sign(place, "`!` after a value".to_owned()));
            }
            '&' => {
                self.put(Token::Word("and".to_owned()), 1);
                return Ok(());
            }
            // `-2~i`, as LaTeX ties them.
            '~' if self.is_tie() => {
                self.at += 1;
                return Ok(());
            }
            '~' => {
                self.put(Token::Sign('≈'), 1);
                return Ok(());
            }
            '+' | '-' | '*' | '/' | '^' | '|' | ',' | ';' | ':' | '=' | '<' | '>' | '%' | '°' | '\'' | '.' | '\n'
            | '?' | '!' | '≠' | '≤' | '≥' | '≈' | '⇒' | '¦' | '…' | '"' | '∈' | '∞' | '÷' | '±' | '∓' =>
                {}
            '·' | '⋅' => {
                self.put(Token::Sign('*'), 1);
                return Ok(());
            }
            _ => return Err(Unreadable::Sign(place, format!("`{token}` has no meaning here"))),
        }
        self.put(Token::Sign(token), length);
        Ok(())
    }

    /// Does it stand between a number and a letter, with no blank?
    fn is_tie(&self) -> bool {
        let before = self.at.checked_sub(1).map(|at| self.glyphs[at].sign);
        before.is_some_and(|sign| sign.is_ascii_digit()) && self.sign(1).is_some_and(char::is_alphabetic)
    }

    /// `4i^ + j^`: does it stand straight behind an i or j, with no exponent after it?
    fn follows_unit_vector(&self) -> bool {
        let back = |count: usize| self.at.checked_sub(count).map(|at| self.glyphs[at].sign);
        let is_letter = |sign: Option<char>| sign.is_some_and(char::is_alphabetic);
        let ends = !self.sign(1).is_some_and(|next| next.is_alphanumeric() || "(-{[.√".contains(next) || next == OPEN);
        matches!(back(1), Some('i' | 'j'))
            && !is_letter(back(2))
            && ends
            && !self.is_letter("i")
            && !self.is_letter("j")
    }

    /// Does a letter stand straight before it?
    fn follows_letter(&self) -> bool {
        self.at > 0 && self.glyphs[self.at - 1].sign.is_alphabetic()
    }

    /// `< or =`: how many signs that is.
    fn or_equal(&self) -> Option<usize> {
        let blanks = |from: usize| from + (from..).take_while(|at| self.sign(*at) == Some(' ')).count();
        let or = blanks(1);
        let equal = blanks(or + 2);
        let is_or = self.sign(or) == Some('o') && self.sign(or + 1) == Some('r') && equal > or + 2;
        (is_or && self.sign(equal) == Some('=')).then_some(equal + 1)
    }

    /// Is what stands straight before it a decimal?
    fn is_after_a_measure(&self) -> bool {
        let ends_here = |placed: &Placed| placed.end == self.glyphs[self.at].place;
        let last = self.out.last().filter(|placed| ends_here(placed));
        last.is_some_and(|placed| matches!(placed.token, Token::Number(Expr::Decimal(_))))
    }

    /// `2.78 !!`, `2.78 m/s!`: does it stand behind a word, or set off, and after nothing of which there is a factorial?
    fn is_exclaimed(&self) -> bool {
        let is_set_off = |at: usize| self.glyphs[..at].last().is_some_and(|before| before.sign == ' ');
        let first = self.glyphs[..=self.at].iter().rposition(|glyph| glyph.sign != '!').map_or(0, |before| before + 1);
        is_set_off(first) || matches!(self.out.last().map(|last| &last.token), Some(Token::Word(_)))
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

    pub(super) fn is_letter(&self, name: &str) -> bool {
        self.letters.iter().any(|letter| letter.name().bytes().filter(|sign| *sign != b'_').eq(name.bytes()))
    }
}

/// A letter of the question without its index.
pub(super) fn base(letter: &Letter) -> &str {
    let name = letter.name();
    name.split_once('_').map_or(name.trim_end_matches(|sign: char| sign.is_ascii_digit()), |(base, _)| base)
}
