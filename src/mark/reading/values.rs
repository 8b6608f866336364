//! Values: a formula with its unit and the words around it.

use super::choices::{Choices, Doubt};
use super::formula::formula;
use super::lexicon::{PAST, falls_short, is_other, is_strange};
use super::line;
use super::phrases::Phrase;
use super::tokens::{Placed, Token, excerpt};
use super::vectors::along;
use super::{Form, ReferenceLine, Said, Unreadable, Vocabulary};

/// What stands in a stretch of tokens without separators and equals signs.
#[derive(Default)]
pub(super) struct Stretch {
    /// The values, each with what it is called if words before it say so.
    pub values: Vec<(Option<String>, Said)>,
    /// Words that belong to no value.
    pub remarks: Vec<String>,
}

/// Reads a stretch of tokens.
pub(super) struct Values<'a> {
    pub text: &'a str,
    pub vocabulary: &'a Vocabulary,
    pub choices: &'a mut Choices,
}

impl Values<'_> {
    /// Every value of a stretch, in order.
    pub(super) fn stretch(&mut self, tokens: &[Placed]) -> Result<Stretch, Unreadable> {
        let mut found = Stretch::default();
        let mut lead: Vec<usize> = Vec::new();
        let mut tokens = tokens.to_vec();
        let mut at = 0;
        while at < tokens.len() {
            self.choices.step(tokens[at].start)?;
            match tokens[at].token.clone() {
                Token::Phrase(Phrase::Because) => {
                    let reason = self.slice(&tokens, at, tokens.len()).to_lowercase();
                    self.remark(&mut found, reason);
                    lead.clear();
                    at = tokens.len();
                }
                // `41 grad`: gradians, or a gradient?
                Token::Phrase(Phrase::Gradient)
                    if is_after_number(&tokens, at) && self.slice(&tokens, at, at + 1) == "grad" =>
                {
                    return Err(Unreadable::Sign(tokens[at].start, "`grad` after a number".to_owned()));
                }
                Token::Phrase(phrase) => {
                    at = self.word(&tokens, at, phrase, &mut lead, &mut found)?;
                }
                // `81.9'`: minutes, without their degrees?
                Token::Sign(mark @ ('\'' | '"'))
                    if is_after_number(&tokens, at)
                        && !tokens[at].spaced
                        && !tokens[..at].iter().any(|placed| placed.is(mark)) =>
                {
                    return Err(Unreadable::Sign(tokens[at].start, format!("`{mark}` after a number")));
                }
                Token::Sign('.' | '!' | '?' | '"' | '\'') => at += 1,
                Token::Sign('≈') if found.values.is_empty() || !lead.is_empty() => at += 1,
                Token::Sign(':') if !lead.is_empty() => at += 1,
                // `A - 2.78`: a dash, not a minus sign.
                Token::Sign('-')
                    if lead.last().is_some_and(|last| names_something(&tokens, *last))
                        && tokens[at].spaced
                        && tokens.get(at + 1).is_some_and(|next| next.spaced) =>
                {
                    self.choices.note(|| "- read as a dash".to_owned());
                    at += 1;
                }
                // `A-2.78`
                Token::Sign('-')
                    if matches!(lead.as_slice(), [only] if phrase_at(&tokens, *only) == Some(Phrase::Sphere))
                        && !tokens[at].spaced
                        && tokens.get(at + 1).is_some_and(|next| !next.spaced)
                        && self.choices.otherwise(Doubt::Dash, tokens[at].start) =>
                {
                    at += 1;
                }
                // `25/7 (3.57)`, `18 J lost (33.7%)`
                Token::Sign('(')
                    if !found.values.is_empty()
                        && (lead.is_empty() && at + 3 == tokens.len()
                            || at + 4 == tokens.len() && tokens[at + 2].is('%')) =>
                {
                    let again = self.slice(&tokens, at, tokens.len()).to_owned();
                    self.remark(&mut found, again);
                    at = tokens.len();
                }
                _ => {
                    if let (Some((_, last)), true) = (found.values.last(), lead.is_empty()) {
                        let after_words = last.reference.is_some() || !last.remarks.is_empty();
                        // `3.61 m/s 56.3°`
                        let number = matches!(tokens[at].token, Token::Number(_));
                        let angle = number && tokens.get(at + 1).is_some_and(|next| next.is('°'));
                        let size = !last.unit.as_ref().is_some_and(|unit| unit.degrees);
                        if let Token::Sign(sign @ ('±' | '∓')) = tokens[at].token {
                            let message = format!("`{sign}` says two things at once");
                            return Err(Unreadable::Sign(tokens[at].start, message));
                        }
                        if !(after_words || angle && size) {
                            return Err(Unreadable::Sign(
                                tokens[at].start,
                                "a second value without a word or sign between".to_owned(),
                            ));
                        }
                    }
                    at = self.value(&mut tokens, at, &mut lead, &mut found)?;
                }
            }
        }
        if !lead.is_empty() {
            let phrases: Vec<Phrase> = lead.iter().filter_map(|at| phrase_at(&tokens, *at)).collect();
            let words = self.slice(&tokens, lead[0], lead[lead.len() - 1] + 1).to_owned();
            // `5 m/s for A`, `3.61 is the speed of A`
            let first = self.slice(&tokens, lead[0], lead[0] + 1).to_lowercase();
            let name = self.label(&tokens, &lead).filter(|_| matches!(&*first, "for" | "of" | "is" | "as"));
            if let Some((label, _)) = found.values.last_mut() {
                *label = label.take().or(name);
            }
            if phrases.contains(&Phrase::Or) {
                return Err(Unreadable::Sign(tokens[lead[0]].start, "a rival answer is missing".to_owned()));
            }
            self.remark(&mut found, words.to_lowercase());
        }
        Ok(found)
    }

    fn slice(&self, tokens: &[Placed], from: usize, to: usize) -> &str {
        excerpt(self.text, tokens[from].start, tokens[to - 1].end)
    }

    fn remark(&mut self, found: &mut Stretch, words: String) {
        match found.values.last_mut() {
            Some((_, last)) => last.remarks.push(words),
            None => found.remarks.push(words),
        }
    }

    /// Words: what they say of the value before, or keep for the value after.
    fn word(
        &mut self,
        tokens: &[Placed],
        at: usize,
        phrase: Phrase,
        lead: &mut Vec<usize>,
        found: &mut Stretch,
    ) -> Result<usize, Unreadable> {
        let said_in_words = |form: Form, reference| Said { form, unit: None, reference, remarks: Vec::new() };
        match phrase {
            Phrase::Line(line) => {
                let typed = self.slice(tokens, at, at + 1).to_lowercase();
                let away = (line.is_sense_alone() && typed.starts_with("away")).then_some(typed);
                match found.values.last_mut() {
                    Some((_, last)) if lead_says_nothing(tokens, lead) && with_line(last.reference, line).is_some() => {
                        last.reference = with_line(last.reference, line);
                        let words = lead.drain(..).map(|at| tokens[at].clone()).collect::<Vec<_>>();
                        let words = words.iter().filter_map(|word| self.text.get(word.start..word.end));
                        last.remarks.extend(words.map(str::to_lowercase));
                    }
                    Some(_) => {
                        let place = tokens[at].start;
                        return Err(Unreadable::Sign(place, "a second direction for the same value".to_owned()));
                    }
                    None => {
                        if !line.is_direction()
                            && !tokens[at + 1..].iter().any(|placed| matches!(placed.token, Token::Number(_)))
                        {
                            return Err(Unreadable::Sign(tokens[at].start, "an angle is missing".to_owned()));
                        }
                        let label = self.label(tokens, lead);
                        let mut said = said_in_words(Form::Direction, Some(line));
                        self.refuse_short_of(tokens, lead)?;
                        said.remarks = self.plain_words(tokens, lead);
                        lead.clear();
                        found.values.push((label, said));
                    }
                }
                // Away from the other sphere, and so towards the one that is meant, or just apart.
                if let Some((_, last)) = found.values.last_mut() {
                    last.remarks.extend(away);
                }
                Ok(at + 1)
            }
            Phrase::Rest => {
                if found.values.is_empty() {
                    let label = self.label(tokens, lead);
                    let said = self.at_rest(tokens, lead, at)?;
                    lead.clear();
                    found.values.push((label, said));
                } else {
                    let words = self.slice(tokens, at, at + 1).to_lowercase();
                    self.remark(found, words);
                }
                Ok(at + 1)
            }
            Phrase::OrLess | Phrase::OrMore | Phrase::Excluding | Phrase::End { .. } => {
                Err(Unreadable::Sign(tokens[at].start, "these words belong to a range".to_owned()))
            }
            // `7 bananas`: seven of what?
            Phrase::Unknown if !found.values.is_empty() => Err(self.strange_word(tokens, at)),
            _ => {
                lead.push(at);
                Ok(at + 1)
            }
        }
    }

    /// At rest, with what is said before it: `initially at rest` is of another moment, and `nearly at rest` is something else.
    fn at_rest(&self, tokens: &[Placed], lead: &[usize], at: usize) -> Result<Said, Unreadable> {
        self.refuse_short_of(tokens, lead)?;
        let name = lead.iter().position(|at| names_something(tokens, *at)).filter(|name| *name > 0);
        let before_name = name.map(|name| self.slice(tokens, lead[0], lead[name - 1] + 1).to_lowercase());
        // `was at rest` tells of a state, `was brought to rest` of what happens.
        let is_state = matches!(&*self.slice(tokens, at, at + 1).to_lowercase(), "at rest" | "stationary");
        let past = lead.last().map(|last| self.slice(tokens, *last, last + 1).to_lowercase());
        let past = past.filter(|word| is_state && PAST.contains(&&**word));
        let remarks = before_name.into_iter().chain(self.after_name(tokens, lead)).chain(past).collect();
        Ok(Said { form: Form::AtRest, unit: None, reference: None, remarks })
    }

    /// `nearly along the line of centres`, `nearly at rest`: what falls short of what is said, and what nobody knows, goes to
    /// a person.
    fn refuse_short_of(&self, tokens: &[Placed], lead: &[usize]) -> Result<(), Unreadable> {
        let short_of = || lead.iter().find(|at| falls_short(&self.slice(tokens, **at, **at + 1).to_lowercase()));
        match self.strange(tokens, lead).or_else(|| short_of().copied()) {
            Some(at) => Err(self.strange_word(tokens, at)),
            None => Ok(()),
        }
    }

    /// `B reverses direction along AB`: the words before a direction that name nothing, and may turn it.
    fn plain_words(&self, tokens: &[Placed], lead: &[usize]) -> Vec<String> {
        let plain = lead.iter().filter(|at| is_plain(tokens, **at));
        plain.map(|at| self.slice(tokens, *at, *at + 1).to_lowercase()).collect()
    }

    /// `A rebounds with 2.41`: what is said between the name, if there is one, and the value.
    fn after_name(&self, tokens: &[Placed], lead: &[usize]) -> Option<String> {
        let last_name = lead.iter().rposition(|at| names_something(tokens, *at));
        let between = &lead[last_name.map_or(0, |last| last + 1)..];
        between
            .iter()
            .any(|at| is_plain(tokens, *at))
            .then(|| self.slice(tokens, between[0], between[between.len() - 1] + 1).to_lowercase())
    }

    /// A word before a value that nobody knows.
    fn strange(&self, tokens: &[Placed], lead: &[usize]) -> Option<usize> {
        lead.iter().copied().find(|at| is_strange(self.slice(tokens, *at, *at + 1)))
    }

    fn strange_word(&self, tokens: &[Placed], at: usize) -> Unreadable {
        let word = self.slice(tokens, at, at + 1);
        Unreadable::Sign(tokens[at].start, format!("`{word}` may say something else of the value"))
    }

    /// What words before a value call it: those that name a quantity or a sphere.
    fn label(&self, tokens: &[Placed], lead: &[usize]) -> Option<String> {
        let names = |at: &&usize| names_something(tokens, **at);
        let place = lead.iter().position(|at| names(&at))?;
        let last = lead.iter().rev().find(names)?;
        // `initial speed`, `relative speed`
        let is_other = |at: usize| is_other(&self.slice(tokens, at, at + 1).to_lowercase());
        let is_sphere = |at: &&usize| {
            matches!(&*self.slice(tokens, **at, **at + 1).to_lowercase(), "sphere" | "ball" | "particle" | "disc")
        };
        let before = lead[..place].iter().rev().find(|at| !is_sphere(at)).filter(|at| is_other(**at));
        let first = before.unwrap_or(&lead[place]);
        // `increases by` is no `increases to`.
        let is_by = |at: &&usize| matches!(&*self.slice(tokens, **at, **at + 1).to_lowercase(), "by" | "to");
        let last = lead.iter().find(|at| *at > last).filter(is_by).unwrap_or(last);
        Some(self.slice(tokens, *first, *last + 1).to_owned())
    }

    /// A formula, its unit, and what is said before it.
    fn value(
        &mut self,
        tokens: &mut Vec<Placed>,
        at: usize,
        lead: &mut Vec<usize>,
        found: &mut Stretch,
    ) -> Result<usize, Unreadable> {
        let label = self.label(tokens, lead);
        let phrases: Vec<Phrase> = lead.iter().filter_map(|at| phrase_at(tokens, *at)).collect();
        let words = lead.first().map(|first| self.slice(tokens, *first, lead[lead.len() - 1] + 1).to_lowercase());
        let has_name = lead.iter().any(|at| names_something(tokens, *at));
        let after_name = self.after_name(tokens, lead).filter(|_| has_name);
        // `cube root of 13`, `scrap 13`: what is done to the value?
        if let Some(strange) = self.strange(tokens, lead) {
            return Err(self.strange_word(tokens, strange));
        }
        let is_towards = matches!(words.as_deref(), Some("towards" | "toward"));
        let toward = phrases.last() == Some(&Phrase::Toward) || is_towards;
        let across = phrases.contains(&Phrase::Across);
        let is_bare = lead.is_empty();
        lead.clear();
        let place = tokens[at].start;
        let parsed = formula(std::mem::take(tokens), at, self.text, self.vocabulary, self.choices)?;
        *tokens = parsed.tokens;
        let mut said = Said { form: parsed.form, unit: parsed.unit, reference: None, remarks: Vec::new() };
        if phrases.contains(&Phrase::Gradient) {
            said.form = match said.form {
                Form::Value(value) => Form::Gradient(value),
                _ => return Err(Unreadable::Sign(place, "a gradient is a number".to_owned())),
            };
        }
        // `perpendicular to i + 2j` is a line, and no direction of what stands before it.
        if across {
            let gradient = match &said.form {
                Form::Vector(x, y, _) if found.values.is_empty() => line::across(x, y),
                _ => None,
            };
            let gradient = gradient.ok_or_else(|| {
                Unreadable::Sign(place, "what is perpendicular to it is for a person to see".to_owned())
            })?;
            said.form = Form::Gradient(gradient);
            said.remarks.push(line::ACROSS.to_owned());
            found.values.push((label, said));
            return Ok(parsed.next);
        }
        // `2 m/s parallel to i`
        if toward && let Some((_, last)) = found.values.last_mut() {
            match (&last.form, &said.form) {
                (Form::Value(magnitude), Form::Vector(x, y, _)) if !is_angle(last) => {
                    last.form = along(magnitude, x, y)
                }
                _ => return Err(Unreadable::Sign(place, "a direction that is no vector".to_owned())),
            }
            return Ok(parsed.next);
        }
        if phrases.contains(&Phrase::Or) || toward {
            // `±8` has no word for it.
            let is_sign = words.as_ref().is_some_and(|words| words.contains('±') || words.starts_with('\\'));
            let joined = (phrases.contains(&Phrase::Or) && is_sign).then(|| "or".to_owned());
            said.remarks.extend(joined.or(words));
        } else if let Some(words) = words.filter(|_| label.is_none() && !phrases.contains(&Phrase::Gradient)) {
            // `2.78 m/s at 46.1`: a direction follows.
            let joins = phrases.iter().all(|phrase| matches!(phrase, Phrase::Joiner | Phrase::Is));
            if !joins || matches!(&*words, "at" | "from" | "to" | "is to" | "in") {
                said.remarks.push(words);
            }
        }
        said.remarks.extend(after_name);
        // `along the line of centres 1.92`: the direction of the value that follows it at once.
        let is_directed = is_bare && matches!(said.form, Form::Value(_)) && !is_angle(&said);
        if let Some((_, direction)) = found.values.last_mut().filter(|_| is_directed)
            && direction.form == Form::Direction
        {
            said.reference = direction.reference;
            said.remarks.append(&mut direction.remarks);
            *direction = said;
            return Ok(parsed.next);
        }
        found.values.push((label, said));
        Ok(parsed.next)
    }
}

