//! Is each number called what it is? A speed is no kinetic energy, and a mass no weight.

use super::given::unit_of;
use super::requests::{Thing, thing};
use super::sentence::{BETWEEN, Noun, Sentence, Token, is_one_of, noun_of, sentences};
use crate::bank::Question;
use crate::examine::Finding;
use crate::expr::print;
use crate::mechanics::SceneText;
use crate::unit::Unit;

/// Numbers that the words call something that has another unit.
pub fn otherwise(question: &Question) -> Vec<Finding> {
    let stems = question.styles.iter().flat_map(|style| style.stem.iter().chain([&style.note]));
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    let mut findings: Vec<Finding> = Vec::new();
    for sentence in stems.chain(asks).flat_map(sentences) {
        for place in 0..sentence.len() {
            // Styles share most of their words.
            let found = called(&question.scene, &sentence, place);
            findings.extend(found.filter(|found| !findings.iter().any(|known| known.message == found.message)));
        }
    }
    findings
}

/// The number at a place, if what it is called is not what it is.
fn called(scene: &SceneText, sentence: &Sentence, place: usize) -> Option<Finding> {
    let Token::Number(expr, said, _) = &sentence[place] else { return None };
    if let Some(found) = in_another_unit(scene, sentence, place) {
        return Some(found);
    }
    let unit = if *said == Unit::None { unit_of(expr, scene) } else { *said };
    let is_between = |token: &Token| {
        matches!(token, Token::Sphere(_)) || is_one_of(token, &BETWEEN) || is_one_of(token, &["between"])
    };
    let at = sentence[..place].iter().rposition(|token| !is_between(token))?;
    let (thing, Token::Word(noun)) = (thing(&sentence[at])?, &sentence[at]) else { return None };
    // `After the impulse *A* has {v m/s}` tells when.
    let lead = sentence[..at].iter().rev().find(|token| !is_one_of(token, &["the", "this", "an"]));
    if lead.is_some_and(|lead| is_one_of(lead, &["after", "before"])) {
        return None;
    }
    // `A velocity at 30 degrees`; and a number in the unit of no such thing is told of beside its unit.
    let is_open = matches!(thing, Thing::Speed | Thing::Velocity | Thing::Angle | Thing::Mass | Thing::Ratio);
    if is_open || unit == Unit::None || thing.unit() == Some(unit) {
        return None;
    }
    let what = match unit {
        Unit::Kilogram => "a mass",
        Unit::MetrePerSecond => "a speed or velocity",
        Unit::Degree => "an angle",
        Unit::NewtonSecond => "an impulse",
        _ => return None,
    };
    let (name, unit) = (print::plain(expr), if *said == Unit::None { "" } else { said.plain() });
    let inside = if unit.is_empty() { name.clone() } else { format!("{name} {unit}") };
    let message = format!("the words give `{name}` as `{noun}`, and it is {what}");
    let found = Finding::new(message, format!("{{{inside}}}"), format!("expected {what}"));
    Some(found.with_help("call it what it is, or print the number that is meant"))
}

/// A mass in metres, a speed in kilograms: of a formula that is no quantity of the scene by itself.
fn in_another_unit(scene: &SceneText, sentence: &Sentence, place: usize) -> Option<Finding> {
    let Token::Number(expr, said, _) = &sentence[place] else { return None };
    let (at, noun, is_plural) = noun_of(sentence, place)?;
    // `Of mass {m kg}, is {d m} from it`: what comes after the first number is no mass, but for one of a row.
    let first = at + sentence[at..].iter().position(|token| matches!(token, Token::Number(..)))?;
    let is_of_row = |token: &Token| matches!(token, Token::Number(..) | Token::Comma) || is_one_of(token, &["and"]);
    if first < place && !(is_plural && sentence[first..place].iter().all(is_of_row)) {
        return None;
    }
    let own = match noun {
        Noun::Mass => Unit::Kilogram,
        Noun::Speed | Noun::Velocity => Unit::MetrePerSecond,
        Noun::Angle => Unit::Degree,
        Noun::Radius => Unit::Metre,
    };
    let Token::Word(noun) = &sentence[at] else { return None };
    if *said == Unit::None || *said == own || unit_of(expr, scene) != Unit::None {
        return None;
    }
    let (name, unit) = (print::plain(expr), said.plain());
    let message = format!("the words give `{name}` as `{noun}`, in {unit}");
    let help = match *said == Unit::Metre && scene.symbols.contains_key("m") {
        true => format!("write `{{{name}*m}}` for {name} times the letter *m*"),
        false => format!("write `{{{name} {}}}`, or call it what it is", own.plain()),
    };
    let found = Finding::new(message, format!("{{{name} {unit}}}"), format!("expected {}", own.plain()));
    Some(found.with_help(help))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn each_number_is_called_what_it_is() {
        let rest = "rest/speeds-and-directions";
        let speed = "the speed of *A* is {u m/s}";
        let impulse = ("vector-impulse/velocity-after-an-impulse", "receives an impulse of");
        let table: [(&str, Edits, &str); 11] = [
            (rest, &[], ""),
            (impulse.0, &[], ""),
            (impulse.0, &[(impulse.1, "receives a momentum of")], ""),
            (impulse.0, &[(impulse.1, "receives a kinetic energy of")], "as `energy`, and it is an impulse"),
            (rest, &[(speed, "the kinetic energy of *A* is {u m/s}")], "give `u` as `energy`, and it is a speed"),
            (rest, &[(speed, "*A* has momentum {u m/s}")], "give `u` as `momentum`, and it is a speed"),
            (rest, &[(speed, "*A* has momentum {u}")], "give `u` as `momentum`, and it is a speed"),
            ("ranges/mass-ratio-when-a-goes-on", &[("{k*m} and", "{k m} and")], "give `k` as `masses`, in m"),
            (rest, &[("of mass {mA kg}", "of mass {mA kg}, is {3 m} from a wall")], ""),
            (rest, &[(speed, "the kinetic energy of *A* is great, as it moves at {u m/s}")], ""),
            (rest, &[("*A*, of mass {mA kg}", "*A*, of weight {mA kg}")], "give `mA` as `weight`, and it is a mass"),
        ];
        for (id, edits, words) in table {
            let said: String = otherwise(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
