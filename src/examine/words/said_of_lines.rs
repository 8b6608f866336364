//! What the words say of how walls and the line of centres lie: parallel to a vector or to each other, or perpendicular.

use super::said::Seen;
use super::sentence::{Sentence, Token, is_one_of, says};
use crate::examine::Finding;
use crate::expr::{Angles, Meaning, print, read};
use crate::mechanics::{Axis, Quantity};
use crate::number::Value;
use crate::unit::Unit;

/// What lies in a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Lies {
    /// The line of centres.
    Line,
    /// A wall, or which of several.
    Wall(Option<usize>),
}

fn is_walls(token: &Token) -> bool {
    is_one_of(token, &["walls"])
}

/// Do words say that something lies in a direction, and not that it moves in one?
fn lies_in(before: &[Token]) -> bool {
    matches!(before, [.., is, within, the] if is_one_of(is, &["is", "was", "lies", "lay", "being"])
        && is_one_of(within, &["in"]) && is_one_of(the, &["the"]))
}

/// Are two directions parallel, or else perpendicular?
pub(super) fn do_lie([x, y]: [Value; 2], [p, q]: [Value; 2], are_parallel: bool) -> bool {
    let turned = if are_parallel { &(&x * &q) - &(&y * &p) } else { &(&x * &p) + &(&y * &q) };
    turned.is_zero()
}

