//! The grammar of a student's formula. What holds tightest comes first: roots, powers, functions, side by side, strokes.

use super::characters::{CLOSE, OPEN};
use super::choices::{Choices, Doubt};
use super::tokens::{Placed, Token, excerpt};
use super::units;
use super::vectors::rational;
use super::{SaidUnit, Unreadable, Vocabulary};
use crate::expr::{Expr, Function};
use crate::number::Fraction;

/// Deeper nesting than any answer has.
const DEEPEST: usize = 40;

/// More parts than any answer has.
const MOST_PARTS: usize = 400;

/// The highest exponent that is read.
const HIGHEST_EXPONENT: i64 = 16;

/// A walk over the tokens of an answer.
pub(super) struct Parser<'a> {
    pub(super) tokens: Vec<Placed>,
    pub(super) at: usize,
    pub(super) text: &'a str,
    pub(super) vocabulary: &'a Vocabulary,
    pub(super) choices: &'a mut Choices,
    /// In a label any name will do.
    pub(super) any_name: bool,
    /// Where the tokens that may be read end.
    pub(super) end: usize,
    /// Which brackets stand open.
    pub(super) open: Vec<char>,
    depth: usize,
    parts: usize,
    /// Was a vector written in brackets with a comma, or as a column?
    pub(super) coordinates: bool,
    pub(super) column: bool,
}

/// A formula and whether its last part is bare, so that what follows could belong to it.
pub(super) type Parsed = Result<Expr, Unreadable>;

impl<'a> Parser<'a> {
    /// A walk from the first token.
    pub(super) fn new(
        tokens: Vec<Placed>,
        text: &'a str,
        vocabulary: &'a Vocabulary,
        choices: &'a mut Choices,
    ) -> Self {
        let end = tokens.len();
        Parser {
            tokens,
            at: 0,
            text,
            vocabulary,
            choices,
            any_name: false,
            end,
            open: Vec::new(),
            depth: 0,
            parts: 0,
            coordinates: false,
            column: false,
        }
    }

    pub(super) fn token(&self, ahead: usize) -> Option<&Token> {
        let at = self.at + ahead;
        (at < self.end).then(|| &self.tokens[at].token)
    }

    pub(super) fn sign(&self, ahead: usize) -> Option<char> {
        match self.token(ahead) {
            Some(Token::Sign(sign)) => Some(*sign),
            _ => None,
        }
    }

    pub(super) fn spaced(&self, ahead: usize) -> bool {
        self.tokens.get(self.at + ahead).is_some_and(|placed| placed.spaced)
    }

    pub(super) fn eat(&mut self, sign: char) -> bool {
        let found = self.sign(0) == Some(sign);
        self.at += usize::from(found);
        found
    }

    /// Where the next token stands in the text.
    pub(super) fn place(&self) -> usize {
        match self.tokens.get(self.at).filter(|_| self.at < self.end) {
            Some(placed) => placed.start,
            None => self.end.checked_sub(1).and_then(|last| self.tokens.get(last)).map_or(0, |placed| placed.end),
        }
    }

    pub(super) fn fault<T>(&self, message: impl Into<String>) -> Result<T, Unreadable> {
        Err(Unreadable::Sign(self.place(), message.into()))
    }

    /// What cannot stand where it does.
    pub(super) fn unexpected<T>(&self) -> Result<T, Unreadable> {
        match self.token(0) {
            None => self.fault("something is missing at the end"),
            Some(Token::Word(word)) => self.fault(format!("`{word}` is neither a letter of the question nor a unit")),
            Some(Token::Greek(name)) => self.fault(format!("`{name}` is no letter of the question")),
            Some(Token::Number(_)) => self.fault("a number without a sign before it"),
            Some(Token::Phrase(_)) => self.fault("words where a number or letter is expected"),
            Some(Token::Sign(CLOSE | OPEN)) => self.fault("something is missing here"),
            Some(Token::Sign('\n')) => self.fault("the line ends too early"),
            Some(Token::Sign(sign @ ('±' | '∓'))) => self.fault(format!("`{sign}` says two things at once")),
            Some(Token::Sign(sign)) => self.fault(format!("`{sign}` where a number or letter is expected")),
            Some(_) => self.fault("something is missing here"),
        }
    }

    /// Runs a rule one level further down.
    pub(super) fn nested(&mut self, rule: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        self.choices.step(self.place())?;
        self.parts += 1;
        if self.depth >= DEEPEST {
            return self.fault("the answer is nested too deeply");
        }
        if self.parts > MOST_PARTS {
            return self.fault("the answer is too long a formula");
        }
        self.depth += 1;
        let parsed = rule(self);
        self.depth -= 1;
        parsed
    }

    /// Terms with plus and minus signs.
    pub(super) fn sum(&mut self) -> Parsed {
        let mut terms = Vec::new();
        self.eat('+');
        loop {
            terms.push(self.nested(Self::term)?);
            if self.sign(0) == Some('-') && self.column_entry_follows() {
                break;
            }
            if !self.eat('+') && self.sign(0) != Some('-') {
                break;
            }
        }
        Ok(if terms.len() == 1 { terms.remove(0) } else { Expr::Sum(with_degrees_throughout(terms)) })
    }

