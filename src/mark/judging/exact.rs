//! Is what a student wrote exactly equal to the model answer? Refuted by intervals, proved by the normal form.

use crate::expr::{Expr, Function, Meaning, Turn, evaluate, holds};
use crate::number::{Angle, Fraction, Letter, Range, Value};

use super::enclosure::{POINTS, at_point, enclose};

/// The precision of the enclosures that refute.
const BITS: usize = 96;

/// An answer with more roots, sines and the like than this goes to a person rather than through exact arithmetic.
const MOST_ROOTS: usize = 12;
/// The same below a fraction's line, where each root doubles the work.
const MOST_ROOTS_BELOW: usize = 4;
/// The longest number in an exact calculation, in bits: about 300 figures.
const LONGEST_NUMBER: usize = 1000;

/// Whether two expressions are equal for all their letters can stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Equality {
    Equal,
    Different,
    /// Neither proved nor refuted.
    Undecided,
}

/// The letter of that name; a capital is condoned where the question has only the small letter, or the reverse.
pub(super) fn letter<'a>(letters: &'a [Letter], name: &str) -> Option<&'a Letter> {
    letters.iter().find(|letter| letter.name() == name).or_else(|| {
        let single = name.len() == 1;
        letters.iter().find(|letter| single && letter.name().eq_ignore_ascii_case(name))
    })
}

/// What a name means where these are the letters.
pub(super) fn meaning_of(letters: &[Letter], name: &str) -> Option<Meaning> {
    let letter = letter(letters, name)?;
    Some(match letter.range() {
        Range::Acute => Meaning::Angle(Turn::of(Angle::of(&Value::letter(*letter), &Value::ONE)?)),
        _ => Meaning::Number(Value::letter(*letter)),
    })
}

/// The exact meaning; `None` if it has none, or takes too long.
pub(super) fn meaning(expr: &Expr, letters: &[Letter]) -> Option<Meaning> {
    if !is_manageable(expr) {
        return None;
    }
    evaluate(expr, &|name| meaning_of(letters, name)).ok()
}

/// The exact value, if it is a plain number or a formula.
pub(super) fn value(expr: &Expr, letters: &[Letter]) -> Option<Value> {
    match meaning(expr, letters)? {
        Meaning::Number(value) => Some(value),
        _ => None,
    }
}

/// A name that is neither a letter of the question nor a unit vector.
pub(super) fn unknown_letter(expr: &Expr, letters: &[Letter]) -> Option<String> {
    let names = expr.names();
    let known = |name: &str| matches!(name, "i" | "j") || letter(letters, name).is_some();
    names.iter().find(|name| !known(&name.text)).map(|name| name.text.clone())
}

/// Are the two equal, whatever their letters stand for?
pub(super) fn same(model: &Expr, student: &Expr, letters: &[Letter]) -> Equality {
    match measured(model, student, letters) {
        Some(Equality::Equal) | None => {}
        Some(decided) => return decided,
    }
    if !is_manageable(student) || !is_manageable(model) {
        return Equality::Undecided;
    }
    let equation = Expr::equation(model.clone(), student.clone());
    match holds(&equation, &|name| meaning_of(letters, name)) {
        Ok(Some(true)) => Equality::Equal,
        Ok(Some(false)) => Equality::Different,
        _ => at_points(&equation, letters),
    }
}

/// Enclosures at the points: `Different` if any keep apart, `Equal` if all meet, `None` if there are none.
fn measured(model: &Expr, student: &Expr, letters: &[Letter]) -> Option<Equality> {
    let points = if letters.is_empty() { 1 } else { POINTS };
    let mut met = false;
    for point in 0..points {
        let Some(right) = enclose(model, letters, point, BITS) else { continue };
        let Some(said) = enclose(student, letters, point, BITS) else { continue };
        if !right.overlaps(&said) {
            return Some(Equality::Different);
        }
        met = true;
    }
    met.then_some(Equality::Equal)
}

/// Does the equation hold exactly at fixed points? For forms that the normal form cannot take.
fn at_points(equation: &Expr, letters: &[Letter]) -> Equality {
    let mut held = 0;
    for point in 0..2 * POINTS {
        let names = |name: &str| {
            let letter = letter(letters, name)?;
            let value = Value::from(at_point(letter, point));
            Some(match letter.range() {
                Range::Acute => Meaning::Angle(Turn::of(Angle::of(&value, &Value::ONE)?)),
                _ => Meaning::Number(value),
            })
        };
        match holds(equation, &names) {
            Ok(Some(true)) => held += 1,
            Ok(Some(false)) => return Equality::Different,
            _ => {}
        }
    }
    // Two formulas of an exam that agree exactly at this many unrelated points are the same formula.
    if held >= POINTS && !letters.is_empty() { Equality::Equal } else { Equality::Undecided }
}

/// Is it short and shallow enough for exact arithmetic to be quick?
fn is_manageable(expr: &Expr) -> bool {
    roots(expr) <= MOST_ROOTS && below_lines(expr) && numbers(expr)
}

/// How many roots, sines and inverse sines are in it.
fn roots(expr: &Expr) -> usize {
    let own = match expr {
        Expr::Call(Function::Abs, _) => 0,
        Expr::Call(..) => 1,
        Expr::Power(_, exponent) => usize::from(!matches!(**exponent, Expr::Number(ref number) if number.is_integer())),
        _ => 0,
    };
    own + expr.children().into_iter().map(roots).sum::<usize>()
}

fn below_lines(expr: &Expr) -> bool {
    let below = match expr {
        Expr::Quotient(_, below) => roots(below),
        Expr::Power(base, exponent) if matches!(**exponent, Expr::Negative(_)) => roots(base),
        _ => 0,
    };
    below <= MOST_ROOTS_BELOW && expr.children().into_iter().all(below_lines)
}

fn numbers(expr: &Expr) -> bool {
    use dashu_int::ops::BitTest;
    let short = |number: &Fraction| {
        number.numerator().bit_len() <= LONGEST_NUMBER && number.denominator().bit_len() <= LONGEST_NUMBER
    };
    let own = match expr {
        Expr::Number(number) => short(number),
        Expr::Decimal(text) => text.len() <= LONGEST_NUMBER / 4,
        _ => true,
    };
    own && expr.children().into_iter().all(numbers)
}
