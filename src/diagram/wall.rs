//! A sphere at a wall, with its velocity or the components of it, and the other wall where it strikes two in turn.

use super::canvas::{Canvas, Spot};
use super::corner::{Other, Way, draw_angle};
use super::drawing::{Drawing, Point, Style};
use super::formula;
use super::spheres::{Body, Motion, draw_axes};
use super::spots::{around, beside, in_arc, inside};
use crate::expr::{Expr, Text};
use crate::mechanics::Sphere;

/// Radius of the sphere.
pub const RADIUS: f64 = 2.1;
/// Length of the arrow of a velocity, and of a component.
pub const ARROW: f64 = 3.4;
const COMPONENT: f64 = 2.6;
/// How far the wall runs to either side.
pub const WALL: f64 = 6.0;
/// The strokes that stand for the solid side of the wall: how far apart, and how long.
const HATCH: (f64, f64) = (0.75, 0.6);
/// How far from the sphere an arc runs, and how far the line that it begins at.
pub const ARC: f64 = 0.9;
pub const BEYOND: f64 = 2.6;

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
    /// The wall that it comes from or goes to.
    pub other: Option<Other>,
    /// Its way from the wall, in a picture that shows it.
    pub way: Option<Way>,
}

/// A wall through a point, solid on the side to which `inward` points, that runs so far to its right and to its left.
pub fn draw_wall(foot: Point, inward: Point, [right, left]: [f64; 2], canvas: &mut Canvas) {
    let along = inward.turned();
    canvas.line(Style::Rim, foot - along * right, foot + along * left);
    let (apart, length) = HATCH;
    let strokes = ((right + left) / apart) as u32;
    for number in 0..strokes {
        let from = foot + along * (left - f64::from(number) * apart);
        canvas.line(Style::Thin, from, from + (inward - along) * length);
    }
}

impl AtWall {
    /// The picture. The centre of the sphere is the origin.
    pub fn draw(&self) -> Drawing {
        let centre = Point::default();
        let mut canvas = Canvas::default();
        let arrows = self.body.motions.iter().map(|motion| (side(motion), RADIUS + length(motion), &motion.label));
        let place = self.other.as_ref().map(|other| other.place(self.way.as_ref(), self.inward, arrows));
        let other = self.other.as_ref().zip(place.as_ref());
        match other {
            Some((other, place)) => other.draw(place, self.inward, &mut canvas),
            None => draw_wall(self.inward * RADIUS, self.inward, [WALL; 2], &mut canvas),
        }
        canvas.circle(Style::Rim, centre, RADIUS);
        canvas.dot(centre);
        for motion in &self.body.motions {
            self.draw_motion(motion, &mut canvas);
        }
        if let Some(way) = &self.way {
            way.draw(self.inward, other, &mut canvas);
        }
        let along = self.arrows_side();
        canvas.label(formula(Expr::name(self.name.name())), inside(centre, RADIUS, -along, -self.inward));
        for motion in &self.body.motions {
            canvas.label(motion.label.clone(), self.beside_arrow(motion));
            if let Some(angle) = &motion.angle {
                let side = side(motion);
                canvas.label(angle.clone(), in_arc(centre, RADIUS + ARC, parallel(self.inward, side), side));
            }
        }
        if let Some(way) = &self.way {
            way.label(self.inward, other, &mut canvas);
        }
        let notes = [self.body.mass.clone(), self.body.at_rest.then(|| Text::words("at rest"))];
        for note in notes.into_iter().flatten() {
            // Among many lines: further off, on either side.
            let far = [1.3, 2.6, 3.9, 5.2].into_iter().flat_map(|step| {
                [(-along, 0.0), (along, 0.0), (-along, 1.5), (along, 1.5)]
                    .map(|(side, up)| Spot::new(centre + side * (RADIUS + step) - self.inward * up, side))
            });
            canvas.label(note, around(centre, RADIUS, -along, -self.inward).into_iter().chain(far));
        }
        if let Some((other, place)) = other {
            other.label(place, self.inward, &mut canvas);
        }
        if self.axes {
            draw_axes(&mut canvas);
        }
        canvas.finish()
    }

    /// The arrow of a velocity, with its angle; it points at the centre, or away from it.
    fn draw_motion(&self, motion: &Motion, canvas: &mut Canvas) {
        let (from, to) = ends(motion);
        canvas.arrow(Style::Velocity, from, to);
        if motion.angle.is_some() {
            draw_angle(Point::default(), self.inward, side(motion), canvas);
        }
    }

    /// The direction parallel to the wall on whose side the arrows stand.
    fn arrows_side(&self) -> Point {
        let along = self.inward.turned();
        let leans = |motion: &&Motion| along.dot(motion.heading).abs() > 1e-9;
        self.body.motions.iter().find(leans).map_or(along, |motion| parallel(self.inward, side(motion)))
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

/// The direction parallel to a wall that is nearest to another one.
pub fn parallel(inward: Point, direction: Point) -> Point {
    let along = inward.turned();
    if along.dot(direction) < 0.0 { -along } else { along }
}

/// From the centre to where the arrow stands: before the impact it comes from there, after it it goes there.
fn side(motion: &Motion) -> Point {
    if motion.leaving { motion.heading } else { -motion.heading }
}

fn length(motion: &Motion) -> f64 {
    if motion.component { COMPONENT } else { ARROW }
}

fn ends(motion: &Motion) -> (Point, Point) {
    let side = side(motion);
    let (rim, far) = (side * RADIUS, side * (RADIUS + length(motion)));
    if motion.leaving { (rim, far) } else { (far, rim) }
}
