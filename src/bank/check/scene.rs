//! The scene checked as far as it can be without numbers: its formulas, letters and conditions.

use super::super::document::{Faults, listed};
use super::super::requirement::sentence_fault;
use super::super::scene_file::SceneFile;
use super::super::scene_names::given_unknowns;
use super::names::{Also, NamesUsed};
use super::quantities;
use crate::diagnostic::near;
use crate::expr::{Angles, Expr, read};
use crate::mechanics::{Quantity, SceneText, Sphere, VelocityText, is_sentence};
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
        // What has been read and is no formula.
        if path.ends_with("sense") {
            continue;
        }
        match path.split(['.', '[']).next().unwrap_or_default() {
            "symbols" => {
                if !Range::DECLARED.iter().any(|(name, _)| *name == text) {
                    let names = Range::DECLARED.map(|(name, _)| name);
                    let label = format!("expected {}", listed(&names));
                    faults.unknown(words.span(), format!("unknown range `{text}`"), label, text, names);
                }
            }
            "unknowns" => {
                const NEEDS_NO_RANGE: [&str; 3] = ["e", "A.mass", "B.mass"];
                let letters: Vec<&str> = file.text.symbols.keys().map(String::as_str).collect();
                let implied = NEEDS_NO_RANGE.into_iter().filter(|name| !letters.contains(name));
                let letters: Vec<&str> = letters.iter().copied().chain(implied).collect();
                if matches!(read(text, Angles::Degrees), Ok(Expr::Name(_))) {
                    if !letters.contains(&text) {
                        let help = near(text, letters.iter().copied()).map_or_else(
                            || format!("declare it in `[scene.symbols]`, as in `{text} = \"positive\"`, or name one of those"),
                            |meant| format!("did you mean `{meant}`?"),
                        );
                        let label = format!("expected one of {}", listed(&letters));
                        faults.report(words.span(), format!("unknown letter `{text}`"), label, help);
                    }
                } else {
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
            "before" | "after" | "then" if is_rest(path, text) => {
                let is_in_a_plane = is_in_a_plane(&file.text);
                let nought = if is_in_a_plane { "[\"0\", \"0\"]" } else { "\"0\"" };
                let label = if is_in_a_plane { "expected components along i and along j" } else { "expected a value" };
                faults.report(
                    words.span(),
                    "a velocity in words",
                    label,
                    format!("write `{nought}` for a sphere at rest"),
                );
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

/// Is it a whole velocity, and the words `at rest`?
fn is_rest(path: &str, text: &str) -> bool {
    let is_velocity =
        ["before", "after"].iter().any(|key| path.trim_end_matches(".A").trim_end_matches(".B").ends_with(key));
    let mut words = text.split_whitespace().map(str::to_lowercase);
    is_velocity && words.any(|word| ["rest", "stationary", "still"].contains(&word.as_str()))
}

/// Has some velocity two components, or is there a line of centres that a line needs not?
fn is_in_a_plane(scene: &SceneText) -> bool {
    let velocities = [&scene.before.a, &scene.before.b, &scene.after.a, &scene.after.b];
    let of_two = |velocity: &VelocityText<String>| !matches!(velocity, VelocityText::Along(_));
    scene.line_of_centres.is_some() || velocities.into_iter().flatten().any(of_two)
}
