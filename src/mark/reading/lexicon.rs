//! The words that students write around their values, one by one, by what they do to them.

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use super::centres;
use super::tokens::is_greek;
use super::units::is_unit_word;
use super::wording::{AFTER_A_LINE, PHRASES};

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
    /// Takes back the value beside it.
    Rejection,
    /// Does nothing.
    Plain,
}

/// Words for what falls short of the value beside it.
pub(crate) const NOT_QUITE: [&str; 2] = ["nearly", "almost"];

/// Words for what is so only roughly.
const ROUGHLY: [&str; 7] = ["very", "approximately", "approx", "about", "roughly", "around", "circa"];

/// Words for the most that there can be, and for the least.
pub(crate) const MOST: [&str; 6] = ["maximum", "max", "greatest", "largest", "highest", "fastest"];
pub(crate) const LEAST: [&str; 5] = ["minimum", "min", "smallest", "lowest", "slowest"];

/// Words for the size of a vector.
pub(crate) const SIZES: [&str; 4] = ["magnitude", "mag", "modulus", "size"];

/// Words for what is no longer so.
pub(crate) const PAST: [&str; 2] = ["was", "were"];

/// Words for the way that something points, on the page.
pub(crate) const WAYS: [&str; 8] =
    ["right", "left", "up", "down", "upwards", "downwards", "horizontally", "vertically"];

/// Words before a noun that make it the name of something else; so do those for the most and the least.
const OTHERS: [&str; 14] = [
    "each",
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

/// Words that may turn a value round, but not from within a reason for it.
pub(super) const COMPARISONS: [&str; 9] =
    ["than", "less", "more", "under", "over", "negative", "opposite", "zero", "nought"];

/// Words that stand for signs or functions, and these.
pub(super) const SIGNS: [(&str, &str); 102] = [
    ("times", "*"),
    ("lots of", "*"),
    ("multiplied by", "*"),
    ("over", "/"),
    ("divided by", "÷"),
    ("plus", "+"),
    ("minus", "-"),
    ("equals", "="),
    ("is equal to", "="),
    ("squared", "^2"),
    ("cubed", "^3"),
    ("per cent", "%"),
    ("percent", "%"),
    ("root of", "√"),
    ("square root of", "√"),
    ("square root", "√"),
    ("sqrt of", "√"),
    ("cube root of", "∛"),
    ("cube root", "∛"),
    ("inverse sin", "arcsin"),
    ("inverse sine", "arcsin"),
    ("inverse sin of", "arcsin"),
    ("inverse sine of", "arcsin"),
    ("sin inverse", "arcsin"),
    ("inverse cos", "arccos"),
    ("inverse cosine", "arccos"),
    ("inverse cos of", "arccos"),
    ("inverse cosine of", "arccos"),
    ("cos inverse", "arccos"),
    ("inverse tan", "arctan"),
    ("inverse tangent", "arctan"),
    ("inverse tan of", "arctan"),
    ("inverse tangent of", "arctan"),
    ("tan inverse", "arctan"),
    ("arc sin", "arcsin"),
    ("arc cos", "arccos"),
    ("arc tan", "arctan"),
    ("inv sin", "arcsin"),
    ("inv cos", "arccos"),
    ("inv tan", "arctan"),
    ("sq root", "√"),
    ("sq root of", "√"),
    ("sqr root", "√"),
    ("sqr root of", "√"),
    ("greater then", ">"),
    ("less then", "<"),
    ("inverse cot", "arccot"),
    ("inverse sec", "arcsec"),
    ("inverse cosec", "arccosec"),
    ("out of", "/"),
    ("greater than", ">"),
    ("more than", ">"),
    ("larger than", ">"),
    ("bigger than", ">"),
    ("less than", "<"),
    ("smaller than", "<"),
    ("at least", "≥"),
    ("no less than", "≥"),
    ("not less than", "≥"),
    ("greater than or equal to", "≥"),
    ("at most", "≤"),
    ("no more than", "≤"),
    ("not more than", "≤"),
    ("neither less than", "≥"),
    ("nor more than", ",≤"),
    ("nor greater than", ",≤"),
    ("and nor more than", ",≤"),
    ("nor less than", ",≥"),
    ("neither more than", "≤"),
    ("no greater than", "≤"),
    ("no bigger than", "≤"),
    ("no larger than", "≤"),
    ("no higher than", "≤"),
    ("no smaller than", "≥"),
    ("no lower than", "≥"),
    ("not smaller than", "≥"),
    ("not greater than", "≤"),
    ("less than or equal to", "≤"),
    ("exceeds", ">"),
    ("exceeding", ">"),
    ("does not exceed", "≤"),
    ("doesn't exceed", "≤"),
    ("not exceeding", "≤"),
    ("cannot exceed", "≤"),
    ("can't exceed", "≤"),
    ("cannot be more than", "≤"),
    ("can't be more than", "≤"),
    ("cannot be greater than", "≤"),
    ("can't be greater than", "≤"),
    ("cannot be less than", "≥"),
    ("can't be less than", "≥"),
    ("up to and including", "≤"),
    ("infinity", "∞"),
    ("inf", "∞"),
    ("element of", "∈"),
    ("must exceed", ">"),
    ("is positive", ">0"),
    ("positive", ">0"),
    ("must be positive", ">0"),
    ("has to be positive", ">0"),
    ("can't be negative", "≥0"),
    ("cannot be negative", "≥0"),
];

/// Words that stand for signs before a number alone: `negative 0.75`, `e above 1/3`.
pub(super) const BEFORE_A_NUMBER: [(&str, &str); 4] =
    [("negative", "-"), ("above", ">"), ("below", "<"), ("over", ">")];

/// Single words, by what they do.
const SINGLE: [(Sort, &str); 9] = [
    (
        Sort::Joiner,
        "and so hence therefore thus then giving gives give at with in inclined makes making make moves moving move moved \
         which hence also but while whereas travels travelling going leaving leaves having has to from by through",
    ),
    (Sort::Because, "because since as due where if when"),
    (Sort::Or, "or alternatively"),
    (
        Sort::Noun,
        "speed speeds velocity velocities vel angle angles direction directions dir deflection deflected impulse ke \
         kinetic energy loss lost change gain fraction percentage magnitude mag mod modulus component components momentum ratio \
         mass coefficient restitution turned turns deflects deviation deviates deviated rotated rotates coeff coef bearing increase increases increased gained gains decrease decreases \
         decreased loses reduced reduces reduction falls fell drop drops dropped slows slowed rises rose answer ans tangent separation approach difference acceleration work distance force time",
    ),
    (Sort::Is, "is are was be becomes being equal must should lies"),
    (Sort::Gradient, "gradient grad slope"),
    (
        Sort::Negation,
        "minimum wrong incorrect not never no isn't isnt aren't doesn't doesnt don't dont cannot can't cant won't wasn't neither nor unless \
         except least most than under over less more half twice double triple treble quarter third \
         hundred hundreds thousand thousands million dozen ten twenty squared cubed power unsure guess maybe \
         negative opposite reverse backwards one two three four five six seven eight nine zero \
         nought point divided multiplied",
    ),
    (
        Sort::Rejection,
        "reject rejected rejecting discard discarded disregard disregarded ignore ignored inadmissible invalid scrap \
         scrapped impossible cancel cancelled canceled delete deleted void withdrawn mistake error crossed",
    ),
    (
        Sort::Plain,
        "maximum max possible all anything valid range inclusive exclusive strictly any between of the a an its their both approx approximately about roughly around circa say exactly only just after \
         before finally initially final initial new total sphere spheres ball balls disc discs body particle particles \
         along parallel par para perp perpendicular right left up down upwards downwards north south east west rightwards \
         leftwards horizontally vertically acute obtuse clockwise anticlockwise counterclockwise away towards it they \
         i.e ie eg sf dp s.f d.p rounded decimal places significant figures correct collision impact into afterwards \
         that this these set for on off each other line centres centers vector unit magnitude required shown qed \
         respectively simplified exact value form answer ans greatest largest system exerts continues path paths motion travel axis oe awrt cao sense \
         immediately original towards heading bounces bouncing bounce rebounds rebounding rebounded rebound separates separating yes reversed reverses unchanged done \
         remains remaining retained kept hopefully think calculator working see diagram there here now directed directly acts acting straight slides rolls glides very nearly almost precisely overall resultant \
         scalar using used calculated find found get got have we solution value values part question result results \
         answers both my our checked units metric decimal fraction respectively clm com colm pclm plm mom cons nel nlr nlor nli \
         collide collides meet meets catch catches hit hits strike strikes again continue does do will clearly obviously eventually need needs provided requires needed condition conservation linear law eq eqn equation substituting subtracting adding pythagoras pythag trig trigonometry",
    ),
];

/// Single words and what they do, for looking up.
static SORTS: LazyLock<HashMap<&str, Sort>> = LazyLock::new(|| {
    let words = SINGLE.iter().rev().flat_map(|(sort, words)| words.split_whitespace().map(|word| (word, *sort)));
    words.collect()
});

/// Every word with which a phrase can begin.
static STARTS: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let first = PHRASES.into_iter().flatten().filter_map(|words| words.split(' ').next());
    let others = "at in down up perpendicular perp normal the its their a an this ab tangentially";
    first.chain(centres::starts()).chain(others.split(' ')).collect()
});

