//! A particle that receives an impulse: its velocity and the impulse, or the triangle of its momenta.

use super::canvas::{Canvas, Spot};
use super::drawing::{Drawing, Point, Style};
use super::spheres::{Body, draw_axes};
use super::spots::{around, beside};
use super::{Diagram, formula};
use crate::expr::{Expr, Text, print};

/// Radius of the particle, which has room for its name.
const RADIUS: f64 = 0.9;
/// Length of an arrow.
const ARROW: f64 = 3.8;
/// The longest side of a triangle of momenta.
const LONGEST: f64 = 8.0;
/// The shortest side in which an arrow can be seen, and the least height over the longest side that keeps two
/// sides apart, heads and all.
const SHORTEST: f64 = 1.7;
const LEAST_HEIGHT: f64 = 1.4;
/// How far from its middle line a label is clear of a hollow arrow.
const BESIDE_HOLLOW: f64 = 0.3;

/// What a picture of a particle shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Particle {
    /// The particle, with its velocity.
    pub body: Body,
    /// The direction of the impulse, and what stands at it.
    pub impulse: Option<(Point, Text)>,
    /// Are **i** and **j** drawn?
    pub axes: bool,
}

impl Particle {
    /// The picture.
    pub fn draw(&self) -> Drawing {
        let centre = Point::default();
        let mut canvas = Canvas::default();
        canvas.circle(Style::Rim, centre, RADIUS);
        let heading = self.body.motions.first().map(|motion| motion.heading);
        if let Some(heading) = heading {
            canvas.arrow(Style::Velocity, heading * RADIUS, heading * (RADIUS + ARROW));
        }
        let impulse = self.impulse.as_ref().map(|(towards, label)| {
            // The impulse stands on the side where the velocity does not: it pushes from behind, or it leaves.
            let pushes = heading.is_some_and(|heading| heading.dot(*towards) > 0.0);
            let side = if pushes { -*towards } else { *towards };
            let (near, far) = (side * (RADIUS + 0.2), side * (RADIUS + ARROW));
            if pushes {
                canvas.hollow_arrow(far, near)
            } else {
                canvas.hollow_arrow(near, far)
            }
            (side, label)
        });
        canvas.label(formula(Expr::name("A")), [Spot::over(centre)]);
        if let Some(motion) = self.body.motions.first() {
            canvas.label(motion.label.clone(), at_arrow(motion.heading));
        }
        if let Some((side, label)) = impulse {
            canvas.label(label.clone(), at_arrow(side));
        }
        let first = heading.or(impulse.map(|(side, _)| side)).map_or(Point::new(0.0, -1.0), Point::turned);
        let first = if first.y > 0.0 { -first } else { first };
        let notes = [self.body.mass.clone(), self.body.at_rest.then(|| Text::words("at rest"))];
        for note in notes.into_iter().flatten() {
            canvas.label(note, around(centre, RADIUS, first, first.turned()));
        }
        if self.axes {
            draw_axes(&mut canvas);
        }
        canvas.finish()
    }
}

/// Spots for what stands at an arrow on this side of the particle: at its far end, or beside it.
fn at_arrow(side: Point) -> Vec<Spot> {
    let far = side * (RADIUS + ARROW);
    let ends = [0.0, 0.6, 1.2, 2.4].map(|step| Spot::new(far + side * step, side));
    ends.into_iter().chain(beside(side * RADIUS, far, Point::new(0.0, 1.0))).collect()
}

/// The momentum before, the impulse and the momentum after, with what stands at each.
pub struct Momenta {
    /// The momentum before and the impulse, to one scale.
    pub steps: [Point; 2],
    /// What stands at the momentum before, at the impulse and at the momentum after.
    pub labels: [Text; 3],
    /// Are **i** and **j** drawn?
    pub axes: bool,
}

impl Momenta {
    /// The triangle, if its sides can be told apart.
    pub fn triangle(self) -> Option<Diagram> {
        let [before, impulse] = self.steps;
        let after = before + impulse;
        let sides = [before, impulse, after].map(Point::length);
        let longest = sides.into_iter().fold(0.0, f64::max);
        let shortest = sides.into_iter().fold(longest, f64::min);
        let scale = LONGEST / longest;
        let height = before.turned().dot(impulse).abs() / longest * scale;
        if longest == 0.0 || shortest * scale < SHORTEST || height < LEAST_HEIGHT {
            return None;
        }
        let (start, middle, end) = (Point::default(), before * scale, after * scale);
        let mut canvas = Canvas::default();
        canvas.arrow(Style::Velocity, start, middle);
        canvas.arrow(Style::Velocity, start, end);
        canvas.hollow_arrow(middle, end);
        let centroid = (start + middle + end) * (1.0 / 3.0);
        for ((from, to), label) in [(start, middle), (middle, end), (start, end)].into_iter().zip(&self.labels) {
            let out = (from + to) * 0.5 - centroid;
            let across = (to - from).unit().turned();
            let out = if across.dot(out) >= 0.0 { across } else { -across };
            // Beside the middle of its arrow, and further off rather than at a corner, where two arrows meet.
            let at = |shares: &'static [f64], steps: &'static [f64]| {
                let spot = move |share: f64, step: f64| Spot::new(from + (to - from) * share + out * step, out);
                steps.iter().flat_map(move |step| shares.iter().map(move |share| spot(*share, *step)))
            };
            let middle = at(&[0.5, 0.4, 0.6, 0.3, 0.7], &[0.0, BESIDE_HOLLOW, 0.8, 1.4, 2.0]);
            let off = at(&[0.5, 0.2, 0.8, 0.0, 1.0, -0.2, 1.2], &[0.0, 0.8, 1.6, 2.4, 3.2]);
            canvas.label(label.clone(), middle.chain(off));
        }
        if self.axes {
            draw_axes(&mut canvas);
        }
        let [before, impulse, after] = self.labels.each_ref().map(print::text_unicode);
        let words = format!(
            "The triangle of momenta. The momentum before the impulse, {before}, and the impulse, {impulse}, follow each other; \
             the momentum after, {after}, closes the triangle from the beginning of the first to the end of the second."
        );
        Some(Diagram { title: "Momentum".to_owned(), drawing: canvas.finish(), words })
    }
}
