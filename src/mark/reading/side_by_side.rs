//! Statements with nothing but a blank between them: `v = 4 w = 6`, `A = 3 B = 5`.

use super::choices::Doubt;
use super::lexicon::is_rejection;
use super::names;
use super::phrases::Phrase;
use super::ranges::is_any;
use super::statements::Statements;
use super::tokens::{Placed, Token};
use super::units::{is_unit_word, unit};

impl Statements<'_> {
    /// Where the second of two statements begins: at a name, with a blank before it, between a value and an equals sign.
    ///
    /// A name that the question does not have can be no factor of the value before it. One that it has may be; then it is
    /// read as a name if numbers stand on both sides, and otherwise in a further reading.
    pub(super) fn next_statement(&mut self, tokens: &[Placed]) -> Option<usize> {
        if let Some(at) = next_inequality(tokens) {
            // `k > 2 reject k < -2`: which of the two is meant, a person sees.
            let is_rejection = |word: &Placed| is_rejection(&self.slice(std::slice::from_ref(word)).to_lowercase());
            return (!tokens[..at].iter().any(is_rejection)).then_some(at);
        }
        let equals = outer_equals(tokens);
        let first = *equals.first()?;
        if !is_label(&tokens[..first]) {
            return self.next_equation(tokens, &equals);
        }
        for pair in equals.windows(2) {
            let (value, after) = (&tokens[pair[0] + 1..pair[1]], &tokens[pair[1] + 1..]);
            let words = value.iter().rev().take_while(|placed| is_word(placed)).count();
            let is_named = value[value.len() - words..]
                .iter()
                .any(|placed| matches!(placed.token, Token::Phrase(Phrase::Sphere | Phrase::Noun)) && placed.spaced);
            let (name, is_known) = match value {
                _ if words > 0 && words < value.len() && is_named => (words, false),
                [_, .., last] if last.spaced => match &last.token {
                    Token::Word(name) if !is_unit_word(name) => match names::letter(name, self.vocabulary).is_some() {
                        false if names::is_made_of_letters(name, self.vocabulary) => continue,
                        is_known => (1, is_known),
                    },
                    Token::Greek(name) => (1, names::letter(name, self.vocabulary).is_some()),
                    _ => continue,
                },
                _ => continue,
            };
            let value = &value[..value.len() - name];
            let at = pair[1] - name;
            let may_be_product = is_known
                && (!self.is_of_figures(value)
                    || !after.first().is_some_and(|first| self.is_figure(first))
                    || self.choices.otherwise(Doubt::SideBySide, tokens[at].start));
            if self.ends_a_value(value) && !may_be_product {
                return Some(at);
            }
        }
        self.next_equation(tokens, &equals)
    }

    /// `with tan θ = 3/4`: a name with its own equals sign, that is told beside what stands before; so is an angle by its
    /// function, `at tan⁻¹(3/2) = 56.3°`.
    pub(super) fn adds(&self, tokens: &[Placed]) -> bool {
        let [with, rest @ ..] = tokens else { return false };
        let is_name = |placed: &Placed| {
            matches!(placed.token, Token::Word(_) | Token::Greek(_) | Token::Phrase(Phrase::Noun | Phrase::Remark))
        };
        let length = rest.iter().take_while(|placed| is_name(placed)).count();
        let is_named = length > 0 && rest.get(length).is_some_and(|next| next.is('='));
        let is_function = |placed: &Placed| matches!(&placed.token, Token::Word(word) if names::is_function(word));
        let is_angle = || rest.first().is_some_and(is_function) && rest.iter().any(|placed| placed.is('='));
        with.token == Token::Phrase(Phrase::Joiner)
            && matches!(&*self.slice(std::slice::from_ref(with)).to_lowercase(), "with" | "at")
            && (is_named || is_angle())
    }

    /// Where the second of two equations begins, `18 = 3v+w  w-v = 2`: after several blanks at letters or numbers of them;
    /// after one at letters that stood there before, as no product would have them again.
    fn next_equation(&mut self, tokens: &[Placed], equals: &[usize]) -> Option<usize> {
        for pair in equals.windows(2) {
            for at in pair[0] + 2..pair[1] {
                if !tokens[at].spaced || !self.ends_a_value(&tokens[pair[0] + 1..at]) {
                    continue;
                }
                let gap = self.text.get(tokens[at - 1].end..tokens[at].start).unwrap_or_default();
                let is_wide = gap.len() > 1 && gap.trim().is_empty();
                let side = &tokens[at..pair[1]];
                if !self.is_sum_of_letters(side, is_wide) {
                    continue;
                }
                let after = tokens.get(pair[1] + 1);
                let stood_before = |placed: &Placed| {
                    is_sign_of_sum(placed) || tokens[..at].iter().any(|before| before.token == placed.token)
                };
                let is_close = side[1..].iter().all(|placed| !placed.spaced);
                let likely = is_close
                    && side.iter().all(stood_before)
                    && (side.len() > 1 || after.is_some_and(|after| self.is_figure(after)));
                if is_wide || (likely && !self.choices.otherwise(Doubt::SideBySide, tokens[at].start)) {
                    return Some(at);
                }
            }
        }
        None
    }

    /// `w`, `w-v`, and after several blanks `4v`, too.
    fn is_sum_of_letters(&self, side: &[Placed], is_wide: bool) -> bool {
        let is_letter = |placed: &Placed| match &placed.token {
            Token::Word(word) => !is_unit_word(word) || names::letter(word, self.vocabulary).is_some(),
            Token::Greek(_) => true,
            _ => false,
        };
        let is_number = |placed: &Placed| is_wide && matches!(placed.token, Token::Number(_));
        let begins = side.first().is_some_and(|first| is_letter(first) || is_number(first));
        begins
            && side.last().is_some_and(is_letter)
            && side.iter().all(|placed| is_letter(placed) || is_number(placed) || is_sign_of_sum(placed))
    }

    /// Is it a number or a vector in numbers, with its unit or without?
    pub(super) fn is_of_figures(&self, value: &[Placed]) -> bool {
        let unit = (1..value.len()).find(|at| unit(value, *at, self.text).is_some_and(|(_, end)| end == value.len()));
        let unit =
            unit.filter(|at| !matches!(&value[*at..], [Placed { token: Token::Word(word), .. }] if word.len() == 1));
        value[..unit.unwrap_or(value.len())].iter().all(|placed| self.is_figure(placed))
    }

    fn is_figure(&self, placed: &Placed) -> bool {
        match &placed.token {
            Token::Number(_) | Token::Root { .. } => true,
            Token::Sign(sign) => matches!(sign, '-' | '+' | '/' | '(' | ')' | '°' | '⟦' | '⟧'),
            Token::Word(word) => self.vocabulary.vectors && matches!(word.as_str(), "i" | "j"),
            _ => false,
        }
    }

    /// Does a value end here, so that what follows is no argument of a function and no operand?
    fn ends_a_value(&self, tokens: &[Placed]) -> bool {
        match tokens.last().map(|last| &last.token) {
            Some(Token::Number(_) | Token::Sign(')' | ']' | '°' | '%' | '⟧')) => true,
            Some(Token::Phrase(Phrase::Line(_) | Phrase::Rest)) => true,
            Some(Token::Greek(name)) => names::letter(name, self.vocabulary).is_some(),
            Some(Token::Word(word)) => {
                is_unit_word(word)
                    || names::letter(word, self.vocabulary).is_some()
                    || (self.vocabulary.vectors && matches!(word.as_str(), "i" | "j"))
            }
            _ => false,
        }
    }
}

