//! Ranges of values without inequality signs: `(1/3, 1]`, `]1/3, 1]`, `{e : e > 1/3}`, `between 2 and 3`, `more than 2`.

use super::choices::{Choices, Doubt};
use super::inequalities::has_inequality;
use super::phrases::Phrase;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::{End, Form, Label, Said, Unreadable};
use crate::expr::{Expr, print};

const OPENING: [char; 4] = ['(', '[', '{', '⟦'];
const CLOSING: [char; 4] = [')', ']', '}', '⟧'];

pub(super) fn is_any(placed: &Placed, signs: &[char]) -> bool {
    matches!(placed.token, Token::Sign(sign) if signs.contains(&sign))
}

/// `]1/3, 1[` with its brackets as round ones, which mean the same.
pub(super) fn with_round_brackets(tokens: Vec<Placed>) -> Vec<Placed> {
    if !tokens.iter().any(|placed| is_any(placed, &['[', ']'])) {
        return tokens;
    }
    let mut out = tokens.clone();
    // For each bracket that stands open: has a comma followed it?
    let mut open: Vec<bool> = Vec::new();
    for (at, placed) in tokens.iter().enumerate() {
        let ends = tokens.get(at + 1).is_none_or(|next| {
            matches!(next.token, Token::Phrase(_) | Token::Sign(',' | ';' | '.' | '\n' | '⇒' | '¦'))
        });
        match placed.token {
            Token::Sign(']') if open.is_empty() => {
                out[at].token = Token::Sign('(');
                open.push(false);
            }
            Token::Sign('[') if ends && open.last() == Some(&true) => {
                out[at].token = Token::Sign(')');
                open.pop();
            }
            Token::Sign(',' | ';') => open.iter_mut().for_each(|comma| *comma = true),
            _ if is_any(placed, &OPENING) => open.push(false),
            _ if is_any(placed, &CLOSING) => {
                open.pop();
            }
            _ => {}
        }
    }
    out
}

/// `e > 1/3 up to 1` as `e > 1/3, up to 1`, and `from 1/3 to 1, not including 1/3` in one.
pub(super) fn with_ends_apart(tokens: Vec<Placed>, text: &str) -> Vec<Placed> {
    let said = |placed: &Placed| text.get(placed.start..placed.end).unwrap_or_default().to_lowercase();
    let is_up_to = |at: usize| match &tokens[at].token {
        Token::Phrase(_) => said(&tokens[at]) == "up" && tokens.get(at + 1).is_some_and(|to| said(to) == "to"),
        Token::Sign('≤') => said(&tokens[at]).starts_with("up to"),
        _ => false,
    };
    let mut out: Vec<Placed> = Vec::with_capacity(tokens.len());
    for (at, placed) in tokens.iter().enumerate() {
        let is_excluding = tokens.get(at + 1).is_some_and(|next| next.token == Token::Phrase(Phrase::Excluding));
        if placed.is(',') && is_excluding {
            continue;
        }
        let begun = out.iter().rposition(|placed| is_any(placed, &[',', ';', '\n'])).map_or(0, |comma| comma + 1);
        if is_up_to(at) && has_inequality(&out[begun..]) {
            if out.last().is_some_and(|last| matches!(said(last).as_str(), "and" | "but")) {
                out.pop();
            }
            out.push(Placed { token: Token::Sign(','), end: placed.start, ..placed.clone() });
        }
        out.push(placed.clone());
    }
    out
}

/// What holds of the letter in `{e : e > 1/3}`, `{e ∈ ℝ : e > 1/3}`.
pub(super) fn without_set_builder(tokens: &[Placed]) -> &[Placed] {
    let [open, Placed { token: Token::Word(_) | Token::Greek(_), .. }, inside @ .., close] = tokens else {
        return tokens;
    };
    let inside = match inside {
        [element, reals, after @ ..] if element.is('∈') && reals.token == Token::Word("R".to_owned()) => after,
        all => all,
    };
    let [such_that, rest @ ..] = inside else { return tokens };
    let is_set = is_any(open, &OPENING) && is_any(close, &CLOSING) && is_any(such_that, &[':', '|']);
    // The braces of a fraction are none that were typed.
    let is_bracket = |placed: &Placed| is_any(placed, &OPENING[..3]) || is_any(placed, &CLOSING[..3]);
    let unbroken = !rest.iter().any(|placed| is_bracket(placed) || placed.is('|'));
    if is_set && has_inequality(rest) && unbroken { rest } else { tokens }
}

