//! What is said to happen, or not to: `a second collision`, `they do not collide again`.

use super::phrases::Walk;

/// Words that deny what stands beside them.
pub(crate) const NEVER: [&str; 10] =
    ["no", "not", "never", "cannot", "can't", "don't", "dont", "doesn't", "won't", "without"];
/// Words for one of several impacts that is not the first.
pub(crate) const FURTHER: [&str; 7] = ["further", "more", "second", "other", "subsequent", "longer", "another"];
/// Words for an impact.
pub(crate) const MEETING: [&str; 15] = [
    "collision",
    "collisions",
    "collide",
    "collides",
    "impact",
    "impacts",
    "meet",
    "meets",
    "meeting",
    "hit",
    "hits",
    "strike",
    "strikes",
    "catch",
    "catches",
];

impl Walk<'_> {
    /// The words that say that spheres meet again, or that they do not.
    pub(super) fn meeting(&self, at: usize) -> Option<usize> {
        let denied = self.any(at, &NEVER);
        let further = self.any(denied.unwrap_or(at), &FURTHER);
        let met = self.any(further.or(denied)?, &MEETING)?;
        Some(self.any(met, &["again", "any more", "anymore"]).unwrap_or(met))
    }
}
