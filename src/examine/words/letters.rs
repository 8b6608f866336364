//! Of which angle each letter is: of one alone, and of that which the scene or an answer calls by it.

use super::asked_when::impact;
use super::given::{names_in, names_of_given};
use super::impacts::{impacts, wall_measured_from, wall_of};
use super::said::{only_subject, told};
use super::sentence::{
    Noun, Sentence, Token, is_one_of, is_supposed, measured_from, noun_of, says, sentences, subject,
};
use crate::answer::Kind;
use crate::bank::{Find, Question, Style};
use crate::examine::Finding;
use crate::expr::{Expr, Text};
use crate::mechanics::{Axis, Moment, Quantity, Sphere, ordinal};

/// An angle that has a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Called {
    /// Of a path with a line.
    WithLine {
        /// After how many impacts, and on which side of the next, if that is said.
        time: Option<(u8, Moment)>,
        /// The impact whose wall it is, if that is said.
        wall: Option<u8>,
    },
    /// That through which a path is turned.
    Turned,
}

/// A place in the words where an angle is called by a letter.
struct Call {
    letter: String,
    angle: Called,
    /// The line from which it is measured.
    from: Option<Axis>,
    /// The words that lead to it.
    at: String,
}

/// Letters that the words give to two angles, or to another than the scene and the answers do; and letters of what is to
/// be shown of which the words never say what they are.
pub fn of_other_angles(question: &Question) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    for style in &question.styles {
        let calls = calls(question, style);
        for (place, call) in calls.iter().enumerate() {
            let letter = &call.letter;
            let own = own_angles(question, letter);
            let other = match own.first() {
                Some(first) if !own.iter().any(|own| agree(*own, call.angle)) => Some(*first),
                Some(_) => None,
                None => {
                    let is_other = |first: &&Call| first.letter == *letter && differ(first, call);
                    calls[..place].iter().find(is_other).map(|first| first.angle)
                }
            };
            let Some(other) = other else { continue };
            let (said_of, has_of) = (shown(question, call.angle), shown(question, other));
            let message = match walls(call.angle, other).map(|walls| walls.map(|wall| nth_wall(question, wall))) {
                Some([said, has]) if said_of == has_of => {
                    format!("the words measure the angle `{letter}` from the {said} wall, and it is one with the {has}")
                }
                None if said_of == has_of => {
                    format!("the words call two angles `{letter}`, which are measured from different lines")
                }
                _ => format!("the words call the angle {said_of} `{letter}`, and `{letter}` is the angle {has_of}"),
            };
            let help = "give it a letter of its own, or say the time and the line of the angle that is meant";
            findings.push(Finding::new(message, call.at.clone(), "another angle").with_help(help).as_warning());
        }
    }
    // Styles share most of their words.
    findings.sort_by(|one, other| (&one.message, &one.at).cmp(&(&other.message, &other.at)));
    findings.dedup();
    findings.extend(unknown(question));
    findings
}

/// Letters on the left of what is to be shown that stand nowhere else.
fn unknown(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, answer) in part.answers.iter().enumerate().filter(|(_, answer)| answer.kind == Kind::Shown) {
            let letters = answer.show.iter().flat_map(Expr::names).map(|name| &name.text);
            let letters = letters.filter(|letter| question.scene.symbols.contains_key(*letter));
            let has = |text: &Text, letter: &str| text.names().iter().any(|name| name.text == letter);
            let is_said = |letter: &&String| {
                let asks = question.parts[..=place].iter().flat_map(|part| &part.ask);
                let is_asked = asks.into_iter().any(|text| has(text, letter));
                is_asked || question.styles.iter().all(|style| style.stem.iter().any(|text| has(text, letter)))
            };
            findings.extend(letters.filter(|letter| !is_said(letter)).map(|letter| {
                let message = format!("the words never say what `{letter}` is, and ask to show what it comes to");
                let is_angle = question.scene.symbols.get(letter).is_some_and(|range| range == "acute");
                let help = match is_angle {
                    true => format!("say it in the stem, as in `makes an acute angle {{{letter}}} with …`"),
                    false => format!("say it before the result, as in `is {{{letter}}}, where {{display: result}}`"),
                };
                let found = Finding::new(message, "", "a student cannot know it");
                found.with_help(help).at_row(place, "answers", row).as_warning()
            }));
        }
    }
    findings
}

fn shown(question: &Question, angle: Called) -> String {
    match angle {
        Called::Turned => "through which a path is turned".to_owned(),
        Called::WithLine { time: None, .. } => "of a path with a line".to_owned(),
        Called::WithLine { time: Some((impact, moment)), .. } => {
            let all = if question.scene.then.is_empty() {
                [""].as_slice()
            } else {
                &["first ", "second ", "third ", "fourth "]
            };
            let nth = all.get(usize::from(impact)).copied().unwrap_or_default();
            format!("{} the {nth}impact", if moment == Moment::Before { "before" } else { "after" })
        }
    }
}

