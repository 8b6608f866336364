//! Lines and directions in words: `to the line of centres`, `perpendicular to AB`, `away from A`.

use super::centres;
use super::lexicon;
use super::names;
use super::phrases::{Phrase, Walk};
use super::tokens::{Placed, Token};
use super::units::is_unit_word;
use super::{ReferenceLine, Unreadable, wording};
use crate::expr::Expr;

/// So many words beside a line may be said of it: not all of an answer is looked through for each.
const FEW_WORDS: usize = 12;

/// A noun that names a line.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Line {
    Centres,
    Tangent,
    /// `AB`
    Ab,
    AToB,
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

impl Walk<'_> {
    /// A reference line with the words before it, or such words before a vector.
    pub(super) fn reference(&self, at: usize) -> Result<Option<(Phrase, usize)>, Unreadable> {
        if let Some((sense, end)) = self.sense(at) {
            return Ok(Some((Phrase::Line(sense), end)));
        }
        if let Some((relation, next)) = self.relation(at) {
            if relation == Relation::Angle
                && let Some(end) = self.minus_i(next)
            {
                return Ok(Some((Phrase::Line(ReferenceLine::MinusI), end)));
            }
            // `to the line perpendicular to AB`
            let named = || self.any(self.article(next), &["line", "direction"]);
            let on_it = || Some((Line::Centres, centres::on_it(|at| self.word(at), next)?));
            let axis = || self.axis(next).filter(|_| relation == Relation::Angle);
            if let Some((line, end)) = self.line(next).or_else(|| self.line(named()?)).or_else(on_it).or_else(axis) {
                // `24 N s on the wall`: what it acts on.
                if line == Line::Tangent && self.words(at, "on").is_some() && self.is_wall(next) {
                    return Ok(Some((Phrase::Remark, end)));
                }
                // `in the direction AB` has a sense, and `parallel to AB` has none.
                let line = match line {
                    Line::Ab if self.any(at, &["in direction", "direction of"]).is_some() => Line::AToB,
                    Line::Ab if self.any(at, &["parallel", "in direction parallel"]).is_some() => Line::Centres,
                    line => line,
                };
                let said = match (relation, line) {
                    (Relation::Along, Line::I | Line::J) => return Ok(Some((Phrase::Toward, self.article(next)))),
                    (Relation::Angle, Line::Centres) => Some(ReferenceLine::LineOfCentres),
                    // `6.35 m/s away from the wall` is a way to go, `18.4° away from it` an angle.
                    (Relation::Angle, Line::Tangent) if self.any(at, &wording::AWAY_FROM).is_some() => {
                        let is_angle = at > 0 && self.tokens[at - 1].is('°');
                        is_angle.then_some(ReferenceLine::CommonTangent)
                    }
                    (Relation::Angle, Line::Tangent) => Some(ReferenceLine::CommonTangent),
                    (Relation::Angle, Line::Ab) => Some(ReferenceLine::LineAB),
                    (Relation::Angle, Line::AToB) => Some(ReferenceLine::FromAToB),
                    (Relation::Angle, Line::BToA) => Some(ReferenceLine::FromBToA),
                    (Relation::Angle, Line::I) => Some(ReferenceLine::I),
                    (Relation::Angle, Line::J) => Some(ReferenceLine::J),
                    (Relation::Angle, Line::Original) => Some(ReferenceLine::OriginalDirection),
                    (Relation::Along, Line::Centres) | (Relation::Across, Line::Tangent) => {
                        Some(ReferenceLine::AlongLineOfCentres)
                    }
                    (Relation::Along, Line::Ab) => Some(ReferenceLine::AlongAB),
                    (Relation::Along, Line::AToB) => Some(ReferenceLine::AlongAToB),
                    (Relation::Along, Line::BToA) => Some(ReferenceLine::AlongBToA),
                    (Relation::Along, Line::Tangent)
                    | (Relation::Across, Line::Centres | Line::Ab | Line::AToB | Line::BToA) => {
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
                && let Some(end) = self.unknown_line(next).or_else(|| self.vector_of_angle(at, next))
            {
                let place = self.tokens[end].start;
                return Err(Unreadable::Sign(
                    place,
                    "the line from which the angle is measured is not known".to_owned(),
                ));
            }
            return Ok(None);
        }
        // `in the i direction`, `in the -i direction`, `in the +i direction`
        let is_sign = |at: usize| self.tokens.get(at).is_some_and(|sign| sign.is('-') || sign.is('+'));
        if let Some(next) = self.words(at, "in").map(|next| self.article(next))
            && self.unit_vector(next + usize::from(is_sign(next))).is_some()
        {
            return Ok(Some((Phrase::Toward, next)));
        }
        // `in the line of centres`, `down the line of centres`, `in LOC direction`
        if let Some(next) = self.any(at, &["in", "down", "up"])
            && let Some((Line::Centres | Line::Ab, end)) = self.line(next)
        {
            return Ok(Some((Phrase::Line(ReferenceLine::AlongLineOfCentres), end)));
        }
        if let Some(next) = self.any(at, &["in tangential direction", "tangentially"]) {
            return Ok(Some((Phrase::Line(ReferenceLine::AlongCommonTangent), next)));
        }
        // The line alone names itself, `line of centres = …`, or is the whole answer.
        let whole = self.stands_alone(at);
        Ok(match self.line(at) {
            Some((Line::Centres, end)) if whole(end) => Some((Phrase::Line(ReferenceLine::AlongLineOfCentres), end)),
            Some((Line::Ab, end)) if whole(end) => Some((Phrase::Line(ReferenceLine::AlongAB), end)),
            Some((Line::AToB, end)) if whole(end) => Some((Phrase::Line(ReferenceLine::AlongAToB), end)),
            Some((Line::BToA, end)) if whole(end) => Some((Phrase::Line(ReferenceLine::AlongBToA), end)),
            Some((Line::Centres | Line::Tangent | Line::Ab | Line::AToB, end)) => Some((Phrase::Noun, end)),
            _ => None,
        })
    }

    /// Is what begins here all that is said, or all that is said of a sphere?
    fn stands_alone(&self, at: usize) -> impl Fn(usize) -> bool {
        let parts = |placed: Option<&Placed>| {
            placed.is_none_or(|placed| matches!(placed.token, Token::Sign(':' | ';' | ',' | '\n' | '.' | '=' | '"')))
        };
        let begins = parts(at.checked_sub(1).and_then(|before| self.tokens.get(before)));
        move |end| {
            let next = self.tokens.get(end);
            begins && parts(next) && !next.is_some_and(|next| next.is('=') || next.is(':'))
        }
    }

    /// `towards A`, `away from the sphere B`, `from A to B`: a sense, without the line along which it is.
    fn sense(&self, at: usize) -> Option<(ReferenceLine, usize)> {
        let led = self.any(at, &wording::IN_THE_SENSE).map_or(at, |next| self.article(next));
        if let Some(found) = self.one_to_the_other(led).filter(|(_, end)| led > at || self.is_a_way(at, *end)) {
            return Some(found);
        }
        let (next, towards) = match self.any(at, &wording::AWAY_FROM) {
            Some(next) => (next, false),
            None => (self.any(at, &wording::TOWARDS)?, true),
        };
        let next = self.any(self.article(next), &["sphere", "ball", "particle"]).unwrap_or(self.article(next));
        // `in the direction of A's motion`
        if next >= self.tokens.len() || self.is_possessive(next) {
            return None;
        }
        match (self.typed(next), towards) {
            ("B", true) | ("A", false) => Some((ReferenceLine::TowardsB, next + 1)),
            ("A", true) | ("B", false) => Some((ReferenceLine::TowardsA, next + 1)),
            _ => None,
        }
    }

    /// `from A to B`, `A to B`, `A → B`.
    fn one_to_the_other(&self, at: usize) -> Option<(ReferenceLine, usize)> {
        let first = self.words(at, "from").unwrap_or(at);
        let sphere = |at: usize| (at < self.tokens.len()).then(|| self.typed(at));
        let next = match self.tokens.get(first + 1) {
            Some(arrow) if arrow.is('⇒') => first + 2,
            _ => self.any(first + 1, &["to", "towards"])?,
        };
        match (sphere(first)?, sphere(next)?) {
            ("A", "B") => Some((ReferenceLine::AlongAToB, next + 1)),
            ("B", "A") => Some((ReferenceLine::AlongBToA, next + 1)),
            _ => None,
        }
    }

    /// Is `A to B` from here to there a way to go: after `from`, or behind a value with nothing more said of *B*?
    fn is_a_way(&self, at: usize, end: usize) -> bool {
        let is_measure = |placed: &Placed| match &placed.token {
            Token::Number(_) | Token::Sign(')' | '(' | '°' | ',') => true,
            Token::Word(word) => is_unit_word(word),
            _ => false,
        };
        // `2:3 (A to B)` says which of the two comes first.
        let is_ratio = |three: &[Placed]| {
            let is_number = |placed: &Placed| matches!(placed.token, Token::Number(_));
            three[1].is(':') && is_number(&three[0]) && is_number(&three[2])
        };
        let is_after_value = at > 0 && is_measure(&self.tokens[at - 1]) && !self.tokens[..at].windows(3).any(is_ratio);
        let ends = |next: &Placed| matches!(next.token, Token::Sign(')' | ',' | ';' | '.' | '\n'));
        self.words(at, "from").is_some() || is_after_value && self.tokens.get(end).is_none_or(ends)
    }

    fn relation(&self, at: usize) -> Option<(Relation, usize)> {
        let across = self.any(at, &wording::ACROSS).or_else(|| self.at_ninety_degrees(at));
        if let Some(next) = across {
            return Some((Relation::Across, self.any(next, &["to", "with", "from"]).unwrap_or(next)));
        }
        if let Some(next) = self.any(at, &wording::ALONG) {
            return Some((Relation::Along, next));
        }
        self.any(at, &wording::ANGLE).map(|next| (Relation::Angle, next))
    }

    /// `at 90° to`
    fn at_ninety_degrees(&self, at: usize) -> Option<usize> {
        let next = self.words(at, "at")?;
        let ninety = self.tokens.get(next)?.token == Token::Number(Expr::integer(90));
        (ninety && self.tokens.get(next + 1)?.is('°')).then_some(next + 2)
    }

    fn line(&self, at: usize) -> Option<(Line, usize)> {
        let at = self.article(at);
        let at = at + usize::from(self.is_possessive(at) && !self.is_line_named_before(at));
        let across = self.any(at, &["perpendicular", "perp", "normal"]);
        if let Some(next) = across.and_then(|next| self.any(next, &["to", "of", "from"])) {
            let next = self.article(next);
            let on_it = || Some((Line::Centres, centres::on_it(|at| self.word(at), next)?));
            return match self.plain_line(next).or_else(on_it)? {
                (Line::Centres | Line::Ab, end) => Some((Line::Tangent, end)),
                (Line::Tangent, end) => Some((Line::Centres, end)),
                _ => None,
            };
        }
        self.plain_line(at)
    }

    /// A line by its own name.
    pub(super) fn plain_line(&self, at: usize) -> Option<(Line, usize)> {
        let known = [
            (Line::Ab, &["ab"][..]),
            (Line::AToB, &wording::A_TO_B),
            (Line::BToA, &wording::B_TO_A),
            (Line::Centres, &wording::CENTRES),
            (Line::Tangent, &wording::TANGENT),
            (Line::I, &["x axis"]),
            (Line::J, &["y axis"]),
        ];
        let longest = known
            .into_iter()
            .filter_map(|(line, spellings)| Some((line, self.any(at, spellings)?)))
            .chain(centres::described(|at| self.word(at), at).map(|next| (Line::Centres, next)))
            .chain(self.original(at).map(|next| (Line::Original, next)))
            .max_by_key(|(_, next)| *next);
        let (line, next) = match longest {
            Some(found) => found,
            None => self.unit_vector(at).map(|line| (line, at + 1))?,
        };
        let next = self.any(next, &wording::AFTER_A_LINE).unwrap_or(next);
        Some((line, next))
    }

    /// `original direction`, `velocity before`; a path is always that which was gone before.
    fn original(&self, at: usize) -> Option<usize> {
        if let Some(next) = self.any(at, &wording::ORIGINAL) {
            return self.any(next, &wording::MOTION);
        }
        let before = self.any(at, &wording::MOTION).and_then(|next| self.words(next, "before"));
        before.or_else(|| self.words(at, "path"))
    }

    /// `the tangent makes 81.9° with A's path`: the line is the one that is named first.
    fn is_line_named_before(&self, at: usize) -> bool {
        (at.saturating_sub(FEW_WORDS)..at).any(|before| {
            self.plain_line(before).is_some_and(|(line, _)| matches!(line, Line::Centres | Line::Tangent | Line::Ab))
        })
    }

    /// `A's`
    pub(super) fn is_possessive(&self, at: usize) -> bool {
        self.tokens.get(at).is_some_and(|placed| {
            let typed = self.typed(at);
            lexicon::is_sphere(typed) && placed.end - placed.start > typed.len()
        })
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
        if self.is_some_course(noun) {
            return Some(noun);
        }
        let word = self.word(noun)?;
        // `to the perpendicular`: to what?
        if matches!(word, "perpendicular" | "perp") {
            return Some(noun);
        }
        let harmless = lexicon::sort(word).is_some()
            || self.any(noun, &wording::REST).is_some()
            || self.any(noun, &wording::REMARKS).is_some()
            || is_unit_word(self.typed(noun))
            || lexicon::is_sphere(self.typed(noun))
            || names::is_made_of_letters(self.typed(noun), self.vocabulary);
        (!harmless || matches!(word, "horizontal" | "vertical")).then_some(noun)
    }

    /// `78.7° to the vector 2i + j`: where the vector begins from which the angle before is measured.
    fn vector_of_angle(&self, at: usize, next: usize) -> Option<usize> {
        let start = self.of_a_vector(next);
        let is_unit =
            |placed: &Placed| matches!(&placed.token, Token::Word(word) if matches!(word.as_str(), "i" | "j"));
        let ends = |placed: &Placed| matches!(placed.token, Token::Sign(',' | ';' | '\n' | '=' | '⇒'));
        let after_angle = at > 0 && self.tokens[at - 1].is('°');
        let mut vector = self.tokens.get(start..)?.iter().take_while(|placed| !ends(placed));
        (after_angle && self.vocabulary.vectors && self.is_formula(start) && vector.any(is_unit)).then_some(start)
    }

    /// Is it the wall itself that is named, and not its line or its direction?
    fn is_wall(&self, at: usize) -> bool {
        self.any(self.article(at), &["wall", "smooth wall", "vertical wall"]).is_some()
    }

    /// `B's path`, `the way that it was going`, `velocity of B`, where no value follows: some line, but which?
    fn is_some_course(&self, from: usize) -> bool {
        // `to the right along the line of centres`, `moves off along AB`
        let goes_on = |at: &usize| {
            self.word(*at).is_some_and(|word| {
                !matches!(word, "in" | "at" | "and" | "so" | "because" | "when" | "after" | "along")
            })
        };
        let most = self.tokens.len().min(from + FEW_WORDS);
        let end = (from..most).find(|at| !goes_on(at)).unwrap_or(most);
        let is_value = self.tokens.get(end).is_some_and(|next| next.is('=') || self.is_formula(end));
        let is_whose = |at| lexicon::is_sphere(self.typed(at)) || self.any(at, &wording::ORIGINAL).is_some();
        let tells = |at| {
            self.word(at).is_some_and(|word| wording::COURSES.contains(&word))
                || self.words(at, "velocity").is_some() && (from..end).any(is_whose)
        };
        // `to the line` is that of which the question speaks.
        let is_line_alone = end == from + 1 && self.word(from) == Some("line");
        !is_value && !is_line_alone && (from..end).any(tells) && !self.is_line_named_before(from)
    }
}
