//! A formula beside the value of a letter in it, as `e tan α, e = 1/3` or `e tan α where e = 1/3`, where the answer has no
//! such letter.

use crate::expr::Expr;
use crate::mark::reading::{Form, Reading, Said, Statement, read_answer};

use super::{Model, by_kind};

/// Does the formula come to the answer with the values that are told beside it? Whether that is the answer, a person sees.
pub(super) fn come_to_the_answer(model: &Model, reading: &Reading) -> bool {
    let (values, formulas): (Vec<&Statement>, Vec<&Statement>) =
        reading.statements.iter().partition(|statement| value_of_letter(model, statement).is_some());
    let mut values: Vec<(String, Expr)> = values.iter().filter_map(|value| value_of_letter(model, value)).collect();
    values.extend(reading.remarks().flat_map(|remark| told_in_words(model, remark)));
    let put_in = |statement: &Statement| {
        let said = statement.said.iter().map(|said| match &said.form {
            Form::Value(formula) => Said { form: Form::Value(with(formula, &values)), ..said.clone() },
            _ => said.clone(),
        });
        Statement { said: said.collect(), ..statement.clone() }
    };
    let has_letter = |said: &Said| match &said.form {
        Form::Value(formula) => {
            formula.names().iter().any(|name| values.iter().any(|(letter, _)| *letter == name.text))
        }
        _ => false,
    };
    let is_open = formulas.iter().flat_map(|statement| &statement.said).any(has_letter);
    is_open && {
        let statements = formulas.iter().map(|formula| put_in(formula)).collect();
        by_kind(model, &Reading { statements, ..reading.clone() }).is_credited()
    }
}

/// `e = 1/3`, where the question has an e and the answer has none.
fn value_of_letter(model: &Model, statement: &Statement) -> Option<(String, Expr)> {
    let Some(Expr::Name(letter)) = statement.label.as_ref().and_then(|label| label.expr.as_ref()) else { return None };
    let is_of_question = model.vocabulary.letters.iter().any(|own| own.name() == letter.text);
    let is_asked = model.letter.as_ref() == Some(&letter.text) || model.value.names().contains(&letter);
    match &statement.said.last()?.form {
        Form::Value(value) if is_of_question && !is_asked && value.names().is_empty() => {
            Some((letter.text.clone(), value.clone()))
        }
        _ => None,
    }
}

/// `where e = 1/3`
fn told_in_words(model: &Model, remark: &str) -> Vec<(String, Expr)> {
    let told = remark.strip_prefix("where ").filter(|told| told.contains('='));
    let readings = told.and_then(|told| read_answer(told, &model.vocabulary).ok());
    let statements = readings.iter().flatten().take(1).flat_map(|reading| &reading.statements);
    statements.filter_map(|statement| value_of_letter(model, statement)).collect()
}

fn with(formula: &Expr, values: &[(String, Expr)]) -> Expr {
    formula.substitute(&|name| values.iter().find(|(letter, _)| letter == name).map(|(_, value)| value.clone()))
}
