//! What is said beside a value or an equation and is no part of it: how far it is rounded, which equation is used.

use super::choices::Choices;
use super::inequalities::has_inequality;
use super::phrases::{Phrase, Walk};
use super::said_again::{closes, compares, measured, of_one_figure, parts, said_again};
use super::tokens::{Placed, Token};
use super::units::unit;
use super::{SaidUnit, Vocabulary};
use crate::expr::Expr;

/// A unit has no more tokens: `kg m s^(-1)`.
const LONGEST_UNIT: usize = 8;

impl Walk<'_> {
    /// `(nearest degree)`, `to the nearest tenth of a degree`: the token after it.
    fn nearest_degree(&self, at: usize) -> Option<usize> {
        let open = self.tokens[at].is('(');
        let start = at + usize::from(open);
        let start = self.any(start, &["correct to", "rounded to", "to"]).map_or(start, |next| self.article(next));
        let step = self.words(start, "nearest")?;
        let part = self.any(step, &["tenth of", "hundredth of", "whole", "tenth", "hundredth"]);
        let step = self.article(part.unwrap_or(step));
        let number = |at: usize| matches!(self.tokens.get(at).map(|placed| &placed.token), Some(Token::Number(_)));
        let step = step + usize::from(number(step));
        let is = |sign: char| self.tokens.get(step).is_some_and(|placed| placed.is(sign));
        let end =
            if is('°') { step + 1 } else { self.any(step, &["integer", "whole number"]).or(part.filter(|_| !open))? };
        match open {
            true => self.tokens.get(end).is_some_and(|token| token.is(')')).then_some(end + 1),
            false => Some(end),
        }
    }

    /// `(3 s.f.)`, `[3sf]`, `to 2 dp`: how far a value is rounded; the token after it.
    pub(super) fn accuracy(&self, at: usize) -> Option<usize> {
        if let Some(end) = self.nearest_degree(at) {
            return Some(end);
        }
        let open = self.tokens[at].is('(') || self.tokens[at].is('[');
        let start = at + usize::from(open);
        let words = ["correct to", "rounded to", "to"];
        let number = self.any(start, &words).unwrap_or(start);
        let led = open || number > start;
        let small = |expr: &Expr| matches!(expr, Expr::Number(value) if value.as_small().is_some_and(|(n, d)| n < 10 && d == 1));
        let counts = match &self.tokens.get(number)?.token {
            Token::Number(value) => small(value),
            Token::Word(word) => matches!(word.as_str(), "one" | "two" | "three" | "four"),
            _ => false,
        };
        if !(counts && (led || at > 0)) {
            return None;
        }
        let kinds = [
            "sf",
            "dp",
            "sig figs",
            "sig fig",
            "significant figures",
            "significant figure",
            "decimal places",
            "decimal place",
        ];
        // `3.s.f.`
        let kind = number + 1 + usize::from(self.tokens.get(number + 1).is_some_and(|token| token.is('.')));
        let end = self.any(kind, &kinds)?;
        let end = end + usize::from(self.tokens.get(end).is_some_and(|token| token.is('.')));
        match open {
            true => self.tokens.get(end).is_some_and(|token| token.is(')') || token.is(']')).then_some(end + 1),
            false => Some(end),
        }
    }

    /// `(→)`, `R(→):`, `→:`: the direction in which an equation is written; the token after it.
    pub(super) fn positive_direction(&self, at: usize) -> Option<usize> {
        let is = |at: usize, sign: char| self.tokens.get(at).is_some_and(|token| token.is(sign));
        let begins = at == 0 || is(at - 1, '\n');
        let open = at + usize::from(matches!(self.word(at), Some("r" | "res" | "resolve" | "resolving")));
        let bracket = usize::from(is(open, '('));
        let end = (is(open + bracket, '⇒') && begins).then_some(open + bracket + 1)?;
        match bracket {
            1 => is(end, ')').then(|| end + 1 + usize::from(is(end + 1, ':'))),
            _ => is(end, ':').then_some(end + 1),
        }
    }

    /// `24 N s (equal and opposite)`: what is always so of the impulses on two bodies; the token after it.
    pub(super) fn equal_and_opposite(&self, at: usize) -> Option<usize> {
        let next = self.any(at, &["equal and opposite", "equal but opposite"])?;
        let before = at.checked_sub(1)?;
        let is_parted = self.tokens[before].is('(') || self.tokens[before].is(',');
        let end = if is_parted { before } else { at };
        let is_impulse = |from: usize| {
            unit(self.tokens, from, "").is_some_and(|(unit, next)| next == end && unit.dimension == [1, 1, -1, 0])
        };
        let is_last = !self.tokens[next..].iter().any(|placed| matches!(placed.token, Token::Number(_)));
        (is_last && (1..end).rev().take(LONGEST_UNIT).any(is_impulse)).then_some(next)
    }

    /// `eqn 2`, `from (1)`, `in equation (1)`: which equation is meant; the token after it.
    pub(super) fn named_equation(&self, at: usize) -> Option<usize> {
        self.word(at)?;
        let lead = self.any(at, &["from", "using", "in", "into", "sub into", "by", "of"]);
        let named = self.any(lead.unwrap_or(at), &["eq", "eqn", "equation", "eqs", "eqns", "equations"]);
        let number = named.or(lead)?;
        let number = number + usize::from(self.tokens.get(number).is_some_and(|token| token.is('.')));
        let counts = |at: usize| {
            matches!(&self.tokens.get(at)?.token, Token::Number(Expr::Number(value)) if value.is_integer())
                .then_some(at + 1)
        };
        let is = |at: usize, sign: char| self.tokens.get(at).is_some_and(|token| token.is(sign));
        let bracketed =
            |at: usize| is(at, '(').then(|| counts(at + 1).filter(|next| is(*next, ')')))?.map(|next| next + 1);
        match is(number, '(') {
            true => {
                let mut end = bracketed(number)?;
                // `from (1) and (2)`
                while let Some(next) = self.any(end, &["and"]).or(is(end, ',').then_some(end + 1)).and_then(bracketed) {
                    end = next;
                }
                Some(end)
            }
            // `(from 1)`
            false => counts(number).filter(|next| named.is_some() || (at > 0 && is(at - 1, '(') && is(*next, ')'))),
        }
    }
}

