//! What the words say that one thing is of another, in words alone: masses and speeds that are twice others, speeds that are
//! equal, and how much of the energy is lost.

use std::cmp::Ordering;

use super::said::{Seen, moment, told};
use super::sentence::{Sentence, Token, is_one_of, says, subject};
use crate::examine::Finding;
use crate::expr::{print, written};
use crate::mechanics::{Derivation, Moment, Quantity, Sphere};
use crate::number::Value;
use crate::unit::Unit;

/// Words with which a sentence says less than that it is so, or says that it is not.
const NOT_QUITE: [&str; 15] = [
    "not",
    "never",
    "no",
    "neither",
    "more",
    "less",
    "than",
    "least",
    "most",
    "greater",
    "smaller",
    "about",
    "nearly",
    "almost",
    "approximately",
];

/// One thing to try where something is not so.
const MEND: &str = "mend the numbers or `conditions` of `[scene]`, or say what it is there";

/// What of a sphere is compared with that of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    Mass,
    Speed,
}

/// How many times another thing is said to be there, in which words, and what follows them.
struct Share<'s, 't> {
    times: Value,
    said: String,
    after: &'s [Token<'t>],
}

impl Seen<'_> {
    /// `Twice the mass of *B*`, `equal speeds`, `half of the kinetic energy is lost`.
    pub(super) fn shares(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        if says(sentence, &NOT_QUITE) || !self.question.scene.then.is_empty() {
            return;
        }
        self.equal_speeds(sentence, findings);
        for place in 0..sentence.len() {
            let Some(share) = self.share(&sentence[place..]) else { continue };
            self.times_another(sentence, place, &share, findings);
            self.share_lost(sentence, place, &share, findings);
        }
    }

    /// The share with which words begin: `twice`, `three times`, `half of`, `two thirds of`, `{1/4} of`.
    fn share<'s, 't>(&self, words: &'s [Token<'t>]) -> Option<Share<'s, 't>> {
        const COUNTS: [(&str, i64); 9] = [
            ("a", 1),
            ("one", 1),
            ("two", 2),
            ("three", 3),
            ("four", 4),
            ("five", 5),
            ("six", 6),
            ("seven", 7),
            ("eight", 8),
        ];
        const PARTS: [(&str, i64); 6] =
            [("half", 2), ("third", 3), ("quarter", 4), ("fifth", 5), ("sixth", 6), ("eighth", 8)];
        let counted = |word: &str| COUNTS.iter().find(|(own, _)| *own == word).map(|(_, count)| *count);
        let count = |word: &str| counted(word).or_else(|| word.parse().ok());
        let part = |word: &str| {
            let one = word.strip_suffix('s').unwrap_or(word);
            PARTS.iter().find(|(own, _)| *own == one).map(|(_, part)| *part)
        };
        let next = |at: usize, list: &[&str]| words.get(at).is_some_and(|token| is_one_of(token, list));
        let (times, taken) = match words {
            [Token::Number(expr, Unit::None, _), next, ..] if is_one_of(next, &["times", "of"]) => {
                (self.number(expr)?, if is_one_of(next, &["times"]) { 2 } else { 1 })
            }
            [Token::Word(word), ..] => match word.as_str() {
                "twice" | "double" => (Value::from(2), 1),
                "thrice" => (Value::from(3), 1),
                // Of `two and a half times` this is not all.
                "half" if !next(1, &["times"]) => (Value::fraction(1, 2), 1),
                word if next(1, &["times"]) => (Value::from(count(word)?), 2),
                word => {
                    let (count, part, taken) = match (word.split_once('-'), words.get(1)) {
                        (Some((of, in_parts)), _) => (count(of)?, part(in_parts)?, 1),
                        (None, Some(Token::Word(in_parts))) => (count(word)?, part(in_parts)?, 2),
                        _ => return None,
                    };
                    // `A third sphere` is no part of one; and half is read where it stands.
                    if part == 2 || !next(taken, &["of", "the", "that", "as"]) {
                        return None;
                    }
                    (Value::fraction(count, part), taken)
                }
            },
            _ => return None,
        };
        let each = words[..taken].iter().map(|token| match token {
            Token::Word(word) => word.clone(),
            Token::Number(expr, ..) => print::plain(expr),
            _ => String::new(),
        });
        Some(Share { times, said: each.collect::<Vec<_>>().join(" "), after: &words[taken..] })
    }

    /// A mass or speed that is said to be so many times that of another sphere.
    fn times_another(&self, sentence: &Sentence, place: usize, share: &Share, findings: &mut Vec<Finding>) {
        let before = &sentence[..place];
        let Some((size, other)) = compared_with(before, share.after) else { return };
        let Some(one) = subject(before).filter(|one| *one != other) else { return };
        let wrong = |moment| {
            let of = |sphere| self.size(size, sphere, moment);
            Some(differ(&of(one)?, &(&share.times * &of(other)?)))
        };
        if self.denied(sentence, place, wrong) {
            let what = if size == Size::Mass { "mass" } else { "speed" };
            let (one, other, times) = (one.name(), other.name(), print::unicode(&written(&share.times)));
            let message = format!(
                "the words say that the {what} of `*{one}*` is {times} times that of `*{other}*`, and it is not so"
            );
            findings.push(self.finding(message, &place_of(share), MEND));
        }
    }

    /// The mass or the speed of a sphere.
    fn size(&self, size: Size, sphere: Sphere, moment: Moment) -> Option<Value> {
        self.known.number(match size {
            Size::Mass => Quantity::Mass(sphere),
            Size::Speed => Quantity::Speed(sphere, moment),
        })
    }

    /// Is something wrong at the time of which the words tell; or before and after, where they tell of none?
    fn denied(&self, sentence: &Sentence, place: usize, wrong: impl Fn(Moment) -> Option<bool>) -> bool {
        match told(sentence, place) {
            Some((_, moment)) => wrong(moment) == Some(true),
            None => [Moment::Before, Moment::After].into_iter().all(|moment| wrong(moment) == Some(true)),
        }
    }

    /// Speeds that are said to be equal.
    fn equal_speeds(&self, sentence: &Sentence, findings: &mut Vec<Finding>) {
        let of_both = |token: &Token| {
            matches!(token, Token::Sphere(_)) || is_one_of(token, &["of", "and", "the", "two", "spheres"])
        };
        let is_said = |at: &usize| match &sentence[*at..] {
            [equal, speed, ..] if is_one_of(equal, &["equal", "same"]) && is_one_of(speed, &["speed", "speeds"]) => {
                true
            }
            [are, equal, ..] if is_one_of(are, &["are"]) && is_one_of(equal, &["equal"]) => {
                let lead = sentence[..*at].iter().rev().find(|token| !of_both(token));
                lead.is_some_and(|lead| is_one_of(lead, &["speeds"]))
            }
            _ => false,
        };
        let Some(at) = (0..sentence.len()).find(is_said) else { return };
        let named: Vec<Sphere> =
            Sphere::ALL.into_iter().filter(|sphere| sentence.contains(&Token::Sphere(*sphere))).collect();
        let are_both = match named.as_slice() {
            [] => says(sentence, &["spheres", "they", "both", "each", "balls", "particles"]),
            named => named == Sphere::BOTH,
        };
        // `The same speed as before` is that of one.
        let is_old = sentence[at..].windows(2).any(|pair| match pair {
            [like, next] => is_one_of(like, &["as", "to"]) && is_one_of(next, &["before", "it", "its", "that"]),
            _ => false,
        });
        if !are_both || is_old || self.is_alone() {
            return;
        }
        let wrong = |moment| {
            let of = |sphere| self.size(Size::Speed, sphere, moment);
            Some(differ(&of(Sphere::A)?, &of(Sphere::B)?))
        };
        if self.denied(sentence, at, wrong) {
            let message = "the words say that the speeds are equal, and it is not so".to_owned();
            let words = sentence[at..].iter().take(2).filter_map(|token| match token {
                Token::Word(word) => Some(word.as_str()),
                _ => None,
            });
            findings.push(self.finding(message, &words.collect::<Vec<_>>().join(" "), MEND));
        }
    }

    /// The share of the kinetic energy that is said to be lost.
    fn share_lost(&self, sentence: &Sentence, place: usize, share: &Share, findings: &mut Vec<Finding>) {
        const LOST: [&str; 5] = ["lost", "loses", "lose", "losing", "dissipated"];
        const DESCRIBED: [&str; 9] =
            ["of", "the", "its", "their", "total", "initial", "original", "kinetic", "combined"];
        let Some(energy) = share.after.iter().position(|token| !is_one_of(token, &DESCRIBED)) else { return };
        let (described, after) = share.after.split_at(energy);
        let is_lost = match after {
            [energy, rest @ ..] if is_one_of(energy, &["energy"]) => {
                says(rest, &LOST[..1]) || place > 0 && is_one_of(&sentence[place - 1], &LOST)
            }
            _ => false,
        };
        if !is_lost || moment(sentence, place) == Moment::After && told(sentence, place).is_none() {
            return;
        }
        let owner = after.iter().skip(1).take(4).find_map(|token| match token {
            Token::Sphere(sphere) => Some(*sphere),
            _ => None,
        });
        let is_of_it = says(described, &["its"]);
        let owner = owner.or_else(|| subject(&sentence[..place]).filter(|_| is_of_it));
        let lost = match owner.or(self.is_alone().then_some(Sphere::A)) {
            Some(sphere) => self.lost_by(sphere),
            None if is_of_it => None,
            None => self.lost_by_all(),
        };
        // More than the whole is lost in hundredths.
        let is_percentage = (&share.times - &Value::ONE).sign() == Some(Ordering::Greater);
        let whole = Value::from(if is_percentage { 100 } else { 1 });
        if lost.is_some_and(|(lost, of)| differ(&(&lost * &whole), &(&share.times * &of))) {
            let message = format!("the words say that {} of the kinetic energy is lost, and it is not so", share.said);
            findings.push(self.finding(message, &place_of(share), MEND));
        }
    }

    /// What a sphere loses of its energy, and that energy, both for a mass of 2.
    fn lost_by(&self, sphere: Sphere) -> Option<(Value, Value)> {
        let squared = |moment| self.size(Size::Speed, sphere, moment).map(|speed| &speed * &speed);
        let before = squared(Moment::Before)?;
        Some((&before - &squared(Moment::After)?, before))
    }

    /// What both lose together, of one that they have.
    fn lost_by_all(&self) -> Option<(Value, Value)> {
        let mut known = self.known.clone();
        Derivation::carry_out(&mut known, &[Quantity::FractionLost]);
        Some((known.number(Quantity::FractionLost)?, Value::ONE))
    }
}

