//! Pictures in words, for a reader who does not see them: the same givens, and no more.

use super::corner::{Between, Other, Way};
use super::particle::Particle;
use super::spheres::{Body, Motion, Spheres};
use super::wall::AtWall;
use super::{Point, Text};
use crate::expr::{Expr, print};
use crate::mechanics::{Moment, Sphere};

const UNIT_VECTORS: &str = " The unit vector i points to the right and j up the page.";

/// Two spheres in words.
pub fn in_words(spheres: &Spheres, moment: Moment) -> String {
    let [a, b] = spheres.names.map(Sphere::name);
    let mut words = if spheres.apart {
        let [left, right] = spheres.beyond.each_ref().map(|beyond| beyond.sphere.as_ref().map(|(name, _)| name.name()));
        match (left, right) {
            (None, None) => format!("Two spheres on one straight line, {a} to the left of {b}."),
            (None, Some(c)) => format!("Three spheres on one straight line, from left to right {a}, {b} and {c}."),
            (Some(c), _) => format!("Three spheres on one straight line, from left to right {c}, {a} and {b}."),
        }
    } else {
        let line = towards(spheres.line);
        format!("Two spheres seen from above as they touch. The line of centres runs {line}, from {a} to {b}.")
    };
    if spheres.axes {
        words.push_str(UNIT_VECTORS);
    }
    let two = Sphere::BOTH.map(|sphere| (spheres.names[sphere as usize], &spheres.bodies[sphere as usize]));
    let third = spheres.beyond.iter().filter_map(|beyond| beyond.sphere.as_ref());
    for (name, of) in two.into_iter().chain(third.map(|(name, of)| (*name, of))) {
        let sentence = body(name, of, moment, "impact", "the line of centres");
        words.extend([" ", &sentence].into_iter().filter(|_| !sentence.is_empty()));
    }
    for (beyond, (nearest, side)) in spheres.beyond.iter().zip([(a, "left"), (b, "right")]) {
        let last = beyond.sphere.as_ref().map_or(nearest, |(name, _)| name.name());
        match beyond.wall {
            Some(_) if spheres.apart => {
                words.push_str(&format!(" A wall stands to the {side} of {last}, across the line."));
            }
            Some(inward) => {
                let (runs, lies) = (runs(inward), towards(inward));
                words.push_str(&format!(" A wall runs {runs}; from {last} it lies {lies}."));
            }
            None => {}
        }
    }
    if let Some(positive) = spheres.positive {
        words.push_str(&format!(" The positive direction is {}.", towards(positive)));
    }
    words
}

/// A sphere at a wall in words.
pub fn at_wall_in_words(picture: &AtWall, moment: Moment) -> String {
    let wall = |inward| format!("runs {}; from the sphere it lies {}.", runs(inward), towards(inward));
    let here = wall(picture.inward);
    let mut words = match &picture.other {
        None => format!("A sphere touches a fixed wall, seen from above. The wall {here}"),
        Some(Other { inward, names: [touched, other], between, .. }) => {
            let there = wall(*inward);
            let mut words = format!(
                "Two fixed walls, seen from above. A sphere touches the {touched}. The {touched} {here} The {other} {there}"
            );
            match between {
                Between::Right => words.push_str(" The walls meet at a right angle."),
                Between::Angle(angle) => {
                    words.push_str(&format!(" The walls meet at an angle of {}.", print::text_unicode(angle)));
                }
                Between::Unsaid => {}
            }
            words
        }
    };
    if picture.axes {
        words.push_str(UNIT_VECTORS);
    }
    let sentence = body(picture.name, &picture.body, moment, "impact", "the wall");
    words.extend([" ", &sentence].into_iter().filter(|_| !sentence.is_empty()));
    if let Some(way) = &picture.way {
        words.push_str(&on_its_way(picture, way));
    }
    words
}

