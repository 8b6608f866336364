//! The pictures of a worked solution: before and after, with what the working calls each component.

use super::corner::Other;
use super::drawing::Point;
use super::given::{line_of_centres, mass, titled};
use super::illustration::{direction, measure};
use super::particle::Momenta;
use super::spheres::{Body, Motion, Spheres};
use super::wall::AtWall;
use super::walls::Walls;
use super::words::{at_wall_in_words, in_words};
use super::{Diagram, Manner, contact, formula};
use crate::expr::{Expr, print, written};
use crate::mechanics::{
    Axis, Contact, Derivation, Known, Moment, Quantity, Scene, Setting, Show, Sphere, ordinal, pose,
};
use crate::number::Value;
use crate::unit::Unit;

/// How wide a momentum may be that is written out.
const WIDEST: f64 = 13.0;

/// The pictures of a solution, impact by impact: each before and after. Where the line of centres is given: the components along it and across it, the unknown ones
/// as letters in the positive direction; at a wall, perpendicular and parallel to it. Where the line is found: the
/// velocities as vectors. For an impulse: the triangle of momenta.
pub fn solution(scene: &Scene, manner: Manner) -> Vec<Vec<Diagram>> {
    let Ok(mut known) = pose(scene) else { return Vec::new() };
    let geometry = match &scene.contact {
        Some(Contact::Offset { offset, sum, .. }) => contact::triangle(scene, &known, offset, sum),
        _ => None,
    };
    Derivation::carry_out(&mut known, &needed(scene));
    let walls = Walls::of(scene, &known);
    let view = |show| View { scene, known: &known, show, manner, names: Sphere::BOTH, other: walls.other(0, manner) };
    if scene.setting == Setting::Impulse {
        return vec![view(Show::new(scene, &known, &[])).momenta().into_iter().collect()];
    }
    let first = view(Show::new(scene, &known, &[]));
    let mut pictures: Vec<Vec<Diagram>> = vec![geometry.into_iter().chain(first.before_and_after()).collect()];
    for then in &scene.then {
        let meeting = then.meeting;
        let needed: Vec<Quantity> =
            needed(&then.scene).into_iter().map(|quantity| meeting.quantity(quantity)).collect();
        Derivation::carry_out(&mut known, &needed);
        let here = meeting.known(&known);
        let later = Show::new(scene, &known, &[]).of_later(meeting).map(|show| {
            let other = walls.other(meeting.number.into(), manner);
            let view = View { scene: &then.scene, known: &here, show, manner, names: meeting.of, other };
            view.before_and_after()
        });
        pictures.push(later.unwrap_or_default());
    }
    if pictures.len() > 1 {
        for (impact, picture) in
            (0..).zip(&mut pictures).flat_map(|(impact, of_it)| of_it.iter_mut().map(move |picture| (impact, picture)))
        {
            *picture = numbered(std::mem::take(picture), impact);
        }
    }
    pictures
}

/// What a picture of one impact shows.
fn needed(scene: &Scene) -> Vec<Quantity> {
    let spheres = if scene.setting.is_of_one() { &Sphere::BOTH[..1] } else { &Sphere::BOTH };
    let velocities = |moment, axes: [Axis; 2]| {
        spheres.iter().flat_map(move |sphere| axes.map(|axis| Quantity::Velocity(*sphere, moment, axis)))
    };
    let mut needed = vec![];
    if scene.setting == Setting::Impulse {
        needed.extend(
            [Moment::Before, Moment::After].into_iter().flat_map(|moment| velocities(moment, [Axis::X, Axis::Y])),
        );
    } else {
        needed.extend([Quantity::Line(Axis::X), Quantity::Line(Axis::Y)]);
        needed.extend(velocities(Moment::Before, [Axis::N, Axis::T]));
        if scene.contact.is_none() {
            needed.extend(velocities(Moment::After, [Axis::X, Axis::Y]));
        }
        // A velocity that is given along i and j has its component along the line of centres too.
        let is_given = |sphere: &&Sphere| scene.velocity(**sphere, Moment::After).is_some();
        let along = |sphere: &Sphere| Quantity::Velocity(*sphere, Moment::After, Axis::N);
        needed.extend(spheres.iter().filter(is_given).map(along));
    }
    needed
}

/// Says of which impact a picture is: `Before the second impact`.
fn numbered(picture: Diagram, number: u8) -> Diagram {
    let impact = ordinal(number);
    let words = picture.words.replace("the impact", &format!("the {impact} impact"));
    Diagram { title: format!("{} the {impact} impact", picture.title), words, ..picture }
}

fn pictured(spheres: &Spheres, moment: Moment) -> Diagram {
    Diagram { title: String::new(), drawing: spheres.draw(), words: in_words(spheres, moment) }
}

struct View<'a> {
    scene: &'a Scene,
    known: &'a Known<Value>,
    show: Show<'a>,
    manner: Manner<'a>,
    /// Who has the part of A, and who that of B.
    names: [Sphere; 2],
    /// The wall that the sphere comes from or goes to, where this one is at a wall too.
    other: Option<Other>,
}