/// The line of a value that has one already, or none, and of which another is said.
fn with_line(known: Option<ReferenceLine>, said: ReferenceLine) -> Option<ReferenceLine> {
    known.map_or(Some(said), |known| known.and(said))
}

fn phrase_at(tokens: &[Placed], at: usize) -> Option<Phrase> {
    match tokens.get(at)?.token {
        Token::Phrase(phrase) => Some(phrase),
        _ => None,
    }
}

fn is_angle(said: &Said) -> bool {
    said.unit.as_ref().is_some_and(|unit| unit.degrees)
}

fn is_after_number(tokens: &[Placed], at: usize) -> bool {
    at > 0 && matches!(tokens[at - 1].token, Token::Number(_))
}

/// Is it a word that neither names nor joins?
fn is_plain(tokens: &[Placed], at: usize) -> bool {
    matches!(phrase_at(tokens, at), Some(Phrase::Remark | Phrase::Unknown))
}

/// Does a word name a quantity or a sphere?
fn names_something(tokens: &[Placed], at: usize) -> bool {
    matches!(phrase_at(tokens, at), Some(Phrase::Noun | Phrase::Sphere))
}

/// Do the words between a value and its line leave the line to the value?
fn lead_says_nothing(tokens: &[Placed], lead: &[usize]) -> bool {
    !lead.iter().any(|at| matches!(phrase_at(tokens, *at), Some(Phrase::Or | Phrase::Because)))
}
