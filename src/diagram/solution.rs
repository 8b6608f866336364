//! The pictures of a worked solution: before and after, with what the working calls each component.

use super::drawing::Point;
use super::given::{line_of_centres, mass};
use super::illustration::{direction, measure};
use super::spheres::{Body, Motion, Spheres};
use super::words::in_words;
use super::{Diagram, Manner, contact, formula};
use crate::expr::Expr;
use crate::mechanics::{Axis, Contact, Derivation, Known, Moment, Quantity, Scene, Show, Sphere, pose};
use crate::number::Value;
use crate::unit::Unit;

/// The pictures of a solution. Where the line of centres is given: the components along it and across it, the unknown ones
/// as letters in the positive direction. Where it is found: the velocities as vectors.
pub fn solution(scene: &Scene, manner: Manner) -> Vec<Diagram> {
    let Ok(mut known) = pose(scene) else { return Vec::new() };
    let mut needed = vec![Quantity::Line(Axis::X), Quantity::Line(Axis::Y)];
    needed.extend(
        Sphere::BOTH
            .into_iter()
            .flat_map(|sphere| [Axis::N, Axis::T].map(|axis| Quantity::Velocity(sphere, Moment::Before, axis))),
    );
    if scene.contact.is_none() {
        needed.extend(
            Sphere::BOTH
                .into_iter()
                .flat_map(|sphere| [Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, Moment::After, axis))),
        );
    }
    let geometry = match &scene.contact {
        Some(Contact::Offset { offset, sum, .. }) => contact::triangle(scene, &known, offset, sum),
        _ => None,
    };
    Derivation::carry_out(&mut known, &needed);
    let view = View { scene, known: &known, show: Show::new(scene, &known, &[]), manner };
    let both = [Moment::Before, Moment::After].map(|moment| match scene.contact {
        Some(_) => view.components(moment),
        None => view.vectors(moment),
    });
    let [Some(before), Some(after)] = both else { return geometry.into_iter().collect() };
    geometry.into_iter().chain([(Moment::Before, before), (Moment::After, after)].map(titled)).collect()
}

fn titled((moment, spheres): (Moment, Spheres)) -> Diagram {
    let title = if moment == Moment::Before { "Before" } else { "After" };
    Diagram { title: title.to_owned(), drawing: spheres.draw(), words: in_words(&spheres, moment) }
}

struct View<'a> {
    scene: &'a Scene,
    known: &'a Known<Value>,
    show: Show<'a>,
    manner: Manner<'a>,
}

impl View<'_> {
    /// The line of centres as it is drawn: as it lies where it is parallel to an axis, else across the page.
    fn components(&self, moment: Moment) -> Option<Spheres> {
        let line = match self.show.axis() {
            Some(_) => line_of_centres(self.known)?,
            None => Point::new(1.0, 0.0),
        };
        let positive = if self.show.is_against_n() { -line } else { line };
        let across = match self.show.axis() {
            Some(Axis::X) => Point::new(0.0, 1.0),
            Some(_) => Point::new(1.0, 0.0),
            None => line.turned(),
        };
        let mut bodies = [Body::default(), Body::default()];
        for sphere in Sphere::BOTH {
            let along = match moment {
                Moment::Before => self.component(sphere, Axis::N, positive),
                Moment::After => Some(arrow(self.show.after(sphere), positive)),
            };
            let unchanged = self.component(sphere, Axis::T, across);
            let motions: Vec<Motion> = along.into_iter().chain(unchanged).collect();
            let mass = mass(self.scene, sphere, self.manner);
            bodies[sphere as usize] = Body { mass, at_rest: motions.is_empty(), motions };
        }
        Some(Spheres { line, named: false, bodies, axes: self.manner.vectors, positive: Some(positive) })
    }

    /// A component before the impact, drawn in its own direction; none if it is nought.
    fn component(&self, sphere: Sphere, axis: Axis, positive: Point) -> Option<Motion> {
        let value = self.show.worked(Quantity::Velocity(sphere, Moment::Before, axis));
        if value.is_zero() {
            return None;
        }
        let shown = match axis {
            Axis::N => self.show.along(sphere, Moment::Before),
            _ => self.show.across(sphere, Moment::Before),
        };
        let negative = measure(&value).is_some_and(|size| size < 0.0);
        Some(if negative { arrow(shown.negated(), -positive) } else { arrow(shown, positive) })
    }

    /// The velocities as vectors.
    fn vectors(&self, moment: Moment) -> Option<Spheres> {
        let line = line_of_centres(self.known)?;
        let mut bodies = [Body::default(), Body::default()];
        for sphere in Sphere::BOTH {
            let at = |axis| self.known.number(Quantity::Velocity(sphere, moment, axis));
            let (x, y) = (at(Axis::X)?, at(Axis::Y)?);
            let motions = match direction(&x, &y) {
                None => Vec::new(),
                Some(heading) => {
                    let vector = self.show.vector(sphere, moment);
                    let label = self.manner.quantity(&vector, Unit::MetrePerSecond);
                    vec![Motion { heading, label, angle: None, component: false, leaving: moment == Moment::After }]
                }
            };
            let mass = mass(self.scene, sphere, self.manner);
            bodies[sphere as usize] = Body { mass, at_rest: motions.is_empty(), motions };
        }
        let named = moment == Moment::Before;
        Some(Spheres { line, named, bodies, axes: named, positive: None })
    }
}

fn arrow(label: Expr, heading: Point) -> Motion {
    Motion { heading, label: formula(label), angle: None, component: true, leaving: false }
}
