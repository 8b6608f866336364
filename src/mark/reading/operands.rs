//! Operands: numbers and mixed numbers, letters, roots, sizes, brackets and columns.

use dashu_int::IBig;

use super::characters::{CLOSE, OPEN};
use super::choices::Doubt;
use super::grammar::{Parsed, Parser};
use super::names;
use super::tokens::{Placed, Token};
use super::vectors::rational;
use crate::expr::{Expr, Function};
use crate::number::Fraction;

impl Parser<'_> {
    /// The letters and functions of a word in place of it. `false` if it is not made of them.
    pub(super) fn take_apart(&mut self, at: usize) -> bool {
        let Placed { token, start, end, spaced } = self.tokens[at].clone();
        let pieces = match &token {
            Token::Word(word) => match names::split(word, start, self.vocabulary, self.choices) {
                Some(pieces) => pieces,
                None if self.any_name => vec![Token::Letter(word.clone())],
                None => return false,
            },
            Token::Greek(name) => match names::letter(name, self.vocabulary) {
                Some(letter) => vec![letter],
                None if self.any_name => vec![Token::Letter((*name).to_owned())],
                None => match names::split(name, start, self.vocabulary, self.choices) {
                    // Of `μ²` nobody knows whether it is (mu)² or mu².
                    Some(pieces) if *name == "mu" && !self.tokens.get(at + 1).is_some_and(|next| next.is('^')) => {
                        pieces
                    }
                    _ => return false,
                },
            },
            _ => return true,
        };
        let count = pieces.len();
        let whole = token_length(&token) == end - start;
        let mut from = start;
        let placed: Vec<Placed> = pieces
            .into_iter()
            .enumerate()
            .map(|(place, token)| {
                let first = if whole { from } else { start };
                let last = if whole && place + 1 < count { first + piece_length(&token) } else { end };
                from = last.min(end);
                Placed { token, start: first.min(end), end: last.min(end), spaced: spaced && place == 0 }
            })
            .collect();
        self.tokens.splice(at..=at, placed);
        self.end += count - 1;
        true
    }

    pub(super) fn operand(&mut self) -> Parsed {
        self.choices.step(self.place())?;
        // `4i+jms-1`
        if matches!(self.token(0), Some(Token::Word(_) | Token::Greek(_)))
            && !self.take_apart(self.at)
            && !(self.part_before_a_unit() && self.take_apart(self.at))
        {
            return self.unexpected();
        }
        let value = match self.token(0) {
            Some(Token::Number(value)) => {
                let value = value.clone();
                return self.number(value);
            }
            Some(Token::Letter(name)) => Expr::name(name.clone()),
            Some(Token::Along(letter)) => Expr::name(letter.to_string()),
            Some(Token::Pi) => Expr::Pi,
            Some(Token::Sign('°')) => Expr::degrees(Expr::integer(1)),
            Some(Token::Root { cube }) => {
                let cube = *cube;
                self.at += 1;
                return self.nested(|parser| parser.root(cube));
            }
            Some(Token::Function(function)) => {
                let function = *function;
                self.at += 1;
                return self.nested(|parser| parser.call(function));
            }
            Some(Token::Reciprocal(function)) => {
                let function = *function;
                self.at += 1;
                return Ok(match self.nested(|parser| parser.call(function))? {
                    // `arccot 7` is the angle whose tangent is one over seven.
                    Expr::Call(inverse @ (Function::Asin | Function::Acos | Function::Atan), argument) => {
                        let share = rational(&argument).and_then(|number| number.reciprocal());
                        Expr::call(inverse, share.map_or_else(|| Expr::integer(1).over(*argument), Expr::Number))
                    }
                    value => Expr::integer(1).over(value),
                });
            }
            Some(Token::Sign('|')) => {
                self.at += 1;
                return self.nested(Self::bars);
            }
            Some(Token::Sign(open @ ('(' | '[' | '{' | OPEN))) => {
                let open = *open;
                self.at += 1;
                return self.nested(|parser| parser.brackets(open));
            }
            _ => return self.unexpected(),
        };
        self.at += 1;
        Ok(value)
    }

    /// A number, or a mixed number: `2 3/4`, `2½`.
    fn number(&mut self, value: Expr) -> Parsed {
        let start = self.at;
        self.at += 1;
        let Expr::Number(whole) = &value else { return Ok(value) };
        let digits = |ahead: usize| match self.token(ahead) {
            Some(Token::Number(Expr::Number(part))) => Some(part.clone()),
            _ => None,
        };
        let group = self.sign(0) == Some(OPEN);
        let ahead = usize::from(group);
        let stroke = self.sign(ahead + 1) == Some('/') && (group || !self.spaced(1) && !self.spaced(2));
        let (above, below) = (digits(ahead), digits(ahead + 2));
        let closed = !group || self.sign(4) == Some(CLOSE);
        let blank = group || self.spaced(0);
        let (Some(above), Some(below), true) = (above, below, stroke && closed && blank) else { return Ok(value) };
        if !group && (matches!(self.sign(3), Some('^' | '.')) || above >= below) {
            return Ok(value);
        }
        let Some(part) = below.reciprocal().map(|share| &above * &share) else { return Ok(value) };
        // In brackets two numbers may be the components of a column.
        let place = self.place();
        let in_brackets = !group && matches!(self.open.last(), Some('(' | '[')) && self.vocabulary.vectors;
        if in_brackets && self.choices.otherwise(Doubt::Column, place) {
            return Ok(value);
        }
        let mixed = Expr::Number(whole + &part);
        self.at += if group { 5 } else { 3 };
        let typed = self.typed(start);
        self.choices.note(|| format!("{typed} read as {}", crate::expr::print::unicode(&mixed)));
        Ok(mixed)
    }

    /// What stands under a root: brackets, digits alone, or letters.
    fn root(&mut self, cube: bool) -> Parsed {
        let start = self.at;
        let place = self.place();
        let bare = !matches!(self.sign(0), Some('(' | '[' | '{' | OPEN | '|'));
        let mut under = match self.token(0) {
            // `√39 4/9` is hardly the root of a mixed number; `√7¼` may be.
            Some(Token::Number(value)) => {
                let value = value.clone();
                let before_fraction = self.is_fraction(1) || self.sign(1) == Some(OPEN);
                match before_fraction && self.choices.otherwise(Doubt::Root, place) {
                    true => self.number(value)?,
                    false => {
                        self.at += 1;
                        value
                    }
                }
            }
            _ => self.operand()?,
        };
        if bare && matches!(under, Expr::Name(_)) {
            under = self.raised(under, start)?;
            let letters = |parser: &Self| {
                !parser.spaced(0) && matches!(parser.token(0), Some(Token::Letter(_)) | Some(Token::Word(_)))
            };
            if letters(self) && self.choices.otherwise(Doubt::Root, place) {
                let mut factors = vec![under];
                while letters(self) && self.continues() {
                    factors.push(self.factor()?);
                }
                under = Expr::Product(factors);
                let typed = self.typed(start.saturating_sub(1));
                let read = Expr::call(Function::Sqrt, under.clone());
                self.choices.note(|| format!("{typed} read as {}", crate::expr::print::unicode(&read)));
            }
        }
        Ok(match cube {
            true => cube_root(under),
            false => Expr::call(Function::Sqrt, under),
        })
    }

    /// `√(-2² + 3²)`, `√(3² + -2²)`: first under a root nobody takes a square off, nor behind a plus, and the sign may be meant
    /// to be squared.
    pub(super) fn is_sign_squared(&mut self) -> bool {
        let minus = self.at - 1;
        let opened = self.opened_before(minus);
        let is_root = |at: usize| matches!(self.tokens[at].token, Token::Root { cube: false });
        let is_added = minus > 0 && self.tokens[minus - 1].is('+');
        let is_under_root = opened.is_some_and(|open| open > 0 && is_root(open - 1) && (open + 1 == minus || is_added));
        let two = 2 + usize::from(self.sign(2) == Some(OPEN));
        let is_square = matches!(self.token(0), Some(Token::Number(_)))
            && self.sign(1) == Some('^')
            && self.token(two) == Some(&Token::Number(Expr::integer(2)));
        let place = self.place();
        let is_squared = is_under_root && is_square && self.choices.otherwise(Doubt::SquaredSign, place);
        if is_squared {
            self.choices.note(|| "the sign before a square read as squared".to_owned());
        }
        is_squared
    }

    /// Where the bracket opens in which a token stands.
    fn opened_before(&self, at: usize) -> Option<usize> {
        let mut depth = 0_usize;
        (0..at).rev().find(|before| match self.tokens[*before].token {
            Token::Sign(')' | CLOSE) => {
                depth += 1;
                false
            }
            Token::Sign('(' | OPEN) if depth == 0 => true,
            Token::Sign('(' | OPEN) => {
                depth -= 1;
                false
            }
            _ => false,
        })
    }

    fn bars(&mut self) -> Parsed {
        self.open.push('|');
        let inner = self.sum()?;
        self.open.pop();
        if !self.eat('|') {
            return self.fault("`|` is never closed");
        }
        Ok(Expr::call(Function::Abs, inner))
    }

    /// Brackets around a formula, or around the two components of a vector.
    pub(super) fn brackets(&mut self, open: char) -> Parsed {
        self.open.push(open);
        let first = self.sum()?;
        let second = match self.sign(0) {
            Some(sign @ (',' | ';')) => {
                self.at += 1;
                self.coordinates |= sign == ',';
                self.column |= sign == ';';
                Some(self.sum()?)
            }
            Some('-') => Some(self.column_component()?),
            // `3u 7-3e over 5` has no brackets of its own, and a question without vectors no columns.
            None if matches!(self.token(0), Some(Token::Number(_)))
                && self.spaced(0)
                && open != OPEN
                && self.vocabulary.vectors =>
            {
                Some(self.column_component()?)
            }
            _ => None,
        };
        self.open.pop();
        if second.is_some() && matches!(self.sign(0), Some(',' | ';')) {
            return self.fault("a third component");
        }
        let (close, shown) = match open {
            '(' => (')', "(".to_owned()),
            '[' => (']', "[".to_owned()),
            '{' => ('}', "{".to_owned()),
            _ => (CLOSE, "a group".to_owned()),
        };
        if !self.eat(close) {
            return match self.token(0) {
                None => self.fault(format!("`{shown}` is never closed")),
                Some(_) => self.unexpected(),
            };
        }
        if second.is_some() && self.transposed() {
            (self.coordinates, self.column) = (false, true);
        }
        Ok(match second {
            Some(second) => Expr::Vector(Box::new(first), Box::new(second)),
            None => first,
        })
    }

    /// `(4, 1)^T`: a row for a column, which it passes over.
    fn transposed(&mut self) -> bool {
        let is_t = |token: Option<&Token>| matches!(token, Some(Token::Word(word)) if word == "T");
        let length = match (self.sign(0), self.sign(1)) {
            (Some('^'), Some(OPEN)) if is_t(self.token(2)) && self.sign(3) == Some(CLOSE) => 4,
            (Some('^'), None) if is_t(self.token(1)) => 2,
            _ => 0,
        };
        self.at += length;
        length > 0
    }

    fn column_component(&mut self) -> Parsed {
        self.column = true;
        self.sum()
    }
}

/// The number of which a fraction is the cube, or the root as it stands.
fn cube_root(under: Expr) -> Expr {
    let exact = match &under {
        Expr::Number(number) => whole_cube_root(number.numerator()).zip(whole_cube_root(number.denominator())),
        _ => None,
    };
    match exact.and_then(|(above, below)| Fraction::from_integers(above, below)) {
        Some(root) => Expr::Number(root),
        None => Expr::Power(Box::new(under), Box::new(Expr::Number(Fraction::new(1, 3)))),
    }
}

fn whole_cube_root(number: IBig) -> Option<IBig> {
    let (sign, size) = number.into_parts();
    let root = size.nth_root(3);
    (root.pow(3) == size).then(|| IBig::from_parts(sign, root))
}

/// How many bytes a token's name takes, as typed in full.
fn token_length(token: &Token) -> usize {
    match token {
        Token::Word(word) => word.len(),
        _ => 0,
    }
}

fn piece_length(token: &Token) -> usize {
    match token {
        Token::Letter(name) => name.replace('_', "").len(),
        Token::Function(function) | Token::Reciprocal(function) => function.name().len(),
        Token::Root { .. } => 4,
        Token::Pi => 2,
        _ => 1,
    }
}
