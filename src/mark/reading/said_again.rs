//! A value that is said again in brackets: `0.75 (3/4)`, `4√39/9 [2.78]`, `81.9° (1.43 rad)`, or another one there.

use super::choices::{Choices, Doubt};
use super::grammar::Parser;
use super::inequalities::has_inequality;
use super::names;
use super::tokens::{Placed, Token};
use super::units::{is_unit_word, unit};
use super::vectors::{self, Shape, shape};
use super::{SaidUnit, Vocabulary};
use crate::expr::{Expr, Function};
use crate::mark::enclosure::about;
use crate::number::{Letter, Range};

/// The closing bracket of a value that is said again, or of a condition, in the bracket that opens here.
pub(super) fn said_again(
    tokens: &[Placed],
    start: usize,
    vocabulary: &Vocabulary,
    choices: &mut Choices,
) -> Option<usize> {
    // `36°52' (36.9°)`
    let is_end = |sign: char| matches!(sign, ')' | '°' | '%' | '⟧' | '\'' | '"');
    let after_value = match tokens[start - 1].token {
        Token::Number(_) | Token::Word(_) => true,
        Token::Sign(sign) => is_end(sign),
        _ => false,
    };
    if !after_value {
        return None;
    }
    if let Some(close) = same_or_rival(tokens, start, vocabulary, choices) {
        return Some(close);
    }
    if !tokens[start].is('(') {
        return None;
    }
    let inner = tokens.get(start + 1)?;
    let close = start + tokens[start..].iter().position(|placed| placed.is(')'))?;
    let inside = &tokens[start + 1..close];
    if !tokens[start].spaced && !has_inequality(inside) {
        return None;
    }
    if inner.is('=') || inner.is('≈') || inside.iter().any(compares) {
        let opens = inside.iter().any(|placed| placed.is('('));
        return (!opens).then_some(close);
    }
    // A speed, an impulse or an energy: no letters of a question look like their units.
    let whole = |unit: &SaidUnit| unit.dimension[1] != 0 && unit.dimension[2] != 0;
    let end = match unit(tokens, start + 2, "").filter(|(unit, _)| whole(unit)) {
        Some((_, end)) => end,
        // `√13 m/s (3.61)`
        None => {
            let before = (1..start).filter_map(|at| unit(&tokens[..start], at, ""));
            before.filter(|(unit, end)| *end == start && whole(unit)).map(|_| start + 2).next()?
        }
    };
    (matches!(inner.token, Token::Number(_)) && tokens.get(end)?.is(')')).then_some(end)
}

/// The closing bracket where what stands in brackets is nearly the value before them, in which no product would be
/// meant; or where it is another value at the end, as two answers are, unless a product is.
fn same_or_rival(tokens: &[Placed], start: usize, vocabulary: &Vocabulary, choices: &mut Choices) -> Option<usize> {
    let closing = match tokens[start].token {
        Token::Sign('(') => ')',
        Token::Sign('[') => ']',
        Token::Sign('{') => '}',
        // Braces of LaTeX, or a student's own.
        Token::Sign('⟦') => '⟧',
        _ => return None,
    };
    let (before, after) = tokens.split_at(start);
    let close = closes(after, closing)?;
    let inside = &after[1..close];
    let begins = |placed: &Placed| matches!(placed.token, Token::Phrase(_)) || parts(placed) || compares(placed);
    let stated = before.iter().rposition(begins).map_or(before, |at| &before[at + 1..]);
    let only_decimal = |tokens: &[Placed]| matches!(tokens, [Placed { token: Token::Number(Expr::Decimal(_)), .. }]);
    let measure = matches!(tokens[start - 1].token, Token::Word(_) | Token::Sign('°' | '%' | '\'' | '"'));
    let follows = |next: &Placed| match &next.token {
        // `0.5 \frac{1}{2} v` is a product.
        _ if closing == '⟧' => false,
        Token::Word(word) => is_unit_word(word),
        Token::Phrase(_) | Token::Sign(',' | ';' | '.' | '\n' | '⇒' | '<' | '>' | '≤' | '≥') => true,
        _ => false,
    };
    let ends = after.get(close + 1).is_none_or(follows);
    if inside.is_empty() || !(tokens[start].spaced || measure) || !ends || inside.iter().any(begins) {
        return None;
    }
    let ((one, is_formula), (other, has_letters)) = (measured(stated, vocabulary)?, measured(inside, vocabulary)?);
    let gap = (one - other).abs();
    let is_same = gap < 0.01 * one.abs() || gap <= half_unit(stated) || gap <= half_unit(inside);
    let is_last = start + close + 1 == tokens.len();
    // `2.78 (46.1°)`, `10/43 (23.3%)`: by such nobody multiplies.
    let is_measure = |placed: &Placed| placed.is('°') || placed.is('%');
    if closing != '⟧' && inside.last().is_some_and(is_measure) {
        return Some(start + close);
    }
    let mut is_product = || choices.otherwise(Doubt::SaidAgain, tokens[start].start);
    // `½u(1-e) (½u-½eu)`, `4i + j (√17)`, `28 (18 + 10)`; but `(1-e) (1-e)` is a square.
    let is_square = || {
        tokens[start - 1].is(closing)
            && inside.iter().rev().zip(before[..start - 1].iter().rev()).all(|(one, other)| one.token == other.token)
    };
    let is_again = is_same && tokens[start].spaced && closing != '⟧' && !is_square();
    if is_formula || has_letters {
        return (is_again && !is_product()).then_some(start + close);
    }
    // `k > 32/3 (10.7)`
    if is_same && closing != '⟧' && before.iter().any(compares) {
        return Some(start + close);
    }
    if is_last && closing == ')' && only_decimal(inside) {
        // `25/7 (3.57)`, where nothing more is said, or another answer.
        let is_set_off = measure || of_one_figure(&tokens[start - 1]) || (!is_same && !is_product());
        return is_set_off.then_some(start + close);
    }
    let is_decimal = only_decimal(stated) || only_decimal(inside) || measure;
    (is_decimal && is_same || is_again && !is_product()).then_some(start + close)
}

