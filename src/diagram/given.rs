//! The figure of a question: what is given, and nothing else.

use super::illustration::{direction, measure};
use super::spheres::{Body, Motion, Spheres};
use super::words::in_words;
use super::{Diagram, Manner, Point, contact, formula};
use crate::expr::{Expr, Text, written, written_angle};
use crate::mechanics::{Axis, Contact, Known, Moment, Quantity, Scene, Sphere, Velocity, pose};
use crate::number::{Angle, Value};
use crate::unit::Unit;

/// The pictures of what a scene gives: the spheres as they touch, or the path of A and its distance from B. There are
/// none where the line of centres is to be found: to draw it would be to give it away.
pub fn given(scene: &Scene, manner: Manner) -> Vec<Diagram> {
    let Ok(known) = pose(scene) else { return Vec::new() };
    let diagram = match &scene.contact {
        Some(Contact::Along(..)) => touching(scene, &known, manner),
        Some(Contact::Offset { offset, radii, .. }) => contact::path(scene, &known, offset, radii, manner),
        _ => None,
    };
    diagram.into_iter().collect()
}

fn touching(scene: &Scene, known: &Known<Value>, manner: Manner) -> Option<Diagram> {
    let line = line_of_centres(known)?;
    let mut bodies = [Body::default(), Body::default()];
    for sphere in Sphere::BOTH {
        bodies[sphere as usize] = Body { mass: mass(scene, sphere, manner), ..moving(scene, known, sphere, manner)? };
    }
    let spheres = Spheres { line, named: true, bodies, axes: manner.vectors, positive: None };
    Some(Diagram { title: String::new(), drawing: spheres.draw(), words: in_words(&spheres, Moment::Before) })
}

/// The unit vector from A to B, as it is drawn.
pub fn line_of_centres(known: &Known<Value>) -> Option<Point> {
    direction(&known.number(Quantity::Line(Axis::X))?, &known.number(Quantity::Line(Axis::Y))?)
}

/// The mass of a sphere, as it is given.
pub fn mass(scene: &Scene, sphere: Sphere, manner: Manner) -> Option<Text> {
    Some(manner.quantity(&scene.mass(sphere)?.shown, Unit::Kilogram))
}

/// A sphere with its velocity before the impact, as it is given.
fn moving(scene: &Scene, known: &Known<Value>, sphere: Sphere, manner: Manner) -> Option<Body> {
    let velocity = match scene.velocity(sphere, Moment::Before) {
        Some(velocity) => velocity,
        None => return Some(Body::default()),
    };
    let (x, y) = components(velocity);
    if x.is_zero() && y.is_zero() {
        return Some(Body { at_rest: true, ..Body::default() });
    }
    let heading = direction(&x, &y)?;
    let motion = |heading, label, angle| Motion { heading, label, angle, component: false, leaving: false };
    let motions = if manner.vectors {
        let vector = match velocity {
            Velocity::Components(x, y) => Expr::Vector(Box::new(x.shown.clone()), Box::new(y.shown.clone())),
            Velocity::Polar { .. } => Expr::Vector(Box::new(written(&x)), Box::new(written(&y))),
        };
        vec![motion(heading, manner.quantity(&vector, Unit::MetrePerSecond), None)]
    } else {
        let at = |axis| known.number(Quantity::Line(axis));
        let (n_x, n_y) = (at(Axis::X)?, at(Axis::Y)?);
        let along = &(&x * &n_x) + &(&y * &n_y);
        let across = &(&y * &n_x) - &(&x * &n_y);
        let angle = written_angle(&Angle::acute(&across, &along)?);
        match speed(velocity, &x, &y, &angle) {
            Some(speed) => {
                let label = manner.quantity(&speed, Unit::MetrePerSecond);
                vec![motion(heading, label, Some(formula(angle)).filter(|_| !across.is_zero()))]
            }
            None => by_components(velocity, [&along, &across], line_of_centres(known)?, manner)?,
        }
    };
    Some(Body { motions, ..Body::default() })
}

/// The speed, where the question gives that: as such, or by components that are its products with a sine and a cosine.
pub fn speed(velocity: &Velocity, x: &Value, y: &Value, angle: &Expr) -> Option<Expr> {
    match velocity {
        Velocity::Polar { speed, .. } => Some(speed.shown.clone()),
        Velocity::Components(given_x, given_y) => match (x.is_zero(), y.is_zero()) {
            (false, true) => Some(size(&given_x.shown, x)),
            (true, false) => Some(size(&given_y.shown, y)),
            _ if matches!(angle, Expr::Name(_)) => Some(written(&(&(x * x) + &(y * y)).square_root()?)),
            _ => None,
        },
    }
}

/// A component without its sign.
fn size(shown: &Expr, value: &Value) -> Expr {
    if value.sign().is_some_and(|sign| sign.is_lt()) { shown.clone().negated() } else { shown.clone() }
}

/// The components along and across the line of centres, as arrows beside the sphere.
fn by_components(velocity: &Velocity, along_across: [&Value; 2], line: Point, manner: Manner) -> Option<Vec<Motion>> {
    // In the form in which it was given, where a component given is one of these.
    let form = |component: &Value| match velocity {
        Velocity::Components(x, y) => {
            let given = [x, y].into_iter().find(|given| given.value.absolute() == component.absolute());
            given.map_or_else(|| written(&component.absolute()), |given| size(&given.shown, &given.value))
        }
        Velocity::Polar { .. } => written(&component.absolute()),
    };
    let arrow = |component: &Value, axis: Point| {
        let heading = if measure(component)? < 0.0 { -axis } else { axis };
        let label = manner.quantity(&form(component), Unit::MetrePerSecond);
        Some(Motion { heading, label, angle: None, component: true, leaving: false })
    };
    let [along, across] = along_across;
    Some(vec![arrow(along, line)?, arrow(across, line.turned())?])
}

/// Components along **i** and **j**, however the velocity was given.
pub fn components(velocity: &Velocity) -> (Value, Value) {
    match velocity {
        Velocity::Components(x, y) => (x.value.clone(), y.value.clone()),
        Velocity::Polar { speed, cos, sin, .. } => (&speed.value * cos, &speed.value * sin),
    }
}
