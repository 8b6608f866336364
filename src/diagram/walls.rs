//! The walls of a scene in which a sphere strikes several in turn.

use super::corner::{Between, Other};
use super::given::line_of_centres;
use super::{Manner, formula};
use crate::mechanics::{Axis, Derivation, Known, Quantity, Scene, Setting, Sphere, Then, ordinal};
use crate::number::{Angle, Value};

/// Who strikes a wall in each impact, and what is known there of the wall; nothing where it is no wall.
pub struct Walls(Vec<Option<(Sphere, Known<Value>)>>);

impl Walls {
    /// The walls of a scene of which this is known.
    pub fn of(scene: &Scene, known: &Known<Value>) -> Walls {
        let first = (scene.setting == Setting::Wall).then(|| (Sphere::A, known.clone()));
        let mut ahead = known.clone();
        let later = scene.then.iter().map(|Then { meeting, scene }| {
            let lines = [Axis::X, Axis::Y].map(|axis| meeting.quantity(Quantity::Line(axis)));
            (scene.setting == Setting::Wall).then(|| {
                Derivation::carry_out(&mut ahead, &lines);
                (meeting.of[0], meeting.known(&ahead))
            })
        });
        Walls([first].into_iter().chain(later).collect())
    }

    /// What is known of an impact with a wall.
    pub fn known(&self, impact: usize) -> Option<&Known<Value>> {
        self.0.get(impact)?.as_ref().map(|(_, known)| known)
    }

    /// The wall that the sphere comes from to the wall of an impact, or else the one that it goes to.
    pub fn other(&self, impact: usize, manner: Manner) -> Option<Other> {
        let (sphere, here) = self.0.get(impact)?.as_ref()?;
        let by_the_same = |other: &usize| matches!(self.0.get(*other), Some(Some((by, _))) if by == sphere);
        let other = impact.checked_sub(1).filter(by_the_same).or(Some(impact + 1).filter(by_the_same))?;
        let there = self.known(other)?;
        let name = |impact: usize| {
            let earlier = self.0[..impact].iter().flatten().count();
            format!("{} wall", ordinal(u8::try_from(earlier).unwrap_or(u8::MAX)))
        };
        let names = [name(impact), name(other)];
        Some(Other { inward: line_of_centres(there)?, names, named: true, between: between([here, there], manner)? })
    }
}

/// The angle in which two walls meet; nothing if they are one wall.
fn between(walls: [&Known<Value>; 2], manner: Manner) -> Option<Between> {
    let [x, y] = [Axis::X, Axis::Y].map(|axis| walls.map(|known| known.number(Quantity::Line(axis))));
    let ([x, p], [y, q]) = ([x[0].clone()?, x[1].clone()?], [y[0].clone()?, y[1].clone()?]);
    let (cross, dot) = (&(&x * &q) - &(&y * &p), &(&x * &p) + &(&y * &q));
    if dot.is_zero() {
        return Some(Between::Right);
    }
    if cross.is_zero() {
        return dot.sign().is_some_and(|sign| sign.is_lt()).then_some(Between::Unsaid);
    }
    // Where walls have vectors, nothing is said of their angle.
    let angle = (!manner.vectors).then(|| Angle::between(&cross, &-&dot)).flatten();
    Some(angle.map_or(Between::Unsaid, |angle| Between::Angle(formula(manner.angle(&angle)))))
}
