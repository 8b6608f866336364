//! The words of a question with its numbers put in.

use std::borrow::Cow;

use crate::expr::{Expr, Function, Meaning, Piece, Relation, Text, evaluate, number, written};
use crate::generate::Variant;
use crate::number::Value;
use crate::unit::Unit;

/// The paragraphs with numbers in place of names; `result` stands for what is to be shown.
pub fn paragraphs(words: &[Text], variant: &Variant, result: Option<&Expr>) -> Vec<Text> {
    words.iter().map(|text| sentence(text, variant, result)).collect()
}

/// Words with numbers in place of names.
pub fn sentence(text: &Text, variant: &Variant, result: Option<&Expr>) -> Text {
    Text(text.0.iter().map(|piece| filled_piece(piece, variant, result)).collect())
}

/// The same, without a copy where there is no formula in it.
pub fn put_in<'t>(text: &'t Text, variant: &Variant, result: Option<&Expr>) -> Cow<'t, Text> {
    if text.has_formulas() { Cow::Owned(sentence(text, variant, result)) } else { Cow::Borrowed(text) }
}

/// Several paragraphs as one run of words.
pub fn joined(paragraphs: Vec<Text>) -> Text {
    let mut pieces = Vec::new();
    for text in paragraphs {
        if !pieces.is_empty() {
            pieces.push(Piece::Words(" ".to_owned()));
        }
        pieces.extend(text.0);
    }
    Text(pieces)
}

fn filled_piece(piece: &Piece, variant: &Variant, result: Option<&Expr>) -> Piece {
    let fill = |expr: &Expr| match (expr, result) {
        (Expr::Name(name), Some(result)) if name.text == "result" => result.clone(),
        _ => filled(expr, variant),
    };
    match piece {
        Piece::Words(words) => Piece::Words(words.clone()),
        Piece::Italic(inner) => Piece::Italic(inner.iter().map(|piece| filled_piece(piece, variant, result)).collect()),
        Piece::Formula(expr) => Piece::Formula(fill(expr)),
        Piece::Display(expr) => Piece::Display(fill(expr)),
        Piece::Quantity(expr, unit) => match (fill(expr), unit) {
            // `atan(3/4)/deg` degrees are an angle without our help.
            (Expr::Quotient(angle, one_degree), Unit::Degree) if is_one_degree(&one_degree) => Piece::Formula(*angle),
            (size, unit) => Piece::Quantity(size, *unit),
        },
    }
}

fn is_one_degree(expr: &Expr) -> bool {
    matches!(expr, Expr::Degrees(inner) if inner.is_one())
}

/// A formula with numbers in place of names. A name alone is printed as its number was written; a longer
/// formula is worked out.
pub fn filled(expr: &Expr, variant: &Variant) -> Expr {
    let givens = &variant.givens;
    match expr {
        Expr::Name(name) => givens.shown(&name.text).cloned().unwrap_or_else(|| expr.clone()),
        Expr::Vector(x, y) => Expr::Vector(Box::new(filled(x, variant)), Box::new(filled(y, variant))),
        Expr::Relation(left, relation, right) => {
            Expr::Relation(Box::new(filled(left, variant)), *relation, Box::new(filled(right, variant)))
        }
        _ if !expr.names().iter().any(|name| givens.shown(&name.text).is_some()) => expr.clone(),
        _ => match evaluate(expr, &|name| variant.givens.meaning(name)) {
            Ok(Meaning::Number(value)) => written(&value),
            _ => expr.substitute(&|name| givens.shown(name).cloned()),
        },
    }
}

/// The letters that the words give with a unit, such as `m` in 'a mass of 3m kg'.
pub fn letters_with_units(paragraphs: &[Text]) -> Vec<String> {
    let mut found = Vec::new();
    for text in paragraphs {
        collect(&text.0, &mut found);
    }
    found
}

fn collect(pieces: &[Piece], found: &mut Vec<String>) {
    for piece in pieces {
        match piece {
            Piece::Italic(inner) => collect(inner, found),
            Piece::Quantity(expr, unit) if *unit != Unit::None => {
                found.extend(expr.names().iter().map(|name| name.text.clone()));
            }
            _ => {}
        }
    }
}

/// Do the words give vectors in **i** and **j**?
pub fn has_unit_vectors(paragraphs: &[Text]) -> bool {
    paragraphs.iter().flat_map(Text::formulas).any(|formula| match formula {
        Expr::Vector(..) => true,
        Expr::Name(name) => matches!(name.text.as_str(), "i" | "j"),
        _ => false,
    })
}

/// The angles that the words name by a letter and give by their tangent: 'where tan α = 2'.
pub fn named_angles(paragraphs: &[Text]) -> Vec<(Expr, Value)> {
    let named = |formula: &Expr| match formula {
        Expr::Relation(left, Relation::Equal, right) => match &**left {
            Expr::Call(Function::Tan, name) if matches!(**name, Expr::Name(_)) => {
                Some(((**name).clone(), number(right, &|_| None).ok()?))
            }
            _ => None,
        },
        _ => None,
    };
    paragraphs.iter().flat_map(Text::formulas).filter_map(named).collect()
}
