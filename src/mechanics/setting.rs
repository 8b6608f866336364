//! What an impact is between, and how it is spoken of.
//!
//! The laws are those of two smooth spheres that strike obliquely, and so are their words. In another setting a law is
//! the same and its words are not: what is the line of centres of two spheres is the perpendicular to a wall. So
//! words are written once, for two spheres, and a setting says how it calls the same things.

use std::borrow::Cow;

use crate::number::Letter;

/// What an impact is between.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Setting {
    /// Two smooth spheres, at any angle to their line of centres.
    #[default]
    Oblique,
    /// Two spheres that move along one line: nothing is across it.
    Direct,
    /// A sphere and a fixed smooth wall, which stands in the place of B and does not move.
    Wall,
    /// One particle that receives an impulse, which is given or to be found.
    Impulse,
}

/// Words for two spheres, and the same for a wall. Longer ones come first, as they hold shorter ones.
const AT_A_WALL: &[(&str, &str)] = &[
    (
        "Smooth spheres push each other along the line of centres alone",
        "A smooth wall pushes perpendicular to itself alone",
    ),
    ("The spheres are smooth, so", "The wall is smooth, so"),
    ("along the line of centres and perpendicular to it", "perpendicular to the wall and parallel to it"),
    ("separation over approach along the line of centres", "speed after over speed before, perpendicular to the wall"),
    (
        "sine and cosine are exchanged: along the line of centres the component is u cos",
        "sine and cosine are exchanged: look where the angle is measured from",
    ),
    (
        "The angle is with the line of centres, so cosine gives the component along it and sine the one across, which does not change.",
        "Look where the angle is measured from: with the wall, cosine gives the component parallel to it, which does not change, and sine the one perpendicular to it.",
    ),
    (
        "e multiplies the speed of approach: the spheres part more slowly than they met.",
        "e multiplies the speed towards the wall: the sphere leaves more slowly than it came.",
    ),
    (
        "B is in front: it must move away from A, so the separation is the velocity of B less that of A.",
        "After the impact the sphere moves away from the wall.",
    ),
    (
        "The spheres do not stick together: the law of restitution says how fast they part.",
        "The sphere does not stay at the wall: the law of restitution says how fast it leaves.",
    ),
    (
        "That is the angle with the common tangent; the angle with the line of centres is 90° minus that.",
        "That is the angle with the perpendicular to the wall; the angle with the wall is 90° minus that.",
    ),
    (
        "the velocities of A and B have equal components along the line of centres: the spheres do not approach, so there is no impact",
        "the sphere moves parallel to the wall: it does not strike it, so there is no impact",
    ),
    (
        "the spheres have equal velocities along the line of centres: they do not approach, so there is no impact",
        "the sphere moves parallel to the wall: it does not strike it, so there is no impact",
    ),
    (
        "A and B have the same velocity before, so neither approaches the other: there is no impact",
        "the sphere is at rest before, so it does not strike the wall: there is no impact",
    ),
    ("A would still be moving into B", "A would still be moving into the wall"),
    ("the separation along the line of centres is", "the velocity of A away from the wall is"),
    ("but e times the approach is", "but e times its velocity towards the wall is"),
    ("the spheres would pass through each other", "the sphere would pass through the wall"),
    ("but smooth spheres exert no force that way", "but a smooth wall exerts no force that way"),
    (
        "The spheres approach each other before the impact, so the speed of approach is positive:",
        "The sphere moves towards the wall before the impact, so its speed towards the wall is positive:",
    ),
    (
        "The spheres do not pass through each other, so the speed of separation is not negative:",
        "The sphere does not pass through the wall, so its speed away from the wall is not negative:",
    ),
    ("Along the line of centres the spheres approach at", "The sphere moves towards the wall at"),
    ("Along the line of centres they separate at", "The sphere leaves the wall at"),
    ("the speed of approach along the line of centres", "the speed towards the wall"),
    ("the speed of separation along the line of centres", "the speed away from the wall"),
    ("a direction is measured from the line of centres", "a direction is measured from the wall"),
    (
        "the angle between them is not the sum of their angles with the line of centres",
        "the angle between them is the sum of their angles with the wall, and not with the perpendicular to it",
    ),
    (
        "tangent of the angle of *A* to the line of centres",
        "tangent of the angle of *A* to the perpendicular to the wall",
    ),
    ("to the common tangent", "to the wall"),
    ("to the line of centres", "to the perpendicular to the wall"),
    ("with the line of centres", "with the perpendicular to the wall"),
    ("perpendicular to the line of centres", "parallel to the wall"),
    ("Perpendicular to the line of centres", "Parallel to the wall"),
    ("across the line of centres", "parallel to the wall"),
    ("Across the line of centres", "Parallel to the wall"),
    ("along the line of centres", "perpendicular to the wall"),
    ("Along the line of centres", "Perpendicular to the wall"),
    ("the part along the line of centres", "the part perpendicular to the wall"),
    ("the line of centres", "the perpendicular to the wall"),
    ("from *A* towards *B*", "towards the wall"),
    ("from *B* towards *A*", "away from the wall"),
    ("the impact the spheres", "the impact the sphere"),
    ("difference of kinetic energies, both spheres", "difference of kinetic energies"),
    ("difference of the kinetic energies, both spheres", "difference of the kinetic energies"),
    ("the change of momentum of one sphere", "the change of momentum"),
    ("a difference of momenta of one sphere", "a difference of momenta"),
    ("The component across the line of centres", "The component parallel to the wall"),
    ("the component across the line of centres", "the component parallel to the wall"),
    ("components across the line of centres", "components parallel to the wall"),
    ("The component across", "The component parallel to the wall"),
    ("the component across", "the component parallel to the wall"),
    ("components across", "components parallel to the wall"),
];

