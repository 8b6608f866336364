//! Words that are no formula: reference lines, rest, labels, and what says nothing about the value.

use super::asides::with_asides_set_off;
use super::lexicon::{self, Sort};
use super::signs::with_signs;
use super::tokens::{Placed, Token, is_greek};
use super::units::is_unit_word;
use super::{ReferenceLine, Unreadable, Vocabulary, names};
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
    /// `is`
    Is,
    /// `of`, `the`, `both move to the right`
    Remark,
    /// A word of some language that says nothing here: after a value it may change what it is.
    Unknown,
}

/// A noun that names a line.
#[derive(Clone, Copy, PartialEq)]
enum Line {
    Centres,
    Tangent,
    BToA,
    I,
    J,
    Original,
}

/// How words before it relate to the line.
#[derive(Clone, Copy, PartialEq)]
enum Relation {
    Angle,
    Along,
    Across,
}

/// The tokens with words that are no formula understood, and those for signs (`times`, `over`) put as signs.
pub(super) fn with_phrases(tokens: &[Placed], vocabulary: &Vocabulary) -> Result<Vec<Placed>, Unreadable> {
    let tokens = with_signs(tokens);
    let small = |placed: &Placed| match &placed.token {
        Token::Word(word) => word.to_ascii_lowercase(),
        _ => String::new(),
    };
    let walk = Walk { tokens: &tokens, words: tokens.iter().map(small).collect(), vocabulary };
    let mut out: Vec<Placed> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let found = match walk.accuracy(at).or_else(|| walk.named_equation(at)) {
            Some(next) => Some((Phrase::Remark, next)),
            None => walk.phrase(at)?,
        };
        match found {
            Some((phrase, next)) => {
                let (first, last) = (&tokens[at], &tokens[next - 1]);
                let token = Token::Phrase(phrase);
                out.push(Placed { token, start: first.start, end: last.end, spaced: first.spaced });
                at = next;
            }
            None => {
                out.push(tokens[at].clone());
                at += 1;
            }
        }
    }
    Ok(with_asides_set_off(out))
}

/// The words of an answer, to be looked through for what they say.
pub(super) struct Walk<'a> {
    pub(super) tokens: &'a [Placed],
    /// The words in small letters; nothing for other tokens.
    words: Vec<String>,
    vocabulary: &'a Vocabulary,
}

