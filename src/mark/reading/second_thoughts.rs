//! Second thoughts: `3.08 → no, 2.78` takes back the value before it.

use super::phrases::Walk;
use super::tokens::{Placed, Token};
use super::units::is_unit_word;

/// Words that take back what stands before them, where another value follows.
const SECOND_THOUGHTS: [&str; 11] =
    ["no", "nope", "sorry", "oops", "wait", "actually", "rather", "correction", "wrong", "incorrect", "i mean"];
/// Those that may be said of the value that follows, too, unless something parts them from it.
const OPEN: [&str; 5] = ["no", "nope", "wrong", "incorrect", "rather"];
/// Words between them and the value that follows; of `it's` the first two letters are read.
const LEADS: [&str; 7] = ["it", "its", "it is", "it should be", "should be", "i meant", "make that"];

/// Is the remark one by which a value is taken back?
pub(crate) fn is_second_thought(remark: &str) -> bool {
    SECOND_THOUGHTS.contains(&remark)
}

impl Walk<'_> {
    /// `2.78, not 3.08`, `k = 8 not -24`: the word before a value that is none. Is it set off from the one that is?
    pub(super) fn denial(&self, at: usize) -> Option<bool> {
        let token = |at: usize| self.tokens.get(at).map(|placed| &placed.token);
        let is_number = |at: usize| matches!(token(at), Some(Token::Number(_)));
        let minus = usize::from(token(at + 1) == Some(&Token::Sign('-')));
        if self.word(at) != Some("not") || !is_number(at + 1 + minus) {
            return None;
        }
        match token(at.checked_sub(1)?)? {
            Token::Sign(',' | '(') => Some(true),
            Token::Number(_) | Token::Sign('°' | '%') => Some(false),
            Token::Word(word) if is_unit_word(word) && (0..at).any(is_number) => Some(false),
            _ => None,
        }
    }

    /// A word by which the value before it is taken back, and the token at which the other value begins.
    pub(super) fn second_thought(&self, at: usize) -> Option<(Placed, usize)> {
        let parts = |at: usize| {
            let sign = |sign: char| self.tokens.get(at).is_some_and(|placed| placed.is(sign));
            // A minus sign stands close before its number.
            let dash = sign('-') && self.tokens.get(at + 1).is_some_and(|next| next.spaced);
            dash || [',', ':', ';', '.', '⇒', '\n'].into_iter().any(sign)
        };
        let in_brackets = self.tokens[at].is('(');
        let first = at + usize::from(in_brackets || (self.tokens[at].is('-') && self.tokens[at].spaced));
        let mut next = self.any(first, &SECOND_THOUGHTS)?;
        let is_open = self.any(first, &OPEN).is_some();
        let is_value = |placed: &Placed| matches!(placed.token, Token::Number(_) | Token::Root { .. });
        if !self.tokens[..first].iter().any(is_value) {
            return None;
        }
        let word = Placed { end: self.tokens[next - 1].end, ..self.tokens[first].clone() };
        if in_brackets {
            next += self.tokens.get(next).filter(|close| close.is(')')).map(|_| 1)?;
        }
        let after_word = next;
        while let Some(more) = parts(next)
            .then_some(next + 1)
            .or_else(|| self.any(next, &SECOND_THOUGHTS))
            .or_else(|| self.any(next, &LEADS))
        {
            next = more;
        }
        let follows =
            self.tokens.get(next).is_some_and(|placed| is_value(placed) || placed.is('-') || self.names(next));
        (follows && !(is_open && next == after_word && !in_brackets)).then_some((word, next))
    }

    /// Does a name with its equals sign stand here?
    fn names(&self, at: usize) -> bool {
        self.word(at).is_some() && self.tokens.get(at + 1).is_some_and(|next| next.is('=') || next.is(':'))
    }
}