/// Brackets around words are an aside, and part it from the rest as commas would: `0 m/s (at rest)`. So are brackets in
/// which a value is said again, or a condition: `√13 (3.61 m/s)`, `√13 (= 3.61)`, `8 (k > 0)`.
pub(super) fn with_asides_set_off(
    mut tokens: Vec<Placed>,
    vocabulary: &Vocabulary,
    choices: &mut Choices,
) -> Vec<Placed> {
    let mut start = 1;
    while start < tokens.len() {
        if let Some(close) = told_besides(&tokens, start, vocabulary) {
            let whole =
                Placed { token: Token::Phrase(Phrase::Remark), end: tokens[close].end, ..tokens[start].clone() };
            tokens.splice(start..=close, [whole]);
            start += 1;
            continue;
        }
        if let Some(close) = line_in_brackets(&tokens, start) {
            tokens.remove(close);
            tokens.remove(start);
            continue;
        }
        if let Some(close) = words_of_a_name(&tokens, start) {
            let (token, end) = (Token::Phrase(Phrase::Remark), tokens[close].end);
            let whole = Placed { token, end, ..tokens[start].clone() };
            tokens.splice(start..=close, [whole]);
            continue;
        }
        // `3, m/s`
        if tokens[start].is(',') && vocabulary.letters.is_empty() && ends_with_unit(&tokens, start) {
            tokens.remove(start);
            continue;
        }
        // `46.1°, measured from AB`
        if let [comma, line, ..] = &tokens[start..]
            && comma.is(',')
            && tokens[start - 1].is('°')
            && matches!(line.token, Token::Phrase(Phrase::Line(line)) if !line.is_direction())
            && tokens.get(start + 2).is_none_or(|next| next.is('.') || next.is(','))
        {
            tokens.remove(start);
            continue;
        }
        if let Some(mut end) = said_again(&tokens, start, vocabulary, choices) {
            // `0.7 (5/7)`: one figure is no value by itself. Nor is what is said to be about as much: `1/14 (≈ 0.07)`.
            // `k > 32/3 (10.7)`: a bound is said again.
            let is_of_bound = has_inequality(&tokens) && !has_inequality(&tokens[start..end]);
            if tokens[start + 1].is('=') || tokens[start + 1].is('≈') {
                tokens.remove(start);
                end -= 1;
            } else if is_of_bound && tokens[start - 1..].first().is_some_and(|before| !before.is(',')) {
                tokens[start].token = Token::Sign('=');
                tokens.remove(end);
                start += 1;
                continue;
            } else {
                // A condition is no value: `0.5 (m > 0)`.
                let is_value = !has_inequality(&tokens[start..end]);
                let sign = if is_value && of_one_figure(&tokens[start - 1]) { '=' } else { ',' };
                tokens[start].token = Token::Sign(sign);
            }
            // `1.92 (48/25) J`
            match unit(&tokens, end + 1, "") {
                Some(_) => drop(tokens.remove(end)),
                None => tokens[end].token = Token::Sign(','),
            }
        }
        start += 1;
    }
    let mut open: Vec<(usize, bool)> = Vec::new();
    for at in 0..tokens.len() {
        match tokens[at].token {
            Token::Sign('(') => open.push((at, false)),
            Token::Phrase(_) => {
                if let Some(last) = open.last_mut() {
                    last.1 = true;
                }
            }
            Token::Sign(')') => {
                if let Some((start, true)) = open.pop() {
                    tokens[start].token = Token::Sign(',');
                    tokens[at].token = Token::Sign(',');
                }
            }
            _ => {}
        }
    }
    tokens
}

