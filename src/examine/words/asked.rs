//! Do the words ask for what the answers are, and speak of what the scene has?

use super::asked_units::stated_otherwise;
use super::sentence::{Sentence, Token, is_one_of, is_supposed, says, sentences};
use crate::answer::Kind;
use crate::bank::{Part, Question};
use crate::examine::Finding;
use crate::expr::{Expr, Piece, Text, print};
use crate::mechanics::{Quantity, Sphere};
use crate::unit::Unit;

/// Words that tell a student to show what is printed, and words that tell to find what is not.
const TO_SHOW: [&str; 8] = ["show", "prove", "verify", "deduce", "explain", "establish", "confirm", "demonstrate"];
const TO_FIND: [&str; 10] =
    ["find", "calculate", "determine", "work", "state", "write", "give", "what", "obtain", "express"];

/// Words that ask for something else than the answers, and spheres that the scene does not have.
pub fn beside_the_point(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let asked = part.ask.iter().map(print::text_unicode).collect::<Vec<_>>().join(" ");
        findings.extend(shown(&asked, part).map(|found| found.at_row(place, "answers", 0)));
    }
    findings.extend(stated_otherwise(question));
    findings.extend(out_of_order(question));
    findings.extend(extremes(question));
    findings.extend(strangers(question));
    findings.extend(called_otherwise(question));
    findings.extend(numbers_for_spheres(question));
    findings.extend(absent(question));
    findings.extend(in_one_line(question));
    findings
}

/// A result that is printed and to be found, or to be shown and of no answer.
fn shown(words: &str, part: &Part) -> Option<Finding> {
    let lower = words.to_lowercase();
    let says = |list: &[&str]| lower.split(|sign: char| !sign.is_alphabetic()).any(|word| list.contains(&word));
    let is_shown = part.answers.iter().any(|answer| answer.kind == Kind::Shown);
    if is_shown && says(&TO_FIND) && !says(&TO_SHOW) {
        let found = Finding::new("the words print the result, and ask to find it", "", "it is to be shown");
        return Some(found.with_help("begin with `Show that`, or leave `show` and `{display: result}` out"));
    }
    if !is_shown && (lower.contains("show that") || lower.contains("prove that")) && !says(&TO_FIND) {
        let found =
            Finding::new("the words ask to show something, and no answer is of kind `shown`", "", "to be found");
        let help = "begin with `Find`; or add `show`, the left side of the result, and print `{display: result}`";
        return Some(found.with_help(help).as_warning());
    }
    None
}

/// `Hence` where nothing comes before, and `part (c)` where there is none or it comes later.
fn out_of_order(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        let said = part.ask.iter().map(print::text_unicode).collect::<Vec<_>>().join(" ");
        let begins = said.split_whitespace().next().is_some_and(|word| word.trim_end_matches(',') == "Hence");
        let is_earlier = |label: &str| question.parts[..place].iter().any(|earlier| earlier.label == label);
        let label =
            |rest: &str| rest.split_once(')').map(|(label, _)| label.to_owned()).filter(|label| label.len() == 1);
        let strange = said.split("part (").skip(1).filter_map(label).find(|label| !is_earlier(label));
        let (message, help) = match strange {
            Some(label) => (
                format!("the words speak of part ({label}), which does not come before"),
                "name a part that comes before",
            ),
            None if begins && place == 0 => {
                ("`Hence` begins the first part".to_owned(), "begin with what is to be found")
            }
            None => continue,
        };
        let found = Finding::new(message, "", "nothing was found before").with_help(help);
        findings.push(found.at_row(place, "answers", 0).as_warning());
    }
    findings
}

/// Words for what is as large as it can be, and as small.
const GREATEST: [&str; 6] = ["greatest", "largest", "maximum", "maximal", "maximised", "maximized"];
const LEAST: [&str; 6] = ["least", "smallest", "minimum", "minimal", "minimised", "minimized"];

