//! What every scene takes to be so, and a student only if the words say it: smooth spheres and planes, equal radii.

use super::impacts::impacts;
use super::sentence::{Sentence, Token, is_one_of, says, sentences};
use crate::bank::{Question, Style};
use crate::examine::Finding;

/// What meets.
const SPHERES: [&str; 6] = ["sphere", "spheres", "ball", "balls", "disc", "discs"];
/// On what they move.
const PLANES: [&str; 6] = ["plane", "table", "surface", "floor", "ice", "ground"];

/// Words that may describe a plane or a wall beside others.
const DESCRIBING: [&str; 6] = ["smooth", "fixed", "vertical", "horizontal", "long", "straight"];

/// How something is to the touch. That nothing is rough is told where the word stands.
const TOUCHED: [&str; 2] = ["smooth", "rough"];

/// What the words leave out, and what they say of planes and walls that no scene has.
pub fn unsaid(question: &Question) -> Vec<Finding> {
    let found = |check: &fn(&Question, &[Sentence]) -> Option<Finding>| {
        question.styles.iter().find_map(|style| check(question, &said(style)))
    };
    let left_out = [spheres, planes, radii];
    let of_no_scene = [sloping, walls];
    left_out.iter().filter_map(found).map(Finding::as_warning).chain(of_no_scene.iter().filter_map(found)).collect()
}

fn said(style: &Style) -> Vec<Sentence<'_>> {
    style.stem.iter().chain([&style.note]).flat_map(sentences).collect()
}

fn untold(what: &str, at: &str, help: &str) -> Finding {
    Finding::new(format!("the words never say {what}"), at, "the scene takes it to be so").with_help(help)
}

/// The first of some words that is said, and whether `smooth` describes any of them.
fn described(said: &[Sentence], nouns: &[&str]) -> Option<(String, bool)> {
    let is_noun = |token: &&Token| is_one_of(token, nouns);
    let first = said.iter().flatten().find(is_noun)?;
    let is_smooth = said.iter().any(|sentence| {
        let of = |at: usize| sentence[at + 1..].iter().take(4).any(|token| is_one_of(token, nouns));
        (0..sentence.len()).any(|at| is_one_of(&sentence[at], &TOUCHED) && of(at))
    });
    // `The spheres are smooth and have equal radii`, `The plane on which they move is smooth`
    let are_smooth = |sentence: &Sentence| {
        let at =
            sentence.windows(2).position(|pair| is_one_of(&pair[0], &["is", "are"]) && is_one_of(&pair[1], &TOUCHED));
        // `Both are smooth`, `*A* and *B* are smooth`: neither is a plane.
        let of_spheres = |words: &[Token]| {
            nouns == SPHERES
                && (says(words, &["both", "they", "all"])
                    || words.iter().any(|token| matches!(token, Token::Sphere(_))))
        };
        at.is_some_and(|at| says(&sentence[..at], nouns) || of_spheres(&sentence[..at]))
    };
    let is_smooth = is_smooth || said.iter().any(are_smooth);
    let Token::Word(first) = first else { return None };
    Some((first.clone(), is_smooth))
}

/// Spheres that meet obliquely keep their velocities across the line of centres, as they are smooth.
fn spheres(question: &Question, said: &[Sentence]) -> Option<Finding> {
    let (word, is_smooth) = described(said, &SPHERES)?;
    let help = "begin with `Two smooth uniform spheres`, or `A smooth uniform sphere`";
    (is_oblique(question) && !is_smooth).then(|| untold("that the spheres are smooth", &word, help))
}

/// Nothing slows down what moves on a smooth plane.
fn planes(_: &Question, said: &[Sentence]) -> Option<Finding> {
    // A plane in which vectors lie is none on which anything moves.
    let is_trodden = |sentence: &&Sentence| says(sentence, &["on"]);
    let on: Vec<Sentence> = said.iter().filter(is_trodden).cloned().collect();
    let ((word, _), (_, is_smooth)) = (described(&on, &PLANES)?, described(said, &PLANES)?);
    let help = format!("say `a smooth horizontal {word}`");
    (!is_smooth).then(|| untold(&format!("that the {word} is smooth"), &word, &help))
}