fn is_sign_of_sum(placed: &Placed) -> bool {
    placed.is('+') || placed.is('-')
}

/// Where the second of two inequalities for one letter begins, that bound it from both sides: `e > 1/3 e < 1`.
fn next_inequality(tokens: &[Placed]) -> Option<usize> {
    let is_above = |placed: &Placed| is_any(placed, &['>', '≥']);
    let is_below = |placed: &Placed| is_any(placed, &['<', '≤']);
    let mut signs = (1..tokens.len()).filter(|at| is_above(&tokens[*at]) || is_below(&tokens[*at]));
    let (first, second) = (signs.next()?, signs.next()?);
    let name = second - 1;
    let turns = is_above(&tokens[first]) == is_below(&tokens[second]);
    let is_again = tokens[name].token == tokens[first - 1].token && matches!(tokens[name].token, Token::Word(_));
    (turns && is_again && tokens[name].spaced && name > first + 1).then_some(name)
}

/// The places of the equals signs outside brackets.
fn outer_equals(tokens: &[Placed]) -> Vec<usize> {
    let mut depth = 0_usize;
    let mut found = Vec::new();
    for (at, placed) in tokens.iter().enumerate() {
        match placed.token {
            Token::Sign('(' | '[' | '{' | '⟦') => depth += 1,
            Token::Sign(')' | ']' | '}' | '⟧') => depth = depth.saturating_sub(1),
            Token::Sign('=' | '≈') if depth == 0 => found.push(at),
            _ => {}
        }
    }
    found
}

/// A name and nothing else, or its size, power, sine or tangent: `v`, `|v|`, `v²`, `tan θ`.
fn is_label(tokens: &[Placed]) -> bool {
    let is_name = |placed: &Placed| matches!(placed.token, Token::Word(_) | Token::Greek(_));
    let is_figure = |placed: &Placed| matches!(placed.token, Token::Number(_) | Token::Sign('^' | '⟦' | '⟧'));
    match tokens {
        [] => false,
        [bar, inner @ .., last] if bar.is('|') && last.is('|') => inner.iter().all(is_name),
        [first, rest @ ..] if is_name(first) => rest.iter().all(|placed| is_name(placed) || is_figure(placed)),
        words => words.iter().all(is_word),
    }
}

fn is_word(placed: &Placed) -> bool {
    matches!(placed.token, Token::Phrase(Phrase::Sphere | Phrase::Noun | Phrase::Remark | Phrase::Joiner))
}