/// Every word that stands in a list of words or of phrases.
static KNOWN: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let others = OTHERS.iter().chain(&MOST).chain(&LEAST);
    let phrases =
        PHRASES.into_iter().flatten().chain(&AFTER_A_LINE).chain(others).chain(centres::WORDS.into_iter().flatten());
    let single = SINGLE.iter().flat_map(|(_, words)| words.split_whitespace());
    phrases.flat_map(|words| words.split(' ')).chain(single).collect()
});

/// Is it a word of a language that nobody here knows?
pub(crate) fn is_strange(word: &str) -> bool {
    let small = word.to_lowercase();
    // A command of LaTeX that was understood is none.
    let is_command = word.starts_with('\\');
    !is_command
        && word.is_ascii()
        && is_only_a_word(word)
        && !KNOWN.contains(&*small)
        && !is_greek(&small)
        && !is_unit_word(word)
}

/// Does the word, in small letters, say that a state is not quite reached: `nearly at rest`?
pub(super) fn falls_short(word: &str) -> bool {
    NOT_QUITE.contains(&word) || ROUGHLY.contains(&word)
}

/// Does the word before a noun make it the name of something else: `relative speed`? It is in small letters.
pub(super) fn is_other(word: &str) -> bool {
    [&OTHERS[..], &MOST, &LEAST].iter().any(|words| words.contains(&word))
}

/// Does the word take back the value beside it; it is in small letters.
pub(crate) fn is_rejection(word: &str) -> bool {
    sort(word) == Some(Sort::Rejection)
}

/// What a single word does; it is in small letters.
pub(super) fn sort(word: &str) -> Option<Sort> {
    SORTS.get(word).copied()
}

/// Does it name a quantity?
pub(crate) fn names_a_quantity(word: &str) -> bool {
    sort(&word.to_lowercase()) == Some(Sort::Noun)
}

/// May it turn round what is said, or take it back?
pub(crate) fn turns_round(word: &str) -> bool {
    matches!(sort(&word.to_lowercase()), Some(Sort::Negation | Sort::Rejection))
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
