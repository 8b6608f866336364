//! Numbers that stand in the words as they were typed, without braces: they are the same in every variant.

use super::given::{names_in, names_of_scene};
use super::sentence::in_order;
use super::units::typed_unit;
use crate::bank::Question;
use crate::examine::Finding;
use crate::expr::{Angles, Expr, Meaning, Piece, Text, evaluate, print, read};
use crate::unit::Unit;

/// Masses, speeds and angles that the words give in plain digits, where no formula of the scene has them.
pub fn beside_the_scene(question: &Question) -> Vec<Finding> {
    let mut findings: Vec<Finding> = Vec::new();
    for style in &question.styles {
        let mut there = names_of_scene(question);
        there.extend(style.lets.iter().flat_map(|(_, formula)| names_in(&print::plain(formula))));
        let asks = question.parts.iter().flat_map(|part| &part.ask);
        for text in style.stem.iter().chain([&style.note]).chain(asks) {
            findings.extend(letters(text, question));
            findings.extend(in_pieces(text));
            let is_there = |typed: &Typed| there.contains(&typed.digits) || is_of_a_line(typed, question);
            for typed in quantities(text).into_iter().filter(|typed| !is_there(typed)) {
                let Typed { shown, digits, unit } = typed;
                let message = format!("the words give `{shown}` in plain digits, and nothing in the scene has it");
                let help = format!(
                    "write the name that `[scene]` has, as in `{{u {unit}}}`; or `{{{digits} {unit}}}`, and `{digits}` in `[scene]`"
                );
                let found = Finding::new(message, shown, "the same in every variant");
                findings.push(found.with_help(help).as_warning());
            }
        }
    }
    findings.sort_by(|one, other| one.message.cmp(&other.message));
    findings.dedup();
    findings
}

/// Is it the angle that a wall or a line of centres makes with an axis in every variant?
fn is_of_a_line(typed: &Typed, question: &Question) -> bool {
    let scene = &question.scene;
    let later = scene.then.iter().flat_map(|then| [&then.wall, &then.line_of_centres]);
    let mut lines = [&scene.wall, &scene.line_of_centres].into_iter().chain(later).flatten();
    let component = |text: &String| match evaluate(&read(text, Angles::Degrees).ok()?, &|_| None) {
        Ok(Meaning::Number(value)) => value.to_f64(),
        _ => None,
    };
    let Some(said) = typed.digits.parse::<f64>().ok().filter(|_| typed.unit == Unit::Degree.plain()) else {
        return false;
    };
    lines.any(|[x, y]| {
        let (Some(x), Some(y)) = (component(x), component(y)) else { return false };
        let angle = y.abs().atan2(x.abs()).to_degrees();
        [angle, 90.0 - angle, 180.0 - angle].into_iter().any(|angle| (angle - said).abs() < 1e-6)
    })
}

/// Letters of the scene that stand in the words without braces, alone or after a number: `of mass m`, `2u`.
fn letters(text: &Text, question: &Question) -> Vec<Finding> {
    let symbols = &question.scene.symbols;
    // `A` and `I` are words too.
    let is_letter = |word: &str| {
        let is_short = word.len() == 1 && !["a", "i"].contains(&word);
        symbols.get(word).is_some_and(|range| is_short || range == "acute")
    };
    // A Greek letter may be typed as it is.
    let name_of = |letter: &str| match read(letter, Angles::Degrees) {
        Ok(Expr::Name(name)) if !letter.is_ascii() => name.text,
        _ => letter.to_owned(),
    };
    let mut pieces = Vec::new();
    in_order(&text.0, &mut pieces);
    let mut findings = Vec::new();
    for piece in pieces {
        let Piece::Words(words) = piece else { continue };
        let mut before = "";
        for word in words.split_whitespace() {
            let bare = word.trim_matches(|sign: char| !sign.is_alphanumeric());
            let letter = bare.trim_start_matches(|sign: char| sign.is_ascii_digit());
            let name = name_of(letter);
            // `2 m` is a length.
            let is_unit = before.ends_with(|sign: char| sign.is_ascii_digit());
            if is_letter(&name) && !is_unit {
                let factor = bare.strip_suffix(letter).filter(|factor| !factor.is_empty());
                let times = factor.map_or_else(String::new, |factor| format!("{factor}*"));
                let message = format!("the words give `{bare}` without braces, and `{name}` is a letter of the scene");
                let found = Finding::new(message, format!("{before} {word}"), "no formula");
                findings.push(found.with_help(format!("write `{{{times}{name}}}`")).as_warning());
            }
            before = word;
        }
    }
    findings
}

