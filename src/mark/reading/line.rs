//! Lines by their equation: `y = -3x + 2` has the gradient -3, `x = 2y` one half.

use super::Vocabulary;
use super::choices::Choices;
use super::grammar::Parser;
use super::tokens::{Placed, Token};
use crate::expr::Expr;
use crate::number::{Letter, Range};

/// The gradient of the line with this equation, where x and y are coordinates and no letters of the question.
pub(super) fn gradient(left: &[Placed], right: &[Placed], text: &str, vocabulary: &Vocabulary) -> Option<Expr> {
    let named = |name: &str| vocabulary.letters.iter().any(|letter| letter.name() == name);
    let [Placed { token: Token::Word(across), .. }] = left else { return None };
    let along = match across.as_str() {
        "y" => "x",
        "x" => "y",
        _ => return None,
    };
    if !vocabulary.vectors || named("x") || named("y") {
        return None;
    }
    let mut letters = vocabulary.letters.clone();
    letters.push(Letter::new(along, Range::Real)?);
    let vocabulary = Vocabulary { letters, vectors: false };
    let mut choices = Choices::default();
    let mut parser = Parser::new(right.to_vec(), text, &vocabulary, &mut choices);
    let value = parser.sum().ok().filter(|_| parser.at == parser.end)?;
    let slope = slope(&value, along)?;
    match along {
        "x" => Some(slope),
        _ if slope.is_zero() => None,
        _ => Some(Expr::integer(1).over(slope)),
    }
}

/// What a letter is multiplied by in a formula that is linear in it; `None` if it is not, or the letter is not there.
fn slope(expr: &Expr, letter: &str) -> Option<Expr> {
    let has = |expr: &Expr| expr.names().iter().any(|name| name.text == letter);
    match expr {
        Expr::Name(name) if name.text == letter => Some(Expr::integer(1)),
        Expr::Negative(inner) => Some(slope(inner, letter)?.negated()),
        Expr::Sum(terms) => {
            let with: Vec<Expr> =
                terms.iter().filter(|term| has(term)).map(|term| slope(term, letter)).collect::<Option<_>>()?;
            (!with.is_empty()).then(|| Expr::sum(with))
        }
        Expr::Product(factors) => {
            let (with, without): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|factor| has(factor));
            let [one] = with.as_slice() else { return None };
            Some(Expr::product(without.into_iter().cloned().chain([slope(one, letter)?])))
        }
        Expr::Quotient(above, below) if !has(below) => Some(slope(above, letter)?.over((**below).clone())),
        _ => None,
    }
}