/// The least of what the scene makes greatest, and the greatest or least of what nothing makes so.
fn extremes(question: &Question) -> Option<Finding> {
    let scene = &question.scene;
    let sentences: Vec<_> = texts(question).flat_map(sentences).filter(|sentence| !is_supposed(sentence)).collect();
    let word = |words: &[&str]| {
        sentences.iter().find_map(|sentence| {
            // `At least` is a bound, and `the greatest of the three` one of several.
            // `As small as possible` is the least.
            let is_as_possible = |place: usize| {
                let is_between = |words: [&str; 2]| {
                    let [before, after] = [place.checked_sub(1), place.checked_add(1)];
                    [before, after].into_iter().zip(words).all(|(at, word)| {
                        at.and_then(|at| sentence.get(at)).is_some_and(|token| is_one_of(token, &[word]))
                    })
                };
                let size: &[&str] =
                    if words.contains(&LEAST[0]) { &["small", "low"] } else { &["large", "great", "high"] };
                is_one_of(&sentence[place], size) && is_between(["as", "as"])
            };
            let is_extreme = |place: &usize| {
                let before = place.checked_sub(1).map(|before| &sentence[before]);
                is_as_possible(*place)
                    || is_one_of(&sentence[*place], words)
                        && !before.is_some_and(|token| is_one_of(token, &["at"]))
                        && !sentence.get(place + 1).is_some_and(|token| is_one_of(token, &["of"]))
            };
            (0..sentence.len()).find(is_extreme).and_then(|place| match &sentence[place] {
                Token::Word(word) if is_as_possible(place) => Some(format!("as {word} as possible")),
                Token::Word(word) => Some(word.clone()),
                _ => None,
            })
        })
    };
    if let Some(maximise) = &scene.maximise {
        if let Some(found) = greatest_of_another(maximise, &sentences) {
            return Some(found);
        }
        let said = word(&LEAST)?;
        let message = format!("the words say `{said}`, and the scene makes `{maximise}` as large as possible");
        let other = if said.starts_with("as ") { "as large as possible" } else { "greatest" };
        let help = format!("say `{other}`: what `maximise` names in `[scene]` is made as large as it can be");
        let found = Finding::new(message, said, "the greatest in the scene").with_help(help);
        // Beside the greatest there may be a least of something else; but not `is least` and `least deflection`.
        let named = maximise.parse::<Quantity>().map(Quantity::in_plain_words).unwrap_or_default();
        let is_of_it = sentences.iter().flat_map(|sentence| sentence.windows(2)).any(|pair| match pair {
            [is, least] if is_one_of(least, &LEAST) => is_one_of(is, &["is"]),
            [least, Token::Word(next)] => is_one_of(least, &LEAST) && named.split(' ').any(|word| word == next),
            _ => false,
        });
        return Some(if is_of_it || word(&GREATEST).is_none() { found } else { found.as_warning() });
    }
    let said = word(&[GREATEST, LEAST].concat())?;
    let is_range = question.parts.iter().flat_map(|part| &part.answers).any(|answer| answer.kind == Kind::Range);
    let (message, label, help) = match (is_range, scene.conditions.is_empty()) {
        (true, _) => {
            let message = format!("the words say `{said}`, and the answer is a set of values");
            (message, "one value", "ask for the set of possible values")
        }
        (false, true) => {
            let message = format!("the words say `{said}`, and nothing in the scene makes it so");
            (message, "no `maximise`", "name it in `maximise` of `[scene]`, or ask for what is found")
        }
        // The least for which something happens may be that for which it just does.
        (false, false) => return None,
    };
    Some(Finding::new(message, said, label).with_help(help).as_warning())
}

