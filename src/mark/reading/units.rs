//! Units in every spelling: `m s^-1`, `ms-1`, `m/s`, `metres per second`, `kg m s⁻¹`, `Ns`, `kJ`, `rad`.

use super::characters::{CLOSE, OPEN};
use super::tokens::{Placed, Token, excerpt};
use super::{SaidUnit, Vocabulary};
use crate::expr::Expr;
use crate::number::Fraction;

/// Powers of kilogram, metre, second and radian.
type Dimension = [i8; 4];

/// A unit by its spelling: its dimension, and how many of the base unit it is.
struct Known {
    names: &'static [&'static str],
    dimension: Dimension,
    scale: (i64, i64),
}

const fn known(names: &'static [&'static str], dimension: Dimension, above: i64, below: i64) -> Known {
    Known { names, dimension, scale: (above, below) }
}

/// Symbols, which may stand close together as in `kgms`; longer ones first.
const SYMBOLS: [Known; 13] = [
    known(&["kg", "Kg", "KG"], [1, 0, 0, 0], 1, 1),
    known(&["km"], [0, 1, 0, 0], 1000, 1),
    known(&["cm"], [0, 1, 0, 0], 1, 100),
    known(&["mm"], [0, 1, 0, 0], 1, 1000),
    known(&["kJ", "KJ"], [1, 2, -2, 0], 1000, 1),
    known(&["mJ"], [1, 2, -2, 0], 1, 1000),
    known(&["kN"], [1, 1, -2, 0], 1000, 1),
    known(&["J"], [1, 2, -2, 0], 1, 1),
    known(&["N"], [1, 1, -2, 0], 1, 1),
    known(&["m", "M"], [0, 1, 0, 0], 1, 1),
    known(&["s", "S"], [0, 0, 1, 0], 1, 1),
    known(&["g"], [1, 0, 0, 0], 1, 1000),
    known(&["h"], [0, 0, 1, 0], 3600, 1),
];

/// Whole words.
const WORDS: [Known; 20] = [
    known(&["rad", "rads", "radian", "radians"], [0, 0, 0, 1], 1, 1),
    known(&["mps"], [0, 1, -1, 0], 1, 1),
    known(&["kph", "kmph"], [0, 1, -1, 0], 5, 18),
    known(&["mph"], [0, 1, -1, 0], 1397, 3125),
    known(&["metre", "metres", "meter", "meters", "mtr", "mtrs"], [0, 1, 0, 0], 1, 1),
    known(&["second", "seconds", "sec", "secs"], [0, 0, 1, 0], 1, 1),
    known(&["hour", "hours", "hr", "hrs"], [0, 0, 1, 0], 3600, 1),
    known(&["minute", "minutes", "min", "mins"], [0, 0, 1, 0], 60, 1),
    known(&["newton", "newtons"], [1, 1, -2, 0], 1, 1),
    known(&["joule", "joules", "jouls"], [1, 2, -2, 0], 1, 1),
    known(&["kilojoule", "kilojoules"], [1, 2, -2, 0], 1000, 1),
    known(&["millijoule", "millijoules"], [1, 2, -2, 0], 1, 1000),
    known(&["kilogram", "kilograms", "kilogramme", "kilogrammes", "kilo", "kilos", "kgs"], [1, 0, 0, 0], 1, 1),
    known(&["gram", "grams", "gramme", "grammes"], [1, 0, 0, 0], 1, 1000),
    known(&["kilometre", "kilometres", "kilometer", "kilometers", "kms"], [0, 1, 0, 0], 1000, 1),
    known(&["centimetre", "centimetres", "centimeter", "centimeters", "cms"], [0, 1, 0, 0], 1, 100),
    known(&["millimetre", "millimetres", "millimeter", "millimeters"], [0, 1, 0, 0], 1, 1000),
    known(&["newtonseconds", "newtonsecond", "nsec", "nsecs", "ns"], [1, 1, -1, 0], 1, 1),
    known(&["newtonmetres", "newtonmetre", "newtonmeters"], [1, 2, -2, 0], 1, 1),
    known(&["watt", "watts"], [1, 2, -3, 0], 1, 1),
];

