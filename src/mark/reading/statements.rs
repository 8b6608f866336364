//! Statements: what stands between separators, and what each is called.

use super::both_signs::with_both_signs;
use super::choices::Choices;
use super::commands::simple;
use super::equation_number::without_number;
use super::formula::formula;
use super::inequalities::{has_inequality, is_inequality};
use super::lexicon::{NOT_QUITE, is_rejection};
use super::line;
use super::part_label::{with_arrows_after_names, without_arrow, without_part_label};
use super::phrases::Phrase;
use super::ranges;
use super::segments::{outside, segments, unquoted};
use super::sides::{filling, is_called, without_value_of};
use super::tokens::{Placed, Token, excerpt};
use super::{Form, Said, Statement, Unreadable, Vocabulary};
use crate::expr::Expr;

/// Every statement of an answer.
pub(super) fn statements(
    tokens: Vec<Placed>,
    text: &str,
    vocabulary: &Vocabulary,
    choices: &mut Choices,
    passes_over: bool,
) -> Result<Vec<Statement>, Unreadable> {
    let tokens = ranges::with_ends_apart(ranges::with_round_brackets(tokens), text);
    let tokens = with_arrows_after_names(tokens, vocabulary);
    let tokens = with_both_signs(tokens);
    let mut reader = Statements {
        text,
        vocabulary,
        choices,
        found: Vec::new(),
        remarks: Vec::new(),
        lines: Vec::new(),
        multiplier: None,
        passes_over,
    };
    let tokens = ranges::without_set_builder(without_part_label(without_arrow(unquoted(&tokens)), vocabulary));
    let segments = segments(tokens);
    for (at, (concludes, segment)) in segments.iter().enumerate() {
        let segment = without_number(segment, reader.choices);
        let before = reader.found.len();
        let read = reader.segment(segment, *concludes);
        if read.is_err() && at + 1 < segments.len() && reader.is_passed_over(segment) {
            reader.found.truncate(before);
        } else {
            read?;
        }
    }
    let Statements { mut found, remarks, lines, .. } = reader;
    if line::are_unknowns(&lines, &found) {
        let place = tokens.first().map_or(0, |first| first.start);
        return Err(Unreadable::Sign(place, "x and y are unknowns here, and no line is meant".to_owned()));
    }
    match found.last_mut().and_then(|last| last.said.last_mut()) {
        Some(last) => last.remarks.extend(remarks),
        None => {
            let place = tokens.first().map_or(0, |first| first.start);
            return Err(Unreadable::Sign(place, "no value, formula or direction is in it".to_owned()));
        }
    }
    Ok(found)
}

/// What is remarked of a value that is drawn from what stands before it.
const SO: &str = "so";

pub(super) struct Statements<'a> {
    pub(super) text: &'a str,
    pub(super) vocabulary: &'a Vocabulary,
    pub(super) choices: &'a mut Choices,
    pub(super) found: Vec<Statement>,
    /// Words before the first value.
    remarks: Vec<String>,
    /// The gradients of lines that were given by their equations.
    pub(super) lines: Vec<Expr>,
    /// The letter of which nothing is known in `k(i - 3j)`.
    pub(super) multiplier: Option<Token>,
    /// Are formulas on the way to a value passed over, in letters that nobody knows?
    pub(super) passes_over: bool,
}