/// The greatest deflection of one sphere, where the scene makes that of another so.
fn greatest_of_another(maximise: &str, sentences: &[Sentence]) -> Option<Finding> {
    let is_of_turning = |quantity: &Quantity| {
        matches!(quantity, Quantity::Deflection(_) | Quantity::SignedDeflection(_) | Quantity::TanDeflection(_))
    };
    let own = maximise.parse::<Quantity>().ok().filter(is_of_turning)?.sphere()?;
    let is_great = |sentence: &&Sentence| {
        says(sentence, &[&GREATEST[..], &["large", "great"]].concat())
            && says(sentence, &["deflection", "deflected", "turned"])
    };
    let named = |sentence: &Sentence| {
        let spheres = sentence.iter().filter_map(|token| match token {
            Token::Sphere(sphere) => Some(*sphere),
            _ => None,
        });
        spheres.collect::<Vec<Sphere>>()
    };
    let other =
        sentences.iter().filter(is_great).map(named).find(|named| !named.is_empty() && !named.contains(&own))?[0];
    let (own, other) = (own.name(), other.name());
    let message =
        format!("the words speak of the greatest deflection of `*{other}*`, and the scene makes that of `*{own}*` so");
    let found = Finding::new(message, format!("of *{other}*"), "another sphere");
    Some(found.with_help(format!("name `*{own}*`, or what is of `{other}` in `maximise`")))
}

/// All words that a student reads.
fn texts(question: &Question) -> impl Iterator<Item = &Text> {
    let stems = question.styles.iter().flat_map(|style| style.stem.iter().chain([&style.note]));
    let asks = question.parts.iter().flat_map(|part| &part.ask);
    let names = question.parts.iter().flat_map(|part| &part.answers).flat_map(|answer| [&answer.name, &answer.phrase]);
    stems.chain(asks).chain(names)
}

/// A wall or a line of centres of which the words speak and that the scene does not have, and figures by number.
fn absent(question: &Question) -> Vec<Finding> {
    let scene = &question.scene;
    let has_wall = scene.wall.is_some() || scene.then.iter().any(|then| then.wall.is_some());
    let has_spheres = !scene.is_of_one() || scene.then.iter().any(|then| then.of.len() > 1);
    let (wall, line) = ("speak of a wall, and the scene has none", "speak of a line of centres, and no spheres meet");
    let (name, mend) = ("name what there is", "give in `[scene]` what is said, or say what it has");
    let mut told: Vec<&str> = Vec::new();
    let mut findings = Vec::new();
    let marks = question.parts.iter().flat_map(|part| &part.marks).flat_map(|mark| &mark.text);
    for said in texts(question).chain(marks).flat_map(|text| &text.0).filter_map(words) {
        let all: Vec<&str> = said.split_whitespace().collect();
        for (place, word) in all.iter().enumerate() {
            let bare = word.trim_matches(|sign: char| !sign.is_alphanumeric()).to_lowercase();
            let next = all.get(place + 1).copied().unwrap_or_default();
            let (message, label, help) = match bare.as_str() {
                "spheres" | "balls" if !has_spheres => ("speak of spheres, and the scene has one", "one sphere", mend),
                "wall" | "walls" if !has_wall => (wall, "no wall", mend),
                "centres" if !has_spheres => (line, "no line of centres", name),
                "rough" => ("say `rough`, and every impact here is smooth", "not smooth", "say `smooth`"),
                "figure" | "fig" | "diagram" if next.starts_with(|sign: char| sign.is_ascii_digit()) => {
                    ("speak of a figure by number, and a sheet numbers none", "no number", "say `the diagram`")
                }
                _ => continue,
            };
            if !told.contains(&message) {
                told.push(message);
                let at = all[place.saturating_sub(2)..all.len().min(place + 2)].join(" ");
                let found = Finding::new(format!("the words {message}"), at, label).with_help(help);
                // A rough sketch may be asked for.
                let is_sure =
                    bare == "rough" && !["sketch", "diagram", "estimate", "idea"].iter().any(|it| next.starts_with(it));
                findings.push(if is_sure { found } else { found.as_warning() });
            }
        }
    }
    findings
}

