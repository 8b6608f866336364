//! Restitution at a wall the wrong way round: `v = 6/0.5` for `v = 0.5 × 6`.

use crate::expr::Expr;
use crate::mark::working::equations::Departure;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::Working;
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{any_within, sizes};
use crate::mark::working::theirs::is_of_velocity;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

impl Working<'_> {
    /// A line in which the component before the impact is divided by e, or e is set to the one after it: it has used restitution
    /// the wrong way round.
    pub(super) fn rebound_on_wrong_side(&self) -> Option<Evidence> {
        let e = sizes(&self.prepared.known, Quantity::Restitution)?;
        let before = sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, Moment::Before, Axis::N))?;
        if e.iter().chain(&before).any(|size| !size.is_normal()) || e.iter().all(|e| (e - 1.0).abs() < 1e-9) {
            return None;
        }
        let over_e = [before.iter().zip(&e).map(|(before, e)| before / e).collect::<Vec<f64>>()];
        let (e, before) = ([e], [before]);
        let is_e = |expr: &Expr| self.is_one_of(expr, &e);
        let is_divided = |member: &Member| {
            let by_e = |inner: &Expr| matches!(inner, Expr::Quotient(_, below) if is_e(below));
            any_within(&member.expr, &by_e) && self.is_one_of(&member.expr, &over_e)
        };
        let is_after = |side: &Expr| match side {
            Expr::Product(factors) => match factors.as_slice() {
                [factor, Expr::Name(name)] => is_e(factor) && is_of_velocity(&name.text),
                _ => false,
            },
            _ => false,
        };
        let is_set = |(left, right): &(Expr, Expr)| {
            is_after(left) && self.is_one_of(right, &before) || is_after(right) && self.is_one_of(left, &before)
        };
        let line = self.lines.iter().position(|studied| {
            let is = studied
                .reading
                .as_ref()
                .is_some_and(|reading| reading.members.iter().any(is_divided) || reading.equations.iter().any(is_set));
            is && !studied.line.is_crossed_out()
        })?;
        let departure = Departure::RestitutionOnWrongSide;
        let (note, feedback) = (Some(departure.tag()), departure.sentence().to_owned());
        Some(Evidence { given: false, note, feedback, ..Evidence::given(line, "restitution") })
    }
}
