//! Do the words of a part ask for this very answer: of this sphere, this angle, one value or a set of them?

use super::asked_count::otherwise;
use super::asked_energy::{energy_at_a_moment, energy_of_another, of_several_impacts, other_energy};
use super::sentence::{Sentence, Token, is_one_of, is_supposed, says, sentences};
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::examine::Finding;
use crate::expr::{Expr, Function, print};
use crate::mechanics::{Quantity, Sphere};

/// Answers for which the words of their part do not ask, though they ask for something of the kind. What makes the paper
/// wrong must be mended; where the words may be read in another way it is a warning.
pub fn others(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let all: Vec<Sentence> = part.ask.iter().flat_map(sentences).filter(|words| !is_supposed(words)).collect();
        for (row, answer) in part.answers.iter().enumerate() {
            let found = of_another_by_name(answer).or_else(|| of_another(answer, part, &all));
            let found = found.or_else(|| of_another_at_once(answer, part, &all));
            let found = found.or_else(|| of_several_impacts(question, answer, &all));
            let found = found.or_else(|| energy_of_another(question, answer, &all));
            let found = found.or_else(|| another_letter(answer, &all)).or_else(|| no_coefficient(answer, &all));
            let found = found.or_else(|| another_angle(answer, &all)).or_else(|| set(answer, &all));
            let found = found.or_else(|| another_function(answer, &all)).or_else(|| other_energy(answer, part, &all));
            let found = found.or_else(|| size_alone(answer, part, &all));
            let found = found.or_else(|| energy_at_a_moment(answer, part, &all));
            let help = "ask for what `find` finds, or find what is asked for";
            let with_help = |found: Finding| if found.help.is_some() { found } else { found.with_help(help) };
            findings.extend(found.map(|found| with_help(found).at_row(place, "answers", row)));
        }
        let counted = otherwise(part, &all).into_iter();
        findings.extend(counted.map(|(row, found)| found.at_row(place, "answers", row)));
    }
    findings
}

/// The name of an answer has one sphere, and what is found is of another.
fn of_another_by_name(answer: &Answer) -> Option<Finding> {
    let own = sphere_of(&answer.find)?;
    let name = sentences(&answer.name);
    let is_named = |sphere: Sphere| name.iter().flatten().any(|token| *token == Token::Sphere(sphere));
    let is_another = !is_named(own) && Sphere::ALL.into_iter().any(is_named);
    let (name, own) = (print::text_unicode(&answer.name), own.name());
    let found = || Finding::new(format!("the answer `{name}` is of *{own}*"), "", format!("found of {own}"));
    is_another.then(found)
}

/// The words ask for a motion, and the answer is a coefficient of restitution.
fn no_coefficient(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    let is_one = answer.find.quantities().first().is_some_and(|find| find.of_its_impact() == Quantity::Restitution);
    let words = |list: &[&str]| asked.iter().any(|sentence| says(sentence, list));
    let has_letter = asked.iter().flatten().any(|token| matches!(token, Token::Number(Expr::Name(_), ..)));
    let is_asked = words(&["restitution", "coefficient"]) || has_letter;
    if !is_one || is_asked || !words(&["speed", "velocity", "angle", "energy", "impulse", "mass", "direction"]) {
        return None;
    }
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for no coefficient of restitution, and the answer `{name}` is one");
    Some(Finding::new(message, "", "a coefficient of restitution"))
}

/// The words ask for the values of one letter, and the answer is another.
fn another_letter(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    let is_letter = matches!(answer.find, Find::Unknown(_)) || answer.kind == Kind::Range;
    let own = answer.find.name();
    let names = |token: &Token| match token {
        Token::Number(expr, ..) => expr.names().into_iter().map(|name| name.text.clone()).collect(),
        _ => Vec::new(),
    };
    let is_named = asked.iter().flatten().any(|token| names(token).contains(&own));
    let other = asked.iter().flat_map(|sentence| sentence.windows(3)).find_map(|words| match words {
        [value, of, Token::Number(Expr::Name(name), ..)]
            if is_one_of(value, &["value", "values"]) && is_one_of(of, &["of"]) =>
        {
            Some(&name.text)
        }
        _ => None,
    });
    let other = other.filter(|_| is_letter && !is_named)?;
    let message = format!("the words ask for `{other}`, and the answer is `{own}`");
    Some(Finding::new(message, "", "another letter"))
}

