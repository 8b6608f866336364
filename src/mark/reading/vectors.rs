//! Formulas in i and j: told apart into components, or found to be no vector at all.

use super::tokens::{Placed, Token};
use super::{Form, Notation, Vocabulary};
use crate::expr::{Expr, Function};
use crate::number::Fraction;

/// What a formula is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    /// A number or a formula in letters.
    Scalar(Expr),
    /// A vector by its components.
    Vector(Expr, Expr),
    /// A number plus a vector.
    Mixed,
}

/// What a formula is, or why it makes no sense.
pub(super) fn shape(expr: &Expr) -> Result<Shape, &'static str> {
    use Shape::{Mixed, Scalar, Vector};
    Ok(match expr {
        Expr::Name(name) if name.text == "i" => Vector(Expr::integer(1), Expr::integer(0)),
        Expr::Name(name) if name.text == "j" => Vector(Expr::integer(0), Expr::integer(1)),
        Expr::Number(_) | Expr::Decimal(_) | Expr::Name(_) | Expr::Pi => Scalar(expr.clone()),
        Expr::Vector(x, y) => match (shape(x)?, shape(y)?) {
            (Scalar(x), Scalar(y)) => Vector(x, y),
            // `(4i, -3j)`
            (Vector(x, below), Vector(left, y)) if below.is_zero() && left.is_zero() => Vector(x, y),
            _ => return Err("a vector as the component of a vector"),
        },
        Expr::Negative(inner) => match shape(inner)? {
            Scalar(value) => Scalar(Expr::Negative(Box::new(value))),
            Vector(x, y) => Vector(x.negated(), y.negated()),
            Mixed => Mixed,
        },
        Expr::Sum(terms) => sum(terms)?,
        Expr::Product(factors) => product(factors)?,
        Expr::Quotient(above, below) => match (shape(above)?, shape(below)?) {
            (Scalar(above), Scalar(below)) => Scalar(Expr::Quotient(Box::new(above), Box::new(below))),
            (Vector(x, y), Scalar(below)) => Vector(x.over(below.clone()), y.over(below)),
            (Mixed, Scalar(_)) => Mixed,
            _ => return Err("a division by a vector"),
        },
        Expr::Power(base, exponent) => match (shape(base)?, shape(exponent)?) {
            (Scalar(base), Scalar(exponent)) => Scalar(Expr::Power(Box::new(base), Box::new(exponent))),
            _ => return Err("a power of a vector"),
        },
        Expr::Call(function, argument) => match (function, shape(argument)?) {
            (function, Scalar(argument)) => Scalar(Expr::call(*function, argument)),
            (Function::Abs, Vector(x, y)) => Scalar(size(&x, &y)),
            _ => return Err("a function of a vector"),
        },
        Expr::Degrees(inner) => match shape(inner)? {
            Scalar(value) => Scalar(Expr::degrees(value)),
            _ => return Err("a vector in degrees"),
        },
        Expr::Relation(..) => return Err("an equation where a value is expected"),
    })
}

/// `-1.5i + j2`: a number straight behind a unit vector goes before it.
pub(super) fn with_numbers_first(mut tokens: Vec<Placed>, vocabulary: &Vocabulary) -> Vec<Placed> {
    let is_unit = |placed: &Placed| matches!(&placed.token, Token::Word(word) if word == "i" || word == "j");
    let parts = |placed: Option<&Placed>| {
        placed.is_none_or(|placed| matches!(placed.token, Token::Sign('+' | '-' | '=' | ',' | ';' | '(' | ')' | '\n')))
    };
    for at in 1..tokens.len() {
        let is_number = matches!(tokens[at].token, Token::Number(_)) && !tokens[at].spaced;
        let is_first = parts(at.checked_sub(2).map(|before| &tokens[before])) && parts(tokens.get(at + 1));
        if vocabulary.vectors && is_number && is_first && is_unit(&tokens[at - 1]) {
            tokens.swap(at - 1, at);
        }
    }
    tokens
}