/// The word for something, and the word that describes it so.
fn described_as<'s>(said: &'s [Sentence], nouns: &[&str], words: &[&str]) -> Option<(&'s str, &'s str)> {
    let (nouns_after, is_word) = (|token: &Token| is_one_of(token, nouns), |token: &Token| is_one_of(token, words));
    said.iter().find_map(|sentence| {
        (0..sentence.len()).filter(|at| is_word(&sentence[*at])).find_map(|at| {
            let noun = sentence[at + 1..].iter().find(|token| !is_one_of(token, &DESCRIBING))?;
            let noun = Some(noun).filter(|noun| nouns_after(noun))?;
            match (noun, &sentence[at]) {
                (Token::Word(noun), Token::Word(word)) => Some((noun.as_str(), word.as_str())),
                _ => None,
            }
        })
    })
}

/// On a plane that slopes the weight acts along it.
fn sloping(_: &Question, said: &[Sentence]) -> Option<Finding> {
    let (noun, word) = described_as(said, &PLANES, &["inclined", "sloping", "vertical"])?;
    let message = format!("the words say `{word} {noun}`, and scenes are of smooth horizontal ones");
    let help = format!("write `a smooth horizontal {noun}`");
    Some(Finding::new(message, format!("{word} {noun}"), "not as the scene is solved").with_help(help))
}

/// Walls stand, and stand still.
fn walls(_: &Question, said: &[Sentence]) -> Option<Finding> {
    let (noun, word) = described_as(said, &["wall", "walls"], &["horizontal", "inclined", "sloping", "moving"])?;
    let message = format!("the words say `{word} {noun}`, and scenes are of smooth fixed vertical ones");
    let help = format!("write `smooth fixed vertical {noun}`");
    Some(Finding::new(message, word, "not as the scene is solved").with_help(help))
}

/// Words by which spheres are said to have one radius.
const ALIKE: [&str; 9] =
    ["radius", "radii", "identical", "size", "sizes", "sized", "equal-sized", "equally-sized", "discs"];

/// Spheres of unlike radii have a line of centres that is not horizontal.
fn radii(question: &Question, said: &[Sentence]) -> Option<Finding> {
    let is_told = said.iter().any(|sentence| says(sentence, &ALIKE));
    let (word, _) = described(said, &SPHERES)?;
    let help = "say `of equal radii`, or `The spheres have equal radii.`";
    (is_oblique(question) && !is_told).then(|| untold("that the spheres have equal radii", &word, help))
}

/// Do two spheres meet first, and not in one line?
fn is_oblique(question: &Question) -> bool {
    !question.scene.is_in_one_line() && impacts(&question.scene).first().is_some_and(|first| !first.is_of_one())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn what_the_scene_takes_to_be_so_is_said() {
        let (rest, wall, direct) =
            ("rest/speeds-and-directions", "walls/rebound-speed-and-direction", "direct/velocities-after-impact");
        let table: [(&str, Edits, &str); 16] = [
            (rest, &[], ""),
            (rest, &[("smooth uniform", "uniform"), ("The spheres have", "Both are smooth and have")], ""),
            (rest, &[("smooth uniform sphere", "uniform sphere")], "that the spheres are smooth"),
            (rest, &[("smooth uniform", "uniform"), ("have equal", "are smooth and have equal")], ""),
            (rest, &[("smooth horizontal", "horizontal")], "that the plane is smooth"),
            (
                rest,
                &[("smooth horizontal", "horizontal"), (" The spheres have", " The plane is smooth. The spheres have")],
                "",
            ),
            (rest, &[(" The spheres have equal radii.", "")], "that the spheres have equal radii"),
            (wall, &[("smooth horizontal", "horizontal")], "that the plane is smooth"),
            (wall, &[("A smooth uniform", "A uniform")], ""),
            (rest, &[("smooth horizontal", "smooth inclined")], "say `inclined plane`"),
            (wall, &[("fixed vertical", "fixed horizontal")], "say `horizontal wall`"),
            (wall, &[("smooth fixed", "moving smooth")], "say `moving wall`"),
            (wall, &[("smooth fixed", "large smooth fixed")], ""),
            (direct, &[], ""),
            ("i-j/velocities-after-impact", &[], ""),
            ("vector-impulse/impulse-from-two-velocities", &[("A puck *A*", "A ball *A*")], ""),
        ];
        for (id, edits, words) in table {
            let said: String = unsaid(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