    /// `(2 -1)`: in brackets, a minus sign with a blank before it and none after may begin a second component.
    fn column_entry_follows(&mut self) -> bool {
        let in_brackets = matches!(self.open.last(), Some('(' | '[')) && self.vocabulary.vectors;
        if !in_brackets || !self.spaced(0) || self.spaced(1) {
            return false;
        }
        let place = self.place();
        // One blank between two numbers is all that such brackets hold.
        let opened =
            (0..self.at).rev().take_while(|at| !matches!(self.tokens[*at].token, Token::Sign('(' | '['))).count();
        opened <= 4 && matches!(self.token(1), Some(Token::Number(_))) && self.choices.otherwise(Doubt::Column, place)
    }

    /// A product, with the minus signs before it.
    pub(super) fn term(&mut self) -> Parsed {
        if self.eat('-') {
            return if self.is_sign_squared() { self.product() } else { self.negated(Self::term) };
        }
        self.product()
    }

    /// What stands after a minus sign; three of them in a row are a stroke of the pen and not an operation.
    fn negated(&mut self, rule: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        if self.sign(0) == Some('-') && self.sign(1) == Some('-') {
            return self.fault("three minus signs in a row");
        }
        Ok(negative(self.nested(rule)?))
    }

    /// A factor after an explicit sign may have a minus sign of its own.
    pub(super) fn signed_factor(&mut self) -> Parsed {
        if self.eat('-') {
            return self.negated(Self::signed_factor);
        }
        self.nested(Self::factor)
    }

    /// An operand with its power and degree sign.
    pub(super) fn factor(&mut self) -> Parsed {
        let start = self.at;
        let base = self.operand()?;
        self.raised(base, start)
    }

    /// What follows an operand that began at a token: powers, degrees.
    pub(super) fn raised(&mut self, base: Expr, start: usize) -> Parsed {
        let mut value = base;
        let single = self.at == start + 1;
        if self.eat('^') {
            let exponent = self.nested(Self::exponent)?;
            value = power(value, exponent).or_else(|message| self.fault(message))?;
        } else if let Expr::Name(name) = &value
            && self.any_name
            && single
            && self.subscript_follows()
        {
            // `v1` is a name; `v2` may be a square, too.
            value = Expr::name(format!("{}_1", name.text));
            self.at += 1;
        } else if single && matches!(value, Expr::Name(_)) && !self.spaced(0) && self.small_digit() {
            // `v2` where the question has no such letter: the raised two of another keyboard. `e2v` may be e times 2v.
            let place = self.place();
            let is_e = matches!(&value, Expr::Name(name) if name.text == "e");
            let letter_next = !self.spaced(1) && matches!(self.token(1), Some(Token::Word(_) | Token::Letter(_)));
            let multiplies = is_e && letter_next && self.choices.otherwise(Doubt::Multiple, place);
            let digit = self.operand()?;
            let typed = self.typed(start);
            value = match multiplies {
                true => Expr::Product(vec![value, digit]),
                false => Expr::Power(Box::new(value), Box::new(digit)),
            };
            self.choices.note(|| format!("{typed} read as {}", crate::expr::print::unicode(&value)));
        } else if single && matches!(&value, Expr::Name(name) if name.text == "e") && self.multiple_follows() {
            // `e6u`, `e 2v`
            value = Expr::Product(vec![value, self.operand()?]);
        }
        while self.sign(0) == Some('°') {
            self.at += 1;
            value = self.minutes(value)?;
        }
        Ok(value)
    }

    /// A one close behind, which is no power.
    fn subscript_follows(&self) -> bool {
        let more = !self.spaced(1) && matches!(self.token(1), Some(Token::Number(_)) | Some(Token::Sign('^' | '.')));
        self.token(0) == Some(&Token::Number(Expr::integer(1))) && !self.spaced(0) && !more
    }

    /// A number with a letter close behind it: so much of that.
    fn multiple_follows(&self) -> bool {
        let letter_next = !self.spaced(1) && matches!(self.token(1), Some(Token::Word(_) | Token::Letter(_)));
        matches!(self.token(0), Some(Token::Number(_))) && letter_next
    }

    /// A two or three that stands by itself.
    fn small_digit(&self) -> bool {
        let small = matches!(self.token(0), Some(Token::Number(value)) if *value == Expr::integer(2) || *value == Expr::integer(3));
        let more = !self.spaced(1) && matches!(self.token(1), Some(Token::Number(_)) | Some(Token::Sign('^')));
        small && !more
    }

    /// A formula with a sign of degrees behind it; in `α°` the letter is the angle already.
    pub(super) fn in_degrees(&self, expr: Expr) -> Expr {
        let is_angle = matches!(&expr, Expr::Name(name) if self.is_angle(&name.text));
        if is_angle { expr } else { Expr::degrees(expr) }
    }

