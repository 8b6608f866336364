//! The energy that is lost by way of what each sphere loses or gains.

use super::values::names_loss;
use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::judging::named_spheres;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::sizes;
use crate::mechanics::{Law, Quantity, Sphere};

impl Working<'_> {
    /// `216 - 144`: what one sphere loses and what the other does, right or the student's own, each a number.
    pub(super) fn is_of_both_losses(&self, expr: &Expr) -> bool {
        let Expr::Sum(terms) = expr else { return false };
        let [one, other] = terms.as_slice() else { return false };
        let is = |term: &Expr, sizes: &Vec<f64>| self.is_one_of(term, std::slice::from_ref(sizes));
        [&self.prepared.known, &self.followed].into_iter().any(|known| {
            match Sphere::BOTH.map(|sphere| sizes(known, Quantity::SphereEnergyLost(sphere))) {
                [Some(a), Some(b)] => is(one, &a) && is(other, &b) || is(one, &b) && is(other, &a),
                _ => false,
            }
        })
    }

    /// What each sphere loses or gains, right on lines of their own or on one, and then a loss of neither alone: whatever the
    /// calculator made of them.
    pub(super) fn losses_apart(&self, law: Law, code: Code) -> Option<Evidence> {
        if !law.gives(Quantity::EnergyLost) {
            return None;
        }
        let follows = !code.is_accuracy() || code == Code::A1FollowThrough;
        let of = |sphere| {
            let place = |known| self.line_that_is(known, Quantity::SphereEnergyLost(sphere));
            let own = || if follows { place(&self.followed) } else { None };
            place(&self.prepared.known).or_else(own)
        };
        let last = of(Sphere::A)?.max(of(Sphere::B)?);
        let is_of_both = |member: &Member| {
            member.label.as_ref().is_some_and(|label| names_loss(label) && named_spheres(label).is_empty())
        };
        let says = |studied: &Studied| studied.reading.iter().flat_map(|reading| &reading.members).any(is_of_both);
        let line = self.lines.iter().skip(last).position(says)?;
        Some(Evidence::given(last + line, law.name()))
    }
}
