//! Tokens into a tree, the tightest sign first: `^`, then `*` and `/`, then `+` and `-`, then a relation.
//!
//! A minus sign holds less tightly than a power, as on paper: `-2^2` is -4. Writing side by side
//! holds as `*` does, so `1/2m` is half of m.

use super::lexer::{Placed, Token, tokens};
use super::meant::nothing_in_brackets;
use crate::expr::fault::Fault;
use crate::expr::{Expr, Function, Name, Span};
use crate::number::Fraction;

/// The measure of a bare number under `sin`, `cos` and `tan`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angles {
    /// Radians, as in the exchange format.
    Radians,
    /// Degrees, as in a student's answer and in the words of a question: `6sin10`.
    Degrees,
}

/// Reads an expression or a relation between two.
///
/// In degrees, every number that stands bare in the argument of `sin`, `cos` or `tan` becomes so
/// many degrees; letters, `pi` and the results of inverse functions are angles already.
///
/// ```
/// use carom::expr::{print, read};
/// use carom::expr::Angles;
/// let size = read("6sin10", Angles::Degrees).unwrap();
/// assert_eq!(print::plain(&size), "6*sin(10*deg)");
/// let fault = read("2*(u + ", Angles::Degrees).unwrap_err();
/// assert_eq!(fault.message, "the expression ends too early");
/// ```
pub fn read(text: &str, angles: Angles) -> Result<Expr, Fault> {
    read_with(text, angles, Decimals::Exact)
}

/// As [`read`], but a number with a decimal point keeps the digits with which it was written, for printing.
///
/// ```
/// use carom::expr::{Angles, print, read_as_written};
/// assert_eq!(print::plain(&read_as_written("2.50", Angles::Degrees).unwrap()), "2.50");
/// ```
pub fn read_as_written(text: &str, angles: Angles) -> Result<Expr, Fault> {
    read_with(text, angles, Decimals::AsWritten)
}

/// What becomes of a number with a decimal point.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Decimals {
    /// The number that it is.
    Exact,
    /// The digits as they were written, for printing.
    AsWritten,
}

pub(super) fn read_with(text: &str, angles: Angles, decimals: Decimals) -> Result<Expr, Fault> {
    let tokens = tokens(text)?;
    let mut parser = Parser { tokens: &tokens, next: 0, end: text.trim_end().len(), depth: 0, angles, decimals };
    let whole = parser.relation()?;
    match parser.peek() {
        None => Ok(whole.expr),
        Some(_) => Err(parser.unexpected()),
    }
}

/// What can be done about a formula that is too long or too deep.
pub(super) const TAKE_APART: &str = "take it apart: give parts of it names of their own";

/// Deeper nesting than any formula has, and far less than would exhaust the stack.
const DEEPEST: usize = 100;

/// A walk over the tokens of a text.
pub(super) struct Parser<'a> {
    pub(super) tokens: &'a [Placed],
    pub(super) next: usize,
    end: usize,
    depth: usize,
    pub(super) angles: Angles,
    decimals: Decimals,
}

/// A tree under construction, and the number of nodes from its root to its deepest leaf.
pub(super) struct Part {
    pub(super) expr: Expr,
    pub(super) height: usize,
}

impl Part {
    fn leaf(expr: Expr) -> Part {
        Part { expr, height: 1 }
    }
}

