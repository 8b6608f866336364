//! Who strikes whom: impacts of which the words speak, and that the scene does not have.

use super::asked_for::whose;
use super::grammar::body;
use super::impacts::{Impact, impacts, ordinal};
use super::sentence::{Sentence, Token, is_one_of, is_supposed, says, sentences};
use crate::answer::Kind;
use crate::bank::{Answer, EarnedFor, Find, Question};
use crate::examine::Finding;
use crate::expr::{Text, print};
use crate::mechanics::{Quantity, Sphere};

/// Impulses that are asked for between others than those between whom they are found, and spheres that are said to strike
/// each other and never do.
pub fn otherwise(question: &Question) -> Vec<Finding> {
    let impacts = impacts(&question.scene);
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let asked = plain(part.ask.iter());
        for (row, answer) in part.answers.iter().enumerate().filter(|(_, answer)| answer.kind != Kind::Shown) {
            let Some(quantity) = answer.find.quantities().first().copied() else { continue };
            let impact = impacts.iter().find(|impact| impact.number == quantity.impact());
            let is_impulse = matches!(quantity.of_its_impact(), Quantity::ImpulseMagnitude | Quantity::Impulse(..));
            let Some(impact) = impact.filter(|_| is_impulse && part.answers.len() == 1) else { continue };
            let found = on_another(&asked, answer).or_else(|| exerted_by_its_own(&asked, answer));
            if let Some(found) = found.or_else(|| on_what_strikes(question, &asked, answer)) {
                findings.push(found.at_row(place, "answers", row));
            }
            if let Some(own) = asked.iter().find_map(exerts_on_itself) {
                let message = format!("the words have `*{}*` exert an impulse on itself", own.name());
                let found = Finding::new(message, "", "no sphere does that");
                findings.push(found.with_help("name the other sphere").at_row(place, "answers", row));
            }
            if let Some(other) = asked.iter().find_map(|sentence| exerts_otherwise(sentence, impact)) {
                let name = print::text_unicode(&answer.name);
                let message =
                    format!("the words ask for an impulse of {other}, and the answer `{name}` is of another impact");
                let help =
                    "find the impulse of the impact that is named, as in `second.impulse.magnitude`, or name another";
                findings
                    .push(Finding::new(message, "", "of another impact").with_help(help).at_row(place, "answers", row));
            }
        }
    }
    let stems = question.styles.iter().flat_map(|style| &style.stem);
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    let mut told: Vec<[Sphere; 2]> = Vec::new();
    let said = plain(stems.chain(asks));
    for [one, other] in said.iter().flat_map(|sentence| strikes(sentence)) {
        let is_there = impacts.iter().any(|impact| impact.has(one) && impact.has(other));
        if !is_there && !told.contains(&[one, other]) {
            told.push([one, other]);
            let (one, other) = (one.name(), other.name());
            let message = format!("the words say that `*{one}*` strikes `*{other}*`, and in the scene it does not");
            let help = "name in the words those that meet in `[scene]`, or let others meet there with `of`";
            findings.push(Finding::new(message, format!("*{other}*"), "no impact of these").with_help(help));
        }
    }
    findings.extend(said.iter().find_map(|sentence| never_happens(sentence, impacts.len())));
    findings.extend(said.iter().find_map(|sentence| no_such_wall(sentence, &impacts)));
    let mut striking = said.iter().flat_map(|sentence| strikes_a_wall(sentence));
    let never = |sphere: &Sphere| !impacts.iter().any(|impact| impact.is_wall && impact.has(*sphere));
    // That there is no wall at all is told of the wall.
    if let Some(sphere) = striking.find(never).filter(|_| impacts.iter().any(|impact| impact.is_wall)) {
        let name = sphere.name();
        let message = format!("the words say that `*{name}*` strikes a wall, and in the scene it does not");
        let help = "name in the words the one that strikes it in `[scene]`, or let this one strike it there with `of`";
        findings.push(Finding::new(message, format!("*{name}* strikes"), "no impact of these").with_help(help));
    }
    findings
}

