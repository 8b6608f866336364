//! The direction of a velocity, by its components along and across the line of centres or along i and j; and that of
//! an impulse, along i and j.
//!
//! `tan β = v_t/v_n`. The angle *to* the line is acute, 0 to 90 degrees; the angle *from* n or i is
//! signed, anticlockwise.

use smallvec::smallvec;

use super::{Shape, Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, components, first_equation, is_at_rest_before, number, rule, silent, velocity, with_inputs};
use crate::expr::{Expr, Function, print, written};
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};
use crate::number::{Angle, Number};

pub const NAME: &str = "direction";

pub const SEEN: Seen = Seen::Value(
    &[
        Quantity::AngleToLine(Sphere::A, Moment::After),
        Quantity::AngleToLine(Sphere::B, Moment::After),
        Quantity::TOverN(Sphere::A, Moment::After),
        Quantity::TOverN(Sphere::B, Moment::After),
        Quantity::AngleToWall(Sphere::A, Moment::After),
        Quantity::TanToWall(Sphere::A, Moment::After),
        Quantity::ImpulseAngle,
    ],
    Shape::Tangent,
);

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) = ("inverse tangent of their two components", "either way up; both components present");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 14,
        tag: "struck-inherits",
        did: "sent B off in the direction in which A was moving",
        sentence: "B was at rest and is pushed along the line of centres, so that is the way in which it moves off.",
        also: &[Law::Resolve],
        condoned: false,
    },
    Slip {
        place: 23,
        tag: "angle-complement",
        did: "divided the components the other way up",
        sentence: "That is the angle with the common tangent; the angle with the line of centres is 90° minus that.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 25,
        tag: "deflection-for-direction",
        did: "gave the angle through which the path turned",
        sentence: "That is how far the path turned: a direction is measured from the line of centres.",
        also: &[],
        condoned: false,
    },
];

const TO_LINE: u8 = 0;
const FROM_N: u8 = 1;
const FROM_I: u8 = 2;
const SIZE_OF_TANGENT: u8 = 3;
const TANGENT: u8 = 4;
const TO_WALL: u8 = 5;
const TANGENT_TO_WALL: u8 = 6;
const OF_IMPULSE: u8 = 7;

