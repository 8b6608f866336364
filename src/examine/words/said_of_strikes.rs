//! What the words say of who strikes, and how: a sphere at rest strikes nobody, and who meets a wall along it or at an angle
//! does not strike it at right angles.

use super::impacts::impacts;
use super::said::Seen;
use super::said_of_walls::STRUCK;
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use super::truth::is_at_rest;
use crate::examine::Finding;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// One who does it is the sphere that moves.
const STRIKES: [&str; 3] = ["strikes", "hits", "meets"];

/// `Goes on to hit`, of one who does hit.
fn goes_on(before: &[Token]) -> bool {
    matches!(before, [.., goes, on, to, hit] if is_one_of(goes, &["goes", "went", "moves"]) && is_one_of(on, &["on"])
        && is_one_of(to, &["to"]) && is_one_of(hit, &["hit", "strike", "meet"]))
}

impl Seen<'_> {
    /// `*A* is struck by *B*` or `*B* strikes *A*`, where *B* is at rest until the first collision, which is theirs.
    pub(super) fn striking(&self, sentence: &Sentence, is_struck: bool, findings: &mut Vec<Finding>) {
        if says(sentence, &["not", "no", "never", "again"]) {
            return;
        }
        let is_struck_word = |token: &Token| is_one_of(token, &STRUCK) && !is_one_of(token, &["then"]);
        let Some(at) = sentence.iter().position(is_struck_word) else { return };
        let said = match &sentence[at..] {
            [struck, by, Token::Sphere(striker), ..]
                if is_one_of(struck, &["struck", "hit"]) && is_one_of(by, &["by"]) =>
            {
                Some((*striker, *striker))
            }
            [strikes, Token::Sphere(other), ..] if is_one_of(strikes, &STRIKES) || goes_on(&sentence[..=at]) => {
                subject(&sentence[..at]).filter(|striker| striker != other).map(|striker| (striker, *other))
            }
            _ => None,
        };
        let Some((striker, named)) = said else { return };
        if let Some(strangers) = self.never_meet(&[Token::Sphere(striker), Token::Sphere(named)]) {
            let message = format!("the words speak of a collision of {strangers}, and in the scene they do not meet");
            let help = "name in the words those that meet in `[scene]`, or let others meet there with `of`";
            findings.push(self.finding(message, &format!("*{}*", named.name()), help));
            return;
        }
        let at = format!("{}*{}*", if striker == named { "by " } else { "" }, named.name());
        let all = impacts(&self.question.scene);
        let of_it = |number: usize| all.get(number).filter(|one| one.has(striker) && !one.is_of_one());
        // After the first impact only who is struck in the next, and never again, is known to be at rest until then.
        let is_first = match is_struck {
            false => of_it(0).is_some(),
            true => of_it(1).is_some() && all.iter().filter(|one| one.has(striker)).count() == 1,
        };
        if is_first && is_at_rest(self.variant, striker) == Some(true) {
            let name = striker.name();
            let message = format!("the words say that `*{name}*` strikes, and in the scene it is at rest before that");
            findings.push(self.finding(message, &at, "name the one that moves as the one that strikes"));
        }
    }

    /// `Strikes a wall at right angles`, where the path makes another angle with it.
    pub(super) fn squarely(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let Some(at) = sentence.iter().position(|token| is_one_of(token, &STRIKES)) else { return };
        let is_oblique = || {
            let along = Quantity::Velocity(Sphere::A, Moment::Before, Axis::T);
            self.known.number(along).is_some_and(|along| along.sign().is_some_and(|sign| sign.is_ne()))
        };
        if self.question.scene.wall.is_none() || !self.question.scene.then.is_empty() || !is_oblique() {
            return;
        }
        let near = &sentence[at..sentence.len().min(at + 8)];
        let how = near.iter().enumerate().find_map(|(place, token)| match token {
            Token::Word(word) if ["perpendicularly", "head-on", "squarely"].contains(&word.as_str()) => {
                Some(word.clone())
            }
            Token::Word(word) if word == "at" => {
                let is_right = near.get(place + 1).is_some_and(|next| is_one_of(next, &["right"]))
                    && near.get(place + 2).is_some_and(|next| is_one_of(next, &["angles"]));
                // `At right angles to its old path` is said of something else.
                let is_of_other = near.get(place + 3).is_some_and(|next| is_one_of(next, &["to", "with"]));
                let comes_late = near[..place].iter().any(|token| is_one_of(token, &["and", "moves", "rebounds"]));
                (is_right && !is_of_other && !comes_late).then(|| "at right angles".to_owned())
            }
            _ => None,
        });
        if let Some(how) = how {
            let message = format!("the words say that the wall is struck {how}, and in the scene it is not");
            findings.push(self.finding(
                message,
                &how,
                "say `obliquely`, or turn the wall or the velocity in `[scene]`",
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::said;
    use crate::examine::Edits;

    #[test]
    fn who_strikes_is_who_moves_and_a_third_collision_is_one_more_than_two() {
        let (second, wall) = ("successive/second-collision", "walls/rebound-speed-and-direction");
        let line = "successive/no-more-collisions";
        let meeting = "After *B* has struck *C*, *A* does not strike *B* again.";
        let directly = "when it strikes *B* directly";
        let table: [(&str, Edits, &str); 17] = [
            (second, &[], ""),
            (
                second,
                &[(directly, "when it is struck by *B* directly")],
                "`*B*` strikes, and in the scene it is at rest",
            ),
            (second, &[(directly, "when *B* strikes *A* directly")], "`*B*` strikes, and in the scene it is at rest"),
            (second, &[(directly, "when *B* is struck by *A* directly")], ""),
            (
                wall,
                &[("it strikes a smooth", "it strikes at right angles a smooth")],
                "the wall is struck at right angles",
            ),
            (wall, &[("it strikes a smooth", "it strikes head-on a smooth")], "the wall is struck head-on"),
            (line, &[], ""),
            (
                line,
                &[("then *B* strikes *C*", "then *C* strikes *B*")],
                "`*C*` strikes, and in the scene it is at rest",
            ),
            (line, &[("then *B* strikes *C*", "then *C* is struck by *B*")], ""),
            (
                line,
                &[("then *B* strikes *C*", "then *A* strikes *C*")],
                "`*A*` and `*C*`, and in the scene they do not meet",
            ),
            (line, &[("then *B* strikes *C*", "and *A* goes on to hit *C*")], "`*A*` and `*C*`"),
            (line, &[("then *B* strikes *C*", "and *B* goes on to hit *C*")], ""),
            (line, &[(meeting, "There is no third collision.")], ""),
            (line, &[(meeting, "There is a third collision.")], "they do not meet"),
            (line, &[(meeting, "There are exactly two collisions.")], ""),
            (line, &[(meeting, "There are exactly three collisions.")], "they do not meet"),
            (line, &[(meeting, "There are only two collisions between the spheres.")], ""),
        ];
        for (id, edits, words) in table {
            let said = said(id, edits);
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