/// The words ask for the impulse on one sphere, and the name of the answer has another.
fn on_another(asked: &[Sentence], answer: &Answer) -> Option<Finding> {
    let on = |sentence: &Sentence| {
        let pairs = sentence.windows(2).map(|pair| match pair {
            [on, Token::Sphere(sphere)] if is_one_of(on, &["on"]) => Some(*sphere),
            _ => None,
        });
        pairs.flatten().collect::<Vec<_>>()
    };
    let is_of_it = |sentence: &&Sentence| says(sentence, &["impulse"]);
    let said: Vec<Sphere> = asked.iter().filter(is_of_it).flat_map(on).collect();
    let own = sentences(&answer.name).iter().flat_map(on).next()?;
    let other = said.first().filter(|_| !said.contains(&own))?.name();
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for the impulse on `*{other}*`, and the answer is called `{name}`");
    let found = Finding::new(message, "", format!("on {}", own.name()));
    let found = found.with_help(format!("ask for the impulse on `*{}*`, or call the answer so", own.name()));
    // The two have one magnitude.
    Some(if matches!(answer.find, Find::Vector(..)) { found } else { found.as_warning() })
}

/// `The second collision`, where there is one.
fn never_happens(sentence: &[Token], impacts: usize) -> Option<Finding> {
    let (nth, pair) = sentence.windows(2).find_map(|pair| {
        let is_impact = is_one_of(&pair[1], &["collision", "impact"]);
        let nth = ordinal(&pair[0]).filter(|_| is_impact)?;
        (nth >= impacts || impacts == 1).then_some((nth, pair))
    })?;
    let [Token::Word(which), Token::Word(noun)] = pair else { return None };
    let there = if impacts == 1 { "one impact".to_owned() } else { format!("{impacts} impacts") };
    let message = format!("the words speak of a {which} {noun}, and the scene has {there}");
    let help = if nth == 0 {
        format!("say `the {noun}`, or add with `[[scene.then]]` what comes after it")
    } else {
        "name an impact that there is, or add it with `[[scene.then]]`".to_owned()
    };
    let found = Finding::new(message, format!("{which} {noun}"), "no such impact").with_help(help);
    Some(if nth == 0 { found.as_warning() } else { found })
}

/// `The third wall`, where two are struck.
fn no_such_wall(sentence: &[Token], impacts: &[Impact]) -> Option<Finding> {
    let walls = impacts.iter().filter(|impact| impact.is_wall).count();
    let is_wall = |pair: &&[Token]| is_one_of(&pair[1], &["wall"]);
    // That there is one where the words have none is told of the wall; a second may be there and never be struck.
    let (nth, pair) = sentence.windows(2).filter(is_wall).find_map(|pair| Some((ordinal(&pair[0])?, pair)))?;
    let Token::Word(which) = &pair[0] else { return None };
    (walls > 0 && nth >= walls.max(2)).then(|| {
        let message = format!("the words speak of a {which} wall, and {walls} are struck in the scene");
        let found = Finding::new(message, format!("{which} wall"), "no such wall");
        found.with_help("name a wall that is struck, or let a sphere strike it with `[[scene.then]]`").as_warning()
    })
}

/// Sentences of what is so.
fn plain<'t>(texts: impl Iterator<Item = &'t Text>) -> Vec<Sentence<'t>> {
    let is_denied =
        |sentence: &Sentence| sentence.iter().any(|token| is_one_of(token, &["not", "no", "whether", "never"]));
    texts.flat_map(sentences).filter(|sentence| !is_supposed(sentence) && !is_denied(sentence)).collect()
}