/// Where the sphere goes from a wall, and from another one.
fn on_its_way(picture: &AtWall, way: &Way) -> String {
    let name = picture.name.name();
    let at = |angle: Option<&Expr>, wall: &str| {
        angle.map(|angle| format!(", at an angle of {} to the {wall}", print::unicode(angle))).unwrap_or_default()
    };
    let (touched, to) = match &picture.other {
        Some(other) => (other.names[0].as_str(), format!(", to the {}", other.names[1])),
        None => ("wall", String::new()),
    };
    let from_it = at(way.angle.as_ref(), touched);
    let mut words = format!(" From there {name} moves {}{from_it}{to}.", towards(way.heading));
    if let (Some(other), Some((onwards, angle))) = (&picture.other, &way.onwards) {
        let from_it = at(Some(angle), &other.names[1]);
        words.push_str(&format!(" From the {} it moves {}{from_it}.", other.names[1], towards(*onwards)));
    }
    words
}

/// How a wall runs, by the direction towards it.
fn runs(inward: Point) -> &'static str {
    let wall = inward.turned();
    match (wall.x * wall.y, wall.x.abs() < 1e-9) {
        (_, true) => "up the page",
        (slope, _) if slope.abs() < 1e-9 => "from left to right",
        (slope, _) if slope > 0.0 => "from the left up to the right",
        _ => "from the left down to the right",
    }
}

/// A particle in words, with the impulse that it receives.
pub fn particle_in_words(picture: &Particle, moment: Moment) -> String {
    let mut words = "A particle A seen from above.".to_owned();
    if picture.axes {
        words.push_str(UNIT_VECTORS);
    }
    let sentence = body(Sphere::A, &picture.body, moment, "impulse", "its old path");
    words.extend([" ", &sentence].into_iter().filter(|_| !sentence.is_empty()));
    if let Some((direction, label)) = &picture.impulse {
        words.push_str(&format!(" The impulse on A is {} {}.", print::text_unicode(label), towards(*direction)));
    }
    words
}

/// What happens to one body: immediately before or after what, and with what its angles are.
fn body(sphere: Sphere, body: &Body, moment: Moment, event: &str, reference: &str) -> String {
    let name = sphere.name();
    let mass = body.mass.as_ref().map(|mass| format!(", of mass {},", print::text_unicode(mass))).unwrap_or_default();
    let when = if moment == Moment::Before { "before" } else { "after" };
    let subject = format!("Immediately {when} the {event} {name}{mass}");
    if body.at_rest {
        return format!("{subject} is at rest.");
    }
    match &body.motions[..] {
        [] if mass.is_empty() => String::new(),
        [] => format!("{name} has mass {}.", body.mass.as_ref().map(print::text_unicode).unwrap_or_default()),
        motions if motions.iter().any(|motion| motion.component) => {
            let parts: Vec<String> = motions.iter().map(component).collect();
            format!("{subject} has velocity {}.", parts.join(" and "))
        }
        motions => {
            let parts: Vec<String> = motions.iter().map(|motion| whole(motion, reference)).collect();
            format!("{subject} moves {}.", parts.join(" and "))
        }
    }
}

fn component(motion: &Motion) -> String {
    format!("{} {}", print::text_unicode(&motion.label), towards(motion.heading))
}

fn whole(motion: &Motion, reference: &str) -> String {
    let angle = |angle: &Text| format!(", at an angle of {} to {reference}", print::text_unicode(angle));
    format!(
        "with {} {} {}{}",
        if motion.angle.is_some() || !is_vector(&motion.label) { "speed" } else { "velocity" },
        print::text_unicode(&motion.label),
        towards(motion.heading),
        motion.angle.as_ref().map(angle).unwrap_or_default()
    )
}

/// A vector has its direction in it.
fn is_vector(label: &Text) -> bool {
    label.names().iter().any(|name| matches!(name.text.as_str(), "i" | "j"))
        || label.formulas().iter().any(|formula| matches!(formula, Expr::Vector(..)))
}

/// A direction as one reads it off a page.
pub fn towards(direction: Point) -> &'static str {
    let sign = |coordinate: f64| {
        if coordinate.abs() < 1e-9 {
            0
        } else if coordinate > 0.0 {
            1
        } else {
            -1
        }
    };
    match (sign(direction.x), sign(direction.y)) {
        (1, 0) => "to the right",
        (-1, 0) => "to the left",
        (0, 1) => "up the page",
        (0, -1) => "down the page",
        (1, 1) => "to the right and up the page",
        (1, -1) => "to the right and down the page",
        (-1, 1) => "to the left and up the page",
        (-1, -1) => "to the left and down the page",
        _ => "nowhere",
    }
}
