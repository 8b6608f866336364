//! Does the question say all that its scene takes, and use every name that it declares?

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::Value as Json;

use super::typed::quantities;
use crate::bank::{Question, Style};
use crate::examine::Finding;
use crate::expr::{Angles, Expr, Markup, Text, print, read};
use crate::mechanics::{Quantity, SceneText, VelocityText};
use crate::unit::Unit;

/// Numbers that are never said or never taken, and letters that are never used.
pub fn unsaid(question: &Question) -> Vec<Finding> {
    let scene = names_of_scene(question);
    let mut findings = Vec::new();
    for style in &question.styles {
        let taken = origins(&scene, style);
        let mut words = names_of(&style.stem);
        words.extend(of_text(&style.note));
        for part in &question.parts {
            words.extend(names_of(&part.ask));
        }
        let said = origins(&words, style);
        for (name, domain) in &style.parameters {
            if domain.size() > 1 && taken.contains(name) && !said.contains(name) {
                let message = format!("the words of style `{}` never give `{name}`", style.name);
                let label = "the scene takes it, so a student must be told";
                let found = Finding::at_parameter(message, style.name, name, label);
                findings.push(found.with_help(help_to_say(name, question, style, &scene, &words)));
            }
            if domain.size() > 1 && !taken.contains(name) && said.contains(name) {
                let message = format!("nothing in the scene takes `{name}`, which style `{}` gives", style.name);
                let label = "the answers are the same whatever it is";
                let found = Finding::at_parameter(message, style.name, name, label);
                findings.push(found.with_help(format!("put `{name}` where the scene has a number, or take it out")));
            }
        }
    }
    findings.extend(question.scene.symbols.iter().filter(|(name, _)| !is_used(name, question)).map(|(name, range)| {
        let message = format!("nothing uses the letter `{name}`");
        let found = Finding::new(message, format!("{name} = \"{range}\""), "declared here");
        found.with_help("take it out, or use it in the scene")
    }));
    findings
}

/// How a name is said: in the place of a number of its unit that was typed, or by what is derived from it for the scene.
fn help_to_say(
    name: &str,
    question: &Question,
    style: &Style,
    scene: &BTreeSet<String>,
    said: &BTreeSet<String>,
) -> String {
    let in_braces = |name: &str| {
        // A letter brings its unit with it.
        let has_letter = |name: &String| question.scene.symbols.contains_key(name);
        let is_number = !with_letters(&BTreeSet::from([name.to_owned()]), style).iter().any(has_letter);
        let unit = if is_number { unit_of(&Expr::name(name), &question.scene).plain() } else { "" };
        let space = if unit.is_empty() { "" } else { " " };
        (format!("`{{{name}{space}{unit}}}`"), unit)
    };
    let derived = style.lets.iter().map(|(own, _)| own).filter(|own| scene.contains(*own) && !said.contains(*own));
    let comes_of_it = |own: &&String| origins(&BTreeSet::from([(*own).clone()]), style).contains(name);
    let (shown, unit) = match derived.into_iter().find(comes_of_it).filter(|_| !scene.contains(name)) {
        Some(own) => in_braces(own),
        None => in_braces(name),
    };
    let typed = style.stem.iter().flat_map(quantities).find(|typed| typed.unit == unit);
    match typed {
        Some(typed) => format!("write {shown} in the place of `{}`", typed.shown),
        None => format!("write it into the stem, as in {shown}"),
    }
}

/// The names with those from which they are derived, and the letters in their values.
pub(super) fn with_letters(names: &BTreeSet<String>, style: &Style) -> BTreeSet<String> {
    let mut all = origins(names, style);
    let domains = style.parameters.iter().filter(|(name, _)| all.contains(name)).map(|(_, domain)| domain);
    let values = domains.flat_map(|domain| (0..domain.size().min(100)).map(|place| domain.value(place)));
    let letters: Vec<String> = values.flat_map(|value| names_of_expr(&value).collect::<Vec<_>>()).collect();
    all.extend(letters);
    all
}

/// The names and letters that the words of a style give, with those from which they are derived.
pub(super) fn said_in(question: &Question, style: &Style) -> BTreeSet<String> {
    let mut words = names_of(&style.stem);
    words.extend(of_text(&style.note));
    words.extend(question.parts.iter().flat_map(|part| names_of(&part.ask)));
    with_letters(&words, style)
}