/// `The impulse that *A* exerts on the wall`, where the vector that is found is the one on *A*.
fn exerted_by_its_own(asked: &[Sentence], answer: &Answer) -> Option<Finding> {
    let Find::Vector(component, _) = answer.find else { return None };
    let Quantity::Impulse(own, _) = component.of_its_impact() else { return None };
    let exerts = |sentence: &Sentence| {
        sentence.windows(3).any(|words| match words {
            [Token::Sphere(sphere), exerts, on] => {
                *sphere == own && is_one_of(exerts, &["exerts", "gives"]) && is_one_of(on, &["on", "to"])
            }
            _ => false,
        })
    };
    // `The impulse exerted on the bat by *A*`
    let exerted = |sentence: &Sentence| {
        let at = sentence.iter().position(|token| is_one_of(token, &["exerted", "given", "received"]));
        let is_by = |words: &[Token]| is_one_of(&words[0], &["by"]) && words[1] == Token::Sphere(own);
        at.is_some_and(|at| {
            is_one_of(sentence.get(at + 1).unwrap_or(&Token::Comma), &["on", "to"])
                && sentence[at..].windows(2).any(is_by)
                && !sentence[..at].contains(&Token::Sphere(own))
        })
    };
    asked.iter().find(|sentence| says(sentence, &["impulse"]) && (exerts(sentence) || exerted(sentence)))?;
    let own = own.name();
    let message =
        format!("the words ask for the impulse that `*{own}*` exerts, and the answer is the impulse on `*{own}*`");
    let help = format!("ask for the impulse that is exerted on `*{own}*`, or find the opposite one");
    Some(Finding::new(message, "", format!("on {own}")).with_help(help))
}

/// `The impulse on the stick`, where the stem lets a stick strike *A* and the vector that is found is the one on *A*.
fn on_what_strikes(question: &Question, asked: &[Sentence], answer: &Answer) -> Option<Finding> {
    let Find::Vector(component, _) = answer.find else { return None };
    let Quantity::Impulse(own, _) = component.of_its_impact() else { return None };
    let struck_by = |sentence: &Sentence| {
        let pairs = sentence.windows(3).filter_map(|words| match words {
            [by, article, Token::Word(noun)] if is_one_of(by, &["by"]) && is_one_of(article, &["a", "an", "the"]) => {
                body(noun).is_none().then(|| noun.clone())
            }
            _ => None,
        });
        pairs.collect::<Vec<_>>()
    };
    let stems = question.styles.iter().flat_map(|style| &style.stem);
    let mut strikers: Vec<String> = stems.flat_map(sentences).flat_map(|sentence| struck_by(&sentence)).collect();
    strikers.push("wall".to_owned());
    let on = |sentence: &Sentence| {
        let at = sentence.iter().position(|token| is_one_of(token, &["impulse"]))?;
        sentence[at..].windows(3).find_map(|words| match words {
            [on, the, Token::Word(noun)] if is_one_of(on, &["on"]) && is_one_of(the, &["the", "this"]) => {
                strikers.contains(noun).then(|| noun.clone())
            }
            _ => None,
        })
    };
    let names_own = |sentence: &Sentence| {
        let is_on_own = |pair: &[Token]| is_one_of(&pair[0], &["on", "to"]) && pair[1] == Token::Sphere(own);
        sentence.windows(2).any(is_on_own)
    };
    let striker = asked.iter().filter(|sentence| !names_own(sentence)).find_map(on)?;
    let own = own.name();
    let message = format!("the words ask for the impulse on the {striker}, and the answer is the impulse on `*{own}*`");
    let help = format!("ask for the impulse on `*{own}*`, or find the opposite one");
    Some(Finding::new(message, "", format!("on {own}")).with_help(help))
}

/// `That A exerts on A`, `exerted on A by A`.
fn exerts_on_itself(sentence: &Sentence) -> Option<Sphere> {
    let own = |one: &Sphere, other: &Sphere| (one == other).then_some(*one);
    sentence.windows(4).find_map(|words| match words {
        [Token::Sphere(one), exerts, on, Token::Sphere(other)]
            if is_one_of(exerts, &["exerts"]) && is_one_of(on, &["on"]) =>
        {
            own(one, other)
        }
        [on, Token::Sphere(one), by, Token::Sphere(other)] | [by, Token::Sphere(one), on, Token::Sphere(other)]
            if is_one_of(on, &["on"]) && is_one_of(by, &["by"]) =>
        {
            own(one, other)
        }
        _ => None,
    })
}

