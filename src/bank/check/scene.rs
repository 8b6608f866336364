//! The scene checked as far as it can be without numbers: its formulas, letters and conditions.

use super::super::document::{Faults, listed};
use super::super::requirement::sentence_fault;
use super::super::scene_file::SceneFile;
use super::super::scene_names::given_unknowns;
use super::names::{Also, NamesUsed};
use super::quantities;
use crate::expr::{Angles, Expr, read};
use crate::mechanics::{Quantity, Sphere, is_sentence};
use crate::number::Range;

/// Reads every formula of the scene.
pub fn scene(file: &SceneFile, used: &mut NamesUsed, faults: &mut Faults) {
    for found in given_unknowns(&file.text) {
        if let Some(words) = file.words(&found.field) {
            faults.expression(words, found.fault);
        }
    }
    for (what, key) in [("the letter", "unknowns["), ("the condition", "conditions[")] {
        let rows = file.places.iter().filter(|(path, _)| path.starts_with(key));
        faults.twice(what, &[], &rows.map(|(_, words)| words.clone()).collect::<Vec<_>>());
    }
    for (path, words) in &file.places {
        let text = words.get_ref().as_str();
        match path.split(['.', '[']).next().unwrap_or_default() {
            "symbols" => {
                if !Range::DECLARED.iter().any(|(name, _)| *name == text) {
                    let names = Range::DECLARED.map(|(name, _)| name);
                    let label = format!("expected {}", listed(&names));
                    faults.unknown(words.span(), format!("unknown range `{text}`"), label, text, names);
                }
            }
            "unknowns" => {
                if !matches!(read(text, Angles::Degrees), Ok(Expr::Name(_))) {
                    faults.report(
                        words.span(),
                        format!("`{text}` is no letter"),
                        "expected the name of what is to be found",
                        "name a letter of `[scene.symbols]`, `e`, `A.mass` or `B.mass`",
                    );
                }
            }
            "maximise" => {
                if text.parse::<Quantity>().is_err() {
                    quantities::unknown(words, &[], faults);
                }
            }
            "then" if path.contains("].of[") => {
                let names = Sphere::ALL.map(Sphere::name);
                if !names.contains(&text) {
                    let label = format!("expected {}", listed(&names));
                    faults.unknown(words.span(), format!("unknown sphere `{text}`"), label, text, names);
                }
            }
            "conditions" if is_sentence(text) => faults.expression(words, sentence_fault("a condition in words", text)),
            "conditions" => match read(text, Angles::Degrees) {
                Ok(expr @ Expr::Relation(..)) => used.expression(words, &expr, Also::Quantities, None, faults),
                Ok(_) => {
                    let help = format!("write `{text} = 0`");
                    faults.report(words.span(), "a condition without `=`", "expected an equation", help);
                }
                Err(fault) => faults.expression(words, fault),
            },
            _ => match read(text, Angles::Degrees) {
                Ok(Expr::Relation(..)) => {
                    let help = "put equations into `conditions`";
                    faults.report(words.span(), format!("`{path}` is an equation"), "expected a value", help);
                }
                Ok(expr) => used.expression(words, &expr, Also::Nothing, None, faults),
                Err(fault) => faults.expression(words, fault),
            },
        }
    }
}
