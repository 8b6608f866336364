//! What was read, as a terminal shows it.

use super::ranges;
use super::{Form, Notation, Said, Statement};
use crate::expr::{Expr, print};

/// The statements as a terminal shows them.
pub(super) fn shown(statements: &[Statement]) -> String {
    let each = |statement: &Statement| {
        let said: Vec<String> = statement.said.iter().map(printed).collect();
        let first = statement.said.first().map(|said| &said.form);
        let (equations, is_range) = (matches!(first, Some(Form::Equation(_))), matches!(first, Some(Form::Range(..))));
        let said = said.join(if equations { ", " } else { " = " });
        match &statement.label {
            Some(label) if is_range && said.starts_with(['(', '[']) => format!("{} ∈ {said}", label.typed),
            Some(label) if is_range => format!("{} {said}", label.typed),
            Some(label) => format!("{} = {said}", label.typed),
            None => said,
        }
    };
    statements.iter().map(each).collect::<Vec<_>>().join(", ")
}

/// A value as a terminal shows it.
fn printed(said: &Said) -> String {
    let mut out = match &said.form {
        Form::Value(value) | Form::Mixed(value) | Form::Equation(value) => print::unicode(value),
        Form::Percentage(value) => format!("{}%", print::unicode(value)),
        Form::Vector(x, y, Notation::Coordinates) => format!("({}, {})", print::unicode(x), print::unicode(y)),
        Form::Vector(x, y, _) => print::unicode(&Expr::Vector(Box::new(x.clone()), Box::new(y.clone()))),
        Form::Ratio(a, b) => format!("{} : {}", print::unicode(a), print::unicode(b)),
        Form::Range(low, high) => ranges::printed(low, high),
        Form::Gradient(value) => format!("gradient {}", print::unicode(value)),
        Form::AtRest => "at rest".to_owned(),
        Form::Direction => String::new(),
    };
    if let Some(unit) = &said.unit {
        match unit.degrees {
            true => out.push('°'),
            false => out.extend([" ", &unit.typed]),
        }
    }
    if let Some(line) = said.reference {
        if !out.is_empty() {
            out.push(' ');
        }
        out.push_str(line.words());
    }
    out
}
