//! Turned through more than a right angle, or less: by the scalar product of the velocities, or by two angles with a wall.

use super::compare::any_within;
use super::condition::oriented;
use super::evidence::Evidence;
use super::examine::Working;
use crate::bank::EarnedFor;
use crate::expr::{Expr, Function, Relation};
use crate::mark::reading::Form;
use crate::mechanics::{Law, Quantity, Setting};
use crate::number::Range;

impl Working<'_> {
    /// Is it what is to be shown of the turn, for a method mark: the line that demands it has found it, and so has one for
    /// the value where the turn is just a right angle.
    pub(super) fn demanded_of_turn(&self, law: Law) -> Option<Evidence> {
        self.demanded_dot().filter(|dot| law.gives(*dot))?;
        let mark = self.part.scheme.iter().find(|mark| mark.earned_for == EarnedFor::Condition)?;
        let line = self.uses_condition(mark).map(|found| found.line).or_else(|| self.critical_line(mark))?;
        Some(Evidence::given(line, law.name()))
    }

    /// The scalar product of the velocities before and after of which the question has an inequality with nought.
    fn demanded_dot(&self) -> Option<Quantity> {
        let condition = self.question.scene.conditions.first()?;
        let Expr::Name(name) = &condition.left else { return None };
        let dot = name.text.parse().ok().filter(|quantity| matches!(quantity, Quantity::DeflectionDot(_)));
        dot.filter(|_| condition.is_inequality() && condition.right.is_zero())
    }

    /// `α + β > 90`, `β > 90 - α`, `tan(α + β) < 0` at a wall, with one of the question's angles and another.
    pub(super) fn is_of_angles(&self, form: &Form) -> bool {
        let Form::Equation(Expr::Relation(left, relation, right)) = form else { return false };
        let (Some(_), Setting::Wall) = (self.demanded_dot(), self.prepared.setting) else { return false };
    /// How the scalar product of the velocities before a wall and after it is to stand to nought, where that is what is given.
    pub(super) fn demanded_turn(&self) -> Option<Relation> {
        let condition = self.question.scene.conditions.first()?;
        let Expr::Name(name) = &condition.left else { return None };
        let is_dot = matches!(name.text.parse(), Ok(Quantity::DeflectionDot(_)));
        Some(condition.relation)
            .filter(|_| is_dot && condition.right.is_zero() && self.prepared.setting == Setting::Wall)
    }

    /// `α + β = 90`, or `cos(90 - α)` for the angle after: a right angle between paths that make these angles with a wall.
    pub(super) fn makes_right_angle(&self, (left, right): &(Expr, Expr)) -> bool {
        if self.demanded_turn() != Some(Relation::Equal) {
            return false;
        }
        let are_together = || {
            let mut all = terms(left);
            all.extend(terms(right).into_iter().map(|(plus, term)| (!plus, term)));
            let (right_angle, angles): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, term)| is_right_angle(term));
            matches!(right_angle.as_slice(), [(false, _)]) && self.are_two_angles(&angles)
        };
        let is_rest = |inner: &Expr| match inner {
            Expr::Call(Function::Sin | Function::Cos | Function::Tan, angle) => match terms(angle).as_slice() {
                [(true, whole), (false, part)] => is_right_angle(whole) && self.is_given_angle(part),
                _ => false,
            },
            _ => false,
        };
        are_together() || any_within(left, &is_rest) || any_within(right, &is_rest)
    }

        let is_more = |relation: Relation| oriented(1.0, relation).map(f64::is_sign_positive);
        let (Some(left_is_more), Some(dot_is_more)) =
            (is_more(*relation), is_more(self.question.scene.conditions[0].relation))
        else {
            return false;
        };
        let (more, less) = if left_is_more { (left, right) } else { (right, left) };
        // With a scalar product below nought the angles are more than a right angle together.
        let (angles, bound) = if dot_is_more { (less, more) } else { (more, less) };
        let is_obtuse = |tangent: &Expr, nought: &Expr| match tangent {
            Expr::Call(Function::Tan, sum) => nought.is_zero() && self.are_two_angles(&terms(sum)),
            _ => false,
        };
        if is_obtuse(bound, angles) {
            return true;
        }
        let mut all = terms(angles);
        all.extend(terms(bound).into_iter().map(|(plus, term)| (!plus, term)));
        let (right_angle, angles): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, term)| is_right_angle(term));
        matches!(right_angle.as_slice(), [(false, _)]) && self.are_two_angles(&angles)
    }

    /// One of the question's angles, by its letter or as it is, and another letter, both counted.
    fn are_two_angles(&self, terms: &[(bool, &Expr)]) -> bool {
        let [(true, one), (true, other)] = terms else { return false };
        let is_given = |angle: &Expr| self.is_given_angle(angle);
        let is_other = |angle: &Expr| match angle {
            Expr::Name(name) => self.question.letters.iter().all(|letter| letter.name() != name.text),
            _ => false,
        };
        is_given(one) && is_other(other) || is_other(one) && is_given(other)
    }

    /// With tangents as the lines up to one have them: `tan β` is `3e/2` after `tan β = 3e/2`.
    pub(super) fn with_stated_tangents(&self, expr: &Expr, place: usize) -> Expr {
        if let Expr::Call(Function::Tan, inner) = expr
            && let Expr::Name(name) = &**inner
            && !self.question.letters.iter().any(|letter| letter.name() == name.text)
        {
            let equations = self.lines[..=place].iter().filter_map(|studied| studied.reading.as_ref());
            let mut stated = equations.flat_map(|reading| &reading.equations).filter(|(left, _)| left == expr);
            if let Some((_, tangent)) = stated.next() {
                return tangent.clone();
            }
        }
        expr.map_children(&mut |child| self.with_stated_tangents(child, place))
    }
}

/// The terms of a sum, and whether each is added.
fn terms(expr: &Expr) -> Vec<(bool, &Expr)> {
    match expr {
        Expr::Sum(all) => all.iter().flat_map(terms).collect(),
        Expr::Negative(inner) => terms(inner).into_iter().map(|(plus, term)| (!plus, term)).collect(),
        _ => vec![(true, expr)],
    }
}

fn is_right_angle(expr: &Expr) -> bool {
    let is = |expr: &Expr, number: i64| *expr == Expr::integer(number);
    match expr {
        Expr::Degrees(inner) => is(inner, 90),
        Expr::Quotient(above, below) => **above == Expr::Pi && is(below, 2),
        _ => is(expr, 90),
    }
}
    /// Is it an angle of the question, by its letter or as it is?
    fn is_given_angle(&self, angle: &Expr) -> bool {
        let is_acute = |name: &str| {
            let mut letters = self.question.letters.iter();
            letters.any(|letter| letter.name() == name && letter.range() == Range::Acute)
        };
        match angle {
            Expr::Name(name) => is_acute(&name.text) || self.prepared.angles.iter().any(|(own, _)| *own == name.text),
            Expr::Degrees(_) => true,
            _ => false,
        }
    }

