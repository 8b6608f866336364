//! Is each thing that the words of a part request found by an answer, and is anything requested at all?

use super::requests::{Request, Thing, requests, thing};
use super::sentence::{Sentence, Token, in_order, is_one_of, is_supposed, says, sentences};
use super::units::{Stated, stated};
use crate::answer::Kind;
use crate::bank::{Answer, Code, Find, Part, Question, Style};
use crate::examine::Finding;
use crate::expr::{Expr, Piece, Relation, print};
use crate::mechanics::Quantity;

/// Things that are requested and that no answer finds, and answers of another form than that in which they are requested.
pub fn unfound(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let said: Vec<Sentence> = part.ask.iter().flat_map(sentences).collect();
        let asked: Vec<Sentence> = said.iter().filter(|words| !is_supposed(words)).cloned().collect();
        let found = [
            nothing(part, &said),
            found_by_none(part, &asked),
            size_of_a_vector(part, &asked),
            speed_of_a_vector(part, &asked),
            explained(part, &said),
            given(question, &asked),
            in_terms_of_numbers(question, &asked),
            other_line(part, &asked),
            other_unit(part),
        ];
        findings.extend(found.into_iter().flatten().map(|found| found.at_row(place, "answers", 0)));
        findings.extend(called_a_velocity(place, part));
    }
    findings
}

