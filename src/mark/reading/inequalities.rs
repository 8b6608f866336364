//! Inequalities: two in a row, `or` between them, `more than 3` without a letter, and ends that are infinite.

use super::lexicon::is_rejection;
use super::phrases::Phrase;
use super::ranges::{is_any, is_infinite, said};
use super::sides::Side;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::{End, Form, Said, SaidUnit, Statement, Unreadable};
use crate::expr::{Expr, Relation};

/// Is it the sign of an inequality?
pub(super) fn is_inequality(sign: char) -> bool {
    matches!(sign, '<' | '>' | '≤' | '≥')
}

/// Is there an inequality in it?
pub(super) fn has_inequality(tokens: &[Placed]) -> bool {
    tokens.iter().any(|placed| is_any(placed, &['<', '>', '≤', '≥']))
}

/// The sides of inequalities, and between each two their sign with its place.
type Chain<'s, 't> = (&'s [&'t [Placed]], &'s [(char, usize)]);

/// `3 < k < ∞` without the end that says nothing.
pub(super) fn without_infinite_ends<'s, 't>(
    sides: &'s [&'t [Placed]],
    relations: &'s [(char, usize)],
) -> Result<Chain<'s, 't>, Unreadable> {
    let (mut sides, mut relations) = (sides, relations);
    for (first, outwards) in [(true, '>'), (false, '<')] {
        let side = if first { sides[0] } else { sides[sides.len() - 1] };
        if !is_infinite(side) || sides.len() < 3 {
            continue;
        }
        let (sign, place) = if first { relations[0] } else { relations[relations.len() - 1] };
        // Nothing is above infinity, and nothing below minus infinity.
        let towards = if matches!(sign, '≤' | '<') { '<' } else { '>' };
        if !is_inequality(sign) || (towards == outwards) == side[0].is('-') {
            return Err(Unreadable::Sign(place, "nothing lies beyond infinity".to_owned()));
        }
        match first {
            true => (sides, relations) = (&sides[1..], &relations[1..]),
            false => (sides, relations) = (&sides[..sides.len() - 1], &relations[..relations.len() - 1]),
        }
    }
    Ok((sides, relations))
}

fn is_number(placed: &Placed) -> bool {
    matches!(placed.token, Token::Number(_))
}