/// Are two things of which neither is below nought known not to be equal?
fn differ(one: &Value, other: &Value) -> bool {
    (&(one * one) - &(other * other)).sign().is_some_and(Ordering::is_ne)
}

/// What the words after a share compare it with: `the mass of *B*`, `that of *B*`, `as heavy as *B*`.
fn compared_with(before: &[Token], after: &[Token]) -> Option<(Size, Sphere)> {
    const JOINED: [&str; 8] = ["the", "of", "that", "as", "large", "sphere", "ball", "particle"];
    const OTHERS: [&str; 9] =
        ["velocity", "radius", "energy", "component", "momentum", "impulse", "angle", "distance", "magnitude"];
    let size = |token: &Token| match token {
        Token::Word(word) => match word.as_str() {
            "mass" | "heavy" => Some(Some(Size::Mass)),
            "speed" | "fast" => Some(Some(Size::Speed)),
            word if OTHERS.contains(&word) => Some(None),
            _ => None,
        },
        _ => None,
    };
    let end = after.iter().position(|token| matches!(token, Token::Sphere(_)))?;
    let Token::Sphere(other) = after[end] else { return None };
    let between = &after[..end];
    if !between.iter().all(|token| is_one_of(token, &JOINED) || size(token).is_some()) {
        return None;
    }
    let named = between.iter().find_map(size);
    let size = named.or_else(|| before.iter().rev().find_map(size).filter(|_| says(between, &["that"])));
    Some((size??, other))
}

