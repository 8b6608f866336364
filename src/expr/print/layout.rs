//! The layout of a formula: every decision that LaTeX, MathML and a terminal share.
//!
//! A layout is a row of items. It says where signs, brackets and multiplication signs stand, and
//! which brackets a function does without; the printers only say how each item is written.

use super::letter::{Letter, letter};
use super::shape::{behind_minus, is_digits, is_whole_power, tidied};
use crate::expr::{Expr, Function, Relation};
use crate::unit::Unit;

/// Items from left to right.
pub(super) type Row = Vec<Item>;

/// A piece of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    /// Digits, without sign.
    Digits(String),
    /// A letter, perhaps with a subscript.
    Letter(Letter),
    /// A unit vector or the zero vector.
    Bold(char),
    /// The degree sign.
    Degree,
    /// A minus sign before the first term.
    Negation,
    /// A plus sign between terms.
    Plus,
    /// A minus sign between terms.
    Minus,
    /// A multiplication sign that shows.
    Times,
    /// Multiplication by writing side by side.
    Beside,
    /// Multiplication by writing side by side, with a little space: between a function and a unit vector.
    Gap,
    /// What stands between two sides.
    Relation(Relation),
    /// One row over another.
    Fraction(Row, Row),
    /// Square root.
    Root(Row),
    /// Base and exponent.
    Power(Row, Row),
    /// Round brackets.
    Brackets(Row),
    /// Size without sign.
    Bars(Row),
    /// A function, its whole power if any, and its argument, with brackets if it needs them.
    Call(Function, Option<String>, Row),
    /// A unit and the space before it.
    Unit(Unit),
}

/// The layout of a formula.
pub(super) fn layout(expr: &Expr) -> Row {
    row(&by_components(&tidied(expr)))
}

/// The layout of a value with its unit: `(4i - j) m s^-1`, `30°`.
pub(super) fn quantity(expr: &Expr, unit: Unit) -> Row {
    measured(&by_components(&tidied(expr)), unit)
}

fn measured(expr: &Expr, unit: Unit) -> Row {
    match (expr, unit) {
        // In `u = 4 m s^-1` the unit belongs to the right side.
        (Expr::Relation(left, relation, right), _) => {
            let mut items = row(left);
            items.push(Item::Relation(*relation));
            items.extend(measured(right, unit));
            items
        }
        (_, Unit::None) | (Expr::Degrees(_), Unit::Degree) => row(expr),
        // So many degrees as an angle has is that angle.
        (Expr::Quotient(angle, one), Unit::Degree) if **one == Expr::degrees(Expr::integer(1)) => row(angle),
        (_, Unit::Degree) => row(&Expr::degrees(expr.clone())),
        _ => {
            let size = behind_minus(expr);
            let loose = is_loose(size.as_ref().unwrap_or(expr));
            let mut items = if loose { bracketed(expr) } else { row(expr) };
            items.push(Item::Unit(unit));
            items
        }
    }
}

/// Does the row reach above and below the line, so that brackets around it must grow?
pub(super) fn is_tall(row: &[Item]) -> bool {
    row.iter().any(|item| match item {
        Item::Fraction(..) => true,
        Item::Root(inner) | Item::Brackets(inner) | Item::Bars(inner) | Item::Power(inner, _) => is_tall(inner),
        Item::Call(_, _, argument) => is_tall(argument),
        _ => false,
    })
}

/// The tree with vectors written as sums along i and j; only the zero vector is left.
fn by_components(expr: &Expr) -> Expr {
    let expr = expr.map_children(&mut |child| by_components(child));
    let Expr::Vector(x, y) = &expr else { return expr };
    let along = |component: &Expr, unit: &str| Expr::Product(vec![component.clone(), Expr::name(unit)]);
    match (x.is_zero(), y.is_zero()) {
        (true, true) => expr,
        (false, true) => tidied(&along(x, "i")),
        (true, false) => tidied(&along(y, "j")),
        (false, false) => tidied(&Expr::Sum(vec![along(x, "i"), along(y, "j")])),
    }
}

fn row(expr: &Expr) -> Row {
    if let Some(size) = behind_minus(expr) {
        let mut items = vec![Item::Negation];
        items.extend(operand(&size));
        return items;
    }
    match expr {
        Expr::Number(value) if !value.is_integer() => {
            let digits = |part: String| vec![Item::Digits(part)];
            vec![Item::Fraction(digits(value.numerator().to_string()), digits(value.denominator().to_string()))]
        }
        Expr::Number(value) => vec![Item::Digits(value.to_string())],
        Expr::Decimal(text) => vec![Item::Digits(text.clone())],
        Expr::Name(name) if name.text == "i" => vec![Item::Bold('i')],
        Expr::Name(name) if name.text == "j" => vec![Item::Bold('j')],
        Expr::Name(name) => vec![Item::Letter(letter(&name.text))],
        Expr::Pi => vec![Item::Letter(letter("pi"))],
        Expr::Degrees(inner) => {
            let mut items = if is_digits(inner) || is_letter(inner) { row(inner) } else { bracketed(inner) };
            items.push(Item::Degree);
            items
        }
        Expr::Negative(inner) => operand(inner),
        Expr::Sum(terms) => sum(terms),
        Expr::Product(factors) => product(factors),
        Expr::Quotient(numerator, denominator) => vec![Item::Fraction(row(numerator), row(denominator))],
        Expr::Power(base, exponent) => power(base, exponent),
        Expr::Call(Function::Sqrt, argument) => vec![Item::Root(row(argument))],
        Expr::Call(Function::Abs, argument) => vec![Item::Bars(row(argument))],
        Expr::Call(function, argument) => vec![Item::Call(*function, None, argument_row(argument))],
        Expr::Vector(..) => vec![Item::Bold('0')],
        Expr::Relation(left, relation, right) => {
            let mut items = row(left);
            items.push(Item::Relation(*relation));
            items.extend(row(right));
            items
        }
    }
}

