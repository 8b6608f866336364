//! The impacts of a scene, as words speak of them: who takes part, and whether a wall is struck.

use super::sentence::{Token, is_one_of};
use crate::mechanics::{SceneText, Sphere};

/// One of them.
pub struct Impact<'q> {
    /// How many come before it.
    pub number: u8,
    /// Is it with a wall?
    pub is_wall: bool,
    of: Vec<&'q str>,
}

impl Impact<'_> {
    /// Does a sphere take part?
    pub fn has(&self, sphere: Sphere) -> bool {
        self.of.contains(&sphere.name())
    }

    /// Is there no other sphere in it?
    pub fn is_of_one(&self) -> bool {
        self.of.len() == 1
    }
}

/// All of them, in their order.
pub fn impacts(scene: &SceneText) -> Vec<Impact<'_>> {
    let first = (scene.wall.is_some(), if scene.is_of_one() { vec!["A"] } else { vec!["A", "B"] });
    let later = scene.then.iter().map(|then| (then.wall.is_some(), then.of.iter().map(String::as_str).collect()));
    let all = [first].into_iter().chain(later);
    (0..).zip(all).map(|(number, (is_wall, of))| Impact { number, is_wall, of }).collect()
}

/// The impact with the wall that words begin with: `the wall`, if there is one alone, or `the second wall`.
pub fn wall_named(scene: &SceneText, words: &[Token]) -> Option<u8> {
    const DESCRIBED: [&str; 8] = ["the", "a", "this", "that", "smooth", "fixed", "vertical", "plane"];
    let described = words.iter().take_while(|token| is_one_of(token, &DESCRIBED) || ordinal(token).is_some()).count();
    words.get(described).filter(|token| is_one_of(token, &["wall"]))?;
    let walls: Vec<u8> = impacts(scene).iter().filter(|impact| impact.is_wall).map(|impact| impact.number).collect();
    match (walls.as_slice(), words[..described].iter().find_map(ordinal)) {
        ([one], None) => Some(*one),
        (several, nth) => several.get(nth?).copied(),
    }
}

/// The impact with the wall from which an angle is measured for which these words come next: `with the second wall`.
pub fn wall_measured_from(scene: &SceneText, after: &[Token]) -> Option<u8> {
    let after =
        &after[..after.iter().position(|token| matches!(token, Token::Number(..))).unwrap_or(after.len()).min(10)];
    let leads = (0..after.len()).filter(|place| is_one_of(&after[*place], &["with", "to", "and", "between"]));
    leads.into_iter().find_map(|place| wall_named(scene, &after[place + 1..]))
}

/// The vector along the wall of an impact, as it is written in the scene.
pub fn wall_of(scene: &SceneText, impact: u8) -> Option<&[String; 2]> {
    match impact.checked_sub(1) {
        None => scene.wall.as_ref(),
        Some(later) => scene.then.get(usize::from(later))?.wall.as_ref(),
    }
}

/// The place that a word gives in a row: `first` is 0.
pub fn ordinal(token: &Token) -> Option<usize> {
    ["first", "second", "third", "fourth"].iter().position(|nth| is_one_of(token, &[nth]))
}