/// The bracket that closes here, where one opens.
fn closing(tokens: &[Placed], start: usize) -> Option<usize> {
    let close = match tokens[start].token {
        Token::Sign('(') => ')',
        Token::Sign('[') => ']',
        _ => return None,
    };
    Some(start + closes(&tokens[start..], close)?)
}

/// `56.3° (to the line of centres)`, `56.3° [above the line of centres]`: the closing bracket of the line from which the angle
/// before is measured, and of nothing else but words that say no more.
fn line_in_brackets(tokens: &[Placed], start: usize) -> Option<usize> {
    let close = closing(tokens, start)?;
    let inside = &tokens[start + 1..close];
    let after_angle = tokens[start - 1].is('°');
    let is_line = |placed: &&Placed| matches!(placed.token, Token::Phrase(Phrase::Line(line)) if after_angle || !line.is_direction());
    let is_word = |placed: &Placed| is_line(&placed) || placed.token == Token::Phrase(Phrase::Remark);
    (inside.iter().filter(is_line).count() == 1 && inside.iter().all(is_word)).then_some(close)
}

/// `v (final) = 2.78`, `speed (of B) = 3.08`: the closing bracket of words that belong to the name before them.
fn words_of_a_name(tokens: &[Placed], start: usize) -> Option<usize> {
    let close = closing(tokens, start)?;
    let is_word =
        |placed: &Placed| matches!(placed.token, Token::Phrase(Phrase::Remark | Phrase::Noun | Phrase::Sphere));
    let is_name = |placed: &Placed| is_word(placed) || matches!(placed.token, Token::Word(_) | Token::Greek(_));
    let is_named = is_name(&tokens[start - 1]) && tokens.get(close + 1).is_some_and(|next| next.is('='));
    let inside = &tokens[start + 1..close];
    (is_named && !inside.is_empty() && inside.iter().all(is_word)).then_some(close)
}

