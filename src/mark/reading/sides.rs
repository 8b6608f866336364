//! What stands on one side of an equals sign: a name, a number, a formula, or words.

use super::choices::Doubt;
use super::formula::formula;
use super::grammar::Parser;
use super::names;
use super::phrases::Phrase;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::units::is_unit_word;
use super::vectors::{Shape, shape};
use super::{Form, Label, SaidUnit, Unreadable};
use crate::expr::{Expr, Function};

/// What one side of an equals sign is.
pub(super) enum Side {
    /// It names what stands on the other.
    Label(Label),
    /// A number, which begins a chain of values.
    Number,
    /// A formula in letters: the statement is an equation.
    Formula,
}

impl Statements<'_> {
    /// The expression of a label, where it is one.
    pub(super) fn named(&mut self, tokens: &[Placed]) -> Option<Expr> {
        let before = self.choices.decided().len();
        let mut parser = Parser::new(tokens.to_vec(), self.text, self.vocabulary, self.choices);
        parser.any_name = true;
        let expr = parser.sum().ok().filter(|_| parser.at == parser.end);
        self.choices.forget(before);
        expr.and_then(|expr| match shape(&expr) {
            Ok(Shape::Scalar(value)) => Some(value),
            _ => None,
        })
    }

    /// What a side is, if a name may stand there.
    pub(super) fn what_is(&mut self, tokens: &[Placed]) -> Result<Side, Unreadable> {
        let typed = self.plain_name(tokens);
        let words = tokens.iter().any(|placed| matches!(placed.token, Token::Phrase(_) | Token::Sign(':')));
        let expr = self.named(tokens);
        // `i = 4, j = 1`: the names of components.
        let is_unit_vector = self.vocabulary.vectors
            && matches!(tokens, [Placed { token: Token::Word(word), .. }] if word == "i" || word == "j");
        if words || is_unit_vector || self.is_size_of_vector(tokens) {
            return Ok(Side::Label(Label { typed, expr: None }));
        }
        let Some(expr) = expr else {
            let name = tokens.iter().any(|placed| matches!(placed.token, Token::Word(_) | Token::Greek(_)));
            let numbers = tokens.iter().any(|placed| matches!(placed.token, Token::Number(_)));
            // A vector or something that is not read as a formula.
            let before = self.choices.decided().len();
            let read = formula(tokens.to_vec(), 0, self.text, self.vocabulary, self.choices);
            self.choices.forget(before);
            return match read {
                Ok(_) => Ok(Side::Number),
                Err(_) if name && !numbers => Ok(Side::Label(Label { typed, expr: None })),
                Err(reason) => Err(reason),
            };
        };
        if let Some(name) = numbered_name(tokens, &expr)
            && self.choices.otherwise(Doubt::NumberedName, tokens[0].start)
        {
            return Ok(Side::Label(Label { typed, expr: Some(name) }));
        }
        let strange = self.has_strange_names(&expr);
        let letters = !expr.names().is_empty();
        Ok(match (is_a_name(&expr), strange, letters) {
            (true, ..) | (_, true, _) => Side::Label(Label { typed, expr: Some(expr) }),
            (false, false, true) => Side::Formula,
            (false, false, false) => Side::Number,
        })
    }

    /// `|4i + j|`: names a magnitude, and does not find it.
    pub(super) fn is_size_of_vector(&self, tokens: &[Placed]) -> bool {
        let [first, inner @ .., last] = tokens else { return false };
        let is_unit = |placed: &Placed| matches!(&placed.token, Token::Word(word) if word == "i" || word == "j");
        let unbroken = first.is('|') && last.is('|') && !inner.iter().any(|placed| placed.is('|'));
        self.vocabulary.vectors && unbroken && inner.iter().any(is_unit)
    }

    /// A magnitude that is only named is no answer.
    pub(super) fn is_worked_out(&self, tokens: &[Placed]) -> Result<(), Unreadable> {
        match self.is_size_of_vector(tokens) {
            true => Err(Unreadable::Sign(tokens[0].start, "the magnitude is still to be worked out".to_owned())),
            false => Ok(()),
        }
    }

    /// A formula without the words that lead to it: `by conservation of momentum`, `CLM:`. They name no value.
    pub(super) fn without_lead_in<'t>(&mut self, tokens: &'t [Placed]) -> &'t [Placed] {
        let says_nothing = |placed: &Placed| matches!(placed.token, Token::Phrase(phrase) if phrase != Phrase::Sphere);
        let words = tokens.iter().take_while(|placed| says_nothing(placed)).count();
        let rest = match &tokens[words..] {
            [colon, rest @ ..] if colon.is(':') => rest,
            rest => rest,
        };
        if words > 0 && matches!(self.what_is(rest), Ok(Side::Formula)) {
            self.remark(self.slice(&tokens[..words]).to_lowercase());
            return rest;
        }
        tokens
    }

    /// The name of a value that stands before it. After a formula in letters a letter of the question is no name, but
    /// the other side of an equation.
    pub(super) fn name_at_the_end(&mut self, tokens: &[Placed], after_number: bool) -> Option<Label> {
        let has_number = tokens.iter().any(|placed| matches!(placed.token, Token::Number(_)));
        if has_number && !self.is_size_of_vector(tokens) {
            return None;
        }
        let Ok(Side::Label(label)) = self.what_is(tokens) else { return None };
        let is_name = |expr: &Expr| is_a_name(expr) && (after_number || self.has_strange_names(expr));
        label.expr.as_ref().is_none_or(is_name).then_some(label)
    }

    /// Is it a number of times one letter, and no number with its unit?
    pub(super) fn is_multiple(&self, tokens: &[Placed]) -> bool {
        let [number, letter] = tokens else { return false };
        let is_letter = matches!(&letter.token, Token::Word(word) if word.chars().count() == 1 && !is_unit_word(word));
        let is_unit_vector = matches!(&letter.token, Token::Word(word) if word == "i" || word == "j");
        matches!(number.token, Token::Number(_)) && is_letter && !letter.spaced && !is_unit_vector
    }

    /// Is there a name in it that the question does not have?
    pub(super) fn has_strange_names(&self, expr: &Expr) -> bool {
        let known = |name: &str| self.vocabulary.letters.iter().any(|letter| letter.name() == name);
        expr.names().iter().any(|name| !known(&name.text))
    }

    /// What a side says if it is a formula of words, as `speed of separation / speed of approach` is.
    pub(super) fn in_words(&self, tokens: &[Placed]) -> Option<String> {
        let nouns = |placed: &Placed| matches!(placed.token, Token::Phrase(Phrase::Noun | Phrase::Unknown));
        let words = |placed: &Placed| {
            matches!(placed.token, Token::Phrase(Phrase::Noun | Phrase::Unknown | Phrase::Remark | Phrase::Sphere))
                || matches!(placed.token, Token::Sign('+' | '-' | '*' | '/' | '(' | ')'))
                // `change in momentum`
                || self.slice(std::slice::from_ref(placed)).eq_ignore_ascii_case("in")
        };
        let is_formula = tokens.iter().any(nouns) && tokens.iter().all(words);
        is_formula.then(|| self.slice(tokens).to_lowercase())
    }

    /// `if e = 1`, `when e = 1`: who knows whether it is?
    pub(super) fn is_condition(&self, reason: &[Placed]) -> bool {
        let word = reason.first().map(|first| self.slice(std::slice::from_ref(first)).to_lowercase());
        matches!(word.as_deref(), Some("if" | "when")) && reason.iter().any(|placed| placed.is('='))
    }

    /// `13.3° when α = 38.3°`, `13.3° for α = 38.3°`: a number is said where a letter of the question has some value, as it is
    /// with `at`. A formula is not: `u/2 when e = 1` answers another question.
    pub(super) fn is_place_of_a_number(&self, before: &[Placed], reason: &[Placed]) -> bool {
        let is_letter = |placed: &Placed| match &placed.token {
            Token::Word(name) => names::letter(name, self.vocabulary).is_some(),
            Token::Greek(name) => names::letter(name, self.vocabulary).is_some(),
            _ => false,
        };
        let is_number = match self.found.last().and_then(|last| last.said.last()) {
            Some(said) if before.is_empty() => matches!(&said.form, Form::Value(value) if value.names().is_empty()),
            _ => before.iter().any(|placed| matches!(placed.token, Token::Number(_))) && !before.iter().any(is_letter),
        };
        match reason {
            [word, letter, equals, ..] if is_number && is_letter(letter) && equals.is('=') => {
                matches!(&*self.slice(std::slice::from_ref(word)).to_lowercase(), "when" | "for")
            }
            _ => false,
        }
    }

    /// Where that place is told with `for`.
    pub(super) fn place_of_a_number(&self, tokens: &[Placed]) -> Option<usize> {
        (1..tokens.len()).find(|at| {
            let (before, reason) = tokens.split_at(*at);
            matches!(reason[0].token, Token::Phrase(_)) && self.is_place_of_a_number(before, reason)
        })
    }

    /// One side of an equation, whose names must be known.
    pub(super) fn side(&mut self, tokens: &[Placed]) -> Result<Expr, Unreadable> {
        Ok(self.side_with_unit(tokens)?.0)
    }

    /// One side of an equation or of an inequality, and its unit.
    pub(super) fn side_with_unit(&mut self, tokens: &[Placed]) -> Result<(Expr, Option<SaidUnit>), Unreadable> {
        let place = tokens.first().map_or(self.text.len(), |first| first.start);
        let read = formula(tokens.to_vec(), 0, self.text, self.vocabulary, self.choices)?;
        let rest = &read.tokens[read.next..];
        let words = rest.iter().all(|placed| {
            matches!(
                placed.token,
                Token::Phrase(Phrase::Remark | Phrase::Joiner | Phrase::Noun | Phrase::Is) | Token::Sign('.')
            )
        });
        match read.form {
            Form::Value(value) if words => Ok((value, read.unit)),
            // `60% < e`
            Form::Percentage(value) if words => Ok((value.over(Expr::integer(100)), read.unit)),
            Form::Vector(x, y, _) if words => Ok((Expr::Vector(Box::new(x), Box::new(y)), read.unit)),
            _ => Err(Unreadable::Sign(place, "one side of the equation is no formula".to_owned())),
        }
    }
}

