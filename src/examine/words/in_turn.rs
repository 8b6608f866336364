//! Numbers of two spheres in one row: `their speeds are {u} and {w} respectively`, `the angles are {a} for *A* and {b} for *B*`.

use super::sentence::{Noun, Token, is_one_of, measured_from, noun_of};
use crate::mechanics::Sphere;

/// The spheres of a sentence in the order in which they are named first, or those before if it names none.
pub fn named_in_turn(sentence: &[Token], before: Vec<Sphere>) -> Vec<Sphere> {
    let mut named = Vec::new();
    for token in sentence {
        if let Token::Sphere(sphere) = token
            && !named.contains(sphere)
        {
            named.push(*sphere);
        }
    }
    if named.is_empty() { before } else { named }
}

/// Whose a number of a row is that belongs to `them`, the spheres of the sentence before; in a sentence that names none but
/// behind the row.
pub fn of_them(sentence: &[Token], place: usize, them: &[Sphere]) -> Option<(Noun, Sphere)> {
    let (at, noun, is_plural) = noun_of(sentence, place)?;
    let is_theirs = at > 0 && is_one_of(&sentence[at - 1], &["their"]);
    let names_any = sentence[..place].iter().any(|token| matches!(token, Token::Sphere(_)));
    let is_number = |token: &&Token| matches!(token, Token::Number(..));
    let nth = sentence[at..place].iter().filter(is_number).count();
    let row = sentence[place..].iter().take_while(|token| is_of_row(token)).filter(is_number).count();
    let is_whole = nth + row == them.len();
    them.get(nth).filter(|_| is_theirs && is_plural && !names_any && is_whole).map(|sphere| (noun, *sphere))
}

/// The words that tell from which line an angle of a row is measured: behind the whole row, or before it, `the angles between
/// their paths and the line of centres are {a} and {b}`.
pub fn lines_of_row<'s, 't>(sentence: &'s [Token<'t>], place: usize) -> &'s [Token<'t>] {
    let is_passed = |token: &&Token| is_of_row(token) || is_one_of(token, &["respectively", "for"]);
    let is_passed = |token: &&Token| is_passed(token) || matches!(token, Token::Sphere(_));
    let behind = place + 1 + sentence[place + 1..].iter().take_while(is_passed).count();
    let is_row = sentence[place + 1..behind].iter().any(|token| matches!(token, Token::Number(..)));
    let after = &sentence[if is_row { behind } else { place + 1 }..];
    match noun_of(sentence, place) {
        Some((at, Noun::Angle, _)) if measured_from(after).is_none() => {
            let first = at + sentence[at..place].iter().take_while(|token| !matches!(token, Token::Number(..))).count();
            // The line stands on either side of `and`.
            let and = sentence[at..first].iter().rposition(|token| is_one_of(token, &["and"]));
            let sides = and.map(|and| [&sentence[at + and..first], &sentence[at..at + and]]);
            // `Inclined to the wall at an angle {a}`
            let lead = sentence[..at].iter().rposition(|token| is_one_of(token, &["inclined"]));
            let lead = lead.map(|lead| &sentence[lead + 1..at]).filter(|lead| {
                lead.len() < 12 && !lead.iter().any(|token| matches!(token, Token::Number(..) | Token::Comma))
            });
            let named = sides.into_iter().flatten().chain(lead).find(|side| measured_from(side).is_some());
            named.unwrap_or(&sentence[at..first])
        }
        _ => after,
    }
}

fn is_of_row(token: &Token) -> bool {
    matches!(token, Token::Number(..) | Token::Comma) || is_one_of(token, &["and"])
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::said;

    #[test]
    fn numbers_in_a_row_are_of_the_spheres_in_turn() {
        let line = "direct/one-sphere-catches-the-other";
        let speeds = "The speed of *A* is {u m/s} and the speed of *B* is {w m/s}. The";
        let both = "both-moving/energy-lost-and-impulse";
        let path = "Immediately before the collision *A* has speed {uA m/s} and its direction of motion makes an acute angle of {alpha deg}\n\
                    with the line of centres of the spheres; *B* has speed {uB m/s} and its direction of motion makes an acute angle of\n\
                    {beta deg} with the line of centres.";
        let angles = |from: &str, row: &str| {
            format!(
                "*A* and *B* have speeds {{uA m/s}} and {{uB m/s}}. The angles between their directions of motion and \
                 {from}, both acute, are {row}."
            )
        };
        let (loc, across) = ("the line of centres", "the line perpendicular to the line of centres");
        let (row, crossed) =
            ("{alpha deg} for *A* and {beta deg} for *B*", "{beta deg} for *A* and {alpha deg} for *B*");
        let [so, crossed, across] = [angles(loc, row), angles(loc, crossed), angles(across, row)];
        let behind = |line: &str| {
            format!(
                "*A* and *B* have speeds {{uA m/s}} and {{uB m/s}}, and their directions of motion make acute angles of \
                 {{alpha deg}} and {{beta deg}} respectively with {line}."
            )
        };
        let [behind, wrong] = [behind(loc), behind("the common tangent")];
        let wall = "walls/rebound-speed-and-direction";
        let makes = "its direction of motion makes an acute angle of\n{alpha deg} with the wall";
        let table = [
            (wall, makes, "its path is inclined to the wall at an acute angle of {alpha deg}", ""),
            (
                wall,
                makes,
                "its path is inclined to the normal to the wall at an acute angle of {alpha deg}",
                "the angle",
            ),
            (line, speeds, "Their speeds are {u m/s} and {w m/s} respectively. The", ""),
            (line, speeds, "Their speeds are {w m/s} and {u m/s} respectively. The", "give `*A*` the speed `w`"),
            (
                line,
                speeds,
                "Their speeds just before they meet are {w m/s} and {u m/s}. The",
                "give `*A*` the speed `w`",
            ),
            (both, path, so.as_str(), ""),
            (both, path, crossed.as_str(), "give `*A*` the angle `beta`"),
            (both, path, across.as_str(), "give `*A*` the angle `alpha`"),
            (both, path, behind.as_str(), ""),
            (both, path, wrong.as_str(), "give `*A*` the angle `alpha`"),
        ];
        for (id, from, to, words) in table {
            // Equal angles tell nothing.
            let own = r#"beta  = ["atan(3/4)/deg", "atan(4/3)/deg", "atan(12/5)/deg"]"#;
            let unequal = (own, r#"beta  = ["atan(5/12)/deg"]"#);
            let edits = [(from, to), unequal];
            let said = said(id, if id == both { &edits } else { &edits[..1] });
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {to}: {said}");
        }
    }
}
