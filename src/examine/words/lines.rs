//! From which line the words measure an angle that is to be found, and from which the answer is measured.

use super::impacts::{wall_measured_from, wall_of};
use super::sentence::{Noun, Sentence, Token, is_one_of, measured_from, noun_of, sentences};
use crate::bank::{Answer, Find, Part, Question};
use crate::examine::Finding;
use crate::expr::{Expr, Text, print};
use crate::mechanics::{Axis, Quantity};

/// Answers that are measured from another line than that of their words.
pub fn from_another_line(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, answer) in part.answers.iter().enumerate() {
            let Some((axis, of_wall)) = axis(question, answer) else { continue };
            let said = [of_answer(answer), of_letter(question, answer), of_part(part, axis)];
            let Some(other) = said.into_iter().flatten().find(|said| *said != axis) else { continue };
            let [said, found] = [other, axis].map(|axis| line(axis, of_wall));
            let message = format!(
                "the words measure `{}` from {said}, and `{}` is measured from {found}",
                print::text_unicode(&answer.name),
                answer.find.name()
            );
            let help = match (of_wall, other) {
                (true, Axis::N) => {
                    "find `A.after.angle_to_loc_deg`, which is the angle with the normal; or say `with the wall`"
                }
                (true, _) => "find `A.after.angle_to_wall_deg`; or say `with the normal to the wall`",
                (false, _) => "say `with the line of centres`",
            };
            let found = Finding::new(message, "", "found here").with_help(help);
            findings.push(found.at_row(place, "answers", row));
        }
        findings.extend(from_another_vector(place, part));
        findings.extend(from_another_wall(question, place, part));
    }
    findings
}

/// Angles with a wall for which the words name another wall.
fn from_another_wall(question: &Question, place: usize, part: &Part) -> Option<Finding> {
    let scene = &question.scene;
    let wall_of_answer = |answer: &Answer| match &answer.find {
        Find::Quantity(quantity) => match quantity.of_its_impact() {
            Quantity::AngleToWall(..) | Quantity::TanToWall(..) => Some(quantity.impact()),
            _ => None,
        },
        _ => None,
    };
    let mut own = part.answers.iter().enumerate().filter_map(|(row, answer)| Some((row, wall_of_answer(answer)?)));
    let (Some((row, wall)), None) = (own.next(), own.next()) else { return None };
    let answer = &part.answers[row];
    let in_answer = [&answer.phrase, &answer.name].into_iter().flat_map(sentences);
    let in_answer = in_answer.into_iter().find_map(|sentence| wall_measured_from(scene, &sentence));
    let in_part = || {
        part.ask.iter().flat_map(sentences).find_map(|sentence| {
            let angle = sentence.iter().position(|token| is_one_of(token, &["angle"]))?;
            wall_measured_from(scene, &sentence[angle..])
        })
    };
    // Walls that are parallel make one angle with a path.
    let is_other = |said: &u8| wall_of(scene, *said) != wall_of(scene, wall);
    in_answer.filter(is_other).or_else(|| in_part().filter(is_other))?;
    let message =
        format!("the words measure `{}` from another wall than it is found with", print::text_unicode(&answer.name));
    let help = "name the wall of the impact of which it is found, or find it of the other";
    Some(Finding::new(message, "", "of another wall").with_help(help).at_row(place, "answers", row))
}

/// Angles with **i** for which the words name **j** alone.
fn from_another_vector(place: usize, part: &Part) -> Vec<Finding> {
    let is_of_i = |answer: &Answer| match &answer.find {
        Find::Quantity(quantity) => {
            matches!(quantity.of_its_impact(), Quantity::ImpulseAngle | Quantity::AngleFromI(..))
        }
        _ => false,
    };
    let names = |text: &Text, vector: &str| {
        text.formulas().into_iter().any(|expr| matches!(expr, Expr::Name(name) if name.text == vector))
    };
    // Both may be named for a vector in terms of them.
    let is_other =
        |texts: &[&Text]| texts.iter().any(|text| names(text, "j")) && !texts.iter().any(|text| names(text, "i"));
    let own = part.answers.iter().enumerate().filter(|(_, answer)| is_of_i(answer));
    let wrong = own.filter(|(_, answer)| {
        is_other(&[&answer.phrase, &answer.name]) || is_other(&part.ask.iter().collect::<Vec<_>>())
    });
    wrong
        .map(|(row, answer)| {
            let (name, find) = (print::text_unicode(&answer.name), answer.find.name());
            let message = format!("the words measure `{name}` from j, and `{find}` is measured from i");
            Finding::new(message, "", "found here").with_help("say `with {i}`").at_row(place, "answers", row)
        })
        .collect()
}

fn line(axis: Axis, of_wall: bool) -> &'static str {
    match (axis, of_wall) {
        (Axis::N, true) => "the normal to the wall",
        (_, true) => "the wall",
        (Axis::N, false) => "the line of centres",
        (_, false) => "what is perpendicular to the line of centres",
    }
}

