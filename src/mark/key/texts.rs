//! What is seen in the texts of a keyed question, and not in what they come to: its letters, its angles by name, its decimals.

use std::collections::BTreeMap;

use crate::expr::{Angles, degrees, read};
use crate::mechanics::{SceneText, VelocityText};
use crate::number::Letter;
use crate::paper::KeyQuestion;

/// The letters that stand in what is given, or are to be found from it.
pub(super) fn given_letters(question: &KeyQuestion, letters: &[Letter]) -> Vec<Letter> {
    let given = SceneText { symbols: BTreeMap::new(), ..question.scene.clone() };
    let scene = serde_json::to_value(&given).unwrap_or_default();
    let texts = texts(&scene);
    let is_in = |text: &&str, name: &str| {
        text.split(|sign: char| !sign.is_ascii_alphanumeric() && sign != '_').any(|word| word == name)
    };
    letters.iter().filter(|letter| texts.iter().any(|text| is_in(text, letter.name()))).copied().collect()
}

/// The texts in a value, without the names of its fields: `e` is one of those, though a number stands there.
fn texts(value: &serde_json::Value) -> Vec<&str> {
    match value {
        serde_json::Value::String(text) => vec![text],
        serde_json::Value::Array(all) => all.iter().flat_map(texts).collect(),
        serde_json::Value::Object(fields) => fields.values().flat_map(texts).collect(),
        _ => Vec::new(),
    }
}

/// The parameters of a question that are named as angles are.
pub(super) fn angles(question: &KeyQuestion) -> Vec<(String, f64)> {
    const NAMES: [&str; 5] = ["alpha", "beta", "gamma", "theta", "phi"];
    let own = question.parameters.iter().filter(|(name, _)| NAMES.contains(&name.as_str()));
    let angle = |(name, text): (&String, &serde_json::Value)| {
        let angle = read(text.as_str()?, Angles::Degrees).ok()?;
        let turn = degrees(&angle, &|_| None).ok()?;
        Some((name.clone(), turn.enclose(ANGLE_BITS)?.to_f64()))
    };
    own.filter_map(angle).chain(angle_by_tangent(question)).collect()
}

/// The angle α of a question whose words give its tangent, and whose scene has its cosine and sine.
fn angle_by_tangent(question: &KeyQuestion) -> Option<(String, f64)> {
    let name = question.scene.symbols.keys().find(|name| *name == "alpha")?;
    let Some(VelocityText::Polar(polar)) = &question.scene.before.a else { return None };
    let (cos, sin) = polar.cos.as_ref().zip(polar.sin.as_ref())?;
    let angle = read(&format!("atan(({sin})/({cos}))/deg"), Angles::Degrees).ok()?;
    let turn = degrees(&angle, &|_| None).ok()?;
    Some((name.clone(), turn.enclose(ANGLE_BITS)?.to_f64().abs()))
}

/// How precisely an angle is known that students have a letter for.
const ANGLE_BITS: usize = 64;

/// The decimals in the scene of a question.
pub(super) fn decimals(question: &KeyQuestion) -> Vec<String> {
    let text = serde_json::to_string(&question.scene).unwrap_or_default();
    let numbers = text.split(|sign: char| !sign.is_ascii_digit() && sign != '.');
    numbers.filter(|number| number.contains('.')).map(str::to_owned).collect()
}
