//! Do the words ask for a motion after the impact after which it is found, and not before it?
//!
//! `After it has struck the wall` and `before *C* strikes it` name an impact of a sphere. Where no impact is plain from the
//! words, as in `after the second collision` where walls are struck between, nothing is said.

use super::asked_where::only_between;
use super::impacts::{impacts, ordinal};
use super::sentence::{Sentence, Token, is_one_of, is_supposed, says, sentences};
use crate::bank::{EarnedFor, Question};
use crate::examine::Finding;
use crate::expr::{Text, print};
use crate::mechanics::{Moment, Quantity, Sphere};

/// Answers that the words, or the names of the answers, place on the other side of an impact.
pub fn otherwise(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, answer) in part.answers.iter().enumerate() {
            let own = std::slice::from_ref(&answer.name);
            let (quantities, name) = (answer.find.quantities(), print::text_unicode(&answer.name));
            let mut texts = [own, part.ask.as_slice()].into_iter();
            let found = texts.find_map(|texts| misplaced(question, &quantities, ("the words ask for", &name), texts));
            findings.extend(found.map(|found| found.at_row(place, "answers", row)));
        }
    }
    findings
}

/// Marks whose text places what they are for on the other side of an impact.
pub fn marked_otherwise(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, mark) in part.marks.iter().enumerate() {
            let (EarnedFor::Quantity(quantity), Some(text)) = (&mark.earned_for, &mark.text) else { continue };
            let who = format!("the text of the mark {} speaks of", mark.id);
            let found = misplaced(question, &[*quantity], (&who, &quantity.to_string()), std::slice::from_ref(text));
            let help = format!("say in the `text` of the mark {} what it is for, or mend `for`", mark.id);
            findings.extend(found.map(|found| found.with_help(help).at_row(place, "marks", row)));
        }
    }
    findings
}

/// What is found on the wrong side of every impact that the words name, or after a later one.
fn misplaced(
    question: &Question,
    quantities: &[Quantity],
    (who, name): (&str, &str),
    texts: &[Text],
) -> Option<Finding> {
    let quantity = *quantities.first()?;
    let (sphere, moment) = match quantity.of_its_impact() {
        Quantity::Speed(sphere, moment)
        | Quantity::Velocity(sphere, moment, _)
        | Quantity::AngleToLine(sphere, moment)
        | Quantity::AngleToWall(sphere, moment) => (sphere, moment),
        _ => return None,
    };
    let is_plain = |sentence: &Sentence| !is_supposed(sentence) && !says(sentence, &["given"]);
    let all: Vec<Sentence> = texts.iter().flat_map(sentences).filter(is_plain).collect();
    let named: Option<Vec<(Vec<u8>, Moment)>> = all.iter().flat_map(|words| moments(question, sphere, words)).collect();
    let found_at = (quantity.impact(), moment);
    // `After it has struck the wall and met *A* again` names more than one.
    let is_one = !all.iter().any(|words| says(words, &["and", "again", "then", "finally", "final", "eventually"]));
    let is_later = |impact: u8| is_one && quantity.impact() > impact && moment == Moment::After;
    let is_wrong = |(impacts, asked): &(Vec<u8>, Moment)| {
        impacts.iter().all(|impact| match asked {
            Moment::Before => found_at >= (*impact, Moment::After),
            Moment::After => found_at <= (*impact, Moment::Before) || is_later(*impact),
        })
    };
    let named = named.filter(|named| named.iter().all(is_wrong))?;
    let (impacts_named, wanted) = named.first()?;
    let (impact, wanted) = (*impacts_named.last()?, *wanted);
    let (asked, found, found_where) = match wanted {
        Moment::Before => ("before", "after it", "after the impact"),
        Moment::After if quantity.impact() > impact => ("after", "after a later one", "after the later impact"),
        Moment::After => ("after", "before it", "before the impact"),
    };
    let is_there = impacts(&question.scene).iter().any(|one| one.number == impact);
    let there = quantities.iter().filter(|_| is_there).filter_map(|quantity| at(*quantity, impact, wanted));
    let there: Vec<String> = there.map(|quantity| format!("`{quantity}`")).collect();
    let help = match there.as_slice() {
        [] => format!("ask for what is {found_where}"),
        there => format!("find {}, or ask for what is {found_where}", there.join(" and ")),
    };
    let message = format!("{who} what is {asked} an impact, and `{name}` is found {found}");
    Some(Finding::new(message, "", format!("found {found_where}")).with_help(help))
}

