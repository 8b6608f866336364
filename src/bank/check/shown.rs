//! The left side of what is to be shown: it must stand for what is found, and for nothing else.

use super::super::document::Faults;
use super::super::file::{DomainFile, QuestionFile, StyleFile};
use super::super::literal::Words;
use super::super::question::{Find, Part};
use crate::expr::{Angles, Expr, Function, print, read};
use crate::mechanics::Quantity;

/// Left sides that say something else than the answer finds.
pub fn shown(parts: &[Part], file: &QuestionFile, faults: &mut Faults) {
    let answers = parts.iter().flat_map(|part| &part.answers);
    for (answer, written) in answers.zip(file.parts.iter().flat_map(|part| &part.answers)) {
        let (Find::Quantity(quantity), Some(show), Some(words)) = (&answer.find, &answer.show, &written.show) else {
            continue;
        };
        let is_tangent = is_tangent(quantity.of_its_impact());
        let letter = match show {
            Expr::Name(letter) => &letter.text,
            Expr::Call(Function::Tan, inner) if is_tangent => match &**inner {
                Expr::Name(letter) => &letter.text,
                _ => continue,
            },
            _ => {
                let message = format!("`{}` is shown, but `{quantity}` is found", words.get_ref());
                let meant = angle(show).unwrap_or_else(|| "beta".to_owned());
                let (label, help) = match is_tangent {
                    true => ("expected a tangent", format!("write `show = \"tan({meant})\"`, or find what is shown")),
                    false => {
                        ("expected a letter for it", "write a letter that you declare in `[scene.symbols]`".to_owned())
                    }
                };
                faults.report(words.span(), message, label, help);
                continue;
            }
        };
        of_letter(letter, words, matches!(show, Expr::Name(_)), file, faults);
    }
}

/// The letter must be free in the scene; one that stands for a result is declared, so that the working keeps clear of it.
fn of_letter(letter: &str, words: &Words, is_alone: bool, file: &QuestionFile, faults: &mut Faults) {
    let Some(scene) = &file.scene else { return };
    let formulas =
        scene.places.iter().filter(|(path, _)| !path.starts_with("symbols") && !path.starts_with("unknowns"));
    let own = |style: &'_ StyleFile| (style.parameters.clone(), style.lets.clone());
    let (parameters, lets): (Vec<_>, Vec<_>) = file.styles.iter().map(own).unzip();
    let parameters: Vec<_> = file.parameters.iter().chain(parameters.iter().flatten()).collect();
    let lets: Vec<_> = file.lets.iter().chain(lets.iter().flatten()).collect();
    let values = parameters.iter().flat_map(|(_, domain)| match domain {
        DomainFile::List(items, _) => items.as_slice(),
        DomainFile::Range(range) => std::slice::from_ref(range),
    });
    let names = |words: &Words| read(words.get_ref(), Angles::Degrees).is_ok_and(|expr| has_name(&expr, letter));
    let is_number = parameters.iter().any(|(name, _)| name.get_ref() == letter)
        || lets.iter().any(|(name, formula)| name.get_ref() == letter || names(formula));
    if is_number || values.into_iter().any(names) || formulas.into_iter().any(|(_, formula)| names(formula)) {
        let message = format!("`{letter}` is given, and shown to be something else");
        faults.report(words.span(), message, "the question has a value for it", "take another letter in `show`");
    } else if is_alone && !scene.letters().contains(&letter) {
        let message = format!("`{letter}` in `show` is no letter of the scene");
        let label = "the working may use it for something else";
        let help =
            format!("declare it, `{letter} = \"positive\"` in `[scene.symbols]`: the working then keeps clear of it");
        faults.report(words.span(), message, label, help);
    }
}

fn has_name(expr: &Expr, letter: &str) -> bool {
    expr.names().iter().any(|name| name.text == letter)
}

/// Is it the tangent of an angle?
pub(super) fn is_tangent(quantity: Quantity) -> bool {
    use Quantity::{TOverN, TanDeflection, TanToLine, TanToWall};
    matches!(quantity, TOverN(..) | TanDeflection(_) | TanToLine(..) | TanToWall(..))
}

/// The angle of which a function is taken.
fn angle(expr: &Expr) -> Option<String> {
    match expr {
        Expr::Call(_, inner) => Some(print::plain(inner)),
        _ => expr.children().into_iter().find_map(angle),
    }
}
