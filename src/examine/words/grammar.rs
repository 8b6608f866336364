//! Words by what they do in a sentence: the nouns and verbs of collisions, in the singular and in the plural, and the small
//! words that join them. What stands in no list is of no known kind, and nothing is concluded from it.

/// One or several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// One.
    One,
    /// More than one.
    Several,
}

/// Bodies, of which a sentence tells what they do.
const BODIES: [(&str, &str); 11] = [
    ("sphere", "spheres"),
    ("particle", "particles"),
    ("ball", "balls"),
    ("disc", "discs"),
    ("puck", "pucks"),
    ("stone", "stones"),
    ("bead", "beads"),
    ("body", "bodies"),
    ("object", "objects"),
    ("wall", "walls"),
    ("cushion", "cushions"),
];

/// What is measured of them, and what befalls them.
const NOUNS: [(&str, &str); 37] = [
    ("mass", "masses"),
    ("radius", "radii"),
    ("speed", "speeds"),
    ("velocity", "velocities"),
    ("impulse", "impulses"),
    ("component", "components"),
    ("angle", "angles"),
    ("momentum", "momenta"),
    ("energy", "energies"),
    ("magnitude", "magnitudes"),
    ("coefficient", "coefficients"),
    ("restitution", "restitutions"),
    ("direction", "directions"),
    ("deflection", "deflections"),
    ("distance", "distances"),
    ("value", "values"),
    ("ratio", "ratios"),
    ("sum", "sums"),
    ("product", "products"),
    ("size", "sizes"),
    ("range", "ranges"),
    ("vector", "vectors"),
    ("path", "paths"),
    ("plane", "planes"),
    ("surface", "surfaces"),
    ("floor", "floors"),
    ("table", "tables"),
    ("line", "lines"),
    ("tangent", "tangents"),
    ("normal", "normals"),
    ("centre", "centres"),
    ("center", "centers"),
    ("collision", "collisions"),
    ("impact", "impacts"),
    ("motion", "motions"),
    ("constant", "constants"),
    ("instant", "instants"),
];

/// What may be counted in figures beside them.
const UNITS: [(&str, &str); 6] = [
    ("metre", "metres"),
    ("second", "seconds"),
    ("newton", "newtons"),
    ("joule", "joules"),
    ("degree", "degrees"),
    ("kilogram", "kilograms"),
];

/// Verbs of one and of several, and whether the second is nothing else: `a rebound`, `it hit`.
const VERBS: [(&str, &str, bool); 37] = [
    ("is", "are", true),
    ("was", "were", true),
    ("has", "have", true),
    ("does", "do", true),
    ("lies", "lie", true),
    ("moves", "move", true),
    ("travels", "travel", true),
    ("slides", "slide", true),
    ("rolls", "roll", true),
    ("goes", "go", true),
    ("comes", "come", true),
    ("collides", "collide", true),
    ("strikes", "strike", true),
    ("hits", "hit", false),
    ("meets", "meet", true),
    ("rebounds", "rebound", false),
    ("bounces", "bounce", false),
    ("makes", "make", true),
    ("leaves", "leave", true),
    ("loses", "lose", true),
    ("gains", "gain", true),
    ("turns", "turn", false),
    ("stops", "stop", false),
    ("changes", "change", false),
    ("reverses", "reverse", false),
    ("returns", "return", false),
    ("remains", "remain", true),
    ("continues", "continue", true),
    ("approaches", "approach", false),
    ("reaches", "reach", true),
    ("receives", "receive", true),
    ("exerts", "exert", true),
    ("imparts", "impart", true),
    ("experiences", "experience", false),
    ("catches", "catch", true),
    ("impinges", "impinge", true),
    ("acts", "act", true),
];

/// Words that join what follows to a noun before them.
pub const JOINING: [&str; 29] = [
    "of",
    "between",
    "with",
    "from",
    "to",
    "by",
    "on",
    "for",
    "in",
    "at",
    "towards",
    "against",
    "before",
    "after",
    "during",
    "along",
    "joining",
    "behind",
    "perpendicular",
    "parallel",
    "immediately",
    "just",
    "exerted",
    "given",
    "lost",
    "made",
    "received",
    "moving",
    "travelling",
];