/// The same for a direct impact.
const IN_A_LINE: &[(&str, &str)] = &[
    ("; condone sign errors and sine for cosine;", "; condone sign errors;"),
    ("condone sign errors and sine for cosine", "condone sign errors"),
    ("the components of the velocities of", "the velocities of"),
    (" after the impact along the line of centres, positive", " after the impact, positive"),
    ("momentum along the line of centres", "momentum"),
    ("Momentum along the line of centres", "Momentum"),
    ("Momentum and restitution along the line of centres", "Momentum and restitution"),
    ("component of the velocity of *A* along the line of centres", "velocity of *A*"),
    ("component of the velocity of *B* along the line of centres", "velocity of *B*"),
    ("is its change of momentum along the line of centres", "is its change of momentum"),
    ("turns back along the line of centres", "turns back"),
    ("turn back along the line of centres", "turn back"),
    ("moves along the line of centres", "moves along the same line"),
    ("has no velocity left along the line of centres", "is brought to rest"),
    ("Along the line of centres the spheres approach at", "The spheres approach at"),
    ("Along the line of centres they separate at", "They separate at"),
    (
        "check the direction of the line of centres, or leave out `sense`",
        "check the signs: a velocity is positive from A towards B",
    ),
    (", along the line of centres", ""),
    (" along the line of centres", ""),
    ("the components along", "the velocities along"),
    ("for the two components", "for the two velocities"),
    ("give the components before", "give the velocities before"),
    ("solves the two equations for a component", "solves the two equations for a velocity"),
    ("a correct component", "a correct velocity"),
    ("squares of components may leave out the unchanged ones on both sides", "condone a slip in one term"),
];

/// The same for an impulse on one particle.
const ON_A_PARTICLE: &[(&str, &str)] = &[
    (
        "Impulse is the change of velocity along the line of centres, times the mass, and not the change of speed.",
        "Impulse is the change of velocity, as a vector, times the mass, and not the change of speed.",
    ),
    (
        "angle between them is not the sum of their angles with the line of centres",
        "angle between them is not the sum of their angles with one line",
    ),
    (
        "That is the angle with the common tangent; the angle with the line of centres is 90° minus that.",
        "That is the angle with the other unit vector; the angle that is asked for is 90° minus that.",
    ),
    ("The sphere turns back along the line of centres", "The particle turns back"),
    ("impulse as the change of momentum of one sphere", "impulse as the change of momentum"),
    ("a difference of momenta of one sphere, in either order", "a difference of momenta, in either order"),
    ("difference of kinetic energies, both spheres", "difference of kinetic energies"),
    ("no impulse acted, so there was no impact", "no impulse acted"),
    ("the impact", "the impulse"),
];

