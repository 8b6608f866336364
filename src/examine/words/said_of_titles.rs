//! What the title says of the scene. It is read like the words, though spheres have no names in it: an `A` may be an article.

use super::impacts::impacts;
use super::said::Seen;
use super::sentence::{Token, is_one_of, says, sentences};
use super::truth::is_at_rest;
use crate::examine::Finding;
use crate::expr::{Piece, Text};
use crate::mechanics::Sphere;

impl Seen<'_> {
    /// A wall, a third sphere, a sphere at rest or a kind of impact of which the title speaks, and that the scene does not
    /// have.
    pub(super) fn titled(&self, findings: &mut Vec<Finding>) {
        self.headed("title", &self.question.title, findings);
        // `Collisions, direct and oblique, with walls or between spheres` is of many questions.
        let topic = &self.question.topic;
        if topic.split_whitespace().count() <= MOST_OF_A_TOPIC && !topic.contains([',', '&']) && !has_and(topic) {
            self.headed("topic", topic, findings);
        }
    }

    fn headed(&self, of: &str, heading: &str, findings: &mut Vec<Finding>) {
        let title = Text(vec![Piece::Words(heading.to_owned())]);
        let all = impacts(&self.question.scene);
        for sentence in sentences(&title) {
            let known = findings.len();
            self.kind(&sentence, findings);
            self.equal_masses(&sentence, findings);
            // Nobody reads a title on a paper.
            for mut found in findings.split_off(known) {
                found.message = found.message.replacen("the words say", &format!("the {of} says"), 1);
                findings.push(found.as_warning());
            }
            let word = |words: &[&str]| sentence.iter().find(|token| is_one_of(token, words));
            let is_there = |sphere: Sphere| all.iter().any(|impact| impact.has(sphere));
            let is_of_three = sentence.windows(2).any(|pair| {
                is_one_of(&pair[0], &["three"]) && is_one_of(&pair[1], &["spheres", "particles", "balls", "bodies"])
            });
            let rests = |sphere: Sphere| is_there(sphere) && is_at_rest(self.variant, sphere) != Some(false);
            let is_of_rest =
                sentence.windows(2).any(|pair| is_one_of(&pair[0], &["at"]) && is_one_of(&pair[1], &["rest"]));
            // `A is left at rest` is of later.
            let is_of_later = says(&sentence, &["left", "after", "comes", "brought"]);
            let walls = all.iter().filter(|impact| impact.is_wall).count();
            let counted = sentence.windows(2).find_map(|pair| {
                let count = ["two", "three", "four"].iter().position(|count| is_one_of(&pair[0], &[count]))? + 2;
                (is_one_of(&pair[1], &["walls"]) && count > walls && walls > 0).then_some(&pair[0])
            });
            let wrong = [
                counted.map(|at| (at, "of so many walls")),
                word(&["successive"]).filter(|_| all.len() == 1).map(|at| (at, "of successive impacts")),
                word(&["wall", "walls"])
                    .filter(|_| !all.iter().any(|impact| impact.is_wall))
                    .map(|at| (at, "of a wall")),
                word(&["three"]).filter(|_| is_of_three && !is_there(Sphere::C)).map(|at| (at, "of three")),
                word(&["rest"])
                    .filter(|_| is_of_rest && !is_of_later && !Sphere::ALL.into_iter().any(rests))
                    .map(|at| (at, "of one at rest")),
            ];
            for (token, what) in wrong.into_iter().flatten() {
                let Token::Word(at) = token else { continue };
                let has =
                    if what.starts_with("of so many") || what.ends_with("impacts") { "has fewer" } else { "has none" };
                let message = format!("the {of} speaks {what}, and the scene {has}");
                findings.push(self.finding(message, at, &format!("mend the {of}, or the scene")).as_warning());
            }
        }
    }
}

/// The most words of a topic that says what kind of scene it is.
const MOST_OF_A_TOPIC: usize = 3;

fn has_and(topic: &str) -> bool {
    topic.split_whitespace().any(|word| ["and", "or", "with"].contains(&word))
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::said;

    #[test]
    fn a_title_is_of_its_scene() {
        let (rest, direct, wall) =
            ("rest/speeds-and-directions", "direct/velocities-after-impact", "walls/velocity-in-i-and-j");
        let (here, there) = ("A strikes B at rest: speeds and directions", "Direct impact: the velocities after");
        let table = [
            (rest, here, here, ""),
            (rest, here, "Oblique impact with a wall", "the title speaks of a wall"),
            (
                rest,
                here,
                "Direct impact: speeds and directions",
                "the title says `direct`, and in the scene the impact is oblique",
            ),
            (rest, here, "Three spheres: speeds", "the title speaks of three"),
            (rest, here, "Equal masses: speeds and directions", "the title says that masses are equal"),
            (rest, here, "An elastic collision", "the title says `elastic`"),
            (rest, here, "Speeds, directions and what else there is to know", ""),
            (direct, there, "Oblique impact: the velocities after", "says `Oblique`".to_lowercase().as_str()),
            (direct, there, "A sphere strikes another at rest", "the title speaks of one at rest"),
            (direct, there, "Successive impacts: the velocities after", "the title speaks of successive impacts"),
            (direct, "direct impact", "walls", "the topic speaks of a wall"),
            (direct, "direct impact", "direct and oblique impacts, walls", ""),
            (
                "successive/corner",
                "Two walls in turn: a sphere in a corner",
                "Three walls in turn",
                "of so many walls, and the scene has fewer",
            ),
            (wall, "Oblique impact with a wall: velocities in i and j", "A direct way to velocities in i and j", ""),
        ]
        .map(|(id, from, to, wanted)| (id, from, to, wanted.to_owned()));
        for (id, from, to, wanted) in table {
            let said = said(id, &[(&format!("\"{from}\""), &format!("\"{to}\""))]);
            assert!(said.contains(&wanted) && said.is_empty() == wanted.is_empty(), "{to}: {said}");
        }
    }
}