/// The vectors **i** and **j** where everything moves in one line.
fn in_one_line(question: &Question) -> Option<Finding> {
    if !question.scene.is_in_one_line() {
        return None;
    }
    let is_vector = |expr: &&Expr| expr.names().iter().any(|name| matches!(name.text.as_str(), "i" | "j"));
    let found = texts(question).flat_map(|text| text.formulas()).find(is_vector)?;
    let message =
        format!("the words have a vector, `{}`, and in the scene all moves in one line", print::unicode(found));
    let help = "take `i` or `j` out of the braces; what is to be in italics stands between `_` and `_`";
    // A product may be written with a star or without.
    let first = found.names().first().map_or_else(String::new, |name| format!("{{{}", name.text));
    Some(Finding::new(message, first, "no vector in the scene").with_help(help))
}

fn words(piece: &Piece) -> Option<&str> {
    if let Piece::Words(words) = piece { Some(words) } else { None }
}

/// Spheres that are called otherwise than *A*, *B* and *C*: `two spheres *P* and *Q*`. Points may have such letters.
fn called_otherwise(question: &Question) -> Option<Finding> {
    const SPHERES: [&str; 6] = ["sphere", "spheres", "ball", "balls", "particle", "particles"];
    const OF_SPHERES: [&str; 4] = ["mass", "speed", "velocity", "motion"];
    fn name<'t>(token: &'t Token) -> Option<&'t str> {
        match token {
            Token::Number(Expr::Name(name), ..) => Some(&name.text),
            _ => None,
        }
    }
    let is_given = |name: &str| {
        let scene = &question.scene;
        scene.symbols.contains_key(name) || question.styles.iter().any(|style| question.is_given(style, name))
    };
    let is_strange =
        |name: &&str| name.len() == 1 && name.starts_with(|sign: char| sign.is_ascii_uppercase()) && !is_given(name);
    let of_spheres = texts(question).flat_map(sentences).find_map(|sentence| {
        let leads = |at: usize| match &sentence[..at] {
            [.., before] if is_one_of(before, &SPHERES) => true,
            [.., noun, of] => is_one_of(noun, &OF_SPHERES) && is_one_of(of, &["of"]),
            _ => false,
        };
        let at = (0..sentence.len())
            .filter(|at| leads(*at))
            .find(|at| name(&sentence[*at]).is_some_and(|name| is_strange(&name)))?;
        name(&sentence[at]).map(str::to_owned)
    })?;
    let message =
        format!("the words call a sphere `*{of_spheres}*`, and the spheres of a scene are `*A*`, `*B*` and `*C*`");
    let help = "call it in the words as `[scene]` does: `*A*` is the one that strikes, `*B*` the one that is struck";
    Some(Finding::new(message, format!("*{of_spheres}*"), "no sphere of the scene").with_help(help))
}

/// Is the letter of a sphere perhaps that of a point or a line: `from *B* to *C*`, `the line *BC*`?
fn is_a_point(question: &Question, sphere: Sphere) -> bool {
    const BEFORE: [&str; 12] =
        ["point", "points", "from", "to", "through", "at", "between", "line", "lines", "corner", "wall", "distance"];
    let all = texts(question).flat_map(sentences);
    let mut pairs = all.flat_map(|sentence| sentence.windows(2).map(|pair| pair.to_vec()).collect::<Vec<_>>());
    pairs.any(|pair| matches!(pair[1], Token::Sphere(of) if of == sphere) && is_one_of(&pair[0], &BEFORE))
}

/// A number or letter where a sphere is to stand: `the direction of motion of *e*`, `the mass of *mA* is`.
fn numbers_for_spheres(question: &Question) -> Option<Finding> {
    let found = texts(question).flat_map(sentences).find_map(|sentence| {
        sentence.windows(3).zip(sentence.get(3..).unwrap_or_default().iter().map(Some).chain([None])).find_map(
            |(words, next)| {
                let [noun, of, Token::Number(Expr::Name(name), Unit::None, _)] = words else { return None };
                let moves = is_one_of(noun, &["motion", "path"]);
                // `The speed of u` may be given, and is not said to be something.
                let has = is_one_of(noun, &["mass"]) && next.is_some_and(|next| is_one_of(next, &["is", "was"]));
                let is_vector = matches!(name.text.as_str(), "i" | "j");
                (is_one_of(of, &["of"]) && (moves || has) && !is_vector).then(|| name.text.clone())
            },
        )
    })?;
    let message = format!("the words speak of `{found}` as of a sphere, and it is a number");
    let help = "name the sphere that is meant: `*A*`, `*B*` or `*C*`";
    Some(Finding::new(message, format!("*{found}*"), "no sphere").with_help(help))
}