impl Setting {
    /// What is modelled, in words.
    pub fn model(self) -> &'static str {
        match self {
            Setting::Oblique => "two smooth spheres, oblique impact",
            Setting::Direct => "two spheres, direct impact",
            Setting::Wall => "a smooth sphere and a fixed smooth wall",
            Setting::Impulse => "a particle and an impulse",
        }
    }

    /// Is one sphere the whole of what moves?
    pub fn is_of_one(self) -> bool {
        matches!(self, Setting::Wall | Setting::Impulse)
    }

    /// Has the working the component after the impact away from what stands in the place of B, and not towards it?
    pub fn works_away_from_b(self) -> bool {
        self == Setting::Wall
    }

    /// Words that are written for two spheres, as this setting says them.
    pub fn say(self, words: &str) -> Cow<'_, str> {
        let phrases = match self {
            Setting::Oblique => return Cow::Borrowed(words),
            Setting::Direct => IN_A_LINE,
            Setting::Wall => AT_A_WALL,
            Setting::Impulse => ON_A_PARTICLE,
        };
        let mut said = String::with_capacity(words.len());
        let mut rest = words;
        // Most letters begin no phrase.
        let initials = phrases.iter().fold(0_u128, |initials, (spheres, _)| initials | initial(spheres));
        // Phrase by phrase, so that what is said already is not said again.
        while let Some(next) = rest.char_indices().find(|(at, _)| initials & initial(&rest[*at..]) != 0) {
            let (before, here) = rest.split_at(next.0);
            said.push_str(before);
            let phrase = phrases.iter().find(|(spheres, _)| here.starts_with(spheres));
            let (taken, ours) = phrase.map_or((1, &here[..1]), |(spheres, ours)| (spheres.len(), *ours));
            said.push_str(ours);
            rest = &here[taken..];
        }
        said.push_str(rest);
        Cow::Owned(said)
    }
}

/// Words about *e*, with the letter that the coefficient of restitution has in their question, if it is another.
pub fn with_letter_of_restitution(words: &str, letter: Option<Letter>) -> Cow<'_, str> {
    let Some(letter) = letter.filter(|letter| letter.name() != "e") else { return Cow::Borrowed(words) };
    let pieces = words.split_inclusive(|sign: char| !sign.is_alphanumeric());
    let said = pieces.map(|piece| match piece.strip_prefix('e') {
        Some(rest) if !rest.starts_with(char::is_alphanumeric) => format!("{}{rest}", letter.name()),
        _ => piece.to_owned(),
    });
    Cow::Owned(said.collect())
}

/// The bit of the first letter, if it is one of ASCII, as that of every phrase is.
fn initial(words: &str) -> u128 {
    words.bytes().next().filter(u8::is_ascii).map_or(0, |first| 1 << first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_setting_has_its_words() {
        let words = "By conservation of momentum along the line of centres:";
        assert_eq!(Setting::Oblique.say(words), words);
        assert_eq!(Setting::Direct.say(words), "By conservation of momentum:");
        assert_eq!(
            Setting::Wall.say("the component perpendicular to the line of centres does not change"),
            "the component parallel to the wall does not change"
        );
    }

    #[test]
    fn what_is_said_of_two_spheres_is_said_of_one_in_its_own_words() {
        let sentence =
            |tag: &str| crate::mechanics::Slip::all().iter().find(|(_, slip)| slip.tag == tag).unwrap().1.sentence;
        let table = [
            (Setting::Wall, "energy-after-along-only", "The components parallel to the wall count after the impact"),
            (Setting::Wall, "rebound-missed", "The sphere turns back perpendicular to the wall:"),
            (
                Setting::Wall,
                "deflection-added",
                "Draw both velocities from one point: the angle between them is the sum of their angles with the wall",
            ),
            (Setting::Impulse, "rebound-missed", "The particle turns back:"),
            (Setting::Impulse, "angle-complement", "That is the angle with the other unit vector;"),
        ];
        for (setting, tag, begins) in table {
            let said = setting.say(sentence(tag));
            assert!(said.starts_with(begins) && !said.contains("centres"), "{tag}: {said}");
        }
    }

    #[test]
    fn restitution_has_the_letter_of_its_question() {
        let f = Letter::new("f", crate::number::Range::Unit).unwrap();
        let table = [
            ("*e* on the correct side; condone sign errors", "*f* on the correct side; condone sign errors"),
            (
                "e is separation over approach: the special value of e.",
                "f is separation over approach: the special value of f.",
            ),
        ];
        for (words, said) in table {
            assert_eq!(with_letter_of_restitution(words, Some(f)), said);
            assert_eq!(with_letter_of_restitution(words, None), words);
        }
    }

    #[test]
    fn at_a_wall_what_is_unchanged_is_parallel_to_the_wall() {
        for tag in ["e-on-perpendicular", "perpendicular-dropped", "wrong-axis"] {
            let slip = crate::mechanics::Slip::all().iter().find(|(_, slip)| slip.tag == tag).unwrap().1;
            let said = Setting::Wall.say(slip.sentence);
            assert!(said.contains("parallel to the wall") && said.contains("unchanged"), "{said}");
            assert!(!said.contains("centres") && !said.contains("across"), "{said}");
        }
    }
}
