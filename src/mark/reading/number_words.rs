//! Numbers in words, where nothing but the number can be meant: `two m/s`, `three quarters`, `a third of u`, `3 and 4/7`.

use super::Vocabulary;
use super::characters::{CLOSE, OPEN};
use super::choices::{Choices, Doubt};
use super::names;
use super::tokens::{Placed, Token};
use super::units::is_unit_word;
use crate::expr::Expr;
use crate::number::{Letter, Range};

const WHOLE: [&str; 21] = [
    "zero",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
    "fifteen",
    "sixteen",
    "seventeen",
    "eighteen",
    "nineteen",
    "twenty",
];
const TENS: [&str; 8] = ["twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"];
/// One of so many equal parts, and several of them.
const PARTS: [(&str, &str, i64); 20] = [
    ("half", "halves", 2),
    ("third", "thirds", 3),
    ("quarter", "quarters", 4),
    ("fourth", "fourths", 4),
    ("fifth", "fifths", 5),
    ("sixth", "sixths", 6),
    ("seventh", "sevenths", 7),
    ("eighth", "eighths", 8),
    ("ninth", "ninths", 9),
    ("tenth", "tenths", 10),
    ("eleventh", "elevenths", 11),
    ("twelfth", "twelfths", 12),
    ("thirteenth", "thirteenths", 13),
    ("fourteenth", "fourteenths", 14),
    ("fifteenth", "fifteenths", 15),
    ("sixteenth", "sixteenths", 16),
    ("seventeenth", "seventeenths", 17),
    ("eighteenth", "eighteenths", 18),
    ("nineteenth", "nineteenths", 19),
    ("twentieth", "twentieths", 20),
];
/// Words and signs between which a number can stand in words.
const BEFORE: [&str; 13] = ["is", "and", "or", "so", "are", "was", "at", "of", "to", "root", "sqrt", "between", "than"];
const AFTER: [&str; 16] = [
    "and", "or", "so", "over", "times", "root", "square", "squared", "plus", "minus", "divided", "percent", "per",
    "all", "degrees", "x",
];

/// A number: what stands above the line and below it, and the token after it.
type Found = (i64, i64, usize);

/// The number in words that begins at a token, as tokens of figures; what stands before it has been read already.
pub(super) fn number_in_words(
    out: &[Placed],
    tokens: &[Placed],
    at: usize,
    vocabulary: &Vocabulary,
) -> Option<(Vec<Placed>, usize)> {
    let words = Words { tokens, vocabulary };
    if !matches!(tokens[at].token, Token::Word(_) | Token::Number(_)) || !begins_after(out) {
        return None;
    }
    let (above, below, next) = words.number(at).filter(|found| words.ends(*found))?;
    // Figures alone are a number already.
    words.word(next - 1)?;
    Some((figures(&tokens[at], tokens[next - 1].end, above, below), next))
}

/// `3 and 4/7`, `three and a half`: the fraction that `and` adds to the whole number before it. They may be two values.
pub(super) fn added_fraction(
    out: &[Placed],
    tokens: &[Placed],
    at: usize,
    vocabulary: &Vocabulary,
    choices: &mut Choices,
) -> Option<(Vec<Placed>, usize)> {
    let words = Words { tokens, vocabulary };
    let (last, before) = out.split_last()?;
    let is_whole = matches!(&last.token, Token::Number(Expr::Number(number)) if number.is_integer());
    if words.word(at)? != "and" || !is_whole || !begins_after(before) {
        return None;
    }
    let (above, below, next) =
        words.fraction(at + 1).or_else(|| words.number(at + 1)).filter(|found| words.ends(*found))?;
    if above >= below || choices.otherwise(Doubt::Mixed, tokens[at].start) {
        return None;
    }
    Some((figures(&tokens[at + 1], tokens[next - 1].end, above, below), next))
}

/// Can a number begin after this?
fn begins_after(out: &[Placed]) -> bool {
    out.last().is_none_or(|last| match &last.token {
        Token::Sign(sign) => "=≈<>≤≥:,;([⇒\n-+*/".contains(*sign) || *sign == OPEN,
        Token::Root { .. } => true,
        Token::Word(word) => BEFORE.contains(&&*word.to_ascii_lowercase()),
        _ => false,
    })
}

fn figures(first: &Placed, end: usize, above: i64, below: i64) -> Vec<Placed> {
    let place = |token, spaced| Placed { token, start: first.start, end, spaced };
    let number = |value| Token::Number(Expr::integer(value));
    if below == 1 {
        return vec![place(number(above), first.spaced)];
    }
    let signs = [Token::Sign(OPEN), number(above), Token::Sign('/'), number(below), Token::Sign(CLOSE)];
    signs.into_iter().enumerate().map(|(at, token)| place(token, first.spaced && at == 0)).collect()
}

