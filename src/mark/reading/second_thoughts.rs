//! Second thoughts: `3.08 → no, 2.78` takes back the value before it, and `not 3.08 but 2.78` the one after it.

use super::phrases::Walk;
use super::tokens::{Placed, Token};
use super::units::{is_unit_word, unit};
use super::wording::{IN_PLACE_OF, LEADS, SECOND_THOUGHTS, Thoughts};

/// Is the remark one by which a value is taken back?
pub(crate) fn is_second_thought(remark: &str) -> bool {
    SECOND_THOUGHTS.iter().any(|thoughts| thoughts.words.contains(&remark))
}

/// Is the remark one by which a value gives way to another?
pub(crate) fn is_in_place_of(remark: &str) -> bool {
    IN_PLACE_OF.contains(&remark)
}

impl Walk<'_> {
    /// `2.78, not 3.08`, `2.78 instead of 3.08`, `not 3.08 but 2.78`: the token after the words before a value that is none.
    /// Is it set off from the one that is?
    pub(super) fn denial(&self, at: usize) -> Option<(usize, bool)> {
        let is_number = |at: usize| matches!(self.token(at), Some(Token::Number(_)));
        let next = self.words(at, "not").or_else(|| self.any(at, &IN_PLACE_OF))?;
        let number = next + usize::from(self.token(next) == Some(&Token::Sign('-')));
        if !is_number(number) {
            return None;
        }
        let Some(before) = at.checked_sub(1) else {
            return (next == 1 && self.gives_way(number + 1)).then_some((next, true));
        };
        match self.token(before)? {
            Token::Sign(',' | '(') => Some((next, true)),
            Token::Number(_) | Token::Sign('°' | '%') => Some((next, false)),
            Token::Word(word) if is_unit_word(word) && (0..at).any(is_number) => Some((next, false)),
            _ => None,
        }
    }

    fn token(&self, at: usize) -> Option<&Token> {
        self.tokens.get(at).map(|placed| &placed.token)
    }

    /// `but 2.78`, `, 2.78`: after a value that is denied, is another put in its place?
    fn gives_way(&self, after_number: usize) -> bool {
        let is_measure = matches!(self.token(after_number), Some(Token::Sign('°' | '%')));
        let end = unit(self.tokens, after_number, "").map_or(after_number + usize::from(is_measure), |(_, end)| end);
        let comma = matches!(self.token(end), Some(Token::Sign(',' | ';'))).then_some(end + 1);
        let Some(next) = self.any(comma.unwrap_or(end), &["but", "but rather"]).or(comma) else { return false };
        self.is_value(self.any(next, &LEADS).unwrap_or(next))
    }

    /// A word by which the value before it is taken back, and the token at which the other value begins.
    pub(super) fn second_thought(&self, at: usize) -> Option<(Placed, usize)> {
        let closing = match self.tokens[at].token {
            Token::Sign('(') => Some(')'),
            Token::Sign('[') => Some(']'),
            _ => None,
        };
        let first = at + usize::from(closing.is_some() || (self.tokens[at].is('-') && self.tokens[at].spaced));
        let mut next = self.thought(first, |_| true)?;
        if !self.tokens[..first].iter().any(|placed| matches!(placed.token, Token::Number(_) | Token::Root { .. })) {
            return None;
        }
        let word = Placed { end: self.tokens[next - 1].end, ..self.tokens[first].clone() };
        if let Some(closing) = closing {
            next += self.tokens.get(next).filter(|close| close.is(closing)).map(|_| 1)?;
        }
        let value = self.after_thoughts(next);
        // `3.08 → no 2.78`, `3.08, rather 2.78`
        let follows = |sign: char| at > 0 && self.tokens[at - 1].is(sign);
        let is_led = closing.is_some() || follows('⇒') || follows(',') && self.word(first) == Some("rather");
        let is_open = self.thought(first, |thoughts| thoughts.are_open).is_some() && value == next && !is_led;
        (self.is_value(value) && !is_open).then_some((word, value))
    }

    /// `no, 2.78`, `scrap that, 2.78`: the token at which the value begins, where nothing that was said is taken back.
    pub(super) fn fresh_start(&self, at: usize) -> Option<usize> {
        let begins = at == 0 || matches!(self.token(at - 1), Some(Token::Sign('\n')));
        let next = self.thought(at, |thoughts| thoughts.begin).filter(|_| begins)?;
        let value = self.after_thoughts(next);
        let is_open = self.thought(at, |thoughts| thoughts.are_open).is_some() && value == next;
        (self.is_value(value) && !is_open).then_some(value)
    }

    /// The token after a word that takes back what stands before it, of those that may do something else besides.
    fn thought(&self, at: usize, which: impl Fn(&Thoughts) -> bool) -> Option<usize> {
        let those = SECOND_THOUGHTS.iter().filter(|thoughts| which(thoughts));
        those.filter_map(|thoughts| self.any(at, thoughts.words)).max()
    }

    /// The token after signs and further words of the kind: `wait`, `it should be`.
    fn after_thoughts(&self, at: usize) -> usize {
        let parts = |at: usize| {
            let sign = |sign: char| self.tokens.get(at).is_some_and(|placed| placed.is(sign));
            // A minus sign stands close before its number.
            let dash = sign('-') && self.tokens.get(at + 1).is_some_and(|next| next.spaced);
            dash || [',', ':', ';', '.', '⇒', '\n'].into_iter().any(sign)
        };
        let mut next = at;
        while let Some(more) =
            parts(next).then_some(next + 1).or_else(|| self.thought(next, |_| true)).or_else(|| self.any(next, &LEADS))
        {
            next = more;
        }
        next
    }

    /// Does a value begin here, or a name with its equals sign?
    fn is_value(&self, at: usize) -> bool {
        let is_value = |token: &Token| matches!(token, Token::Number(_) | Token::Root { .. } | Token::Sign('-'));
        self.token(at).is_some_and(is_value) || self.names(at)
    }

    /// Does a name with its equals sign stand here?
    fn names(&self, at: usize) -> bool {
        self.word(at).is_some() && self.tokens.get(at + 1).is_some_and(|next| next.is('=') || next.is(':'))
    }
}