impl Statements<'_> {
    /// `k < 2 or k > 3`: `or` between inequalities parts statements that are rivals.
    pub(super) fn alternatives(&mut self, tokens: &[Placed]) -> Result<(), Unreadable> {
        let is_or = |placed: &Placed| placed.token == Token::Phrase(Phrase::Or);
        let parts: Vec<&[Placed]> = tokens.split(is_or).collect();
        let is_inequality = |part: &&[Placed]| has_inequality(part);
        // `3 : 4 or 3/4`
        let is_ratio = |part: &[Placed]| matches!(part, [first, colon, ..] if is_number(first) && colon.is(':'));
        let is_said_again = parts.len() == 2 && is_ratio(parts[0]) && parts[1].first().is_some_and(is_number);
        if parts.len() == 1 || !(is_said_again || parts.iter().all(is_inequality)) {
            return self.chain(tokens);
        }
        for (place, part) in parts.into_iter().enumerate() {
            let before = self.found.len();
            self.chain(part)?;
            if place > 0
                && let Some(first) = self.found.get_mut(before).and_then(|found| found.said.first_mut())
            {
                first.remarks.push("or".to_owned());
            }
        }
        Ok(())
    }

    /// `A rebounds if e > 1/3`, `v < 0 for e > 1/3`: where the inequality begins that is the condition for what words
    /// alone say, or for the sign of another letter, and nothing else the answer. Which way a sphere then moves is for a person to see.
    pub(super) fn asked_condition(&self, tokens: &[Placed]) -> Option<usize> {
        let leads = |placed: &&Placed| {
            let word = self.slice(std::slice::from_ref(*placed)).to_lowercase();
            matches!(placed.token, Token::Phrase(_)) && matches!(&*word, "if" | "when" | "where" | "for")
        };
        let lead = tokens.iter().position(|placed| leads(&placed))?;
        let (words, condition) = tokens.split_at(lead);
        let is_condition = self.found.is_empty()
            && !self.vocabulary.vectors
            && (self.say_what_happens(words) || self.is_sign_of_another(words))
            && has_inequality(condition);
        let begins = condition.iter().take_while(|placed| matches!(placed.token, Token::Phrase(_))).count();
        is_condition.then_some(lead + begins)
    }

    /// `v < 0`, where no letter that is asked about stands in it.
    fn is_sign_of_another(&self, words: &[Placed]) -> bool {
        let is_strange = |placed: &Placed| match &placed.token {
            Token::Word(word) => !self.vocabulary.letters.iter().any(|letter| letter.name() == word),
            Token::Sign('<' | '>' | '≤' | '≥' | '_') | Token::Phrase(Phrase::Sphere) => true,
            Token::Number(number) => *number == Expr::integer(0),
            _ => false,
        };
        has_inequality(words) && words.iter().all(is_strange)
    }

    /// Do words alone say what happens, and not which way a sphere moves?
    fn say_what_happens(&self, words: &[Placed]) -> bool {
        const WAYS: [&str; 15] = [
            "less",
            "under",
            "below",
            "exactly",
            "same",
            "original",
            "forward",
            "forwards",
            "continues",
            "right",
            "left",
            "on",
            "away",
            "towards",
            "unchanged",
        ];
        let tells_way = |word: &str| WAYS.contains(&&*word.to_lowercase());
        // `turned through more than 90°`
        let measures = words.iter().any(|placed| placed.token == Token::Phrase(Phrase::Noun));
        let says_how = |placed: &Placed| match placed.token {
            Token::Phrase(Phrase::Remark | Phrase::Sphere | Phrase::Joiner | Phrase::Is | Phrase::Noun) => true,
            Token::Number(_) | Token::Sign('°' | '>') => measures,
            _ => false,
        };
        words.iter().all(says_how) && !self.slice(words).split_whitespace().any(tells_way)
    }

    /// `1/3 for A to rebound` without what happens then.
    fn without_what_happens<'t>(&self, tokens: &'t [Placed]) -> &'t [Placed] {
        let is_for = |placed: &Placed| {
            matches!(placed.token, Token::Phrase(Phrase::Remark | Phrase::Joiner))
                && matches!(&*self.slice(std::slice::from_ref(placed)).to_lowercase(), "for" | "to")
        };
        match tokens.iter().position(is_for) {
            Some(at) if self.say_what_happens(&tokens[at..]) => &tokens[..at],
            _ => tokens,
        }
    }

    pub(super) fn inequality(&mut self, sides: &[&[Placed]], relations: &[(char, usize)]) -> Result<(), Unreadable> {
        let (sides, relations) = without_infinite_ends(sides, relations)?;
        if self.is_of_multiplier(sides, relations) {
            return Ok(());
        }
        let remarks = self.rejections(sides);
        let is_phrase = |placed: &&Placed| matches!(placed.token, Token::Phrase(_));
        let lead = if remarks.is_empty() { 0 } else { sides[0].iter().take_while(is_phrase).count() };
        let values = std::iter::once(&sides[0][lead..]).chain(sides[1..].iter().copied());
        let values: Vec<(Expr, Option<SaidUnit>)> = values.map(|side| self.bounded(side)).collect::<Result<_, _>>()?;
        let pairs = values.iter().zip(&values[1..]).zip(relations);
        // `f > 2/3 for another collision`
        let is_phrase = |placed: &&Placed| matches!(placed.token, Token::Phrase(_));
        let last = sides[sides.len() - 1];
        let beside = last.iter().rev().take_while(is_phrase).count();
        let beside = self.slice(&last[last.len() - beside..]).to_lowercase();
        let said = pairs.map(|(((left, before), (right, after)), (sign, _))| {
            let relation = match sign {
                '<' => Relation::Less,
                '>' => Relation::Greater,
                '≤' => Relation::LessOrEqual,
                '≥' => Relation::GreaterOrEqual,
                '≠' => Relation::NotEqual,
                _ => Relation::Equal,
            };
            let form = Form::Equation(Expr::Relation(Box::new(left.clone()), relation, Box::new(right.clone())));
            Said { form, unit: before.clone().or(after.clone()), reference: None, remarks: remarks.clone() }
        });
        self.found.push(Statement { label: None, said: said.collect() });
        if !beside.is_empty() {
            self.remark(beside);
        }
        Ok(())
    }

    /// `set of values: 1/8 < e ≤ 1`, `values of f are 0 ≤ f ≤ 3/4`, `f: 0 ≤ f ≤ 3/4`: where the whole inequality begins that
    /// words or its letter announce.
    pub(super) fn announced(&self, tokens: &[Placed]) -> Option<usize> {
        let announces = |placed: &Placed| placed.is(':') || placed.token == Token::Phrase(Phrase::Is);
        let at = tokens.iter().position(announces).filter(|at| *at > 0 && !self.vocabulary.vectors)?;
        let (before, after) = (&tokens[..at], &tokens[at + 1..]);
        let is_name = |placed: &Placed| match placed.token {
            Token::Word(_) | Token::Greek(_) => true,
            Token::Phrase(Phrase::Remark | Phrase::Noun | Phrase::Sphere) => {
                !is_rejection(&self.slice(std::slice::from_ref(placed)).to_lowercase())
            }
            _ => false,
        };
        let begins = |first: &Placed| !matches!(first.token, Token::Phrase(_) | Token::Sign('<' | '>' | '≤' | '≥'));
        let is_whole = after.first().is_some_and(begins) && has_inequality(after);
        (is_whole && before.iter().all(is_name)).then_some(at + 1)
    }

    /// The words beside an inequality by which it is taken back: `reject k < -2`.
    fn rejections(&self, sides: &[&[Placed]]) -> Vec<String> {
        let words = sides.iter().copied().flatten().filter(|placed| matches!(placed.token, Token::Phrase(_)));
        let words = words.map(|placed| self.slice(std::slice::from_ref(placed)).to_lowercase());
        words.filter(|word| is_rejection(word)).collect()
    }

    /// The value of `e = 5/7 < 1` or `v = u(1-e)/2 > 0`, which its end bounds.
    pub(super) fn value_that_is_bounded<'s, 't>(
        &mut self,
        sides: &'s [&'t [Placed]],
        relations: &[(char, usize)],
    ) -> Result<Option<&'s [&'t [Placed]]>, Unreadable> {
        let (Some((bound, values)), Some(((sign, _), equals))) = (sides.split_last(), relations.split_last()) else {
            return Ok(None);
        };
        let [name, _, ..] = values else { return Ok(None) };
        let is_value = is_inequality(*sign)
            && equals.iter().all(|(sign, _)| matches!(sign, '=' | '≈'))
            && bound.iter().all(|placed| !matches!(placed.token, Token::Phrase(_)))
            && matches!(self.what_is(name)?, Side::Label(_));
        Ok(is_value.then_some(values))
    }

    /// A side of an inequality. After `e = 5/7` it may be an e that the question does not have, and in `v < 0` the student's
    /// own letter for a velocity.
    fn bounded(&mut self, tokens: &[Placed]) -> Result<(Expr, Option<SaidUnit>), Unreadable> {
        let tokens = self.without_what_happens(tokens);
        let typed = self.slice(tokens).to_owned();
        let is_velocity =
            matches!(tokens, [Placed { token: Token::Word(word), .. }] if word.starts_with(['v', 'V', 'w', 'x', 'y']));
        let is_name =
            is_velocity || self.found.iter().filter_map(|found| found.label.as_ref()).any(|label| label.typed == typed);
        self.side_with_unit(tokens).or_else(|fault| Ok((self.named(tokens).filter(|_| is_name).ok_or(fault)?, None)))
    }

    /// `> 3`, where words say or leave out what is: the range above it.
    pub(super) fn one_sided(&mut self, sign: char, tokens: &[Placed]) -> Result<Said, Unreadable> {
        let (at, unit) = self.side_with_unit(tokens)?;
        let end = Some(End { at, included: Some(matches!(sign, '≤' | '≥')) });
        let said = match sign {
            '>' | '≥' => said(end, None, Vec::new()),
            _ => said(None, end, Vec::new()),
        };
        Ok(Said { unit, ..said })
    }
}
