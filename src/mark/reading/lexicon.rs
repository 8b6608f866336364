//! The words that students write around their values, by what they do to them.

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use super::tokens::is_greek;
use super::units::is_unit_word;

/// What a word does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    /// Joins statements.
    Joiner,
    /// Begins a reason.
    Because,
    /// Joins rivals.
    Or,
    /// Names a quantity.
    Noun,
    /// Stands for an equals sign.
    Is,
    /// Says that a gradient follows.
    Gradient,
    /// May turn the meaning round.
    Negation,
    /// Does nothing.
    Plain,
}

/// At rest, in words.
pub(super) const REST: [&str; 27] = [
    "at rest",
    "is at rest",
    "remains at rest",
    "stays at rest",
    "is brought to rest",
    "brought to rest",
    "comes to rest",
    "came to rest",
    "come to rest",
    "to rest",
    "stationary",
    "is stationary",
    "does not move",
    "doesn't move",
    "doesnt move",
    "not moving",
    "is not moving",
    "isn't moving",
    "no velocity",
    "no speed",
    "has no velocity",
    "zero velocity",
    "stops",
    "stopped",
    "is stopped",
    "stays still",
    "is still",
];

/// Words before the line to which something is perpendicular.
pub(super) const ACROSS: [&str; 12] = [
    "perpendicular",
    "perpendicular direction",
    "perpendicularly",
    "perp",
    "normal to",
    "at right angles",
    "at a right angle",
    "right angles",
    "at right angle",
    "in direction perpendicular",
    "in the direction perpendicular",
    "moving perpendicular",
];

/// Words before the line along which something moves.
pub(super) const ALONG: [&str; 15] = [
    "along",
    "parallel to",
    "parallel with",
    "parallel",
    "in direction of",
    "in direction",
    "in a direction parallel to",
    "in direction parallel to",
    "in line with",
    "in direction of vector",
    "in direction along",
    "parallel to vector",
    "direction of",
    "direction is parallel to",
    "on",
];

/// Words before the line from which an angle is measured.
pub(super) const ANGLE: [&str; 14] = [
    "to",
    "with",
    "from",
    "against",
    "above",
    "below",
    "off",
    "measured from",
    "relative to",
    "made with",
    "with respect to",
    "wrt",
    "away from",
    "measured to",
];

/// The line of centres, without its article.
pub(super) const CENTRES: [&str; 23] = [
    "line of centres",
    "line of centre",
    "lines of centres",
    "loc",
    "line joining centres",
    "line connecting centres",
    "line through centres",
    "line between centres",
    "line of their centres",
    "line of joining centres",
    "line joining a and b",
    "line joining a to b",
    "line connecting a and b",
    "line connecting a to b",
    "line through a and b",
    "line between a and b",
    "line joining centre of a to centre of b",
    "line joining centre of a and centre of b",
    "centre line",
    "line of impact",
    "common normal",
    "normal",
    "line ab",
];

/// The common tangent.
pub(super) const TANGENT: [&str; 15] = [
    "common tangent",
    "tangent",
    "common tangent plane",
    "tangent plane",
    "tangential direction",
    "plane of contact",
    "tangent at contact",
    "tangent at point of contact",
    "common tangent at point of contact",
    "wall",
    "smooth wall",
    "vertical wall",
    "plane of wall",
    "line of wall",
    "surface",
];

/// The line of centres from A to B. `AB` alone may be the line or the sense.
pub(super) const A_TO_B: [&str; 9] = [
    "direction ab",
    "direction of ab",
    "vector ab",
    "a to b",
    "from a to b",
    "direction a to b",
    "direction from a to b",
    "direction of a to b",
    "sense from a to b",
];

/// The line of centres from B to A.
pub(super) const B_TO_A: [&str; 11] = [
    "ba",
    "line ba",
    "direction ba",
    "direction of ba",
    "vector ba",
    "b to a",
    "from b to a",
    "direction b to a",
    "direction from b to a",
    "direction of b to a",
    "sense from b to a",
];

/// Words before the sphere towards which something moves.
pub(super) const TOWARDS: [&str; 6] =
    ["towards", "toward", "heading towards", "heading for", "in direction of", "in direction towards"];