/// The words name one sphere, and the answer is of another.
fn of_another(answer: &Answer, part: &Part, asked: &[Sentence]) -> Option<Finding> {
    let own = sphere_of(&answer.find)?;
    let named = |sphere: Sphere| asked.iter().flatten().any(|token| *token == Token::Sphere(sphere));
    let is_of_both = asked.iter().flatten().any(|token| is_one_of(token, &["each", "both", "spheres", "their", "two"]));
    let other = Sphere::ALL.into_iter().find(|sphere| *sphere != own && named(*sphere))?;
    // A part whose result is printed need not name what it is of.
    if named(own) || is_of_both || part.answers.iter().any(|answer| answer.kind == Kind::Shown) {
        return None;
    }
    // `The speed of the sphere that *A* strikes` names another, and asks of the right one.
    let is_plain = asked.iter().flat_map(|sentence| sentence.windows(2)).any(|words| match words {
        [of, Token::Sphere(sphere)] => *sphere == other && is_one_of(of, &["of"]),
        _ => false,
    });
    let (name, own, other) = (print::text_unicode(&answer.name), own.name(), other.name());
    let message = format!("the words ask of `*{other}*`, and the answer `{name}` is of *{own}*");
    let found = Finding::new(message, "", format!("found of {own}"));
    Some(if is_plain { found } else { found.as_warning() })
}

/// `Find the speed of *B* after it has met *A*`, and no answer of the part is of *B*.
fn of_another_at_once(answer: &Answer, part: &Part, asked: &[Sentence]) -> Option<Finding> {
    const ASKING: [&str; 4] = ["find", "calculate", "determine", "state"];
    const NOUNS: [&str; 3] = ["speed", "velocity", "mass"];
    let own = sphere_of(&answer.find)?;
    let of = |words: &[Token]| match words {
        [noun, of, Token::Sphere(sphere)] if is_one_of(noun, &NOUNS) && is_one_of(of, &["of"]) => Some(*sphere),
        _ => None,
    };
    let at_once = |words: &[Token]| {
        let is_asked = is_one_of(&words[0], &ASKING) && is_one_of(&words[1], &["the"]);
        of(&words[2..]).filter(|_| is_asked)
    };
    let other = asked.iter().flat_map(|sentence| sentence.windows(5)).find_map(at_once)?;
    let is_own = asked.iter().flat_map(|sentence| sentence.windows(3)).any(|words| of(words) == Some(own));
    let is_found = part.answers.iter().any(|answer| sphere_of(&answer.find).is_none_or(|found| found == other));
    if is_own || is_found || part.answers.iter().any(|answer| answer.kind == Kind::Shown) {
        return None;
    }
    let (name, own, other) = (print::text_unicode(&answer.name), own.name(), other.name());
    let message = format!("the words ask of `*{other}*`, and the answer `{name}` is of *{own}*");
    Some(Finding::new(message, "", format!("found of {own}")))
}

/// The sphere whose mass, speed, velocity, angle or energy is to be found.
pub(super) fn sphere_of(find: &Find) -> Option<Sphere> {
    whose(*find.quantities().first()?)
}

/// The sphere that a mass, speed, velocity, angle or energy is of.
pub(super) fn whose(quantity: Quantity) -> Option<Sphere> {
    match quantity.of_its_impact() {
        Quantity::Mass(sphere)
        | Quantity::Speed(sphere, _)
        | Quantity::Velocity(sphere, ..)
        | Quantity::AngleToLine(sphere, _)
        | Quantity::AngleToWall(sphere, _)
        | Quantity::Deflection(sphere)
        | Quantity::SphereEnergyLost(sphere)
        | Quantity::SphereEnergyGained(sphere) => Some(sphere),
        _ => None,
    }
}

/// The words ask for the angle with a line, and the answer is the angle of deflection, or the other way round.
fn another_angle(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    const TURNED: [&str; 5] = ["deflect", "turn", "chang", "rotat", "through"];
    const LINES: [&str; 4] = ["line", "wall", "centres", "perpendicular"];
    const DIRECTIONS: [&str; 2] = ["direction", "directions"];
    let says_turned = asked
        .iter()
        .flatten()
        .any(|token| matches!(token, Token::Word(word) if TURNED.iter().any(|begin| word.starts_with(begin))));
    // `The angle between its directions before and after`, `that its direction after makes with that before`
    let words = |list: &[&str]| asked.iter().any(|sentence| says(sentence, list));
    let is_between = (words(&["between"]) || (words(&["with", "to"]) && !words(&LINES)))
        && words(&["before", "initial", "original"])
        && words(&["after", "final", "afterwards", "new"]);
    let says_turned = says_turned || is_between;
    let names_line = words(&LINES);
    let is_asked = words(&["angle", "angles", "deflection", "deflections"]);
    let Find::Quantity(quantity) = &answer.find else { return None };
    if answer.kind == Kind::Shown || !is_asked {
        return None;
    }
    let (has, said) = match quantity.of_its_impact() {
        Quantity::Deflection(_) if !says_turned && (names_line || words(&DIRECTIONS)) => {
            ("through which the path is turned", "with a line")
        }
        Quantity::AngleToLine(..) | Quantity::AngleToWall(..) if says_turned && !names_line => {
            ("with a line", "through which the path is turned")
        }
        _ => return None,
    };
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for an angle {said}, and the answer `{name}` is one {has}");
    Some(Finding::new(message, "", "another angle").as_warning())
}