struct Words<'a> {
    tokens: &'a [Placed],
    vocabulary: &'a Vocabulary,
}

impl Words<'_> {
    fn word(&self, at: usize) -> Option<String> {
        match &self.tokens.get(at)?.token {
            Token::Word(word) => Some(word.to_ascii_lowercase()),
            _ => None,
        }
    }

    /// A whole number in figures.
    fn count(&self, at: usize) -> Option<i64> {
        match &self.tokens.get(at)?.token {
            Token::Number(Expr::Number(number)) => number.as_small().filter(|(_, below)| *below == 1).map(|(n, _)| n),
            _ => None,
        }
    }

    /// The token after a hyphen, if one stands close here.
    fn after_hyphen(&self, at: usize) -> usize {
        at + usize::from(self.tokens.get(at).is_some_and(|sign| sign.is('-') && !sign.spaced))
    }

    /// `two`, `forty-five`, `a third`, `three quarters`, `2 thirds`.
    fn number(&self, at: usize) -> Option<Found> {
        let (count, next, is_article) = match (self.count(at), self.word(at).as_deref()) {
            (Some(count), _) => (count, at + 1, false),
            (None, Some("a" | "an")) => (1, at + 1, true),
            (None, Some("nought" | "nil")) => (0, at + 1, false),
            (None, Some("none")) => {
                return (self.tokens.len() == 1 && !self.vocabulary.vectors).then_some((0, 1, at + 1));
            }
            // Half of what, if not of a letter of the question? Nobody takes the half of e.
            (None, Some("half")) => {
                let is_share = |letter: &Letter| letter.range() == Range::Unit;
                let is_number = self.vocabulary.letters.iter().all(is_share) && self.tokens.get(at + 1).is_none();
                return (is_number || self.is_factor_after(at + 1)).then_some((1, 2, at + 1));
            }
            (None, word) => {
                let (count, next) = self.count_in_words(at, word?)?;
                (count, next, false)
            }
        };
        let part = self.after_hyphen(next);
        let is_part =
            |word: &str| PARTS.iter().find(|(one, several, _)| word == if count == 1 { *one } else { *several });
        match self.word(part).and_then(|word| is_part(&word)) {
            Some((.., below)) => Some((count, *below, part + 1)),
            None => (!is_article).then_some((count, 1, next)),
        }
    }

    /// `two`, `forty`, `forty-five`
    fn count_in_words(&self, at: usize, word: &str) -> Option<(i64, usize)> {
        let whole = |word: &str| WHOLE.iter().position(|whole| *whole == word).map(|number| number as i64);
        let Some(tens) = TENS.iter().position(|tens| *tens == word) else { return Some((whole(word)?, at + 1)) };
        let (tens, unit) = (10 * (tens as i64 + 2), self.after_hyphen(at + 1));
        let units = self.word(unit).and_then(|word| whole(&word)).filter(|units| (1..10).contains(units));
        Some(units.map_or((tens, at + 1), |units| (tens + units, unit + 1)))
    }

    /// `4/7`
    fn fraction(&self, at: usize) -> Option<Found> {
        let stroke = self.tokens.get(at + 1)?;
        let is_close = stroke.is('/') && !stroke.spaced && !self.tokens.get(at + 2)?.spaced;
        Some((self.count(at)?, self.count(at + 2)?, at + 3)).filter(|_| is_close)
    }

    /// Does a letter of the question stand here?
    fn is_factor(&self, at: usize) -> bool {
        match self.tokens.get(at).map(|placed| &placed.token) {
            Some(Token::Word(word)) => names::is_made_of_letters(word, self.vocabulary),
            Some(Token::Greek(name)) => names::letter(name, self.vocabulary).is_some(),
            _ => false,
        }
    }

    /// `u`, `of u`
    fn is_factor_after(&self, at: usize) -> bool {
        self.is_factor(at + usize::from(self.word(at).is_some_and(|word| word == "of")))
    }

    /// Is the number all that is said, or does something follow that goes with a number?
    fn ends(&self, (above, below, next): Found) -> bool {
        let Some(after) = self.tokens.get(next) else { return true };
        match &after.token {
            Token::Sign('-') => after.spaced,
            // `zero (at rest)`
            Token::Sign('(') => above == 0 && after.spaced && self.word(next + 1).is_some(),
            Token::Sign(sign) => "=≈<>≤≥,;)].⇒\n+*/°%".contains(*sign) || *sign == CLOSE,
            Token::Root { .. } | Token::Pi => true,
            Token::Word(word) if word.eq_ignore_ascii_case("of") => below > 1 && self.is_factor_after(next),
            Token::Word(word) => {
                is_unit_word(word) || self.is_factor(next) || AFTER.contains(&&*word.to_ascii_lowercase())
            }
            Token::Greek(_) => self.is_factor(next),
            _ => false,
        }
    }
}
