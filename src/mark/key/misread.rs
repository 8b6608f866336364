//! A question as it is for who has copied one of its numbers wrongly.

use super::{KeyedBlank, KeyedPart, KeyedQuestion, motion};
use crate::answer::Kind;
use crate::bank::Find;
use crate::expr::{Expr, Turn, written, written_angle};
use crate::mark::judging::Model;
use crate::mark::working::{Elsewhere, Misread};
use crate::mechanics::{Datum, Derivation, Known, Quantity, Scene, Sphere, Velocity, pose};
use crate::number::{Angle, Value};

/// One thing that is given by a number.
#[derive(Clone, Copy)]
enum Thing {
    /// A mass, in every impact of the sphere.
    Mass(Sphere),
    /// A component of a velocity before, or its speed.
    Velocity(usize, usize),
    /// The direction of a velocity before.
    Angle(usize),
    /// The coefficient of restitution of an impact: the first, or one of those that come later.
    Restitution(usize),
}

impl KeyedQuestion {
    /// The question with everything that follows from the number as it was copied: once for each thing that it may be given
    /// for. Where letters are to be found from conditions nothing is worked out again, nor for one number of the question in
    /// the place of another.
    pub(in crate::mark) fn with_misread(&self, misread: &Misread) -> Vec<KeyedQuestion> {
        if !self.scene.unknowns.is_empty() || misread.is_of_another(self.prepared()) {
            return Vec::new();
        }
        let masses = Sphere::ALL.map(Thing::Mass).into_iter();
        let velocities = [0, 1].into_iter().flat_map(|of| [0, 1].map(|axis| Thing::Velocity(of, axis)));
        let restitution = (0..=self.scene.then.len()).map(Thing::Restitution);
        let all = masses.chain(velocities).chain([0, 1].map(Thing::Angle)).chain(restitution);
        all.filter_map(|thing| self.with_thing_misread(thing, misread)).collect()
    }

    fn with_thing_misread(&self, thing: Thing, misread: &Misread) -> Option<KeyedQuestion> {
        let mut scene = self.scene.clone();
        let is_changed = self.misread_in(&mut scene, thing, misread)?;
        let given = pose(&scene).ok().filter(|given| is_changed && *given != self.given)?;
        let mut known = given.clone();
        let parts = self.parts_unstated().iter().map(|part| part.of_what_is_given(&scene, &mut known)).collect();
        let elsewhere = Elsewhere::of(&scene);
        Some(KeyedQuestion { elsewhere, ..self.of_scene(scene, given, parts) })
    }

    /// Puts the number as it was copied into a thing that is given; `None` if what comes of it is none.
    fn misread_in(&self, scene: &mut Scene, thing: Thing, misread: &Misread) -> Option<bool> {
        let givens = match thing {
            Thing::Mass(sphere) => {
                let first = Sphere::BOTH.into_iter().zip(&mut scene.masses);
                let later =
                    scene.then.iter_mut().flat_map(|then| then.meeting.of.into_iter().zip(&mut then.scene.masses));
                let of_sphere = first.chain(later).filter(|(of, _)| *of == sphere);
                of_sphere.filter_map(|(_, mass)| mass.as_mut()).collect()
            }
            Thing::Restitution(0) => scene.restitution.iter_mut().collect(),
            Thing::Restitution(later) => scene.then[later - 1].scene.restitution.iter_mut().collect(),
            Thing::Velocity(of, axis) => match (&mut scene.before[of], axis) {
                (Some(Velocity::Components(x, _)), 0) => vec![x],
                (Some(Velocity::Components(_, y)), _) => vec![y],
                (Some(Velocity::Polar { speed, .. }), 0) => vec![speed],
                _ => Vec::new(),
            },
            Thing::Angle(of) => {
                let Some(Velocity::Polar { cos, sin, angle: Some((turn, shown)), .. }) = &mut scene.before[of] else {
                    return Some(false);
                };
                let read = misread.read(shown);
                let is_changed = read != *shown;
                let degrees = self.exact(&read)?;
                *turn = Turn::degrees(degrees.as_fraction()?.clone());
                let direction = turn.direction()?;
                (*cos, *sin, *shown) = (direction.cos, direction.sin, read);
                return Some(is_changed);
            }
        };
        let mut is_changed = false;
        for given in givens {
            let read = misread.read(&given.shown);
            is_changed |= read != given.shown;
            given.value = self.exact(&read)?;
            given.shown = read;
        }
        Some(is_changed)
    }
}

impl KeyedPart {
    /// The same part of another scene: what is right there, as far as that is a value.
    fn of_what_is_given(&self, scene: &Scene, known: &mut Known<Value>) -> KeyedPart {
        let asked = self.blanks.iter().flat_map(|blank| blank.find.quantities());
        let marked = self.scheme.iter().flat_map(|mark| mark.earned_for.quantities().iter().copied());
        let asked: Vec<Quantity> = asked.chain(marked).collect();
        let (derivation, _) = Derivation::carry_out(known, &asked);
        let blanks = self.blanks.iter().map(|blank| blank.of_what_is_given(scene, known)).collect();
        KeyedPart { blanks, derivation, known: known.clone(), ..self.clone() }
    }
}

impl KeyedBlank {
    fn of_what_is_given(&self, scene: &Scene, known: &Known<Value>) -> KeyedBlank {
        let right = self.right_from(known).filter(|_| self.model.kind != Kind::Shown);
        let Some(right) = right else { return self.clone() };
        let own = &self.model;
        let mut model = Model {
            quantity: own.quantity,
            letter: own.letter.clone(),
            angle: own.angle.clone(),
            other_angles: own.other_angles.clone(),
            is_of_both: own.is_of_both,
            ..own.of_value(right)
        };
        motion::tell(&mut model, &self.name, &self.find, scene, known);
        KeyedBlank { model, ..self.clone() }
    }

    /// What is right where this is known, as the model answer has it.
    fn right_from(&self, known: &Known<Value>) -> Option<Expr> {
        let value = |quantity: &Quantity| match known.0.get(quantity)? {
            Datum::Number(value) => Some(written(value)),
            Datum::Direction { y, x } => Some(written_angle(&Angle::of(y, x)?)),
            Datum::Equation(_) => None,
        };
        match &self.find {
            Find::Quantity(quantity) => value(quantity),
            Find::Vector(x, y) => Some(Expr::Vector(Box::new(value(x)?), Box::new(value(y)?))),
            Find::Unknown(_) => None,
        }
    }
}