/// The length of a vector.
pub(super) fn size(x: &Expr, y: &Expr) -> Expr {
    if let (Some(x), Some(y)) = (rational(x), rational(y)) {
        return Expr::call(Function::Sqrt, Expr::Number(&(&x * &x) + &(&y * &y)));
    }
    let squares = [x, y].map(|part| part.clone().to_the(2));
    Expr::call(Function::Sqrt, Expr::Sum(squares.into()))
}

/// So much in the direction of a vector.
pub(super) fn along(magnitude: &Expr, x: &Expr, y: &Expr) -> Form {
    let unit = |part: &Expr| part.is_zero() || part.is_one() || *part == Expr::integer(1).negated();
    let axis = (x.is_zero() || y.is_zero()) && unit(x) && unit(y);
    let component = |part: &Expr| {
        if part.is_zero() {
            return Expr::integer(0);
        }
        let times = scaled(magnitude.clone(), part.clone());
        if axis { times } else { times.over(size(x, y)) }
    };
    Form::Vector(component(x), component(y), Notation::Words)
}

fn sum(terms: &[Expr]) -> Result<Shape, &'static str> {
    let mut scalars = Vec::new();
    let (mut xs, mut ys) = (Vec::new(), Vec::new());
    let mut vector = false;
    for term in terms {
        match shape(term)? {
            Shape::Scalar(value) => scalars.push(value),
            Shape::Vector(x, y) => {
                vector = true;
                xs.push(x);
                ys.push(y);
            }
            Shape::Mixed => return Ok(Shape::Mixed),
        }
    }
    Ok(match (vector, scalars.iter().all(Expr::is_zero)) {
        (false, _) => Shape::Scalar(Expr::Sum(scalars)),
        // `2i + 0` is only short for `2i + 0j`.
        (true, true) => Shape::Vector(Expr::sum(xs), Expr::sum(ys)),
        (true, false) => Shape::Mixed,
    })
}

fn product(factors: &[Expr]) -> Result<Shape, &'static str> {
    let mut scalars = Vec::new();
    let mut vector: Option<Shape> = None;
    for factor in factors {
        match (shape(factor)?, &vector) {
            (Shape::Scalar(value), _) => scalars.push(value),
            (found, None) => vector = Some(found),
            _ => return Err("a product of two vectors"),
        }
    }
    let times = |component: Expr| scalars.iter().rev().cloned().fold(component, |part, scalar| scaled(scalar, part));
    Ok(match vector {
        None => Shape::Scalar(Expr::Product(scalars)),
        Some(Shape::Vector(x, y)) => Shape::Vector(times(x), times(y)),
        Some(other) => other,
    })
}

/// A factor times a component, as a student would write it: numbers multiplied out, `(1/√10)(−3)` as `−3/√10`.
pub(super) fn scaled(factor: Expr, component: Expr) -> Expr {
    if component.is_zero() || factor.is_one() {
        return component;
    }
    if let (Some(a), Some(b)) = (rational(&factor), rational(&component)) {
        return Expr::Number(&a * &b);
    }
    match (factor, component) {
        (factor, Expr::Number(number)) if number.sign().is_lt() => scaled(factor, Expr::Number(number.abs())).negated(),
        (factor, Expr::Negative(inner)) => scaled(factor, *inner).negated(),
        (Expr::Negative(inner), component) => scaled(*inner, component).negated(),
        (Expr::Quotient(above, below), component) => scaled(*above, component).over(*below),
        // Numbers stand first.
        (factor, component @ Expr::Number(_)) => Expr::product([component, factor]),
        (factor, component) => Expr::product([factor, component]),
    }
}

/// The value of a fraction of whole numbers; decimals keep their digits.
pub(super) fn rational(expr: &Expr) -> Option<Fraction> {
    match expr {
        Expr::Number(value) => Some(value.clone()),
        Expr::Negative(inner) => rational(inner).map(|value| -value),
        Expr::Quotient(above, below) => Some(&rational(above)? * &rational(below)?.reciprocal()?),
        _ => None,
    }
}
