//! Both laws in one formula: seen from the centre of mass each sphere turns back with *e* times its velocity,
//! `v = 1.4 − 0.5(5 − 1.4)`.

use crate::bank::Code;
use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Value, Working};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::sizes;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

/// How far numbers may be apart and still be one, in parts of the greater: figures are rounded.
const NEAR: f64 = 0.005;

impl Working<'_> {
    /// The line that has the velocity of a sphere after the impact as that of the centre of mass less *e* times what the sphere
    /// had beside it; with its sign wrong it shows the method.
    pub(in crate::mark::working) fn by_centre_of_mass(&self, code: Code) -> Option<Evidence> {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let before = |sphere| known(Quantity::Velocity(sphere, Moment::Before, Axis::N));
        let [m_a, m_b] = [known(Quantity::Mass(Sphere::A))?, known(Quantity::Mass(Sphere::B))?];
        let (a, b, e) = (before(Sphere::A)?, before(Sphere::B)?, known(Quantity::Restitution)?);
        let at = |point: usize| (m_a[point] * a[point] + m_b[point] * b[point]) / (m_a[point] + m_b[point]);
        let whole: Vec<f64> = (0..a.len()).map(at).collect();
        let beside = [a, b].map(|own| -> Vec<f64> { own.iter().zip(&whole).map(|(own, whole)| own - whole).collect() });
        let is = |values: &[Value], right: &dyn Fn(usize) -> f64| {
            values.iter().enumerate().all(|(point, value)| match value {
                Value::Number(own) => (own.middle() - right(point)).abs() <= NEAR * right(point).abs(),
                Value::Vector(..) => false,
            })
        };
        let agrees = |expr: &Expr, turned: f64| {
            let Expr::Sum(terms) = expr else { return false };
            let [first, second] = terms.as_slice() else { return false };
            let has = |whole_term: &Expr, other: &Expr, sense: f64| {
                let (Some(centre), Some(rest)) = (self.values_of(whole_term), self.values_of(other)) else {
                    return false;
                };
                let is_part = |own: &Vec<f64>| is(&rest, &|point| -turned * sense * e[point] * own[point]);
                is(&centre, &|point| sense * whole[point]) && is_product(other) && beside.iter().any(is_part)
            };
            [1.0, -1.0].into_iter().any(|sense| has(first, second, sense) || has(second, first, sense))
        };
        let is_velocity = |member: &Member| {
            let names = member.expr.names();
            member.letter.is_some() && !names.iter().any(|name| member.letter.as_ref() == Some(&name.text))
        };
        let line = |turned: f64| {
            self.lines.iter().position(|studied| {
                !studied.line.is_crossed_out()
                    && self.members(studied).any(|(member, _)| is_velocity(member) && agrees(&member.expr, turned))
            })
        };
        let role = "the velocity by that of the centre of mass";
        match (line(1.0), code.is_accuracy()) {
            (Some(line), _) => Some(Evidence::given(line, role)),
            (None, false) => Some(Evidence::given(line(-1.0)?, role)),
            (None, true) => None,
        }
    }
}

/// Is it *e* times something, as it stands?
fn is_product(expr: &Expr) -> bool {
    match expr {
        Expr::Negative(inner) => is_product(inner),
        Expr::Product(_) | Expr::Quotient(..) => true,
        _ => false,
    }
}