impl Statements<'_> {
    /// Is it a word that leads on from what stands before?
    fn is_conclusion(&self, placed: &Placed) -> bool {
        let word = self.slice(std::slice::from_ref(placed)).to_lowercase();
        placed.token == Token::Phrase(Phrase::Joiner)
            && matches!(&*word, "so" | "hence" | "therefore" | "thus" | "then" | "and" | "also" | "but" | "&")
    }

    fn segment(&mut self, tokens: &[Placed], concludes: bool) -> Result<(), Unreadable> {
        let reason = tokens.iter().position(|placed| placed.token == Token::Phrase(Phrase::Because));
        let reason = reason.or_else(|| self.condition_of_multiplier(tokens)).or_else(|| self.place_of_a_number(tokens));
        let whole = tokens;
        let (tokens, reason) = whole.split_at(reason.unwrap_or(whole.len()));
        let is_open =
            !(tokens.is_empty() && self.found.is_empty()) || self.slice(&reason[..reason.len().min(1)]) == "if";
        if is_open && self.is_condition(reason) && !self.is_place_of_a_number(tokens, reason) {
            return Err(Unreadable::Sign(reason[0].start, "the answer holds on a condition".to_owned()));
        }
        if let Some(at) = self.asked_condition(whole) {
            let (words, condition) = whole.split_at(at);
            self.remark(self.slice(words).to_lowercase());
            return self.segment(condition, concludes);
        }
        // `so k lies between 2 and 3`
        let begun = tokens.iter().take_while(|placed| self.is_conclusion(placed)).count();
        if let Some((label, said)) = self.range_in_words(&tokens[begun..])? {
            self.found.push(Statement { label, said: vec![said] });
            return Ok(());
        }
        let conclusion = |placed: &Placed| self.is_conclusion(placed);
        // `and` only adds.
        let draws = |placed: &Placed| {
            let word = self.slice(std::slice::from_ref(placed)).to_lowercase();
            matches!(&*word, "so" | "hence" | "therefore" | "thus").then_some(SO)
        };
        // `k = 8 or k = -8`
        let rival = |at: usize| {
            let after = tokens[at + 1..].iter().take_while(|placed| !conclusion(placed));
            tokens[at].token == Token::Phrase(Phrase::Or)
                && tokens[..at].iter().any(|placed| placed.is('='))
                && after.clone().any(|placed| placed.is('='))
        };
        // `so v = 3`, where nothing stands before.
        let lead = tokens.iter().take_while(|placed| conclusion(placed)).count();
        // `v = 0 so A stops`: what follows is a statement of its own, if anything stands before.
        let mut start = lead;
        let mut link = if concludes { Some(SO) } else { tokens[..lead].iter().find_map(draws) };
        let mut found = Vec::new();
        for at in lead + 1..tokens.len() {
            // `A and B have speeds …`: words alone before it are no statement.
            let said = tokens[start..at]
                .iter()
                .any(|placed| !matches!(placed.token, Token::Phrase(phrase) if phrase != Phrase::Rest));
            let rival = rival(at);
            if at > start
                && said
                && (conclusion(&tokens[at]) || rival || self.adds(&tokens[at..]))
                && outside(&tokens[start..at])
            {
                found.push((link, &tokens[start..at]));
                link = if rival { Some("or") } else { draws(&tokens[at]) };
                start = at + 1;
            } else if at == start && conclusion(&tokens[at]) {
                // `and so`
                link = link.or(draws(&tokens[at]));
                start = at + 1;
            }
        }
        if start < tokens.len() {
            found.push((link, &tokens[start..]));
        }
        let last = found.len().saturating_sub(1);
        for (at, (link, statement)) in found.into_iter().enumerate() {
            let before = self.found.len();
            let read = self.alternatives(statement);
            if read.is_err() && at < last && self.is_passed_over(statement) {
                self.found.truncate(before);
                continue;
            }
            read?;
            let first = self.found.get_mut(before).and_then(|first| first.said.first_mut());
            if let Some((first, link)) = first.zip(link) {
                first.remarks.push(link.to_owned());
            }
        }
        if !reason.is_empty() {
            let words = self.slice(reason).to_lowercase();
            self.remark(words);
            self.condition_of_choice(&reason[1..]);
        }
        Ok(())
    }

    /// `48 = 6v + 2w, w - v = 2, so v = 5.5`: is it an equation in letters, and may such lead to what follows?
    fn is_passed_over(&mut self, tokens: &[Placed]) -> bool {
        let is_of_formula = |placed: &Placed| match placed.token {
            Token::Phrase(phrase) => phrase == Phrase::Joiner,
            Token::Sign(sign) => !is_inequality(sign) && !matches!(sign, '≠' | '≈'),
            _ => true,
        };
        let has_letter = tokens.iter().any(|placed| matches!(placed.token, Token::Word(_) | Token::Greek(_)));
        let equals = tokens.iter().filter(|placed| placed.is('=')).count();
        let is_equation = self.passes_over && equals == 1 && has_letter && tokens.iter().all(is_of_formula);
        if is_equation {
            let equation = self.slice(tokens).to_owned();
            self.choices.note(|| format!("{equation} read as a step to what follows"));
        }
        is_equation
    }

    /// `k = 8 or -8 since k > 0`: of values between which somebody chooses, the reason may tell which it is.
    fn condition_of_choice(&mut self, reason: &[Placed]) {
        let before = self.found.len();
        let is_rival = |said: &Said| said.remarks.iter().any(|remark| remark.split(' ').any(|word| word == "or"));
        let is_choice = self.found.iter().flat_map(|found| &found.said).any(is_rival);
        if is_choice && has_inequality(reason) && self.chain(reason).is_err() {
            self.found.truncate(before);
        }
    }

    /// What a value is called: as it was typed, but for commands, so that `\tan\beta` is the name that `tan β` is.
    pub(super) fn plain_name(&self, tokens: &[Placed]) -> String {
        let mut pieces = self.slice(tokens).split('\\');
        let mut called = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            let (command, after) =
                piece.split_at(piece.find(|sign: char| !sign.is_ascii_alphabetic()).unwrap_or(piece.len()));
            match simple(command) {
                Some(plain) if called.is_empty() => called.extend([plain.trim_start(), after]),
                Some(plain) => called.extend([plain, after]),
                None => called.extend(["\\", piece]),
            }
        }
        called.trim_end().to_owned()
    }

    pub(super) fn slice(&self, tokens: &[Placed]) -> &str {
        match (tokens.first(), tokens.last()) {
            (Some(first), Some(last)) => excerpt(self.text, first.start, last.end),
            _ => "",
        }
    }

    pub(super) fn remark(&mut self, words: String) {
        match self.found.last_mut().and_then(|last| last.said.last_mut()) {
            Some(last) => last.remarks.push(words),
            None => self.remarks.push(words),
        }
    }

    /// Sides with relations between them.
    pub(super) fn chain(&mut self, tokens: &[Placed]) -> Result<(), Unreadable> {
        if let Some(next) = self.next_statement(tokens) {
            let (first, rest) = tokens.split_at(next);
            self.chain(first)?;
            return self.chain(rest);
        }
        if let Some(at) = self.announced(tokens) {
            let (words, inequality) = tokens.split_at(at);
            self.chain(inequality)?;
            if words.iter().any(|placed| matches!(placed.token, Token::Phrase(_))) {
                self.remark(self.slice(&words[..at - 1]).to_lowercase());
            }
            return Ok(());
        }
        // What stands before an inequality, and says what happens then.
        let mut beside = Vec::new();
        let mut sides: Vec<&[Placed]> = Vec::new();
        let mut relations: Vec<(char, usize)> = Vec::new();
        let (mut depth, mut start) = (0_usize, 0);
        for (at, placed) in tokens.iter().enumerate() {
            match placed.token {
                Token::Sign('(' | '[' | '{' | '⟦') => depth += 1,
                Token::Sign(')' | ']' | '}' | '⟧') => depth = depth.saturating_sub(1),
                Token::Sign(sign @ ('=' | '≈' | '<' | '>' | '≤' | '≥' | '≠' | '∈')) if depth == 0 => {
                    // `≈ 3.08` and `= 3.08` by themselves are only values.
                    if matches!(sign, '≈' | '=') && at == start && sides.is_empty() {
                        start = at + 1;
                        continue;
                    }
                    // `e is > 1/3`, `k must be strictly > 3`
                    let says_nothing = |placed: &&Placed| {
                        let is_remark = placed.token == Token::Phrase(Phrase::Remark) && is_inequality(sign);
                        is_remark || placed.token == Token::Phrase(Phrase::Is)
                    };
                    let side = &tokens[start..at];
                    let words = side.iter().rev().take_while(says_nothing).count();
                    // `e nearly > 1/3`
                    let is_short =
                        |word: &&Placed| NOT_QUITE.contains(&&*self.slice(std::slice::from_ref(*word)).to_lowercase());
                    if let Some(word) = side[side.len() - words..].iter().find(is_short) {
                        return Err(Unreadable::Sign(word.start, "an inequality that nearly holds".to_owned()));
                    }
                    let side = if words < side.len() { &side[..side.len() - words] } else { side };
                    // `values of e greater than 3`, `must have e > 3`
                    let is_remark = |placed: &&Placed| {
                        // `reject k < -2` says something of it.
                        matches!(placed.token, Token::Phrase(Phrase::Remark | Phrase::Is))
                            && !is_rejection(&self.slice(std::slice::from_ref(*placed)).to_lowercase())
                    };
                    let lead = if is_inequality(sign) { side.iter().take_while(is_remark).count() } else { 0 };
                    let lead = if lead < side.len() { lead } else { 0 };
                    beside.extend((lead > 0).then(|| self.slice(&side[..lead]).to_lowercase()));
                    sides.push(&side[lead..]);
                    relations.push((sign, placed.start));
                    start = at + 1;
                }
                // `e is 2/3`, `the value of e must be 2/3`
                Token::Phrase(Phrase::Is)
                    if depth == 0 && sides.is_empty() && is_called(&tokens[start..at], &tokens[at + 1..]) =>
                {
                    sides.push(without_value_of(&tokens[start..at]));
                    relations.push(('=', placed.start));
                    start = at + 1 + filling(&tokens[at + 1..]);
                }
                _ => {}
            }
        }
        sides.push(&tokens[start..]);
        // `greater than 3`, `all values greater than 3`
        if let ([nothing, right], [(sign, _)]) = (sides.as_slice(), relations.as_slice())
            && is_inequality(*sign)
            && nothing.iter().all(|placed| matches!(placed.token, Token::Phrase(_)))
            && !right.is_empty()
            && !self.vocabulary.vectors
        {
            let mut said = self.one_sided(*sign, right)?;
            // `reject > 1`
            said.remarks.extend((!nothing.is_empty()).then(|| self.slice(nothing).to_lowercase()));
            self.found.push(Statement { label: None, said: vec![said] });
            return Ok(());
        }
        for (side, relation) in sides.iter().zip(relations.iter().chain(relations.last())) {
            if side.is_empty() {
                return Err(Unreadable::Sign(relation.1, format!("nothing on one side of `{}`", relation.0)));
            }
        }
        // `e ∈ (1/3, 1]`
        for ((sign, place), side) in relations.iter().zip(&sides[1..]) {
            if *sign == '∈' && self.range(side)?.is_none() {
                return Err(Unreadable::Sign(*place, "a range is expected after `∈`".to_owned()));
            }
        }
        let equal = relations.iter().all(|(sign, _)| matches!(sign, '=' | '≈' | '∈'));
        if let Some(values) = self.value_that_is_bounded(&sides, &relations)? {
            self.equality(values)?;
            return self.inequality(&[sides[0], sides[values.len()]], &relations[values.len() - 1..]);
        }
        match (sides.len(), equal) {
            (1, _) => self.alone(sides[0]),
            (_, false) => {
                self.inequality(&sides, &relations)?;
                beside.into_iter().for_each(|words| self.remark(words));
                Ok(())
            }
            _ => self.equality(&sides),
        }
    }

    /// A formula that fills its tokens and is no vector.
    pub(super) fn scalar(&mut self, tokens: &[Placed]) -> Result<Expr, Unreadable> {
        let place = tokens.first().map_or(self.text.len(), |first| first.start);
        let read = formula(tokens.to_vec(), 0, self.text, self.vocabulary, self.choices)?;
        match read.form {
            Form::Value(value) if read.next == read.tokens.len() => Ok(value),
            _ => Err(Unreadable::Sign(place, "a number or formula is expected here".to_owned())),
        }
    }
}
