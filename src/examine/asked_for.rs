//! Do the words of a part ask for this very answer: of this sphere, this angle, one value or a set of them?

use super::finding::Finding;
use super::sentence::{Sentence, Token, is_one_of, is_supposed, sentences};
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::expr::print;
use crate::mechanics::{Quantity, Sphere};

/// Answers for which the words of their part do not ask, though they ask for something of the kind.
pub fn others(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let all: Vec<Sentence> = part.ask.iter().flat_map(sentences).filter(|words| !is_supposed(words)).collect();
        for (row, answer) in part.answers.iter().enumerate() {
            let found =
                of_another(answer, part, &all).or_else(|| another_angle(answer, &all)).or_else(|| set(answer, &all));
            let help = "ask for what `find` finds, or find what is asked for";
            findings.extend(found.map(|found| found.with_help(help).at_row(place, "answers", row).as_warning()));
        }
    }
    findings
}

/// The words name one sphere, and the answer is of another.
fn of_another(answer: &Answer, part: &Part, asked: &[Sentence]) -> Option<Finding> {
    let own = sphere_of(&answer.find)?;
    let named = |sphere: Sphere| asked.iter().flatten().any(|token| *token == Token::Sphere(sphere));
    let is_of_both = asked.iter().flatten().any(|token| is_one_of(token, &["each", "both", "spheres", "their", "two"]));
    let other = Sphere::ALL.into_iter().find(|sphere| *sphere != own && named(*sphere))?;
    // A part whose result is printed need not name what it is of.
    if named(own) || is_of_both || part.answers.iter().any(|answer| answer.kind == Kind::Shown) {
        return None;
    }
    let (name, own, other) = (print::text_unicode(&answer.name), own.name(), other.name());
    let message = format!("the words ask of `*{other}*`, and the answer `{name}` is of *{own}*");
    Some(Finding::new(message, "", format!("found of {own}")))
}

/// The sphere whose speed, velocity, angle or energy is to be found.
fn sphere_of(find: &Find) -> Option<Sphere> {
    match find.quantities().first()?.of_its_impact() {
        Quantity::Speed(sphere, _)
        | Quantity::Velocity(sphere, ..)
        | Quantity::AngleToLine(sphere, _)
        | Quantity::AngleToWall(sphere, _)
        | Quantity::Deflection(sphere)
        | Quantity::SphereEnergyLost(sphere) => Some(sphere),
        _ => None,
    }
}

/// The words ask for the angle with a line, and the answer is the angle of deflection, or the other way round.
fn another_angle(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    const TURNED: [&str; 5] = ["deflect", "turn", "chang", "rotat", "through"];
    const LINES: [&str; 6] = ["line", "wall", "centres", "direction", "directions", "perpendicular"];
    let says_turned = asked
        .iter()
        .flatten()
        .any(|token| matches!(token, Token::Word(word) if TURNED.iter().any(|begin| word.starts_with(begin))));
    let names_line = asked.iter().flatten().any(|token| is_one_of(token, &LINES));
    let is_asked = asked.iter().flatten().any(|token| is_one_of(token, &["angle", "angles"]));
    let Find::Quantity(quantity) = &answer.find else { return None };
    if answer.kind == Kind::Shown || !is_asked {
        return None;
    }
    let (has, said) = match quantity.of_its_impact() {
        Quantity::Deflection(_) if !says_turned && names_line => ("through which the path is turned", "with a line"),
        Quantity::AngleToLine(..) | Quantity::AngleToWall(..) if says_turned && !names_line => {
            ("with a line", "through which the path is turned")
        }
        _ => return None,
    };
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for an angle {said}, and the answer `{name}` is one {has}");
    Some(Finding::new(message, "", "another angle"))
}

/// The words ask for one value, and the answer is a set of values.
fn set(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    const OF_SETS: [&str; 9] =
        ["values", "range", "set", "possible", "which", "inequality", "show", "greatest", "least"];
    let says = |words: &[&str]| asked.iter().flatten().any(|token| is_one_of(token, words));
    if answer.kind != Kind::Range || !says(&["value"]) || says(&OF_SETS) {
        return None;
    }
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for one value, and the answer `{name}` is a set of values");
    Some(Finding::new(message, "", "a set of values"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn words_that_ask_for_another_answer_are_found() {
        let table: [(&str, Edits, &str); 6] = [
            ("ranges/direction-reversed", &[], ""),
            ("ranges/direction-reversed", &[("set of possible values", "value")], "ask for one value"),
            ("rest-letters/direction-and-deflection", &[], ""),
            ("direct/restitution-from-one-speed", &[], ""),
            ("deflection/equal-masses", &[], ""),
            ("successive/three-in-a-line", &[], ""),
        ];
        for (id, edits, words) in table {
            let said: String = others(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
