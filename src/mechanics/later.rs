//! Impacts that come later: a sphere that was struck strikes another, or a wall.
//!
//! No law is written twice for them. A quantity of a later impact is a quantity of an impact with the number of the
//! impact before it, `second.B.after.speed`, and is said of the sphere by its own name; a [`Meeting`] says which spheres
//! have the parts of A and B there. So a rule of a later impact is the rule of a law with other names for what it needs
//! and gives, and between two impacts stands the one rule that velocities are carried over.

use std::collections::HashMap;
use std::fmt;
use std::sync::OnceLock;

use foldhash::fast::FixedState;

use super::law::Known;
use super::place::OF_AN_IMPACT;
use super::{Axis, Moment, Quantity, Sphere};
use crate::number::Number;

/// How impacts after the first are called, in the order in which they come.
pub const LATER: [&str; 3] = ["second", "third", "fourth"];

/// An impact that comes later, and between whom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Meeting {
    /// How many impacts come before it.
    pub number: u8,
    /// Who has the part of A in the laws, and who that of B.
    pub of: [Sphere; 2],
    /// Is it a wall that has the part of B? Then the second name stands for it, and not for a sphere.
    pub with_wall: bool,
}

/// A quantity of a later impact.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Later {
    number: u8,
    /// The place of the quantity in the first impact: so the whole is as small as a quantity of that.
    place: u8,
}

/// The quantities of one impact, each at its place.
fn of_an_impact() -> &'static [Option<Quantity>; OF_AN_IMPACT] {
    static ALL: OnceLock<[Option<Quantity>; OF_AN_IMPACT]> = OnceLock::new();
    ALL.get_or_init(|| {
        let mut all = [None; OF_AN_IMPACT];
        for quantity in Quantity::of_an_impact() {
            all[quantity.place()] = Some(quantity);
        }
        all
    })
}

/// The quantities of one impact by their names.
fn names() -> &'static HashMap<String, Quantity, FixedState> {
    static NAMES: OnceLock<HashMap<String, Quantity, FixedState>> = OnceLock::new();
    let named = || Quantity::named(&Sphere::ALL).into_iter().map(|quantity| (quantity.to_string(), quantity));
    NAMES.get_or_init(|| named().collect())
}

impl Later {
    /// A quantity of one impact, said of a later one; `None` of what is no quantity of one impact.
    pub fn new(number: u8, quantity: Quantity) -> Option<Later> {
        let place = u8::try_from(quantity.place()).ok()?;
        of_an_impact()[usize::from(place)].map(|_| Later { number, place })
    }

    /// By its name, `second.B.after.speed`.
    pub fn named(name: &str) -> Option<Later> {
        let (ordinal, rest) = name.split_once('.')?;
        let number = LATER.iter().position(|word| *word == ordinal)? as u8 + 1;
        Later::new(number, *names().get(rest)?)
    }

    /// How many impacts come before.
    pub fn number(self) -> u8 {
        self.number
    }

    /// The quantity, of the spheres by their own names.
    pub fn quantity(self) -> Quantity {
        of_an_impact()[usize::from(self.place)].expect("a later quantity has the place of one")
    }

    /// Its place among all quantities.
    pub(super) fn place_among_all(self) -> usize {
        OF_AN_IMPACT * usize::from(self.number) + usize::from(self.place)
    }
}

impl fmt::Display for Later {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", ordinal(self.number), self.quantity())
    }
}

impl fmt::Debug for Later {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// `first`, `second`, …
pub fn ordinal(number: u8) -> &'static str {
    match usize::from(number) {
        0 => "first",
        number => LATER.get(number - 1).copied().unwrap_or("later"),
    }
}

/// Words that speak of the impact, or of what happens in it alone, with its number.
pub fn numbered(number: u8, words: &str) -> String {
    const IN_IT: [(&str, &str); 2] = [
        ("kinetic energy lost", "kinetic energy lost in the impact"),
        (" is its change of momentum", " in the impact is its change of momentum"),
    ];
    let its_own = IN_IT.iter().filter(|_| !words.contains("the impact"));
    let words = its_own.fold(words.to_owned(), |words, (alone, with_it)| words.replace(alone, with_it));
    words.replace("the impact", &format!("the {} impact", ordinal(number)))
}

