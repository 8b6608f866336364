//! The quantity that words are about: for `speed of A`, `A.after.speed`.

use std::sync::OnceLock;

use crate::mechanics::conditions_in_words::in_english;
use crate::mechanics::{Quantity, Setting};

/// Words that say nothing of a quantity.
const IDLE: [&str; 33] = [
    "the",
    "of",
    "in",
    "is",
    "are",
    "impact",
    "collision",
    "that",
    "which",
    "a",
    "an",
    "to",
    "with",
    "degrees",
    "and",
    "has",
    "have",
    "on",
    "its",
    "by",
    "it",
    "their",
    "makes",
    "sphere",
    "ball",
    "motion",
    "after",
    "immediately",
    "be",
    "must",
    "should",
    "acute",
    "path",
];

/// Other words for those of the vocabulary.
const ALSO: [(&str, &str); 23] = [
    ("turn", "deflected"),
    ("turns", "deflected"),
    ("turned", "deflected"),
    ("deflects", "deflected"),
    ("deflection", "deflected"),
    ("loss", "lost"),
    ("loses", "lost"),
    ("ke", "kinetic energy"),
    ("velocities", "velocity"),
    ("masses", "mass"),
    ("speeds", "speed"),
    ("angles", "angle"),
    ("initial", "before"),
    ("initially", "before"),
    ("final", "after"),
    ("tan", "tangent"),
    ("loc", "line centres"),
    ("centers", "centres"),
    ("parallel", "along"),
    ("direct", "direction"),
    ("momenta", "momentum"),
    ("proportion", "fraction"),
    ("through", ""),
];

impl Quantity {
    /// The quantity that words are most probably about: `speed of A`. What is not said to be before is after.
    ///
    /// ```
    /// use carom::mechanics::Quantity;
    /// assert_eq!(Quantity::meant("the speed of B").map(|quantity| quantity.to_string()).as_deref(), Some("B.after.speed"));
    /// assert_eq!(Quantity::meant("colour"), None);
    /// ```
    pub fn meant(words: &str) -> Option<Quantity> {
        let said = content(words);
        let is_sphere = |word: &String| ["A", "B", "C"].contains(&word.as_str());
        let named: Vec<&String> = said.iter().filter(|word| is_sphere(word)).collect();
        let weigh = |own: &[String]| {
            if !named.is_empty() && own.iter().any(|word| is_sphere(word) && !said.contains(word)) {
                return None;
            }
            let matched: Vec<&String> = said.iter().filter(|word| own.contains(word)).collect();
            matched.iter().find(|word| !is_sphere(word))?;
            let missing = own.iter().filter(|word| !said.contains(word)).count();
            let beside = said.iter().filter(|word| !own.contains(word) && !is_sphere(word)).count();
            Some(3 * matched.len() as i64 - 2 * (missing + beside) as i64)
        };
        let mut best: Option<(i64, Quantity)> = None;
        for (quantity, names) in named_in_words() {
            let weight = names.iter().filter_map(|name| weigh(name)).max();
            if let Some(weight) = weight.filter(|weight| best.is_none_or(|(best, _)| *weight > best)) {
                best = Some((weight, *quantity));
            }
        }
        best.map(|(_, quantity)| quantity)
    }
}

/// Every quantity with the content of each of its names in words.
fn named_in_words() -> &'static [(Quantity, Vec<Vec<String>>)] {
    static NAMED: OnceLock<Vec<(Quantity, Vec<Vec<String>>)>> = OnceLock::new();
    NAMED.get_or_init(|| {
        let names = |quantity: Quantity| {
            let own = (!matches!(quantity, Quantity::Impulse(..))).then(|| quantity.in_words());
            [Some(in_english(quantity, Setting::default())), own].into_iter().flatten().map(|name| content(&name))
        };
        Quantity::all().into_iter().map(|quantity| (quantity, names(quantity).collect())).collect()
    })
}

/// The words that tell quantities apart, each in one form.
fn content(words: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for word in words.split(|sign: char| !sign.is_alphanumeric()).filter(|word| !word.is_empty()) {
        let word = if ["A", "B", "C"].contains(&word) { word.to_owned() } else { word.to_lowercase() };
        let other = ALSO.iter().find(|(also, _)| *also == word).map_or(word.as_str(), |(_, word)| word);
        for word in other.split_whitespace().filter(|word| !IDLE.contains(word)) {
            if !found.iter().any(|known| known == word) {
                found.push(word.to_owned());
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_about_the_quantity_that_has_most_of_them() {
        let table = [
            ("the speed of A after", "A.after.speed"),
            ("speed of B before", "B.before.speed"),
            ("initial speed of A", "A.before.speed"),
            ("speed", "A.after.speed"),
            ("impulse", "impulse.magnitude"),
            ("the impulse on A", "impulse.magnitude"),
            ("A turns through", "A.deflection_deg"),
            ("deflection of A", "A.deflection_deg"),
            ("tangent of the deflection of A", "A.tan_deflection"),
            ("kinetic energy lost", "ke.lost"),
            ("ke lost", "ke.lost"),
            ("loss in kinetic energy", "ke.lost"),
            ("energy lost by A", "A.ke_lost"),
            ("the fraction of energy lost", "ke.fraction_lost"),
            ("coefficient of restitution", "e"),
            ("mass of B", "B.mass"),
            ("component of A along the line of centres", "A.after.n"),
            ("component of A perpendicular to the line of centres", "A.after.t"),
            ("the angle A makes with the wall", "A.after.angle_to_wall_deg"),
            ("direction of A", "A.after.angle_to_loc_deg"),
            ("speed of approach", "approach"),
            ("ratio of the masses", "mass_ratio"),
        ];
        let meant = |words| Quantity::meant(words).map_or_else(String::new, |quantity| quantity.to_string());
        let wrong: Vec<_> = table.iter().filter(|(words, name)| meant(words) != *name).collect();
        assert!(wrong.is_empty(), "{:?}", wrong.iter().map(|(words, _)| (words, meant(words))).collect::<Vec<_>>());
        assert_eq!(Quantity::meant("nice numbers"), None);
    }
}
