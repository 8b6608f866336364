//! Have letters of one kind all a unit, or none of them? A speed of *u* m/s is a number *u* of them; a speed *u* brings its
//! unit with it; and where one stands beside the other, the letters mean two things.

use std::collections::BTreeSet;

use super::given::with_letters;
use super::sentence::{Noun, Sentence, Token, is_one_of, owner_of, sentences};
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::expr::{Expr, print};
use crate::mechanics::Sphere;
use crate::unit::Unit;

/// A mass or a speed in letters, as the stem gives it.
struct Given<'q> {
    noun: Noun,
    owner: Sphere,
    expr: &'q Expr,
    unit: Unit,
}

/// Letters without a unit beside letters of the same kind that have one.
pub fn mixed(question: &Question) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    for style in &question.styles {
        let sentences: Vec<Sentence> = style.stem.iter().flat_map(sentences).collect();
        let given: Vec<Given> = sentences.iter().flat_map(|sentence| in_letters(sentence, question, style)).collect();
        for one in given.iter().filter(|one| one.unit == Unit::None) {
            let is_other =
                |other: &&Given| (other.noun, other.unit) == (one.noun, unit_of(one.noun)) && other.owner != one.owner;
            let Some(other) = given.iter().find(is_other) else { continue };
            let (name, other_name) = (print::plain(one.expr), print::plain(other.expr));
            let unit = other.unit.plain();
            let message = format!("`{other_name}` is said in {unit} and `{name}` without a unit, and both are letters");
            let found = Finding::new(message, format!("{{{name}}}"), format!("expected {unit}, as for `{other_name}`"));
            let help = format!("write `{{{name} {unit}}}`, or `{{{other_name}}}` without one");
            findings.push(found.with_help(help).as_warning());
        }
    }
    // Styles share most of their words.
    findings.sort_by(|one, other| one.message.cmp(&other.message));
    findings.dedup();
    findings
}

fn unit_of(noun: Noun) -> Unit {
    if noun == Noun::Mass { Unit::Kilogram } else { Unit::MetrePerSecond }
}

/// The masses and speeds of a sentence that are letters; of `masses 3m and 2m kg` each has the unit of the last.
fn in_letters<'q>(sentence: &Sentence<'q>, question: &Question, style: &Style) -> Vec<Given<'q>> {
    let unit = |place: usize| {
        let rest = &sentence[place..];
        let row = rest
            .iter()
            .take_while(|token| matches!(token, Token::Number(..) | Token::Comma) || is_one_of(token, &["and"]));
        let units = row.filter_map(|token| if let Token::Number(_, unit, _) = token { Some(*unit) } else { None });
        units.into_iter().find(|unit| *unit != Unit::None).unwrap_or(Unit::None)
    };
    let given = |(place, token): (usize, &Token<'q>)| {
        let Token::Number(expr, ..) = token else { return None };
        let (noun, owner) = owner_of(sentence, place)?;
        let names: BTreeSet<String> = expr.names().iter().map(|name| name.text.clone()).collect();
        let has_letters =
            with_letters(&names, style).iter().any(|name| question.scene.symbols.contains_key(name.as_str()));
        (matches!(noun, Noun::Mass | Noun::Speed) && has_letters).then(|| Given {
            noun,
            owner,
            expr,
            unit: unit(place),
        })
    };
    sentence.iter().enumerate().filter_map(given).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn letters_of_one_kind_have_all_a_unit_or_none() {
        let letters = "direct/velocities-in-letters";
        let (of_a, of_b) = ("of mass {mA} is", "of mass {mB}, which");
        let ratio = "ranges/mass-ratio-that-can-be";
        let table: [(&str, Edits, &str); 7] = [
            (letters, &[], ""),
            (letters, &[(of_b, "of mass {mB kg}, which")], "`mB` is said in kg and `mA` without a unit"),
            (letters, &[(of_a, "of mass {mA kg} is")], "`mA` is said in kg and `mB` without a unit"),
            (letters, &[(of_a, "of mass {mA kg} is"), (of_b, "of mass {mB kg}, which")], ""),
            (letters, &[(of_b, "of mass {3 kg}, which")], ""),
            (ratio, &[("{k*m} and {m}", "{k*m} and {m kg}")], ""),
            (ratio, &[("{k*m} and {m}", "{k*m kg} and {m}")], "`k*m` is said in kg and `m` without a unit"),
        ];
        for (id, edits, words) in table {
            let said: String = mixed(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
