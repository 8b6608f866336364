//! What the words say of who moves towards a wall, or away from it.

use super::impacts::{impacts, wall_named, wall_of};
use super::said::{Seen, told_before};
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use crate::examine::Finding;
use crate::expr::{Angles, read};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::Value;

/// Words of an impact.
pub(super) const STRUCK: [&str; 14] = [
    "strikes",
    "strike",
    "struck",
    "hits",
    "hit",
    "collides",
    "collide",
    "collided",
    "collision",
    "impact",
    "rebounds",
    "rebound",
    "bounces",
    "then",
];

impl Seen<'_> {
    /// A sphere that is said to move towards a wall and moves away from it, or the other way round; whether something has
    /// been struck in the sentences before.
    pub(super) fn about_a_wall(&self, sentence: &Sentence, is_struck: bool, findings: &mut Vec<Finding>) {
        for place in 0..sentence.len() {
            let (way, is_towards, rest) = match &sentence[place..] {
                [towards, rest @ ..] if is_one_of(towards, &["towards", "toward"]) => ("towards", true, rest),
                [away, from, rest @ ..] if is_one_of(away, &["away"]) && is_one_of(from, &["from"]) => {
                    ("away from", false, rest)
                }
                _ => continue,
            };
            let Some(wall) = wall_named(&self.question.scene, rest) else { continue };
            let moment = told_before(sentence, place).map_or(Moment::Before, |(_, moment)| moment);
            let is_alone = impacts(&self.question.scene).iter().all(|impact| impact.is_of_one());
            let only = is_alone.then_some(Sphere::A);
            let Some(sphere) = subject(&sentence[..place]).or(only) else { continue };
            // With several impacts it is not plain after which, or before which.
            let is_open = !self.question.scene.then.is_empty();
            let is_struck = is_struck || says(&sentence[..place], &STRUCK);
            let approaches = match moment {
                // Who has struck something may be on the way back.
                Moment::Before if is_struck && (is_open || told_before(sentence, place).is_none()) => continue,
                _ if says(sentence, &["not", "no", "never", "neither", "impulse", "force"]) => continue,
                Moment::After if is_open => continue,
                // Whoever has struck it leaves it.
                Moment::After => Some(false),
                Moment::Before => self.approaches(sphere, wall),
            };
            if approaches == Some(!is_towards) {
                let time = if moment == Moment::After { "after the impact" } else { "at first" };
                let name = sphere.name();
                let message = format!("the words say that `*{name}*` moves {way} the wall {time}, and it is not so");
                let help = "say which way it moves, or turn its velocity round in `[scene]`";
                let words = sentence[place..].iter().map_while(|token| match token {
                    Token::Word(word) => Some(word.as_str()),
                    _ => None,
                });
                let words: Vec<&str> = words.take(way.split(' ').count() + 2).collect();
                findings.push(self.finding(message, &words.join(" "), help).as_warning());
            }
        }
    }

    /// Of two in a line with a wall at its end, the one that is said to lie nearer to it and lies further away: `*B* is between
    /// *A* and the wall`, `*B* is nearer to the wall`, `*A* lies beyond *B* as seen from the wall`.
    pub(super) fn nearer_to_a_wall(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let scene = &self.question.scene;
        if !scene.is_in_one_line() || says(sentence, &["not", "no", "never", "speed", "force", "impulse"]) {
            return;
        }
        let Some((near, far, at)) = (0..sentence.len()).find_map(|place| self.said_nearer(sentence, place)) else {
            return;
        };
        let impacts = impacts(scene);
        let all: Vec<Sphere> =
            Sphere::ALL.into_iter().filter(|sphere| impacts.iter().any(|impact| impact.has(*sphere))).collect();
        let strikers: Vec<Sphere> = impacts
            .iter()
            .filter(|impact| impact.is_wall)
            .filter_map(|impact| all.iter().copied().find(|sphere| impact.has(*sphere)))
            .collect();
        // The line runs from A to the others, and a wall is at its end.
        let is_at_end = strikers.iter().all(|striker| Some(striker) == all.last());
        let is_at_start = strikers.iter().all(|striker| Some(striker) == all.first());
        let is_so = match (is_at_end, is_at_start) {
            (true, false) => near > far,
            (false, true) => near < far,
            _ => return,
        };
        if !is_so && all.contains(&near) && all.contains(&far) && near != far {
            let (near, far) = (near.name(), far.name());
            let message =
                format!("the words say that `*{near}*` is nearer to the wall than `*{far}*`, and it is not so");
            let help = "say who lies next to the wall, or change who strikes it in `[scene]`";
            findings.push(self.finding(message, &at, help));
        }
    }

    /// The sphere that is said to be nearer to a wall, the other, and the words that say so.
    fn said_nearer(&self, sentence: &[Token], place: usize) -> Option<(Sphere, Sphere, String)> {
        let scene = &self.question.scene;
        let spheres: Vec<Sphere> = sentence.iter().filter_map(named).collect();
        let other = |own: Sphere| {
            let is_said = spheres.iter().find(|sphere| **sphere != own);
            let is_one_of_two = scene.then.iter().all(|then| !then.of.iter().any(|name| name == "C"));
            is_said.copied().or_else(|| Sphere::BOTH.into_iter().find(|sphere| *sphere != own && is_one_of_two))
        };
        let own = || subject(&sentence[..place]);
        match &sentence[place..] {
            [between, one, and, rest @ ..] if is_one_of(between, &["between"]) && is_one_of(and, &["and"]) => {
                wall_named(scene, rest)?;
                Some((own()?, named(one)?, format!("between *{}*", named(one)?.name())))
            }
            [nearer, rest @ ..] if is_one_of(nearer, &["nearer", "closer", "nearest", "closest"]) => {
                let rest = rest.strip_prefix(&[Token::Word("to".to_owned())]).unwrap_or(rest);
                wall_named(scene, rest)?;
                let Token::Word(word) = nearer else { return None };
                Some((own()?, other(own()?)?, word.clone()))
            }
            [beyond, one, rest @ ..] if is_one_of(beyond, &["beyond"]) => {
                let from = rest.iter().position(|token| is_one_of(token, &["from"]))?;
                wall_named(scene, &rest[from + 1..])?;
                Some((named(one)?, own()?, format!("beyond *{}*", named(one)?.name())))
            }
            _ => None,
        }
    }

    /// The vector along the wall of an impact.
    pub(super) fn along_wall(&self, impact: u8) -> Option<[Value; 2]> {
        let along = wall_of(&self.question.scene, impact)?;
        let [x, y] = [0, 1].map(|at| self.number(&read(&along[at], Angles::Degrees).ok()?));
        Some([x?, y?])
    }

    /// Does a sphere, before it takes part in anything, move towards the wall of an impact? The wall lies where it is
    /// struck from.
    fn approaches(&self, sphere: Sphere, wall: u8) -> Option<bool> {
        let scene = &self.question.scene;
        let impacts = impacts(scene);
        let first = impacts.iter().find(|impact| impact.has(sphere))?.number;
        let striker = *Sphere::ALL.iter().find(|sphere| impacts[usize::from(wall)].has(**sphere))?;
        let [x, y] = self.along_wall(wall)?;
        let (x, y) = (x.to_f64()?, y.to_f64()?);
        let across = |sphere: Sphere, impact: u8| {
            // What it has before one impact it has from the last.
            let last = impacts.iter().rfind(|last| last.number < impact && last.has(sphere));
            let (moment, impact) = last.map_or((Moment::Before, impact), |last| (Moment::After, last.number));
            let of = |axis| {
                let quantity = Quantity::Velocity(sphere, moment, axis).in_impact(impact)?;
                let number = self.known.number(quantity).or_else(|| self.variant.solution.number(quantity))?;
                number.to_f64()
            };
            // In a line across the wall there is no other component.
            Some(of(Axis::X)? * -y + of(Axis::Y).unwrap_or(0.0) * x)
        };
        if (sphere, first) == (striker, wall) {
            return Some(true);
        }
        let (own, towards) = (across(sphere, first)?, across(striker, wall)?);
        (own.abs() > 1e-9 && towards.abs() > 1e-9).then_some(own * towards > 0.0)
    }
}