/// Names of spheres in the words that stand for nothing in the scene.
fn strangers(question: &Question) -> Vec<Finding> {
    let scene = &question.scene;
    let has_other = [&scene.before.b, &scene.after.b].into_iter().any(Option::is_some) || scene.masses.b.is_some();
    let is_there = |sphere: Sphere| match sphere {
        Sphere::A => true,
        Sphere::B if has_other => true,
        _ => scene.then.iter().any(|then| then.of.iter().any(|name| name == sphere.name())),
    };
    let texts: Vec<&Text> = texts(question).collect();
    let is_named = |sphere: &Sphere| {
        let formulas = texts.iter().flat_map(|text| text.formulas());
        formulas.into_iter().any(|expr| matches!(expr, Expr::Name(name) if name.text == sphere.name()))
    };
    let is_letter = |sphere: &Sphere| {
        let is_its_name = |name: &String| name == sphere.name();
        let given = |style: &crate::bank::Style| {
            style.parameters.iter().any(|(name, _)| is_its_name(name))
                || style.lets.iter().any(|(name, _)| is_its_name(name))
        };
        scene.symbols.keys().any(is_its_name) || question.styles.iter().any(given)
    };
    let strange = Sphere::ALL.into_iter().filter(|sphere| !is_there(*sphere) && is_named(sphere) && !is_letter(sphere));
    strange
        .map(|sphere| {
            let name = format!("*{}*", sphere.name());
            let message = format!("the words speak of `{name}`, and no sphere of the scene has this name");
            let found = Finding::new(message, name, "no sphere");
            let found = found.with_help("name a sphere that there is; a point has another letter");
            if is_a_point(question, sphere) { found.as_warning() } else { found }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn what_is_as_large_as_can_be_is_so_in_the_scene() {
        let greatest = "deflection/greatest-deflection";
        let range = "ranges/direction-reversed";
        let table: [(&str, Edits, &str); 11] = [
            (greatest, &[], ""),
            ("deflection/equal-masses", &[], ""),
            (
                "deflection/equal-masses",
                &[("as large as possible", "as small as possible")],
                "say `as small as possible`, and the scene",
            ),
            (greatest, &[("greatest", "least")], "say `least`, and the scene makes `A.tan_deflection` as large"),
            (greatest, &[("*A* is greatest", "*A* is smallest")], "say `smallest`"),
            (greatest, &[("*A* is greatest", "*B* is greatest")], "greatest deflection of `*B*`"),
            ("deflection/elastic", &[("greatest angle", "minimum angle")], "say `minimum`"),
            (range, &[("set of possible values", "greatest possible value")], "the answer is a set of values"),
            (range, &[("possible values of {e}.", "possible values of {e}, in lowest terms.")], ""),
            (range, &[("{e}.\"", "{e}, at least in words.\"")], ""),
            (
                "walls/rebound-speed-and-direction",
                &[("Find the speed", "Find the maximum speed")],
                "nothing in the scene",
            ),
        ];
        for (id, edits, words) in table {
            let said = extremes(&edited(id, edits)).map_or_else(String::new, |finding| finding.message);
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }

    #[test]
    fn each_answer_is_of_what_is_asked_for() {
        let rest = "rest/speeds-and-directions";
        let table: [(&str, Edits, &str); 4] = [
            (rest, &[], ""),
            (rest, &[("the speed and the direction of motion of each", "the speed of each")], "`direction of A` is in"),
            (rest, &[("the speed and the direction of motion of each", "the velocity of each")], ""),
            (
                "vector-impulse/impulse-from-two-velocities",
                &[("impulse on *A*.\"", "impulse on *B*.\"")],
                "speak of `*B*`",
            ),
        ];
        for (id, edits, words) in table {
            let said: String =
                beside_the_point(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
