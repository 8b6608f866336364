//! What follows the name of a function: a power, brackets or a bare argument, and degrees.

use super::lexer::Token;
use super::parser::{Angles, Parser, Part};
use crate::expr::{Expr, Fault, Function, Span};

impl Parser<'_> {
    /// What follows a function's name: perhaps a power, then its argument.
    pub(super) fn call(&mut self, function: Function, named: Span) -> Result<Part, Fault> {
        let power = if self.eat(&Token::Power) {
            let negative = self.eat(&Token::Minus);
            let exponent = match self.peek() {
                Some(Token::Open(_)) => self.operand()?,
                _ => self.atom()?,
            };
            Some(if negative { self.node(exponent.expr.negated(), exponent.height)? } else { exponent })
        } else {
            None
        };
        if let Some(brackets) = self.empty_brackets() {
            return Err(without_argument(function, Span { start: named.start, end: brackets.end }));
        }
        let argument = match self.peek() {
            Some(Token::Open(_)) => self.operand()?,
            _ => self.bare_argument(function, named)?,
        };
        let (function, power) = match (inverse(function), power) {
            (Some(inverse), Some(power)) if power.expr == Expr::integer(-1) => (inverse, None),
            (_, power) => (function, power),
        };
        let below = argument.height + 1;
        let argument = match (function, self.angles) {
            (Function::Sin | Function::Cos | Function::Tan, Angles::Degrees) => in_degrees(argument.expr),
            _ => argument.expr,
        };
        let call = self.node(Expr::call(function, argument), below)?;
        match power {
            None => Ok(call),
            Some(power) => {
                let below = power.height.max(call.height);
                self.node(Expr::Power(Box::new(call.expr), Box::new(power.expr)), below)
            }
        }
    }

    /// An argument without brackets: what is written tightly together, as in `sin2x` or `cos alpha`.
    fn bare_argument(&mut self, function: Function, named: Span) -> Result<Part, Fault> {
        if !matches!(self.peek(), Some(Token::Number(_) | Token::Name(_) | Token::Pi | Token::Vulgar(..) | Token::Root))
        {
            return Err(without_argument(function, named));
        }
        let first = match self.peek() {
            Some(Token::Root) => self.operand()?,
            _ => self.atom()?,
        };
        let mut height = first.height;
        let mut factors = vec![first.expr];
        let one_only = matches!(function, Function::Sqrt | Function::Abs);
        while !one_only && self.continues_argument() {
            let next = self.atom()?;
            height = height.max(next.height);
            factors.push(next.expr);
        }
        if let (Some(Token::Power), false) = (self.peek(), one_only) {
            return Err(Fault::new(
                "a power after a function without brackets",
                self.span(),
                "of the argument, or of the whole",
            )
            .try_this(format!("write `{0}(x^2)` or `{0}(x)^2`", function.name())));
        }
        let mut part = match factors.len() {
            1 => Part { expr: factors.remove(0), height },
            _ => self.node(Expr::Product(factors), height)?,
        };
        while !one_only && self.eat(&Token::Degrees) {
            part = self.node(Expr::degrees(part.expr), part.height)?;
        }
        Ok(part)
    }

    /// Does the next token belong to the same bare argument? Space ends it, and so does a unit vector.
    fn continues_argument(&self) -> bool {
        self.tokens.get(self.next).is_some_and(|placed| {
            let fits = match &placed.token {
                Token::Pi => true,
                Token::Name(name) => name != "i" && name != "j",
                _ => false,
            };
            fits && !placed.spaced
        })
    }
}

fn without_argument(function: Function, at: Span) -> Fault {
    let name = function.name();
    Fault::new(format!("`{name}` without its argument"), at, "an argument must follow")
        .try_this(format!("write `{name}(x)`"))
}

/// The argument of a function with the numbers that stand bare in it taken as degrees.
pub(crate) fn in_degrees(argument: Expr) -> Expr {
    match argument {
        Expr::Sum(terms) if !terms.iter().all(is_numeric) => Expr::Sum(terms.into_iter().map(in_degrees).collect()),
        Expr::Negative(inner) if !is_numeric(&inner) => Expr::Negative(Box::new(in_degrees(*inner))),
        other if is_numeric(&other) => Expr::degrees(other),
        other => other,
    }
}

/// Is it made of numbers alone, with no letter and nothing that is an angle already?
fn is_numeric(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => true,
        Expr::Name(_) | Expr::Pi | Expr::Degrees(_) | Expr::Vector(..) | Expr::Relation(..) => false,
        Expr::Call(Function::Asin | Function::Acos | Function::Atan, _) => false,
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, _) => true,
        other => other.children().into_iter().all(is_numeric),
    }
}

fn inverse(function: Function) -> Option<Function> {
    match function {
        Function::Sin => Some(Function::Asin),
        Function::Cos => Some(Function::Acos),
        Function::Tan => Some(Function::Atan),
        _ => None,
    }
}