/// The spheres on one line, in the order in which they lie there once these have met: who is new comes from beyond the others.
pub fn row(meetings: &[Meeting]) -> Vec<Sphere> {
    let mut row = Meeting::FIRST.of.to_vec();
    for meeting in meetings.iter().filter(|meeting| !meeting.with_wall) {
        let [one, other] = meeting.of;
        if !row.contains(&other) {
            row.push(other);
        } else if !row.contains(&one) {
            row.insert(0, one);
        }
    }
    row
}

impl Meeting {
    /// The first impact.
    pub const FIRST: Meeting = Meeting { number: 0, of: Sphere::BOTH, with_wall: false };

    /// The first impact where it is one of A with a wall: a B that comes later has taken no part in it.
    pub(super) const FIRST_WITH_WALL: Meeting = Meeting { with_wall: true, ..Meeting::FIRST };

    /// The last impact before this one in which the sphere took part.
    pub fn last_of(self, sphere: Sphere, meetings: &[Meeting]) -> Option<Meeting> {
        let first = meetings.iter().find(|meeting| meeting.number == 0).copied().unwrap_or(Meeting::FIRST);
        let earlier = meetings.iter().copied().filter(|meeting| meeting.number < self.number).chain([first]);
        earlier.filter(|meeting| meeting.part(sphere).is_some()).max_by_key(|meeting| meeting.number)
    }

    /// A quantity as the laws have it, of A and B, said of this impact and of who meets in it.
    pub fn quantity(self, quantity: Quantity) -> Quantity {
        if self.number == 0 {
            return quantity;
        }
        quantity.with_spheres(|part| self.sphere(part)).in_impact(self.number).unwrap_or(quantity)
    }

    /// Who has the part of A, or of B.
    pub fn sphere(self, part: Sphere) -> Sphere {
        self.of[usize::from(part != Sphere::A)]
    }

    /// Which part a sphere has here, if it is one of the two.
    pub fn part(self, sphere: Sphere) -> Option<Sphere> {
        match self.of {
            [first, _] if first == sphere => Some(Sphere::A),
            [_, second] if second == sphere && !self.with_wall => Some(Sphere::B),
            _ => None,
        }
    }

    /// What the laws call a quantity of this impact; `None` of any other.
    pub fn in_law(self, quantity: Quantity) -> Option<Quantity> {
        let Quantity::Later(later) = quantity else { return None };
        let own = later.quantity();
        let is_here = later.number == self.number && own.sphere().is_none_or(|sphere| self.of.contains(&sphere));
        let part = |sphere| if sphere == self.of[0] { Sphere::A } else { Sphere::B };
        is_here.then(|| own.with_spheres(part))
    }

    /// What is known of this impact, as the laws call it.
    pub fn known<N: Number>(self, known: &Known<N>) -> Known<N> {
        let here = known.0.iter().filter_map(|(quantity, datum)| Some((self.in_law(*quantity)?, datum.clone())));
        Known(here.collect())
    }

    /// A name of the laws, `B`, `m_B` or `vector.v_B`, with the name of who has the part here; `None` of other names.
    pub fn name(self, name: &str) -> Option<String> {
        let (stem, part) = match name.rsplit_once('_') {
            Some((stem, part)) => (format!("{stem}_"), part),
            None => (String::new(), name),
        };
        let part = Sphere::BOTH.into_iter().find(|sphere| sphere.name() == part)?;
        Some(format!("{stem}{}", self.sphere(part).name()))
    }

    /// A sentence about the spheres of the laws, with the names of who has their parts.
    pub fn in_words(self, words: &str) -> String {
        if self.of == Meeting::FIRST.of {
            return words.to_owned();
        }
        let mut said = String::with_capacity(words.len());
        let mut rest = words;
        while let Some(first) = rest.chars().next() {
            let length = if first.is_alphanumeric() {
                rest.find(|sign: char| !sign.is_alphanumeric()).unwrap_or(rest.len())
            } else {
                first.len_utf8()
            };
            let (word, after) = rest.split_at(length);
            // `A smooth wall pushes …`: at a wall a sentence begins with no sphere.
            let is_article = self.with_wall && (said.is_empty() || said.ends_with(". "));
            let part = Sphere::BOTH.into_iter().find(|part| part.name() == word && !is_article);
            said.push_str(part.map_or(word, |part| self.sphere(part).name()));
            rest = after;
        }
        said
    }