/// `That A exerts on B`: who is named, where an impact is of others.
fn exerts_otherwise(sentence: &[Token], impact: &Impact) -> Option<String> {
    let at = sentence.windows(2).position(|pair| is_one_of(&pair[0], &["exerts"]) && is_one_of(&pair[1], &["on"]))?;
    let beside = [at.checked_sub(1)?, at + 2].into_iter().filter_map(|place| sentence.get(place));
    let is_strange = |token: &Token| match token {
        Token::Sphere(sphere) => !impact.has(*sphere),
        token => is_one_of(token, &["wall"]) && !impact.is_wall,
    };
    let name = |token: &Token| match token {
        Token::Sphere(sphere) => format!("*{}*", sphere.name()),
        _ => "the wall".to_owned(),
    };
    beside.into_iter().find(|token| is_strange(token)).map(name)
}

/// The pairs of spheres of which a sentence says that one strikes the other: `A strikes B`, `B collides with C`.
fn strikes(sentence: &[Token]) -> Vec<[Sphere; 2]> {
    const STRIKES: [&str; 4] = ["strikes", "hits", "struck", "meets"];
    let pair = |words: &[Token]| match words {
        [Token::Sphere(one), verb, Token::Sphere(other), ..] if is_one_of(verb, &STRIKES) => Some([*one, *other]),
        [Token::Sphere(one), verb, with, Token::Sphere(other)]
            if is_one_of(verb, &["collides"]) && is_one_of(with, &["with"]) =>
        {
            Some([*one, *other])
        }
        _ => None,
    };
    (0..sentence.len()).filter_map(|at| pair(&sentence[at..sentence.len().min(at + 4)])).collect()
}

/// The spheres of which a sentence says that they strike a wall: `A strikes the wall`, `B collides with a smooth wall`.
fn strikes_a_wall(sentence: &[Token]) -> Vec<Sphere> {
    const STRIKES: [&str; 5] = ["strikes", "hits", "meets", "reaches", "rebounds"];
    const DESCRIBED: [&str; 11] =
        ["the", "a", "this", "that", "with", "from", "smooth", "fixed", "vertical", "first", "second"];
    let strikes = |words: &[Token]| match words {
        [Token::Sphere(sphere), verb, rest @ ..] if is_one_of(verb, &STRIKES) || is_one_of(verb, &["collides"]) => {
            let next = rest.iter().find(|token| !is_one_of(token, &DESCRIBED));
            next.is_some_and(|token| is_one_of(token, &["wall"])).then_some(*sphere)
        }
        _ => None,
    };
    (0..sentence.len()).filter_map(|at| strikes(&sentence[at..])).collect()
}

