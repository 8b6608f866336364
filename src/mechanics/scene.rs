//! A scene that has been read: every expression evaluated, every letter with its range.

use std::sync::Arc;

use super::later::Meeting;
use super::scene_text::Sense;
use super::setting::Setting;
use super::{Moment, Quantity, Sphere};
use crate::expr::{Expr, Relation, Turn};
use crate::number::{Letter, Value};

/// A value with the form in which it was given, for working that shows what a student would write.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// The exact value.
    pub value: Value,
    /// The form: `4`, `2*m`, `v*cos(theta)`.
    pub shown: Expr,
}

impl Given {
    /// Nought.
    pub fn nought() -> Given {
        Given { value: Value::ZERO, shown: Expr::integer(0) }
    }
}

/// A velocity as it was given.
#[derive(Clone, Debug, PartialEq)]
pub enum Velocity {
    /// By components along i and j.
    Components(Given, Given),
    /// By a speed and a direction, anticlockwise from i.
    Polar {
        /// The speed.
        speed: Given,
        /// The cosine of the direction.
        cos: Value,
        /// The sine of the direction.
        sin: Value,
        /// The angle, unless cosine and sine were given.
        angle: Option<(Turn, Expr)>,
    },
}

/// What is given of the line of centres.
#[derive(Clone, Debug, PartialEq)]
pub enum Contact {
    /// A vector along it, and whether it points from A to B.
    Along(Value, Value, Option<Sense>),
    /// How far B's centre lies to the left of A's path relative to B, the radii, and their sum.
    Offset {
        /// The offset of the path.
        offset: Given,
        /// The radii of A and B.
        radii: Box<[Given; 2]>,
        /// The distance of the centres at the impact.
        sum: Given,
    },
    /// B's centre less A's, and the sum of the radii.
    Apart(Value, Value, Value),
}

/// A condition that the scene must satisfy: an equation between quantities, or an inequality.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// The left side.
    pub left: Expr,
    /// `=`, `<`, `<=`, `>` or `>=`.
    pub relation: Relation,
    /// The right side.
    pub right: Expr,
}

/// One impact, as far as it is given: of two smooth spheres, of a sphere A with a wall, or an impulse on A alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What the impact is between.
    pub setting: Setting,
    /// Masses of A and B.
    pub masses: [Option<Given>; 2],
    /// Velocities before, of A and B.
    pub before: [Option<Velocity>; 2],
    /// Velocities after, of A and B.
    pub after: [Option<Velocity>; 2],
    /// The line of centres.
    pub contact: Option<Contact>,
    /// The impulse that A receives, where it is given.
    pub impulse: Option<[Given; 2]>,
    /// The coefficient of restitution.
    pub restitution: Option<Given>,
    /// The letters, by name.
    pub letters: Vec<Letter>,
    /// The letters to be found.
    pub unknowns: Vec<Letter>,
    /// What determines them.
    pub conditions: Vec<Condition>,
    /// Or what they make largest.
    pub maximise: Option<Quantity>,
    /// The impacts that come later, in their order.
    pub then: Vec<Then>,
}

/// An impact that comes after another.
#[derive(Clone, Debug, PartialEq)]
pub struct Then {
    /// Who meets.
    pub meeting: Meeting,
    /// The impact by itself, with A and B for who has their parts; velocities that are carried over are not in it.
    pub scene: Scene,
}

/// A scene that is solved is shared with its solution; one that is lent is copied for that.
impl From<&Scene> for Arc<Scene> {
    fn from(scene: &Scene) -> Arc<Scene> {
        Arc::new(scene.clone())
    }
}

impl Scene {
    /// The scene of an impact: this one, or a later one.
    pub fn of_impact(&self, number: u8) -> Option<&Scene> {
        if number == 0 {
            return Some(self);
        }
        self.then.iter().find(|then| then.meeting.number == number).map(|then| &then.scene)
    }

    /// Every quantity that it has and that has a name, impact by impact.
    pub fn quantities(&self) -> Vec<Quantity> {
        let all = Quantity::all();
        let later = self.then.iter().flat_map(|then| all.iter().map(|quantity| then.meeting.quantity(*quantity)));
        let mut here: Vec<Quantity> = all.iter().copied().chain(later).collect();
        here.retain(|quantity| self.has(*quantity));
        here
    }

    /// Does it have the quantity? A wall is no sphere, and who does not take part in an impact has no velocity after it.
    pub fn has(&self, quantity: Quantity) -> bool {
        let Quantity::Later(later) = quantity else { return quantity.is_in(self.setting) };
        let then = self.then.iter().find(|then| then.meeting.number == later.number());
        then.is_some_and(|then| then.meeting.in_law(quantity).is_some_and(|in_law| in_law.is_in(then.scene.setting)))
    }

    /// The letter that the coefficient of restitution has, where it is a letter.
    pub fn letter_of_restitution(&self) -> Option<Letter> {
        let Given { value, shown } = self.restitution.as_ref()?;
        let Expr::Name(name) = shown else { return None };
        value.letters().into_iter().find(|letter| letter.name() == name.text)
    }

    /// The mass of a sphere.
    pub fn mass(&self, sphere: Sphere) -> Option<&Given> {
        self.masses[sphere as usize].as_ref()
    }

    /// A velocity.
    pub fn velocity(&self, sphere: Sphere, moment: Moment) -> Option<&Velocity> {
        match moment {
            Moment::Before => self.before[sphere as usize].as_ref(),
            Moment::After => self.after[sphere as usize].as_ref(),
        }
    }
}