/// Is it infinity, with its sign: `∞`, `+∞`, `-∞`?
pub(super) fn is_infinite(tokens: &[Placed]) -> bool {
    match tokens {
        [infinity] => infinity.is('∞'),
        [sign, infinity] => (sign.is('+') || sign.is('-')) && infinity.is('∞'),
        _ => false,
    }
}

impl Statements<'_> {
    /// The range that a side is, if it is one in brackets. Two numbers in brackets of one kind may be coordinates.
    pub(super) fn range(&mut self, tokens: &[Placed]) -> Result<Option<Said>, Unreadable> {
        let [open, inside @ .., close] = tokens else { return Ok(None) };
        let comma = inside.iter().position(|placed| is_any(placed, &[',', ';']));
        let nested = inside.iter().scan(0_i32, |depth, placed| {
            *depth += i32::from(is_any(placed, &OPENING)) - i32::from(is_any(placed, &CLOSING));
            Some(*depth)
        });
        let whole =
            is_any(open, &['(', '[']) && is_any(close, &[')', ']']) && nested.into_iter().all(|depth| depth >= 0);
        let Some(comma) = comma.filter(|_| whole && !self.vocabulary.vectors) else { return Ok(None) };
        let (low, high) = (&inside[..comma], &inside[comma + 1..]);
        let endless = is_infinite(low) || is_infinite(high);
        let of_one_kind = open.is('(') == close.is(')');
        if of_one_kind && !endless && !self.choices.otherwise(Doubt::Brackets, open.start) {
            return Ok(None);
        }
        if is_infinite(low) && !low[0].is('-') || is_infinite(high) && high[0].is('-') {
            return Err(Unreadable::Sign(open.start, "a range that begins where it should end".to_owned()));
        }
        let low = self.end(low, Some(open.is('[')))?;
        let high = self.end(high, Some(close.is(']')))?;
        Ok(Some(said(low, high, Vec::new())))
    }

    /// An end of a range, unless it is infinite.
    fn end(&mut self, tokens: &[Placed], included: Option<bool>) -> Result<Option<End>, Unreadable> {
        match is_infinite(tokens) {
            true => Ok(None),
            false => Ok(Some(End { at: self.scalar(tokens)?, included })),
        }
    }

    /// `k between 2 and 3`, `k from 2 to 3 inclusive`, `up to 3`: what it is called, and the range.
    pub(super) fn range_in_words(&mut self, tokens: &[Placed]) -> Result<Option<(Option<Label>, Said)>, Unreadable> {
        if self.vocabulary.vectors {
            return Ok(None);
        }
        let word = |placed: &Placed| match placed.token {
            Token::Phrase(_) => self.slice(std::slice::from_ref(placed)).to_lowercase(),
            _ => String::new(),
        };
        if let [before @ .., last] = tokens
            && let Token::Phrase(last @ (Phrase::OrLess | Phrase::OrMore)) = last.token
        {
            return self.on_one_side(before, last == Phrase::OrMore).map(Some);
        }
        let words: Vec<String> = tokens.iter().map(word).collect();
        let excluding = tokens.iter().position(|placed| placed.token == Token::Phrase(Phrase::Excluding));
        let name = tokens.iter().take_while(is_letter).count();
        // `e up to 3/4`, `e can be up to 3/4`
        let before_up = name + words[name..].iter().take_while(|word| !word.is_empty() && *word != "up").count();
        if let [up, to, ..] = &words[before_up..]
            && (&**up, &**to) == ("up", "to")
        {
            let included = (excluding == Some(before_up + 2)).then_some(false);
            let start = before_up + 2 + usize::from(included.is_some());
            let high = End { at: self.side(&tokens[start..])?, included };
            let beside = words[name..before_up].to_vec();
            return Ok(Some((self.called(&tokens[..name]), said(None, Some(high), beside))));
        }
        let Some(lead) = words.iter().position(|word| matches!(&**word, "between" | "from")) else {
            return Ok(self.one_to_another(tokens, &words));
        };
        let joiner = if words[lead] == "between" { "and" } else { "to" };
        let Some(joint) = words.iter().position(|word| word == joiner).filter(|joint| *joint > lead) else {
            return Ok(None);
        };
        let Some(span) = Span::around(tokens, words[joint - 1] == "up", lead + 1, joint) else { return Ok(None) };
        // Numbers alone: `the line between A and B` is none.
        let (Ok(low), Ok(high)) = (self.scalar(span.low.0), self.scalar(span.high.0)) else { return Ok(None) };
        let name = tokens[..lead].iter().take_while(is_letter).count();
        if tokens[name..lead].iter().any(|placed| !is_word(&placed)) {
            return Ok(None);
        }
        let label = self.called(&tokens[..name]);
        let beside = [&words[name..lead], &words[span.beside.clone()]].concat();
        let excluded = span.excluded.map(|excluded| self.scalar(excluded)).transpose()?;
        Ok(Some((label, span.range(low, high, excluded.as_ref(), beside))))
    }

    /// What a range is called by the letters before it, if any are.
    fn called(&mut self, name: &[Placed]) -> Option<Label> {
        (!name.is_empty()).then(|| Label { typed: self.plain_name(name), expr: self.named(name) })
    }

    /// `2/3 to 1`, `e = 2/3 to 1`: numbers alone, which may be two values as well; those of `2/3 up to 1` and `2/3 (not included)
    /// to 1` are none.
    fn one_to_another(&mut self, tokens: &[Placed], words: &[String]) -> Option<(Option<Label>, Said)> {
        let joint = words.iter().position(|word| word == "to").filter(|joint| *joint > 0)?;
        let name = tokens.iter().take_while(is_letter).count();
        let lead = tokens.get(name).filter(|sign| name > 0 && is_any(sign, &['=', ':']));
        let (name, low) = if lead.is_some() { (&tokens[..name], name + 1) } else { (&tokens[..0], 0) };
        let is_up_to = words[joint - 1] == "up";
        let span = Span::around(tokens, is_up_to, low, joint)?;
        let begins = |side: &[Placed]| matches!(side.first().map(|first| &first.token), Some(Token::Number(_)));
        let is_range = || is_up_to || span.tells_an_end();
        let is_likely = |choices: &mut Choices| is_range() || choices.otherwise(Doubt::To, tokens[joint].start);
        if !begins(span.low.0) || !begins(span.high.0) || !is_likely(self.choices) {
            return None;
        }
        let (low, high) = (self.scalar(span.low.0).ok()?, self.scalar(span.high.0).ok()?);
        let excluded = span.excluded.map(|excluded| self.scalar(excluded)).transpose().ok()?;
        let beside = words[span.beside.clone()].to_vec();
        Some((self.called(name), span.range(low, high, excluded.as_ref(), beside)))
    }

    /// `e is 0.8 or less`: what it is called, and the range.
    fn on_one_side(&mut self, tokens: &[Placed], above: bool) -> Result<(Option<Label>, Said), Unreadable> {
        let name = tokens.iter().take_while(is_letter).count();
        let is_lead = |placed: &&Placed| matches!(placed.token, Token::Phrase(_) | Token::Sign('='));
        let lead = tokens[name..].iter().take_while(is_lead).count();
        let (name, lead) = if lead > 0 { (name, name + lead) } else { (0, 0) };
        let label = self.called(&tokens[..name]);
        let end = Some(End { at: self.scalar(&tokens[lead..])?, included: Some(true) });
        let remarks = if lead > name { vec![self.slice(&tokens[name..lead]).to_lowercase()] } else { Vec::new() };
        let (low, high) = if above { (end, None) } else { (None, end) };
        Ok((label, said(low, high, remarks)))
    }
}