impl View<'_> {
    /// The impact before and after, if both can be drawn.
    fn before_and_after(&self) -> Vec<Diagram> {
        let both = self.at(Moment::Before).zip(self.at(Moment::After));
        both.into_iter().flat_map(<[_; 2]>::from).collect()
    }

    /// The impact before or after, with that above it.
    fn at(&self, moment: Moment) -> Option<Diagram> {
        let picture = match (self.scene.setting, &self.scene.contact) {
            (Setting::Wall, _) => self.at_wall(moment)?,
            (_, Some(_)) => pictured(&self.components(moment)?, moment),
            (_, None) => pictured(&self.vectors(moment)?, moment),
        };
        Some(titled(moment, picture))
    }

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
                Moment::After => self.after(sphere, positive),
            };
            let unchanged = self.component(sphere, Axis::T, across);
            let motions: Vec<Motion> = along.into_iter().chain(unchanged).collect();
            let mass = mass(self.scene, sphere, self.manner);
            bodies[sphere as usize] = Body { mass, at_rest: motions.is_empty(), motions };
        }
        let apart = self.scene.setting == Setting::Direct;
        // Where the picture is turned i and j lie otherwise than on the page.
        let axes = self.manner.vectors && moment == Moment::Before && self.show.axis().is_some();
        let names = self.names;
        Some(Spheres {
            line,
            apart,
            named: false,
            names,
            bodies,
            beyond: Default::default(),
            axes,
            positive: Some(positive),
        })
    }

    /// A component after the impact: one that is given in its own direction, an unknown one in the positive.
    fn after(&self, sphere: Sphere, positive: Point) -> Option<Motion> {
        let shown = self.show.after(sphere);
        if self.scene.velocity(sphere, Moment::After).is_none() {
            return Some(arrow(shown, positive));
        }
        let value = self.show.worked(Quantity::Velocity(sphere, Moment::After, Axis::N));
        if value.is_zero() {
            return None;
        }
        let negative = measure(&value).is_some_and(|size| size < 0.0);
        Some(if negative { arrow(shown.negated(), -positive) } else { arrow(shown, positive) })
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

    /// The components of A perpendicular and parallel to the wall, as sizes at arrows that have their directions.
    fn at_wall(&self, moment: Moment) -> Option<Diagram> {
        let inward = line_of_centres(self.known)?;
        let leaving = moment == Moment::After;
        let arrow = |label, heading| Motion { leaving, ..arrow(label, heading) };
        let size = |axis, shown: Expr| {
            let negative = self.show.worked(Quantity::Velocity(Sphere::A, moment, axis));
            Some(if measure(&negative)? < 0.0 { shown.negated() } else { shown })
        };
        let mut motions = Vec::new();
        match (moment, self.scene.velocity(Sphere::A, Moment::After)) {
            (Moment::Before, _) => {
                motions.push(arrow(size(Axis::N, self.show.along(Sphere::A, Moment::Before))?, inward));
            }
            (Moment::After, Some(_)) => motions.push(arrow(size(Axis::N, self.show.after(Sphere::A))?, -inward)),
            (Moment::After, None) => motions.push(arrow(self.show.after(Sphere::A), -inward)),
        }
        // The component parallel to the wall is the same after as before.
        let parallel = self.show.exact(Quantity::Velocity(Sphere::A, Moment::Before, Axis::T));
        if !parallel.is_zero() {
            let along = inward.turned();
            let heading = if measure(&parallel)? < 0.0 { -along } else { along };
            let worked = self.show.worked(Quantity::Velocity(Sphere::A, Moment::Before, Axis::T));
            let shown = self.show.across(Sphere::A, Moment::Before);
            motions.push(arrow(if measure(&worked)? < 0.0 { shown.negated() } else { shown }, heading));
        }
        let body = Body { mass: mass(self.scene, Sphere::A, self.manner), at_rest: false, motions };
        // What is the same in both pictures is told in the first.
        let named = moment == Moment::Before;
        let (axes, other) = (self.manner.vectors && named, self.other.clone().map(|other| Other { named, ..other }));
        let picture = AtWall { inward, name: self.names[0], body, axes, other, way: None };
        let words = at_wall_in_words(&picture, moment);
        Some(Diagram { title: String::new(), drawing: picture.draw(), words })
    }

    /// The triangle of momenta: before, impulse, after.
    fn momenta(&self) -> Option<Diagram> {
        let mass = self.known.number(Quantity::Mass(Sphere::A))?;
        let momentum = |moment| {
            let at = |axis| self.known.number(Quantity::Velocity(Sphere::A, moment, axis));
            Some([&mass * &at(Axis::X)?, &mass * &at(Axis::Y)?])
        };
        let (before, after) = (momentum(Moment::Before)?, momentum(Moment::After)?);
        let impulse = [&after[0] - &before[0], &after[1] - &before[1]];
        let point = |pair: &[Value; 2]| Some(Point::new(measure(&pair[0])?, measure(&pair[1])?));
        // Short vectors are written out; long ones, with letters over letters, only have their names.
        let label = |name: Expr, pair: &[Value; 2]| {
            let vector = Expr::Vector(Box::new(written(&pair[0])), Box::new(written(&pair[1])));
            let whole = formula(Expr::equation(name.clone(), vector));
            if print::extent(&whole).0 < WIDEST { whole } else { formula(name) }
        };
        let of = |moment| self.show.named_momentum(Sphere::A, moment);
        let labels = [
            label(of(Moment::Before), &before),
            label(Expr::name("vector.I"), &impulse),
            label(of(Moment::After), &after),
        ];
        Momenta { steps: [point(&before)?, point(&impulse)?], labels, axes: self.manner.vectors }.triangle()
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
        Some(Spheres {
            line,
            apart: false,
            named,
            names: self.names,
            bodies,
            beyond: Default::default(),
            axes: named,
            positive: None,
        })
    }
}

fn arrow(label: Expr, heading: Point) -> Motion {
    Motion { heading, label: formula(label), angle: None, component: true, leaving: false }
}