impl Walk<'_> {
    /// The word at a token, in small letters.
    fn word(&self, at: usize) -> Option<&str> {
        self.words.get(at).map(String::as_str).filter(|word| !word.is_empty())
    }

    /// Do these words stand here? The token after them, stops and articles passed over.
    fn words(&self, at: usize, words: &str) -> Option<usize> {
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
    fn article(&self, at: usize) -> usize {
        // A small `a` is an article; a capital is a sphere.
        let small_a = matches!(self.tokens.get(at).map(|placed| &placed.token), Some(Token::Word(word)) if word == "a");
        match self.word(at) {
            Some("the" | "its" | "their" | "it's" | "this" | "his" | "an") => at + 1,
            Some("a") if small_a => at + 1,
            _ => at,
        }
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
            if let Some(next) = self.any(at, &lexicon::REST) {
                return Ok(Some((Phrase::Rest, next)));
            }
            if let Some(found) = self.reference(at)? {
                return Ok(Some(found));
            }
            if let Some(next) = self.any(at, &lexicon::REMARKS) {
                return Ok(Some((Phrase::Remark, next)));
            }
        }
        // `i component`, `x component`
        if self.vocabulary.vectors
            && matches!(word, "i" | "j" | "x" | "y")
            && let Some(next) = self.any(at + 1, &["component", "comp"])
        {
            return Ok(Some((Phrase::Noun, next)));
        }
        let made_of_letters = names::is_made_of_letters(self.typed(at), self.vocabulary);
        let sort = lexicon::sort(word);
        if let Some(Sort::Negation) = sort {
            return Err(Unreadable::Sign(placed.start, format!("`{word}` may turn the answer round")));
        }
        if made_of_letters && (word.len() < 4 || sort.is_none()) {
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
            Some(Sort::Plain) => Phrase::Remark,
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

    fn typed(&self, at: usize) -> &str {
        match &self.tokens[at].token {
            Token::Word(word) => word,
            _ => "",
        }
    }

    /// A reference line with the words before it, or such words before a vector.
    fn reference(&self, at: usize) -> Result<Option<(Phrase, usize)>, Unreadable> {
        if let Some((relation, next)) = self.relation(at) {
            if relation == Relation::Angle
                && let Some(end) = self.minus_i(next)
            {
                return Ok(Some((Phrase::Line(ReferenceLine::MinusI), end)));
            }
            if let Some((line, end)) = self.line(next) {
                let said = match (relation, line) {
                    (Relation::Along, Line::I | Line::J) => return Ok(Some((Phrase::Toward, self.article(next)))),
                    (Relation::Angle, Line::Centres) => Some(ReferenceLine::LineOfCentres),
                    (Relation::Angle, Line::Tangent) => Some(ReferenceLine::CommonTangent),
                    (Relation::Angle, Line::BToA) => Some(ReferenceLine::FromBToA),
                    (Relation::Angle, Line::I) => Some(ReferenceLine::I),
                    (Relation::Angle, Line::J) => Some(ReferenceLine::J),
                    (Relation::Angle, Line::Original) => Some(ReferenceLine::OriginalDirection),
                    (Relation::Along, Line::Centres | Line::BToA) | (Relation::Across, Line::Tangent) => {
                        Some(ReferenceLine::AlongLineOfCentres)
                    }
                    (Relation::Along, Line::Tangent) | (Relation::Across, Line::Centres | Line::BToA) => {
                        Some(ReferenceLine::AlongCommonTangent)
                    }
                    _ => None,
                };
                return Ok(Some((said.map_or(Phrase::Remark, Phrase::Line), end)));
            }
            // `in direction 43.9° to AB` begins with an angle, and no vector.
            let angle = self.words(at, "in").is_some()
                && matches!(self.tokens.get(next).map(|placed| &placed.token), Some(Token::Number(_)));
            if relation == Relation::Along && !angle && self.is_formula(self.article(next)) {
                return Ok(Some((Phrase::Toward, self.article(next))));
            }
            if relation == Relation::Across
                && self.vocabulary.vectors
                && self.word(next - 1) == Some("to")
                && self.is_formula(self.article(next))
            {
                return Ok(Some((Phrase::Across, self.article(next))));
            }
            if relation == Relation::Angle
                && let Some(end) = self.unknown_line(next)
            {
                let place = self.tokens[end].start;
                return Err(Unreadable::Sign(
                    place,
                    "the line from which the angle is measured is not known".to_owned(),
                ));
            }
            return Ok(None);
        }
        // `in the i direction`, `in the -i direction`
        if let Some(next) = self.words(at, "in").map(|next| self.article(next))
            && self.unit_vector(next + usize::from(self.tokens.get(next).is_some_and(|sign| sign.is('-')))).is_some()
        {
            return Ok(Some((Phrase::Toward, next)));
        }
        // The line alone names itself: `line of centres = …`.
        Ok(match self.line(at) {
            Some((Line::Centres | Line::Tangent, end)) => Some((Phrase::Noun, end)),
            _ => None,
        })
    }

    fn relation(&self, at: usize) -> Option<(Relation, usize)> {
        let across = self.any(at, &lexicon::ACROSS).or_else(|| self.at_ninety_degrees(at));
        if let Some(next) = across {
            return Some((Relation::Across, self.any(next, &["to", "with", "from"]).unwrap_or(next)));
        }
        if let Some(next) = self.any(at, &lexicon::ALONG) {
            return Some((Relation::Along, next));
        }
        self.any(at, &lexicon::ANGLE).map(|next| (Relation::Angle, next))
    }

    /// `at 90° to`
    fn at_ninety_degrees(&self, at: usize) -> Option<usize> {
        let next = self.words(at, "at")?;
        let ninety = self.tokens.get(next)?.token == Token::Number(Expr::integer(90));
        (ninety && self.tokens.get(next + 1)?.is('°')).then_some(next + 2)
    }

    fn line(&self, at: usize) -> Option<(Line, usize)> {
        let at = self.article(at);
        let across = self.any(at, &["perpendicular", "perp", "normal"]);
        if let Some(next) = across.and_then(|next| self.any(next, &["to", "of", "from"])) {
            let next = self.article(next);
            return match self.plain_line(next)? {
                (Line::Centres, end) => Some((Line::Tangent, end)),
                (Line::Tangent, end) => Some((Line::Centres, end)),
                _ => None,
            };
        }
        self.plain_line(at)
    }

    /// A line by its own name.
    fn plain_line(&self, at: usize) -> Option<(Line, usize)> {
        let known = [
            (Line::BToA, &lexicon::B_TO_A[..]),
            (Line::Centres, &lexicon::CENTRES),
            (Line::Tangent, &lexicon::TANGENT),
            (Line::Original, &lexicon::ORIGINAL),
            (Line::I, &["x axis"]),
            (Line::J, &["y axis"]),
        ];
        let longest = known
            .into_iter()
            .filter_map(|(line, spellings)| Some((line, self.any(at, spellings)?)))
            .max_by_key(|(_, next)| *next);
        let (line, next) = match longest {
            Some(found) => found,
            None => self.unit_vector(at).map(|line| (line, at + 1))?,
        };
        let next = self.any(next, &lexicon::AFTER_A_LINE).unwrap_or(next);
        Some((line, next))
    }

    /// A unit vector that stands alone, not as the first term of a vector.
    fn unit_vector(&self, at: usize) -> Option<Line> {
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

    /// `-i`, `the negative i direction`: the token after it.
    fn minus_i(&self, at: usize) -> Option<usize> {
        let at = self.article(at);
        let turned = self.tokens.get(at).is_some_and(|token| token.is('-')) || self.word(at) == Some("negative");
        let (line, end) = self.plain_line(at + 1).filter(|_| turned)?;
        (line == Line::I).then(|| self.any(end, &["axis"]).unwrap_or(end))
    }

    /// Does a formula begin here?
    fn is_formula(&self, at: usize) -> bool {
        match self.tokens.get(at).map(|placed| &placed.token) {
            Some(Token::Word(word)) => names::is_made_of_letters(word, self.vocabulary),
            Some(Token::Number(_) | Token::Sign('(' | '-' | '+' | '⟦' | '[')) => true,
            _ => false,
        }
    }

    /// A noun that could be a line, but is none that we know: its token.
    fn unknown_line(&self, at: usize) -> Option<usize> {
        let noun = self.article(at);
        let word = self.word(noun)?;
        let harmless = lexicon::sort(word).is_some()
            || self.any(noun, &lexicon::REST).is_some()
            || self.any(noun, &lexicon::REMARKS).is_some()
            || is_unit_word(self.typed(noun))
            || lexicon::is_sphere(self.typed(noun))
            || names::is_made_of_letters(self.typed(noun), self.vocabulary);
        (!harmless || matches!(word, "horizontal" | "vertical")).then_some(noun)
    }
}
