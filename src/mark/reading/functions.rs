//! Functions: their powers, and how far an argument without brackets reaches.

use super::characters::OPEN;
use super::choices::Doubt;
use super::grammar::{Parsed, Parser, negative};
use super::tokens::Token;
use crate::expr::{Expr, Function, bare_in_degrees, print};
use crate::number::Range;

impl Parser<'_> {
    /// What follows a function's name: perhaps a power, then its argument.
    pub(super) fn call(&mut self, function: Function) -> Parsed {
        let start = self.at - 1;
        let (function, power) = self.power_of_a_function(function)?;
        let inverse = matches!(function, Function::Asin | Function::Acos | Function::Atan);
        if matches!(self.token(0), Some(Token::Word(word)) if word == "of") {
            self.at += 1;
        }
        let bracket = matches!(self.sign(0), Some('(' | '[' | '{' | '|')) || self.group_is_all();
        let mut squared = None;
        let argument = if bracket || function == Function::Abs {
            let group = self.group_is_all();
            let argument = self.nested(Self::operand)?;
            // `sin ½x`
            match self.close_angle().filter(|_| group) {
                Some(angle) => Expr::Product(vec![argument, angle]),
                None => argument,
            }
        } else if inverse {
            self.whole_argument(function, start)?
        } else {
            let argument = self.short_argument(start)?;
            // `sin x^2`: the square of the sine, unless meant otherwise.
            if self.sign(0) == Some('^') && power.is_none() {
                let place = self.place();
                let before = self.at;
                if self.choices.otherwise(Doubt::Square, place) {
                    self.raised(argument, before)?
                } else {
                    squared = Some(before);
                    argument
                }
            } else {
                argument
            }
        };
        let argument = match function {
            Function::Sin | Function::Cos | Function::Tan => bare_in_degrees(argument),
            _ => argument,
        };
        let call = Expr::call(function, argument);
        let value = match (power, squared) {
            (Some(power), _) => Expr::Power(Box::new(call), Box::new(power)),
            (None, Some(before)) => self.raised(call, before)?,
            (None, None) => return Ok(call),
        };
        if squared.is_some() {
            let typed = self.typed(start);
            self.choices.note(|| format!("{typed} read as {}", print::unicode(&value)));
        }
        Ok(value)
    }

    /// `sin²`, `tan^-1`, `tan⁻¹`, and `tan-1(`, which is the inverse too.
    fn power_of_a_function(&mut self, function: Function) -> Result<(Function, Option<Expr>), super::Unreadable> {
        let inverse = match function {
            Function::Sin => Function::Asin,
            Function::Cos => Function::Acos,
            Function::Tan => Function::Atan,
            other => return Ok((other, None)),
        };
        let one = |token: Option<&Token>| token == Some(&Token::Number(Expr::integer(1)));
        let closely = self.sign(0) == Some('-') && one(self.token(1)) && !self.spaced(0) && !self.spaced(1);
        if closely && (self.sign(2) == Some('(') || self.sign(2) == Some(OPEN) || self.spaced(2)) {
            self.at += 2;
            let is_reciprocal = matches!(self.tokens[self.at - 3].token, Token::Reciprocal(_));
            self.choices.note(|| match is_reciprocal {
                true => format!("{0}-1 read as arc{0}", one_over(function)),
                false => format!("{}-1 read as {}", function.name(), arc(inverse)),
            });
            return Ok((inverse, None));
        }
        if !self.eat('^') {
            return Ok((function, None));
        }
        let minus = self.eat('-');
        let exponent = match self.token(0) {
            Some(Token::Number(value)) => {
                let value = value.clone();
                self.at += 1;
                value
            }
            Some(Token::Sign('(' | '{' | OPEN)) => self.nested(Self::operand)?,
            _ => return self.unexpected(),
        };
        let exponent = if minus { negative(exponent) } else { exponent };
        if exponent == negative(Expr::integer(1)) {
            return Ok((inverse, None));
        }
        match &exponent {
            Expr::Number(power)
                if power.as_small().is_some_and(|(power, one)| (1..=16).contains(&power) && one == 1) =>
            {
                Ok((function, Some(exponent)))
            }
            _ => self.fault("such a power of a function is not read"),
        }
    }

    /// A group that is no fraction is a pair of brackets.
    fn group_is_all(&self) -> bool {
        self.sign(0) == Some(OPEN)
    }

    /// `arctan 3√3/5`: all that follows up to a plus or minus sign, unless meant otherwise.
    fn whole_argument(&mut self, function: Function, start: usize) -> Parsed {
        let (place, group) = (self.place(), self.sign(0) == Some(OPEN));
        if self.choices.is_flipped(Doubt::Argument, place) {
            return self.signed_factor();
        }
        let all = self.nested(Self::term)?;
        if matches!(all, Expr::Product(_) | Expr::Quotient(..)) && !group {
            self.choices.otherwise(Doubt::Argument, place);
            let typed = self.typed(start);
            let read = Expr::call(function, all.clone());
            self.choices.note(|| format!("{typed} read as {}", print::unicode(&read)));
        }
        Ok(all)
    }

    /// `sin 2x`, `cos 30`, `sin αv`: a number and an angle, and below a stroke a number if meant otherwise.
    fn short_argument(&mut self, start: usize) -> Parsed {
        let minus = self.eat('-');
        let mut factors = Vec::new();
        let mut complete = false;
        loop {
            self.choices.step(self.place())?;
            match self.token(0) {
                // `sin 1/2x`
                Some(Token::Number(above)) if factors.is_empty() && self.is_fraction_of_an_angle() => {
                    let above = above.clone();
                    self.at += 2;
                    if let Some(Token::Number(below)) = self.token(0).cloned() {
                        factors.push(Expr::Quotient(Box::new(above), Box::new(below)));
                        self.at += 1;
                    }
                }
                Some(Token::Number(value)) if factors.is_empty() => {
                    factors.push(value.clone());
                    self.at += 1;
                }
                Some(Token::Root { .. }) if factors.is_empty() => factors.push(self.nested(Self::operand)?),
                Some(Token::Word(_) | Token::Greek(_)) => {
                    let fits = factors.is_empty() || self.angle_follows();
                    if !fits || complete || !self.take_apart(self.at) {
                        break;
                    }
                }
                Some(Token::Pi) => {
                    factors.push(Expr::Pi);
                    self.at += 1;
                    complete = true;
                }
                Some(Token::Letter(name)) if factors.is_empty() || (!complete && self.is_angle(name)) => {
                    let name = name.clone();
                    complete = self.is_angle(&name);
                    factors.push(Expr::name(name));
                    self.at += 1;
                }
                _ => break,
            }
            if factors.len() > 8 {
                return self.fault("an argument of so many factors needs brackets");
            }
        }
        if factors.is_empty() {
            return self.unexpected();
        }
        let pi = factors.contains(&Expr::Pi);
        let mut argument = if factors.len() == 1 { factors.remove(0) } else { Expr::Product(factors) };
        while self.eat('°') {
            argument = self.in_degrees(argument);
        }
        if self.sign(0) == Some('/') && !self.spaced(0) && matches!(self.token(1), Some(Token::Number(_))) {
            let place = self.place();
            // `sin π/6` can only mean one thing.
            let below = pi || self.choices.otherwise(Doubt::Argument, place);
            if below && let Some(Token::Number(number)) = self.token(1).cloned() {
                self.at += 2;
                argument = Expr::Quotient(Box::new(argument), Box::new(number));
            }
            if !pi {
                let typed = self.text.get(self.tokens[start].start..self.end_of_stroke(below)).unwrap_or_default();
                let read = if below { "with the quotient inside" } else { "with the quotient outside" };
                self.choices.note(|| format!("{} read {read}", typed.trim()));
            }
        }
        Ok(if minus { negative(argument) } else { argument })
    }

    /// A letter for an angle close behind what was read.
    fn close_angle(&mut self) -> Option<Expr> {
        if self.spaced(0) || !self.angle_follows() {
            return None;
        }
        let Some(Token::Letter(name)) = self.token(0).cloned() else { return None };
        self.at += 1;
        Some(Expr::name(name))
    }

    /// `1/2x`, all of it close together, with an x that may be an angle.
    fn is_fraction_of_an_angle(&self) -> bool {
        let is_number = |ahead: usize| matches!(self.token(ahead), Some(Token::Number(_)));
        let name = match self.token(3) {
            Some(Token::Word(name) | Token::Letter(name)) => name.as_str(),
            Some(Token::Greek(name)) => name,
            _ => return false,
        };
        let is_letter = self.vocabulary.letters.iter().any(|letter| letter.name() == name);
        is_letter
            && self.is_angle(name)
            && self.sign(1) == Some('/')
            && is_number(2)
            && (1..=3).all(|ahead| !self.spaced(ahead))
    }

    /// Where `sin x/2` ends in the text.
    fn end_of_stroke(&self, passed: bool) -> usize {
        let last = if passed { self.at - 1 } else { self.at + 1 };
        self.tokens.get(last).map_or(self.text.len(), |placed| placed.end)
    }

    /// Is the next word an angle of the question, that can be part of the argument?
    fn angle_follows(&mut self) -> bool {
        let at = self.at;
        let word = matches!(self.token(0), Some(Token::Word(_) | Token::Greek(_)));
        let unit = self.outside() && self.unit_here().is_some();
        if word && !unit && !self.take_apart(at) {
            return false;
        }
        matches!(self.token(0), Some(Token::Letter(name)) if self.is_angle(name))
            || matches!(self.token(0), Some(Token::Pi))
    }

    /// May it be an angle? Masses, speeds and coefficients of restitution are none.
    pub(super) fn is_angle(&self, name: &str) -> bool {
        let letter = self.vocabulary.letters.iter().find(|letter| letter.name() == name);
        letter.is_none_or(|letter| !matches!(letter.range(), Range::Positive | Range::Unit))
    }
}

/// The name of one over a function.
fn one_over(function: Function) -> &'static str {
    match function {
        Function::Sin => "cosec",
        Function::Cos => "sec",
        _ => "cot",
    }
}

fn arc(inverse: Function) -> &'static str {
    match inverse {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        _ => "arctan",
    }
}
