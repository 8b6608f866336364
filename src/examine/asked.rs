//! Do the words ask for what the answers are, and speak of what the scene has?

use super::finding::Finding;
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::expr::{Expr, Piece, Text, print};
use crate::mechanics::Sphere;
use crate::unit::Unit;

/// Words that name a quantity, and the unit in which it is stated.
const QUANTITIES: [(&str, Unit); 12] = [
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
    ("mass", Unit::Kilogram),
];

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
        if let Some((said, unit)) = misnamed(&asked, &part.answers.iter().collect::<Vec<_>>()) {
            let message = format!("the words ask for what is stated in {said}, and the answer is in {unit}");
            let found = Finding::new(message, "", "found here");
            let help = "ask for what `find` finds, or find what is asked for";
            findings.push(found.with_help(help).at_row(place, "answers", 0).as_warning());
        }
    }
    findings.extend(strangers(question));
    findings.extend(absent(question));
    findings
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
    let is_alone = scene.wall.is_some() || scene.impulse.is_some();
    let has_spheres = !is_alone || scene.then.iter().any(|then| then.of.len() > 1);
    let (wall, line) = ("speak of a wall, and the scene has none", "speak of a line of centres, and no spheres meet");
    let (name, mend) = ("name what there is", "give in `[scene]` what is said, or say what it has");
    let mut told: Vec<&str> = Vec::new();
    let mut findings = Vec::new();
    for said in texts(question).flat_map(|text| &text.0).filter_map(words) {
        let all: Vec<&str> = said.split_whitespace().collect();
        for (place, word) in all.iter().enumerate() {
            let bare = word.trim_matches(|sign: char| !sign.is_alphanumeric()).to_lowercase();
            let next = all.get(place + 1).copied().unwrap_or_default();
            let (message, label, help) = match bare.as_str() {
                "wall" | "walls" if !has_wall => (wall, "no wall", mend),
                "centres" if !has_spheres => (line, "no line of centres", name),
                "figure" | "fig" | "diagram" if next.starts_with(|sign: char| sign.is_ascii_digit()) => {
                    ("speak of a figure by number, and a sheet numbers none", "no number", "say `the diagram`")
                }
                _ => continue,
            };
            if !told.contains(&message) {
                told.push(message);
                let at = all[place.saturating_sub(2)..all.len().min(place + 2)].join(" ");
                findings.push(Finding::new(format!("the words {message}"), at, label).with_help(help).as_warning());
            }
        }
    }
    findings
}

fn words(piece: &Piece) -> Option<&str> {
    if let Piece::Words(words) = piece { Some(words) } else { None }
}

/// Names of spheres in the words that stand for nothing in the scene.
fn strangers(question: &Question) -> Vec<Finding> {
    let scene = &question.scene;
    let is_there = |sphere: Sphere| match sphere {
        Sphere::A => true,
        Sphere::B if scene.wall.is_none() && scene.impulse.is_none() => true,
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
            found.with_help("name a sphere that there is; a point has another letter").as_warning()
        })
        .collect()
}
