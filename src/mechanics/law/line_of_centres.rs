//! The impulse acts along the line of centres, so its direction is that line.
//!
//! `n = I_B/|I_B|`: what B receives points from A to B. A sphere's change of velocity has the direction of
//! the impulse that it receives.

use smallvec::smallvec;

use super::{Seen, Datum, Here, Law, Line, Outcome, Rule, Show, Slip, rule, velocity};
use crate::expr::Expr;
use crate::mechanics::Axis::{X, Y};
use crate::mechanics::Moment::{After, Before};
use crate::mechanics::{Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "line of centres";

pub const SEEN: Seen = Seen::AlongLine;

pub const ACCURACY: &str = "correct direction, any multiple";

pub const METHOD: (&str, &str) = ("line of centres parallel to the impulse", "any multiple of the vector");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 45,
        tag: "line-perpendicular",
        did: "took the line perpendicular to the impulse",
        sentence: "The impulse points along the line of centres, not across it.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 46,
        tag: "line-is-velocity",
        did: "took the path of A for the line of centres",
        sentence: "The line of centres is where the push acts: find the change of velocity of A, not its velocity.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 47,
        tag: "line-is-relative",
        did: "took the relative velocity for the line of centres",
        sentence: "The spheres may meet off centre: the line of centres has the direction of the change of velocity of A, not of the relative velocity.",
        also: &[],
        condoned: false,
    },
];

pub fn rules() -> Vec<Rule> {
    let line = [Quantity::Line(X), Quantity::Line(Y)];
    let mut rules = Vec::new();
    for sphere in [Sphere::A, Sphere::B] {
        let impulse = [Quantity::Impulse(sphere, X), Quantity::Impulse(sphere, Y)];
        // A form for each sphere; A's impulse is the one that an exam asks for.
        rules.push(rule(Law::LineOfCentres, sphere as u8, &impulse, &line, 1));
        // Without the mass the change of velocity has the same direction.
        let at = |moment, axis| velocity(sphere, moment, axis);
        let change = [at(Before, X), at(Before, Y), at(After, X), at(After, Y)];
        rules.push(rule(Law::LineOfCentres, BY_CHANGE + sphere as u8, &change, &line, 6));
    }
    rules
}

/// From the change of a velocity: added to the number of the sphere.
const BY_CHANGE: u8 = 2;

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let n = &rule.needs;
    let [x, y] = if rule.form < BY_CHANGE {
        known.numbers([n[0], n[1]])?
    } else {
        let [u_x, u_y, v_x, v_y] = known.numbers([n[0], n[1], n[2], n[3]])?;
        [v_x - u_x, v_y - u_y]
    };
    along(if rule.form % BY_CHANGE == Sphere::A as u8 { [-x, -y] } else { [x, y] })
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let before = |sphere| known.numbers([velocity(sphere, Before, X), velocity(sphere, Before, Y)]);
    match slip {
        "line-perpendicular" => {
            let outcome = evaluate(rule, known)?;
            let [Datum::Number(x), Datum::Number(y)] = outcome.as_slice() else { return None };
            Some(smallvec![Datum::Number(-y.clone()), Datum::Number(x.clone())])
        }
        "line-is-velocity" => along(before(Sphere::A)?),
        "line-is-relative" => {
            let [[a_x, a_y], [b_x, b_y]] = [before(Sphere::A)?, before(Sphere::B)?];
            along([a_x - b_x, a_y - b_y])
        }
        _ => None,
    }
}

/// The unit vector along a vector.
fn along<N: Number>([x, y]: [N; 2]) -> Outcome<N> {
    let size = (x.squared() + y.squared()).root()?;
    Some(smallvec![Datum::Number(x.over(&size)?), Datum::Number(y.over(&size)?)])
}

/// The direction.
pub fn earning(_: &Rule, show: &Show) -> Option<Expr> {
    Some(show.line_direction())
}

pub fn lines(_: &Rule, show: &Show) -> Vec<Line> {
    vec![Line::with(
        "The impulse acts along the line of centres, so the line of centres is parallel to {n}.",
        &[("n", show.line_direction())],
        vec![],
    )]
}