impl Seen<'_> {
    /// Walls and lines of centres that are parallel to a vector, or perpendicular to it.
    pub(super) fn parallel(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let (mut subject, mut nth, mut is_parallel) = (None, None, None);
        for (place, token) in sentence.iter().enumerate() {
            match token {
                Token::Word(word) => match word.as_str() {
                    "first" | "second" | "third" => {
                        nth = ["first", "second", "third"].iter().position(|ordinal| ordinal == word);
                        // `The first wall is parallel to i and the second to j.`
                        if let (Some(Lies::Wall(_)), Some(_)) = (subject, is_parallel) {
                            subject = Some(Lies::Wall(nth));
                        }
                    }
                    "wall" => {
                        if let (Some(Lies::Line), Some(is_parallel)) = (subject, is_parallel) {
                            self.line_beside_wall(is_parallel, nth, "wall", findings);
                        }
                        (subject, nth) = (Some(Lies::Wall(nth)), None);
                    }
                    "centres" => {
                        // `A wall that is perpendicular to the line of centres`
                        let lead = &sentence[place.saturating_sub(5)..place];
                        let is_beside = says(lead, &["parallel", "perpendicular", "normal"]);
                        if let (Some(Lies::Wall(nth)), Some(is_parallel), true) = (subject, is_parallel, is_beside) {
                            self.line_beside_wall(is_parallel, nth, "line", findings);
                        }
                        subject = Some(Lies::Line);
                    }
                    "parallel" | "along" => is_parallel = Some(true),
                    "perpendicular" | "normal" => is_parallel = Some(false),
                    // `The line through the centres is in the direction of {j}`
                    "direction" if subject == Some(Lies::Line) && lies_in(&sentence[..place]) => {
                        is_parallel = Some(true)
                    }
                    "walls" | "velocity" | "component" | "components" | "plane" | "path" | "direction" | "impulse"
                    | "speed" | "moving" | "moves" => (subject, is_parallel) = (None, None),
                    _ => {}
                },
                Token::Number(expr, Unit::None, lead) => {
                    let leads = place.checked_sub(1).map(|before| &sentence[before]);
                    let is_of = place > 1 && is_one_of(&sentence[place - 2], &["direction"]);
                    let is_to = leads.is_some_and(|token| {
                        is_one_of(token, &["to", "vector", "along"]) || (is_of && is_one_of(token, &["of"]))
                    });
                    let (Some(Meaning::Vector(x, y)), Some(lies), Some(is_parallel), true) =
                        (self.meaning(expr), subject, is_parallel, is_to)
                    else {
                        continue;
                    };
                    let Some([p, q]) = self.lies(lies) else { continue };
                    if !do_lie([x, y], [p, q], is_parallel) {
                        let what = if lies == Lies::Line { "line of centres" } else { "wall" };
                        let how = if is_parallel { "parallel" } else { "perpendicular" };
                        let shown = print::unicode(expr);
                        let message = format!("the words say that the {what} is {how} to {shown}, and it is not");
                        let help = format!("say what `[scene]` has for the {what}, or turn it there");
                        findings.push(self.finding(message, lead, &help));
                    }
                }
                _ => {}
            }
        }
    }

    /// A line of centres that is parallel to a wall, or perpendicular to it.
    fn line_beside_wall(&self, is_parallel: bool, nth: Option<usize>, at: &str, findings: &mut Vec<Finding>) {
        let (Some(line), Some(wall)) = (self.lies(Lies::Line), self.lies(Lies::Wall(nth))) else { return };
        if !do_lie(line, wall, is_parallel) {
            let how = if is_parallel { "parallel" } else { "perpendicular" };
            let message = format!("the words say that the line of centres is {how} to the wall, and it is not");
            let help = "say how they lie in `[scene]`, or turn one of them there";
            findings.push(self.finding(message, &format!("{how} to the {at}"), help));
        }
    }

    /// Two walls that are said to be parallel to each other, or perpendicular: `perpendicular walls`, `walls that meet at
    /// right angles`.
    pub(super) fn walls(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let how = |token: &Token| match token {
            token if is_one_of(token, &["parallel"]) => Some(true),
            token if is_one_of(token, &["perpendicular"]) => Some(false),
            _ => None,
        };
        let Some(walls) = sentence.iter().position(is_walls) else {
            self.wall_beside_the_first(sentence, findings);
            return;
        };
        let is_of_them = |token: &&Token| is_one_of(token, &["smooth", "fixed", "vertical"]);
        let described = sentence[..walls].iter().rev().find(|token| !is_of_them(token));
        let described = described.and_then(|token| Some((token, how(token)?)));
        let after = &sentence[walls + 1..];
        // `Parallel to one of them` is of something else.
        let beside = after.windows(4).find_map(|words| {
            let is_each = is_one_of(&words[2], &["each"]) && is_one_of(&words[3], &["other"]);
            let is_one = is_one_of(&words[2], &["one"]) && is_one_of(&words[3], &["another"]);
            Some((&words[0], how(&words[0])?)).filter(|_| is_one_of(&words[1], &["to"]) && (is_each || is_one))
        });
        // `The walls are parallel, …`
        let alone = || {
            const LEADING: [&str; 6] = ["are", "which", "that", "lie", "stand", "vertical"];
            let at = after.iter().position(|token| how(token).is_some())?;
            let ends = match after.get(at + 1) {
                None | Some(Token::Comma) => true,
                Some(next) => is_one_of(next, &["and", "with", "so", "but"]),
            };
            let is_led = after[..at].iter().all(|token| *token == Token::Comma || is_one_of(token, &LEADING));
            Some((&after[at], how(&after[at])?)).filter(|_| is_led && ends)
        };
        let across = || {
            let is_right =
                |pair: &[Token]| is_one_of(&pair[0], &["right"]) && is_one_of(&pair[1], &["angle", "angles"]);
            let at = after.windows(2).position(is_right)?;
            // `It strikes one of the walls at right angles` is of its path.
            let lead = &after[..at];
            let is_verb = |token: &Token| is_one_of(token, &["meet", "meeting", "are", "stand", "standing", "lie"]);
            let is_led = lead.iter().all(|token| is_verb(token) || is_one_of(token, &["that", "which", "at", "a"]));
            (is_led && lead.iter().any(is_verb)).then_some((&after[at], false))
        };
        let Some((Token::Word(word), are_parallel)) = described.or(beside).or_else(alone).or_else(across) else {
            return;
        };
        self.two_walls(are_parallel, word, findings);
    }

    /// `The second wall is parallel to the first`, `is at right angles to the first wall`.
    fn wall_beside_the_first(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const OTHER: [&str; 2] = ["first", "other"];
        let is_wall = |pair: &[Token]| is_one_of(&pair[0], &["second", "other"]) && is_one_of(&pair[1], &["wall"]);
        let Some(second) = sentence.windows(2).position(is_wall) else { return };
        let rest = &sentence[second + 2..];
        let to_the_first = |rest: &[Token]| match rest {
            [to, the, first, rest @ ..] => {
                let ends = rest
                    .first()
                    .is_none_or(|next| !matches!(next, Token::Word(word) if word != "wall" && word != "and"));
                is_one_of(to, &["to", "with"]) && is_one_of(the, &["the"]) && is_one_of(first, &OTHER) && ends
            }
            _ => false,
        };
        let is_led = |at: usize| {
            const LEADING: [&str; 8] = ["is", "which", "that", "lies", "stands", "also", "at", "vertical"];
            rest[..at].iter().all(|token| *token == Token::Comma || is_one_of(token, &LEADING))
        };
        let said = (0..rest.len()).find_map(|at| match &rest[at..] {
            [how, rest @ ..] if is_one_of(how, &["parallel"]) && to_the_first(rest) => Some((at, "parallel", true)),
            [how, rest @ ..] if is_one_of(how, &["perpendicular"]) && to_the_first(rest) => {
                Some((at, "perpendicular", false))
            }
            [right, angles, rest @ ..]
                if is_one_of(right, &["right"]) && is_one_of(angles, &["angles"]) && to_the_first(rest) =>
            {
                Some((at, "right angles", false))
            }
            _ => None,
        });
        if let Some((_, word, are_parallel)) = said.filter(|(at, ..)| is_led(*at)) {
            self.two_walls(are_parallel, word, findings);
        }
    }

    /// The two walls of a scene, which are said to be parallel or else at right angles.
    fn two_walls(&self, are_parallel: bool, word: &str, findings: &mut Vec<Finding>) {
        let lies = |nth| self.lies(Lies::Wall(Some(nth)));
        let (Some(one), Some(other), None) = (lies(0), lies(1), lies(2)) else { return };
        if !do_lie(one, other, are_parallel) {
            let how = if are_parallel { "parallel to each other" } else { "at right angles" };
            let message = format!("the words say that the walls are {how}, and in the scene they are not");
            findings.push(self.finding(message, word, "say how they lie in `[scene]`, or turn a `wall` there"));
        }
    }

    /// How a wall or the line of centres lies.
    fn lies(&self, what: Lies) -> Option<[Value; 2]> {
        let scene = &self.question.scene;
        match what {
            Lies::Line if scene.then.iter().any(|then| then.line_of_centres.is_some()) => None,
            Lies::Line if scene.wall.is_some() => None,
            Lies::Line => {
                let [x, y] = [Axis::X, Axis::Y].map(|axis| self.known.number(Quantity::Line(axis)));
                Some([x?, y?])
            }
            Lies::Wall(nth) => {
                let walls: Vec<_> =
                    scene.wall.iter().chain(scene.then.iter().filter_map(|then| then.wall.as_ref())).collect();
                let wall = match (walls.as_slice(), nth) {
                    ([one], None) => one,
                    (several, nth) => several.get(nth?)?,
                };
                let [x, y] = [0, 1].map(|at| self.number(&read(&wall[at], Angles::Degrees).ok()?));
                Some([x?, y?])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    const CORNER: &str = "successive/corner";
    const MEET: &str = "walls that meet at a\nright angle.";

    #[test]
    fn walls_and_lines_of_centres_lie_as_they_are_said_to() {
        let table = [
            (
                "walls/velocity-in-i-and-j",
                "wall is parallel to {i}",
                "wall is parallel to {j}",
                "the wall is parallel to j",
            ),
            ("walls/velocity-in-i-and-j", "wall is parallel to {i}", "wall is perpendicular to {j}", ""),
            ("walls/velocity-in-i-and-j", "wall is parallel to {i}", "cushion is parallel to {i}", ""),
            (
                "walls/velocity-in-i-and-j",
                "wall is parallel to {i}",
                "cushion is parallel to {j}",
                "the wall is parallel to j",
            ),
            ("i-j/energy-lost", "is parallel to {i}", "is in the direction of {i}", ""),
            ("i-j/energy-lost", "is parallel to {i}", "is in the direction of {j}", "line of centres is parallel to j"),
            ("successive/corner", "and the second to {j}", "and the second to {i}", "the wall is parallel to i"),
            (
                "i-j/energy-lost",
                "is parallel to {i}",
                "is perpendicular to {i}",
                "line of centres is perpendicular to i",
            ),
            (
                "successive/struck-onto-a-wall",
                "which is perpendicular to the wall",
                "which is parallel to the wall",
                "the line of centres is parallel to the wall",
            ),
            ("successive/corner", "meet at a\nright angle", "are perpendicular to each other", ""),
            (
                "successive/corner",
                "that meet at a\nright angle",
                "that are parallel to each other",
                "the walls are parallel",
            ),
            ("successive/corner", "two smooth fixed", "two parallel smooth fixed", "the walls are parallel"),
            (CORNER, MEET, "walls. The walls are parallel.", "the walls are parallel"),
            (CORNER, MEET, "walls, which are perpendicular.", ""),
            (CORNER, MEET, "walls. The second wall is parallel to the first.", "the walls are parallel"),
            (
                CORNER,
                MEET,
                "walls. The second wall, which is parallel to the first wall, is smooth.",
                "the walls are parallel",
            ),
            (CORNER, MEET, "walls. The second wall is at right angles to the first.", ""),
            (CORNER, MEET, "walls. The second wall is struck at right angles to the first path.", ""),
            (
                "successive/corner",
                "meet at a\nright angle.",
                "meet. Between the walls it moves parallel to one of them.",
                "",
            ),
            (
                "successive/walls-at-an-angle",
                "vertical walls.",
                "vertical walls. It meets none of the walls at right angles.",
                "",
            ),
            (
                "successive/walls-at-an-angle",
                "vertical walls.",
                "vertical walls that meet at right angles.",
                "at right angles",
            ),
            (
                "successive/struck-onto-a-wall",
                "which is perpendicular to the wall",
                "and the wall is perpendicular to the line of centres",
                "",
            ),
            (
                "successive/struck-onto-a-wall",
                "which is perpendicular to the wall",
                "and the wall is parallel to the line of centres",
                "the line of centres is parallel to the wall",
            ),
        ];
        assert_said(&table);
    }
}