    /// What a student typed, with the names that the laws have for who takes part: `v_C` is `v_B` where C has the part
    /// of B. A letter is a sphere's name where it ends a name, as in `v_B`, `v_{B}` and `mB`.
    pub fn in_law_names(self, typed: &str) -> String {
        if self.of == Meeting::FIRST.of {
            return typed.to_owned();
        }
        let mut signs = typed.chars().peekable();
        let mut before = ' ';
        let mut said = String::with_capacity(typed.len());
        while let Some(sign) = signs.next() {
            let ends = !signs.peek().is_some_and(|next| next.is_alphanumeric());
            let begun = matches!(before, '_' | '{' | 'U' | 'V' | 'W') || before.is_lowercase();
            let sphere = Sphere::ALL.into_iter().find(|sphere| ends && begun && sphere.name().starts_with(sign));
            match sphere.and_then(|sphere| self.part(sphere)) {
                Some(part) => said.push_str(part.name()),
                None => said.push(sign),
            }
            before = sign;
        }
        said
    }

    /// Every later impact, of what is known or given.
    pub fn all<'q>(given: impl IntoIterator<Item = &'q Quantity>) -> Vec<Meeting> {
        let mut all = Meeting::said(given);
        all.retain(|meeting| meeting.number > 0);
        all
    }

    /// Every impact of which it is said between whom it is: the later ones, and the first if it is with a wall.
    pub(super) fn said<'q>(given: impl IntoIterator<Item = &'q Quantity>) -> Vec<Meeting> {
        let meeting = |quantity: &Quantity| match quantity {
            Quantity::Meeting(meeting) => Some(*meeting),
            _ => None,
        };
        given.into_iter().filter_map(meeting).collect()
    }
}

impl Quantity {
    /// What it is, whichever impact it is of.
    pub fn of_its_impact(self) -> Quantity {
        match self {
            Quantity::Later(later) => later.quantity(),
            quantity => quantity,
        }
    }

    /// How many impacts come before the one that it is of.
    pub fn impact(self) -> u8 {
        match self {
            Quantity::Later(later) => later.number,
            _ => 0,
        }
    }

    /// The same of the impact before which so many come; `None` of what is no quantity of one impact.
    pub fn in_impact(self, number: u8) -> Option<Quantity> {
        if number == 0 { Some(self) } else { Later::new(number, self).map(Quantity::Later) }
    }

    /// Another quantity of the same impact.
    fn beside(self, other: impl FnOnce(Quantity) -> Option<Quantity>) -> Option<Quantity> {
        other(self.of_its_impact())?.in_impact(self.impact())
    }

    /// Of an angle to the line of centres, or of a speed: the component along that line.
    pub fn along_the_line(self) -> Option<Quantity> {
        self.beside(|own| match own {
            Quantity::AngleToLine(sphere, moment) | Quantity::Speed(sphere, moment) => {
                Some(Quantity::Velocity(sphere, moment, Axis::N))
            }
            _ => None,
        })
    }

    /// Of a component of a velocity: the same velocity along another axis.
    pub fn along(self, axis: Axis) -> Quantity {
        let along = |own| match own {
            Quantity::Velocity(sphere, moment, _) => Some(Quantity::Velocity(sphere, moment, axis)),
            _ => None,
        };
        self.beside(along).unwrap_or(self)
    }

    /// Of the component of a velocity after an impact: the same before it.
    pub(crate) fn before_its_impact(self) -> Option<Quantity> {
        matches!(self.of_its_impact(), Quantity::Velocity(_, Moment::After, _)).then(|| self.before())
    }

    /// Of a velocity after an impact: the same before it.
    pub(super) fn before(self) -> Quantity {
        let before = |own| match own {
            Quantity::Velocity(sphere, _, axis) => Some(Quantity::Velocity(sphere, Moment::Before, axis)),
            _ => None,
        };
        self.beside(before).unwrap_or(self)
    }
}

