//! What students write around their values in several words: how they say it.

/// At rest, in words.
pub(super) const REST: [&str; 32] = [
    "at rest",
    "is at rest",
    "remains at rest",
    "stays at rest",
    "is brought to rest",
    "brought to rest",
    "comes to rest",
    "came to rest",
    "come to rest",
    "comes to stop",
    "comes to halt",
    "is brought to stop",
    "zero vector",
    "remains stationary",
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
pub(super) const ALONG: [&str; 28] = [
    "along",
    "par",
    "para",
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
    "same direction as",
    "in same direction as",
    "proportional to",
    "multiple of",
    "multiples of",
    "any multiples of",
    "all multiples of",
    "scalar multiple of",
    "any multiple of",
    "any scalar multiple of",
    "any vector parallel to",
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

/// The line of centres by a name of its own, without its article; [`super::centres`] knows what describes it.
pub(super) const CENTRES: [&str; 6] = ["loc", "centre line", "centres line", "line ab", "common normal", "normal"];

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

/// Words before the two spheres from one of which to the other something moves.
pub(super) const IN_THE_SENSE: [&str; 5] = ["in direction of", "in direction", "in sense of", "in sense", "sense"];

/// Words before the sphere from which something moves away.
pub(super) const AWAY_FROM: [&str; 1] = ["away from"];

/// What the direction in which a sphere moved before is called, without `original` or the like.
pub(super) const MOTION: [&str; 10] = [
    "direction",
    "direction of motion",
    "direction of travel",
    "direction of movement",
    "line",
    "line of motion",
    "path",
    "course",
    "velocity",
    "motion",
];

/// Words before [`MOTION`] that place it before the impact.
pub(super) const ORIGINAL: [&str; 6] = ["original", "initial", "previous", "incoming", "starting", "old"];

/// Words that tell of a line, whichever it is: `the way that it was going`.
pub(super) const COURSES: [&str; 12] = [
    "direction",
    "path",
    "course",
    "trajectory",
    "motion",
    "line",
    "axis",
    "travelling",
    "traveling",
    "moving",
    "going",
    "way",
];

/// What may follow the name of a line and adds nothing.
pub(super) const AFTER_A_LINE: [&str; 10] = [
    "produced",
    "extended",
    "of spheres",
    "of two spheres",
    "of A and B",
    "of a and b",
    "of balls",
    "of collision",
    "direction",
    "of impact",
];

/// Runs of words that say nothing about the value.
pub(super) const REMARKS: [&str; 43] = [
    "surd form",
    "in surd form",
    "as a surd",
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
    "same direction",
    "opposite direction",
    "from its path",
    "to each other",
    "to reverse",
    "to be reversed",
    "in total",
    "in magnitude",
    "in ratio",
    "or any multiple",
    "or any scalar multiple",
    "or multiples",
    "to 3sf",
    "i got",
    "i get",
    "i think",
    "i found",
    "i believe",
    "not possible",
    "not valid",
    "not allowed",
    "take positive",
    "taking positive",
    "positive only",
];

/// Words that take back what stands before them, where another value follows; and what else they may do.
pub(super) struct Thoughts {
    pub(super) words: &'static [&'static str],
    /// Can an answer begin with them, and take back what nobody sees?
    pub(super) begin: bool,
    /// May they be said of the value that follows as well, unless something parts them from it?
    pub(super) are_open: bool,
}

pub(super) const SECOND_THOUGHTS: [Thoughts; 3] = [
    Thoughts {
        words: &[
            "nope",
            "sorry",
            "oops",
            "wait",
            "hang on",
            "actually",
            "correction",
            "corrected",
            "edit",
            "i mean",
            "scrap that",
            "scratch that",
            "ignore that",
            "cross that out",
            "never mind",
        ],
        begin: true,
        are_open: false,
    },
    Thoughts { words: &["no"], begin: true, are_open: true },
    Thoughts {
        words: &["rather", "wrong", "incorrect", "crossed out", "scrapped", "deleted"],
        begin: false,
        are_open: true,
    },
];

/// Words between them and the value that follows; of `it's` the first two letters are read.
pub(super) const LEADS: [&str; 9] =
    ["it", "its", "it is", "it should be", "should be", "i meant", "make that", "that", "that is"];

/// Words before a value that gives way to the one before them.
pub(super) const IN_PLACE_OF: [&str; 4] = ["instead of", "rather than", "as opposed to", "in place of"];

/// At rest, where it is all that is said.
pub(super) const REST_ALONE: [&str; 4] = ["rest", "static", "motionless", "immobile"];

/// What says that e is 1, where it is all that is said.
pub(super) const ELASTIC: [&str; 9] = [
    "elastic",
    "perfectly elastic",
    "completely elastic",
    "totally elastic",
    "fully elastic",
    "elastic collision",
    "perfectly elastic collision",
    "collision is elastic",
    "collision is perfectly elastic",
];

/// Of what there can be none, and then it is nought: `no energy is lost`.
pub(super) const NOTHING_OF: [&str; 11] = [
    "energy",
    "ke",
    "kinetic",
    "loss",
    "component",
    "deflection",
    "impulse",
    "momentum",
    "change",
    "deviation",
    "rotation",
];

/// What stands for an equals sign.
pub(super) const IS: [&str; 5] = ["has to be", "have to be", "needs to be", "has value", "has the value"];

/// After the highest value of a range.
pub(super) const OR_LESS: [&str; 8] =
    ["or less", "and less", "or below", "and below", "or under", "or lower", "or smaller", "or fewer"];

/// After the lowest value of a range.
pub(super) const OR_MORE: [&str; 9] =
    ["or more", "or above", "and above", "or over", "and over", "or higher", "or greater", "or larger", "and upwards"];

/// Behind an end of a range that belongs to it, and behind one that does not.
pub(super) const INCLUDED: [&str; 2] = ["included", "inclusive"];
pub(super) const EXCLUDED: [&str; 4] = ["not included", "excluded", "exclusive", "not inclusive"];

/// Beside a range that goes on upwards, and beside one that goes on downwards.
pub(super) const NO_UPPER_END: [&str; 5] =
    ["no upper limit", "no upper bound", "no maximum", "has no upper limit", "unbounded above"];
pub(super) const NO_LOWER_END: [&str; 5] =
    ["no lower limit", "no lower bound", "no minimum", "has no lower limit", "unbounded below"];

/// Before an end that is no part of its range.
pub(super) const EXCLUDING: [&str; 4] = ["not including", "but not including", "excluding", "but excluding"];

/// The lists of which an entry can be a phrase by itself.
pub(super) const PHRASES: [&[&str]; 14] = [
    &REST, &ACROSS, &ALONG, &ANGLE, &CENTRES, &TANGENT, &A_TO_B, &B_TO_A, &TOWARDS, &AWAY_FROM, &ORIGINAL, &MOTION,
    &REMARKS, &IS,
];