/// Marks whose text names one sphere, and that are for a step or value of another.
pub fn marked_otherwise(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, mark) in part.marks.iter().enumerate() {
            let own = match &mark.earned_for {
                EarnedFor::Quantity(quantity) => whose(*quantity),
                EarnedFor::Law(_, sphere) => *sphere,
                _ => None,
            };
            let (Some(own), Some(text)) = (own, &mark.text) else { continue };
            let words: Vec<Token> = sentences(text).into_iter().flatten().collect();
            let names = |sphere: Sphere| words.contains(&Token::Sphere(sphere));
            let other = Sphere::ALL.into_iter().find(|sphere| names(*sphere)).filter(|_| !names(own));
            if let Some(other) = other {
                let (other, own, step) = (other.name(), own.name(), &mark.earned_for);
                let message = format!("the text of the mark {} names `*{other}*`, and it is for `{step}`", mark.id);
                let found = Finding::new(message, "", format!("of {own}"));
                findings.push(
                    found.with_help(format!("name `*{own}*` in its `text`, or mend `for`")).at_row(place, "marks", row),
                );
            }
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn impacts_of_which_the_words_speak_are_those_of_the_scene() {
        let (line, wall) = ("successive/three-in-a-line", "successive/sphere-wall-sphere");
        let onto = "successive/struck-onto-a-wall";
        let both = "both-moving/energy-lost-and-impulse";
        let after = ("rest/speeds-and-directions", "Immediately before the collision");
        let table: [(&str, Edits, &str); 31] = [
            ("successive/corner", &[("loses at the second wall", "loses at the third wall")], "speak of a third wall"),
            ("successive/corner", &[], ""),
            (line, &[], ""),
            (line, &[("that *B* exerts on *C*", "exerted by *C* on *C*")], "have `*C*` exert an impulse on itself"),
            (line, &[("that *B* exerts on *C*", "that *C* exerts on *C*")], "have `*C*` exert an impulse on itself"),
            (
                both,
                &[("exerted on *B*", "exerted on *A*")],
                "impulse on `*A*`, and the answer is called `impulse on B`",
            ),
            ("vector-impulse/impulse-from-two-velocities", &[], ""),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("the impulse on *A*", "the impulse on the stick")],
                "impulse on the stick, and the answer is the impulse on `*A*`",
            ),
            ("vector-impulse/impulse-from-two-velocities", &[("the impulse on *A*", "the impulse on the puck")], ""),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("the impulse on *A*", "the impulse that *A* exerts on the stick")],
                "impulse that `*A*` exerts, and the answer is the impulse on `*A*`",
            ),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("the impulse on *A*", "the impulse exerted on the stick by *A*")],
                "impulse that `*A*` exerts, and the answer is the impulse on `*A*`",
            ),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("the impulse on *A*", "the impulse exerted on *A* by the stick")],
                "",
            ),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("the impulse on *A*", "the impulse that the stick exerts on *A*")],
                "",
            ),
            (both, &[], ""),
            (after.0, &[(after.1, "Immediately before the second collision")], "speak of a second collision"),
            (after.0, &[(after.1, "Immediately before the first collision")], "and the scene has one impact"),
            (after.0, &[(after.1, "There is no second collision. Immediately before it")], ""),
            (line, &[("Find the magnitude", "After the fourth impact find the magnitude")], "has 2 impacts"),
            (line, &[("Find the magnitude", "After the first impact find the magnitude")], ""),
            ("successive/second-collision", &[], ""),
            (wall, &[], ""),
            ("direct/restitution-from-one-speed", &[], ""),
            (line, &[("then *B* strikes *C*", "then *A* strikes *C*")], "that `*A*` strikes `*C*`"),
            (line, &[("then *B* strikes *C*", "then *A* does not strike *C*, and *B* strikes *C*")], ""),
            (
                line,
                &[("that *B* exerts on *C*", "that *A* exerts on *B*")],
                "an impulse of *A*, and the answer `impulse on C`",
            ),
            (wall, &[("the wall exerts on *B*", "*A* exerts on *B*")], "an impulse of *A*"),
            (onto, &[], ""),
            (onto, &[("the collision *B* strikes", "the collision *A* strikes")], "`*A*` strikes a wall"),
            (onto, &[("the collision *B* strikes", "the collision *B* hits")], ""),
            (onto, &[("the collision *B* strikes", "the collision *A* does not strike a wall; *B* strikes")], ""),
            (wall, &[("second.impulse.magnitude", "third.impulse.magnitude")], "an impulse of the wall"),
        ];
        for (id, edits, words) in table {
            let said: String = otherwise(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }

    #[test]
    fn the_text_of_a_mark_names_the_sphere_for_which_it_is() {
        let direct = "direct/velocities-after-impact";
        let table: [(&str, Edits, &str); 4] = [
            (direct, &[], ""),
            (
                direct,
                &[("for = \"A.after.speed\" }", "for = \"A.after.speed\", text = \"speed of *B*\" }")],
                "the mark A1c names `*B*`, and it is for `A.after.speed`",
            ),
            (direct, &[("for = \"A.after.speed\" }", "for = \"A.after.speed\", text = \"speed of *A*\" }")], ""),
            (
                "rest/speeds-and-directions",
                &[("two components of *A*: Pyth", "two components of *B*: Pyth")],
                "names `*B*`, and it is for `speed A`",
            ),
        ];
        for (id, edits, words) in table {
            let said: String =
                marked_otherwise(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
