//! Turned through more than a right angle, or less: by the scalar product of the velocities, or by two angles with a wall.

use super::condition::oriented;
use crate::answer::Kind;
use crate::bank::{EarnedFor, Find};
use crate::expr::{Expr, Function, Relation};
use crate::mark::reading::Form;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working};
use crate::mark::working::numbers::{any_within, sizes};
use crate::mark::working::theirs::is_nearly_right;
use crate::mechanics::{Axis, Known, Law, Moment, Quantity, Setting, Sphere};
use crate::number::Range;

/// What the direction of a velocity may be told by, each at every point.
type Directions = Vec<Vec<f64>>;

impl Working<'_> {
    /// Is it what is to be shown of the turn, for a method mark: the line that demands it has found it, and so has one for
    /// the value where the turn is just a right angle.
    pub(super) fn demanded_of_turn(&self, law: Law) -> Option<Evidence> {
        self.demanded_dot().filter(|dot| law.gives(*dot))?;
        let mark = self.part.scheme.iter().find(|mark| mark.earned_for == EarnedFor::Condition)?;
        let line = self.uses_condition(mark).filter(|found| found.given).map(|found| found.line);
        let line = line.or_else(|| self.critical_line(mark))?;
        Some(Evidence::given(line, law.name()))
    }

    /// The scalar product of the velocities before and after of which the question has an inequality with nought.
    fn demanded_dot(&self) -> Option<Quantity> {
        let condition = self.question.scene.conditions.first()?;
        let Expr::Name(name) = &condition.left else { return None };
        let dot = name.text.parse().ok().filter(|quantity| matches!(quantity, Quantity::DeflectionDot(_)));
        dot.filter(|_| condition.is_inequality() && condition.right.is_zero())
    }

    /// How the scalar product of the velocities before a wall and after it is to stand to nought, where that is what is given.
    pub(super) fn demanded_turn(&self) -> Option<Relation> {
        self.turn_given().filter(|_| self.prepared.setting == Setting::Wall)
    }

    /// The same at a wall or between spheres.
    fn turn_given(&self) -> Option<Relation> {
        let condition = self.question.scene.conditions.first()?;
        let Expr::Name(name) = &condition.left else { return None };
        let is_dot = matches!(name.text.parse(), Ok(Quantity::DeflectionDot(_)));
        Some(condition.relation).filter(|_| is_dot && condition.right.is_zero())
    }

    /// `α + β = 90`, or `cos(90 - α)` for the angle after: a right angle between paths that make these angles with a wall, or
    /// with the line of centres of a sphere that goes back.
    pub(super) fn makes_right_angle(&self, (left, right): &(Expr, Expr)) -> bool {
        if self.turn_given() != Some(Relation::Equal) {
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
        are_together()
            || any_within(left, &is_rest)
            || any_within(right, &is_rest)
            || self.is_product_but_for_a_sign(left, right)
    }

    /// `v_A u cos θ - u² sin² θ = 0`: between spheres the scalar product with a sign wrong, perhaps divided by the component
    /// before.
    fn is_product_but_for_a_sign(&self, left: &Expr, right: &Expr) -> bool {
        let Some(Expr::Name(name)) = self.question.scene.conditions.first().map(|condition| &condition.left) else {
            return false;
        };
        let Ok(Quantity::DeflectionDot(sphere)) = name.text.parse() else { return false };
        let component = |moment, axis| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, axis));
        let along = component(Moment::Before, Axis::N).zip(component(Moment::After, Axis::N));
        let (Some((before, after)), Some(across)) = (along, component(Moment::Before, Axis::T)) else { return false };
        let Some(excess) = self.excess(left, Relation::Greater, right) else { return false };
        let each = before.iter().zip(&after).zip(&across);
        let wrong: Vec<f64> = each.map(|((before, after), across)| before * after - across * across).collect();
        let divided: Vec<f64> = wrong.iter().zip(&before).map(|(wrong, before)| wrong / before).collect();
        [wrong, divided].into_iter().any(|wrong| {
            let turned: Vec<f64> = wrong.iter().map(|wrong| -wrong).collect();
            self.is_positive_multiple(&excess, &wrong) || self.is_positive_multiple(&excess, &turned)
        })
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

    /// The deflection from the directions before and after, each from a line of its own: one less the other, or both from two
    /// right angles. Which of them it should be is accuracy.
    pub(super) fn between_directions(&self, law: Law) -> Option<Evidence> {
        let ends = self.ends();
        let is_between = |expr: &Expr| {
            let Expr::Sum(_) = expr else { return false };
            let (whole, angles): (Vec<_>, Vec<_>) = terms(expr).into_iter().partition(|(_, term)| is_straight(term));
            let ([(_, one), (_, other)], true) = (angles.as_slice(), whole.len() <= 1) else { return false };
            ends.iter().any(|(before, after)| {
                let is = |term: &Expr, ends: &[Vec<f64>]| self.is_direction(term, ends);
                is(one, before) && is(other, after) || is(other, before) && is(one, after)
            })
        };
        let is_it = |studied: &Studied| {
            studied.matched.is_empty() && self.members(studied).any(|(member, _)| is_between(&member.expr))
        };
        Some(Evidence::given(self.lines.iter().position(is_it)?, law.name()))
    }

    /// What an answer would be that takes one of two directions which stand in the lines from the other, or adds them; in
    /// degrees, at every point.
    pub(in crate::mark::working) fn turns(&self) -> Vec<Vec<f64>> {
        let mut asked = self.part.blanks.iter().flat_map(|blank| blank.find.quantities());
        if !asked.any(|find| matches!(find, Quantity::Deflection(_))) {
            return Vec::new();
        }
        let stands = |angle: &&Vec<f64>| {
            let alone = std::slice::from_ref(*angle);
            let mut members = self.lines.iter().flat_map(|studied| self.members(studied));
            members.any(|(member, _)| self.is_direction(&member.expr, alone))
        };
        let mut turns = Vec::new();
        for (before, after) in self.ends() {
            for one in before.iter().filter(stands) {
                for other in after.iter().filter(stands) {
                    let with =
                        |turn: &dyn Fn(f64, f64) -> f64| one.iter().zip(other).map(|(a, b)| turn(*a, *b)).collect();
                    turns.extend([with(&|a, b| a + b), with(&|a, b| a - b), with(&|a, b| 180.0 - a - b)]);
                }
            }
        }
        turns
    }

    /// The directions before and after of each sphere that has both.
    fn ends(&self) -> Vec<(Directions, Directions)> {
        let found = self.prepared.all_where_found().unwrap_or_default();
        let ends = |sphere| {
            let after = [&self.prepared.known, &self.followed, &found];
            let after = after.map(|known| directions(known, sphere, Moment::After));
            (directions(&self.prepared.known, sphere, Moment::Before), after.concat())
        };
        let both = Sphere::BOTH.into_iter().map(ends);
        both.filter(|(before, after)| !before.is_empty() && !after.is_empty()).collect()
    }

    /// Is it one of these angles, in degrees or in radians?
    fn is_direction(&self, expr: &Expr, angles: &[Vec<f64>]) -> bool {
        let in_radians = |angle: &Vec<f64>| angle.iter().map(|degrees| degrees.to_radians()).collect();
        self.is_one_of(expr, angles) || self.is_one_of(expr, &angles.iter().map(in_radians).collect::<Vec<_>>())
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

    /// Is it the direction after less the one before, `β - α`?
    pub(super) fn is_of_directions(&self, expr: &Expr) -> bool {
        match terms(expr).as_slice() {
            [(true, one), (false, other)] => {
                self.is_given_angle(other) && !self.is_given_angle(one) && matches!(one, Expr::Name(_))
            }
            _ => false,
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

impl Working<'_> {
    /// With tangents as the question asks for them elsewhere, unless the student has found another: `f/(e tan α)` for `f/tan β`
    /// and for `f tan(90 - β)`, where tan β is e tan α.
    pub(super) fn with_tangents_asked(&self, expr: &Expr) -> Expr {
        let Expr::Call(Function::Tan, angle) = expr else {
            return expr.map_children(&mut |child| self.with_tangents_asked(child));
        };
        let tangent = match terms(angle).as_slice() {
            [(true, own)] => self.tangent_asked(own).cloned(),
            [(true, whole), (false, own)] if is_right_angle(whole) => self
                .tangent_asked(own)
                .map(|tangent| Expr::Quotient(Box::new(Expr::integer(1)), Box::new(tangent.clone()))),
            _ => None,
        };
        tangent.unwrap_or_else(|| expr.clone())
    }

    fn tangent_asked(&self, angle: &Expr) -> Option<&Expr> {
        let Expr::Name(name) = angle else { return None };
        let blanks = self.question.parts.iter().flat_map(|part| &part.blanks);
        let mut asked = blanks.filter_map(|blank| {
            let is_it = blank.model.angle.as_ref() == Some(&name.text) && blank.model.kind == Kind::Expression;
            let Find::Quantity(quantity) = blank.find else { return None };
            is_it.then_some((quantity, &blank.model.value))
        });
        let (quantity, right) = asked.next()?;
        let is_right = |own: &Expr| {
            let sizes = [own, right].map(|expr| self.prepared.sizes_of(expr));
            let [Some(own), Some(right)] = sizes else { return false };
            own.iter().zip(&right).all(|(own, right)| is_nearly_right(*own, *right))
        };
        self.theirs.earlier.get(&quantity).is_none_or(is_right).then_some(right)
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

fn is_straight(expr: &Expr) -> bool {
    let is = |expr: &Expr| *expr == Expr::integer(180);
    *expr == Expr::Pi || is(expr) || matches!(expr, Expr::Degrees(inner) if is(inner))
}

/// The acute angles that a velocity makes with the line of centres, and with i, and the rest of a right angle, in degrees.
fn directions(known: &[Known<f64>], sphere: Sphere, moment: Moment) -> Directions {
    let of = |axes: [Axis; 2]| {
        let [one, other] = axes.map(|axis| sizes(known, Quantity::Velocity(sphere, moment, axis)));
        let degrees = |(one, other): (&f64, &f64)| one.abs().atan2(other.abs()).to_degrees();
        let angle: Vec<f64> = one?.iter().zip(&other?).map(degrees).collect();
        let is_along_one = |angle: &f64| *angle < 0.5 || *angle > 89.5;
        (!angle.is_empty() && !angle.iter().any(is_along_one)).then_some(angle)
    };
    let angles = [[Axis::N, Axis::T], [Axis::X, Axis::Y]].into_iter().filter_map(of);
    angles.flat_map(|angle| [angle.iter().map(|angle| 90.0 - angle).collect(), angle]).collect()
}