/// May two be one angle? What is not said may be either.
fn agree(one: Called, other: Called) -> bool {
    match (one, other) {
        (Called::WithLine { time: Some(one), .. }, Called::WithLine { time: Some(other), .. }) if one != other => false,
        (Called::WithLine { .. }, Called::WithLine { .. }) => walls(one, other).is_none(),
        (one, other) => one == other,
    }
}

/// The impacts with the walls from which two angles are measured, where these are known and are two.
fn walls(one: Called, other: Called) -> Option<[u8; 2]> {
    let wall = |angle| if let Called::WithLine { wall, .. } = angle { wall } else { None };
    let walls = [wall(one)?, wall(other)?];
    (walls[0] != walls[1]).then_some(walls)
}

/// Which of the walls is that of an impact, in words.
fn nth_wall(question: &Question, impact: u8) -> &'static str {
    let before = impacts(&question.scene).iter().filter(|one| one.is_wall && one.number < impact).count();
    ordinal(u8::try_from(before).unwrap_or_default())
}

/// The impact with a wall, or the first with one that is parallel to it.
fn wall(question: &Question, impact: u8) -> Option<u8> {
    let along = wall_of(&question.scene, impact)?;
    (0..=impact).find(|one| wall_of(&question.scene, *one) == Some(along))
}

/// What a sphere has before one impact it has from the last.
fn since(question: &Question, sphere: Sphere, (impact, moment): (u8, Moment)) -> (u8, Moment) {
    let impacts = impacts(&question.scene);
    let last = impacts.iter().rfind(|last| last.number < impact && last.has(sphere));
    match (last, moment) {
        (Some(last), Moment::Before) => (last.number, Moment::After),
        _ => (impact, moment),
    }
}

fn differ(one: &Call, other: &Call) -> bool {
    !agree(one.angle, other.angle) || matches!((one.from, other.from), (Some(one), Some(other)) if one != other)
}

/// The angles that the scene gives by a letter, that a condition compares with it, or that an answer finds by it.
fn own_angles(question: &Question, letter: &str) -> Vec<Called> {
    let scene = &question.scene;
    let mut own = Vec::new();
    if names_of_given(&scene.before).contains(letter) {
        own.push(Called::WithLine { time: Some((0, Moment::Before)), wall: None });
    }
    if names_of_given(&scene.after).contains(letter) {
        own.push(Called::WithLine { time: Some((0, Moment::After)), wall: None });
    }
    for condition in scene.conditions.iter().filter(|condition| names_in(condition).contains(letter)) {
        let words = condition.split(|sign: char| !(sign.is_ascii_alphanumeric() || "._".contains(sign)));
        own.extend(words.filter_map(|word| word.parse().ok()).filter_map(|quantity| angle_of(question, quantity)));
    }
    for answer in question.parts.iter().flat_map(|part| &part.answers) {
        let names = answer.show.iter().chain(answer.name.formulas()).flat_map(Expr::names);
        let is_its = names.into_iter().any(|name| name.text == letter);
        if let (Find::Quantity(quantity), true) = (&answer.find, is_its) {
            own.extend(angle_of(question, *quantity));
        }
    }
    own
}

fn angle_of(question: &Question, quantity: Quantity) -> Option<Called> {
    match quantity.of_its_impact() {
        Quantity::AngleToLine(sphere, moment)
        | Quantity::AngleToWall(sphere, moment)
        | Quantity::TanToLine(sphere, moment)
        | Quantity::TanToWall(sphere, moment)
        | Quantity::TOverN(sphere, moment) => Some(Called::WithLine {
            time: Some(since(question, quantity.sphere().unwrap_or(sphere), (quantity.impact(), moment))),
            wall: wall(question, quantity.impact()),
        }),
        Quantity::Deflection(_) | Quantity::TanDeflection(_) | Quantity::DeflectionDot(_) => Some(Called::Turned),
        _ => None,
    }
}

/// Every place where the words of a style call an angle by a letter that the scene declares.
fn calls(question: &Question, style: &Style) -> Vec<Call> {
    let stem = style.stem.iter().chain([&style.note]);
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    let mut found = Vec::new();
    for text in stem.chain(asks) {
        let mut named = None;
        for sentence in sentences(text).into_iter().filter(|sentence| !is_supposed(sentence)) {
            // `At the same angle` may be another.
            if !says(&sentence, &["same", "also", "again", "equal", "still"]) {
                found.extend((0..sentence.len()).filter_map(|place| call(question, &sentence, place, named)));
            }
            named = only_subject(&sentence).or(named);
        }
    }
    found
}

