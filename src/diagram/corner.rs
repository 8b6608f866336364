//! The other of two walls that a sphere strikes in turn, and the way between them.

use super::canvas::{Canvas, Spot};
use super::drawing::{Point, Style};
use super::formula;
use super::spots::in_arc;
use super::wall::{ARC, ARROW, BEYOND, RADIUS, WALL, draw_wall, parallel};
use crate::expr::{Expr, Text, print};

/// What is between the sphere and the other wall, at the least.
const ROOM: f64 = 3.2;
/// The longest and the shortest way from one wall to the other.
const WAY: [f64; 2] = [2.0 * RADIUS + 4.6, 14.0];
/// The longest way from a sphere to the corner; walls that meet further off are not drawn so far.
const FAR: f64 = 18.0;
/// The corner that marks a right angle, and the arc of another angle.
const CORNER: f64 = 0.7;
const WEDGE: f64 = 2.2;

/// The other wall.
#[derive(Clone, Debug, PartialEq)]
pub struct Other {
    /// The unit vector from the sphere to it.
    pub inward: Point,
    /// What they are called: the wall that the sphere touches, and this one.
    pub names: [String; 2],
    /// Do their names stand at them, and the angle in which they meet?
    pub named: bool,
    /// The angle in which the walls meet.
    pub between: Between,
}

/// The angle in which two walls meet, as far as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Between {
    /// A right angle, which has its mark.
    Right,
    /// One that the words have a letter or a number for.
    Angle(Text),
    /// One that is given by the directions of the walls.
    Unsaid,
}

/// The way of the sphere from the wall that it touches, to the other one if there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// Where it leads, of length 1.
    pub heading: Point,
    /// The letter of its angle with the wall that it comes from, if it has one.
    pub angle: Option<Expr>,
    /// Where the sphere goes from the other wall, and the letter of that angle.
    pub onwards: Option<(Point, Expr)>,
}

/// Where the other wall is: the centre of the sphere at the first is the origin.
pub struct Place {
    /// Where the walls meet, if that is near.
    corner: Option<Point>,
    /// The centre of the sphere when it touches the other wall.
    there: Point,
    /// Is the way so short that it is drawn as far as that?
    near: bool,
}

impl Other {
    /// Puts the wall where it is clear of the arrows at the sphere, each by its direction, its length and its label.
    pub fn place<'a>(
        &self,
        way: Option<&Way>,
        inward: Point,
        arrows: impl Iterator<Item = (Point, f64, &'a Text)>,
    ) -> Place {
        // How the walls turn at their corner; the sphere has its room before it.
        let (cross, dot) = (inward.turned().dot(self.inward), inward.dot(self.inward));
        let mut distance = f64::max(RADIUS * dot + (RADIUS + ROOM) * cross.abs(), RADIUS + ROOM * (1.0 - dot).min(1.0));
        let mut shortest = WAY[0];
        for (side, length, label) in arrows {
            let (width, height) = print::extent(label);
            let towards = side.dot(self.inward);
            let label = if towards > 1e-9 { width * self.inward.x.abs() + height * self.inward.y.abs() } else { 0.0 };
            distance = f64::max(distance, towards * length + label + 1.0);
            // Beside an arrow there is room for the sphere.
            if let Some(way) = way.filter(|way| way.heading.dot(side) > 0.0) {
                shortest = f64::max(shortest, (RADIUS + 1.6) / way.heading.dot(side.turned()).abs().max(0.1));
            }
        }
        if let Some(way) = way {
            // So are the lines that show an angle, at either wall.
            let angle =
                |inward: Point, side: Point| [side * (RADIUS + ARROW), parallel(inward, side) * (RADIUS + BEYOND)];
            if way.angle.is_some() {
                let tips = angle(inward, way.heading).map(|tip| tip.dot(self.inward));
                distance = tips.into_iter().fold(distance, |distance, tip| distance.max(tip + ROOM));
            }
            if let Some((onwards, _)) = way.onwards {
                let tips = angle(self.inward, onwards).map(|tip| tip.dot(inward) - RADIUS + 1.0);
                let back = -way.heading.dot(inward);
                shortest = tips.into_iter().fold(shortest, |shortest, tip| shortest.max(tip / back));
            }
            let along = way.heading.dot(self.inward);
            let length = f64::max((distance - RADIUS) / along, shortest);
            if along > 0.0 && length < WAY[1] {
                let there = way.heading * length;
                let corner = self.corner(RADIUS + length * along, inward);
                return Place { corner, there, near: true };
            }
        }
        let corner = self.corner(distance, inward);
        // From a corner the wall leads away from the first one, at least as far as beside the sphere.
        let beside = self.inward * (distance - RADIUS);
        let there = corner.map_or(beside, |corner| {
            let away = -parallel(self.inward, inward);
            let step = f64::max((beside - corner).dot(away), RADIUS);
            corner + away * step - self.inward * RADIUS
        });
        Place { corner, there, near: false }
    }

