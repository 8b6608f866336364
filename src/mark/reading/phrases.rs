//! Words that are no formula: reference lines, rest, labels, and what says nothing about the value.

use std::borrow::Cow;

use super::asides::{unit_before_accuracy, with_asides_set_off};
use super::choices::Choices;
use super::lexicon::{self, Sort};
use super::signs::with_signs;
use super::tokens::{Placed, Token, is_greek};
use super::units::is_unit_word;
use super::{ReferenceLine, Unreadable, Vocabulary, names, wording};
use crate::expr::Expr;

/// What words say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phrase {
    /// `to the line of centres`
    Line(ReferenceLine),
    /// `parallel to`, `in the direction of`, before a vector.
    Toward,
    /// `perpendicular to`, before a vector.
    Across,
    /// `at rest`
    Rest,
    /// `gradient`
    Gradient,
    /// `because`: what follows is no part of the answer.
    Because,
    /// `so`, `and`: another statement may follow.
    Joiner,
    /// `or`: a rival.
    Or,
    /// `speed`, `KE`: names what is stated.
    Noun,
    /// `A`: a sphere.
    Sphere,
    /// `or less`: what stands before it is the highest that there can be.
    OrLess,
    /// `or more`
    OrMore,
    /// `but not including`: what follows is no part of a range.
    Excluding,
    /// `(not included)`: is the end before it part of its range?
    End { included: bool },
    /// `is`
    Is,
    /// `of`, `the`, `both move to the right`
    Remark,
    /// A word of some language that says nothing here: after a value it may change what it is.
    Unknown,
}

/// The tokens with words that are no formula understood, and those for signs (`times`, `over`) put as signs.
pub(super) fn with_phrases(
    tokens: &[Placed],
    vocabulary: &Vocabulary,
    choices: &mut Choices,
) -> Result<Vec<Placed>, Unreadable> {
    let tokens = with_signs(tokens, vocabulary, choices);
    let walk = Walk { tokens: &tokens, words: tokens.iter().map(in_small_letters).collect(), vocabulary };
    if let Some(whole) = walk.in_a_word() {
        return Ok(whole);
    }
    let mut out: Vec<Placed> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    // Does a word stand before that names or says something?
    let mut after_words = false;
    while at < tokens.len() {
        if after_words && walk.is_added(at, &out) {
            return Err(Unreadable::Sign(tokens[at].start, "something is added to words".to_owned()));
        }
        let accuracy = walk.accuracy(at);
        let after_number = matches!(out.last().map(|last| &last.token), Some(Token::Number(_)));
        if let Some(end) = accuracy.and_then(|next| unit_before_accuracy(&tokens, after_number, next)) {
            out.extend(accuracy.map(|next| &tokens[next..end]).into_iter().flatten().cloned());
            at = end;
            continue;
        }
        if let Some((next, set_off)) = walk.denial(at) {
            let comma = Placed { token: Token::Sign(','), ..tokens[at].clone() };
            out.extend(Some(comma).filter(|_| !set_off));
            let (token, end) = (Token::Phrase(Phrase::Remark), tokens[next - 1].end);
            out.push(Placed { token, end, ..tokens[at].clone() });
            at = next;
            continue;
        }
        if let Some((word, next)) = walk.second_thought(at) {
            let comma = Placed { token: Token::Sign(','), ..word.clone() };
            out.extend([Placed { token: Token::Phrase(Phrase::Remark), ..word }, comma]);
            at = next;
            continue;
        }
        if let Some(next) = walk.fresh_start(at) {
            at = next;
            continue;
        }
        let remark = accuracy.or_else(|| walk.named_equation(at)).or_else(|| walk.positive_direction(at));
        let remark = remark.or_else(|| walk.equal_and_opposite(at));
        let found = match remark.or_else(|| walk.meeting(at)) {
            Some(next) => Some((Phrase::Remark, next)),
            None => walk.end_told(at).map_or_else(|| walk.phrase(at), |found| Ok(Some(found)))?,
        };
        after_words = matches!(found, Some((Phrase::Remark | Phrase::Noun | Phrase::Sphere | Phrase::Unknown, next))
            if tokens[at..next].iter().all(|placed| matches!(placed.token, Token::Word(_))));
        match found {
            Some((phrase, next)) => {
                let (first, last) = (&tokens[at], &tokens[next - 1]);
                let token = Token::Phrase(phrase);
                out.push(Placed { token, start: first.start, end: last.end, spaced: first.spaced });
                // `from A's path` is said of A.
                let whose = (at..next)
                    .find(|at| phrase == Phrase::Line(ReferenceLine::OriginalDirection) && walk.is_possessive(*at));
                out.extend(whose.map(|at| Placed {
                    token: Token::Phrase(Phrase::Sphere),
                    end: tokens[at].start + walk.typed(at).len(),
                    ..tokens[at].clone()
                }));
                // `below i` tells a side, too.
                let is_side = matches!(phrase, Phrase::Line(_)) && matches!(walk.word(at), Some("above" | "below"));
                out.extend(is_side.then(|| Placed { token: Token::Phrase(Phrase::Remark), ..tokens[at].clone() }));
                at = next;
            }
            None => {
                out.push(tokens[at].clone());
                at += 1;
            }
        }
    }
    Ok(with_asides_set_off(out, vocabulary, choices))
}

