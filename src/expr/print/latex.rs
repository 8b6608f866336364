//! Formulas as a careful teacher writes them in LaTeX; `amsmath` is not needed.

use super::layout::{Item, Row, is_tall, layout};
use super::letter::{Letter, Symbol};
use super::unit::unit_latex;
use crate::expr::{Expr, Function, Relation};

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
    latex_row(&layout(expr))
}

pub(super) fn latex_row(row: &Row) -> String {
    let mut out = String::new();
    for item in row {
        write_item(item, &mut out);
    }
    out
}

/// Adds a piece, with a space if it would otherwise run into a command's name.
fn push(out: &mut String, piece: &str) {
    let command = out.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let in_command = command.len() < out.len() && command.ends_with('\\');
    if in_command && piece.starts_with(|c: char| c.is_ascii_alphanumeric()) {
        out.push(' ');
    }
    out.push_str(piece);
}

fn write_item(item: &Item, out: &mut String) {
    match item {
        Item::Digits(digits) => push(out, digits),
        Item::Letter(letter) => push(out, &written(letter)),
        Item::Bold(letter) => out.push_str(&format!(r"\mathbf{{{letter}}}")),
        Item::Degree => out.push_str(r"^\circ"),
        Item::Negation | Item::Minus => out.push('-'),
        Item::Plus => out.push('+'),
        Item::Times => out.push_str(r"\times"),
        Item::Beside => {}
        Item::Gap => out.push_str(r"\,"),
        Item::Relation(relation) => out.push_str(relation_sign(*relation)),
        Item::Fraction(top, bottom) => out.push_str(&format!(r"\frac{{{}}}{{{}}}", latex_row(top), latex_row(bottom))),
        Item::Root(inner) => out.push_str(&format!(r"\sqrt{{{}}}", latex_row(inner))),
        Item::Power(base, exponent) => {
            push(out, &latex_row(base));
            out.push_str(&format!("^{{{}}}", latex_row(exponent)));
        }
        Item::Brackets(inner) if is_tall(inner) => {
            out.push_str(&format!(r"\left({}\right)", latex_row(inner)));
        }
        Item::Brackets(inner) => out.push_str(&format!("({})", latex_row(inner))),
        // A minus after a bare `|` would be set as if something stood before it.
        Item::Bars(inner) if is_tall(inner) || inner.first() == Some(&Item::Negation) => {
            out.push_str(&format!(r"\left|{}\right|", latex_row(inner)));
        }
        Item::Bars(inner) => out.push_str(&format!("|{}|", latex_row(inner))),
        Item::Call(function, power, argument) => {
            push(out, command(*function));
            let argument = latex_row(argument);
            match power {
                Some(digits) if digits.len() == 1 => out.push_str(&format!("^{digits}")),
                Some(digits) => out.push_str(&format!("^{{{digits}}}")),
                None => {}
            }
            if argument.starts_with(|c: char| c.is_ascii_alphanumeric()) {
                out.push(' ');
            }
            out.push_str(&argument);
        }
        Item::Unit(unit) => out.push_str(&unit_latex(*unit)),
    }
}

fn written(letter: &Letter) -> String {
    let mut out = match &letter.base {
        Symbol::Italic(text) => text.clone(),
        Symbol::Vector(letter) => format!(r"\mathbf{{{letter}}}"),
        Symbol::Greek(name, _) => format!(r"\{name}"),
        Symbol::Upright(text) => format!(r"\mathrm{{{}}}", safe(text)),
    };
    match &letter.subscript {
        Some(Symbol::Greek(name, _)) => out.push_str(&format!(r"_{{\{name}}}")),
        Some(Symbol::Vector(letter)) => out.push_str(&format!("_{letter}")),
        Some(Symbol::Italic(text) | Symbol::Upright(text)) if text.len() == 1 => out.push_str(&format!("_{text}")),
        Some(Symbol::Italic(text) | Symbol::Upright(text)) => out.push_str(&format!("_{{{text}}}")),
        None => {}
    }
    out
}

/// A name that is no letter: quantities come through, anything else becomes question marks.
fn safe(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '_' => r"\_".to_owned(),
            '.' => ".".to_owned(),
            c if c.is_ascii_alphanumeric() => c.to_string(),
            _ => "?".to_owned(),
        })
        .collect()
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
