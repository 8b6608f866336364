//! What a number in a sentence is of: the noun that names it, or the words around it.

use super::measured::measured_from;
use super::sentence::{Token, is_one_of};
use crate::expr::Expr;
use crate::unit::Unit;
use Token::{Number, Word};

/// What a number in a sentence is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Noun {
    /// A mass.
    Mass,
    /// A speed.
    Speed,
    /// A velocity.
    Velocity,
    /// An acute angle.
    Angle,
    /// A radius.
    Radius,
}

/// Words that may stand between the name of a quantity and its number, beside names, numbers and commas.
pub(super) const BETWEEN: [&str; 34] = [
    "of",
    "is",
    "are",
    "was",
    "has",
    "have",
    "the",
    "a",
    "an",
    "and",
    "sphere",
    "spheres",
    "ball",
    "particle",
    "immediately",
    "just",
    "before",
    "after",
    "it",
    "they",
    "collide",
    "strikes",
    "collision",
    "impact",
    "at",
    "that",
    "instant",
    "respectively",
    "then",
    "both",
    "acute",
    "this",
    "for",
    "meet",
];

/// What the number at a place of a sentence is of, if that is plain.
pub fn noun_of(sentence: &[Token], place: usize) -> Option<(usize, Noun, bool)> {
    if let Some((at, noun)) = unnamed(sentence, place) {
        return Some((at, noun, false));
    }
    for (at, token) in sentence[..place].iter().enumerate().rev() {
        let Word(word) = token else { continue };
        let (noun, is_plural) = match word.as_str() {
            "mass" => (Noun::Mass, false),
            "masses" => (Noun::Mass, true),
            "speed" => (Noun::Speed, false),
            "speeds" => (Noun::Speed, true),
            "velocity" => (Noun::Velocity, false),
            "velocities" => (Noun::Velocity, true),
            "angle" => (Noun::Angle, false),
            "angles" => (Noun::Angle, true),
            "radius" => (Noun::Radius, false),
            "radii" => (Noun::Radius, true),
            word if BETWEEN.contains(&word) => continue,
            "impulse" if is_of_time(&sentence[..at]) => continue,
            _ => return angle_between(&sentence[..place]),
        };
        return Some((at, noun, is_plural));
    }
    None
}

/// `The angles between their paths and the line of centres, both acute, are` some number.
fn angle_between(before: &[Token]) -> Option<(usize, Noun, bool)> {
    const OF_LINES: [&str; 19] = [
        "between",
        "their",
        "its",
        "path",
        "paths",
        "direction",
        "directions",
        "motion",
        "line",
        "centres",
        "to",
        "perpendicular",
        "normal",
        "common",
        "tangent",
        "wall",
        "joining",
        "spheres",
        "balls",
    ];
    let at = before
        .windows(2)
        .rposition(|pair| is_one_of(&pair[0], &["angle", "angles"]) && is_one_of(&pair[1], &["between"]))?;
    let is_led = |token: &Token| match token {
        Word(word) => OF_LINES.contains(&word.as_str()) || BETWEEN.contains(&word.as_str()),
        _ => true,
    };
    let is_plural = is_one_of(&before[at], &["angles"]);
    before[at + 1..].iter().all(is_led).then_some((at, Noun::Angle, is_plural))
}

/// What a number is of that nothing names, `moving at {alpha deg} to the wall` and `moving at {u m/s}`.
fn unnamed(sentence: &[Token], place: usize) -> Option<(usize, Noun)> {
    let at = place.checked_sub(1).filter(|at| is_one_of(&sentence[*at], &["at"]))?;
    let Number(expr, unit, _) = sentence.get(place)? else { return None };
    let after = &sentence[place + 1..];
    let is_to_a_line = || {
        let leads = after.first().is_some_and(|next| is_one_of(next, &["to", "with"]));
        leads && measured_from(after).is_some()
    };
    match unit {
        Unit::Degree if is_to_a_line() => Some((at, Noun::Angle)),
        Unit::None if matches!(expr, Expr::Name(_)) && is_to_a_line() => Some((at, Noun::Angle)),
        Unit::MetrePerSecond if !matches!(expr, Expr::Vector(..)) => Some((at, Noun::Speed)),
        _ => None,
    }
}

/// Do words lead to what comes before or after an impulse, `before the` and `after it receives the`?
fn is_of_time(lead: &[Token]) -> bool {
    let last = lead.iter().rev().find(|token| !is_one_of(token, &["the", "this", "an", "receives", "it"]));
    last.is_some_and(|token| is_one_of(token, &["before", "after"]))
}