/// A word in small letters, as it is spelt in Britain; nothing for another token.
fn in_small_letters(placed: &Placed) -> Cow<'_, str> {
    match &placed.token {
        Token::Word(word) if word.eq_ignore_ascii_case("center") => Cow::Borrowed("centre"),
        Token::Word(word) if word.eq_ignore_ascii_case("centers") => Cow::Borrowed("centres"),
        Token::Word(word) if word.contains(|sign: char| sign.is_ascii_uppercase()) => {
            Cow::Owned(word.to_ascii_lowercase())
        }
        Token::Word(word) => Cow::Borrowed(word),
        _ => Cow::Borrowed(""),
    }
}

/// The words of an answer, to be looked through for what they say.
pub(super) struct Walk<'a> {
    pub(super) tokens: &'a [Placed],
    /// The words in small letters; nothing for other tokens.
    words: Vec<Cow<'a, str>>,
    pub(super) vocabulary: &'a Vocabulary,
}

impl Walk<'_> {
    /// `rest`, `perfectly elastic`: an answer that is no more than that, by what it says.
    fn in_a_word(&self) -> Option<Vec<Placed>> {
        let first = self.tokens.first()?;
        let place = |token: Token| Placed { token, end: self.tokens[self.tokens.len() - 1].end, ..first.clone() };
        let is_all = |words: &[&str]| self.any(self.article(0), words) == Some(self.tokens.len());
        if self.any(0, &wording::REST_ALONE) == Some(self.tokens.len()) {
            return Some(vec![place(Token::Phrase(Phrase::Rest))]);
        }
        let is_one = [Token::Word("e".to_owned()), Token::Sign('='), Token::Number(Expr::integer(1))];
        is_all(&wording::ELASTIC).then(|| is_one.into_iter().map(place).collect())
    }

    /// The word at a token, in small letters.
    pub(super) fn word(&self, at: usize) -> Option<&str> {
        self.words.get(at).map(Cow::as_ref).filter(|word| !word.is_empty())
    }

    /// Do these words stand here? The token after them, stops and articles passed over.
    pub(super) fn words(&self, at: usize, words: &str) -> Option<usize> {
        let mut at = at;
        // Nearly always the first word tells.
        if words.strip_prefix(self.word(at)?)?.bytes().next().is_some_and(|byte| byte != b' ') {
            return None;
        }
        for (place, wanted) in words.split(' ').enumerate() {
            if place > 0 {
                at = self.article(at);
            }
            if self.word(at)? != wanted {
                return None;
            }
            at += 1;
        }
        Some(at)
    }

    pub(super) fn any(&self, at: usize, choices: &[&str]) -> Option<usize> {
        choices.iter().filter_map(|words| self.words(at, words)).max()
    }

    /// Passes over `the`, `its` and the like.
    pub(super) fn article(&self, at: usize) -> usize {
        // A small `a` is an article; a capital is a sphere.
        let small_a = matches!(self.tokens.get(at).map(|placed| &placed.token), Some(Token::Word(word)) if word == "a");
        match self.word(at) {
            Some("the" | "its" | "their" | "it's" | "this" | "his" | "an") => at + 1,
            Some("a") if small_a => at + 1,
            _ => at,
        }
    }

    /// `A + 2`, `v = B - 2`, `a + arctan(e)`: is a number or formula added to what stands before it, or taken off, and no sign of its own? At the
    /// beginning a minus may be a dash, but not after an article.
    fn is_added(&self, at: usize, before: &[Placed]) -> bool {
        let (Some(sign), Some(next)) = (self.tokens.get(at), self.tokens.get(at + 1)) else { return false };
        let ends = |placed: &&Placed| !matches!(placed.token, Token::Sign(',' | ';' | ':' | '\n' | '⇒'));
        let is_side = || before.iter().rev().take_while(ends).any(|placed| placed.is('=') || placed.is('≈'));
        let is_article = || at > 0 && self.article(at - 1) == at;
        let is_sign = sign.is('+') || sign.is('-') && (is_side() || is_article());
        let is_term = match &next.token {
            Token::Number(_) | Token::Root { .. } | Token::Greek(_) | Token::Sign('(') => true,
            Token::Word(_) => self.word(at + 1).is_some_and(|word| lexicon::sort(word).is_none()),
            _ => false,
        };
        is_sign && sign.spaced == next.spaced && is_term
    }

    /// The phrase that begins at a token.
    fn phrase(&self, at: usize) -> Result<Option<(Phrase, usize)>, Unreadable> {
        let Some(word) = self.word(at) else { return Ok(None) };
        let placed = &self.tokens[at];
        let touches = at > 0 && !placed.spaced && matches!(self.tokens[at - 1].token, Token::Number(_));
        if touches && word.len() == 1 {
            return Ok(None);
        }
        if lexicon::begins_a_phrase(word) {
            if let Some(next) = self.any(at, &wording::REST) {
                return Ok(Some((Phrase::Rest, next)));
            }
            if let Some(found) = self.reference(at)? {
                return Ok(Some(found));
            }
            if let Some(next) = self.any(at, &wording::REMARKS) {
                return Ok(Some((Phrase::Remark, next)));
            }
            if let Some(next) = self.any(at, &wording::IS) {
                return Ok(Some((Phrase::Is, next)));
            }
        }
        // `i component`, `x-component`
        if self.vocabulary.vectors
            && matches!(word, "i" | "j" | "x" | "y")
            && let hyphen = usize::from(self.tokens.get(at + 1).is_some_and(|next| next.is('-') && !next.spaced))
            && let Some(next) = self.any(at + 1 + hyphen, &["component", "comp"])
        {
            return Ok(Some((Phrase::Noun, next)));
        }
        if !self.vocabulary.vectors
            && let Some(found) = self.end_of_range(at)
        {
            return Ok(Some(found));
        }
        if let Some(next) = self.no_further_end(at) {
            return Ok(Some((Phrase::Remark, next)));
        }
        let sort = lexicon::sort(word);
        // `2ke` is a product, and no energy.
        if touches && sort == Some(Sort::Noun) && word.len() == 2 && self.typed(at) == word {
            return Ok(None);
        }
        // `a(2)`, `a2` and `a = 2` have a letter, and no article.
        let begins = at == 0 || matches!(self.tokens[at - 1].token, Token::Sign(',' | ';' | '\n' | '⇒'));
        let is_letter = self.tokens.get(at + 1).is_some_and(|next| match next.token {
            Token::Number(_) | Token::Sign('(') => !next.spaced,
            Token::Sign('=') => begins,
            _ => false,
        });
        if is_letter && word.len() == 1 && sort == Some(Sort::Plain) {
            return Ok(None);
        }
        // `k = −8 (N/A)`
        let is = |at: usize, sign: char| self.tokens.get(at).is_some_and(|placed| placed.is(sign));
        if word == "n" && is(at + 1, '/') && self.word(at + 2) == Some("a") {
            return Ok(Some((Phrase::Remark, at + 3)));
        }
        if let Some(Sort::Negation) = sort {
            // `as no impulse acts there`
            let is_of_nothing = word == "no" && self.any(at + 1, &wording::NOTHING_OF).is_some();
            if (lexicon::COMPARISONS.contains(&word) || is_of_nothing) && self.is_in_a_reason(at) {
                return Ok(Some((Phrase::Remark, at + 1)));
            }
            return Err(Unreadable::Sign(placed.start, format!("`{word}` may turn the answer round")));
        }
        if !lexicon::stands_for_itself(word, sort) && names::is_made_of_letters(self.typed(at), self.vocabulary) {
            return Ok(None);
        }
        let alone = self.tokens.get(at + 1).is_none_or(|next| next.spaced || !matches!(next.token, Token::Number(_)));
        if lexicon::is_sphere(self.typed(at)) && !touches && alone {
            return Ok(Some((Phrase::Sphere, at + 1)));
        }
        let phrase = match sort {
            Some(Sort::Joiner) => Phrase::Joiner,
            Some(Sort::Because) => Phrase::Because,
            Some(Sort::Or) => Phrase::Or,
            Some(Sort::Noun) => Phrase::Noun,
            Some(Sort::Is) => Phrase::Is,
            Some(Sort::Gradient) => Phrase::Gradient,
            Some(Sort::Rejection | Sort::Plain) => Phrase::Remark,
            Some(Sort::Negation) | None => {
                if is_unit_word(self.typed(at)) || word == "per" {
                    return Ok(None);
                }
                // A long word that is none of mathematics is only a word.
                if touches || !alone || !lexicon::is_only_a_word(self.typed(at)) || is_greek(word) {
                    return Ok(None);
                }
                Phrase::Unknown
            }
        };
        Ok(Some((phrase, at + 1)))
    }

    /// `since it must be faster than A`, `reject the negative`: after `because`, and without figures, words say why and not
    /// what.
    fn is_in_a_reason(&self, at: usize) -> bool {
        let is_reason = |before: &usize| {
            // `as no impulse acts there`, but `as well as nothing`
            let is_as = self.words(*before, "as").is_some_and(|next| self.any(next, &["no", "there is no"]).is_some());
            let is = |word: &str| matches!(word, "because" | "since") || is_as || lexicon::is_rejection(word);
            self.word(*before).is_some_and(is)
        };
        let Some(reason) = (1..at).rev().find(is_reason) else { return false };
        !self.tokens[reason..].iter().any(|placed| matches!(placed.token, Token::Number(_) | Token::Root { .. }))
    }

    pub(super) fn typed(&self, at: usize) -> &str {
        match &self.tokens[at].token {
            Token::Word(word) => word,
            _ => "",
        }
    }
}
