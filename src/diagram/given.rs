//! The figure of a question: what is given, and nothing else.

use super::corner::Way;
use super::illustration::{direction, measure};
use super::particle::Particle;
use super::spheres::{Beyond, Body, Motion, Spheres};
use super::wall::AtWall;
use super::walls::Walls;
use super::words::{at_wall_in_words, in_words, particle_in_words};
use super::{Diagram, Manner, Point, contact, formula};
use crate::expr::{Expr, Relation, Text, number, written, written_angle};
use crate::mechanics::{
    self, Axis, Condition, Contact, Derivation, Known, Meeting, Moment, Quantity, Scene, Setting, Sphere, Then,
    Velocity, pose,
};
use crate::number::{Angle, Value};
use crate::unit::Unit;

/// The pictures of what a scene gives: the spheres as they touch, or the path of A and its distance from B; spheres on one
/// line; a sphere at a wall; a particle with its impulse. There are none where the line of centres is to be found: to
/// draw it would be to give it away. What is given after the impact has a picture of its own. Of several impacts it is the
/// first that is given.
pub fn given(scene: &Scene, manner: Manner) -> Vec<Diagram> {
    let mut pictures = of_first(scene, manner);
    if let ([picture], false) = (pictures.as_mut_slice(), scene.then.is_empty()) {
        picture.title = "Before the first impact".to_owned();
    }
    pictures
}

fn of_first(scene: &Scene, manner: Manner) -> Vec<Diagram> {
    let Ok(known) = pose(scene) else { return Vec::new() };
    let given = Given { scene, known: &known, manner };
    // What stands in the place of B is no sphere with a velocity.
    let spheres = if scene.setting.is_of_one() { &Sphere::BOTH[..1] } else { &Sphere::BOTH };
    let is_given = |moment| spheres.iter().any(|sphere| scene.velocity(*sphere, moment).is_some());
    let each = |picture: &dyn Fn(Moment) -> Option<Diagram>| {
        let both: Vec<Moment> =
            [Moment::Before, Moment::After].into_iter().filter(|moment| is_given(*moment)).collect();
        match &both[..] {
            [Moment::Before] => picture(Moment::Before).into_iter().collect(),
            several => several.iter().filter_map(|moment| Some(titled(*moment, picture(*moment)?))).collect(),
        }
    };
    match (scene.setting, &scene.contact) {
        (Setting::Direct, _) => each(&|moment| given.in_line(moment)),
        (Setting::Wall, _) => each(&|moment| given.at_wall(moment)),
        (Setting::Impulse, _) => given.particle(),
        (Setting::Oblique, Some(Contact::Along(..))) => given.touching().into_iter().collect(),
        (Setting::Oblique, Some(Contact::Offset { offset, radii, .. })) => {
            contact::path(scene, &known, offset, radii, manner).into_iter().collect()
        }
        (Setting::Oblique, _) => Vec::new(),
    }
}

/// A picture with the moment above it.
pub fn titled(moment: Moment, diagram: Diagram) -> Diagram {
    let title = if moment == Moment::Before { "Before" } else { "After" };
    Diagram { title: title.to_owned(), ..diagram }
}

/// A scene as its question gives it.
struct Given<'a> {
    scene: &'a Scene,
    known: &'a Known<Value>,
    manner: Manner<'a>,
}