/// Words that may stand between a subject and its verb.
pub const ADVERBS: [&str; 15] = [
    "then",
    "now",
    "also",
    "both",
    "each",
    "all",
    "initially",
    "immediately",
    "not",
    "never",
    "always",
    "just",
    "still",
    "again",
    "subsequently",
];

/// Words that are of no noun phrase.
const CLOSED: [&str; 40] = [
    "and",
    "or",
    "but",
    "that",
    "which",
    "who",
    "whose",
    "where",
    "when",
    "while",
    "if",
    "whether",
    "than",
    "as",
    "so",
    "can",
    "cannot",
    "could",
    "may",
    "might",
    "must",
    "will",
    "would",
    "shall",
    "should",
    "did",
    "had",
    "been",
    "being",
    "be",
    "what",
    "how",
    "because",
    "since",
    "until",
    "there",
    "here",
    "respectively",
    "about",
    "into",
];

/// Words that describe a noun of a collision and are nothing else there.
pub const DESCRIBING: [&str; 33] = [
    "small",
    "large",
    "smooth",
    "uniform",
    "equal",
    "identical",
    "fixed",
    "vertical",
    "horizontal",
    "solid",
    "hard",
    "perfectly",
    "elastic",
    "rough",
    "moving",
    "stationary",
    "other",
    "first",
    "second",
    "third",
    "kinetic",
    "total",
    "final",
    "initial",
    "new",
    "acute",
    "same",
    "straight",
    "parallel",
    "different",
    "unequal",
    "resulting",
    "common",
];

/// How many things a word for a body is of.
pub fn body(word: &str) -> Option<Count> {
    number_in(&BODIES, word)
}

/// How many things a noun is of.
pub fn noun(word: &str) -> Option<Count> {
    body(word).or_else(|| number_in(&NOUNS, word))
}

/// How many things a word is of that may be counted in figures.
pub fn counted(word: &str) -> Option<Count> {
    noun(word).or_else(|| number_in(&UNITS, word))
}

/// The same noun in the other number.
pub fn other_number(word: &str) -> Option<&'static str> {
    let mut all = BODIES.iter().chain(&NOUNS).chain(&UNITS);
    all.find_map(|(one, several)| match word {
        _ if word == *one => Some(*several),
        _ if word == *several => Some(*one),
        _ => None,
    })
}

fn number_in(nouns: &[(&str, &str)], word: &str) -> Option<Count> {
    nouns.iter().find_map(|(one, several)| match word {
        _ if word == *one => Some(Count::One),
        _ if word == *several => Some(Count::Several),
        _ => None,
    })
}

/// Of how many a verb is, and its form for the other number; none for a form that may be something else.
pub fn verb(word: &str) -> Option<(Count, &'static str)> {
    VERBS.iter().find_map(|(one, several, is_alone)| match word {
        _ if word == *one => Some((Count::One, *several)),
        _ if word == *several && *is_alone => Some((Count::Several, *one)),
        _ => None,
    })
}

/// Of how many a word says that what follows is: `a`, `each`, `two`.
pub fn determiner(word: &str) -> Option<Count> {
    const ONE: [&str; 6] = ["a", "an", "each", "every", "one", "this"];
    const SEVERAL: [&str; 6] = ["two", "three", "four", "both", "these", "those"];
    match word {
        _ if ONE.contains(&word) => Some(Count::One),
        _ if SEVERAL.contains(&word) => Some(Count::Several),
        _ => word.parse().ok().filter(|count: &u32| *count > 0).map(|count| match count {
            1 => Count::One,
            _ => Count::Several,
        }),
    }
}

/// Does a word end a noun phrase, or stand outside of any?
pub fn ends_a_phrase(word: &str) -> bool {
    let is_verb = VERBS.iter().any(|(one, several, _)| word == *one || word == *several);
    is_verb || [&JOINING[..], &CLOSED, &ADVERBS].iter().any(|list| list.contains(&word))
}
