//! A formula by itself: what it is, and its unit.

use super::choices::Choices;
use super::grammar::Parser;
use super::tokens::{Placed, Token};
use super::vectors::{Shape, shape};
use super::{Form, Notation, SaidUnit, Unreadable, Vocabulary};
use crate::expr::Expr;

/// A formula that has been read.
pub(super) struct Formula {
    /// What it is.
    pub form: Form,
    /// Its unit.
    pub unit: Option<SaidUnit>,
    /// The tokens, with words taken apart.
    pub tokens: Vec<Placed>,
    /// The token after it.
    pub next: usize,
}

/// The formula that begins at a token, with its unit.
pub(super) fn formula(
    tokens: Vec<Placed>,
    at: usize,
    text: &str,
    vocabulary: &Vocabulary,
    choices: &mut Choices,
) -> Result<Formula, Unreadable> {
    let place = tokens.get(at).map_or(text.len(), |placed| placed.start);
    if tokens.get(at).is_some_and(|placed| placed.is('°')) {
        return Err(Unreadable::Sign(place, "a number of degrees is missing".to_owned()));
    }
    let mut parser = Parser::new(tokens, text, vocabulary, choices);
    parser.at = at;
    let expr = parser.sum()?;
    let mut unit = None;
    let mut percent = false;
    if parser.eat('%') {
        percent = true;
    } else if let Some((found, next)) = parser.unit_here() {
        unit = Some(found);
        parser.at = next;
    }
    parser.eat('…');
    // `3.61 m/s 56.3°`: a size and an angle.
    let angle = matches!(parser.token(0), Some(Token::Number(_))) && parser.sign(1) == Some('°');
    if !angle && let Some(Token::Word(_) | Token::Greek(_) | Token::Number(_)) = parser.token(0) {
        return parser.unexpected();
    }
    if let Some(sign @ (')' | ']' | '}' | '⟧' | '^' | '%' | '°' | '…' | '|')) = parser.sign(0) {
        return parser.fault(format!("`{}` where nothing can follow", if sign == '⟧' { '}' } else { sign }));
    }
    let next = parser.at;
    let (coordinates, column) = (parser.coordinates, parser.column);
    let end = next.checked_sub(1).and_then(|last| parser.tokens.get(last)).map_or(place, |last| last.end);
    let tokens = parser.tokens;
    let form = match shape(&expr).map_err(|message| Unreadable::Sign(place, message.to_owned()))? {
        Shape::Mixed => Form::Mixed(expr),
        Shape::Vector(x, y) if column => Form::Vector(x, y, Notation::Column),
        Shape::Vector(x, y) if coordinates => Form::Vector(x, y, Notation::Coordinates),
        Shape::Vector(x, y) => Form::Vector(x, y, Notation::UnitVectors),
        Shape::Scalar(value) if percent => Form::Percentage(value),
        Shape::Scalar(value) => match without_degrees(&value) {
            Some(bare) if unit.is_none() => {
                let sign = text.get(..end).and_then(|text| text.char_indices().next_back()).map_or(0, |(at, _)| at);
                let typed = text.get(sign..end).unwrap_or_default().to_owned();
                unit = Some(SaidUnit { typed, dimension: [0, 0, 0, 1], scale: Expr::integer(1), degrees: true });
                Form::Value(bare)
            }
            _ => Form::Value(value),
        },
    };
    if percent && !matches!(form, Form::Percentage(_)) {
        return Err(Unreadable::Sign(place, "a vector in per cent".to_owned()));
    }
    Ok(Formula { form, unit, tokens, next })
}

/// The number of degrees, if degrees are what the last sign of a formula says.
fn without_degrees(expr: &Expr) -> Option<Expr> {
    match expr {
        Expr::Degrees(inner) => Some((**inner).clone()),
        Expr::Negative(inner) => without_degrees(inner).map(|inner| Expr::Negative(Box::new(inner))),
        Expr::Quotient(above, below) => {
            Some(Expr::Quotient(above.clone(), Box::new(without_degrees(below).filter(|below| !below.is_one())?)))
        }
        Expr::Product(factors) => {
            let (last, rest) = factors.split_last()?;
            let last = without_degrees(last)?;
            Some(Expr::Product(rest.iter().cloned().chain([last]).collect()))
        }
        Expr::Sum(terms) => terms.iter().map(without_degrees).collect::<Option<Vec<Expr>>>().map(Expr::Sum),
        _ => None,
    }
}
