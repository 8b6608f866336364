//! Ranges: the one place where two relations stand in a row, `1/3 < e <= 1`.

use super::parser::{Angles, read};
use crate::expr::{Expr, Fault, Relation};

/// Reads a formula, or a relation, or two inequalities in a row; those are a relation whose left side is the first.
///
/// ```
/// use carom::expr::{Angles, Expr, read_range};
/// let Expr::Relation(left, ..) = read_range("1/3 < e <= 1", Angles::Radians).unwrap() else { unreachable!() };
/// assert!(matches!(*left, Expr::Relation(..)));
/// ```
///
/// # Errors
///
/// As for [`read`], for each side.
pub fn read_range(text: &str, angles: Angles) -> Result<Expr, Fault> {
    let is_sign = |sign: char| matches!(sign, '<' | '>' | '≤' | '≥');
    let Some((second, _)) = text.char_indices().filter(|(_, sign)| is_sign(*sign)).nth(1) else {
        return read(text, angles);
    };
    let left = read(&text[..second], angles)?;
    let after = text[second..].trim_start_matches(|sign: char| is_sign(sign) || sign == '=');
    let start = text.len() - after.len();
    let relation = match &text[second..start] {
        "<" => Relation::Less,
        "<=" | "≤" => Relation::LessOrEqual,
        ">" => Relation::Greater,
        ">=" | "≥" => Relation::GreaterOrEqual,
        // Three in a row, or signs that are none: as it would be read without ranges.
        _ => return read(text, angles),
    };
    let right = read(after, angles).map_err(|mut fault| {
        fault.span.start += start;
        fault.span.end += start;
        fault
    })?;
    match right {
        Expr::Relation(..) => read(text, angles),
        right => Ok(Expr::Relation(Box::new(left), relation, Box::new(right))),
    }
}
