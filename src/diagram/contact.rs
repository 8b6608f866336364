//! Where the spheres touch: the path of A, the distance of B's centre from it, and the triangle of the centres.

use super::canvas::{Canvas, Spot};
use super::drawing::{Point, Style};
use super::given::{components, mass, speed};
use super::illustration::{direction, measure};
use super::spots::{around, beside, inside};
use super::words::towards;
use super::{Diagram, Manner, formula};
use crate::expr::{Expr, Text, print};
use crate::mechanics::{Given, Known, Moment, Quantity, Scene, Show, Sphere};
use crate::number::Value;
use crate::unit::Unit;

/// Radius of a sphere: larger than elsewhere, for the triangle lies within the spheres.
const RADIUS: f64 = 3.0;
/// How far before the impact A is drawn in a question.
const BEFORE: f64 = 4.4;
/// Length of the arrow of a velocity.
const ARROW: f64 = 3.0;
/// Radius of the arc of an angle.
const ANGLE: f64 = 1.3;
/// How far beyond B's centre its distance from the path is measured off.
const OUTSIDE: f64 = RADIUS + 1.6;
/// The corner that marks a right angle.
const CORNER: f64 = 0.4;

/// Where things are when the spheres touch: B's centre is the origin.
struct Touch {
    /// The direction in which A moves.
    path: Point,
    /// A's centre.
    a: Point,
    /// The point of A's path nearest to B's centre.
    foot: Point,
}

/// The impact of A on B at rest; no picture is drawn where both move, for then the offset is that of a relative path.
fn touch(scene: &Scene, known: &Known<Value>) -> Option<Touch> {
    let [a, b] = [Sphere::A, Sphere::B].map(|sphere| scene.velocity(sphere, Moment::Before).map(components));
    let ((x, y), (b_x, b_y)) = (a?, b?);
    if !(b_x.is_zero() && b_y.is_zero()) {
        return None;
    }
    let path = direction(&x, &y)?;
    let sine = measure(&known.number(Quantity::ContactSine)?)?;
    let foot = path.turned() * (-sine * 2.0 * RADIUS);
    let a = foot - path * ((1.0 - sine * sine).max(0.0).sqrt() * 2.0 * RADIUS);
    Some(Touch { path, a, foot })
}

fn speed_of_a(scene: &Scene) -> Option<Expr> {
    let velocity = scene.velocity(Sphere::A, Moment::Before)?;
    let (x, y) = components(velocity);
    speed(velocity, &x, &y, &Expr::integer(0))
}

/// The distance as a length.
fn without_sign(offset: &Given) -> Expr {
    let negative = offset.value.sign().is_some_and(|sign| sign.is_lt());
    if negative { offset.shown.clone().negated() } else { offset.shown.clone() }
}

/// The figure of a question: A on its way, and the distance of B's centre from the path.
pub fn path(
    scene: &Scene,
    known: &Known<Value>,
    offset: &Given,
    radii: &[Given; 2],
    manner: Manner,
) -> Option<Diagram> {
    let touch = touch(scene, known)?;
    let Touch { path, foot, .. } = touch;
    let a = touch.a - path * BEFORE;
    let b = Point::default();
    let distance = formula(without_sign(offset));
    let speed = manner.quantity(&speed_of_a(scene)?, Unit::MetrePerSecond);
    let [mass_a, mass_b] = Sphere::BOTH.map(|sphere| mass(scene, sphere, manner));
    let side = if (foot - b).dot(path.turned()) > 0.0 { path.turned() } else { -path.turned() };

    let mut canvas = Canvas::default();
    canvas.line(Style::Dashed, a, foot + path * OUTSIDE);
    for centre in [a, b] {
        canvas.circle(Style::Rim, centre, RADIUS);
        canvas.dot(centre);
    }
    let tip = a + path * (RADIUS + ARROW);
    canvas.arrow(Style::Velocity, a + path * RADIUS, tip);
    let spoke = (path - side * 1.5).unit();
    canvas.line(Style::Thin, b, b + spoke * RADIUS);
    dimension(&touch, offset, &mut canvas);
    canvas.label(formula(radii[1].shown.clone()), beside(b, b + spoke * RADIUS, path));
    canvas.label(speed.clone(), beside(a + path * RADIUS, tip, side));
    names([(a, -side), (b, -side)], path, &mut canvas);
    for (centre, mass, first) in [(a, &mass_a, side), (b, &mass_b, -side)] {
        if let Some(mass) = mass {
            canvas.label(mass.clone(), around(centre, RADIUS, first, path));
        }
    }
    canvas.label(Text::words("at rest"), around(b, RADIUS, -side, path));
    let words = format!(
        "Two spheres seen from above, before they touch. {} is at rest. {} moves {} with speed {} along a straight line. The \
         perpendicular distance from the centre of B to the line along which the centre of A moves is {}. The radius of A is \
         {} and the radius of B is {}.",
        named("B", mass_b.as_ref()),
        named("A", mass_a.as_ref()),
        towards(path),
        print::text_unicode(&speed),
        print::text_unicode(&distance),
        print::unicode(&radii[0].shown),
        print::unicode(&radii[1].shown),
    );
    Some(Diagram { title: String::new(), drawing: canvas.finish(), words })
}