fn all<'s>(asked: &'s [Sentence<'s>]) -> impl Iterator<Item = Request<'s>> {
    asked.iter().flat_map(|sentence| requests(sentence))
}

/// `What happens next?`
fn nothing(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    let is_of_something = |token: &Token| {
        let is_other =
            is_one_of(token, &["vector", "fast", "far", "quickly", "much", "loss", "reduction", "values", "value"]);
        thing(token).is_some() || is_other || matches!(token, Token::Number(..))
    };
    let is_shown = part.answers.iter().any(|answer| answer.kind == Kind::Shown);
    // `Calculate _e_.`
    let has_letter = part.ask.iter().flat_map(|text| &text.0).any(|piece| matches!(piece, Piece::Italic(_)));
    if is_shown || has_letter || part.answers.is_empty() || asked.iter().flatten().any(is_of_something) {
        return None;
    }
    let name = part.answers.first().map(|answer| print::text_unicode(&answer.name)).unwrap_or_default();
    let found = Finding::new("the words name nothing that is to be found", "", "nobody is asked for it");
    Some(found.with_help(format!("ask for what the answers are, as in `Find the {name}.`")).as_warning())
}

/// `Find the speed of A, and state its direction`, where no answer is a direction.
fn found_by_none(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    // A letter that is found may be of anything; so may what is shown.
    let is_open = |answer: &Answer, request: &Request| match (&answer.find, answer.kind) {
        (_, Kind::Shown) => true,
        (Find::Unknown(_), _) | (_, Kind::Range) => !request.said().contains("friction"),
        _ => false,
    };
    let is_named = |answer: &Answer, request: &Request| {
        let name = print::text_unicode(&answer.name).to_lowercase();
        let is_strange = |token: &&Token| thing(token) == Some(Thing::Strange);
        let noun = request.words.iter().find(is_strange).filter(|_| request.thing == Thing::Strange);
        matches!(noun, Some(Token::Word(noun)) if name.contains(noun.as_str()))
    };
    let is_found = |request: &Request| {
        part.answers.iter().any(|answer| {
            is_open(answer, request)
                || is_named(answer, request)
                || answer.find.quantities().into_iter().any(|quantity| request.is_found_by(quantity))
        })
    };
    let request = all(asked).find(|request| !is_found(request))?;
    let change = if request.is_change { "a change of " } else { "" };
    let message = format!("the words ask for {change}`{}`, and no answer of the part finds it", request.said());
    let found = Finding::new(message, "", "the answers of the part");
    Some(found.with_help("ask for what the answers are, or add an answer that finds it").as_warning())
}

/// `The magnitude of the impulse`, where the answer is a vector.
fn size_of_a_vector(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    let request = all(asked).find(|request| {
        let finds =
            |answer: &&Answer| answer.find.quantities().into_iter().any(|quantity| request.is_found_by(quantity));
        let mut found = part.answers.iter().filter(finds).peekable();
        request.is_size && found.peek().is_some() && found.all(|answer| matches!(answer.find, Find::Vector(..)))
    })?;
    let message = format!("the words ask for the magnitude of the {}, and the answer is a vector", request.said());
    let help = "ask for it in terms of {i} and {j}, or find its magnitude, as in `impulse.magnitude`";
    Some(Finding::new(message, "", "a vector").with_help(help))
}

/// `The speed of each sphere`, where the answers are velocities in terms of **i** and **j**.
fn speed_of_a_vector(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    // A vector says which way too.
    let is_way = |request: &Request| matches!(request.thing, Thing::Velocity | Thing::Angle);
    if all(asked).any(|request| is_way(&request)) {
        return None;
    }
    all(asked).find(|request| {
        let finds =
            |answer: &&Answer| answer.find.quantities().into_iter().any(|quantity| request.is_found_by(quantity));
        let mut found = part.answers.iter().filter(finds).peekable();
        request.thing == Thing::Speed
            && found.peek().is_some()
            && found.all(|answer| matches!(answer.find, Find::Vector(..)))
    })?;
    let found = Finding::new("the words ask for a speed, and the answer is a vector", "", "a vector");
    let help = "ask for the velocity in terms of {i} and {j}, or find its size, as in `A.after.speed`";
    Some(found.with_help(help))
}

/// An answer by the name of `velocity` that is a speed.
fn called_a_velocity(place: usize, part: &Part) -> Option<Finding> {
    let is_speed = |answer: &Answer| match answer.find {
        Find::Quantity(quantity) => matches!(quantity.of_its_impact(), Quantity::Speed(..)),
        _ => false,
    };
    let is_called = |answer: &Answer| {
        let name = sentences(&answer.name);
        name.iter().any(|name| says(name, &["velocity"]) && !says(name, &["magnitude", "size"]))
    };
    let row = part.answers.iter().position(|answer| is_speed(answer) && is_called(answer))?;
    let name = print::text_unicode(&part.answers[row].name);
    let found = Finding::new(format!("the answer `{name}` is a speed"), "", "without its direction");
    Some(found.with_help("call it a speed, or find the velocity").at_row(place, "answers", row).as_warning())
}

/// `Explain why`, `show that`, where no answer is of that kind.
fn explained(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    const TO_EXPLAIN: [&str; 5] = ["explain", "justify", "comment", "sketch", "describe"];
    let is_marked = part.marks.iter().any(|mark| mark.code == Code::E1);
    if is_marked || part.answers.iter().any(|answer| answer.kind == Kind::Shown) {
        return None;
    }
    let is_shown = |pair: &[Token]| is_one_of(&pair[0], &["show", "prove"]) && is_one_of(&pair[1], &["that"]);
    // `Describe the direction` is answered by an angle.
    let is_described = part.answers.iter().any(|answer| {
        answer.kind == Kind::Range || answer.find.quantities().iter().any(|quantity| quantity.is_angle())
    });
    let is_open = |token: &&Token| is_one_of(token, &TO_EXPLAIN) && !(is_described && is_one_of(token, &["describe"]));
    let word = asked.iter().flatten().find(is_open);
    let said = match word {
        Some(Token::Word(word)) => word.clone(),
        // Where nothing is to be found besides, this is told as of the whole part.
        _ => asked
            .iter()
            .find(|sentence| sentence.windows(2).any(is_shown) && !requests(sentence).is_empty())
            .map(|_| "show that".to_owned())?,
    };
    let found = Finding::new(format!("the words say `{said}`, and no answer of the part takes it"), "", "to be found");
    let help = "take it out, or give it a mark `E1`, or an answer of kind `shown`";
    Some(found.with_help(help).as_warning())
}

/// `Find the value of {e}`, where that is a number that is given.
fn given(question: &Question, asked: &[Sentence]) -> Option<Finding> {
    let is_given = |name: &str| question.styles.iter().any(|style| style.parameters.iter().any(|(own, _)| own == name));
    let name = asked.iter().flat_map(|sentence| sentence.windows(3)).find_map(|words| match words {
        [value, of, Token::Number(Expr::Name(name), ..)]
            if is_one_of(value, &["value", "values"]) && is_one_of(of, &["of"]) =>
        {
            Some(name.text.as_str()).filter(|name| is_given(name) || is_told(question, name))
        }
        _ => None,
    })?;
    let told = if is_given(name) { "the paper prints as a number" } else { "they tell themselves" };
    let message = format!("the words ask for the value of `{name}`, which {told}");
    Some(Finding::new(message, "", "it is given").with_help("ask for what the answers are"))
}

/// `Where {tan(theta) = t}`: do the words before the parts say what a letter is, by what is given?
fn is_told(question: &Question, name: &str) -> bool {
    let is_open = |expr: &Expr| expr.names().iter().any(|name| question.scene.unknowns.contains(&name.text));
    let tells = |piece: &&Piece| match piece {
        Piece::Formula(Expr::Relation(left, Relation::Equal, right)) => {
            left.names().iter().map(|name| name.text.as_str()).eq([name]) && !is_open(left) && !is_open(right)
        }
        _ => false,
    };
    question.styles.iter().all(|style| {
        let mut pieces = Vec::new();
        style.stem.iter().for_each(|text| in_order(&text.0, &mut pieces));
        pieces.iter().any(tells)
    })
}

/// `Find, in terms of {u}`, where that is a number on every sheet.
fn in_terms_of_numbers(question: &Question, asked: &[Sentence]) -> Option<Finding> {
    let is_plain = |style: &Style, name: &str| {
        let domain = style.parameters.iter().find(|(own, _)| own == name).map(|(_, domain)| domain);
        domain.is_some_and(|domain| (0..domain.size().min(100)).all(|place| domain.value(place).names().is_empty()))
    };
    let is_number = |name: &str| question.styles.iter().all(|style| is_plain(style, name));
    // `In terms of 3m`: a number and a letter.
    let is_multiple = |name: &str| {
        let is_letter = |expr: &Expr| matches!(expr, Expr::Name(_));
        question.styles.iter().any(|style| {
            let mut values = style.parameters.iter().filter(|(own, _)| own == name).map(|(_, domain)| domain);
            let formula = style.lets.iter().find(|(own, _)| own == name).map(|(_, formula)| formula);
            formula.is_some_and(|formula| !is_letter(formula))
                || values.any(|values| (0..values.size().min(100)).any(|place| !is_letter(&values.value(place))))
        })
    };
    let lists = asked.iter().flat_map(|sentence| {
        let ends = sentence
            .windows(2)
            .enumerate()
            .filter(|(_, pair)| is_one_of(&pair[0], &["terms"]) && is_one_of(&pair[1], &["of"]));
        ends.map(|(at, _)| &sentence[at + 2..])
    });
    let name = lists.into_iter().find_map(|list| {
        let list = list.iter().take_while(|token| {
            matches!(token, Token::Number(..) | Token::Comma) || is_one_of(token, &["and", "only"])
        });
        list.filter_map(|token| match token {
            Token::Number(Expr::Name(name), ..) if is_number(&name.text) || is_multiple(&name.text) => {
                Some(name.text.clone())
            }
            _ => None,
        })
        .next()
    })?;
    if !is_number(&name) {
        let message = format!("the words ask for it in terms of `{name}`, which is not always a letter by itself");
        let found = Finding::new(message, "", "it may be a number of times a letter");
        return Some(found.with_help("name the letters, as in `in terms of {m} and {u}`").as_warning());
    }
    let message = format!("the words ask for it in terms of `{name}`, which the paper prints as a number");
    let found = Finding::new(message, "", "it is a number");
    Some(found.with_help(format!("take `{name}` out, or make it a letter in `[scene.symbols]`")))
}

/// `A vector parallel to the common tangent`, where the answer is along the line of centres; `a unit vector`.
fn other_line(part: &Part, asked: &[Sentence]) -> Option<Finding> {
    let is_along_it =
        part.answers.iter().find_map(|answer| match answer.find.quantities().first()?.of_its_impact() {
            Quantity::Line(_) => Some(true),
            Quantity::Tangent(_) => Some(false),
            _ => None,
        })?;
    let sentence = asked.iter().find(|sentence| says(sentence, &["vector", "direction"]))?;
    let is_turned = says(sentence, &["perpendicular", "normal"]);
    let of = match (says(sentence, &["centres", "centers"]), says(sentence, &["tangent"])) {
        (true, false) => !is_turned,
        (false, true) => is_turned,
        _ => is_along_it,
    };
    let has = |is_along| if is_along { "along the line of centres" } else { "along the common tangent" };
    if of != is_along_it {
        let message = format!("the words ask for a vector {}, and the answer is one {}", has(of), has(is_along_it));
        let find = if of { "`n.x` and `n.y`" } else { "`t.x` and `t.y`" };
        return Some(
            Finding::new(message, "", has(is_along_it)).with_help(format!("find {find}, or ask for the other")),
        );
    }
    let found = || {
        let message = "the words ask for a unit vector, and any vector along the line is accepted";
        Finding::new(message, "", "of any length").with_help("ask for a vector parallel to the line").as_warning()
    };
    // `In terms of the unit vectors {i} and {j}` is how.
    let is_unit = |pair: &[Token]| is_one_of(&pair[0], &["unit"]) && is_one_of(&pair[1], &["vector"]);
    sentence.windows(2).any(is_unit).then(found)
}

/// The unit in which words ask for something: `in km/h`.
pub fn unit_asked(asked: &str) -> Option<(&'static str, Stated)> {
    asked.match_indices(" in ").find_map(|(at, lead)| stated(&asked[at + lead.len()..]))
}

/// `In km/h`, `in newtons`: a unit of none of the answers.
fn other_unit(part: &Part) -> Option<Finding> {
    let units: Vec<_> =
        part.answers.iter().filter_map(|answer| answer.find.quantities().first().map(|q| q.unit())).collect();
    let asked = part.ask.iter().map(print::text_unicode).collect::<Vec<_>>().join(" ");
    let (written, unit) = unit_asked(&asked)?;
    // What is shown, and a letter, are stated as the words say.
    if units.len() < part.answers.len() || matches!(unit, Stated::In(unit) if units.contains(&unit)) {
        return None;
    }
    let own: Vec<&str> = units.iter().map(|unit| unit.plain()).filter(|unit| !unit.is_empty()).collect();
    let has = own.first().map_or_else(|| "has no unit".to_owned(), |unit| format!("is stated in {unit}"));
    let message = format!("the words ask for it in `{written}`, and the answer {has}");
    let help = own
        .first()
        .map_or_else(|| "leave the unit out".to_owned(), |unit| format!("write `in {unit}`, or leave it out"));
    Some(Finding::new(message, "", "in another unit").with_help(help))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn what_is_requested_is_found() {
        let (line, after) = ("direct/one-sphere-catches-the-other", "direct/velocities-after-impact");
        let (speed, impulse) =
            ("Find the speed of *B* immediately after the collision.", "Find the magnitude of the impulse that");
        let energy = "Find the total kinetic energy lost in the collision.";
        let vector = "Find a vector parallel to the line of centres of";
        let back = "backwards/velocity-of-b-and-line-of-centres";
        let turned = "ranges/turned-back-by-an-oblique-impact";
        let backwards = "backwards/speed-of-b-and-energy-lost";
        let table: [(&str, Edits, &str); 46] = [
            (line, &[], ""),
            (backwards, &[], ""),
            (backwards, &[("in terms of {m}", "in terms of {mA}")], "`mA`, which is not always a letter by itself"),
            (turned, &[], ""),
            (
                turned,
                &[("ask = \"", "ask = \"Find the value of {alpha}. ")],
                "value of `alpha`, which they tell themselves",
            ),
            (line, &[(speed, "Find, in terms of {u}, the speed of *B*.")], "in terms of `u`, which the paper prints"),
            (line, &[(speed, "Find the speed of *B* in terms of {mA}.")], "in terms of `mA`"),
            ("rest-letters/direction-and-deflection", &[], ""),
            ("i-j/velocities-after-impact", &[], ""),
            (
                "i-j/velocities-after-impact",
                &[("Find, in terms of {i} and {j}, the velocity of each", "Find the speed of each")],
                "ask for a speed, and the answer is a vector",
            ),
            (
                "i-j/velocities-after-impact",
                &[("Find, in terms of {i} and {j}, the velocity of each", "Find the speed and direction of each")],
                "",
            ),
            ("i-j/speeds-after-impact", &[], ""),
            (line, &[(speed, "Find the coefficient of restitution.")], "`coefficient of restitution`, and no answer"),
            (line, &[(speed, "Find the ratio of the speeds of *A* and *B*.")], "`ratio of the speeds`"),
            (line, &[(speed, "Find the change in the speed of *B*.")], "a change of `speed of *B*`"),
            (line, &[(speed, "Find the speed of approach of the spheres.")], "`speed of approach of`"),
            (line, &[(speed, "Find the speed with which the spheres separate.")], "`speed with which the`"),
            (line, &[(speed, "Find the distance between the spheres.")], "`distance between the spheres`"),
            (line, &[(speed, "What happens next?")], "name nothing that is to be found"),
            (line, &[(speed, "How fast does *B* move immediately after the collision?")], ""),
            (line, &[(speed, "Find the value of {e}.")], "the value of `e`, which the paper prints"),
            (line, &[(speed, "Find, in km/h, the speed of *B* immediately after the collision.")], "in `km/h`"),
            (line, &[(speed, "Find, in m/s, the speed of *B* immediately after the collision.")], ""),
            (line, &[(energy, "Work out the reduction in the total KE.")], ""),
            (line, &[(energy, "Find the KE lost.")], ""),
            (line, &[(energy, "Find, in kilojoules, the total kinetic energy lost in the collision.")], "`kilojoules`"),
            (line, &[(energy, "Find the total kinetic energy lost in the collision, in newtons.")], "stated in J"),
            (after, &[], ""),
            (after, &[("\"speed of *A*\"", "\"velocity of *A*\"")], "the answer `velocity of A` is a speed"),
            (
                after,
                &[(impulse, "State the direction of motion of *A*, and find the magnitude of the impulse that")],
                "`direction of motion of`",
            ),
            (
                after,
                &[(impulse, "Explain whether energy is conserved, and find the magnitude of the impulse that")],
                "say `explain`",
            ),
            (
                after,
                &[(impulse, "Show that momentum is conserved, and find the magnitude of the impulse that")],
                "say `show that`",
            ),
            (after, &[(impulse, "Find the magnitude of the force that")], "`force that *A* exerts`"),
            (
                after,
                &[("impulse that *A* exerts on *B*.", "momentum of *B* after the collision.")],
                "`momentum of *B* after`",
            ),
            (
                "walls/tangents-in-letters",
                &[(
                    "letters given, the magnitude of the impulse that the wall exerts on",
                    "letters given, the energy that the wall gives to",
                )],
                "`energy that the wall`",
            ),
            (
                "both-moving/speeds-and-fraction-of-energy-lost",
                &[("total kinetic energy of the spheres that", "total momentum of the spheres that")],
                "`fraction of the total`",
            ),
            (after, &[("impulse that *A* exerts on *B*.", "momentum that *A* gives to *B*.")], ""),
            (after, &[("impulse that *A* exerts on *B*.", "change in the momentum of *B*.")], ""),
            (
                "backwards/velocity-of-b-and-restitution",
                &[("coefficient of restitution between the spheres.\"", "coefficient of friction.\"")],
                "`coefficient of friction`",
            ),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("Find, in terms of {i} and {j}, the impulse on", "Find the magnitude of the impulse on")],
                "the answer is a vector",
            ),
            (
                back,
                &[(vector, "Find a vector parallel to the common tangent of")],
                "along the common tangent, and the answer is one along the line",
            ),
            (back, &[(vector, "Find a vector perpendicular to the line of centres of")], "along the common tangent"),
            (back, &[(vector, "Find a vector perpendicular to the common tangent of")], ""),
            (back, &[(vector, "Find a unit vector parallel to the line of centres of")], "ask for a unit vector"),
            (
                back,
                &[(
                    vector,
                    "Find, in terms of the unit vectors {i} and {j}, a vector in the direction of the line of centres of",
                )],
                "",
            ),
            (
                "rest/speeds-and-directions",
                &[(
                    "Find the speed and the direction of motion of each",
                    "Find the speed, and describe the direction of motion, of each",
                )],
                "",
            ),
        ];
        for (id, edits, words) in table {
            let said: String = unfound(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