impl Given<'_> {
    fn touching(&self) -> Option<Diagram> {
        let line = line_of_centres(self.known)?;
        let mut bodies = [Body::default(), Body::default()];
        for sphere in Sphere::BOTH {
            bodies[sphere as usize] = self.body(sphere, Moment::Before)?;
        }
        let axes = self.manner.vectors;
        // A wall stands beyond whoever strikes it next.
        let mut beyond: [Beyond; 2] = Default::default();
        let wall = Walls::of(self.scene, self.known).known(1).and_then(line_of_centres);
        if let Some(then) = self.scene.then.first().filter(|_| wall.is_some()) {
            beyond[usize::from(then.meeting.of[0] != Sphere::A)].wall = wall;
        }
        let spheres =
            Spheres { line, apart: false, named: true, names: Sphere::BOTH, bodies, beyond, axes, positive: None };
        let words = in_words(&spheres, Moment::Before);
        Some(Diagram { title: String::new(), drawing: spheres.draw(), words })
    }

    /// Two spheres that move along one line, and what stands further along it.
    fn in_line(&self, moment: Moment) -> Option<Diagram> {
        let line = Point::new(1.0, 0.0);
        let body =
            |sphere| self.along(mass(self.scene, sphere, self.manner), self.scene.velocity(sphere, moment), line);
        let bodies = [body(Sphere::A)?, body(Sphere::B)?];
        let beyond = if moment == Moment::Before { self.beyond(line)? } else { Default::default() };
        let names = Sphere::BOTH;
        let spheres = Spheres { line, apart: true, named: false, names, bodies, beyond, axes: false, positive: None };
        let words = in_words(&spheres, moment);
        Some(Diagram { title: String::new(), drawing: spheres.draw(), words })
    }

    /// A sphere that moves along a line.
    fn along(&self, mass: Option<Text>, velocity: Option<&Velocity>, line: Point) -> Option<Body> {
        let mut body = Body { mass, ..Body::default() };
        if let Some(Velocity::Components(along, _)) = velocity {
            body.at_rest = along.value.is_zero();
            if !body.at_rest {
                let backwards = measure(&along.value)? < 0.0;
                let shown = if backwards { along.shown.clone().negated() } else { along.shown.clone() };
                let heading = if backwards { -line } else { line };
                let label = self.manner.quantity(&shown, Unit::MetrePerSecond);
                body.motions = vec![Motion { heading, label, angle: None, component: true, leaving: false }];
            }
        }
        Some(body)
    }

    /// What is struck later: nobody passes another, so that it stands on the side of whoever strikes it first.
    fn beyond(&self, line: Point) -> Option<[Beyond; 2]> {
        let mut beyond: [Beyond; 2] = Default::default();
        for Then { meeting, scene } in &self.scene.then {
            let third = Sphere::C;
            let side = |sphere: Sphere, beyond: &[Beyond; 2]| match sphere {
                Sphere::C => usize::from(beyond[1].sphere.is_some()),
                sphere => sphere as usize,
            };
            match (meeting.with_wall, meeting.of.iter().position(|sphere| *sphere == third)) {
                (true, _) => {
                    let place = side(meeting.of[0], &beyond);
                    beyond[place].wall = Some(if place == 0 { -line } else { line });
                }
                (false, Some(place)) if beyond.iter().all(|beyond| beyond.sphere.is_none()) => {
                    let mass = scene.masses[place].as_ref();
                    let mass = mass.map(|mass| self.manner.quantity(&mass.shown, Unit::Kilogram));
                    let body = self.along(mass, scene.before[place].as_ref(), line)?;
                    beyond[meeting.of[1 - place] as usize].sphere = Some((third, body));
                }
                _ => {}
            }
        }
        Some(beyond)
    }

    fn at_wall(&self, moment: Moment) -> Option<Diagram> {
        let inward = line_of_centres(self.known)?;
        let body = self.body(Sphere::A, moment)?;
        let other = Walls::of(self.scene, self.known).other(0, self.manner).filter(|_| moment == Moment::Before);
        let way = self.way(other.is_some()).or_else(|| self.given_way()).filter(|_| moment == Moment::Before);
        let picture = AtWall { inward, name: Sphere::A, body, axes: self.manner.vectors, other, way };
        let words = at_wall_in_words(&picture, moment);
        Some(Diagram { title: String::new(), drawing: picture.draw(), words })
    }

    /// The way from the wall: to another one, or if its angle has a letter.
    fn way(&self, to_another: bool) -> Option<Way> {
        let letter = |impact| {
            let lettered = self.manner.after_walls.iter().find(|(number, _)| *number == impact);
            lettered.map(|(_, letter)| letter.clone())
        };
        if !to_another && letter(0).is_none() {
            return None;
        }
        let mut known = self.known.clone();
        let mut leads = |meeting: Meeting| {
            let after =
                [Axis::X, Axis::Y].map(|axis| meeting.quantity(Quantity::Velocity(Sphere::A, Moment::After, axis)));
            Derivation::carry_out(&mut known, &after);
            let [x, y] = after.map(|component| known.number(component));
            direction(&x?, &y?)
        };
        let heading = leads(Meeting::FIRST)?;
        let second = self.scene.then.first().filter(|_| to_another).map(|then| then.meeting);
        let onwards = second.and_then(|second| Some((leads(second)?, letter(second.number)?)));
        Some(Way { heading, angle: letter(0), onwards })
    }

    /// The way from the wall where its angle is given, and has a letter.
    fn given_way(&self) -> Option<Way> {
        let asked = Quantity::TanToWall(Sphere::A, Moment::After);
        let given = |condition: &Condition| match (&condition.left, condition.relation) {
            (Expr::Name(name), Relation::Equal) if name.text.parse() == Ok(asked) => {
                number(&condition.right, &|_| None).ok()
            }
            _ => None,
        };
        let tangent = self.scene.conditions.iter().find_map(given)?;
        let (letter, _) = self.manner.angles.iter().find(|(_, named)| (named - &tangent).is_zero())?;
        let (x, y) = components(self.scene.velocity(Sphere::A, Moment::Before)?);
        let (inward, before) = (line_of_centres(self.known)?, direction(&x, &y)?);
        let along = (before - inward * before.dot(inward)).unit();
        let heading = (along - inward * measure(&tangent)?).unit();
        Some(Way { heading, angle: Some(letter.clone()), onwards: None })
    }

    /// The particle with its velocity and its impulse; its velocity after, where that is given, by itself.
    fn particle(&self) -> Vec<Diagram> {
        let picture = |moment, impulse: Option<(Point, Text)>, axes| {
            let body = self.body(Sphere::A, moment)?;
            if body.motions.is_empty() && !body.at_rest && impulse.is_none() {
                return None;
            }
            let picture = Particle { body, impulse, axes };
            let words = particle_in_words(&picture, moment);
            Some(Diagram { title: String::new(), drawing: picture.draw(), words })
        };
        let axes = self.manner.vectors;
        let before = picture(Moment::Before, given_impulse(self.scene, self.manner), axes);
        let Some(after) = picture(Moment::After, None, axes && before.is_none()) else {
            return before.into_iter().collect();
        };
        let is_moving = self.scene.velocity(Sphere::A, Moment::Before).is_some();
        let title = if is_moving { "Before" } else { "The impulse" };
        let before = before.map(|diagram| Diagram { title: title.to_owned(), ..diagram });
        before.into_iter().chain([titled(Moment::After, after)]).collect()
    }

    /// A sphere with its mass and its velocity, as they are given.
    fn body(&self, sphere: Sphere, moment: Moment) -> Option<Body> {
        let mass = mass(self.scene, sphere, self.manner);
        Some(Body { mass, ..self.moving(sphere, moment)? })
    }

    fn moving(&self, sphere: Sphere, moment: Moment) -> Option<Body> {
        let Some(velocity) = self.scene.velocity(sphere, moment) else { return Some(Body::default()) };
        let (x, y) = components(velocity);
        if x.is_zero() && y.is_zero() {
            return Some(Body { at_rest: true, ..Body::default() });
        }
        let heading = direction(&x, &y)?;
        let leaving = moment == Moment::After;
        let motion = |label, angle| Motion { heading, label, angle, component: false, leaving };
        let in_vectors = self.manner.vectors
            || (self.scene.setting == Setting::Impulse && matches!(velocity, Velocity::Components(..)));
        let motions = if in_vectors {
            let vector = match velocity {
                Velocity::Components(x, y) => vector(x, y),
                Velocity::Polar { .. } => Expr::Vector(Box::new(written(&x)), Box::new(written(&y))),
            };
            vec![motion(self.manner.quantity(&vector, Unit::MetrePerSecond), None)]
        } else if let (Setting::Impulse, Velocity::Polar { speed, .. }) = (self.scene.setting, velocity) {
            vec![motion(self.manner.quantity(&speed.shown, Unit::MetrePerSecond), None)]
        } else {
            let at = |axis| self.known.number(Quantity::Line(axis));
            let (n_x, n_y) = (at(Axis::X)?, at(Axis::Y)?);
            let along = &(&x * &n_x) + &(&y * &n_y);
            let across = &(&y * &n_x) - &(&x * &n_y);
            // With the line of centres, or with the wall, which lies across it.
            let angle = match self.scene.setting {
                Setting::Wall => Angle::acute(&along, &across)?,
                _ => Angle::acute(&across, &along)?,
            };
            let (name, angle) = (self.manner.angle(&angle), written_angle(&angle));
            let slants = !across.is_zero() && (self.scene.setting != Setting::Wall || !along.is_zero());
            match speed(velocity, &x, &y, &angle) {
                Some(speed) => {
                    let label = self.manner.quantity(&speed, Unit::MetrePerSecond);
                    vec![motion(label, Some(formula(name)).filter(|_| slants))]
                }
                None => {
                    let motions =
                        by_components(velocity, [&along, &across], line_of_centres(self.known)?, self.manner)?;
                    motions.into_iter().map(|motion| Motion { leaving, ..motion }).collect()
                }
            }
        };
        Some(Body { motions, ..Body::default() })
    }
}

/// A vector as its components are given; letters in them as one would write them down.
fn vector(x: &mechanics::Given, y: &mechanics::Given) -> Expr {
    let shown = |given: &mechanics::Given| match given.value.is_constant() {
        true => given.shown.clone(),
        false => written(&given.value),
    };
    Expr::Vector(Box::new(shown(x)), Box::new(shown(y)))
}

/// The direction of the impulse as it is given, and the impulse.
fn given_impulse(scene: &Scene, manner: Manner) -> Option<(Point, Text)> {
    let [x, y] = scene.impulse.as_ref()?;
    let vector = vector(x, y);
    Some((direction(&x.value, &y.value)?, manner.quantity(&vector, Unit::NewtonSecond)))
}

/// The unit vector from A to B, as it is drawn.
pub fn line_of_centres(known: &Known<Value>) -> Option<Point> {
    direction(&known.number(Quantity::Line(Axis::X))?, &known.number(Quantity::Line(Axis::Y))?)
}

/// The mass of a sphere, as it is given.
pub fn mass(scene: &Scene, sphere: Sphere, manner: Manner) -> Option<Text> {
    Some(manner.quantity(&scene.mass(sphere)?.shown, Unit::Kilogram))
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