/// The two ends of a range in words.
struct Span<'t> {
    /// An end, and whether words behind it tell that it belongs to the range.
    low: (&'t [Placed], Option<bool>),
    high: (&'t [Placed], Option<bool>),
    /// Where the words behind them stand.
    beside: std::ops::Range<usize>,
    /// What is said not to belong to it.
    excluded: Option<&'t [Placed]>,
}

impl<'t> Span<'t> {
    /// What stands before and behind the word that joins two ends; before it stands `up` too, or not.
    fn around(tokens: &'t [Placed], is_up_to: bool, start: usize, joint: usize) -> Option<Span<'t>> {
        let excluding = tokens.iter().position(|placed| placed.token == Token::Phrase(Phrase::Excluding));
        // `from 1/3 up to but not including 1`
        let is_open_above = excluding == Some(joint + 1);
        let excluding = excluding.filter(|_| !is_open_above);
        let whole = excluding.unwrap_or(tokens.len());
        let from = joint + 1 + usize::from(is_open_above);
        let high = tokens.get(from..whole)?;
        let after = whole - high.iter().rev().take_while(is_word).count();
        let low = end_and_told(tokens.get(start..joint - usize::from(is_up_to))?);
        let (high, told) = end_and_told(&tokens[from..after]);
        let high = (high, told.or(is_open_above.then_some(false)));
        Some(Span { low, high, beside: after..whole, excluded: excluding.map(|at| &tokens[at + 1..]) })
    }

    fn tells_an_end(&self) -> bool {
        self.low.1.is_some() || self.high.1.is_some() || self.excluded.is_some()
    }

    /// The range from the one end to the other. Where one is left out, the other is not.
    fn range(&self, low: Expr, high: Expr, excluded: Option<&Expr>, beside: Vec<String>) -> Said {
        let is_in = |at: &Expr, told: Option<bool>| excluded.map(|excluded| excluded != at).or(told);
        let told = [is_in(&low, self.low.1), is_in(&high, self.high.1)];
        let beside_one_left_out = |other: Option<bool>| (other == Some(false)).then_some(true);
        let low = End { at: low, included: told[0].or(beside_one_left_out(told[1])) };
        let high = End { at: high, included: told[1].or(beside_one_left_out(told[0])) };
        said(Some(low), Some(high), beside)
    }
}

/// An end without the words that tell whether it belongs to the range, and what they tell.
fn end_and_told(tokens: &[Placed]) -> (&[Placed], Option<bool>) {
    match tokens {
        [end @ .., Placed { token: Token::Phrase(Phrase::End { included }), .. }] => (end, Some(*included)),
        _ => (tokens, None),
    }
}

/// Words that say nothing of an end.
fn is_word(placed: &&Placed) -> bool {
    matches!(placed.token, Token::Phrase(phrase) if !matches!(phrase, Phrase::End { .. }))
}

fn is_letter(placed: &&Placed) -> bool {
    matches!(placed.token, Token::Word(_) | Token::Greek(_))
}

pub(super) fn said(low: Option<End>, high: Option<End>, remarks: Vec<String>) -> Said {
    Said { form: Form::Range(low, high), unit: None, reference: None, remarks }
}

/// A range as a terminal shows it.
pub(super) fn printed(low: &Option<End>, high: &Option<End>) -> String {
    let number = |end: &End| print::unicode(&end.at);
    match (low, high) {
        (Some(low), Some(high)) => match (low.included, high.included) {
            (Some(first), Some(last)) => {
                let (open, close) = (if first { '[' } else { '(' }, if last { ']' } else { ')' });
                format!("{open}{}, {}{close}", number(low), number(high))
            }
            _ => format!("from {} to {}", number(low), number(high)),
        },
        (Some(low), None) => format!("{} {}", if low.included == Some(true) { '≥' } else { '>' }, number(low)),
        (None, Some(high)) => match high.included {
            Some(included) => format!("{} {}", if included { '≤' } else { '<' }, number(high)),
            None => format!("up to {}", number(high)),
        },
        (None, None) => "any value".to_owned(),
    }
}
