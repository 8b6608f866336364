//! The layout of a formula: every decision that LaTeX, MathML and a terminal share.
//!
//! A layout is a row of items. It says where signs, brackets and multiplication signs stand, and
//! which brackets a function does without; the printers only say how each item is written.

use std::borrow::Cow;

use super::letter::{Letter, letter};
use super::shape::{Vectors, is_digits, is_whole_power, tidied};
use crate::expr::{Expr, Function, Relation};
use crate::number::{Decimal, Fraction};
use crate::unit::Unit;

/// Items from left to right.
pub(super) type Row<'e> = Vec<Item<'e>>;

/// A piece of a formula; its letters and most of its digits are those of the expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item<'e> {
    /// Digits, without sign.
    Digits(Cow<'e, str>),
    /// A letter, perhaps with a subscript.
    Letter(Letter<'e>),
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
    Fraction(Row<'e>, Row<'e>),
    /// Square root.
    Root(Row<'e>),
    /// Base and exponent.
    Power(Row<'e>, Row<'e>),
    /// Round brackets.
    Brackets(Row<'e>),
    /// Size without sign.
    Bars(Row<'e>),
    /// A function, its whole power if any, and its argument, with brackets if it needs them.
    Call(Function, Option<String>, Row<'e>),
    /// A unit and the space before it.
    Unit(Unit),
}

/// Most rows have no more items than this.
const USUAL: usize = 8;

/// A formula ready to be laid out.
pub(super) struct Formula<'e>(Cow<'e, Expr>);

impl<'e> Formula<'e> {
    /// The formula of an expression.
    pub fn of(expr: &'e Expr) -> Formula<'e> {
        Formula(tidied(expr, Vectors::Sums))
    }

    /// Its layout.
    pub fn row(&self) -> Row<'_> {
        row(&self.0)
    }

    /// Its layout as a value with its unit: `(4i - j) m s^-1`, `30°`.
    pub fn quantity(&self, unit: Unit) -> Row<'_> {
        let mut items = Row::with_capacity(USUAL);
        measured(&self.0, unit, &mut items);
        items
    }
}

fn measured<'e>(expr: &'e Expr, unit: Unit, items: &mut Row<'e>) {
    match (expr, unit) {
        // In `u = 4 m s^-1` the unit belongs to the right side.
        (Expr::Relation(left, relation, right), _) => {
            lay(left, items);
            items.push(Item::Relation(*relation));
            measured(right, unit, items);
        }
        (_, Unit::None) | (Expr::Degrees(_), Unit::Degree) => lay(expr, items),
        // So many degrees as an angle has is that angle.
        (Expr::Quotient(angle, by), Unit::Degree) if matches!(&**by, Expr::Degrees(one) if one.is_one()) => {
            lay(angle, items);
        }
        (Expr::Negative(size), Unit::Degree) => {
            items.push(Item::Negation);
            let mut angle = Row::new();
            measured(size, unit, &mut angle);
            if matches!(**size, Expr::Negative(_)) {
                items.push(Item::Brackets(angle));
            } else {
                items.append(&mut angle);
            }
        }
        (_, Unit::Degree) => degrees(expr, items),
        _ => {
            let size = if let Expr::Negative(size) = expr { size } else { expr };
            if is_loose(size) {
                items.push(bracketed(expr))
            } else {
                lay(expr, items)
            }
            items.push(Item::Unit(unit));
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

fn row(expr: &Expr) -> Row<'_> {
    let mut items = Row::with_capacity(USUAL);
    lay(expr, &mut items);
    items
}

/// Adds the items of a tidied expression.
fn lay<'e>(expr: &'e Expr, items: &mut Row<'e>) {
    match expr {
        Expr::Number(value) => items.push(number(value)),
        Expr::Decimal(text) => items.push(Item::Digits(text.into())),
        Expr::Name(name) if name.text == "i" => items.push(Item::Bold('i')),
        Expr::Name(name) if name.text == "j" => items.push(Item::Bold('j')),
        Expr::Name(name) => items.push(Item::Letter(letter(&name.text))),
        Expr::Pi => items.push(Item::Letter(letter("pi"))),
        Expr::Degrees(inner) => degrees(inner, items),
        Expr::Negative(size) => {
            items.push(Item::Negation);
            operand(size, items);
        }
        Expr::Sum(terms) => sum(terms, items),
        Expr::Product(factors) => product(factors, items),
        Expr::Quotient(numerator, denominator) => items.push(Item::Fraction(row(numerator), row(denominator))),
        Expr::Power(base, exponent) => items.push(power(base, exponent)),
        Expr::Call(Function::Sqrt, argument) => items.push(Item::Root(row(argument))),
        Expr::Call(Function::Abs, argument) => items.push(Item::Bars(row(argument))),
        Expr::Call(function, argument) => items.push(Item::Call(*function, None, argument_row(argument))),
        Expr::Vector(..) => items.push(Item::Bold('0')),
        Expr::Relation(left, relation, right) => {
            lay(left, items);
            items.push(Item::Relation(*relation));
            lay(right, items);
        }
    }
}

fn bracketed(expr: &Expr) -> Item<'_> {
    Item::Brackets(row(expr))
}

fn number<'e>(value: &Fraction) -> Item<'e> {
    let (above, below) = match value.as_small() {
        Some((above, below)) => (digits(above), digits(below)),
        None => (value.numerator().to_string().into(), value.denominator().to_string().into()),
    };
    if value.is_integer() {
        Item::Digits(above)
    } else {
        Item::Fraction(vec![Item::Digits(above)], vec![Item::Digits(below)])
    }
}

/// The digits of a number; most numbers have one, which need not be made.
fn digits<'e>(number: i64) -> Cow<'e, str> {
    const READY: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
    let ready = usize::try_from(number).ok().and_then(|number| READY.get(number));
    ready.map_or_else(|| number.to_string().into(), |digit| (*digit).into())
}

/// Adds an angle of so many degrees.
fn degrees<'e>(number: &'e Expr, items: &mut Row<'e>) {
    match decimal_of_degrees(number) {
        Some(decimal) => items.push(Item::Digits(decimal.into())),
        None if is_digits(number) || is_letter(number) => lay(number, items),
        None => items.push(bracketed(number)),
    }
    items.push(Item::Degree);
}

/// A fraction of degrees as angles are given, `116.23` and not `11623/100`, where it has so few figures that somebody may
/// have written it.
fn decimal_of_degrees(number: &Expr) -> Option<String> {
    let value = match number {
        Expr::Number(value) => value.clone(),
        Expr::Quotient(above, below) => match (&**above, &**below) {
            (Expr::Number(above), Expr::Number(below)) => above * &below.reciprocal()?,
            _ => return None,
        },
        _ => return None,
    };
    let decimal = Decimal::exact(&value).filter(|decimal| (1..=MOST_PLACES_OF_DEGREES).contains(&decimal.places))?;
    Some(decimal.to_string())
}

/// A fraction of degrees with more decimals than this stays a fraction.
const MOST_PLACES_OF_DEGREES: u32 = 6;

/// Would a sign or factor before or after it bind to a part of it only?
fn is_loose(expr: &Expr) -> bool {
    matches!(expr, Expr::Sum(_) | Expr::Relation(..) | Expr::Negative(_))
}

/// Adds a term or factor, in brackets if it is loose.
fn operand<'e>(expr: &'e Expr, items: &mut Row<'e>) {
    if is_loose(expr) { items.push(bracketed(expr)) } else { lay(expr, items) }
}

