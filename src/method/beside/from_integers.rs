//! One quotient in doubles from the integers that the exact method has: what exactness is measured against.
//!
//! It turns the same whole numbers into doubles, and must divide p by q where the exact method need not.

use crate::method::answer::{integers, matrix};
use crate::method::batch::{batch, float};
use crate::method::{After, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Doubles from whole numbers.
pub(in crate::method) struct FromIntegers;

impl Method for FromIntegers {
    fn name(&self) -> &'static str {
        "ratio-from-integers"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "what the exact integers accept, with a line of centres along an axis"
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(64.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        let form = |impact: &Impact<Value>| {
            let whole = matrix::whole::<1>(impact, integers::elements).map_err(|unfit| unfit.words("a fraction"))?;
            // Fractions, or there would be no whole form.
            let float = |value: &Value| value.to_f64().unwrap_or(f64::NAN);
            let before = impact.before.each_ref().map(|velocity| velocity.each_ref().map(float));
            match whole.on_line() {
                Some((line, axis, below)) => Ok((line, (before, axis, below))),
                None => Err("the line of centres lies along neither axis".to_owned()),
            }
        };
        batch(impacts, form, solve, |(before, axis, below): &(After<f64>, usize, i64), along: &[f64; 2]| {
            let mut after = *before;
            for (velocity, component) in after.iter_mut().zip(along) {
                velocity[*axis] = component / matrix::double(*below);
            }
            float(after)
        })
    }
}

#[inline(always)]
fn solve(impact: &matrix::OnLine<1>) -> [f64; 2] {
    let [m_a, m_b] = impact.masses.map(matrix::double);
    let [p, q] = impact.e.map(matrix::double);
    let [[a], [b]] = impact.along.map(|along| along.map(matrix::double));
    let per_mass = (1.0 + p / q) * (a - b) / (m_a + m_b);
    [a - per_mass * m_b, b + per_mass * m_a]
}