/// The words ask for the sine of an angle, and the answer is its tangent.
fn another_function(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    let is_function = |expr: &&Expr| {
        matches!(expr, Expr::Call(Function::Sin | Function::Cos | Function::Tan, _)) && !expr.names().is_empty()
    };
    let own: Vec<&Expr> = answer.name.formulas().into_iter().filter(is_function).collect();
    let said = asked.iter().flatten().filter_map(|token| match token {
        Token::Number(expr, ..) => Some(*expr),
        _ => None,
    });
    let said: Vec<&Expr> = said.filter(is_function).collect();
    let is_asked = |own: &&Expr| said.iter().any(|said| print::plain(said) == print::plain(own));
    if own.is_empty() || answer.kind == Kind::Shown || own.iter().any(is_asked) {
        return None;
    }
    let (said, own) = (print::unicode(said.first()?), print::unicode(own.first()?));
    let message = format!("the words ask for `{said}`, and the answer is `{own}`");
    Some(Finding::new(message, "", "another function of the angle"))
}

/// The words ask for a velocity, and no answer says its direction.
fn size_alone(answer: &Answer, part: &Part, asked: &[Sentence]) -> Option<Finding> {
    let says = |words: &[&str]| asked.iter().any(|sentence| says(sentence, words));
    let is_speed = |answer: &Answer| match answer.find {
        Find::Quantity(quantity) => matches!(quantity.of_its_impact(), Quantity::Speed(..)),
        _ => false,
    };
    let is_asked = says(&["velocity", "velocities"])
        && !says(&["speed", "speeds", "magnitude", "magnitudes", "component", "components", "size"]);
    let are_all = part.answers.iter().all(is_speed);
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for a velocity, and the answer `{name}` is a speed alone");
    (is_asked && are_all).then(|| Finding::new(message, "", "without its direction").as_warning())
}