fn sum<'e>(terms: &'e [Expr], items: &mut Row<'e>) {
    for (place, term) in terms.iter().enumerate() {
        match term {
            Expr::Negative(size) => {
                items.push(if place == 0 { Item::Negation } else { Item::Minus });
                operand(size, items);
            }
            // `(4i - j) - (2i + 5j)`: a vector stays one thing, also where it stands first
            Expr::Sum(_) if place == 0 && !is_vector(term) => lay(term, items),
            _ => {
                if place > 0 {
                    items.push(Item::Plus);
                }
                operand(term, items);
            }
        }
    }
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

fn product<'e>(factors: &'e [Expr], items: &mut Row<'e>) {
    for (place, factor) in factors.iter().enumerate() {
        if place == 0 {
            operand(factor, items);
            continue;
        }
        // the sign is chosen when both its sides stand
        let sign = items.len();
        items.push(Item::Beside);
        operand(factor, items);
        let (before, after) = items.split_at_mut(sign);
        let Some((sign, next)) = after.split_first_mut() else { continue };
        let shows = is_times_shown(before.last(), factor, next);
        *sign = match (shows, next.first(), open_argument(before)) {
            (true, ..) => Item::Times,
            (_, Some(Item::Bold(_)), Some(_)) => Item::Gap,
            (_, Some(Item::Call(..)), _) | (.., None) => Item::Beside,
            // `cos(alpha) v` must not be taken for the cosine of `alpha v`.
            (.., Some(argument)) => {
                *argument = vec![Item::Brackets(std::mem::take(argument))];
                Item::Beside
            }
        };
    }
}