/// A vector that is put together from its components: one of them may be below nought, or one.
fn in_pieces(text: &Text) -> Option<Finding> {
    let mut pieces = Vec::new();
    in_order(&text.0, &mut pieces);
    let is_unit = |expr: &Expr| matches!(expr, Expr::Name(name) if ["i", "j"].contains(&name.text.as_str()));
    let (number, vector) = pieces.windows(2).find_map(|pair| match pair {
        [Piece::Formula(number), Piece::Formula(vector)] if is_unit(vector) && !is_unit(number) => {
            Some((print::plain(number), print::plain(vector)))
        }
        _ => None,
    })?;
    let message = format!("the words put a vector together from `{{{number}}}` and `{{{vector}}}`");
    let found = Finding::new(message, format!("{{{number}}}{{{vector}}}"), "it reads badly where a component is -1");
    Some(found.with_help("write it in one, as in `{[p, q] m/s}`"))
}

/// A number with its unit that was typed.
pub struct Typed {
    /// As it stands.
    pub shown: String,
    /// The number.
    pub digits: String,
    /// The name of its unit.
    pub unit: &'static str,
}

/// The numbers of a text that were typed with a unit; of right angles nothing is said.
pub fn quantities(text: &Text) -> Vec<Typed> {
    let mut found = Vec::new();
    for words in text.0.iter().filter_map(|piece| if let Piece::Words(words) = piece { Some(words) } else { None }) {
        let mut rest = words.as_str();
        while let Some(start) = rest.find(|sign: char| sign.is_ascii_digit()) {
            let is_within = rest[..start].ends_with(|sign: char| sign.is_alphanumeric() || "./".contains(sign));
            let number = &rest[start..];
            let end = number.find(|sign: char| !(sign.is_ascii_digit() || sign == '.')).unwrap_or(number.len());
            let (digits, after) = number.split_at(end);
            // A right angle and a straight one are the same in every variant, and may be.
            let is_turn = ["90", "180", "360"].contains(&digits);
            if let Some((written, unit)) =
                typed_unit(after).filter(|(_, unit)| !is_within && (!is_turn || *unit != Unit::Degree))
            {
                let length = after.find(written).unwrap_or(0) + written.len();
                let shown = number[..end + length].to_owned();
                found.push(Typed { shown, digits: digits.to_owned(), unit: unit.plain() });
            }
            rest = after;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn numbers_and_letters_stand_in_braces() {
        let (rest, wall) = ("rest/speeds-and-directions", "walls/restitution-from-two-angles");
        let table: [(&str, Edits, &str); 13] = [
            (rest, &[], ""),
            (rest, &[("{u m/s} and", "4 m/s and")], "give `4 m/s` in plain digits"),
            (rest, &[("{alpha deg} with", "30 degrees with")], "give `30 degrees` in plain digits"),
            (rest, &[("the plane.", "the plane, on which a right angle has 90°.")], ""),
            (rest, &[("the plane.", "the plane, in 3 parts of 2 m.")], ""),
            (
                "walls/velocity-in-i-and-j",
                &[
                    ("wall   = [\"1\", \"0\"]", "wall   = [\"1\", \"1\"]"),
                    ("parallel to {i}", "inclined at 45° to {i}"),
                ],
                "",
            ),
            (
                "walls/velocity-in-i-and-j",
                &[
                    ("wall   = [\"1\", \"0\"]", "wall   = [\"1\", \"1\"]"),
                    ("parallel to {i}", "inclined at 30° to {i}"),
                ],
                "give `30°` in plain digits",
            ),
            (wall, &[], ""),
            (wall, &[("mass {m} is", "mass m is")], "give `m` without braces"),
            (wall, &[("mass {m} is", "mass 2m is")], "give `2m` without braces"),
            (wall, &[("angle {alpha} with", "angle alpha with")], "give `alpha` without braces"),
            (wall, &[("angle {alpha} with", "angle α with")], "give `α` without braces"),
            (
                "vector-impulse/mass-from-the-speed-after",
                &[("{[x, y] m/s}", "({x}{i} + {y}{j}) m/s")],
                "together from `{x}` and `{i}`",
            ),
        ];
        for (id, edits, words) in table {
            let said: String =
                beside_the_scene(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