/// The axis from which an answer is measured, and whether that is of a wall.
fn axis(question: &Question, answer: &Answer) -> Option<(Axis, bool)> {
    let Find::Quantity(quantity) = &answer.find else { return None };
    match quantity.of_its_impact() {
        Quantity::AngleToWall(..) | Quantity::TanToWall(..) => Some((Axis::T, true)),
        Quantity::AngleToLine(..) | Quantity::TanToLine(..) | Quantity::TOverN(..) => {
            let then = (quantity.impact() as usize).checked_sub(1).and_then(|later| question.scene.then.get(later));
            let wall = if quantity.impact() == 0 { &question.scene.wall } else { &then?.wall };
            Some((Axis::N, wall.is_some()))
        }
        _ => None,
    }
}

/// The axis that the name or the phrase of an answer names.
fn of_answer(answer: &Answer) -> Option<Axis> {
    [&answer.phrase, &answer.name].into_iter().flat_map(sentences).find_map(|sentence| measured_from(&sentence))
}

/// The axis of the angle that the words have called by the letter of which the answer is the tangent.
fn of_letter(question: &Question, answer: &Answer) -> Option<Axis> {
    let letters = answer.show.as_ref()?.names();
    let stems = question.styles.iter().flat_map(|style| &style.stem);
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    stems.chain(asks).flat_map(sentences).find_map(|sentence| {
        let is_called = |place: &usize| match &sentence[*place] {
            Token::Number(Expr::Name(name), ..) => {
                let is_its = letters.iter().any(|letter| letter.text == name.text);
                is_its && noun_of(&sentence, *place).is_some_and(|(_, noun, _)| noun == Noun::Angle)
            }
            _ => false,
        };
        (0..sentence.len()).find(is_called).and_then(|place| measured_from(&sentence[place + 1..]))
    })
}

/// The axis from which a part asks for angles; that of the answer if several are named, and that is one of them.
fn of_part(part: &Part, own: Axis) -> Option<Axis> {
    const ANGLES: [&str; 5] = ["angle", "angles", "direction", "directions", "inclination"];
    let all: Vec<Sentence> = part.ask.iter().flat_map(|text: &Text| sentences(text)).collect();
    let named = all.iter().flat_map(|sentence| {
        let of = |(place, token)| is_one_of(token, &ANGLES).then(|| measured_from(&sentence[place + 1..])).flatten();
        sentence.iter().enumerate().filter_map(of)
    });
    let named: Vec<Axis> = named.collect();
    if named.contains(&own) { Some(own) } else { named.first().copied() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn an_angle_is_asked_for_from_the_line_from_which_it_is_found() {
        let wall = "walls/rebound-speed-and-direction";
        let vector = "vector-impulse/impulse-from-two-velocities";
        let (rest, letters) = ("rest/speeds-and-directions", "rest-letters/direction-and-deflection");
        let corner = "successive/tangents-at-two-walls";
        let ask = "Find {tan(beta)} in terms of the letters given.";
        let table: [(&str, Edits, &str); 16] = [
            (corner, &[], ""),
            (corner, &[(ask, "Find the tangent of the angle between its path and the first wall.")], ""),
            (
                corner,
                &[(ask, "Find the tangent of the angle between its path and the second wall.")],
                "measure `tan β` from another wall",
            ),
            (
                wall,
                &[("phrase = \"with the wall\"", "phrase = \"with the normal to the wall\"")],
                "the normal to the wall",
            ),
            (
                wall,
                &[(", phrase = \"with the wall\"", ""), ("makes with the wall", "makes with the normal to the wall")],
                "from the normal to the wall, and `A.after.angle_to_wall_deg` is measured from the wall",
            ),
            (wall, &[("makes with the wall", "makes with the wall and with the normal to the wall")], ""),
            (
                wall,
                &[
                    (", phrase = \"with the wall\"", ""),
                    ("that its direction of motion then makes with the wall", "of it"),
                ],
                "",
            ),
            (
                wall,
                &[
                    ("A.after.angle_to_wall_deg", "A.after.angle_to_loc_deg"),
                    ("phrase = \"with the wall\"", "phrase = \"to the wall\""),
                ],
                "and `A.after.angle_to_loc_deg` is measured from the normal",
            ),
            (rest, &[("phrase = \"to the line of centres\"", "phrase = \"to the common tangent\"")], "direction of A"),
            (letters, &[("beta} with the line of centres", "beta} with the common tangent")], "measure `tan β`"),
            (letters, &[], ""),
            (wall, &[("then makes with the wall", "then makes with the normal to the wall")], "from the normal"),
            (rest, &[("of motion of each sphere", "of motion of each sphere, from the line of centres,")], ""),
            (vector, &[], ""),
            (vector, &[("phrase = \"with {i}\"", "phrase = \"with {j}\"")], "measure `angle` from j"),
            (vector, &[("direction makes with {i}", "direction makes with {j}")], "measure `angle` from j"),
        ];
        for (id, edits, words) in table {
            let said: String =
                from_another_line(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