/// The triangle of the centres as the spheres touch, for a solution.
pub fn triangle(scene: &Scene, known: &Known<Value>, offset: &Given, sum: &Given) -> Option<Diagram> {
    let touch = touch(scene, known)?;
    let Touch { path, a, foot } = touch;
    let b = Point::default();
    let angle = Expr::name(Show::new(scene, known, &[]).contact_angle());
    let distance = without_sign(offset);
    let line = (b - a).unit();
    let side = if foot.dot(path.turned()) > 0.0 { path.turned() } else { -path.turned() };

    let mut canvas = Canvas::default();
    canvas.line(Style::Centres, a - line * (RADIUS + 1.4), b + line * (RADIUS + 1.4));
    canvas.line(Style::Dashed, a - path * (RADIUS + 1.4), foot + path * OUTSIDE);
    for centre in [a, b] {
        canvas.circle(Style::Rim, centre, RADIUS);
        canvas.dot(centre);
    }
    let arc = (!is_head_on(offset)).then(|| {
        corner(&touch, &mut canvas);
        dimension(&touch, offset, &mut canvas);
        canvas.arc(a, ANGLE, path, line)
    });
    let away = if line.turned().dot(side) < 0.0 { line.turned() } else { -line.turned() };
    let shares = [0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2].map(|share| a + (b - a) * share);
    let spots = [away, -away].into_iter().flat_map(|across| shares.map(|point| Spot::new(point, across)));
    canvas.label(formula(sum.shown.clone()), spots);
    if let Some(middle) = arc {
        let within = [0.0, 0.4, 0.8, 1.2].map(|step| Spot::new(a + middle * (ANGLE + step), middle));
        // Beside a narrow angle: beyond the path.
        let aside = [1.0, 1.5, 2.0].map(|share| Spot::new(a + path * (ANGLE * share), side));
        canvas.label(formula(angle.clone()), within.into_iter().chain(aside));
    }
    names([(a, side), (b, -side)], -path, &mut canvas);
    let words = format!(
        "The spheres as they touch. The centre of A, the centre of B and the foot of the perpendicular from the centre of B \
         to the path of A are the corners of a right-angled triangle. Its hypotenuse is {}, the side opposite the angle {} \
         at the centre of A is {}.",
        print::unicode(&sum.shown),
        print::unicode(&angle),
        print::unicode(&distance),
    );
    Some(Diagram { title: "At the impact".to_owned(), drawing: canvas.finish(), words })
}

fn named(name: &str, mass: Option<&Text>) -> String {
    match mass {
        Some(mass) => format!("Sphere {name}, of mass {},", print::text_unicode(mass)),
        None => format!("Sphere {name}"),
    }
}

fn is_head_on(offset: &Given) -> bool {
    offset.value.is_zero()
}

/// The perpendicular from B's centre to the path, with its right angle.
fn corner(touch: &Touch, canvas: &mut Canvas) {
    let Touch { path, foot, .. } = *touch;
    canvas.line(Style::Thin, Point::default(), foot);
    let up = -foot.unit();
    if foot.length() > CORNER {
        canvas.line(Style::Thin, foot + path * CORNER, foot + (path + up) * CORNER);
        canvas.line(Style::Thin, foot + up * CORNER, foot + (path + up) * CORNER);
    }
}

/// The distance of B's centre from the path, measured off outside of B, where there is room for any distance.
fn dimension(touch: &Touch, offset: &Given, canvas: &mut Canvas) {
    if is_head_on(offset) {
        return;
    }
    let Touch { path, foot, .. } = *touch;
    let out = path * (OUTSIDE - 0.5);
    canvas.line(Style::Dashed, Point::default(), path * OUTSIDE);
    canvas.line(Style::Thin, out, foot + out);
    let label = Spot::new(path * OUTSIDE + foot * 0.5, path);
    canvas.label(formula(without_sign(offset)), [label]);
}

fn names(centres: [(Point, Point); 2], along: Point, canvas: &mut Canvas) {
    for (name, (centre, side)) in ["A", "B"].into_iter().zip(centres) {
        canvas.label(formula(Expr::name(name)), inside(centre, RADIUS, side, along));
    }
}