pub fn rules() -> Vec<Rule> {
    let of_impulse = [X, Y].map(|axis| Quantity::Impulse(Sphere::A, axis));
    let mut rules = vec![rule(Law::Direction, OF_IMPULSE, &of_impulse, &[Quantity::ImpulseAngle], 1)];
    for sphere in Sphere::BOTH {
        for moment in [Moment::Before, Moment::After] {
            let n_t = [velocity(sphere, moment, N), velocity(sphere, moment, T)];
            let x_y = [velocity(sphere, moment, X), velocity(sphere, moment, Y)];
            let mut add = |form, needs: &[Quantity], gives| rules.push(rule(Law::Direction, form, needs, &[gives], 1));
            add(TO_LINE, &n_t, Quantity::AngleToLine(sphere, moment));
            add(FROM_N, &n_t, Quantity::AngleFromN(sphere, moment));
            add(FROM_I, &x_y, Quantity::AngleFromI(sphere, moment));
            add(SIZE_OF_TANGENT, &n_t, Quantity::TanToLine(sphere, moment));
            add(TANGENT, &n_t, Quantity::TOverN(sphere, moment));
            add(TO_WALL, &n_t, Quantity::AngleToWall(sphere, moment));
            add(TANGENT_TO_WALL, &n_t, Quantity::TanToWall(sphere, moment));
        }
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let [x, y] = known.numbers([rule.needs[0], rule.needs[1]])?;
    if matches!(rule.form, TO_LINE | FROM_N | FROM_I | TO_WALL | OF_IMPULSE) && x.is_nought() && y.is_nought() {
        // A sphere at rest has no direction.
        return None;
    }
    match rule.form {
        TO_LINE | OF_IMPULSE => Some(smallvec![Datum::Direction { y: y.size(), x: x.size() }]),
        FROM_N | FROM_I => Some(smallvec![Datum::Direction { y, x }]),
        TO_WALL => Some(smallvec![Datum::Direction { y: x.size(), x: y.size() }]),
        SIZE_OF_TANGENT => number(y.size().over(&x.size())?),
        TANGENT_TO_WALL => number(x.size().over(&y.size())?),
        _ => number(y.over(&x)?),
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    if slip == "angle-complement" {
        let [x, y] = known.numbers([rule.needs[0], rule.needs[1]])?;
        return with_inputs(rule, known, &[(rule.needs[0], y), (rule.needs[1], x)]);
    }
    let Quantity::Velocity(sphere, moment, _) = rule.needs[0] else { return None };
    match slip {
        "perpendicular-dropped" if rule.form != FROM_I && moment == Moment::After => {
            with_inputs(rule, known, &[(rule.needs[1], known.number(rule.needs[1])?.nought())])
        }
        "struck-inherits" if (sphere, moment) == (Sphere::B, Moment::After) && is_at_rest_before(known, sphere) => {
            let of_a = |need| match need {
                Quantity::Velocity(_, _, axis) => known.number(velocity(Sphere::A, Moment::Before, axis)),
                _ => None,
            };
            with_inputs(rule, known, &[(rule.needs[0], of_a(rule.needs[0])?), (rule.needs[1], of_a(rule.needs[1])?)])
        }
        "deflection-for-direction" if moment == Moment::After && rule.form != FROM_I => {
            let [a, p] = components(known, sphere, Moment::Before)?;
            let [x, y] = known.numbers([rule.needs[0], rule.needs[1]])?;
            let cross = (a.clone() * y.clone() - p.clone() * x.clone()).size();
            let dot = a * x + p * y;
            match rule.form {
                _ if cross.is_nought() && dot.is_nought() => None,
                // As it is: a deflection may be more than a right angle.
                TO_LINE | FROM_N | TO_WALL => Some(smallvec![Datum::Direction { y: cross, x: dot }]),
                _ => number(cross.over(&dot)?),
            }
        }
        _ => None,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    match rule.gives[0] {
        Quantity::AngleToLine(sphere, moment) => angle_to_line(show, sphere, moment),
        Quantity::AngleToWall(sphere, moment) => angle_to_wall(show, sphere, moment),
        Quantity::TanToWall(sphere, moment) => tangent_to_wall(show, sphere, moment),
        Quantity::ImpulseAngle => angle_of_impulse(show),
        Quantity::TOverN(sphere, moment) | Quantity::TanToLine(sphere, moment) => {
            tangent_of_direction(show, sphere, moment, rule.gives[0])
        }
        quantity => show.statement(quantity),
    }
}

/// The axis, of the two from which an acute angle may be measured, along which the direction is; then no tangent tells it.
fn of_an_axis(angle: &Angle) -> Option<Axis> {
    match angle.whole_degrees()?.as_small()? {
        (0, 1) => Some(X),
        (90, 1) => Some(Y),
        _ => None,
    }
}

/// The acute angle to the line of centres.
fn angle_to_line(show: &Show, sphere: Sphere, moment: Moment) -> Vec<Line> {
    let quantity = Quantity::AngleToLine(sphere, moment);
    let Some(angle) = show.angle(quantity) else { return silent() };
    let name = Expr::name(sphere.name());
    // Of a sphere whose components are not both there the speed has said so.
    let said = show.is_asked(Quantity::Speed(sphere, moment));
    match of_an_axis(&angle) {
        Some(_) if said => return silent(),
        Some(X) => return vec![Line::with("{A} moves along the line of centres.", &[("A", name)], vec![])],
        Some(_) => return vec![Line::with("{A} moves perpendicular to the line of centres.", &[("A", name)], vec![])],
        None => {}
    }
    let left = show.name("beta");
    let mut equations = vec![tangent_equation(show, sphere, moment, true)];
    equations.push(Expr::equation(left.clone(), Show::angle_expr(&angle)));
    equations.extend(Show::approximate_angle(&left, &angle));
    let words = "The path of {A} makes an angle {b} with the line of centres, where";
    vec![Line::with(words, &[("A", name), ("b", left)], equations)]
}

/// The acute angle of an impulse with i.
fn angle_of_impulse(show: &Show) -> Vec<Line> {
    let Some(angle) = show.angle(Quantity::ImpulseAngle) else { return silent() };
    match of_an_axis(&angle) {
        Some(X) => return vec![Line::with("The impulse is parallel to {i}.", &[], vec![])],
        Some(_) => return vec![Line::with("The impulse is perpendicular to {i}.", &[], vec![])],
        None => {}
    }
    let left = show.name("beta");
    let at = |axis| written(&show.exact(Quantity::Impulse(Sphere::A, axis)).absolute());
    let tangent = at(Y).over(at(X));
    let mut equations = vec![Expr::equation(Expr::call(Function::Tan, left.clone()), tangent)];
    equations.push(Expr::equation(left.clone(), Show::angle_expr(&angle)));
    equations.extend(Show::approximate_angle(&left, &angle));
    vec![Line::with("The impulse makes an acute angle {b} with {i}, where", &[("b", left)], equations)]
}

/// The acute angle to the wall.
fn angle_to_wall(show: &Show, sphere: Sphere, moment: Moment) -> Vec<Line> {
    let Some(angle) = show.angle(Quantity::AngleToWall(sphere, moment)) else { return silent() };
    let name = Expr::name(sphere.name());
    match of_an_axis(&angle) {
        Some(X) => return vec![Line::with("{A} moves along the wall.", &[("A", name)], vec![])],
        Some(_) => return vec![Line::with("{A} moves perpendicular to the wall.", &[("A", name)], vec![])],
        None => {}
    }
    let left = show.name("beta");
    let mut equations = vec![wall_tangent(show, sphere, moment)];
    equations.push(Expr::equation(left.clone(), Show::angle_expr(&angle)));
    equations.extend(Show::approximate_angle(&left, &angle));
    let words = "The path of {A} makes an angle {b} with the wall, where";
    vec![Line::with(words, &[("A", name), ("b", left)], equations)]
}

fn tangent_to_wall(show: &Show, sphere: Sphere, moment: Moment) -> Vec<Line> {
    if moment == Moment::Before && !show.is_asked(Quantity::TanToWall(sphere, moment)) {
        return silent();
    }
    let left = Expr::call(Function::Tan, show.name("beta"));
    let found = show.value(Quantity::TanToWall(sphere, moment));
    let words = "The path of {A} makes an angle {b} with the wall, where";
    let formulas = [("A", Expr::name(sphere.name())), ("b", show.name("beta"))];
    let quotient = wall_tangent(show, sphere, moment);
    vec![Line::with(words, &formulas, with_value(quotient, left, found))]
}

/// `tan β = v/p`, in numbers, β with the wall.
fn wall_tangent(show: &Show, sphere: Sphere, moment: Moment) -> Expr {
    let at = |axis| written(&show.worked(velocity(sphere, moment, axis)).absolute());
    let quotient = at(N).over(at(T));
    Expr::equation(Expr::call(Function::Tan, show.name("beta")), quotient)
}

/// `tan β = p/v`, in numbers.
fn tangent_equation(show: &Show, sphere: Sphere, moment: Moment, size: bool) -> Expr {
    let at = |axis| {
        let component = velocity(sphere, moment, axis);
        if !size {
            // The sign is that of n and t, whichever way the working goes.
            return written(&show.exact(component));
        }
        written(&show.worked(component).absolute())
    };
    let quotient = at(T).over(at(N));
    Expr::equation(Expr::call(Function::Tan, show.name("beta")), quotient)
}

/// An equation, and the value of its left side where that looks otherwise.
fn with_value(equation: Expr, left: Expr, value: Expr) -> Vec<Expr> {
    let found = Expr::equation(left, value);
    let is_seen = print::plain(&found) == print::plain(&equation);
    if is_seen { vec![equation] } else { vec![equation, found] }
}

fn tangent_of_direction(show: &Show, sphere: Sphere, moment: Moment, quantity: Quantity) -> Vec<Line> {
    // The path before makes an angle that is given; its tangent needs no line of its own.
    if moment == Moment::Before && !show.is_asked(quantity) {
        return silent();
    }
    let left = Expr::call(Function::Tan, show.name("beta"));
    let quotient = tangent_equation(show, sphere, moment, quantity == Quantity::TanToLine(sphere, moment));
    let equations = with_value(quotient, left, show.value(quantity));
    let words = match moment {
        Moment::Before => "The path of {A} makes an angle {b} with the line of centres, where",
        Moment::After => "The path of {A} then makes an angle {b} with the line of centres, where",
    };
    vec![Line::with(words, &[("A", Expr::name(sphere.name())), ("b", show.name("beta"))], equations)]
}