/// What units that students write measure. Anything else is letters that look like units.
const MEASURED: [Dimension; 17] = [
    [0, 1, -1, 0],
    [0, 1, 1, 0],
    [0, 1, -2, 0],
    [1, 1, -1, 0],
    [1, 1, 1, 0],
    [1, 1, 0, 0],
    [1, 1, -2, 0],
    [1, 1, -3, 0],
    [1, 2, -2, 0],
    [1, 2, -3, 0],
    [1, 0, 0, 0],
    [1, 0, -1, 0],
    [0, 1, 0, 0],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
    [0, 0, -1, 0],
    [0, 0, -1, 1],
];

/// `1.92 j` where there is no vector and no letter j: joules.
pub(super) fn with_joules(mut tokens: Vec<Placed>, vocabulary: &Vocabulary) -> Vec<Placed> {
    let word = |placed: &Placed, name: &str| matches!(&placed.token, Token::Word(word) if word == name);
    let known = |name: &str| vocabulary.letters.iter().any(|letter| letter.name() == name);
    if vocabulary.vectors || known("j") || tokens.iter().any(|placed| word(placed, "i")) {
        return tokens;
    }
    for at in 1..tokens.len() {
        let ends =
            tokens.get(at + 1).is_none_or(|next| matches!(next.token, Token::Sign(',' | ';' | '.' | '\n' | ')')));
        if word(&tokens[at], "j") && matches!(tokens[at - 1].token, Token::Number(_)) && ends {
            tokens[at].token = Token::Word("J".to_owned());
        }
    }
    tokens
}

/// Is it the name of a unit written out, or of one alone?
pub(super) fn is_unit_word(word: &str) -> bool {
    whole(word).is_some() || symbols(word).is_some()
}

fn whole(word: &str) -> Option<&'static Known> {
    let small = word.to_ascii_lowercase();
    WORDS.iter().find(|known| known.names.contains(&small.as_str()))
}

/// A word as symbols side by side.
fn symbols(word: &str) -> Option<Vec<&'static Known>> {
    let mut out = Vec::new();
    let mut rest = word;
    while !rest.is_empty() {
        let (found, length) = SYMBOLS.iter().find_map(|known| {
            known.names.iter().find(|name| rest.starts_with(**name)).map(|name| (known, name.len()))
        })?;
        out.push(found);
        rest = &rest[length..];
        if out.len() > 4 {
            return None;
        }
    }
    Some(out)
}

/// The unit that begins at a token, and the token after it. `text` is the answer as typed.
pub(super) fn unit(tokens: &[Placed], at: usize, text: &str) -> Option<(SaidUnit, usize)> {
    let bracket = match tokens.get(at)?.token {
        Token::Sign('(') => Some(')'),
        Token::Sign('[') => Some(']'),
        Token::Sign(OPEN) => Some(CLOSE),
        _ => None,
    };
    if let Some(close) = bracket {
        let (inner, next) = unit(tokens, at + 1, text)?;
        return tokens.get(next).is_some_and(|token| token.is(close)).then_some((inner, next + 1));
    }
    let mut reader = Units { tokens, at, dimension: [0; 4], scale: Fraction::ONE };
    reader.term(1)?;
    loop {
        let start = reader.at;
        let below = reader.over();
        if !below {
            reader.dot();
        }
        if reader.term(if below { -1 } else { 1 }).is_none() {
            reader.at = start;
            break;
        }
        if reader.at - at > 24 {
            return None;
        }
    }
    let next = reader.at;
    // A capital is condoned in `MS-1`, but by itself it is no metre.
    let capital =
        matches!(&tokens[at].token, Token::Word(word) if matches!(word.as_str(), "M" | "S")) && next == at + 1;
    if !MEASURED.contains(&reader.dimension) || capital {
        return None;
    }
    let typed = plain(excerpt(text, tokens[at].start, tokens[next - 1].end));
    let Units { dimension, scale, .. } = reader;
    Some((SaidUnit { typed, dimension, scale: Expr::Number(scale), degrees: false }, next))
}

/// A unit as typed, without what only LaTeX needs.
fn plain(typed: &str) -> String {
    let mut plain =
        typed.replace("\\,", " ").replace('~', " ").replace("\\ ", " ").replace("\\;", " ").replace("\\cdot", "·");
    for command in ["\\mathrm", "\\text", "\\left", "\\right"] {
        plain = plain.replace(command, "");
    }
    plain.retain(|sign| !matches!(sign, '{' | '}' | '$'));
    plain.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A walk over the tokens of a unit.
struct Units<'a> {
    tokens: &'a [Placed],
    at: usize,
    dimension: Dimension,
    scale: Fraction,
}

