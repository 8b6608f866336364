//! What the words say is struck first: in the scene that must be the first impact of the one that strikes.

use super::impacts::{Impact, impacts, wall_named};
use super::said::Seen;
use super::sentence::{Sentence, Token, is_one_of, is_supposed, says, subject};
use crate::examine::Finding;
use crate::mechanics::Sphere;

/// Words of what does not come first, or is not said to happen.
const LATER: [&str; 14] = [
    "then",
    "after",
    "afterwards",
    "later",
    "subsequently",
    "next",
    "before",
    "until",
    "having",
    "once",
    "again",
    "not",
    "never",
    "both",
];

impl Seen<'_> {
    /// `*A* strikes the wall, then *B*`, or `it strikes the second wall; then it strikes the first`, where another impact of
    /// the same sphere comes before that one.
    pub(super) fn struck_first(&self, stem: &[Sentence], findings: &mut Vec<Finding>) {
        let strikes = |token: &Token| is_one_of(token, &["strikes", "hits", "meets"]);
        let claim = stem.iter().find_map(|sentence| Some((sentence, sentence.iter().position(strikes)?)));
        let Some((sentence, at)) = claim else { return };
        if is_supposed(sentence) || says(&sentence[..at], &LATER) {
            return;
        }
        let impacts = impacts(&self.question.scene);
        let Some(striker) = striker(&sentence[..at], &impacts) else { return };
        let rest = &sentence[at + 1..];
        let (number, struck) = match (rest, wall_named(&self.question.scene, rest)) {
            ([Token::Sphere(other), ..], _) if *other != striker => {
                let theirs = impacts.iter().find(|impact| impact.has(striker) && impact.has(*other));
                (theirs.map(|impact| impact.number), format!("*{}*", other.name()))
            }
            (_, Some(wall)) => (Some(wall), "wall".to_owned()),
            _ => return,
        };
        let (Some(number), Some(first)) = (number, impacts.iter().find(|impact| impact.has(striker))) else { return };
        if first.number < number && impacts[usize::from(number)].has(striker) {
            let name = striker.name();
            let message = format!(
                "the words let `*{name}*` strike first what it strikes in impact {} of the scene, and it takes part in impact {}",
                number + 1,
                first.number + 1
            );
            let help = "tell the impacts in their order, or change the order of `[scene]` and its `then`";
            findings.push(self.finding(message, &struck, help));
        }
    }
}

/// Who strikes by the words before: the one that is named, or `it` that has just been spoken of; or the only one there is.
fn striker(before: &[Token], impacts: &[Impact]) -> Option<Sphere> {
    let named = match before {
        [before @ .., it] if is_one_of(it, &["it"]) => subject(before),
        before => subject(before),
    };
    let is_alone = || impacts.iter().all(|impact| impact.is_of_one() && impact.has(Sphere::A));
    named.or_else(|| is_alone().then_some(Sphere::A))
}

#[cfg(test)]
mod tests {
    use super::super::said_tests::said;
    use crate::examine::Edits;

    #[test]
    fn what_is_struck_first_is_the_first_impact_of_the_one_that_strikes() {
        let (corner, onto) = ("successive/corner", "successive/sphere-wall-sphere");
        let table: [(&str, Edits, &str); 5] = [
            (corner, &[], ""),
            (
                corner,
                &[(
                    "strikes the first\nwall; then it strikes the second",
                    "strikes the second\nwall; then it strikes the first",
                )],
                "strike first what it strikes in impact 2",
            ),
            (onto, &[], ""),
            (onto, &[("when it strikes *B* directly.", "when it strikes *B* directly. *B* strikes the wall.")], ""),
            (
                onto,
                &[("when it strikes *B* directly.", "and *B* strikes the wall, then *A*.")],
                "strike first what it strikes in impact 2",
            ),
        ];
        for (id, edits, words) in table {
            let said = said(id, edits);
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