    /// Where the walls meet, if the other one is at this distance and that is near.
    fn corner(&self, distance: f64, inward: Point) -> Option<Point> {
        let cross = inward.turned().dot(self.inward);
        let corner = (self.inward.turned() * -RADIUS + inward.turned() * distance) * (1.0 / cross);
        (corner.length() < FAR).then_some(corner)
    }

    /// Both walls as far as the corner, and its angle.
    pub fn draw(&self, place: &Place, inward: Point, canvas: &mut Canvas) {
        for (centre, inward) in [(Point::default(), inward), (place.there, self.inward)] {
            let foot = centre + inward * RADIUS;
            let along = place.corner.map(|corner| (corner - foot).dot(inward.turned()));
            let reach = match along {
                Some(along) if along > 0.0 => [WALL, along],
                Some(along) => [-along, WALL],
                None => [WALL; 2],
            };
            draw_wall(foot, inward, reach, canvas);
        }
        let Some(corner) = place.corner else { return };
        match self.between {
            Between::Right => {
                let [one, other] = [inward, self.inward].map(|inward| -inward * CORNER);
                canvas.line(Style::Thin, corner + one, corner + one + other);
                canvas.line(Style::Thin, corner + other, corner + one + other);
            }
            Between::Angle(_) if self.named => {
                let [one, other] = self.from(corner, place.there, inward);
                canvas.arc(corner, WEDGE, one, other);
            }
            Between::Angle(_) | Between::Unsaid => {}
        }
    }

    /// What stands at them.
    pub fn label(&self, place: &Place, inward: Point, canvas: &mut Canvas) {
        if !self.named {
            return;
        }
        if let (Some(corner), Between::Angle(angle)) = (place.corner, &self.between) {
            let [one, other] = self.from(corner, place.there, inward);
            canvas.label(angle.clone(), in_arc(corner, WEDGE, one, other));
        }
        let walls = [(Point::default(), inward), (place.there, self.inward)].into_iter().zip(&self.names);
        for ((centre, inward), name) in walls {
            let foot = centre + inward * (RADIUS + 0.7);
            let steps = [0.0, 1.5, -1.5, 3.0, -3.0, 4.5, -4.5];
            let spots = [0.0, 1.2, 2.4, 3.6, 4.8]
                .into_iter()
                .flat_map(|off| steps.map(|step| Spot::new(foot + inward.turned() * step + inward * off, inward)));
            canvas.label(Text::words(name), spots);
        }
    }

    /// The directions in which the walls leave the corner.
    fn from(&self, corner: Point, there: Point, inward: Point) -> [Point; 2] {
        [inward * RADIUS, there + self.inward * RADIUS].map(|foot| (foot - corner).unit())
    }
}

impl Way {
    /// The path as far as the other wall, or its beginning.
    pub fn draw(&self, inward: Point, other: Option<(&Other, &Place)>, canvas: &mut Canvas) {
        let there = other.filter(|(_, place)| place.near).map(|(_, place)| place.there);
        let end = there.map_or(self.heading * (RADIUS + ARROW), |there| there - self.heading * RADIUS);
        canvas.arrow(Style::Dashed, self.heading * RADIUS, end);
        if let Some(there) = there {
            canvas.circle(Style::Dashed, there, RADIUS);
            if let Some((onwards, _)) = self.onwards {
                canvas.arrow(Style::Dashed, there + onwards * RADIUS, there + onwards * (RADIUS + ARROW));
            }
        }
        for (centre, inward, side, _) in self.lettered(inward, other) {
            draw_angle(centre, inward, side, canvas);
        }
    }

    /// The letters of its angles.
    pub fn label(&self, inward: Point, other: Option<(&Other, &Place)>, canvas: &mut Canvas) {
        for (centre, inward, side, angle) in self.lettered(inward, other) {
            canvas.label(formula(angle.clone()), in_arc(centre, RADIUS + ARC, parallel(inward, side), side));
        }
    }

    /// Its angles that have a letter: where the sphere is, at which wall, where it goes from there, and the letter.
    fn lettered(
        &self,
        inward: Point,
        other: Option<(&Other, &Place)>,
    ) -> impl Iterator<Item = (Point, Point, Point, &Expr)> {
        let here = self.angle.as_ref().map(|angle| (Point::default(), inward, self.heading, angle));
        let there = other.filter(|(_, place)| place.near).map(|(other, place)| (place.there, other.inward));
        let onwards = there.zip(self.onwards.as_ref());
        let there = onwards.map(|((centre, inward), (onwards, angle))| (centre, inward, *onwards, angle));
        here.into_iter().chain(there)
    }
}

/// The angle of a direction with a wall: the line parallel to the wall, the dashed radius and the arc.
pub fn draw_angle(centre: Point, inward: Point, side: Point, canvas: &mut Canvas) {
    let parallel = parallel(inward, side);
    canvas.line(Style::Dashed, centre, centre + side * RADIUS);
    canvas.line(Style::Dashed, centre, centre + parallel * (RADIUS + BEYOND));
    canvas.arc(centre, RADIUS + ARC, parallel, side);
}
