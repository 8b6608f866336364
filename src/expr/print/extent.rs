//! How much room a line of words and formulas takes, before anything is printed.
//!
//! The room is that of the wider of the fonts in which our pages are set, so that what is kept clear for a label stays
//! clear of it on paper and on screen.

use super::layout::{Formula, Item, Row};
use super::letter::{Letter, Symbol};
use super::unicode::{is_bracketed_on_one_line, name};
use super::unit::unit_unicode;
use crate::expr::{Piece, Text};

/// Height of a line without anything tall in it.
const LINE: f64 = 1.1;
/// Height of a line with a fraction in it.
const TALL: f64 = 1.5;

/// Width and height of a text on one line, in ems of its letters.
///
/// ```
/// use carom::expr::{Text, print};
/// let (width, height) = print::extent(&Text::words("line of centres"));
/// assert!(6.0 < width && width < 8.0 && height == 1.1);
/// ```
pub fn extent(text: &Text) -> (f64, f64) {
    let pieces = text.0.iter().map(|piece| match piece {
        Piece::Words(words) => (words_width(words), LINE),
        Piece::Italic(inner) => extent(&Text(inner.clone())),
        Piece::Formula(expr) | Piece::Display(expr) => row_extent(&Formula::of(expr).row()),
        Piece::Quantity(expr, unit) => row_extent(&Formula::of(expr).quantity(*unit)),
    });
    pieces.fold((0.0, LINE), |(width, height), (more, taller)| (width + more, taller.max(height)))
}

fn row_extent(row: &Row) -> (f64, f64) {
    let items = row.iter().map(item_extent);
    let (width, height) = items.fold((0.0, LINE), |(width, height), (more, taller)| (width + more, taller.max(height)));
    let bracketed = (0..row.len()).filter(|place| is_bracketed_on_one_line(row, *place)).count();
    (width + 0.8 * bracketed as f64, height)
}

fn item_extent(item: &Item) -> (f64, f64) {
    let and = |extra: f64, row: &Row| {
        let (width, height) = row_extent(row);
        (width + extra, height)
    };
    match item {
        Item::Digits(digits) => (words_width(digits), LINE),
        Item::Letter(letter) => (letter_width(letter), LINE),
        Item::Bold(_) => (0.45, LINE),
        Item::Degree => (0.5, LINE),
        Item::Negation => (0.84, LINE),
        Item::Plus | Item::Minus | Item::Times | Item::Relation(_) => (1.48, LINE),
        Item::Beside => (0.2, LINE),
        Item::Gap => (0.35, LINE),
        Item::Fraction(top, bottom) => {
            // On one line beside each other where they cannot stand on one another.
            (row_extent(top).0 + row_extent(bottom).0 + 0.34 + 0.8 * f64::from(u8::from(top.len() > 1)), TALL)
        }
        Item::Root(inner) => and(0.7 + 0.8 * f64::from(u8::from(inner.len() > 1)), inner),
        Item::Power(base, exponent) => and(0.75 * row_extent(exponent).0, base),
        Item::Brackets(inner) => and(0.85, inner),
        Item::Bars(inner) => and(0.7, inner),
        Item::Call(function, power, argument) => {
            let raised = power.as_ref().map_or(0.0, |power| 0.75 * words_width(power));
            // On one line a fraction gets brackets behind the name.
            and(words_width(name(*function)) + raised + 0.6, argument)
        }
        Item::Unit(unit) => (words_width(unit_unicode(*unit)), LINE),
    }
}

/// Width of a part of a formula on a page, where the parts of a fraction stand on one another.
pub(super) fn width_on_page(row: &[Item]) -> f64 {
    let width = |item: &Item| match item {
        Item::Fraction(top, bottom) => width_on_page(top).max(width_on_page(bottom)) + 0.3,
        Item::Root(inner) => width_on_page(inner) + 0.9,
        Item::Power(base, exponent) => width_on_page(base) + 0.75 * width_on_page(exponent),
        Item::Brackets(inner) => width_on_page(inner) + 0.85,
        Item::Bars(inner) => width_on_page(inner) + 0.7,
        Item::Call(function, power, argument) => {
            let raised = power.as_ref().map_or(0.0, |power| 0.75 * words_width(power));
            words_width(name(*function)) + raised + 0.2 + width_on_page(argument)
        }
        item => item_extent(item).0,
    };
    row.iter().map(width).sum()
}

fn letter_width(letter: &Letter) -> f64 {
    let width = |symbol: &Symbol| match symbol {
        Symbol::Italic(text) | Symbol::Upright(text) => words_width(text),
        Symbol::Vector(_) | Symbol::Greek(..) => 0.65,
    };
    width(&letter.base) + letter.subscript.as_ref().map_or(0.0, |below| 0.75 * width(below))
}

fn words_width(words: &str) -> f64 {
    words.chars().map(character_width).sum()
}

/// In ems; those of DejaVu Serif, which is as wide as any that a page is likely to get.
fn character_width(character: char) -> f64 {
    match character {
        'i' | 'j' | 'l' | ' ' | '.' | ',' | '\'' | '’' => 0.32,
        'f' | 't' | 'I' | '(' | ')' => 0.4,
        'r' | 's' | 'z' | '⁻' | '⁰'..='⁹' | '¹' | '²' | '³' | '°' => 0.53,
        'c' | 'v' | 'x' | 'y' => 0.57,
        'w' => 0.86,
        'm' => 0.95,
        'M' | 'W' => 1.03,
        'A'..='Z' => 0.8,
        _ => 0.64,
    }
}
