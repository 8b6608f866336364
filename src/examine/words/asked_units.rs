//! Do the words name a quantity that is stated in the unit of what is found?

use super::requests::requests;
use super::sentence::{Sentence, Token, sentences};
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::examine::Finding;
use crate::expr::print;
use crate::mechanics::Quantity;
use crate::unit::Unit;

/// Words that name a quantity, and the unit in which it is stated.
const QUANTITIES: [(&str, Unit); 16] = [
    ("speed", Unit::MetrePerSecond),
    ("speeds", Unit::MetrePerSecond),
    ("velocity", Unit::MetrePerSecond),
    ("velocities", Unit::MetrePerSecond),
    ("angle", Unit::Degree),
    ("angles", Unit::Degree),
    ("direction", Unit::Degree),
    ("directions", Unit::Degree),
    ("impulse", Unit::NewtonSecond),
    ("momentum", Unit::NewtonSecond),
    ("energy", Unit::Joule),
    ("ke", Unit::Joule),
    ("mass", Unit::Kilogram),
    // `How fast`, `how quickly`, `describe its motion`.
    ("fast", Unit::MetrePerSecond),
    ("quickly", Unit::MetrePerSecond),
    ("describe", Unit::Degree),
];

/// Answers that are stated in another unit than what they are called, or than what is asked for.
pub fn stated_otherwise(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let asked = part.ask.iter().map(print::text_unicode).collect::<Vec<_>>().join(" ");
        let names = part.answers.iter().enumerate().filter_map(|(row, answer)| {
            let (said, unit) = misnamed(&print::text_unicode(&answer.name), &[answer])?;
            let message = format!("the answer `{}` is stated in {unit}", print::text_unicode(&answer.name));
            let help = "give it the name of what `find` finds, or find what it is called";
            Some(
                Finding::new(message, "", format!("its name says {said}"))
                    .with_help(help)
                    .at_row(place, "answers", row),
            )
        });
        findings.extend(names);
        for (row, answer) in part.answers.iter().enumerate() {
            let is_else = |words: &str| misnamed(words, &[answer]).filter(|_| !is_beside(&asked, answer));
            // `Use the speeds to find the loss in energy` speaks of more than is asked.
            let requested = requested(part);
            let found = is_else(&asked).filter(|_| requested.is_empty() || is_else(&requested).is_some());
            let Some((said, unit)) = found else { continue };
            let name = print::text_unicode(&answer.name);
            let message = format!("the words ask for what is stated in {said}, and the answer `{name}` is in {unit}");
            let found = Finding::new(message, "", "found here");
            let help = "ask for what `find` finds, or find what is asked for";
            findings.push(found.with_help(help).at_row(place, "answers", row));
        }
    }
    findings
}

/// What a part requests, without what it says of how and where.
fn requested(part: &Part) -> String {
    let said: Vec<Sentence> = part.ask.iter().flat_map(sentences).collect();
    let words = said.iter().flat_map(|sentence| requests(sentence)).flat_map(|request| request.words);
    let words = words.filter_map(|token| if let Token::Word(word) = token { Some(word.as_str()) } else { None });
    words.collect::<Vec<_>>().join(" ")
}

/// A unit that the words name, and that of the answers, if none of these has any that the words name.
fn misnamed(words: &str, answers: &[&Answer]) -> Option<(&'static str, &'static str)> {
    let lower = words.to_lowercase();
    let words = lower.split(|sign: char| !sign.is_alphabetic());
    let said: Vec<Unit> =
        words.filter_map(|word| QUANTITIES.iter().find(|(known, _)| *known == word)).map(|(_, unit)| *unit).collect();
    let unit = |answer: &&Answer| match &answer.find {
        // A vector may be asked for as a direction.
        Find::Quantity(quantity) if !matches!(answer.kind, Kind::Shown | Kind::Range) => quantity.unit(),
        _ => Unit::None,
    };
    let is_other = |answer: &&Answer| !matches!(unit(answer), Unit::None) && !said.contains(&unit(answer));
    let (first, is_beside) = (said.first()?, answers.iter().all(is_other));
    is_beside.then(|| Some((first.plain(), unit(answers.first()?).plain()))).flatten()
}

/// Is an angle asked for beside what has a unit, as the direction of a velocity or a deflection is?
///
/// Or a magnitude, of which the words before may have told what it is of?
fn is_beside(asked: &str, answer: &Answer) -> bool {
    let is_size = matches!(&answer.find, Find::Quantity(quantity) if matches!(quantity.of_its_impact(), Quantity::ImpulseMagnitude | Quantity::Speed(..)));
    if is_size && ["magnitude", "size"].iter().any(|word| asked.contains(word)) {
        return true;
    }
    const ANGLES: [&str; 7] = ["velocit", "deflect", "inclin", "bearing", "turn", "theta", "alpha"];
    let is_angle = matches!(&answer.find, Find::Quantity(quantity) if quantity.unit() == Unit::Degree);
    is_angle && ANGLES.iter().any(|word| asked.contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn what_is_asked_for_in_other_words_is_no_other_thing() {
        let (rest, line) = ("rest/speeds-and-directions", "direct/one-sphere-catches-the-other");
        let each = "Find the speed and the direction of motion of each";
        let energy = "Find the total kinetic energy lost in the collision.";
        let table: [(&str, Edits, &str); 6] = [
            (rest, &[], ""),
            (rest, &[(each, "Find how fast and in what direction of motion goes each")], ""),
            (rest, &[(each, "How fast is, and at what angle to the line of centres moves, each")], ""),
            (line, &[(energy, "Use the speeds before and after the impact to find the loss in KE.")], ""),
            (line, &[(energy, "By considering the velocities, find how much KE is lost.")], ""),
            (line, &[(energy, "Find the impulse.")], "is stated in N s, and the answer `kinetic energy lost` is in J"),
        ];
        for (id, edits, words) in table {
            let said: String =
                stated_otherwise(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            let words = words.trim_start_matches("is ");
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