fn named(token: &Token) -> Option<Sphere> {
    if let Token::Sphere(sphere) = token { Some(*sphere) } else { None }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn who_moves_towards_a_wall_comes_to_it() {
        let table = [
            ("walls/tangents-in-letters", "towards a smooth", "away from a smooth", "away from the wall at first"),
            ("walls/tangents-in-letters", "rebounds from it", "rebounds, moving away from the wall", ""),
            ("successive/second-collision", "{u m/s} along", "{u m/s} towards the wall along", ""),
            ("successive/second-collision", "{u m/s} along", "{u m/s} away from the wall along", "away from the wall"),
        ];
        assert_said(&table);
    }

    #[test]
    fn who_is_nearer_to_a_wall_strikes_it() {
        let (second, between) =
            ("successive/second-collision", "Sphere *B* is at rest between *A* and a smooth vertical wall.");
        let table = [
            (second, "{u m/s} along", "{u m/s} along", ""),
            (
                second,
                between,
                "Sphere *B* is at rest. There is a smooth vertical wall, and *B* is nearer to the wall.",
                "",
            ),
            (
                second,
                between,
                "Sphere *B* is at rest. There is a smooth vertical wall, and *A* is nearer to the wall.",
                "`*A*` is nearer to the wall than `*B*`",
            ),
            (
                second,
                between,
                "Sphere *B* is at rest, and *A* is between *B* and a smooth vertical wall.",
                "`*A*` is nearer to the wall than `*B*`",
            ),
            (
                second,
                between,
                "*B* is at rest near a smooth vertical wall, and *A* lies beyond *B* as seen from the wall.",
                "",
            ),
            (
                second,
                between,
                "*B* is at rest near a smooth vertical wall, and lies beyond *A* as seen from the wall.",
                "`*A*` is nearer to the wall than `*B*`",
            ),
        ];
        assert_said(&table);
    }
}