/// Does a multiplication sign show before the factor? It does before digits and negative numbers, and where two fractions
/// or roots would run into each other.
fn is_times_shown(before: Option<&Item>, factor: &Expr, next: &[Item]) -> bool {
    if let Expr::Negative(size) = factor {
        return matches!(**size, Expr::Number(_) | Expr::Decimal(_)) || is_times_shown(before, size, &[]);
    }
    match next.first() {
        Some(Item::Fraction(..)) if matches!(before, Some(Item::Fraction(..) | Item::Root(_) | Item::Call(..))) => true,
        Some(Item::Root(inner)) => match before {
            Some(Item::Root(_) | Item::Call(..)) => true,
            Some(Item::Letter(_) | Item::Power(..)) => matches!(inner[..], [Item::Digits(_)]),
            _ => false,
        },
        Some(Item::Fraction(top, bottom)) => {
            let number = matches!((&top[..], &bottom[..]), ([Item::Digits(_)], [Item::Digits(_)]));
            // A number straight before a fraction of numbers would look like a mixed number, and of `m 4u/5` nobody sees at
            // once that it is two factors.
            let is_number = begins_with_digit(top) || matches!(top.first(), Some(Item::Root(_)));
            let is_sum = top.iter().any(|item| matches!(item, Item::Plus | Item::Minus));
            number
                || match before {
                    Some(Item::Digits(_)) => is_number,
                    Some(Item::Letter(_)) => is_number && !is_sum,
                    _ => false,
                }
        }
        _ => begins_with_digit(next),
    }
}

fn begins_with_digit(row: &[Item]) -> bool {
    match row.first() {
        // A nought in bold is one too: `2 0` would be twenty.
        Some(Item::Digits(_) | Item::Bold('0')) => true,
        Some(Item::Fraction(inner, _) | Item::Power(inner, _)) => begins_with_digit(inner),
        _ => false,
    }
}

/// The argument without brackets of the function with which the row ends.
fn open_argument<'i, 'e>(items: &'i mut [Item<'e>]) -> Option<&'i mut Row<'e>> {
    match items.last_mut() {
        Some(Item::Call(_, _, argument)) if !matches!(argument[..], [Item::Brackets(_)]) => Some(argument),
        _ => None,
    }
}

fn power<'e>(base: &'e Expr, exponent: &'e Expr) -> Item<'e> {
    if let Expr::Call(function @ (Function::Sin | Function::Cos | Function::Tan), argument) = base
        && is_whole_power(exponent)
        && let Expr::Number(value) = exponent
    {
        return Item::Call(*function, Some(value.to_string()), argument_row(argument));
    }
    let alone = is_digits(base) || matches!(base, Expr::Name(_) | Expr::Pi | Expr::Call(Function::Abs, _));
    let below = if alone { row(base) } else { vec![bracketed(base)] };
    Item::Power(below, row(exponent))
}

/// The argument of a function: a letter, a number or so many degrees stand without brackets.
fn argument_row(argument: &Expr) -> Row<'_> {
    let alone = match argument {
        Expr::Degrees(inner) => is_digits(inner) || is_letter(inner) || decimal_of_degrees(inner).is_some(),
        Expr::Quotient(top, bottom) => is_digits(top) && is_digits(bottom),
        Expr::Number(_) => true,
        other => is_digits(other) || is_letter(other),
    };
    if alone { row(argument) } else { vec![bracketed(argument)] }
}

fn is_letter(expr: &Expr) -> bool {
    match expr {
        Expr::Name(name) => !name.text.contains('.'),
        Expr::Pi => true,
        _ => false,
    }
}
