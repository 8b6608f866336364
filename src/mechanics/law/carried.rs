//! A sphere comes to its next impact with the velocity that the last one left it.

use smallvec::smallvec;

use super::{Datum, Here, Law, Line, Outcome, Rule, Seen, Shape, Show, Slip, number, rule, silent};
use crate::expr::Expr;
use crate::mechanics::later::Meeting;
use crate::mechanics::{Axis, Moment, Quantity};
use crate::number::Number;

pub const NAME: &str = "carried over";

pub const SEEN: Seen = Seen::Value(&[], Shape::Any);

pub const ACCURACY: &str = "the velocity that the impact before has left";

pub const METHOD: (&str, &str) = ("velocity after one impact used as that before the next", "condone its sign");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 55,
        tag: "velocity-not-carried",
        did: "started the next impact with a velocity from before the last one",
        sentence: "An impact starts with the velocities that the one before has left: look which sphere has been struck already.",
        also: &[],
        condoned: false,
    },
];

/// The forms: along the one line of all spheres, or in the plane.
const IN_A_LINE: u8 = 0;
const IN_A_PLANE: u8 = 1;

/// Without later impacts there is nothing to carry.
pub fn rules() -> Vec<Rule> {
    Vec::new()
}

/// From each impact to the next of each sphere.
pub fn between(meetings: &[Meeting]) -> Vec<Rule> {
    let mut rules = Vec::new();
    for here in meetings.iter().filter(|meeting| meeting.number > 0) {
        for sphere in here.of.into_iter().filter(|sphere| here.part(*sphere).is_some()) {
            let Some(there) = here.last_of(sphere, meetings) else { continue };
            let of = |meeting: Meeting, moment, axis| {
                let part = meeting.part(sphere).unwrap_or(sphere);
                meeting.quantity(Quantity::Velocity(part, moment, axis))
            };
            let line = |meeting: Meeting| meeting.quantity(Quantity::Line(Axis::X));
            let along = [Quantity::InALine, of(there, Moment::After, Axis::N), line(there), line(*here)];
            let (before, after) = (Moment::Before, Moment::After);
            rules.push(rule(Law::Carried, IN_A_LINE, &along, &[of(*here, before, Axis::N)], 1));
            let both = |meeting, moment| [Axis::X, Axis::Y].map(|axis| of(meeting, moment, axis));
            rules.push(rule(Law::Carried, IN_A_PLANE, &both(there, after), &both(*here, before), 1));
        }
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    carried(rule, known, |quantity| quantity)
}

/// What is carried over, from another moment where a slip says so.
fn carried<N: Number>(rule: &Rule, known: &Here<N>, moment: impl Fn(Quantity) -> Quantity) -> Outcome<N> {
    let at = |place: usize| known.number(moment(rule.needs[place]));
    match rule.form {
        // The line of centres may point against i, and once this way and once that.
        IN_A_LINE => number(at(1)? * at(2)? * at(3)?),
        _ => Some(smallvec![Datum::Number(at(0)?), Datum::Number(at(1)?)]),
    }
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    match slip {
        "velocity-not-carried" => carried(rule, known, Quantity::before),
        _ => None,
    }
}

pub fn earning(_: &Rule, _: &Show) -> Option<Expr> {
    None
}

/// The next impact shows the velocities that it starts with.
pub fn lines(_: &Rule, _: &Show) -> Vec<Line> {
    silent()
}