/// The words of a share with the one after it.
fn place_of(share: &Share) -> String {
    match share.after.first() {
        Some(Token::Word(next)) => format!("{} {next}", share.said),
        _ => share.said.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::assert_said;

    #[test]
    fn what_is_so_many_times_another_is_so() {
        let table = [
            ("rest/speeds-and-directions", "the plane. The", "the plane and is not brought to rest. The", ""),
            (
                "rest/speeds-and-directions",
                "which is at rest on the plane",
                "which is at rest on the plane, and *A* then moves on",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. The mass of *A* is 20 times that of *B*.",
                "`*A*` is 20 times that of `*B*`",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. The mass of *A* is half that of *B*.",
                "the mass of `*A*` is 1/2 times that of `*B*`",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* has five times the mass of *B*.",
                "the mass of `*A*` is 5 times that",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* has more than five times the mass of *B*.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* has {mA/mB} times the mass of *B*.",
                "",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. *A* is a third as heavy as *B*.",
                "is 1/3 times that",
            ),
            (
                "direct/one-sphere-catches-the-other",
                "collide directly.",
                "collide directly. The speed of *A* is three times that of *B*.",
                "the speed of `*A*` is 3 times that",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "Half of the kinetic energy is lost. The coefficient",
                "half of the kinetic energy",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "*A* loses {1/7} of its kinetic energy. The coefficient",
                "1/7 of the kinetic energy",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "{99.5}% of the total kinetic energy is lost. The coefficient",
                "99.5 of the kinetic",
            ),
            (
                "both-moving/energy-lost-and-impulse",
                "The coefficient",
                "If half of the kinetic energy is lost, it is warm. The coefficient",
                "",
            ),
        ];
        assert_said(&table);
    }
}
