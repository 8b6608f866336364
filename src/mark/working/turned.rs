//! Turned through more than a right angle, or less: by the scalar product of the velocities, or by two angles with a wall.

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
        let letter = |name: &str| self.question.letters.iter().find(|letter| letter.name() == name);
        let is_given = |angle: &Expr| match angle {
            Expr::Name(name) => letter(&name.text).is_some_and(|letter| letter.range() == Range::Acute),
            Expr::Degrees(_) => true,
            _ => false,
        };
        let is_other = |angle: &Expr| matches!(angle, Expr::Name(name) if letter(&name.text).is_none());
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