impl<'a> Parser<'a> {
    pub(super) fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.next).map(|placed| &placed.token)
    }

    pub(super) fn span(&self) -> Span {
        self.tokens.get(self.next).map_or(Span { start: self.end, end: self.end }, |placed| placed.span)
    }

    pub(super) fn eat(&mut self, token: &Token) -> bool {
        let found = self.peek() == Some(token);
        self.next += usize::from(found);
        found
    }

    /// Keeps a node unless it lies too deep.
    pub(super) fn node(&self, expr: Expr, below: usize) -> Result<Part, Fault> {
        if below >= DEEPEST {
            return Err(self.too_deep());
        }
        Ok(Part { expr, height: below + 1 })
    }

    fn too_deep(&self) -> Fault {
        let span = self.tokens.get(self.next.saturating_sub(1)).map_or(self.span(), |placed| placed.span);
        Fault::new("the expression is nested too deeply", span, format!("more than {DEEPEST} levels here"))
            .try_this(TAKE_APART)
    }

    /// Runs a rule one level further down.
    fn nested(&mut self, rule: impl FnOnce(&mut Self) -> Result<Part, Fault>) -> Result<Part, Fault> {
        if self.depth >= DEEPEST {
            return Err(self.too_deep());
        }
        self.depth += 1;
        let part = rule(self);
        self.depth -= 1;
        part
    }

    fn relation(&mut self) -> Result<Part, Fault> {
        let left = self.sum()?;
        let Some(Token::Relation(relation)) = self.peek() else { return Ok(left) };
        self.next += 1;
        let right = self.sum()?;
        if let Some(Token::Relation(_)) = self.peek() {
            return Err(self.second_relation(left, *relation, right));
        }
        let below = left.height.max(right.height);
        self.node(Expr::Relation(Box::new(left.expr), *relation, Box::new(right.expr)), below)
    }

    pub(super) fn sum(&mut self) -> Result<Part, Fault> {
        let mut terms = Vec::new();
        let mut height = 0;
        // A plus sign in front says nothing.
        self.eat(&Token::Plus);
        loop {
            let term = self.term()?;
            height = height.max(term.height);
            terms.push(term.expr);
            if self.eat(&Token::Plus) {
                continue;
            }
            if self.peek() != Some(&Token::Minus) {
                break;
            }
        }
        if terms.len() == 1 {
            return Ok(Part { expr: terms.remove(0), height });
        }
        self.node(Expr::Sum(terms), height)
    }

    /// A product, with the minus signs before it.
    fn term(&mut self) -> Result<Part, Fault> {
        if self.eat(&Token::Minus) {
            let inner = self.nested(Self::term)?;
            return self.node(Expr::Negative(Box::new(inner.expr)), inner.height);
        }
        self.product()
    }

    fn product(&mut self) -> Result<Part, Fault> {
        let mut left = self.factor()?;
        // Only a product of this loop takes a further factor: brackets around one are kept.
        let mut open = false;
        loop {
            if self.eat(&Token::Over) {
                let right = self.signed_factor()?;
                let below = left.height.max(right.height);
                left = self.node(Expr::Quotient(Box::new(left.expr), Box::new(right.expr)), below)?;
                open = false;
                continue;
            }
            let right = if self.eat(&Token::Times) {
                let raised = self.tokens.get(self.next + 1).is_some_and(|placed| placed.token == Token::Power);
                if !raised && self.eat(&Token::Degrees) {
                    left = self.measured(left, open)?;
                    continue;
                }
                self.signed_factor()?
            } else if self.continues_product()? {
                self.factor()?
            } else {
                return Ok(left);
            };
            left = match left.expr {
                Expr::Product(mut factors) if open => {
                    factors.push(right.expr);
                    // A product's height counts its own node already.
                    self.node(Expr::Product(factors), (left.height - 1).max(right.height))?
                }
                other => self.node(Expr::Product(vec![other, right.expr]), left.height.max(right.height))?,
            };
            open = true;
        }
    }

    /// `x*deg`: the last factor of an open product, or the whole of anything else, in degrees.
    fn measured(&self, left: Part, open: bool) -> Result<Part, Fault> {
        match left.expr {
            Expr::Product(mut factors) if open => {
                if let Some(last) = factors.pop() {
                    factors.push(Expr::degrees(last));
                }
                self.node(Expr::Product(factors), left.height)
            }
            other => self.node(Expr::degrees(other), left.height),
        }
    }

    /// After `*` and `/` a minus sign may stand without brackets.
    fn signed_factor(&mut self) -> Result<Part, Fault> {
        if self.eat(&Token::Minus) {
            let inner = self.nested(Self::signed_factor)?;
            return self.node(Expr::Negative(Box::new(inner.expr)), inner.height);
        }
        self.factor()
    }

    /// An operand with its power, in degrees if their sign follows.
    fn factor(&mut self) -> Result<Part, Fault> {
        let mut part = self.power()?;
        while self.eat(&Token::Degrees) {
            part = self.node(Expr::degrees(part.expr), part.height)?;
        }
        Ok(part)
    }

    fn power(&mut self) -> Result<Part, Fault> {
        let base = self.operand()?;
        if !self.eat(&Token::Power) {
            return Ok(base);
        }
        let exponent = self.nested(Self::exponent)?;
        let below = base.height.max(exponent.height);
        self.node(Expr::Power(Box::new(base.expr), Box::new(exponent.expr)), below)
    }

    /// Powers of powers are taken from the right: `2^3^2` is `2^9`.
    fn exponent(&mut self) -> Result<Part, Fault> {
        if self.eat(&Token::Minus) {
            let inner = self.nested(Self::exponent)?;
            return self.node(Expr::Negative(Box::new(inner.expr)), inner.height);
        }
        self.power()
    }

    /// Does a factor follow that is written side by side with the one before? A number does not do so.
    fn continues_product(&self) -> Result<bool, Fault> {
        match self.peek() {
            Some(Token::Number(_) | Token::Vulgar(..)) => {
                Err(Fault::new("a number without a sign before it", self.span(), "expected `+`, `-`, `*` or `/`")
                    .try_this("write `*` before it if it is a factor, and `^` if it is a power"))
            }
            Some(Token::Name(_) | Token::Function(_) | Token::Pi | Token::Degrees | Token::Root | Token::Open(_)) => {
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    pub(super) fn operand(&mut self) -> Result<Part, Fault> {
        let span = self.span();
        let Some(token) = self.peek() else { return Err(self.unexpected()) };
        match token {
            Token::Open(open) => self.nested(|parser| parser.brackets(*open)),
            Token::Root => {
                self.next += 1;
                let inner = self.nested(Self::operand)?;
                self.node(Expr::call(Function::Sqrt, inner.expr), inner.height)
            }
            Token::Function(function) => {
                self.next += 1;
                self.nested(|parser| parser.call(*function, span))
            }
            _ => self.atom(),
        }
    }

    /// A number, name or constant.
    pub(super) fn atom(&mut self) -> Result<Part, Fault> {
        let span = self.span();
        let expr = match self.peek() {
            Some(Token::Number(digits)) if digits.contains('.') && self.decimals == Decimals::AsWritten => {
                Expr::Decimal(digits.clone())
            }
            Some(Token::Number(digits)) => match digits.parse::<Fraction>() {
                Ok(whole) => match self.tokens.get(self.next + 1) {
                    // Two and a half, written `2½`.
                    Some(Placed { token: Token::Vulgar(numerator, denominator), spaced: false, .. }) => {
                        self.next += 1;
                        Expr::Number(whole + Fraction::new(*numerator, *denominator))
                    }
                    _ => Expr::Number(whole),
                },
                Err(_) => {
                    let fault = Fault::new(format!("`{digits}` is no number"), span, "not a number");
                    return Err(fault.try_this("write it as `2.5` or `5/2`"));
                }
            },
            Some(Token::Vulgar(numerator, denominator)) => Expr::Number(Fraction::new(*numerator, *denominator)),
            Some(Token::Name(text)) => Expr::Name(Name { text: text.clone(), span }),
            Some(Token::Pi) => Expr::Pi,
            Some(Token::Degrees) => Expr::degrees(Expr::integer(1)),
            _ => return Err(self.unexpected()),
        };
        self.next += 1;
        Ok(Part::leaf(expr))
    }

    /// Brackets around one expression, or around the two components of a vector.
    fn brackets(&mut self, open: char) -> Result<Part, Fault> {
        let opened = self.span();
        if let Some(span) = self.empty_brackets() {
            return Err(nothing_in_brackets(span));
        }
        self.next += 1;
        let first = self.sum()?;
        let part = if self.eat(&Token::Comma) {
            let second = self.sum()?;
            let below = first.height.max(second.height);
            self.node(Expr::Vector(Box::new(first.expr), Box::new(second.expr)), below)?
        } else {
            first
        };
        let close = if open == '(' { ')' } else { ']' };
        match self.peek() {
            Some(Token::Close(found)) if *found == close => {
                self.next += 1;
                Ok(part)
            }
            None => {
                let fault =
                    Fault::new(format!("`{open}` is never closed"), opened, format!("its `{close}` is missing"));
                Err(fault.try_this(format!("write `{close}` where the brackets end")))
            }
            Some(Token::Comma) => {
                Err(Fault::new("a third component", self.span(), "a vector has two components, along i and j")
                    .try_this("write a vector as `[2, 3]` or `2i + 3j`"))
            }
            Some(Token::Relation(_)) => Err(Fault::new("a relation in brackets", self.span(), "only outside brackets")
                .try_this("take the brackets around it away")),
            Some(Token::Close(found)) => {
                let fault =
                    Fault::new(format!("`{found}` closes `{open}`"), self.span(), format!("expected `{close}`"));
                Err(fault.try_this(format!("write `{close}` in its place")))
            }
            Some(_) => Err(self.unexpected()),
        }
    }

    /// The fault of a token that cannot stand where it does.
    fn unexpected(&self) -> Fault {
        let span = self.span();
        let operand =
            |message: &str, help: &str| Fault::new(message, span, "expected a number, letter or `(`").try_this(help);
        match self.peek() {
            None if self.tokens.is_empty() => operand("an empty expression", "write what belongs here, or take it out"),
            None => operand("the expression ends too early", "finish it, or take the sign at its end out"),
            Some(Token::Close(close)) => {
                let open = if *close == ')' { '(' } else { '[' };
                Fault::new(format!("unexpected `{close}`"), span, "nothing to close here")
                    .try_this(format!("take it out, or write `{open}` where the brackets begin"))
            }
            Some(Token::Comma) => self.decimal_comma().unwrap_or_else(|| {
                Fault::new("unexpected `,`", span, "a vector needs brackets")
                    .try_this("write a vector as `[2, 3]` or `2i + 3j`")
            }),
            Some(Token::Relation(second)) => self.two_relations(*second).unwrap_or_else(|| {
                operand("a relation without its left side", "write what is compared on both sides: `u > 2`")
            }),
            Some(_) => {
                operand("a sign without its operand", "take one of the signs out, or write what stands between them")
            }
        }
    }
}
