//! The reference numbers checked: one for each parameter of a style.

use super::super::document::{Faults, listed};
use super::super::file::QuestionFile;
use super::super::question::Style;
use super::names::{Also, NamesUsed};
use crate::expr::{Angles, Expr, read_as_written};

/// The reference numbers, and the style whose parameters they are.
pub fn reference(
    file: &QuestionFile,
    styles: &[Style],
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> (Vec<(String, Expr)>, usize) {
    let mut found = Vec::new();
    for (name, words) in &file.reference {
        match read_as_written(words.get_ref(), Angles::Degrees) {
            Ok(expr) => {
                used.expression(words, &expr, Also::OnlyLetters, None, faults);
                found.push((name.get_ref().clone(), expr));
            }
            Err(fault) => {
                faults.expression(words, fault);
                found.push((name.get_ref().clone(), Expr::integer(1)));
            }
        }
    }
    let missing = |style: &Style| -> Vec<String> {
        let names = style.parameters.iter().map(|(name, _)| name);
        names.filter(|name| !found.iter().any(|(known, _)| known == *name)).cloned().collect()
    };
    let excess =
        |style: &Style| found.iter().filter(|(name, _)| !style.parameters.iter().any(|(n, _)| n == name)).count();
    let distance = |index: &usize| missing(&styles[*index]).len() + excess(&styles[*index]);
    let Some(best) = (0..styles.len()).min_by_key(distance) else { return (found, 0) };
    let style = &styles[best];
    if let Some(span) = &file.reference_span {
        for name in missing(style) {
            faults.report(
                span.clone(),
                format!("no reference value for parameter `{name}`"),
                format!("expected one for each parameter of style `{}`", style.name),
                format!("add `{name} = \"…\"`"),
            );
        }
    }
    for (name, _) in &file.reference {
        let text = name.get_ref().as_str();
        let known: Vec<&str> = style.parameters.iter().map(|(name, _)| name.as_str()).collect();
        if !known.contains(&text) {
            let label = format!("style `{}` has {}", style.name, listed(&known));
            let missing = missing(style);
            let missing = missing.iter().map(String::as_str);
            faults.unknown(name.span(), format!("`{text}` is no parameter"), label, text, missing);
        }
    }
    (found, best)
}