/// Does it stand between two things that are said?
pub(super) fn parts(placed: &Placed) -> bool {
    matches!(placed.token, Token::Sign('=' | '≈' | ',' | ';' | ':' | '\n' | '⇒'))
}

/// Does it compare two sides, and not as equals?
pub(super) fn compares(placed: &Placed) -> bool {
    matches!(placed.token, Token::Sign('<' | '>' | '≤' | '≥' | '≠'))
}

/// Where the bracket closes with which the tokens begin.
pub(super) fn closes(tokens: &[Placed], closing: char) -> Option<usize> {
    let opening = &tokens.first()?.token;
    let mut depth = 0_usize;
    tokens.iter().position(|placed| {
        if placed.token == *opening {
            depth += 1;
        } else if placed.is(closing) {
            depth -= 1;
        }
        depth == 0
    })
}

/// About how much is said, in degrees if it is an angle, of a vector its size; and whether letters or a vector are in it.
pub(super) fn measured(tokens: &[Placed], vocabulary: &Vocabulary) -> Option<(f64, bool)> {
    let (value, scale) = match tokens {
        [value @ .., percent] if percent.is('%') => (value, 0.01),
        // The minutes of `36 degrees 52 minutes` are no unit.
        _ if tokens.iter().any(|placed| placed.is('°')) => (tokens, 1.0),
        // `9m` is a mass where the question has an m.
        [.., Placed { token: Token::Word(last), .. }] if names::letter(last, vocabulary).is_some() => (tokens, 1.0),
        _ => match (1..tokens.len())
            .find_map(|at| Some((at, unit(tokens, at, "").filter(|(_, end)| *end == tokens.len())?)))
        {
            Some((at, (unit, _))) => {
                (&tokens[..at], if unit.dimension == [0, 0, 0, 1] { 1_f64.to_degrees() } else { 1.0 })
            }
            None => (tokens, 1.0),
        },
    };
    let mut choices = Choices::default();
    let mut parser = Parser::new(value.to_vec(), "", vocabulary, &mut choices);
    let expr = parser.sum().ok().filter(|_| parser.at == parser.end)?;
    let has_names = !expr.names().is_empty();
    let expr = match shape(&expr).ok()? {
        Shape::Scalar(value) => value,
        Shape::Vector(x, y) => vectors::size(&x, &y),
        Shape::Mixed => return None,
    };
    Some((size(&expr, &vocabulary.letters)? * scale, has_names))
}

/// Half of the last figure of a decimal: what it was rounded from lies no farther away.
fn half_unit(tokens: &[Placed]) -> f64 {
    match tokens {
        [Placed { token: Token::Number(Expr::Decimal(text)), .. }, ..] => {
            let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            0.5001 * 0.1_f64.powi(i32::try_from(decimals).unwrap_or(0))
        }
        _ => 0.0,
    }
}

/// About how much it is, in degrees if it is an angle, where its letters have values that nobody would choose.
fn size(expr: &Expr, letters: &[Letter]) -> Option<f64> {
    let size = about(expr, letters)?;
    Some(if is_angle(expr, letters) { size.to_degrees() } else { size })
}

/// Is it an angle, or does it have one as a term or a factor?
fn is_angle(expr: &Expr, letters: &[Letter]) -> bool {
    match expr {
        Expr::Degrees(_) | Expr::Call(Function::Asin | Function::Acos | Function::Atan, _) => true,
        Expr::Name(name) => letters.iter().any(|letter| letter.name() == name.text && letter.range() == Range::Acute),
        Expr::Call(..) => false,
        other => other.children().into_iter().any(|child| is_angle(child, letters)),
    }
}

/// Is it a decimal of one figure, as `0.7` is?
pub(super) fn of_one_figure(placed: &Placed) -> bool {
    let Token::Number(Expr::Decimal(digits)) = &placed.token else { return false };
    let figures = digits.trim_start_matches(['0', '.']);
    figures.len() == 1
}
