//! Profiles: where examiners differ. A profile is data; the marker knows none of them by name.

use serde::Deserialize;

/// How an examining board, or a teacher, wants answers marked.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Profile {
    /// Its name on the command line.
    pub name: String,
    /// What it is, in a sentence.
    pub about: String,
    /// With how many significant figures a decimal is accepted, where the key asks for three.
    pub figures: u32,
    /// How often too few figures, or figures cut off, cost a mark.
    pub inaccuracy: Charge,
    /// How often a wrong unit costs a mark.
    pub units: Charge,
    /// Is a vector as a pair of coordinates, or a column where i and j are asked for, accepted?
    pub coordinates: bool,
    /// Is an angle in radians accepted where it does not say so?
    pub radians: bool,
    /// How many accuracy marks a number costs that is copied wrongly from the question and then used throughout.
    pub misread: u32,
    /// Is the method mark for momentum given where both masses are left out?
    pub masses_omitted: bool,
    /// Is it given where velocities are not resolved?
    pub unresolved: bool,
}

/// How often a fault costs a mark.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Charge {
    /// Never.
    Never,
    /// The first time in a question.
    Once,
    /// Every time.
    Always,
}

/// The profiles that are built in: name and TOML.
const BUILT_IN: [(&str, &str); 5] = [
    ("carom", include_str!("profiles/carom.toml")),
    ("edexcel", include_str!("profiles/edexcel.toml")),
    ("ocr", include_str!("profiles/ocr.toml")),
    ("mei", include_str!("profiles/mei.toml")),
    ("aqa", include_str!("profiles/aqa.toml")),
];

impl Profile {
    /// The names of the profiles that are built in, the usual one first.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        BUILT_IN.into_iter().map(|(name, _)| name)
    }

    /// A profile that is built in.
    pub fn named(name: &str) -> Option<Profile> {
        let (_, text) = BUILT_IN.into_iter().find(|(known, _)| *known == name)?;
        toml::from_str(text).ok()
    }
}

impl Default for Profile {
    /// Exact, or correct to three significant figures; inaccuracy costs a mark once in a question, units nothing.
    fn default() -> Profile {
        Profile::named("carom").expect("the profile that is built in can be read")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_profile_that_is_built_in_can_be_read_and_has_its_own_name() {
        for name in Profile::names() {
            assert_eq!(Profile::named(name).expect(name).name, name);
        }
        assert_eq!(Profile::named("ib"), None);
    }
}