/// The closing bracket of what is told besides a value: `5 (w = 15)`, `75.9° (at α = 7.07°)`, `0.5 (0 ≤ e ≤ 1)`, `8 (check: 5 + 3
/// = 8)`. It is said of another letter than the value is, or else it is another value of the answer.
fn told_besides(tokens: &[Placed], start: usize, vocabulary: &Vocabulary) -> Option<usize> {
    let after_value = |placed: &Placed| {
        matches!(placed.token, Token::Number(_) | Token::Word(_) | Token::Greek(_) | Token::Sign(')' | '°' | '%' | '⟧'))
    };
    if !tokens[start].is('(') || !after_value(&tokens[start - 1]) {
        return None;
    }
    let close = start + closes(&tokens[start..], ')')?;
    let inside = &tokens[start + 1..close];
    let is_word = |placed: &Placed| matches!(placed.token, Token::Phrase(_));
    let lead = inside.iter().take_while(|placed| is_word(placed) || placed.is(':')).count();
    let told = &inside[lead..];
    // What is rejected in brackets is no aside, and `when e = 1` is a condition on which the answer holds.
    let says_no_more =
        |placed: &Placed| matches!(placed.token, Token::Phrase(Phrase::Joiner | Phrase::Remark | Phrase::Unknown));
    if told.iter().any(is_word) || !inside[..lead].iter().all(|placed| placed.is(':') || says_no_more(placed)) {
        return None;
    }
    let name = |placed: &Placed| match &placed.token {
        Token::Word(word) => Some(word.clone()),
        Token::Greek(letter) => Some(letter.to_string()),
        _ => None,
    };
    let relations = told.iter().filter(|placed| placed.is('=') || compares(placed)).count();
    let begins = tokens[..start]
        .iter()
        .rposition(|placed| placed.is(',') || placed.is(';') || placed.is('\n') || placed.is('⇒'));
    let before = &tokens[begins.map_or(0, |at| at + 1)..start];
    let stated =
        before.iter().rposition(|placed| parts(placed) || is_word(placed)).map_or(before, |at| &before[at + 1..]);
    let is_far = |value: &[Placed]| {
        let sizes = measured(stated, vocabulary).zip(measured(value, vocabulary));
        sizes.is_some_and(|((one, _), (other, _))| (one - other).abs() > 0.01 * one.abs())
    };
    let is_same =
        |value: &[Placed]| value.iter().map(|placed| &placed.token).eq(stated.iter().map(|placed| &placed.token));
    let Some(own) = told.iter().filter_map(name).next() else {
        let made = told.iter().position(|placed| placed.is('=')).filter(|at| relations == 1 && *at > 0);
        return made.filter(|at| is_same(&told[at + 1..])).map(|_| close);
    };
    let is_named_before = before.iter().filter_map(name).any(|before| before == own);
    let is_told = match told {
        [first, equals, value @ ..] if relations == 1 && equals.is('=') => {
            name(first).is_some() && (is_far(value) || is_same(value))
        }
        // A condition on a letter of the question may choose between values.
        _ => {
            relations > 0
                && told.iter().all(|placed| !placed.is('='))
                && !vocabulary.letters.iter().any(|letter| letter.name() == own)
        }
    };
    (is_told && !is_named_before).then_some(close)
}

/// Does a number stand before the comma, and nothing after it but the unit of a speed, an impulse or an energy?
fn ends_with_unit(tokens: &[Placed], comma: usize) -> bool {
    let whole = |unit: &SaidUnit| unit.dimension[1] != 0 && unit.dimension[2] != 0;
    let is_last = unit(tokens, comma + 1, "").is_some_and(|(unit, end)| end == tokens.len() && whole(&unit));
    is_last && matches!(tokens[comma - 1].token, Token::Number(_))
}

/// Where the unit ends that stands after a note on accuracy, and belongs to the number before: `3.61 (3sf) m/s`.
pub(super) fn unit_before_accuracy(tokens: &[Placed], after_number: bool, next: usize) -> Option<usize> {
    let (_, end) = unit(tokens, next, "").filter(|_| after_number)?;
    Some(end)
}