impl Units<'_> {
    fn sign(&self, ahead: usize) -> Option<char> {
        match self.tokens.get(self.at + ahead)?.token {
            Token::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    fn over(&mut self) -> bool {
        let per =
            matches!(self.tokens.get(self.at).map(|token| &token.token), Some(Token::Word(word)) if word == "per");
        let found = per || self.sign(0) == Some('/');
        self.at += usize::from(found);
        found
    }

    fn dot(&mut self) {
        // `newton-seconds`, `N-s`
        let before = self.at.checked_sub(1).map(|before| &self.tokens[before].token);
        let after_newton = matches!(before, Some(Token::Word(word)) if word == "N");
        let is_second = |word: &str| whole(word).is_some() || after_newton && word == "s";
        let hyphen = self.sign(0) == Some('-') && self.word(1).is_some_and(is_second);
        self.at += usize::from(matches!(self.sign(0), Some('*' | '.')) || hyphen);
    }

    fn word(&self, ahead: usize) -> Option<&str> {
        match &self.tokens.get(self.at + ahead)?.token {
            Token::Word(word) => Some(word),
            _ => None,
        }
    }

    /// Symbols and their exponent, which belongs to the last.
    fn term(&mut self, sense: i8) -> Option<()> {
        let word = self.word(0)?.to_owned();
        // `cms` is a plural and `Ns` an impulse, but in `cms-1` there is a second.
        let is_raised = matches!(self.sign(1), Some('^' | '-'));
        let is_per_second = is_raised && matches!(&*word, "cms" | "kms" | "Ns" | "NS");
        let (first, last): (Vec<&Known>, &Known) = match whole(&word).filter(|_| !is_per_second) {
            Some(known) => (Vec::new(), known),
            None => {
                let mut all = symbols(&word)?;
                let last = all.pop()?;
                (all, last)
            }
        };
        self.at += 1;
        let power = self.exponent()?;
        for known in first {
            self.times(known, sense)?;
        }
        self.times(last, sense.checked_mul(power)?)
    }

    fn times(&mut self, known: &Known, power: i8) -> Option<()> {
        for (sum, part) in self.dimension.iter_mut().zip(known.dimension) {
            *sum = sum.checked_add(part.checked_mul(power)?)?;
        }
        let scale = Fraction::new(known.scale.0, known.scale.1).power(i32::from(power))?;
        self.scale = &self.scale * &scale;
        Some(())
    }

    /// `^-1`, `^(-1)`, `⁻¹`, `-1`, `- 1`, `2`; one if there is none.
    fn exponent(&mut self) -> Option<i8> {
        let start = self.at;
        let raised = self.sign(0) == Some('^');
        self.at += usize::from(raised);
        let open = raised.then(|| self.sign(0)).flatten().filter(|sign| matches!(*sign, '(' | '{' | OPEN));
        self.at += usize::from(open.is_some());
        let negative = self.sign(0) == Some('-');
        self.at += usize::from(negative);
        // `ms - 1` at the end of a value: nobody takes 1 from a speed.
        let is_apart = negative && self.tokens.get(self.at + 1).is_none_or(|next| next.is(',') || next.is(';'));
        let digit = match self.tokens.get(self.at) {
            Some(Placed { token: Token::Number(Expr::Number(value)), spaced, .. })
                if raised || !spaced || is_apart && value.is_one() =>
            {
                value
                    .as_small()
                    .filter(|(power, below)| (1..=3).contains(power) && *below == 1)
                    // Nobody writes a first power, so a bare 1 is something else.
                    .filter(|(power, _)| raised || negative || *power > 1)
                    .and_then(|(power, _)| i8::try_from(power).ok())
            }
            _ => None,
        };
        let Some(power) = digit else {
            self.at = start;
            return (!raised).then_some(1);
        };
        self.at += 1;
        if open.is_some() {
            matches!(self.sign(0), Some(')' | '}' | CLOSE)).then_some(())?;
            self.at += 1;
        }
        Some(if negative { -power } else { power })
    }
}
