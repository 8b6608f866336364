//! A side without relations: values with the words around them, a name and a colon, a ratio.

use super::phrases::Phrase;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::values::Values;
use super::vectors::along;
use super::{Form, Label, ReferenceLine, Said, Statement, Unreadable};

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
            let name = matches!(left, [Placed { token: Token::Word(_) | Token::Greek(_), .. }]) && !tokens[at].spaced;
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

    fn ratio(&mut self, left: &[Placed], right: &[Placed]) -> Result<(), Unreadable> {
        let (left, right) = (self.scalar(left)?, self.scalar(right)?);
        let said = Said { form: Form::Ratio(left, right), unit: None, reference: None, remarks: Vec::new() };
        self.found.push(Statement { label: None, said: vec![said] });
        Ok(())
    }
}
