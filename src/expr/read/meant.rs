//! What is meant by signs that cannot stand where they do, where it is plain: a decimal comma, `<>` for `!=`.

use super::lexer::Token;
use super::parser::Parser;
use crate::expr::fault::Fault;
use crate::expr::{Relation, Span};

impl Parser<'_> {
    /// A comma between digits, as many write a decimal number.
    pub(super) fn decimal_comma(&self) -> Option<Fault> {
        let [before, comma, after] = self.tokens.get(self.next.checked_sub(1)?..self.next + 2)? else { return None };
        let (Token::Number(whole), Token::Number(decimals)) = (&before.token, &after.token) else { return None };
        if comma.spaced || after.spaced || whole.contains('.') || decimals.contains('.') {
            return None;
        }
        let span = Span { start: before.span.start, end: after.span.end };
        let fault = Fault::new("a decimal comma", span, "a decimal number has a point here");
        Some(fault.try_this(format!("write `{whole}.{decimals}`")))
    }

    /// Where brackets stand with nothing between them, if they do here.
    pub(super) fn empty_brackets(&self) -> Option<Span> {
        let [open, close] = self.tokens.get(self.next..self.next + 2)? else { return None };
        let are_brackets = matches!((&open.token, &close.token), (Token::Open(_), Token::Close(_)));
        are_brackets.then_some(Span { start: open.span.start, end: close.span.end })
    }

    /// Two relations of which one is meant: `<>`, `=<`, `=>`.
    pub(super) fn two_relations(&self, second: Relation) -> Option<Fault> {
        let before = self.tokens.get(self.next.checked_sub(1)?)?;
        let Token::Relation(first) = before.token else { return None };
        let span = Span { start: before.span.start, end: self.span().end };
        let fault = Fault::new("two relations in a row", span, "expected one");
        let meant = match (first, second) {
            (Relation::Less, Relation::Greater) | (Relation::Greater, Relation::Less) => "!=",
            (Relation::Equal, Relation::Less) => "<=",
            (Relation::Equal, Relation::Greater) => ">=",
            (Relation::Equal, Relation::Equal) => "=",
            (Relation::NotEqual, Relation::Equal) => "!=",
            _ => return Some(fault.try_this("keep one of the two")),
        };
        Some(fault.try_this(format!("write `{meant}`")))
    }
}

/// The fault of brackets with nothing between them.
pub(super) fn nothing_in_brackets(span: Span) -> Fault {
    Fault::new("nothing in the brackets", span, "expected a number or letter in them")
        .try_this("write what belongs between them, or take them out")
}