fn call(question: &Question, sentence: &Sentence, place: usize, named: Option<Sphere>) -> Option<Call> {
    let Token::Number(Expr::Name(name), _, lead) = &sentence[place] else { return None };
    let letter = Some(&name.text).filter(|letter| question.scene.symbols.contains_key(*letter))?;
    let (at, ..) = noun_of(sentence, place).filter(|(_, noun, _)| *noun == Noun::Angle)?;
    let is_turned = sentence[at.saturating_sub(3)..at].iter().any(|token| is_one_of(token, &["through"]))
        || is_to_the_old_way(&sentence[place + 1..]);
    let from = measured_from(&sentence[place + 1..]);
    let angle = match (is_turned, from) {
        (true, _) => Called::Turned,
        (false, Some(_)) => Called::WithLine {
            time: time(question, sentence, place, named),
            wall: wall_measured_from(&question.scene, &sentence[place + 1..]).and_then(|own| wall(question, own)),
        },
        (false, None) => return None,
    };
    let words: Vec<&str> = lead.split_whitespace().collect();
    let at = words[words.len().saturating_sub(8)..].join(" ");
    Some(Call { letter: letter.clone(), angle, from: from.filter(|_| !is_turned), at })
}

/// `To its original direction`, `with the direction in which it was moving before`: is it the angle between two paths?
fn is_to_the_old_way(after: &[Token]) -> bool {
    const OLD: [&str; 7] = ["original", "initial", "old", "former", "previous", "first", "earlier"];
    const WAYS: [&str; 4] = ["direction", "path", "course", "line"];
    match after {
        [to, of, old, way, ..] => {
            let is_of_it = is_one_of(to, &["to", "with", "from"]) && is_one_of(of, &["its", "the", "his", "their"]);
            let was = || {
                let rest = after[3..].iter().take_while(|token| !matches!(token, Token::Comma | Token::Number(..)));
                is_one_of(old, &WAYS) && rest.into_iter().any(|token| is_one_of(token, &["was", "had"]))
            };
            is_of_it && ((is_one_of(old, &OLD) && is_one_of(way, &WAYS)) || was())
        }
        _ => false,
    }
}

/// The time of which an angle is said to be; none where no word tells, or where it is not plain of which impact.
fn time(question: &Question, sentence: &Sentence, place: usize, named: Option<Sphere>) -> Option<(u8, Moment)> {
    let (at, moment) = told(sentence, place)?;
    let impacts = impacts(&question.scene);
    let is_plain = impacts.len() == 1 || impacts.iter().all(|impact| impact.is_of_one());
    let only = is_plain.then_some(Sphere::A);
    let sphere = subject(&sentence[..place]).or(only).or(named)?;
    let rest = &sentence[at + 1..];
    let clause = rest.split(|token| *token == Token::Comma).next().unwrap_or_default();
    impact(question, sphere, clause).map(|impact| since(question, sphere, (impact, moment)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn a_letter_is_of_one_angle() {
        let (two, letters) = ("walls/restitution-from-two-angles", "rest-letters/direction-and-deflection");
        let (corner, distance) = ("successive/tangents-at-two-walls", "rest-letters/distance-from-the-centre-of-b");
        const SHOWN: &str = "Hence show that the path of *A* is deflected through an angle {delta}, where";
        let to_old = &[(SHOWN, "Now *A* moves at an angle {delta} to its original direction. Show that")];
        let beta_to_old =
            &[(SHOWN, "Now *A* moves at an angle {beta} to the direction in which it was moving, and {delta}, where")];
        let table: [(&str, Edits, &str); 16] = [
            (letters, to_old, ""),
            (letters, beta_to_old, "a path is turned `beta`, and `beta` is the angle after"),
            (two, &[], ""),
            (
                two,
                &[("{beta} with", "{alpha} with")],
                "after the impact `alpha`, and `alpha` is the angle before the impact",
            ),
            (two, &[("an acute angle {beta} with", "the same angle {alpha} with")], ""),
            (letters, &[], ""),
            (letters, &[("Immediately after", "Immediately before")], "before the impact `beta`, and `beta` is"),
            (
                letters,
                &[("an angle {delta}", "an angle {beta}")],
                "a path is turned `beta`, and `beta` is the angle after",
            ),
            (letters, &[("an angle {delta}", "an angle")], "the words never say what `delta` is"),
            (corner, &[], ""),
            (
                corner,
                &[("{gamma} to", "{beta} to")],
                "after the second impact `beta`, and `beta` is the angle after the first",
            ),
            (
                corner,
                &[("{gamma} to the second", "{gamma} to the first")],
                "`gamma` from the first wall, and it is one with the second",
            ),
            (
                corner,
                &[("{beta} to the first", "{beta} to the second")],
                "`beta` from the second wall, and it is one with the first",
            ),
            (
                corner,
                &[
                    ("{beta} to the first", "{beta} to the second"),
                    ("find = \"A.after.tan_to_wall\"", "find = \"second.A.before.tan_to_wall\""),
                ],
                "",
            ),
            (corner, &[("{alpha} to the first", "{alpha} to the second")], ""),
            (distance, &[("a straight line and", "a line at an angle {theta} to the line of centres and")], "`theta`"),
        ];
        for (id, edits, words) in table {
            let said: String = of_other_angles(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