/// What is called so in `the value of k`: the letter.
pub(super) fn without_value_of(tokens: &[Placed]) -> &[Placed] {
    let words = tokens.iter().take_while(|placed| placed.token == Token::Phrase(Phrase::Remark)).count();
    &tokens[words..]
}

/// How many words stand between an `is` and the value that it goes before: `must be 8`, `has to be 8`, `is only 8`.
pub(super) fn filling(after: &[Placed]) -> usize {
    let says_nothing = |placed: &&Placed| matches!(placed.token, Token::Phrase(Phrase::Is | Phrase::Remark));
    let words = after.iter().take_while(says_nothing).count();
    let is_number = after.get(words).is_some_and(|next| matches!(next.token, Token::Number(_)));
    let are_all = after.iter().take_while(|placed| placed.token == Token::Phrase(Phrase::Is)).count();
    if is_number && words <= are_all + 1 { words } else { are_all }
}

/// Do letters alone stand before an `is`, and a value after it?
pub(super) fn is_called(before: &[Placed], after: &[Placed]) -> bool {
    let before = without_value_of(before);
    let after = &after[filling(after)..];
    let value =
        |token: &Token| !matches!(token, Token::Phrase(_) | Token::Sign('=' | '≈' | '<' | '>' | '≤' | '≥' | '≠'));
    let letters = before.iter().all(|placed| matches!(placed.token, Token::Word(_) | Token::Greek(_)));
    letters && !before.is_empty() && after.first().is_some_and(|placed| value(&placed.token))
}

/// `m2`, `v2` where the question has an m or a v: what such letters name has a number more often than others, and so the two
/// behind one may be its number.
fn numbered_name(tokens: &[Placed], expr: &Expr) -> Option<Expr> {
    let ([_, digit], Expr::Power(base, exponent)) = (tokens, expr) else { return None };
    let Expr::Name(name) = &**base else { return None };
    let is_two = digit.token == Token::Number(Expr::integer(2)) && **exponent == Expr::integer(2);
    (is_two && !digit.spaced && matches!(&*name.text, "m" | "u" | "v" | "w"))
        .then(|| Expr::name(format!("{}_2", name.text)))
}

/// A name, its size, or a sine, cosine or tangent of one: what an answer calls its value by.
fn is_a_name(expr: &Expr) -> bool {
    match expr {
        Expr::Name(_) => true,
        Expr::Power(base, _) => {
            matches!(&**base, Expr::Call(function, _) if *function != Function::Sqrt) && is_a_name(base)
        }
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, argument) => {
            !argument.names().is_empty() && argument.names().len() <= 2
        }
        Expr::Call(Function::Abs, _) => true,
        _ => false,
    }
}
