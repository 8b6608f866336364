//! The component along a wall, which the wall cannot change, and *e* times a component of the student's own.

use super::impulse::is_worked;
use super::shapes::is_tangent;
use crate::expr::Expr;
use crate::mark::judging::may_be_named;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working};
use crate::mark::working::lines::{Member, says_into_wall};
use crate::mark::working::numbers::{comes_to, is_vector, sizes};
use crate::mark::working::theirs::numbers;
use crate::mechanics::{Axis, Law, Moment, Quantity, Setting, Sphere};

/// A product of more factors is of something else.
const MOST_FACTORS: usize = 4;

impl Working<'_> {
    fn sizes_in(&self, expr: &Expr) -> Option<Vec<f64>> {
        numbers(&self.values_of(expr)?)
    }

    fn before_wall(&self, axis: Axis) -> Option<Vec<f64>> {
        sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, Moment::Before, axis))
    }

    /// `8(3i + 4j)/5 - (4i - 3j)/5`: is it a vector that was put together, with the component that a slanting wall leaves as it is?
    pub(super) fn has_part_along_wall(&self, expr: &Expr, values: &[Value], along: &[f64]) -> bool {
        is_worked(expr) && self.keeps_part_along_wall(values, along)
    }

    /// Has a vector the component along a slanting wall?
    pub(in crate::mark::working) fn keeps_part_along_wall(&self, values: &[Value], along: &[f64]) -> bool {
        let line = |axis| sizes(&self.prepared.known, Quantity::Line(axis));
        let Some((x, y)) = line(Axis::X).zip(line(Axis::Y)) else { return false };
        let has_it = |(point, value): (usize, &Value)| match value {
            Value::Vector(along_i, along_j) => {
                let part = along_j.times(x[point]) - along_i.times(y[point]);
                part.absolute().may_be(along[point].abs())
            }
            Value::Number(_) => false,
        };
        let is_slanting = |(x, y): (&f64, &f64)| x.abs().min(y.abs()) > 1e-9;
        self.prepared.setting == Setting::Wall
            && x.iter().zip(&y).all(is_slanting)
            && values.iter().enumerate().all(has_it)
    }

    /// The line on which *e* is put to the component along a wall, or another value after the impact is given for it, where
    /// none puts it to the other.
    pub(super) fn changes_along_wall(&self) -> Option<usize> {
        if self.prepared.setting != Setting::Wall {
            return None;
        }
        let (along, into) = (self.before_wall(Axis::T)?, self.before_wall(Axis::N)?);
        let has_e_times = |studied: &Studied, sizes: &[f64]| {
            // The ratio of the components in a tangent may come to as much.
            let is_e_times = |member: &Member| !is_tangent(member) && self.is_e_times(&member.expr, sizes);
            self.members(studied).any(|(member, _)| is_e_times(member))
        };
        // Who puts e to the right component as well knows which it is, or has put it to both.
        let changes = |studied: &Studied| has_e_times(studied, &along) || self.says_another_along(studied, &along);
        let line = self.lines.iter().position(|studied| !studied.line.is_crossed_out() && changes(studied))?;
        let is_alike = along.iter().zip(&into).all(|(one, other)| (one.abs() - other.abs()).abs() < 1e-9);
        (!is_alike && !self.reckons_with(&along, line)).then_some(line)
    }

    /// Is a component in a formula that is not *e* times it, or said again after a line? `½ × 16 = 8` beside `√(16² + 6²)`
    /// cancels a fraction.
    pub(super) fn reckons_with(&self, component: &[f64], line: usize) -> bool {
        let sizes = [component.to_vec()];
        // In a law along the line of centres its number is that of something else.
        let is_open = |studied: &Studied| !studied.line.is_crossed_out() && studied.matched.is_empty();
        self.lines.iter().enumerate().filter(|(_, studied)| is_open(studied)).any(|(place, studied)| {
            self.members(studied).any(|(member, _)| {
                let is_said = || place > line && self.is_one_of(&member.expr, &sizes);
                let is_e_times = !is_tangent(member) && self.is_e_times(&member.expr, component);
                !is_e_times && (self.has_part(&member.expr, &sizes) || is_said())
            })
        })
    }

    /// Is one of these sizes in it, but for *e* times it?
    fn has_part(&self, expr: &Expr, sizes: &[Vec<f64>; 1]) -> bool {
        // The size in `-6` is no part of it.
        if let Expr::Negative(inner) = expr {
            return self.has_part(inner, sizes);
        }
        // Nor is the 2 of a square.
        if let Expr::Power(base, _) = expr {
            return self.is_one_of(base, sizes) || self.has_part(base, sizes);
        }
        let mut parts = expr.children().into_iter().filter(|part| !self.is_e_times(part, &sizes[0]));
        parts.any(|part| self.is_one_of(part, sizes) || self.has_part(part, sizes))
    }

    /// Does a line say that the component along the wall is another after the impact?
    fn says_another_along(&self, studied: &Studied, along: &[f64]) -> bool {
        self.members(studied).any(|(member, values)| {
            let is_last = self.is_last_of_its_statement(studied, member);
            let clause = self.clause(studied, member);
            let says = self.says_across(clause) && clause.to_lowercase().contains("after") && !says_into_wall(clause);
            let is_other =
                |(value, right): (&Value, &f64)| matches!(value, Value::Number(_)) && !comes_to(*value, *right);
            is_last && says && values.iter().zip(along).all(is_other)
        })
    }

    fn is_last_of_its_statement(&self, studied: &Studied, member: &Member) -> bool {
        let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
        let last = members.rfind(|other| other.statement == member.statement);
        last.is_some_and(|last| std::ptr::eq(last, member))
    }

    /// Is it *e* times a number of these sizes, as it stands or worked out?
    pub(super) fn is_e_times(&self, expr: &Expr, sizes: &[f64]) -> bool {
        let Some(restitution) = self.restitution() else { return false };
        let sizes = [sizes.to_vec()];
        self.is_product_with(expr, &|factor| self.is_one_of(factor, &restitution), &|rest| self.is_one_of(rest, &sizes))
    }

    /// Pythagoras with the components that lines say are along the wall and across it after the impact: `√52`, after 6 along
    /// it and 4 across.
    pub(super) fn speed_of_own_components(&self, law: Law) -> Option<Evidence> {
        let mut own: [Option<Vec<f64>>; 2] = [None, None];
        for (place, studied) in self.lines.iter().enumerate() {
            if let [Some(along), Some(across)] = &own {
                let whole: Vec<f64> = along.iter().zip(across).map(|(x, y)| x.hypot(*y)).collect();
                let is_speed = |member: &Member| {
                    let is_named = |label: &String| {
                        let after = Quantity::Speed(Sphere::A, Moment::After);
                        label.contains(char::is_alphabetic) && may_be_named(label, after)
                    };
                    member.label.as_ref().is_some_and(is_named)
                        && self.is_near_one_of(&member.expr, std::slice::from_ref(&whole))
                };
                if self.members(studied).any(|(member, _)| is_speed(member)) {
                    return Some(Evidence::given(place, law.name()));
                }
            }
            let Some((member, values)) = self.members(studied).last() else { continue };
            let clause = self.clause(studied, member);
            let says = [self.says_across(clause), says_into_wall(clause)];
            if let ([true, false] | [false, true], Some(sizes)) = (says, numbers(values)) {
                own[usize::from(says[1])] = Some(sizes).filter(|sizes| sizes.iter().all(|size| size.abs() > 1e-9));
            }
        }
        None
    }

    /// What a wall would make of the component along it, taken for the other.
    pub(in crate::mark::working) fn rebound_with_sine_for_cosine(&self) -> Option<Vec<f64>> {
        let along = self.before_wall(Axis::T).filter(|_| self.prepared.setting == Setting::Wall)?;
        let [e] = self.restitution()?;
        Some(along.iter().zip(&e).map(|(along, e)| along * e).collect())
    }

    fn restitution(&self) -> Option<[Vec<f64>; 1]> {
        Some([sizes(&self.prepared.known, Quantity::Restitution)?])
    }

    /// Is it the product of a factor and of something else that are both so?
    fn is_product_with(&self, expr: &Expr, is_factor: &dyn Fn(&Expr) -> bool, is_rest: &dyn Fn(&Expr) -> bool) -> bool {
        let factors = factors(expr);
        let chosen = |chosen: usize, is_in: bool| {
            let all = factors.iter().enumerate().filter(|(place, _)| (chosen >> place & 1 == 1) == is_in);
            Expr::product(all.map(|(_, factor)| factor.clone()))
        };
        // In `-6 × 2/3` the factor is 2 with a third.
        (2..=MOST_FACTORS).contains(&factors.len())
            && (1..(1 << factors.len()) - 1).any(|some| is_factor(&chosen(some, true)) && is_rest(&chosen(some, false)))
    }

    /// Is a value one to which *e* leads, from the component with which the wall is hit?
    pub(super) fn is_rebound(&self, studied: &Studied, statement: usize) -> bool {
        let Some(into) = self.before_wall(Axis::N).filter(|_| self.prepared.setting == Setting::Wall) else {
            return false;
        };
        let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
        members.any(|member| member.statement == statement && self.is_e_times(&member.expr, &into))
    }

    /// *e* times a component of the student's own, which is not right, or a number in the place of *e* times the right one:
    /// restitution has been used.
    pub(super) fn rebound_of_own(&self) -> Option<usize> {
        let (along, into) = (self.before_wall(Axis::T)?, self.before_wall(Axis::N)?);
        let (into, restitution) = ([into], self.restitution()?);
        let after = Quantity::Velocity(Sphere::A, Moment::After, Axis::N);
        let speed = sizes(&self.prepared.known, Quantity::Speed(Sphere::A, Moment::Before)).unwrap_or_default();
        // Where there are several impacts a number may be e of another.
        let is_only = self.question.scene.then.is_empty() && self.part.meeting.number == 0;
        let mut own: Vec<Vec<f64>> = Vec::new();
        let is = |values: &[f64], right: &[f64]| {
            values.iter().zip(right).all(|(own, right)| (own.abs() - right.abs()).abs() < 0.005 * right.abs())
        };
        for (place, studied) in self.lines.iter().enumerate() {
            let is_own = |rest: &Expr| self.is_one_of(rest, &own);
            let is_e = |factor: &Expr| self.is_one_of(factor, &restitution);
            let is_right = |rest: &Expr| self.is_one_of(rest, &into);
            let is_share = |one: &f64| 0.0 < *one && *one < 1.0;
            let is_misread = |factor: &Expr| {
                is_only
                    && factor.names().is_empty()
                    && self.sizes_in(factor).is_some_and(|sizes| sizes.iter().all(is_share))
            };
            let shows = self.members(studied).any(|(member, _)| {
                let is_else = member.label.as_ref().is_some_and(|label| !may_be_named(label, after));
                !is_else
                    && !self.says_across(self.clause(studied, member))
                    && (self.is_product_with(&member.expr, &is_e, &is_own)
                        || self.is_product_with(&member.expr, &is_misread, &is_right))
            });
            if shows {
                return Some(place);
            }
            let said = self.members(studied).filter(|(member, _)| {
                self.is_last_of_its_statement(studied, member) && !self.says_across(self.clause(studied, member))
            });
            let sizes = said.filter_map(|(member, values)| numbers(values).filter(|_| !member.is_given));
            own.extend(sizes.filter(|sizes| !is(sizes, &along) && !is(sizes, &speed)));
        }
        None
    }

    /// *e* times the whole velocity, as a vector: nothing has been resolved to use restitution on.
    pub(super) fn rebound_of_all(&self) -> Option<usize> {
        let before = |axis| sizes(&self.prepared.known, Quantity::Velocity(Sphere::A, Moment::Before, axis));
        let ([e], x, y) = (self.restitution()?, before(Axis::X)?, before(Axis::Y)?);
        let times = |sizes: &[f64]| sizes.iter().zip(&e).map(|(size, e)| size * e).collect::<Vec<f64>>();
        let (x, y) = (times(&x), times(&y));
        let is = |values: &[Value]| [1.0, -1.0].into_iter().any(|sign| is_vector(values, &x, &y, sign));
        let is_alike = e.iter().all(|e| (e - 1.0).abs() < 1e-9);
        self.lines.iter().position(|studied| !is_alike && self.members(studied).any(|(_, values)| is(values)))
    }
}

/// The factors of a product; a number below a line is one, in `2/3 × 33/5` a fifth.
fn factors(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Negative(inner) => factors(inner),
        Expr::Product(all) => all.iter().flat_map(factors).collect(),
        // `6.93/2` is half of it; a half is one factor.
        Expr::Quotient(above, below)
            if matches!(**above, Expr::Product(_)) || !above.is_one() && below.names().is_empty() =>
        {
            factors(above).into_iter().chain([Expr::integer(1).over((**below).clone())]).collect()
        }
        other => vec![other.clone()],
    }
}