/// The words ask for one value, and the answer is a set of values.
fn set(answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    const OF_SETS: [&str; 9] =
        ["values", "range", "set", "possible", "which", "inequality", "show", "greatest", "least"];
    let says = |words: &[&str]| asked.iter().flatten().any(|token| is_one_of(token, words));
    if answer.kind != Kind::Range || !says(&["value"]) || says(&OF_SETS) {
        return None;
    }
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for one value, and the answer `{name}` is a set of values");
    Some(Finding::new(message, "", "a set of values").as_warning())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn words_that_ask_for_another_answer_are_found() {
        let (rest, both) = ("rest/speeds-and-directions", "both-moving/energy-lost-and-impulse");
        let direction = "  { name = \"direction of *B*\", find = \"B.after.angle_to_loc_deg\", accept = \"awrt 3sf\", phrase = \"to the line of centres\" },\n";
        let table: [(&str, Edits, &str); 41] = [
            ("ranges/direction-reversed", &[], ""),
            ("ranges/direction-reversed", &[("set of possible values", "value")], "ask for one value"),
            (
                "ranges/direction-reversed",
                &[("values of {e}.", "values of {u}.")],
                "ask for `u`, and the answer is `e`",
            ),
            (rest, &[], ""),
            (
                "direct/restitution-from-one-speed",
                &[("Find the coefficient of restitution between the spheres.", "Find the speed of *B*.")],
                "no coefficient of restitution, and the answer",
            ),
            (
                rest,
                &[("name = \"direction of *A*\"", "name = \"direction of *C*\"")],
                "the answer `direction of C` is of *A*",
            ),
            (rest, &[(direction, "")], "the direction of each sphere, and only `direction of A`"),
            (
                both,
                &[("find = \"ke.lost\"", "find = \"B.ke_lost\"")],
                "all that is lost, and the answer `kinetic energy lost` is what *B*",
            ),
            (
                both,
                &[("energy lost in", "energy lost by *A* in")],
                "what *A* loses, and the answer `kinetic energy lost` is all",
            ),
            ("walls/rebound-speed-and-direction", &[("energy lost in", "energy lost by *A* in")], ""),
            (
                "rest-letters/distance-from-the-centre-of-b",
                &[("value of {tan(theta)}.", "value of {sin(theta)}.")],
                "ask for `sin θ`, and the answer is `tan θ`",
            ),
            (
                "successive/tangents-at-two-walls",
                &[("Find {tan(beta)} in", "Find {cos(beta)} in")],
                "ask for `cos β`, and the answer is `tan β`",
            ),
            (both, &[("energy lost in", "energy gained in")], "what is `gained`"),
            (
                both,
                &[("energy lost in", "energy of *A* after")],
                "a kinetic energy, and the answer `kinetic energy lost` is",
            ),
            (both, &[("energy lost in", "energy before")], "a kinetic energy, and the answer"),
            (both, &[("Find the total kinetic energy lost in", "Find how much kinetic energy is lost in")], ""),
            (both, &[("find = \"ke.lost\"", "find = \"ke.before\"")], "is an energy before the impact"),
            (both, &[("energy lost in", "energy before"), ("find = \"ke.lost\"", "find = \"ke.before\"")], ""),
            (
                "direct/mass-from-the-velocities",
                &[("the mass of *B*.\"", "the mass of *A*.\"")],
                "the words ask of `*A*`, and the answer `mass of B` is of *B*",
            ),
            (
                "walls/rebound-speed-and-direction",
                &[("the kinetic energy lost in", "the increase in kinetic energy in")],
                "what is `increase`",
            ),
            (
                "both-moving/speeds-and-fraction-of-energy-lost",
                &[("the fraction of the total", "the total")],
                "ask for an energy, and the answer `fraction lost` is a fraction",
            ),
            (
                "both-moving/speeds-and-fraction-of-energy-lost",
                &[("the fraction of the total", "the percentage of the total")],
                "ask for a percentage, and the answer `fraction lost` is a fraction",
            ),
            (
                "both-moving/speeds-and-fraction-of-energy-lost",
                &[("the fraction of the total", "the fraction or percentage of the total")],
                "",
            ),
            (
                "both-moving/speeds-and-fraction-of-energy-lost",
                &[
                    ("the fraction of the total", "the percentage of the total"),
                    (
                        "lost in the collision.\"\nanswers = [{ name = \"fraction",
                        "lost, with its sign, %.\"\nanswers = [{ name = \"fraction",
                    ),
                ],
                "",
            ),
            (both, &[("Find the total kinetic", "Find the fraction of the kinetic")], "is the energy itself"),
            (
                "both-moving/speeds-and-fraction-of-energy-lost",
                &[("total kinetic energy of the spheres that", "kinetic energy of *A* that")],
                "ask for what *A* loses",
            ),
            (
                "vector-impulse/velocity-after-an-impulse",
                &[("it receives the impulse, and its speed.", "it receives the impulse.")],
                "ask for 1 answer in m/s, and the part has 2",
            ),
            (
                both,
                &[
                    (
                        "Find the total kinetic energy lost in",
                        "Find the kinetic energy lost, and the fraction of it, in",
                    ),
                    (
                        "find = \"ke.lost\", accept = \"awrt 3sf\" }",
                        "find = \"ke.lost\", accept = \"awrt 3sf\" }, { name = \"fraction lost\", find = \"ke.fraction_lost\" }",
                    ),
                ],
                "",
            ),
            (
                "direct/velocities-after-impact",
                &[("Find the speed of each sphere", "Find the velocity of each sphere")],
                "ask for a velocity, and the answer `speed of A` is a speed alone",
            ),
            (
                "deflection/greatest-deflection",
                &[("find = \"A.deflection_deg\"", "find = \"A.after.angle_to_loc_deg\"")],
                "ask for an angle through which the path is turned, and the answer `greatest deflection` is one with a line",
            ),
            (
                "walls/velocity-in-i-and-j",
                &[("find = \"A.deflection_deg\"", "find = \"A.after.angle_to_wall_deg\"")],
                "ask for an angle through which the path is turned",
            ),
            (
                "vector-impulse/size-of-the-impulse",
                &[(
                    "Find the angle through which the direction of motion of *A* is turned.",
                    "Find the angle that the direction of motion of *A* after the impulse makes with that before it.",
                )],
                "",
            ),
            ("deflection/greatest-deflection", &[], ""),
            ("walls/velocity-in-i-and-j", &[], ""),
            ("direct/velocities-after-impact", &[], ""),
            ("successive/corner", &[], ""),
            ("direct/velocities-in-letters", &[], ""),
            ("rest-letters/direction-and-deflection", &[], ""),
            ("direct/restitution-from-one-speed", &[], ""),
            ("deflection/equal-masses", &[], ""),
            ("successive/three-in-a-line", &[], ""),
        ];
        for (id, edits, words) in table {
            let said: String = others(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