fn bracketed(expr: &Expr) -> Row {
    vec![Item::Brackets(row(expr))]
}

/// Would a sign or factor before or after it bind to a part of it only?
fn is_loose(expr: &Expr) -> bool {
    matches!(expr, Expr::Sum(_) | Expr::Relation(..)) || behind_minus(expr).is_some()
}

/// A term or factor, in brackets if it is loose.
fn operand(expr: &Expr) -> Row {
    if is_loose(expr) { bracketed(expr) } else { row(expr) }
}

fn sum(terms: &[Expr]) -> Row {
    let mut items = Row::new();
    for (place, term) in terms.iter().enumerate() {
        match behind_minus(term) {
            Some(size) => {
                items.push(if place == 0 { Item::Negation } else { Item::Minus });
                items.extend(operand(&size));
            }
            // `(4i - j) - (2i + 5j)`: a vector stays one thing, also where it stands first
            None if place == 0 && matches!(term, Expr::Sum(_)) && !is_vector(term) => items.extend(row(term)),
            None => {
                if place > 0 {
                    items.push(Item::Plus);
                }
                items.extend(operand(term));
            }
        }
    }
    items
}

/// Is it a sum along i and j?
fn is_vector(expr: &Expr) -> bool {
    match expr {
        Expr::Name(name) => matches!(name.text.as_str(), "i" | "j"),
        Expr::Sum(parts) | Expr::Product(parts) => parts.iter().any(is_vector),
        Expr::Negative(inner) => is_vector(inner),
        _ => false,
    }
}

fn product(factors: &[Expr]) -> Row {
    let mut items = Row::new();
    for (place, factor) in factors.iter().enumerate() {
        let next = operand(factor);
        if place > 0 {
            let shows = is_times_shown(items.last(), factor, &next);
            let sign = match (shows, next.first(), open_argument(&mut items)) {
                (true, ..) => Item::Times,
                (_, Some(Item::Bold(_)), Some(_)) => Item::Gap,
                (_, Some(Item::Call(..)), _) | (.., None) => Item::Beside,
                // `cos(alpha) v` must not be taken for the cosine of `alpha v`.
                (.., Some(argument)) => {
                    *argument = vec![Item::Brackets(std::mem::take(argument))];
                    Item::Beside
                }
            };
            items.push(sign);
        }
        items.extend(next);
    }
    items
}

/// Does a multiplication sign show before the factor? It does before digits and negative numbers.
fn is_times_shown(before: Option<&Item>, factor: &Expr, next: &Row) -> bool {
    if let Some(size) = behind_minus(factor) {
        return matches!(size, Expr::Number(_) | Expr::Decimal(_));
    }
    match next.first() {
        Some(Item::Fraction(top, bottom)) => {
            let number = matches!((&top[..], &bottom[..]), ([Item::Digits(_)], [Item::Digits(_)]));
            // A number straight before a fraction of numbers would look like a mixed number.
            let mixed = begins_with_digit(top) || matches!(top[..], [Item::Root(_)]);
            number || (matches!(before, Some(Item::Digits(_))) && mixed)
        }
        _ => begins_with_digit(next),
    }
}

fn begins_with_digit(row: &Row) -> bool {
    match row.first() {
        Some(Item::Digits(_)) => true,
        Some(Item::Fraction(inner, _) | Item::Power(inner, _)) => begins_with_digit(inner),
        _ => false,
    }
}

/// The argument without brackets of the function with which the row ends.
fn open_argument(items: &mut Row) -> Option<&mut Row> {
    match items.last_mut() {
        Some(Item::Call(_, _, argument)) if !matches!(argument[..], [Item::Brackets(_)]) => Some(argument),
        _ => None,
    }
}

fn power(base: &Expr, exponent: &Expr) -> Row {
    if let Expr::Call(function @ (Function::Sin | Function::Cos | Function::Tan), argument) = base
        && is_whole_power(exponent)
        && let Expr::Number(value) = exponent
    {
        return vec![Item::Call(*function, Some(value.to_string()), argument_row(argument))];
    }
    let alone = is_digits(base) || matches!(base, Expr::Name(_) | Expr::Pi | Expr::Call(Function::Abs, _));
    let below = if alone { row(base) } else { bracketed(base) };
    vec![Item::Power(below, row(exponent))]
}

/// The argument of a function: a letter, a number or so many degrees stand without brackets.
fn argument_row(argument: &Expr) -> Row {
    let number = matches!(argument, Expr::Number(_)) && behind_minus(argument).is_none();
    let alone = match argument {
        Expr::Degrees(inner) => is_digits(inner) || is_letter(inner),
        Expr::Quotient(top, bottom) => is_digits(top) && is_digits(bottom),
        other => number || is_digits(other) || is_letter(other),
    };
    if alone { row(argument) } else { bracketed(argument) }
}

fn is_letter(expr: &Expr) -> bool {
    match expr {
        Expr::Name(name) => !name.text.contains('.'),
        Expr::Pi => true,
        _ => false,
    }
}
