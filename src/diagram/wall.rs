//! A sphere at a wall, with its velocity or the components of it.

use super::canvas::{Canvas, Spot};
use super::drawing::{Drawing, Point, Style};
use super::formula;
use super::spheres::{Body, Motion, draw_axes};
use super::spots::{around, beside, in_arc, inside};
use crate::expr::{Expr, Text};
use crate::mechanics::Sphere;

/// Radius of the sphere.
const RADIUS: f64 = 2.1;
/// Length of the arrow of a velocity, and of a component.
const ARROW: f64 = 3.4;
const COMPONENT: f64 = 2.6;
/// How far the wall runs to either side.
const WALL: f64 = 6.0;
/// The strokes that stand for the solid side of the wall: how far apart, and how long.
const HATCH: (f64, f64) = (0.75, 0.6);
/// How far from the sphere an arc runs, and how far the line that it begins at.
const ARC: f64 = 0.9;
const BEYOND: f64 = 2.6;

/// What a picture of a sphere at a wall shows.
#[derive(Clone, Debug, PartialEq)]
pub struct AtWall {
    /// The unit vector from the sphere to the wall.
    pub inward: Point,
    /// What the sphere is called.
    pub name: Sphere,
    /// The sphere. Its angles are with the wall.
    pub body: Body,
    /// Are **i** and **j** drawn?
    pub axes: bool,
}

impl AtWall {
    /// The picture. The centre of the sphere is the origin.
    pub fn draw(&self) -> Drawing {
        let centre = Point::default();
        let mut canvas = Canvas::default();
        self.draw_wall(&mut canvas);
        canvas.circle(Style::Rim, centre, RADIUS);
        canvas.dot(centre);
        for motion in &self.body.motions {
            self.draw_motion(motion, &mut canvas);
        }
        let along = self.arrows_side();
        canvas.label(formula(Expr::name(self.name.name())), inside(centre, RADIUS, -along, -self.inward));
        for motion in &self.body.motions {
            canvas.label(motion.label.clone(), self.beside_arrow(motion));
            if let Some(angle) = &motion.angle {
                let side = side(motion);
                canvas.label(angle.clone(), in_arc(centre, RADIUS + ARC, self.parallel(side), side));
            }
        }
        let notes = [self.body.mass.clone(), self.body.at_rest.then(|| Text::words("at rest"))];
        for note in notes.into_iter().flatten() {
            canvas.label(note, around(centre, RADIUS, -along, -self.inward));
        }
        if self.axes {
            draw_axes(&mut canvas);
        }
        canvas.finish()
    }

    fn draw_wall(&self, canvas: &mut Canvas) {
        let (foot, along) = (self.inward * RADIUS, self.inward.turned());
        canvas.line(Style::Rim, foot - along * WALL, foot + along * WALL);
        let (apart, length) = HATCH;
        let strokes = (2.0 * WALL / apart) as u32;
        for number in 0..strokes {
            let from = foot + along * (WALL - f64::from(number) * apart);
            canvas.line(Style::Thin, from, from + (self.inward - along) * length);
        }
    }

    /// The arrow of a velocity, with its angle; it points at the centre, or away from it.
    fn draw_motion(&self, motion: &Motion, canvas: &mut Canvas) {
        let centre = Point::default();
        let (from, to) = ends(motion);
        canvas.arrow(Style::Velocity, from, to);
        if motion.angle.is_some() {
            let side = side(motion);
            let parallel = self.parallel(side);
            canvas.line(Style::Dashed, centre, side * RADIUS);
            canvas.line(Style::Dashed, centre, parallel * (RADIUS + BEYOND));
            canvas.arc(centre, RADIUS + ARC, parallel, side);
        }
    }

    /// The direction parallel to the wall that is nearest to another one.
    fn parallel(&self, direction: Point) -> Point {
        let along = self.inward.turned();
        if along.dot(direction) < 0.0 { -along } else { along }
    }

    /// The direction parallel to the wall on whose side the arrows stand.
    fn arrows_side(&self) -> Point {
        let along = self.inward.turned();
        let leans = |motion: &&Motion| along.dot(motion.heading).abs() > 1e-9;
        self.body.motions.iter().find(leans).map_or(along, |motion| self.parallel(side(motion)))
    }

    fn beside_arrow(&self, motion: &Motion) -> Vec<Spot> {
        let (from, to) = ends(motion);
        let side = side(motion);
        let far = if motion.leaving { to } else { from };
        let end = Spot::new(far, side);
        // First the side of the arrow that faces away from the wall, or from where the other arrow is.
        let away = if self.inward.dot(side).abs() > 0.9 { -self.arrows_side() } else { -self.inward };
        let beyond = [0.8, 1.6, 2.4].map(|step| Spot::new(far + side * step, side));
        let raised = [1.2, 2.4, 3.6].map(|step| Spot::new(far + away * step, away));
        [end].into_iter().chain(beside(from, to, away)).chain(beyond).chain(raised).collect()
    }
}

/// From the centre to where the arrow stands: before the impact it comes from there, after it it goes there.
fn side(motion: &Motion) -> Point {
    if motion.leaving { motion.heading } else { -motion.heading }
}

fn ends(motion: &Motion) -> (Point, Point) {
    let side = side(motion);
    let length = if motion.component { COMPONENT } else { ARROW };
    let (rim, far) = (side * RADIUS, side * (RADIUS + length));
    if motion.leaving { (rim, far) } else { (far, rim) }
}
