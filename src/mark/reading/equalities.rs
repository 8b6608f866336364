//! Chains of equals signs: what stands left of them, and the values that are said to be one another's equals.

use super::centres;
use super::line;
use super::phrases::Phrase;
use super::sides::Side;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::values::Values;
use super::wording::CENTRES;
use super::{Form, Label, ReferenceLine, Said, Statement, Unreadable};
use crate::expr::{Expr, Function};

impl Statements<'_> {
    pub(super) fn equality(&mut self, sides: &[&[Placed]]) -> Result<(), Unreadable> {
        if let [left, right] = sides
            && let name = left.len() - self.without_name_of_line(left).len()
            && let Some(gradient) = line::gradient(&left[name..], right, self.text, self.vocabulary)
        {
            if name > 0 {
                self.remark(self.slice(&left[..name]).to_lowercase());
            }
            self.lines.push(gradient.clone());
            let said = Said { form: Form::Gradient(gradient), unit: None, reference: None, remarks: Vec::new() };
            self.found.push(Statement { label: None, said: vec![said] });
            return Ok(());
        }
        let mut sides = sides.to_vec();
        sides[0] = self.without_lead_in(sides[0]);
        // `x: 2 + 3 = 5`
        if let Some(at) = sides[0].iter().position(|placed| placed.is(':'))
            && let (name, [_, value @ ..]) = sides[0].split_at(at)
            && is_of_words(name)
            && !value.is_empty()
            && self.is_of_figures(value)
        {
            let label = Label { typed: self.plain_name(name), expr: self.named(name) };
            sides[0] = value;
            return self.labelled(Some(label), &sides);
        }
        // `KE before ½(4 + 9) + 2 = 8.5`
        let words = sides[0].iter().take_while(|placed| matches!(placed.token, Token::Phrase(_))).count();
        let (name, value) = sides[0].split_at(words);
        if !name.is_empty() && self.is_worked_in_figures(value) {
            let label = Label { typed: self.plain_name(name), expr: None };
            sides[0] = value;
            return self.labelled(Some(label), &sides);
        }
        let sides = sides.as_slice();
        let left = self.what_is(sides[0])?;
        // `2.78 = v`
        if !matches!(left, Side::Label(_))
            && let [values @ .., name] = sides
            && let Some(label) = self.name_at_the_end(name, matches!(left, Side::Number))
        {
            return self.labelled(Some(label), values);
        }
        // `17.9 = 2v`
        if let ([value, multiple], Side::Number) = (sides, &left)
            && self.is_multiple(multiple)
        {
            return self.equality(&[multiple, value]);
        }
        match left {
            Side::Label(label) => self.labelled(Some(label), &sides[1..]),
            Side::Number => self.labelled(None, sides),
            Side::Formula => {
                let values: Vec<Expr> = sides.iter().map(|side| self.side(side)).collect::<Result<_, _>>()?;
                let said = values.windows(2).map(|pair| Said {
                    form: Form::Equation(Expr::equation(pair[0].clone(), pair[1].clone())),
                    unit: None,
                    reference: None,
                    remarks: Vec::new(),
                });
                self.found.push(Statement { label: None, said: said.collect() });
                Ok(())
            }
        }
    }

    /// `LOC: y`, `the line of centres is y`: a side without the name of the line of centres before it.
    fn without_name_of_line<'t>(&self, tokens: &'t [Placed]) -> &'t [Placed] {
        let is_name = |placed: &Placed| match placed.token {
            Token::Phrase(Phrase::Line(line)) => line.unsensed() == ReferenceLine::AlongLineOfCentres,
            // The common tangent and velocities are nouns, too.
            Token::Phrase(Phrase::Noun) => names_line_of_centres(self.slice(std::slice::from_ref(placed))),
            Token::Phrase(Phrase::Remark | Phrase::Joiner | Phrase::Is) => true,
            _ => placed.is(':'),
        };
        &tokens[tokens.iter().take_while(|placed| is_name(placed)).count()..]
    }

    /// Values that are said to be one another's equals.
    pub(super) fn labelled(&mut self, label: Option<Label>, sides: &[&[Placed]]) -> Result<(), Unreadable> {
        // `tan θ = 3/2 56.3°`: the angle itself follows.
        if let ([before @ .., last], Some(Expr::Call(..))) =
            (sides, label.as_ref().and_then(|label| label.expr.as_ref()))
            && let [value @ .., number, degrees] = *last
            && matches!(value.last().map(|last| &last.token), Some(Token::Number(_) | Token::Sign(')' | '⟧')))
            && matches!(number.token, Token::Number(_))
            && number.spaced
            && degrees.is('°')
        {
            self.labelled(label, &[before, &[value]].concat())?;
            return self.alone(&last[value.len()..]);
        }
        let mut label = label;
        let gradient =
            label.as_ref().is_some_and(|label| matches!(&*label.typed.to_lowercase(), "gradient" | "grad" | "slope"));
        let mut said = Vec::new();
        let mut more = Vec::new();
        let mut remarks = Vec::new();
        let mut inner = None;
        for (place, side) in sides.iter().enumerate() {
            let last = place + 1 == sides.len();
            // `v_A : v_B = 2 : 3`
            if let Some(colon) = side.iter().position(|placed| placed.is(':')) {
                let (left, right) = (self.scalar(&side[..colon])?, self.scalar(&side[colon + 1..])?);
                said.push(Said { form: Form::Ratio(left, right), unit: None, reference: None, remarks: Vec::new() });
                continue;
            }
            if let Some(whole) = self.range(side)?.or(self.any_multiple(side)?) {
                said.push(whole);
                continue;
            }
            // `e = separation/approach = 2/3`, `v = |4i + j| = √17`
            let named = self.is_size_of_vector(side).then(|| self.slice(side).to_lowercase());
            if !last && let Some(words) = named.or_else(|| self.in_words(side)) {
                remarks.push(words);
                continue;
            }
            if !last && self.leads_on(side) {
                continue;
            }
            // `speed = v = 2.78`: the letter for what is named.
            if let (false, 0, Some(label)) = (last, place, label.as_mut().filter(|label| label.expr.is_none()))
                && let Some(name) = self.other_name(side)
                && is_of_same_sphere(&name, &label.typed)
            {
                label.typed = format!("{} {name}", label.typed);
                continue;
            }
            self.is_worked_out(side)?;
            let mut values = Values { text: self.text, vocabulary: self.vocabulary, choices: self.choices };
            let stretch = values.stretch(side)?;
            let mut found = stretch.values.into_iter();
            let Some((named, mut first)) = found.next() else {
                let start = side.first().map_or(0, |first| first.start);
                return Err(Unreadable::Sign(start, "a value is expected here".to_owned()));
            };
            inner = inner.or(named);
            if gradient && let Form::Value(value) = &first.form {
                first.form = Form::Gradient(value.clone());
            }
            first.remarks.extend(remarks.drain(..).chain(stretch.remarks));
            said.push(first);
            for (named, value) in found {
                if !last {
                    let start = side.first().map_or(0, |first| first.start);
                    return Err(Unreadable::Sign(start, "two values between two equals signs".to_owned()));
                }
                more.push(Statement { label: named.map(|typed| Label { typed, expr: None }), said: vec![value] });
            }
        }
        if let (Some(label), Some(named)) = (&mut label, inner) {
            label.typed = format!("{}: {named}", label.typed);
        }
        self.found.push(Statement { label, said });
        self.found.extend(more);
        Ok(())
    }

    /// Is something worked out there, in figures and letters of the question?
    fn is_worked_in_figures(&self, tokens: &[Placed]) -> bool {
        let is_operation = |placed: &Placed| matches!(placed.token, Token::Sign('+' | '-' | '*' | '/' | '^'));
        let is_letter = |name: &str| self.vocabulary.letters.iter().any(|letter| letter.name() == name);
        let is_figure = |placed: &Placed| match &placed.token {
            Token::Number(_) | Token::Root { .. } | Token::Sign('(' | ')' | '⟦' | '⟧' | '.' | '·') => true,
            Token::Word(word) => is_letter(word),
            _ => is_operation(placed),
        };
        let begins =
            tokens.first().is_some_and(|first| matches!(first.token, Token::Number(_) | Token::Sign('(' | '⟦')));
        begins && tokens.iter().all(is_figure) && tokens.iter().any(is_operation)
    }

    /// A letter alone that the question does not have.
    fn other_name(&mut self, side: &[Placed]) -> Option<String> {
        let name = self.named(side).filter(|name| matches!(name, Expr::Name(_)) && self.has_strange_names(name));
        name.map(|_| self.plain_name(side))
    }

    /// `m(v − u)`: a formula in letters that nobody knows, on the way to its value. In `u sin θ` another name may begin.
    fn leads_on(&mut self, side: &[Placed]) -> bool {
        let formula = self.passes_over.then(|| self.named(side)).flatten();
        let is_plain = |formula: &Expr| !matches!(formula, Expr::Name(_)) && !has_ratio_of_angle(formula);
        formula.is_some_and(|formula| is_plain(&formula) && self.has_strange_names(&formula))
    }
}