/// The unit of a number or vector that the scene takes as it is; of one that stands in a formula there it is open.
pub fn unit_of(expr: &Expr, scene: &SceneText) -> Unit {
    let is = |given: &String, expr: &Expr| match expr {
        Expr::Name(name) => *given == name.text,
        _ => read(given, Angles::Degrees).is_ok_and(|given| print::plain(&given) == print::plain(expr)),
    };
    let is_vector = |pair: &[String; 2]| match expr {
        Expr::Vector(x, y) => is(&pair[0], x) && is(&pair[1], y),
        _ => pair.iter().any(|given| is(given, expr)),
    };
    let given = |given: Option<&String>| given.is_some_and(|given| is(given, expr));
    let velocities = [&scene.before.a, &scene.before.b, &scene.after.a, &scene.after.b].into_iter().flatten();
    let (mut speed, mut angle) = (false, false);
    for velocity in velocities {
        match velocity {
            // Against the line its size is a speed, too.
            VelocityText::Along(along) => {
                speed |= is(along, expr) || along.strip_prefix('-').is_some_and(|size| is(&size.to_owned(), expr));
            }
            VelocityText::Components(components) => speed |= is_vector(components),
            VelocityText::Polar(polar) => {
                speed |= is(&polar.speed, expr);
                angle |= given(polar.angle_deg.as_ref());
            }
        }
    }
    if !matches!(expr, Expr::Name(_) | Expr::Vector(..)) {
        Unit::None
    } else if [&scene.masses.a, &scene.masses.b]
        .into_iter()
        .chain(scene.then.iter().map(|then| &then.mass))
        .any(|mass| given(mass.as_ref()))
    {
        Unit::Kilogram
    } else if speed {
        Unit::MetrePerSecond
    } else if angle {
        Unit::Degree
    } else if scene.impulse.as_ref().is_some_and(is_vector) {
        Unit::NewtonSecond
    } else {
        scene.conditions.iter().find_map(|condition| compared(condition, expr)).unwrap_or(Unit::None)
    }
}

/// The unit of a number that a condition demands of a quantity: `A.after.speed = v`.
fn compared(condition: &str, expr: &Expr) -> Option<Unit> {
    let (quantity, value) = condition.split_once(['=', '<', '>'])?;
    let value = value.trim_start_matches('=').trim();
    let is_it = matches!(expr, Expr::Name(name) if name.text == value);
    quantity.trim().parse::<Quantity>().ok().filter(|_| is_it).map(Quantity::unit)
}

/// Every name and number in the formulas of the scene; its keys are no names.
pub(super) fn names_of_scene(question: &Question) -> BTreeSet<String> {
    let mut scene = question.scene.clone();
    scene.symbols.clear();
    names_of_given(&scene)
}

/// The same, in the formulas of a part of the scene.
pub(super) fn names_of_given(given: &impl Serialize) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open: Vec<Json> = serde_json::to_value(given).into_iter().collect();
    while let Some(value) = open.pop() {
        match value {
            Json::String(text) => found.extend(names_in(&text)),
            Json::Array(items) => open.extend(items),
            Json::Object(fields) => open.extend(fields.into_iter().map(|(_, value)| value)),
            _ => {}
        }
    }
    found
}

pub(super) fn names_in(text: &str) -> BTreeSet<String> {
    let is_name = |sign: char| sign.is_ascii_alphanumeric() || sign == '_';
    text.split(|sign| !is_name(sign)).filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

fn of_text(text: &Text) -> BTreeSet<String> {
    text.names().iter().map(|name| name.text.clone()).collect()
}

fn names_of(words: &Markup) -> BTreeSet<String> {
    words.iter().flat_map(of_text).collect()
}

fn names_of_expr(expr: &Expr) -> impl Iterator<Item = String> {
    expr.names().into_iter().map(|name| name.text.clone()).collect::<Vec<_>>().into_iter()
}

/// The names with those from which they are derived.
pub(super) fn origins(names: &BTreeSet<String>, style: &Style) -> BTreeSet<String> {
    let mut all = names.clone();
    for (name, meaning) in style.lets.iter().rev() {
        if all.contains(name) {
            all.extend(names_of_expr(meaning));
        }
    }
    all
}

/// Does a letter stand in the scene, in a parameter's values, in a formula of the words or of an answer?
fn is_used(letter: &str, question: &Question) -> bool {
    if names_of_scene(question).contains(letter) {
        return true;
    }
    let in_expr = |expr: &Expr| expr.names().iter().any(|name| name.text == letter);
    let in_style = |style: &Style| {
        let values =
            style.parameters.iter().flat_map(|(_, domain)| (0..domain.size().min(100)).map(|i| domain.value(i)));
        names_of(&style.stem).contains(letter)
            || of_text(&style.note).contains(letter)
            || style.lets.iter().any(|(_, expr)| in_expr(expr))
            || values.into_iter().any(|value| in_expr(&value))
    };
    let in_parts = question.parts.iter().any(|part| {
        let shown = part.answers.iter().filter_map(|answer| answer.show.as_ref());
        let names = part.answers.iter().flat_map(|answer| [&answer.name, &answer.phrase]);
        names_of(&part.ask).contains(letter)
            || shown.into_iter().any(in_expr)
            || names.into_iter().any(|text| of_text(text).contains(letter))
    });
    in_parts || question.styles.iter().any(in_style)
}