/// The same quantity of another impact, before it or after it.
fn at(quantity: Quantity, impact: u8, moment: Moment) -> Option<Quantity> {
    let there = match quantity.of_its_impact() {
        Quantity::Speed(sphere, _) => Quantity::Speed(sphere, moment),
        Quantity::Velocity(sphere, _, axis) => Quantity::Velocity(sphere, moment, axis),
        Quantity::AngleToLine(sphere, _) => Quantity::AngleToLine(sphere, moment),
        Quantity::AngleToWall(sphere, _) => Quantity::AngleToWall(sphere, moment),
        _ => return None,
    };
    there.in_impact(impact)
}

/// The impacts before or after which a sentence asks, each none if it is not plain which; several where it may be any of them.
fn moments(question: &Question, sphere: Sphere, sentence: &[Token]) -> Vec<Option<(Vec<u8>, Moment)>> {
    let at = |(place, token): (usize, &Token)| {
        let moment = match token {
            Token::Word(word) if word == "before" => Moment::Before,
            Token::Word(word) if word == "after" => Moment::After,
            // What strikes at a speed has it until it strikes.
            Token::Word(word) if is_at_the_strike(word, &sentence[..place], &sentence[place + 1..]) => Moment::Before,
            _ => return None,
        };
        let rest = sentence[place + 1..].split(|token| *token == Token::Comma).next().unwrap_or_default();
        let named = match they_collide(question, &sentence[..place], rest) {
            Some(theirs) => vec![theirs],
            None => named(question, sphere, rest),
        };
        Some((!named.is_empty()).then_some((named, moment)))
    };
    sentence.iter().enumerate().filter_map(at).collect()
}

/// `As it strikes`, `with which *A* hits`: of a speed at the beginning of an impact.
fn is_at_the_strike(word: &str, before: &[Token], after: &[Token]) -> bool {
    let leads = match word {
        "as" => !before.last().is_some_and(|last| is_one_of(last, &["same", "such"])),
        "which" => before.last().is_some_and(|last| is_one_of(last, &["with", "at"])),
        _ => false,
    };
    let [who, strikes, ..] = after else { return false };
    let is_who = matches!(who, Token::Sphere(_)) || is_one_of(who, &["it"]);
    leads && is_who && is_one_of(strikes, &["strikes", "hits", "reaches", "meets"])
}

/// `The speeds of *B* and *C* before they collide`: the only impact of the two who alone are named.
fn they_collide(question: &Question, before: &[Token], after: &[Token]) -> Option<u8> {
    // `Before they first collide`
    let (is_first, [they, collide]) = match after {
        [they, first, collide, ..] if is_one_of(first, &["first"]) => (true, [they, collide]),
        [they, collide, ..] => (false, [they, collide]),
        _ => return None,
    };
    let is_theirs = is_one_of(they, &["they"]) && is_one_of(collide, &["collide", "meet", "collided", "met"]);
    let mut named: Vec<Sphere> = before.iter().filter_map(sphere_named).collect();
    named.sort();
    named.dedup();
    let ([one, other], true) = (named.as_slice(), is_theirs && nth_time(after).is_none()) else { return None };
    let theirs = impacts(&question.scene).into_iter().find(|impact| impact.has(*one) && impact.has(*other));
    if is_first { theirs.map(|impact| impact.number) } else { only_between(&question.scene, *one, *other) }
}

fn sphere_named(token: &Token) -> Option<Sphere> {
    if let Token::Sphere(sphere) = token { Some(*sphere) } else { None }
}

/// The impact of a sphere that words name first: with the only wall, with the second, with the sphere that is named.
pub(super) fn impact(question: &Question, sphere: Sphere, words: &[Token]) -> Option<u8> {
    match named(question, sphere, words).as_slice() {
        [one] => Some(*one),
        _ => None,
    }
}

