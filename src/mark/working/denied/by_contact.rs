//! Where the spheres touch: after `sin α = r/r = 1` nothing right has come from the triangle of the centres.

use super::are_far;
use crate::mark::working::examine::{Studied, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::sizes;
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Contact, Datum, Known, Quantity, Sphere};

impl Working<'_> {
    /// Is the line of centres to be found from a distance, and do the lines say a sine that is plainly that of no angle in the
    /// question, and nowhere the right one?
    pub(super) fn is_contact_denied(&self) -> bool {
        let is_from_distance = matches!(self.question.scene.contact, Some(Contact::Offset { .. }));
        let right = sizes(&self.prepared.known, Quantity::ContactSine).filter(|_| is_from_distance);
        let Some(right) = right else { return false };
        let is_of_another = |own: &[f64]| {
            // B, which was at rest, moves along the line of centres: that is no angle of a triangle.
            let of_a = |quantity: &Quantity| quantity.sphere() == Some(Sphere::A);
            let angles = |known: &Known<f64>| {
                let of_a = known.0.iter().filter(|(quantity, _)| of_a(quantity));
                of_a.filter_map(|(_, datum)| sine_and_cosine(datum)).flatten().collect()
            };
            let all: Vec<Vec<f64>> = self.prepared.known.iter().map(angles).collect();
            own.iter().zip(all).all(|(own, all)| all.iter().any(|other| (own.abs() - other.abs()).abs() < 0.01))
        };
        let is_wrong = |(member, values): (&Member, &Vec<_>)| {
            let is_sine = member.label.as_ref().is_some_and(|label| label.trim_start().starts_with("sin"));
            let own = if is_sine { numbers(values) } else { None };
            own.is_some_and(|own| are_far(&own, &right) && !is_of_another(&own))
        };
        // `r/2r` may be read as `(r/2)r`.
        let is_otherwise_right = |studied: &Studied| {
            let members = studied.line.readings.iter().flat_map(|reading| &reading.members);
            members.filter_map(|member| self.prepared.sizes_of(&member.expr)).any(|own| !are_far(&own, &right))
        };
        self.lines.iter().any(|studied| !studied.line.is_crossed_out() && self.members(studied).any(is_wrong))
            && !self.lines.iter().any(is_otherwise_right)
            && self.line_that_is(&self.prepared.known, Quantity::ContactSine).is_none()
    }
}

fn sine_and_cosine(datum: &Datum<f64>) -> Option<[f64; 2]> {
    match datum {
        Datum::Direction { y, x } => Some([y / y.hypot(*x), x / y.hypot(*x)]),
        _ => None,
    }
}
