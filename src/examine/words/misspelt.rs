//! Slips of the pen in the words of the subject: `sphere`, `perpendicular`, `coefficient`.

use crate::bank::Question;
use crate::examine::Finding;

/// Words of which questions are made, and from which no other word that might stand there is one letter away: `fraction`
/// (friction) and `impact` (impart) are left out.
const WORDS: [&str; 49] = [
    "approaches",
    "before",
    "between",
    "calculate",
    "centres",
    "coefficient",
    "collide",
    "collides",
    "collision",
    "components",
    "conserved",
    "deflected",
    "deflection",
    "determine",
    "direction",
    "energy",
    "horizontal",
    "identical",
    "immediately",
    "impulse",
    "initially",
    "kinetic",
    "magnitude",
    "momentum",
    "motion",
    "moving",
    "obliquely",
    "opposite",
    "parallel",
    "particle",
    "perpendicular",
    "question",
    "radius",
    "rebounds",
    "receives",
    "respectively",
    "restitution",
    "separation",
    "smooth",
    "sphere",
    "spheres",
    "stationary",
    "surface",
    "tangent",
    "towards",
    "uniform",
    "velocities",
    "velocity",
    "vertical",
];

/// Slips that are further from their words, or in words too short to be told from others by one letter.
const KNOWN: [(&str, &str); 9] = [
    ("verticle", "vertical"),
    ("horizontle", "horizontal"),
    ("smoth", "smooth"),
    ("speeed", "speed"),
    ("sphre", "sphere"),
    ("recieves", "receives"),
    ("refrence", "reference"),
    ("consevation", "conservation"),
    ("occured", "occurred"),
];

/// Endings by which one word is made of another, and spellings that some have.
const ENDINGS: [&str; 8] = ["s", "d", "r", "ly", "ed", "al", "er", "n"];

/// The word that is meant by one that begins as it does, is no form of it, and is one letter away: wrong, missing, too many,
/// or exchanged with the next.
pub(super) fn meant(word: &str) -> Option<&'static str> {
    if let Some((_, right)) = KNOWN.iter().find(|(slip, _)| *slip == word) {
        return Some(right);
    }
    let is_plain = word.len() > 5 && word.chars().all(|letter| letter.is_ascii_lowercase());
    let is_american = word.starts_with("center");
    if !is_plain || is_american || WORDS.contains(&word) {
        return None;
    }
    let stem = |word: &'static str| [word.strip_suffix('e'), word.strip_suffix('s'), Some(word)].into_iter().flatten();
    let is_form = |of: &'static str| {
        stem(of).any(|stem| word.strip_prefix(stem).is_some_and(|end| end.is_empty() || ENDINGS.contains(&end)))
    };
    let is_near = |other: &&'static str| {
        other.len() > 5 && other.as_bytes()[0] == word.as_bytes()[0] && strsim::osa_distance(word, other) == 1
    };
    WORDS.into_iter().find(|other| is_near(other) && !is_form(other))
}

/// The word that is meant by one that is another, by the word before it: `heavier then`, `between there`, `it's`.
pub(super) fn meant_after(before: &str, word: &str) -> Option<&'static str> {
    const COMPARED: [&str; 10] =
        ["greater", "less", "heavier", "lighter", "faster", "slower", "larger", "smaller", "rather", "higher"];
    const JOINING: [&str; 3] = ["between", "of", "with"];
    match word {
        "it's" | "it’s" | "its'" | "its’" => Some("its"),
        "then" if COMPARED.contains(&before) => Some("than"),
        "there" if JOINING.contains(&before) => Some("them` or `their"),
        _ => None,
    }
}

/// Slips in the title, which is no text of the paper and is read nowhere else.
pub fn in_the_title(question: &Question) -> Vec<Finding> {
    let words = question.title.split(|sign: char| !sign.is_alphabetic());
    let slip = words.into_iter().find_map(|word| Some((word, meant(word)?)));
    let found = slip.map(|(word, right)| {
        let found = Finding::new(format!("a slip of the pen: `{word}`"), word, "here");
        found.with_help(format!("write `{right}`")).as_warning()
    });
    found.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_told_from_another_by_the_word_before_it() {
        let table = [
            ("heavier", "then", Some("than")),
            ("rest", "then", None),
            ("between", "there", Some("them` or `their")),
            ("and", "there", None),
            ("in", "it's", Some("its")),
            ("in", "its", None),
        ];
        for (before, word, wanted) in table {
            assert_eq!(meant_after(before, word), wanted, "{before} {word}");
        }
    }

    #[test]
    fn slips_of_the_pen_are_told_from_forms_and_other_words() {
        let table = [
            ("spheers", "spheres"),
            ("shperes", "spheres"),
            ("coeficient", "coefficient"),
            ("perpindicular", "perpendicular"),
            ("resitution", "restitution"),
            ("imediately", "immediately"),
            ("horizantal", "horizontal"),
            ("colide", "collide"),
            ("colides", "collides"),
            ("stationery", "stationary"),
            ("velocites", "velocities"),
            ("paralel", "parallel"),
            ("verticle", "vertical"),
            ("smoth", "smooth"),
        ];
        for (typed, word) in table {
            assert_eq!(meant(typed), Some(word), "{typed}");
        }
        let right = "spheres impulses impulsive collides collided colliding collisions velocities directions directed reversal \
                     tangents tangential magnitudes uniformly smoothly centre centers particles components friction fraction \
                     imparts reflection vertically planes plate place surfaces energies reverses approach determined motions \
                     horizontally kinetics smoother smoothed rebound rebounded opposed positive beyond moment moments toward though through";
        for word in right.split_whitespace() {
            assert_eq!(meant(word), None, "{word}");
        }
    }
}