impl fmt::Display for Meeting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let second = if self.with_wall { "a wall" } else { self.of[1].name() };
        write!(f, "{} impact of {} and {second}", ordinal(self.number), self.of[0].name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_happens_in_one_of_several_impacts_is_said_with_its_number() {
        for (words, said) in [
            ("the speed of A after the impact", "the speed of A after the second impact"),
            ("The kinetic energy lost, in joules, is", "The kinetic energy lost in the second impact, in joules, is"),
            ("the kinetic energy lost in the impact", "the kinetic energy lost in the second impact"),
            (
                "The impulse on B is its change of momentum:",
                "The impulse on B in the second impact is its change of momentum:",
            ),
            ("Momentum is conserved:", "Momentum is conserved:"),
        ] {
            assert_eq!(numbered(1, words), said);
        }
    }

    #[test]
    fn a_quantity_of_a_later_impact_is_found_by_its_name() {
        for name in ["second.B.after.speed", "third.e", "second.C.before.n", "fourth.ke.lost"] {
            let quantity: Quantity = name.parse().unwrap();
            assert_eq!(quantity.to_string(), name);
        }
        for name in [
            "first.e",
            "second",
            "second.second.e",
            "fifth.e",
            "second.D.mass",
            "C.mass",
            "second.equation of momentum",
        ] {
            assert!(name.parse::<Quantity>().is_err(), "{name}");
        }
    }

    #[test]
    fn who_meets_has_the_parts_of_the_laws() {
        let meeting = Meeting { number: 1, of: [Sphere::B, Sphere::C], with_wall: false };
        for quantity in Quantity::all() {
            let later = meeting.quantity(quantity);
            assert_eq!(later.to_string().parse(), Ok(later));
            assert_eq!(meeting.in_law(later), Some(quantity));
            assert_eq!(later.unit(), quantity.unit());
            assert_eq!(Meeting { number: 2, ..meeting }.in_law(later), None);
        }
        assert_eq!(meeting.quantity(Quantity::Mass(Sphere::B)).to_string(), "second.C.mass");
    }

    #[test]
    fn what_is_typed_of_spheres_is_said_of_the_parts_that_they_have() {
        let meeting = Meeting { number: 1, of: [Sphere::B, Sphere::C], with_wall: false };
        for (typed, said) in [
            ("2v_B + 3v_C = 6", "2v_A + 3v_B = 6"),
            (r"m_{C} = 3, mB = 2", r"m_{B} = 3, mA = 2"),
            ("A: CoM gives xB", "A: CoM gives xA"),
            ("Before", "Before"),
        ] {
            assert_eq!(meeting.in_law_names(typed), said);
        }
    }

    #[test]
    fn what_is_said_of_the_spheres_of_a_law_is_said_of_who_has_their_parts() {
        let spheres = Meeting { number: 1, of: [Sphere::B, Sphere::C], with_wall: false };
        let wall = Meeting { number: 2, of: [Sphere::C, Sphere::A], with_wall: true };
        for (meeting, words, said) in [
            (spheres, "B is in front: it must move away from A.", "C is in front: it must move away from B."),
            (spheres, "A and *B* After", "B and *C* After"),
            (wall, "A smooth wall pushes. Find the velocity of A.", "A smooth wall pushes. Find the velocity of C."),
            (Meeting::FIRST, "A strikes B", "A strikes B"),
        ] {
            assert_eq!(meeting.in_words(words), said);
        }
    }

    #[test]
    fn a_sphere_comes_from_the_last_impact_that_it_had_a_part_in() {
        let wall = Meeting { number: 1, of: [Sphere::B, Sphere::A], with_wall: true };
        let again = Meeting { number: 2, of: [Sphere::A, Sphere::B], with_wall: false };
        let all = [wall, again];
        assert_eq!(again.last_of(Sphere::A, &all), Some(Meeting::FIRST));
        assert_eq!(again.last_of(Sphere::B, &all), Some(wall));
        assert_eq!(again.last_of(Sphere::C, &all), None);
    }
}
