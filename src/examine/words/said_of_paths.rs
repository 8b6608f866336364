//! What the words say of the line in which a sphere moves, before the impact or after it: along the line of centres, parallel
//! to a wall or to a vector, or at right angles to them.

use super::said::{Seen, told};
use super::said_of_lines::do_lie;
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use crate::examine::Finding;
use crate::expr::{Meaning, print};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Value;

/// A line in which a sphere may move.
#[derive(Clone, Debug)]
enum Line {
    /// The line of centres.
    Centres,
    /// The wall.
    Wall,
    /// The line of a vector, with its components and as it is printed.
    Vector([Value; 2], String),
}

/// How a sphere is said to move.
struct Path {
    line: Line,
    is_parallel: bool,
    /// The words that say so.
    said: String,
}

impl Seen<'_> {
    /// A sphere that is said to move towards itself.
    pub(super) fn towards_itself(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        for (place, token) in sentence.iter().enumerate() {
            if is_one_of(token, &["towards"])
                && let (Some(own), Some(Token::Sphere(other))) = (subject(&sentence[..place]), sentence.get(place + 1))
                && own == *other
            {
                let name = own.name();
                let message = format!("the words have `*{name}*` move towards itself");
                findings.push(self.finding(message, &format!("towards *{name}*"), "name the other sphere"));
            }
        }
    }

    /// A sphere that is said to move along a line, or perpendicular to it. Of what is told later nobody knows the time, unless
    /// the sentence says it.
    pub(super) fn lines_of_motion(&self, sentence: &Sentence, is_later: bool, findings: &mut Vec<Finding>) {
        const MOVES: [&str; 4] = ["moving", "moves", "travelling", "travels"];
        for place in (0..sentence.len()).filter(|place| is_one_of(&sentence[*place], &MOVES)) {
            let moment = match told(sentence, place) {
                Some((_, moment)) => moment,
                None if is_later => continue,
                None => Moment::Before,
            };
            if !self.question.scene.then.is_empty() || says(&sentence[..place], &["not", "never"]) {
                continue;
            }
            let alone = || self.is_alone().then_some(Sphere::A);
            let Some(sphere) = subject(&sentence[..place]).or_else(alone) else { continue };
            let Some(path) = self.path(&sentence[place + 1..]) else { continue };
            if self.moves_along(sphere, moment, &path) == Some(false) {
                let how = if path.is_parallel { "along" } else { "perpendicular to" };
                let line = match &path.line {
                    Line::Centres => "the line of centres",
                    Line::Wall => "the wall",
                    Line::Vector(_, shown) => shown,
                };
                let then = if moment == Moment::After { "then " } else { "" };
                let message =
                    format!("the words say that `*{}*` {then}moves {how} {line}, and it is not so", sphere.name());
                let help = match moment {
                    Moment::Before => "name in the words how it moves in `[scene]`, or change it there",
                    Moment::After => "mend the numbers or `conditions` of `[scene]`, or say how it moves",
                };
                findings.push(self.finding(message, &path.said, help));
            }
        }
    }

    /// Spheres that are said to move on opposite sides of the line of centres before the impact, or on the same side of it.
    pub(super) fn sides(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        const OF_LINE: [&str; 3] = ["of", "the", "line"];
        let is_side = |words: &&[Token]| {
            is_one_of(&words[0], &["opposite", "same"])
                && is_one_of(&words[1], &["side", "sides"])
                && words[2..].iter().zip(OF_LINE).all(|(token, word)| is_one_of(token, &[word]))
        };
        let Some(words) = sentence.windows(5).find(is_side) else { return };
        let is_after = says(sentence, &["after", "then"]) && !says(sentence, &["before"]);
        let across = Sphere::BOTH.map(|sphere| {
            let across = self.known.number(Quantity::Velocity(sphere, Moment::Before, Axis::T))?;
            across.sign().filter(|sign| sign.is_ne())
        });
        let ([Some(a), Some(b)], false, Token::Word(said)) = (across, is_after, &words[0]) else { return };
        if (a == b) != (said == "same") && self.question.scene.then.is_empty() {
            let sides = if said == "same" { "the same side" } else { "opposite sides" };
            let message =
                format!("the words say that the spheres move on {sides} of the line of centres, and it is not so");
            let help = "turn one of their velocities to the other side in `[scene]`, or say on which side it is";
            findings.push(self.finding(message, &format!("{said} side"), help));
        }
    }

    /// Two spheres that are said to move in lines at right angles to each other: `along perpendicular lines`.
    pub(super) fn perpendicular_paths(&self, sentence: &Sentence, is_later: bool, findings: &mut Vec<Finding>) {
        const PATHS: [&str; 4] = ["lines", "paths", "directions", "courses"];
        let is_said = |pair: &[Token]| is_one_of(&pair[0], &["perpendicular"]) && is_one_of(&pair[1], &PATHS);
        let Some(place) = sentence.windows(2).position(is_said) else { return };
        let moment = match told(sentence, place) {
            Some((_, moment)) => moment,
            None if is_later => return,
            None => Moment::Before,
        };
        // The lines of walls and of unit vectors are others.
        if says(sentence, &["wall", "walls", "vectors", "not", "never"]) || self.is_alone() {
            return;
        }
        let along = |axis| {
            let of = |sphere| self.known.number(Quantity::Velocity(sphere, moment, axis));
            Some(&of(Sphere::A)? * &of(Sphere::B)?)
        };
        let across = if self.question.scene.is_in_one_line() { Some(Value::ZERO) } else { along(Axis::Y) };
        let (Some(along), Some(across)) = (along(Axis::X), across) else { return };
        if (&along + &across).sign().is_some_and(|sign| sign.is_ne()) {
            let then = if moment == Moment::After { "then " } else { "" };
            let message = format!("the words say that the spheres {then}move in perpendicular lines, and it is not so");
            let help = "say how they move in `[scene]`, or change it there";
            findings.push(self.finding(message, "perpendicular", help));
        }
    }

    /// The line that comes next after `moving`, if it is that of the motion.
    fn path(&self, after: &[Token]) -> Option<Path> {
        const OF_ANOTHER: [&str; 10] =
            ["angle", "component", "when", "where", "which", "so", "is", "are", "while", "and"];
        let mut way: Option<(bool, usize)> = None;
        let clause = after.iter().take_while(|token| !matches!(token, Token::Comma | Token::Sphere(_))).take(12);
        for (at, token) in clause.enumerate() {
            let follows = |words: &[&str]| at > 0 && is_one_of(&after[at - 1], words);
            let line = match token {
                Token::Word(word) => match word.as_str() {
                    word if OF_ANOTHER.contains(&word) => return None,
                    "along" | "parallel" => {
                        way = Some((true, at));
                        continue;
                    }
                    "perpendicular" | "normal" => {
                        way = Some((false, at));
                        continue;
                    }
                    "angles" if follows(&["right"]) => {
                        way = Some((false, at - 1));
                        continue;
                    }
                    "centres" => Line::Centres,
                    "wall" => Line::Wall,
                    _ => continue,
                },
                Token::Number(expr, ..) => match self.meaning(expr) {
                    Some(Meaning::Vector(x, y)) if follows(&["to", "along", "vector"]) => {
                        Line::Vector([x, y], print::unicode(expr))
                    }
                    _ if way.is_some() => return None,
                    _ => continue,
                },
                _ => continue,
            };
            let (is_parallel, start) = way?;
            let words = after[start..].iter().map_while(|token| match token {
                Token::Word(word) => Some(word.as_str()),
                _ => None,
            });
            let said = words.take(4).collect::<Vec<_>>().join(" ");
            return Some(Path { line, is_parallel, said });
        }
        None
    }

    /// Does a sphere move so? None if it is at rest, or if that is not known.
    fn moves_along(&self, sphere: Sphere, moment: Moment, path: &Path) -> Option<bool> {
        let component = |axis| self.known.number(Quantity::Velocity(sphere, moment, axis));
        // What must be nought, and what must not, or nothing moves.
        let none_across = |along, across| {
            let (none, some) = if path.is_parallel { (across, along) } else { (along, across) };
            let is_none = component(none)?.is_zero();
            if is_none && component(some).is_none_or(|some| some.is_zero()) { None } else { Some(is_none) }
        };
        match &path.line {
            Line::Centres => none_across(Axis::N, Axis::T),
            Line::Wall => self.question.scene.wall.as_ref().and_then(|_| none_across(Axis::T, Axis::N)),
            Line::Vector(line, _) => {
                let [x, y] = [Axis::X, Axis::Y].map(component);
                let velocity = [x?, y?];
                let is_at_rest = velocity.iter().all(Value::is_zero);
                (!is_at_rest).then(|| do_lie(velocity, line.clone(), path.is_parallel))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn lines_in_which_spheres_move_are_their_lines() {
        let table = [
            (
                "both-moving/paths-at-right-angles",
                "{uA} perpendicular to the line",
                "{uA} along the line",
                "`*A*` moves along the line of centres",
            ),
            (
                "both-moving/paths-at-right-angles",
                "centres, towards *A*",
                "centres, towards *B*",
                "have `*B*` move towards itself",
            ),
            (
                "rest/speeds-and-directions",
                "Immediately before the collision the speed",
                "Sphere *A* moves perpendicular to the line of centres. The speed",
                "`*A*` moves perpendicular to the line",
            ),
            (
                "rest/speeds-and-directions",
                "Immediately before the collision the speed",
                "*A* moves parallel to the line of centres. The speed",
                "`*A*` moves along the line of centres",
            ),
            (
                "rest/speeds-and-directions",
                "The coefficient",
                "After the collision *B* moves along the line of centres. The coefficient",
                "",
            ),
            (
                "rest/speeds-and-directions",
                "The coefficient",
                "After the collision *A* moves along the line of centres. The coefficient",
                "`*A*` then moves along",
            ),
            (
                "rest/speeds-and-directions",
                "The coefficient",
                "Immediately after the collision *B* moves at right angles to the line of centres. The coefficient",
                "`*B*` then moves perpendicular to the line of centres",
            ),
            (
                "i-j/energy-lost",
                "The coefficient",
                "Immediately before the collision *A* is moving parallel to {i}. The coefficient",
                "moves along i",
            ),
            (
                "i-j/energy-lost",
                "The coefficient",
                "After the collision *B* is not moving parallel to {i}. The coefficient",
                "",
            ),
            (
                "walls/velocity-in-i-and-j",
                "The coefficient",
                "Before the impact *A* moves parallel to the wall. The coefficient",
                "moves along the wall",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "The spheres move on opposite sides of the line of centres. The coefficient",
                "on opposite sides of the line",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "The spheres move on the same side of the line of centres. The coefficient",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "in the same direction along the same\nstraight line",
                "along perpendicular lines",
                "move in perpendicular lines",
            ),
            (
                "i-j/energy-lost",
                "The coefficient",
                "Before the collision they move in perpendicular directions. The coefficient",
                "in perpendicular lines",
            ),
            (
                "rest/speeds-and-directions",
                "The coefficient",
                "Their paths are then in perpendicular directions. The coefficient",
                "",
            ),
            ("both-moving/components-given", "towards *B*, and", "towards *A*, and", "have `*A*` move towards itself"),
        ];
        assert_said(&table);
    }
}
