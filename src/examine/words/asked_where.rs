//! Of which impact an energy, an impulse or a coefficient of restitution is asked for, where there are several: `at the
//! second wall`, `in the collision between *B* and *C*`.

use super::impacts::{impacts, ordinal, wall_named};
use super::sentence::{Sentence, Token, is_one_of, is_supposed, sentences};
use crate::answer::Kind;
use crate::bank::Question;
use crate::examine::Finding;
use crate::expr::{Text, print};
use crate::mechanics::{Quantity, SceneText, Sphere};

/// Answers that are of another impact than those that their words, or their names, speak of.
pub fn otherwise(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate().filter(|_| !question.scene.then.is_empty()) {
        for (row, answer) in part.answers.iter().enumerate().filter(|(_, answer)| answer.kind != Kind::Shown) {
            let Some(quantity) = answer.find.quantities().first().copied().filter(|found| is_of_one(*found)) else {
                continue;
            };
            let own = std::slice::from_ref(&answer.name);
            let is_another = |named: &Vec<u8>| !named.is_empty() && !named.contains(&quantity.impact());
            let named = [own, part.ask.as_slice()].into_iter().map(|texts| named(&question.scene, texts));
            let Some(other) = named.into_iter().find(is_another) else { continue };
            let there = quantity.of_its_impact().in_impact(other[0]);
            let find = there.map_or_else(String::new, |there| format!("find `{there}`, or "));
            let (name, nth) = (print::text_unicode(&answer.name), nth(quantity.impact()));
            let message = format!(
                "the words speak of the {} impact, and the answer `{name}` is of the {nth}",
                self::nth(other[0])
            );
            let found = Finding::new(message, "", format!("found of the {nth} impact"));
            let help = format!("{find}speak of the impact of which it is found");
            findings.push(found.with_help(help).at_row(place, "answers", row));
        }
    }
    findings
}

/// Is it something that belongs to one impact, and not to the time before or after it?
fn is_of_one(quantity: Quantity) -> bool {
    matches!(
        quantity.of_its_impact(),
        Quantity::EnergyLost
            | Quantity::SphereEnergyLost(_)
            | Quantity::SphereEnergyGained(_)
            | Quantity::FractionLost
            | Quantity::Impulse(..)
            | Quantity::ImpulseMagnitude
            | Quantity::Restitution
    )
}

fn nth(impact: u8) -> &'static str {
    ["first", "second", "third", "fourth"].get(usize::from(impact)).copied().unwrap_or("last")
}

/// The impacts that words name by a wall or by two spheres; what is before one or after it is not of it.
fn named(scene: &SceneText, texts: &[Text]) -> Vec<u8> {
    let all: Vec<Sentence> = texts.iter().flat_map(sentences).filter(|words| !is_supposed(words)).collect();
    let mut named = Vec::new();
    for sentence in &all {
        for place in 0..sentence.len() {
            let clause = sentence[..place].iter().rev().take_while(|token| **token != Token::Comma);
            if clause.into_iter().any(|token| is_one_of(token, &["before", "after", "until"])) {
                continue;
            }
            let lead = place.checked_sub(1).map(|lead| &sentence[lead]);
            let is_met = lead.is_some_and(|lead| is_one_of(lead, &MET));
            named.extend(wall_named(scene, &sentence[place..]).filter(|_| is_met));
            named.extend(between(scene, &sentence[place..]));
            named.extend(nth_impact(scene, &sentence[place..]));
            named.extend(exerted(scene, &sentence[place..]));
        }
    }
    named
}

/// Words that lead to a wall that is struck; what lies `near the wall` is not.
const MET: [&str; 14] =
    ["at", "with", "by", "on", "of", "between", "and", "that", "strikes", "strike", "struck", "hits", "hit", "hitting"];

/// The only impact in which the one exerts something on the other: `that *B* exerts on *C*`, `on *C* by *B*`.
fn exerted(scene: &SceneText, words: &[Token]) -> Option<u8> {
    let (one, other) = match words {
        [Token::Sphere(one), exerts, on, Token::Sphere(other), ..]
            if is_one_of(exerts, &["exerts", "exerted"]) && is_one_of(on, &["on"]) =>
        {
            (one, other)
        }
        [on, Token::Sphere(other), by, Token::Sphere(one), ..] if is_one_of(on, &["on"]) && is_one_of(by, &["by"]) => {
            (one, other)
        }
        _ => return None,
    };
    only_between(scene, *one, *other)
}

/// The impact that words number: `in the second impact`, which is not `the second collision between *A* and *B*`.
fn nth_impact(scene: &SceneText, words: &[Token]) -> Option<u8> {
    let [at, the, nth, impact, rest @ ..] = words else { return None };
    let is_said = is_one_of(at, &["in", "at", "during", "of", "by"]) && is_one_of(the, &["the"]);
    let is_impact = is_one_of(impact, &["impact", "collision"]);
    let is_of_some = rest.first().is_some_and(|next| is_one_of(next, &["between", "with", "of"]));
    let number = u8::try_from(ordinal(nth)?).ok().filter(|_| is_said && is_impact && !is_of_some)?;
    // Beside a wall the second collision may be the second of two spheres.
    let all = impacts(scene);
    let is_of_one_kind = all.iter().all(|impact| impact.is_wall == all[0].is_wall);
    all.iter().map(|impact| impact.number).find(|there| *there == number && is_of_one_kind)
}

/// The only impact of two spheres that words begin with: `between *B* and *C*`.
fn between(scene: &SceneText, words: &[Token]) -> Option<u8> {
    let [lead, Token::Sphere(one), and, Token::Sphere(other), ..] = words else { return None };
    let is_said = is_one_of(lead, &["between", "of"]) && is_one_of(and, &["and", "with"]);
    only_between(scene, *one, *other).filter(|_| is_said)
}

/// The impact of two spheres, if they have but one.
pub(super) fn only_between(scene: &SceneText, one: Sphere, other: Sphere) -> Option<u8> {
    let all = impacts(scene);
    let mut of_both = all.iter().filter(|impact| impact.has(one) && impact.has(other));
    match (of_both.next(), of_both.next()) {
        (Some(only), None) => Some(only.number),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn an_energy_or_an_impulse_is_of_the_impact_that_is_named() {
        let (corner, line) = ("successive/corner", "successive/three-in-a-line");
        let wall = "successive/struck-onto-a-wall";
        let table: [(&str, Edits, &str); 13] = [
            (corner, &[], ""),
            (corner, &[("loses at the second wall", "loses in the first impact")], "of the first impact"),
            (corner, &[("loses at the second wall", "loses in the second impact")], ""),
            (
                corner,
                &[("loses at the second", "loses at the first")],
                "of the first impact, and the answer `kinetic energy lost`",
            ),
            (corner, &[("loses at the second wall", "loses when it strikes the first wall")], "of the first impact"),
            (corner, &[("loses at the second wall", "then loses, after it has struck the first wall")], ""),
            (corner, &[("\"kinetic energy lost\"", "\"energy lost at the first wall\"")], "of the first impact"),
            (line, &[], ""),
            (line, &[("that *B* exerts on *C*", "that *A* exerts on *B*")], "of the first impact"),
            (line, &[("that *B* exerts on *C*", "exerted on *C* by *B*")], ""),
            (line, &[("that *B* exerts on *C*", "in the collision between *A* and *B*")], "of the first impact"),
            (wall, &[], ""),
            (wall, &[("the wall exerts on *B*", "*B*, which is near the wall, receives from *A*")], ""),
        ];
        for (id, edits, words) in table {
            let said: String = otherwise(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
