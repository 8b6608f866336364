//! The axes and unit vectors from which angles are measured: `i`, `the vector i`, `the positive x-axis`, `the negative i direction`.

use super::directions::Line;
use super::phrases::Walk;
use super::tokens::Token;

impl Walk<'_> {
    /// A unit vector that stands alone, not as the first term of a vector.
    pub(super) fn unit_vector(&self, at: usize) -> Option<Line> {
        let more = self.tokens.get(at + 1).is_some_and(|next| matches!(next.token, Token::Sign('+' | '-' | '/' | '*')));
        match self.tokens.get(at).map(|placed| &placed.token) {
            Some(Token::Word(word)) if self.vocabulary.vectors && !more => match word.as_str() {
                "i" => Some(Line::I),
                "j" => Some(Line::J),
                _ => None,
            },
            _ => None,
        }
    }

    /// `the direction of the unit vector` before its name: the token after it.
    pub(super) fn of_a_vector(&self, at: usize) -> usize {
        let at = self.any(self.article(at), &["direction of"]).unwrap_or(at);
        self.any(self.article(at), &["vector", "unit vector"]).unwrap_or(self.article(at))
    }

    /// `the vector i`, `the direction of i`, `+i`, `the positive x-axis`
    pub(super) fn axis(&self, at: usize) -> Option<(Line, usize)> {
        let at = self.of_a_vector(at);
        let next = self.after_sign(at, '+', "positive").unwrap_or(at);
        let (line, end) = self.plain_line(next)?;
        matches!(line, Line::I | Line::J).then(|| (line, self.after_axis(end)))
    }

    /// `-i`, `the negative i direction`: the token after it.
    pub(super) fn minus_i(&self, at: usize) -> Option<usize> {
        let at = self.of_a_vector(at);
        let (line, end) = self.plain_line(self.after_sign(at, '-', "negative")?)?;
        (line == Line::I).then(|| self.after_axis(end))
    }

    /// `-`, `-ve` or `negative` before an axis: the token after it.
    fn after_sign(&self, at: usize, sign: char, word: &str) -> Option<usize> {
        if self.tokens.get(at).is_some_and(|token| token.is(sign)) {
            return Some(self.words(at + 1, "ve").unwrap_or(at + 1));
        }
        (self.word(at) == Some(word)).then_some(at + 1)
    }

    /// After the word for what a unit vector is the direction of: `-i axis`, `i-direction`.
    fn after_axis(&self, end: usize) -> usize {
        self.any(end, &["axis", "direction"]).unwrap_or(end)
    }
}