/// Words before the sphere from which something moves away.
pub(super) const AWAY_FROM: [&str; 1] = ["away from"];

/// The direction in which a sphere moved before.
pub(super) const ORIGINAL: [&str; 20] = [
    "path before",
    "path",
    "direction before",
    "line of motion before",
    "velocity before",
    "motion before",
    "original direction",
    "initial direction",
    "original direction of motion",
    "initial direction of motion",
    "original direction of travel",
    "original direction of movement",
    "original line of motion",
    "original path",
    "initial path",
    "original velocity",
    "initial velocity",
    "original motion",
    "previous direction",
    "direction of motion before",
];

/// What may follow the name of a line and adds nothing.
pub(super) const AFTER_A_LINE: [&str; 8] =
    ["of spheres", "of two spheres", "of A and B", "of a and b", "of balls", "of collision", "direction", "of impact"];

/// Runs of words that say nothing about the value.
pub(super) const REMARKS: [&str; 27] = [
    "as required",
    "no units",
    "no unit",
    "as expected",
    "as given",
    "as shown",
    "as before",
    "as needed",
    "as a decimal",
    "as a fraction",
    "to the right",
    "to the left",
    "to right",
    "to left",
    "in opposite direction",
    "in same direction",
    "from its path",
    "to each other",
    "in total",
    "in magnitude",
    "in ratio",
    "to 3sf",
    "i got",
    "i get",
    "i think",
    "i found",
    "i believe",
];

/// After the highest value of a range.
pub(super) const OR_LESS: [&str; 8] =
    ["or less", "and less", "or below", "and below", "or under", "or lower", "or smaller", "or fewer"];

/// After the lowest value of a range.
pub(super) const OR_MORE: [&str; 9] =
    ["or more", "or above", "and above", "or over", "and over", "or higher", "or greater", "or larger", "and upwards"];

/// Before an end that is no part of its range.
pub(super) const EXCLUDING: [&str; 4] = ["not including", "but not including", "excluding", "but excluding"];

/// Words before a noun that make it the name of something else.
pub(super) const OTHERS: [&str; 13] = [
    "initial",
    "original",
    "relative",
    "average",
    "mean",
    "final",
    "total",
    "horizontal",
    "vertical",
    "tangential",
    "perpendicular",
    "perp",
    "parallel",
];

/// Single words, by what they do.
const SINGLE: [(Sort, &str); 8] = [
    (
        Sort::Joiner,
        "and so hence therefore thus then giving gives give at with in makes making make moves moving move moved \
         which hence also but while whereas travels travelling going leaving leaves having has to from by through",
    ),
    (Sort::Because, "because since as due where if when"),
    (Sort::Or, "or alternatively"),
    (
        Sort::Noun,
        "speed speeds velocity velocities vel angle angles direction directions dir deflection deflected impulse ke \
         kinetic energy loss lost change gain fraction percentage magnitude mag component components momentum ratio \
         mass coefficient restitution turned bearing increase increases increased gained gains decrease decreases \
         decreased loses reduced reduces reduction falls fell drop drops dropped slows slowed rises rose answer ans tangent separation approach difference acceleration work distance force time",
    ),
    (Sort::Is, "is are was be becomes being equal must lies"),
    (Sort::Gradient, "gradient slope"),
    (
        Sort::Negation,
        "impossible wrong incorrect not never no isn't isnt aren't doesn't doesnt don't dont cannot can't cant won't wasn't neither nor unless \
         except minimum maximum least most than under over less more half twice double triple treble quarter third \
         hundred hundreds thousand thousands million dozen ten twenty squared cubed power unsure guess maybe \
         negative opposite reverse backwards one two three four five six seven eight nine zero \
         nought point divided multiplied",
    ),
    (
        Sort::Plain,
        "inclusive exclusive strictly between of the a an its their both approx approximately about roughly around circa say exactly only just after \
         before finally initially final initial new total sphere spheres ball balls disc discs body particle particles \
         along parallel perp perpendicular right left up down upwards downwards north south east west rightwards \
         leftwards horizontally vertically acute obtuse clockwise anticlockwise counterclockwise away towards it they \
         i.e ie eg sf dp s.f d.p rounded decimal places significant figures correct collision impact afterwards \
         that this these for on off each other line centres centers vector unit magnitude required shown qed \
         respectively simplified exact value surd form answer ans path motion travel axis oe awrt cao sense \
         immediately original towards heading bounces bouncing rebounds rebounding rebounded separates separating yes reversed reverses unchanged done \
         remains remaining retained kept hopefully think calculator working see diagram there here now very nearly almost precisely overall resultant \
         scalar using used calculated find found get got have we solution value values part question result results \
         answers both my our checked units metric decimal fraction respectively clm com colm pclm plm mom cons nel nlr nlor nli \
         rejected reject rejecting discard discarded ignore ignored disregard disregarded inadmissible invalid scrap \
         scrapped cancel cancelled canceled delete deleted void withdrawn mistake error crossed clearly obviously \
         eventually conservation linear law eq eqn equation substituting subtracting adding",
    ),
];

