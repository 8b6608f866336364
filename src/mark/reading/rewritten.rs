//! The same reading with other formulas: `cos a` written as the `cos α` that it stands for.

use super::{End, Form, Label, Reading, Said, Statement, printed};
use crate::expr::{Expr, print};

impl Reading {
    /// What these statements say with other formulas in them, also in what they are called.
    pub(in crate::mark) fn with(statements: &[Statement], put: &dyn Fn(&Expr) -> Expr) -> Reading {
        let said = |said: &Said| Said { form: form(&said.form, put), ..said.clone() };
        let label = |label: &Label| {
            let expr = label.expr.as_ref().map(put);
            let typed = match &expr {
                Some(changed) if expr != label.expr => print::unicode(changed),
                _ => label.typed.clone(),
            };
            Label { typed, expr }
        };
        let statement = |statement: &Statement| Statement {
            label: statement.label.as_ref().map(label),
            said: statement.said.iter().map(said).collect(),
        };
        let statements: Vec<Statement> = statements.iter().map(statement).collect();
        Reading { printed: printed::shown(&statements), statements, decided: Vec::new() }
    }
}

fn form(form: &Form, put: &dyn Fn(&Expr) -> Expr) -> Form {
    let end = |end: &Option<End>| end.as_ref().map(|end| End { at: put(&end.at), ..end.clone() });
    match form {
        Form::Value(value) => Form::Value(put(value)),
        Form::Percentage(value) => Form::Percentage(put(value)),
        Form::Vector(x, y, notation) => Form::Vector(put(x), put(y), *notation),
        Form::Mixed(value) => Form::Mixed(put(value)),
        Form::Ratio(one, other) => Form::Ratio(put(one), put(other)),
        Form::Equation(equation) => Form::Equation(put(equation)),
        Form::Range(low, high) => Form::Range(end(low), end(high)),
        Form::Gradient(value) => Form::Gradient(put(value)),
        Form::AtRest => Form::AtRest,
        Form::Direction => Form::Direction,
    }
}
