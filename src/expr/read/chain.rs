//! A chain such as `0 < e < 1`: a formula has one relation at most.

use super::lexer::Token;
use super::parser::{Parser, Part};
use crate::expr::{Expr, Fault, Relation, print};

impl Parser<'_> {
    /// The fault of a second relation, with the two formulas that say the same.
    pub(super) fn second_relation(&mut self, left: Part, relation: Relation, middle: Part) -> Fault {
        let (span, second) = (self.span(), self.peek());
        self.next += 1;
        let of = |left: Expr, relation, right| {
            format!("`{}`", print::plain(&Expr::Relation(Box::new(left), relation, Box::new(right))))
        };
        let help = match (second, self.sum()) {
            (Some(Token::Relation(second)), Ok(last)) => {
                let first = of(left.expr, relation, middle.expr.clone());
                format!("write two formulas instead of a chain: {first} and {}", of(middle.expr, *second, last.expr))
            }
            _ => "write two formulas instead of a chain".to_owned(),
        };
        Fault::new("a second relation", span, "one relation at most").try_this(help)
    }
}