/// `line of centers`, `LOC`, `direction`
fn names_line_of_centres(noun: &str) -> bool {
    let noun = noun.to_lowercase().replace("center", "centre");
    let words: Vec<&str> = noun.split_whitespace().collect();
    let is_described = |from: usize| centres::described(|at| words.get(at).copied(), from) == Some(words.len());
    CENTRES.iter().any(|name| noun.ends_with(name)) || noun == "direction" || (0..words.len()).any(is_described)
}

/// Does a letter with the name of a sphere stand behind words that name that sphere?
fn is_of_same_sphere(letter: &str, words: &str) -> bool {
    let mut signs = letter.chars();
    let first = signs.next();
    let index = signs.next_back().filter(|index| first.is_some() && index.is_alphanumeric());
    index.is_none_or(|index| words.split(|sign: char| !sign.is_alphanumeric()).any(|word| word == index.to_string()))
}

/// Names and words alone.
fn is_of_words(tokens: &[Placed]) -> bool {
    let is_word = |placed: &Placed| matches!(placed.token, Token::Word(_) | Token::Greek(_) | Token::Phrase(_));
    !tokens.is_empty() && tokens.iter().all(is_word)
}

fn has_ratio_of_angle(expr: &Expr) -> bool {
    matches!(expr, Expr::Call(Function::Sin | Function::Cos | Function::Tan, _))
        || expr.children().into_iter().any(has_ratio_of_angle)
}
