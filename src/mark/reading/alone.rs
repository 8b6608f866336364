//! A side without relations: values with the words around them, a name and a colon, a ratio.

use super::phrases::Phrase;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::values::Values;
use super::vectors::along;
use super::{Form, Label, ReferenceLine, Said, SaidUnit, Statement, Unreadable, names};
use crate::expr::Expr;

impl Statements<'_> {
    /// A side without relations: `A: 3.08`, `2 : 3`, `1.04 ms^-1 at right angles to LOC`.
    pub(super) fn alone(&mut self, tokens: &[Placed]) -> Result<(), Unreadable> {
        let colon = tokens.iter().position(|placed| placed.is(':'));
        if let Some(at) = colon {
            let (left, right) = (&tokens[..at], &tokens[at + 1..]);
            if right.is_empty() {
                self.remark(self.slice(left).to_lowercase());
                return Ok(());
            }
            // `v : 3`, where there is no v of which it could be the ratio.
            let is_known = |letter: &Placed| match &letter.token {
                Token::Word(word) => names::is_made_of_letters(word, self.vocabulary),
                _ => true,
            };
            let is_close = !tokens[at].spaced || left.first().is_some_and(|letter| !is_known(letter));
            let name = matches!(left, [Placed { token: Token::Word(_) | Token::Greek(_), .. }]) && is_close;
            // `ratio 2:3`
            let number = left.iter().position(|placed| matches!(placed.token, Token::Number(_)));
            let count = left.iter().take_while(|placed| matches!(placed.token, Token::Phrase(_))).count();
            if let Some(number) = number.filter(|number| *number == count && count > 0) {
                let label = Label { typed: self.slice(&left[..number]).to_owned(), expr: None };
                return self.labelled(Some(label), &[&tokens[number..]]);
            }
            let words = count > 0;
            if !left.is_empty() && (name || words) {
                let label = Label { typed: self.plain_name(left), expr: self.named(left) };
                return self.labelled(Some(label), &[right]);
            }
            return self.ratio(left, right);
        }
        if let Some(said) = self.range(tokens)?.or(self.any_multiple(tokens)?) {
            self.found.push(Statement { label: None, said: vec![said] });
            return Ok(());
        }
        // `2.78 (A), 3.08 (B)`
        if let [Placed { token: Token::Phrase(Phrase::Sphere), start, .. }] = tokens
            && self.text.get(..*start).is_some_and(|before| before.ends_with('('))
            && let typed = self.slice(tokens).to_owned()
            && let Some(last) = self.found.last_mut().filter(|last| last.label.is_none())
        {
            last.label = Some(Label { typed, expr: None });
            return Ok(());
        }
        self.is_worked_out(tokens)?;
        let is_toward = tokens.first().is_some_and(|first| first.token == Token::Phrase(Phrase::Toward));
        let mut values = Values { text: self.text, vocabulary: self.vocabulary, choices: self.choices };
        let stretch = values.stretch(tokens)?;
        stretch.remarks.into_iter().for_each(|words| self.remark(words));
        for (label, said) in stretch.values {
            let label = label.map(|typed| Label { typed, expr: None });
            // `71.6° to the line of centres, towards B`; `…, A towards B` says of what it is, too.
            let only = self.found.len() == 1;
            // `along the line of centres, A to B` says it of the line that was named.
            let is_named = self.found.last().and_then(|last| last.said.last()?.reference).is_some();
            let is_sense = |line: &ReferenceLine| {
                line.is_sense_alone() || is_named && matches!(line, ReferenceLine::AlongAToB | ReferenceLine::AlongBToA)
            };
            if let (Form::Direction, Some(sense)) = (&said.form, said.reference.filter(is_sense))
                && let Some(before) = self.found.last_mut()
                && (label.is_none() || (only && before.label.is_none()))
                && let Some(last) = before.said.last_mut()
                && let Some(joined) = last.reference.map_or(Some(sense), |line| line.and(sense))
            {
                last.reference = Some(joined);
                last.remarks.extend(said.remarks);
                before.label = before.label.take().or(label);
                continue;
            }
            // `32 N s, direction of j`
            if let (true, Form::Vector(x, y, _)) = (is_toward, &said.form)
                && let Some(last) = self.found.last_mut().and_then(|found| found.said.last_mut())
                && let Form::Value(size) = &last.form
            {
                last.form = along(size, x, y);
                continue;
            }
            self.found.push(Statement { label, said: vec![said] });
        }
        Ok(())
    }

    /// A term of a ratio, beside which no words stand.
    fn term(&mut self, tokens: &[Placed]) -> Result<(Expr, Option<SaidUnit>), Unreadable> {
        let found = self.side_with_unit(tokens)?;
        let is_word = |placed: &&Placed| matches!(placed.token, Token::Phrase(_));
        match tokens.iter().find(is_word).or(tokens.first().filter(|_| matches!(found.0, Expr::Vector(..)))) {
            Some(other) => Err(Unreadable::Sign(other.start, "a term of a ratio is a number or formula".to_owned())),
            None => Ok(found),
        }
    }

    fn ratio(&mut self, left: &[Placed], right: &[Placed]) -> Result<(), Unreadable> {
        let place = right.first().map_or(self.text.len(), |first| first.start);
        // `3:04` is a time.
        if self.slice(right).strip_prefix('0').is_some_and(|rest| rest.starts_with(|sign: char| sign.is_ascii_digit()))
        {
            return Err(Unreadable::Sign(place, "a time, or a ratio whose second term begins with 0".to_owned()));
        }
        let ((left, of_left), (right, of_right)) = (self.term(left)?, self.term(right)?);
        if of_left.map(|unit| unit.typed) != of_right.map(|unit| unit.typed) {
            return Err(Unreadable::Sign(place, "the terms of the ratio have different units".to_owned()));
        }
        let said = Said { form: Form::Ratio(left, right), unit: None, reference: None, remarks: Vec::new() };
        self.found.push(Statement { label: None, said: vec![said] });
        Ok(())
    }
}
