//! Two spheres with their velocities: the picture that most questions need. They touch, or stand apart on the line along
//! which both move.

use super::canvas::{Canvas, HEAD, Spot};
use super::drawing::{Drawing, Point, Style};
use super::formula;
use super::geometry::Frame;
use super::spots::{in_arc, inside};
use super::wall::draw_wall;
use crate::expr::{Expr, Text};
use crate::mechanics::Sphere;

/// Radius of a sphere.
const RADIUS: f64 = 2.1;
/// Length of an arrow that stands at a rim, and of one that shows a component.
const ARROW: f64 = 3.2;
const COMPONENT: f64 = 2.2;
/// How far the line of centres goes beyond the spheres.
const BEYOND: f64 = 2.3;
/// Half of what is between spheres that stand apart.
const APART: f64 = 0.9;
/// How far a wall at the end of the line runs to either side.
const WALL: f64 = 3.0;
/// How far an arc runs outside its sphere.
const ARC: f64 = 0.9;
/// The corner that marks a right angle.
const CORNER: f64 = 0.45;
/// How far across from its sphere an arrow lies that stands beside it.
const ASIDE: f64 = 0.7;
/// The cosine to the other sphere's direction from which an arrow would graze that sphere, or meet the arrow there.
const IN_THE_WAY: f64 = 0.7;

/// What a picture of two spheres shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Spheres {
    /// The unit vector from A to B.
    pub line: Point,
    /// Do they stand apart, both moving along one line, so that no line of centres is spoken of?
    pub apart: bool,
    /// Is the line of centres called by its name?
    pub named: bool,
    /// Who has the part of A, and who that of B.
    pub names: [Sphere; 2],
    /// A, then B.
    pub bodies: [Body; 2],
    /// What is struck later: on A's side, then on B's.
    pub beyond: [Beyond; 2],
    /// Are **i** and **j** drawn?
    pub axes: bool,
    /// The direction that the working takes as positive.
    pub positive: Option<Point>,
}

/// What is struck later.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Beyond {
    /// A third sphere, where they stand apart: further along the line.
    pub sphere: Option<(Sphere, Body)>,
    /// A wall beyond all of them, by the unit vector towards it.
    pub wall: Option<Point>,
}

/// One of the spheres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Body {
    /// Its mass, where it is known.
    pub mass: Option<Text>,
    /// Is it at rest?
    pub at_rest: bool,
    /// Its velocity, or the components of it.
    pub motions: Vec<Motion>,
}

/// A velocity or a component of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Its direction, of length 1.
    pub heading: Point,
    /// What stands at the arrow.
    pub label: Text,
    /// The acute angle to the line of centres, where it is to be drawn.
    pub angle: Option<Text>,
    /// Is it a component, drawn beside the sphere?
    pub component: bool,
    /// Does it start from the sphere, unless the other one is in the way?
    pub leaving: bool,
}

/// One sphere in its place.
struct Placed<'a> {
    name: Sphere,
    body: &'a Body,
    centre: Point,
    /// From the other sphere to this one.
    outward: Point,
    /// The side of the line of centres on which nothing is in the way: up, or to the right.
    above: Point,
}

impl Spheres {
    /// The picture.
    pub fn draw(&self) -> Drawing {
        let mut canvas = Canvas::default();
        let turned = self.line.turned();
        let above = if turned.y > 1e-9 || (turned.y.abs() <= 1e-9 && turned.x > 0.0) { turned } else { -turned };
        let half = if self.apart { RADIUS + APART } else { RADIUS };
        let placed = |sphere: Sphere| {
            let outward = if sphere == Sphere::A { -self.line } else { self.line };
            let name = self.names[sphere as usize];
            Placed { name, body: &self.bodies[sphere as usize], centre: outward * half, outward, above }
        };
        let both = Sphere::BOTH.map(placed);
        let [far_a, far_b] = both.each_ref().map(|placed| placed.centre + placed.outward * (RADIUS + placed.beyond()));
        if !self.apart {
            canvas.line(Style::Centres, far_a, far_b);
        }
        let mut all = Vec::from(both);
        for (place, beyond) in self.beyond.iter().enumerate() {
            let Placed { centre, outward, .. } = all[place];
            let step = outward * (2.0 * (RADIUS + APART));
            let third = beyond.sphere.as_ref();
            all.extend(third.map(|(name, body)| Placed { name: *name, body, centre: centre + step, outward, above }));
            if let Some(inward) = beyond.wall.filter(|_| self.apart) {
                let last = if third.is_some() { centre + step } else { centre };
                draw_wall(last + inward * (RADIUS + 2.0 * APART), inward, [WALL; 2], &mut canvas);
            }
        }
        for placed in &all {
            canvas.circle(Style::Rim, placed.centre, RADIUS);
            if !self.apart {
                canvas.dot(placed.centre);
            }
        }
        for placed in &all {
            placed.body.motions.iter().for_each(|motion| placed.arrow(motion, &mut canvas));
        }
        for (beyond, placed) in self.beyond.iter().zip(&all).filter(|_| !self.apart) {
            let Some(inward) = beyond.wall else { continue };
            let distance = canvas.frame().farthest(inward) - placed.centre.dot(inward);
            draw_wall(placed.centre + inward * (distance + APART), inward, [WALL; 2], &mut canvas);
        }
        let arcs: Vec<Vec<bool>> = all.iter().map(|placed| placed.arcs(&mut canvas)).collect();
        for placed in &all {
            placed.name(self.apart, &mut canvas);
        }
        for (placed, arcs) in all.iter().zip(arcs) {
            placed.labels(&arcs, &mut canvas);
        }
        if self.named {
            let ends = [(far_b, self.line), (far_a, -self.line)];
            let beyond = ends.map(|(end, outward)| Spot::new(end, outward));
            let beside = ends.iter().flat_map(|(end, outward)| {
                let further = [0.0, 1.2, 2.4, 3.6].map(|step| *end + *outward * step);
                let sides = [above, -above, above * 1.3, above * -1.3, above * 2.6, above * -2.6];
                further.into_iter().flat_map(move |point| sides.map(|side| Spot::new(point + side - side.unit(), side)))
            });
            canvas.label(Text::words("line of centres"), beyond.into_iter().chain(beside));
        }
        if let Some(positive) = self.positive {
            draw_positive(positive, &mut canvas);
        }
        if self.axes {
            draw_axes(&mut canvas);
        }
        canvas.finish()
    }
}

