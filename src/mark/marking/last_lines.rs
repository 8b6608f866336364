//! What the last lines of a working are by their looks: a value alone, an inequality, an angle after its tangent.

use crate::bank::Find;
use crate::expr::{Expr, Function};
use crate::mark::judging::dimension;
use crate::mark::key::KeyedBlank;
use crate::mark::reading::{Form, Said, Statement};
use crate::mark::working::is_bare;
use crate::mechanics::Quantity;
use crate::unit::Unit;

/// What stands before the first equals sign and after the last, where there is a formula between them.
pub(super) fn name_and_end(line: &str) -> Option<String> {
    let (name, rest) = line.split_once('=')?;
    let (_, end) = rest.rsplit_once('=')?;
    Some(format!("{name}={end}"))
}

/// Is it an angle in degrees, or the tangent, sine or cosine of one?
pub(super) fn is_of_angle(statement: &Statement) -> bool {
    let name = statement.label.as_ref().and_then(|label| label.expr.as_ref());
    let is_ratio = matches!(name, Some(Expr::Call(Function::Tan | Function::Sin | Function::Cos, _)));
    is_ratio || statement.said.last().is_some_and(|said| said.unit.as_ref().is_some_and(|unit| unit.degrees))
}

/// Is it a value in the unit of an angle, an energy or an impulse that is asked, to three figures at least? Degrees are often left
/// out. Of fewer figures, or of a speed, it may be a value on the way; a root that is a speed or a magnitude is nothing else.
pub(super) fn has_own_unit(blank: &KeyedBlank, statements: &[Statement]) -> bool {
    let [Statement { label: None, said }] = statements else { return false };
    let is_size = |quantity: &Quantity| matches!(quantity, Quantity::Speed(..) | Quantity::ImpulseMagnitude);
    if let ([Said { form: Form::Value(expr), .. }], Find::Quantity(quantity)) = (said.as_slice(), &blank.find)
        && is_size(&quantity.of_its_impact())
        && has_root(expr)
        && is_bare(&statements[0])
    {
        return true;
    }
    let [Said { form: Form::Value(Expr::Decimal(figures)), unit, .. }] = said.as_slice() else { return false };
    let is_asked = match (&blank.find, unit) {
        (Find::Quantity(quantity), None) => quantity.is_angle(),
        (Find::Quantity(quantity), Some(unit)) if quantity.unit() != Unit::MetrePerSecond => {
            quantity.is_angle() && unit.degrees || dimension(quantity.unit()) == unit.dimension && !unit.degrees
        }
        _ => false,
    };
    is_asked && figures.chars().filter(char::is_ascii_digit).count() >= 3
}

/// `tan δ = 0.237, δ = 13.3°`: an angle, after its own tangent, sine or cosine.
pub(super) fn is_angle_after_its_ratio(statements: &[Statement]) -> bool {
    let name = |statement: &Statement| statement.label.as_ref().and_then(|label| label.expr.clone());
    match statements {
        [ratio, angle] => match (name(ratio), name(angle)) {
            (Some(Expr::Call(Function::Tan | Function::Sin | Function::Cos, of)), Some(angle)) => *of == angle,
            _ => false,
        },
        _ => false,
    }
}

/// Is it found by an inverse tangent, sine or cosine?
pub(super) fn is_inverse(said: &Said) -> bool {
    matches!(&said.form, Form::Value(Expr::Call(Function::Atan | Function::Asin | Function::Acos, _)))
}

/// May a line call its value by a name, or is it an inequality? That can be seen before it is read.
pub(super) fn calls_something(line: &str) -> bool {
    let name = line.split(['=', '<', '>', '≤', '≥', '≈', ':']).next().unwrap_or_default();
    name.len() < line.len() && name.contains(char::is_alphabetic) || line.contains(" is ")
}

/// Is a label a formula rather than a name: `w²`, `v(k + 1)` or `5w`?
pub(super) fn is_formula(label: &str) -> bool {
    label.starts_with(|sign: char| sign.is_ascii_digit())
        || label.contains(['+', '-', '−', '*', '×', '/', '(', '^', '²', '√'])
}

pub(super) fn is_inequality(text: &str) -> bool {
    text.contains(['<', '>', '≤', '≥'])
}

/// What is concluded in a line about a range: `e > 3/4` from `v < 0 so e > 3/4`.
pub(super) fn concluded(line: &str) -> &str {
    let ends = [" so ", "⇒", "=>", "∴", "hence ", "therefore ", "then ", "gives ", ","];
    let cuts = ends.iter().filter_map(|end| line.rfind(end).map(|at| at + end.len()));
    let cut = cuts.filter(|at| is_inequality(&line[..*at].replace("=>", ""))).max().unwrap_or_default();
    let end = line[cut..].trim();
    if is_inequality(end) { end } else { line }
}

fn has_root(expr: &Expr) -> bool {
    matches!(expr, Expr::Call(Function::Sqrt, _)) || expr.children().into_iter().any(has_root)
}
