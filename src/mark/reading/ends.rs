//! Ends of ranges in words: `or less`, `but not including 1`, `(not included)`, `no upper limit`.

use super::phrases::{Phrase, Walk};
use super::tokens::{Placed, Token};
use super::wording;

impl Walk<'_> {
    /// `or less`, after which nothing more is said; `but not including`.
    pub(super) fn end_of_range(&self, at: usize) -> Option<(Phrase, usize)> {
        if let Some(next) = self.any(at, &wording::EXCLUDING) {
            return Some((Phrase::Excluding, next));
        }
        let ends = |next: &usize| self.tokens.get(*next).is_none_or(|after| !matches!(after.token, Token::Word(_)));
        let less = || Some((Phrase::OrLess, self.any(at, &wording::OR_LESS).filter(ends)?));
        let more = || Some((Phrase::OrMore, self.any(at, &wording::OR_MORE).filter(ends)?));
        less().or_else(more)
    }

    /// `(not included)`, `(included)` behind a number. `inclusive` behind the last end is said of both, and is left to the
    /// range.
    pub(super) fn end_told(&self, at: usize) -> Option<(Phrase, usize)> {
        let before = self.tokens.get(at.checked_sub(1)?)?;
        let is_end = matches!(before.token, Token::Number(_) | Token::Sign(')' | '⟧'));
        let is = |at: usize, sign: char| self.tokens.get(at).is_some_and(|placed| placed.is(sign));
        let close = [('(', ')'), ('[', ']')].into_iter().find(|(open, _)| is(at, *open)).map(|(_, close)| close);
        let start = at + usize::from(close.is_some());
        let told = |words: &[&str], included| Some((self.any(start, words)?, included));
        let (next, included) = told(&wording::EXCLUDED, false).or_else(|| told(&wording::INCLUDED, true))?;
        let next = match close {
            Some(close) => is(next, close).then_some(next + 1)?,
            None => next,
        };
        let is_last = (0..at).any(|before| matches!(self.word(before), Some("and" | "to")));
        let is_of_both = is_last && (start..next).any(|at| self.word(at).is_some_and(|word| word.ends_with("clusive")));
        (is_end && !is_of_both && !self.vocabulary.vectors).then_some((Phrase::End { included }, next))
    }

    /// `k > 2, no upper limit`: words by which a range goes on for ever, on the side on which it has no end.
    pub(super) fn no_further_end(&self, at: usize) -> Option<usize> {
        let (next, is_upper) = match self.any(at, &wording::NO_UPPER_END) {
            Some(next) => (next, true),
            None => (self.any(at, &wording::NO_LOWER_END)?, false),
        };
        let is_number = |placed: &Placed| matches!(placed.token, Token::Number(_));
        let bounds = |signs: [char; 2], turned: [char; 2]| {
            self.tokens[..at].windows(2).any(|pair| {
                let is = |placed: &Placed, signs: [char; 2]| signs.into_iter().any(|sign| placed.is(sign));
                is(&pair[0], signs) && is_number(&pair[1]) || is_number(&pair[0]) && is(&pair[1], turned)
            })
        };
        let (above, below) = (bounds(['>', '≥'], ['<', '≤']), bounds(['<', '≤'], ['>', '≥']));
        (if is_upper { above && !below } else { below && !above }).then_some(next)
    }
}
