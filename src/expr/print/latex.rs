//! Formulas as a careful teacher writes them in LaTeX; `amsmath` is not needed.

use super::layout::{Formula, Item, Row, is_tall};
use super::letter::{Letter, Symbol};
use super::unit::unit_latex;
use crate::expr::{Expr, Function, Relation};
use crate::unit::Unit;

/// The formula in LaTeX, without dollar signs.
///
/// ```
/// use carom::expr::{Expr, Function, print};
/// let component = Expr::product([
///     Expr::integer(2),
///     Expr::name("v"),
///     Expr::call(Function::Cos, Expr::name("alpha")),
/// ]);
/// assert_eq!(print::latex(&component), r"2v\cos\alpha");
/// ```
pub fn latex(expr: &Expr) -> String {
    let mut out = String::with_capacity(super::ROOM);
    write_latex(&Formula::of(expr).row(), &mut out);
    out
}

/// A value with its unit, without dollar signs.
pub fn latex_quantity(expr: &Expr, unit: Unit) -> String {
    let mut out = String::with_capacity(super::ROOM);
    write_latex(&Formula::of(expr).quantity(unit), &mut out);
    out
}

pub(super) fn write_latex(row: &Row, out: &mut String) {
    for item in row {
        write_item(item, out);
    }
}

/// Adds a piece, with a space if it would otherwise run into a command's name.
fn push(out: &mut String, piece: &str) {
    if piece.starts_with(|c: char| c.is_ascii_alphanumeric()) && ends_in_command(out) {
        out.push(' ');
    }
    out.push_str(piece);
}

fn ends_in_command(text: &str) -> bool {
    let command = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    command.len() < text.len() && command.ends_with('\\')
}

/// Adds a row between what opens it and what closes it.
fn enclose(open: &str, row: &Row, close: &str, out: &mut String) {
    out.push_str(open);
    write_latex(row, out);
    out.push_str(close);
}

fn write_item(item: &Item, out: &mut String) {
    match item {
        Item::Digits(digits) => push(out, digits),
        Item::Letter(letter) => write_letter(letter, out),
        Item::Bold(letter) => write_bold(*letter, out),
        Item::Degree => out.push_str(r"^\circ"),
        Item::Negation | Item::Minus => out.push('-'),
        Item::Plus => out.push('+'),
        Item::Times => out.push_str(r"\times"),
        Item::Beside => {}
        Item::Gap => out.push_str(r"\,"),
        Item::Relation(relation) => out.push_str(relation_sign(*relation)),
        Item::Fraction(top, bottom) => {
            enclose(r"\frac{", top, "}", out);
            enclose("{", bottom, "}", out);
        }
        Item::Root(inner) => enclose(r"\sqrt{", inner, "}", out),
        Item::Power(base, exponent) => {
            write_latex(base, out);
            enclose("^{", exponent, "}", out);
        }
        Item::Brackets(inner) if is_tall(inner) => enclose(r"\left(", inner, r"\right)", out),
        Item::Brackets(inner) => enclose("(", inner, ")", out),
        // A minus after a bare `|` would be set as if something stood before it.
        Item::Bars(inner) if is_tall(inner) || inner.first() == Some(&Item::Negation) => {
            enclose(r"\left|", inner, r"\right|", out);
        }
        Item::Bars(inner) => enclose("|", inner, "|", out),
        Item::Call(function, power, argument) => {
            push(out, command(*function));
            match power.as_deref() {
                Some(digits) if digits.len() == 1 => out.extend(["^", digits]),
                Some(digits) => out.extend(["^{", digits, "}"]),
                None => {}
            }
            let begin = out.len();
            write_latex(argument, out);
            if out[begin..].starts_with(|c: char| c.is_ascii_alphanumeric()) {
                out.insert(begin, ' ');
            }
        }
        Item::Unit(unit) => out.push_str(unit_latex(*unit)),
    }
}

fn write_bold(letter: char, out: &mut String) {
    out.push_str(r"\mathbf{");
    out.push(letter);
    out.push('}');
}

fn write_letter(letter: &Letter, out: &mut String) {
    match &letter.base {
        Symbol::Italic(text) => push(out, text),
        Symbol::Vector(letter) => write_bold(*letter, out),
        Symbol::Greek(name, _) => out.extend([r"\", name]),
        Symbol::Upright(text) => {
            out.push_str(r"\mathrm{");
            text.chars().for_each(|character| write_safe(character, out));
            out.push('}');
        }
    }
    match &letter.subscript {
        Some(Symbol::Greek(name, _)) => out.extend([r"_{\", name, "}"]),
        Some(Symbol::Vector(letter)) => out.extend(['_', *letter]),
        Some(Symbol::Italic(text) | Symbol::Upright(text)) if text.len() == 1 => out.extend(["_", text]),
        Some(Symbol::Italic(text) | Symbol::Upright(text)) => out.extend(["_{", text, "}"]),
        None => {}
    }
}

/// Adds a character of a name that is no letter: quantities come through, anything else becomes question marks.
fn write_safe(character: char, out: &mut String) {
    match character {
        '_' => out.push_str(r"\_"),
        c if c == '.' || c.is_ascii_alphanumeric() => out.push(c),
        _ => out.push('?'),
    }
}

fn command(function: Function) -> &'static str {
    match function {
        Function::Sqrt => r"\sqrt",
        Function::Sin => r"\sin",
        Function::Cos => r"\cos",
        Function::Tan => r"\tan",
        Function::Asin => r"\arcsin",
        Function::Acos => r"\arccos",
        Function::Atan => r"\arctan",
        Function::Abs => r"\mathrm{abs}",
    }
}

fn relation_sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => r"\neq",
        Relation::Less => "<",
        Relation::LessOrEqual => r"\leq",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => r"\geq",
        Relation::Implies => r"\Rightarrow",
        Relation::Approximately => r"\approx",
    }
}