    /// The text from a token up to what has been read.
    pub(super) fn typed(&self, start: usize) -> &'a str {
        let last = self.at.saturating_sub(1).max(start);
        match (self.tokens.get(start), self.tokens.get(last)) {
            (Some(first), Some(last)) => excerpt(self.text, first.start, last.end.max(first.start)),
            _ => "",
        }
    }

    /// Powers of powers are taken from the right. `2^3/2` may be meant to have a fraction for exponent; nobody raises to sevenths.
    fn exponent(&mut self) -> Parsed {
        if self.eat('-') {
            return self.negated(Self::exponent);
        }
        let (start, place) = (self.at, self.place());
        // `mu^2 5/7` has a square, and no mixed number.
        let base = match self.token(0).cloned() {
            Some(Token::Number(number)) => {
                self.at += 1;
                number
            }
            _ => self.operand()?,
        };
        let fraction =
            matches!(base, Expr::Number(_)) && self.at == start + 1 && self.sign(0) == Some('/') && !self.spaced(0);
        if fraction && let Some(Token::Number(below)) = self.token(1).cloned() {
            // Nobody writes a first power, so `13^1/2` is a root.
            let is_half = below == Expr::integer(2);
            if base.is_one() || is_half && self.choices.otherwise(Doubt::Exponent, place) {
                self.at += 2;
                return Ok(Expr::Quotient(Box::new(base), Box::new(below)));
            }
        }
        if self.eat('^') {
            let exponent = self.nested(Self::exponent)?;
            return power(base, exponent).or_else(|message| self.fault(message));
        }
        Ok(base)
    }

    /// Are bars the innermost thing that stands open?
    pub(super) fn in_bars(&self) -> bool {
        self.open.last() == Some(&'|')
    }

    /// Outside all brackets?
    pub(super) fn outside(&self) -> bool {
        self.open.is_empty()
    }

    /// The unit that begins at the next token, if the formula ends with it.
    pub(super) fn unit_here(&self) -> Option<(SaidUnit, usize)> {
        let (unit, next) = units::unit(&self.tokens[..self.end], self.at, self.text)?;
        let ends = match self.tokens.get(next).filter(|_| next < self.end).map(|placed| &placed.token) {
            None | Some(Token::Phrase(_)) => true,
            // `3.61 m/s 56.3°`
            Some(Token::Number(_)) => {
                let is_degrees = self.tokens[..self.end].get(next + 1).is_some_and(|after| after.is('°'));
                is_degrees && self.tokens[next].spaced
            }
            Some(Token::Sign(sign)) => {
                !matches!(*sign, '+' | '-' | '*' | '/' | '^' | '(' | '|' | OPEN | '°' | '%' | '\'')
            }
            Some(_) => false,
        };
        ends.then_some((unit, next))
    }
}

pub(super) fn negative(value: Expr) -> Expr {
    Expr::Negative(Box::new(value))
}

/// A power, if its exponent is no more than anyone writes.
fn power(base: Expr, exponent: Expr) -> Result<Expr, String> {
    let size = match &exponent {
        Expr::Negative(inner) => inner,
        other => other,
    };
    let ten = base == Expr::integer(10);
    match size {
        Expr::Number(value) if value.abs() > Fraction::from(if ten { 20 } else { HIGHEST_EXPONENT }) => {
            Err("the exponent is too high".to_owned())
        }
        Expr::Power(..) | Expr::Product(_) if size.names().is_empty() => Err("the exponent is too high".to_owned()),
        _ => Ok(Expr::Power(Box::new(base), Box::new(exponent))),
    }
}

/// Where an angle stands in a sum, numbers beside it are degrees: `180 - arctan 7`.
fn with_degrees_throughout(terms: Vec<Expr>) -> Vec<Expr> {
    fn is_angle(expr: &Expr) -> bool {
        match expr {
            Expr::Degrees(_) | Expr::Call(Function::Asin | Function::Acos | Function::Atan, _) => true,
            Expr::Negative(inner) => is_angle(inner),
            // `180 - 2 arctan 2`, `180 - (arctan 2 + 45)`; in `180/pi * arctan 2` it is a number of degrees.
            Expr::Product(factors) => {
                let (angles, others): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|factor| is_angle(factor));
                angles.len() == 1 && others.into_iter().all(|factor| rational(factor).is_some())
            }
            Expr::Quotient(above, below) => is_angle(above) && rational(below).is_some(),
            Expr::Sum(terms) => terms.iter().any(is_angle),
            _ => false,
        }
    }
    fn measured(expr: Expr) -> Expr {
        match expr {
            Expr::Number(_) | Expr::Decimal(_) => Expr::degrees(expr),
            Expr::Negative(inner) => Expr::Negative(Box::new(measured(*inner))),
            other => other,
        }
    }
    if !terms.iter().any(is_angle) {
        return terms;
    }
    terms.into_iter().map(measured).collect()
}