/// The impacts of a sphere that words may name first: all that it has with the sphere or the wall, where no number tells which.
fn named(question: &Question, sphere: Sphere, words: &[Token]) -> Vec<u8> {
    let scene = &question.scene;
    if scene.then.is_empty() {
        return vec![0];
    }
    let impacts = impacts(scene);
    for (place, token) in words.iter().enumerate() {
        let its: Vec<u8> = match token {
            _ if is_one_of(token, &["wall"]) => {
                impacts.iter().filter(|one| one.is_wall && one.has(sphere)).map(|one| one.number).collect()
            }
            Token::Sphere(other) if *other != sphere => {
                impacts.iter().filter(|one| one.has(sphere) && one.has(*other)).map(|one| one.number).collect()
            }
            _ if is_one_of(token, &["they"]) && nth_time(words).is_some() => {
                impacts.iter().filter(|one| !one.is_of_one() && one.has(sphere)).map(|one| one.number).collect()
            }
            _ => continue,
        };
        if let Some(time) = nth_time(words) {
            // A time too many is after all that there are.
            let after_all = u8::try_from(impacts.len()).unwrap_or(u8::MAX);
            return vec![its.get(time).copied().unwrap_or(after_all)];
        }
        let nth = place.checked_sub(1).and_then(|before| ordinal(&words[before]));
        return match (its.as_slice(), nth) {
            ([_, _, ..], Some(nth)) => its.get(nth).copied().into_iter().collect(),
            _ => its,
        };
    }
    Vec::new()
}

/// `For the second time` is 1.
fn nth_time(words: &[Token]) -> Option<usize> {
    words.windows(2).find_map(|pair| ordinal(&pair[0]).filter(|_| is_one_of(&pair[1], &["time"])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn what_is_asked_after_an_impact_is_not_found_before_it() {
        let (wall, corner) = ("successive/struck-onto-a-wall", "successive/corner");
        let after = "immediately after *A* has struck it";
        let twice = "successive/sphere-wall-sphere";
        let (second, first) = ("collides with *B* for the second time", "immediately after they first collide");
        let wall_between = ("find = \"third.A.after.speed\"", "find = \"second.B.after.speed\"");
        let again = "of *A* immediately after it collides with *B* for the second time";
        let (rebound, speed) =
            ("walls/rebound-speed-and-direction", "Find the speed of *A* immediately after the impact");
        let three = "successive/three-in-a-line";
        let table: [(&str, Edits, &str); 26] = [
            (three, &[], ""),
            (
                three,
                &[("immediately after they", "immediately before they")],
                "`speed of B after it has struck C` is found",
            ),
            (rebound, &[(speed, "Find the speed of *A* as it strikes the wall")], "is found after it"),
            (rebound, &[(speed, "Find the speed with which *A* strikes the wall")], "is found after it"),
            (rebound, &[(speed, "Find the speed with which *A* leaves the wall")], ""),
            (wall, &[(after, "as it strikes the wall")], ""),
            (twice, &[], ""),
            (twice, &[(second, "collides with *B* for the first time")], "is found after a later one"),
            (twice, &[(second, "collides with *B* for the third time")], "is found before it"),
            // Of *A* and *B* it is not plain which, and the wall comes between.
            (twice, &[wall_between, (again, "of *B* immediately after it strikes *A*")], "is found before it"),
            (twice, &[wall_between, (again, "of *B* immediately after it strikes the wall")], ""),
            (twice, &[wall_between, (again, "of *B* immediately before it strikes *A*")], ""),
            (
                twice,
                &[("after they first collide", "before they first collide")],
                "before an impact, and `speed of A` is found after",
            ),
            (twice, &[("after it collides with *B* for", "before it collides with *B* for")], "is found after it"),
            (
                twice,
                &[(first, "immediately after they collide for the second time")],
                "`speed of A` is found before it",
            ),
            (twice, &[(first, "immediately after they collide for the first time")], ""),
            (wall, &[], ""),
            (wall, &[(after, "immediately after it has struck the wall")], "what is after an impact, and `speed of B`"),
            (wall, &[(after, "before it strikes the wall")], ""),
            (wall, &[(after, "before *A* strikes it")], "what is before an impact, and `speed of B` is found after it"),
            (wall, &[(after, "before and after it strikes the wall")], ""),
            (wall, &[(after, "after the second impact")], ""),
            (corner, &[], ""),
            (corner, &[("struck the first wall.\"", "struck the second wall.\"")], "`velocity after the first wall`"),
            (
                corner,
                &[("\"second.A.after.x\", \"second.A.after.y\"", "\"A.after.x\", \"A.after.y\"")],
                "after an impact, and `velocity after the second wall` is found before it",
            ),
            (
                "rest/speeds-and-directions",
                &[("immediately after", "immediately before")],
                "what is before an impact, and `speed of A` is found after it",
            ),
        ];
        for (id, edits, words) in table {
            let said: String = otherwise(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
