//! The component across the line of centres where no line has it by itself: the direction after an impact comes of both
//! components, and so does a right angle between the paths.

use super::shapes::{components_in, is_tangent};
use crate::answer::Kind;
use crate::bank::EarnedFor;
use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{comes_to, is_composite, sizes};
use crate::mechanics::{Axis, Law, Moment, Quantity, Setting, Sphere};

impl Working<'_> {
    /// The line of a tangent of the direction after, `tan β = 2 tan α/(1 - e)`, or of the deflection, or of a right angle, `x = -u sin θ tan θ`, where
    /// the component along the line of centres has been found, and only this sphere has one across.
    pub(super) fn across_implied(&self, across: &[(Sphere, Vec<f64>)]) -> Option<usize> {
        let [(sphere, _)] = across else { return None };
        let along = Quantity::Velocity(*sphere, Moment::After, Axis::N);
        if self.prepared.setting != Setting::Oblique || !self.theirs.values.contains_key(&along) {
            return None;
        }
        let line = self.tangent_after(*sphere).into_iter().chain(self.right_angle_with(*sphere)).min();
        line.filter(|line| *line <= self.end_of_finding())
    }

    /// The line that has the tangent of the direction after, unless that is what is to be shown.
    fn tangent_after(&self, sphere: Sphere) -> Option<usize> {
        let [before, after] = [Moment::Before, Moment::After].map(|moment| self.tangent(sphere, moment));
        let (before, after) = (before?, after?);
        // Paths at right angles have gradients of which the product is there.
        let product: Vec<f64> = before.iter().zip(&after).map(|(before, after)| before * after).collect();
        // Where a result is to be shown every step on the way counts.
        let is_open = self.part.blanks.iter().all(|blank| blank.model.kind != Kind::Shown);
        let turned = sizes(&self.prepared.known, Quantity::TanDeflection(sphere)).filter(|_| is_open);
        let is = |values: &[Value], right: &[f64]| values.iter().zip(right).all(|(own, right)| comes_to(*own, *right));
        let is_turned = |values: &[Value]| turned.as_ref().is_some_and(|turned| is(values, turned));
        if self.printed_values().any(|result| self.values_of(result).is_some_and(|own| is(&own, &after))) {
            return None;
        }
        let is_it = |studied: &Studied| {
            let mut members = self.members(studied).filter(|(member, _)| !self.is_printed_value(&member.expr));
            studied.matched.is_empty()
                && self.speaks_of_angle(studied)
                && members.any(|(_, values)| is(values, &after) || is(values, &product) || is_turned(values))
        };
        self.lines.iter().position(is_it)
    }

    /// The component along the line of centres after an impact within a tangent: `tan β = u sin α/(u cos α(1 - e)/2)`.
    pub(in crate::mark::working) fn along_in_tangent(&self) -> Option<usize> {
        let [(sphere, _)] = *self.across() else { return None };
        let after = [sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::After, Axis::N))?];
        let has_it = |member: &Member| {
            let components = components_in(&member.expr, is_tangent(member));
            components.iter().any(|component| is_composite(component) && self.is_one_of(component, &after))
        };
        self.lines.iter().position(|studied| self.members(studied).any(|(member, _)| has_it(member)))
    }

    /// The tangent of the angle between a path and the line of centres, at every point.
    fn tangent(&self, sphere: Sphere, moment: Moment) -> Option<Vec<f64>> {
        let [along, across] =
            [Axis::N, Axis::T].map(|axis| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, axis)));
        let tangents: Vec<f64> = across?.iter().zip(&along?).map(|(across, along)| across / along).collect();
        tangents.iter().all(|size| size.is_normal()).then_some(tangents)
    }

    /// The deflection as the difference of the directions, which is greatest where both turn alike: after the tangent of the
    /// direction after `δ = β - α` or `dβ/dα = 1`, and then the condition for it.
    pub(super) fn directions_turn_alike(&self, law: Law) -> Option<Evidence> {
        let tangent = Sphere::BOTH.into_iter().find_map(|sphere| self.tangent_after(sphere))?;
        let mark = self.part.scheme.iter().find(|mark| mark.earned_for == EarnedFor::Condition)?;
        let end = self.uses_condition(mark).filter(|found| found.given)?.line;
        let says = |studied: &Studied| {
            let mut equations = studied.reading.iter().flat_map(|reading| &reading.equations);
            turns_alike(&studied.line.typed)
                || equations.any(|(left, right)| self.is_of_directions(left) || self.is_of_directions(right))
        };
        let line = self.lines[..=end].iter().position(says)?;
        (tangent < end).then(|| Evidence::given(line, law.name()))
    }

    /// The line on which the paths of a sphere are at right angles, with the student's letter for its component along.
    fn right_angle_with(&self, sphere: Sphere) -> Option<usize> {
        let condition = self.question.scene.conditions.first()?;
        let is_dot = matches!(&condition.left, Expr::Name(name)
            if name.text.parse() == Ok(Quantity::DeflectionDot(sphere)));
        let letter = &self.convention.as_ref()?.letters[sphere as usize];
        let has_letter = |side: &Expr| side.names().iter().any(|name| name.text == *letter);
        let is_it = |studied: &Studied| {
            let mut equations = studied.reading.iter().flat_map(|reading| &reading.equations);
            studied.matched.is_empty()
                && equations.any(|equation| {
                    (has_letter(&equation.0) || has_letter(&equation.1)) && self.holds_only_where_found(equation)
                })
        };
        self.lines.iter().position(is_it).filter(|_| is_dot && condition.right.is_zero())
    }
}

/// `dβ/dα = 1`: the rate at which one angle turns with another.
fn turns_alike(typed: &str) -> bool {
    let typed: Vec<char> = typed.chars().filter(|sign| !sign.is_whitespace()).collect();
    let is_letter = |sign: &char| sign.is_alphabetic();
    typed.windows(7).enumerate().any(|(place, signs)| match signs {
        ['d', of, '/', 'd', by, '=', '1'] => {
            is_letter(of) && is_letter(by) && !typed.get(place + 7).is_some_and(|after| after.is_alphanumeric())
        }
        _ => false,
    })
}