impl Placed<'_> {
    /// How far the line of centres goes beyond this sphere: past an arrow that lies on it.
    fn beyond(&self) -> f64 {
        let along = |motion: &Motion| !motion.component && motion.heading.dot(self.outward).abs() > 0.995;
        if self.body.motions.iter().any(along) { ARROW + 0.8 } else { BEYOND }
    }

    /// The side of the sphere on which the arrow of a velocity stands, and whether the arrow starts there.
    ///
    /// It is the outer side, so that no arrow meets the other sphere. One that is to leave the sphere may do so on the
    /// inner side as far as there is room; if there is none, it stands on neither, but beside the sphere.
    fn side(&self, motion: &Motion) -> Option<(Point, bool)> {
        let outwards = motion.heading.dot(self.outward);
        match motion.leaving || outwards > 1e-9 {
            true => (outwards > -IN_THE_WAY).then_some((motion.heading, true)),
            false => Some((-motion.heading, false)),
        }
    }

    /// Across the arrow of a motion, away from the line of centres.
    fn aside(&self, motion: &Motion) -> Point {
        let across = motion.heading.turned();
        let off_line = motion.heading - self.outward * motion.heading.dot(self.outward);
        let reference = if off_line.length() > 1e-9 { off_line } else { self.above };
        if across.dot(reference) >= 0.0 { across } else { -across }
    }

    /// The ends of the arrow of a motion.
    fn ends(&self, motion: &Motion) -> (Point, Point) {
        if motion.component {
            let along = motion.heading.dot(self.outward).abs() > 0.5;
            let middle = if along {
                self.centre + self.above * (RADIUS + ASIDE)
            } else {
                self.centre + self.outward * (RADIUS + 1.1) + self.above * (COMPONENT / 2.0 + 0.4)
            };
            let half = motion.heading * (COMPONENT / 2.0);
            return (middle - half, middle + half);
        }
        let Some((side, leaves)) = self.side(motion) else {
            let middle = self.centre + self.aside(motion) * (RADIUS + ASIDE);
            let half = motion.heading * (ARROW / 2.0);
            return (middle - half, middle + half);
        };
        let (rim, tail) = (self.centre + side * RADIUS, self.centre + side * (RADIUS + ARROW));
        if leaves { (rim, tail) } else { (tail, rim) }
    }

    fn arrow(&self, motion: &Motion, canvas: &mut Canvas) {
        let (from, to) = self.ends(motion);
        canvas.arrow(Style::Velocity, from, to);
        let slants = !motion.component && motion.heading.dot(self.outward).abs() < 0.995;
        if let Some((side, _)) = self.side(motion).filter(|_| slants) {
            canvas.line(Style::Dashed, self.centre, self.centre + side * RADIUS);
        }
    }

    /// The arc of each motion whose angle is given; a right angle has a corner and no arc.
    fn arcs(&self, canvas: &mut Canvas) -> Vec<bool> {
        let arc = |motion: &Motion, canvas: &mut Canvas| {
            let Some((side, _)) = self.side(motion).filter(|_| motion.angle.is_some()) else { return false };
            if side.dot(self.outward) < 1e-9 {
                let (along, across) = (self.outward * CORNER, side * CORNER);
                canvas.line(Style::Thin, self.centre + along, self.centre + along + across);
                canvas.line(Style::Thin, self.centre + across, self.centre + along + across);
                return false;
            }
            canvas.arc(self.centre, RADIUS + ARC, self.outward, side);
            true
        };
        self.body.motions.iter().map(|motion| arc(motion, canvas)).collect()
    }

    fn name(&self, apart: bool, canvas: &mut Canvas) {
        let beside_the_centre = inside(self.centre, RADIUS, -self.above, self.outward);
        let middle = apart.then(|| Spot::over(self.centre));
        canvas.label(formula(Expr::name(self.name.name())), middle.into_iter().chain(beside_the_centre));
    }

    fn labels(&self, arcs: &[bool], canvas: &mut Canvas) {
        for (motion, arc) in self.body.motions.iter().zip(arcs) {
            canvas.label(motion.label.clone(), self.beside_arrow(motion));
            if let (Some(angle), true, Some((side, _))) = (&motion.angle, *arc, self.side(motion)) {
                canvas.label(angle.clone(), in_arc(self.centre, RADIUS + ARC, self.outward, side));
            }
        }
        if let Some(mass) = &self.body.mass {
            canvas.label(mass.clone(), self.around(-self.above));
        }
        if self.body.at_rest {
            canvas.label(Text::words("at rest"), self.around(self.above));
        }
    }

    /// Spots around the sphere, the first on one side of the line of centres.
    fn around(&self, first: Point) -> Vec<Spot> {
        let leaning = |side: Point| [0.0, 0.4, 0.8, 1.4].map(|share| (side + self.outward * share).unit());
        let directions = leaning(first).into_iter().chain(leaning(-first));
        let near = directions.map(|direction| Spot::new(self.centre + direction * RADIUS, direction));
        let far = [1.2, 2.6]
            .into_iter()
            .flat_map(|step| [first, -first].map(|side| Spot::new(self.centre + side * (RADIUS + step), side)));
        near.chain(far).collect()
    }

    fn beside_arrow(&self, motion: &Motion) -> Vec<Spot> {
        let (from, to) = self.ends(motion);
        let across = (to - from).unit().turned();
        // Of the two sides of an arrow first the one that faces away from the line of centres, or from the sphere.
        let away = to + from - self.centre * 2.0;
        let off_line = away - self.outward * away.dot(self.outward);
        let side = self.side(motion).map(|(side, _)| side).filter(|_| !motion.component);
        let reference = match side {
            None => away,
            Some(_) if off_line.length() > 0.1 => off_line,
            Some(_) => self.above,
        };
        let first = if across.dot(reference) >= 0.0 { across } else { -across };
        let at_tail = |side: Point, step: f64| Spot::new(self.centre + side * (RADIUS + ARROW + step), side);
        let along = [0.5, 0.7, 0.85, 0.3, 0.15, 1.0].map(|share| from + (to - from) * share);
        let mut spots = Vec::new();
        // Beside a slight angle its arc has the room at the end of the arrow.
        let most = if motion.angle.is_some() { 0.8 } else { 0.98 };
        spots.extend(side.filter(|side| side.dot(self.outward) < most).map(|side| at_tail(side, 0.0)));
        for side in [first, -first] {
            // A long label is clear of the head.
            let raised = along.into_iter().flat_map(|point| [point, point + side * HEAD.1]);
            spots.extend(raised.map(|point| Spot::new(point, side)));
        }
        if side.is_none() {
            // Long labels side by side: pushed outwards, or one above the other.
            let middle = (from + to) * 0.5;
            let steps = [0.6, 1.2, 1.8, 2.6, 3.4, 4.4].map(|step| Spot::new(middle + self.outward * step, first));
            spots.extend(steps);
            for lift in [1.2, 2.4, 3.6] {
                spots.extend(
                    [0.0, 1.2, 2.4, 3.6].map(|step| Spot::new(middle + first * lift + self.outward * step, first)),
                );
            }
        }
        spots.extend(side.into_iter().flat_map(|side| [0.0, 0.8, 1.6].map(|step| at_tail(side, step))));
        // Where the label of the other arrow has that room: at the end, a little to one side.
        let lifted = |(side, lift): (Point, f64)| {
            let end = at_tail(side, 0.0).beside;
            [first, -first].map(|across| Spot::new(end + across * lift, side))
        };
        spots.extend(side.into_iter().flat_map(|side| [0.4, 0.8, 1.6].map(|lift| (side, lift))).flat_map(lifted));
        spots
    }
}

/// The positive direction, outside of everything else.
fn draw_positive(positive: Point, canvas: &mut Canvas) {
    let Frame { low, high } = canvas.frame();
    let middle = (low + high) * 0.5;
    let upright = positive.y.abs() > positive.x.abs();
    let at = if upright { Point::new(low.x - 0.9, middle.y) } else { Point::new(middle.x, high.y + 0.9) };
    let half = positive * 1.1;
    canvas.arrow(Style::Thin, at - half, at + half);
    let aside = if upright { Point::new(-1.0, 0.0) } else { Point::new(0.0, 1.0) };
    canvas.label(Text::words("positive"), [Spot::new(at + aside * 0.2, aside)]);
}

/// The unit vectors, outside of everything else.
pub fn draw_axes(canvas: &mut Canvas) {
    let Frame { low, .. } = canvas.frame();
    let origin = Point::new(low.x - 3.6, low.y + 0.4);
    for (unit, step) in [("i", Point::new(1.7, 0.0)), ("j", Point::new(0.0, 1.7))] {
        canvas.arrow(Style::Thin, origin, origin + step);
        canvas.label(formula(Expr::name(unit)), [Spot::new(origin + step, step)]);
    }
}
