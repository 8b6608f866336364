//! Pictures in words, for a reader who does not see them: the same givens, and no more.

use super::spheres::{Body, Motion, Spheres};
use super::{Point, Text};
use crate::expr::{Expr, print};
use crate::mechanics::{Moment, Sphere};

/// Two touching spheres in words.
pub fn in_words(spheres: &Spheres, moment: Moment) -> String {
    let mut words = format!(
        "Two spheres seen from above as they touch. The line of centres runs {}, from A to B.",
        towards(spheres.line)
    );
    if spheres.axes {
        words.push_str(" The unit vector i points to the right and j up the page.");
    }
    for sphere in Sphere::BOTH {
        words.push(' ');
        words.push_str(&body(sphere, &spheres.bodies[sphere as usize], moment));
    }
    if let Some(positive) = spheres.positive {
        words.push_str(&format!(" The positive direction is {}.", towards(positive)));
    }
    words
}

fn body(sphere: Sphere, body: &Body, moment: Moment) -> String {
    let name = sphere.name();
    let mass = body.mass.as_ref().map(|mass| format!(", of mass {},", print::text_unicode(mass))).unwrap_or_default();
    let when = if moment == Moment::Before { "before" } else { "after" };
    let subject = format!("Immediately {when} the impact {name}{mass}");
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
            let parts: Vec<String> = motions.iter().map(whole).collect();
            format!("{subject} moves {}.", parts.join(" and "))
        }
    }
}

fn component(motion: &Motion) -> String {
    format!("{} {}", print::text_unicode(&motion.label), towards(motion.heading))
}

fn whole(motion: &Motion) -> String {
    let angle = |angle: &Text| format!(", at an angle of {} to the line of centres", print::text_unicode(angle));
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
