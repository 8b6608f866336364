//! Letters that stand in formulas with others, `{k*m}`, and of which no word says what they are.

use std::collections::BTreeSet;

use super::given::{names_in, origins};
use super::sentence::{Sentence, Token, is_one_of, sentences};
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::expr::{Expr, print};

/// Letters that multiply others, and those of a vector that are to be found, which never stand alone but where their value
/// is asked for. Of the components of `the velocity (u*i + v*j)` the words have said enough.
pub fn never(question: &Question) -> Vec<Finding> {
    let letters = question.scene.symbols.iter().filter(|(_, range)| range.as_str() != "acute");
    let found = letters.filter_map(|(letter, range)| {
        let at = question.styles.iter().find_map(|style| not_introduced(question, style, letter))?;
        let message = format!("the words never say what `{letter}` is");
        let constant = if range == "real" { "constant" } else { "positive constant" };
        let help = format!("say it where it first stands, as in `where {{{letter}}} is a {constant}`");
        Some(Finding::new(message, at, "a student has to guess").with_help(help).as_warning())
    });
    found.collect()
}

/// The words that lead to the first formula with a letter which no sentence of a style introduces.
fn not_introduced(question: &Question, style: &Style, letter: &str) -> Option<String> {
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    let said: Vec<Sentence> = style.stem.iter().chain([&style.note]).chain(asks).flat_map(sentences).collect();
    let symbols = |expr: &Expr| -> BTreeSet<String> {
        let all = origins(&names_in(&print::plain(expr)), style);
        all.into_iter().filter(|name| question.scene.symbols.contains_key(name)).collect()
    };
    let is_open = question.scene.unknowns.iter().any(|unknown| unknown == letter);
    let mut first = None;
    for sentence in &said {
        for (place, token) in sentence.iter().enumerate() {
            let Token::Number(expr, _, lead) = token else { continue };
            let has = symbols(expr);
            if !has.contains(letter) {
                continue;
            }
            let is_vector = matches!(expr, Expr::Vector(..));
            match expr {
                Expr::Name(name) if name.text == letter && is_asked_for(&sentence[..place]) => {}
                // `Where {k > 1}` says enough.
                Expr::Relation(..) => return None,
                _ if (has.len() > 1 && !is_vector) || (is_vector && is_open) => {
                    first = first.or_else(|| Some(lead.split_whitespace().collect::<Vec<_>>()));
                }
                _ => return None,
            }
        }
    }
    first.map(|words| words[words.len().saturating_sub(4)..].join(" "))
}

/// Do words lead to what is asked for: `the value of`, `in terms of`, `find`?
fn is_asked_for(before: &[Token]) -> bool {
    match before {
        [.., noun, of] if is_one_of(of, &["of"]) => is_one_of(noun, &["value", "values", "terms"]),
        [.., find] => is_one_of(find, &["find"]),
        [] => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn a_letter_is_introduced_where_it_stands_alone_and_is_not_asked_for() {
        let (ratio, size) = ("ranges/mass-ratio-that-can-be", "vector-impulse/size-of-the-impulse");
        let constant = ", where {k} is a positive constant";
        let table: [(&str, Edits, &str); 8] = [
            (ratio, &[], ""),
            (ratio, &[(constant, "")], "never say what `k` is"),
            (ratio, &[(constant, ", where {k > 0}")], ""),
            (size, &[], ""),
            (size, &[(constant, "")], "never say what `k` is"),
            (size, &[(constant, "")], "where {k} is a positive constant"),
            (ratio, &[(constant, ""), ("k = \"positive\"", "k = \"real\"")], "where {k} is a constant"),
            ("direct/velocities-in-letters", &[], ""),
        ];
        for (id, edits, words) in table {
            let said: Vec<_> = never(&edited(id, edits)).into_iter().map(|found| (found.message, found.help)).collect();
            let said = if said.is_empty() { String::new() } else { format!("{said:?}") };
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