/// Single words and what they do, for looking up.
static SORTS: LazyLock<HashMap<&str, Sort>> = LazyLock::new(|| {
    let words = SINGLE.iter().rev().flat_map(|(sort, words)| words.split_whitespace().map(|word| (word, *sort)));
    words.collect()
});

/// The lists whose entries are phrases.
const PHRASES: [&[&str]; 12] =
    [&REST, &ACROSS, &ALONG, &ANGLE, &CENTRES, &TANGENT, &A_TO_B, &B_TO_A, &TOWARDS, &AWAY_FROM, &ORIGINAL, &REMARKS];

/// Every word with which a phrase can begin.
static STARTS: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let first = PHRASES.into_iter().flatten().filter_map(|words| words.split(' ').next());
    first
        .chain([
            "at",
            "in",
            "perpendicular",
            "perp",
            "normal",
            "the",
            "its",
            "their",
            "a",
            "an",
            "this",
            "ab",
            "tangentially",
        ])
        .collect()
});

/// Every word that stands in a list of this file.
static KNOWN: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let phrases = PHRASES.into_iter().flatten().chain(&AFTER_A_LINE).chain(&OTHERS);
    let single = SINGLE.iter().flat_map(|(_, words)| words.split_whitespace());
    phrases.flat_map(|words| words.split(' ')).chain(single).collect()
});

/// Is it a word of a language that nobody here knows?
pub(crate) fn is_strange(word: &str) -> bool {
    let small = word.to_lowercase();
    word.is_ascii() && is_only_a_word(word) && !KNOWN.contains(&*small) && !is_greek(&small) && !is_unit_word(word)
}

/// What a single word does; it is in small letters.
pub(super) fn sort(word: &str) -> Option<Sort> {
    SORTS.get(word).copied()
}

/// Does a word that does this stand for itself, whatever letters the question has?
pub(super) fn stands_for_itself(word: &str, sort: Option<Sort>) -> bool {
    word.len() >= 4 && sort.is_some()
}

/// Is it a word that is never made of letters of the question?
pub(crate) fn is_never_letters(word: &str) -> bool {
    stands_for_itself(word, sort(&word.to_ascii_lowercase()))
}

/// Can a phrase begin with this word?
pub(super) fn begins_a_phrase(word: &str) -> bool {
    STARTS.contains(word)
}

/// Is it the name of a sphere or particle?
pub(super) fn is_sphere(word: &str) -> bool {
    matches!(word, "A" | "B" | "P" | "Q" | "C")
}

/// Is it a word of a language rather than a formula gone wrong: long, with vowels and consonants, in one case?
pub(super) fn is_only_a_word(word: &str) -> bool {
    let rest = word.get(1..).unwrap_or_default();
    let vowels = word.chars().filter(|letter| "aeiouyAEIOUY".contains(*letter)).count();
    word.len() >= 4
        && vowels * 5 >= word.len()
        && vowels < word.len()
        && rest.chars().all(|letter| letter.is_ascii_lowercase())
        && !["sin", "cos", "tan", "sqr", "root", "log", "arc", "inv"].iter().any(|start| word.starts_with(start))
}
