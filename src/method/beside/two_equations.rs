//! Momentum and restitution as two equations along the line of centres, by Gauss's elimination in doubles.
//!
//! `m_A v_A + m_B v_B = p` and `-v_A + v_B = s`. One unknown is taken from the second equation by a multiple of the first, and
//! which equation is first makes the difference: with the masses as they come, with the larger leading coefficient first
//! ("pivoted"), or so after each row has been divided by its largest coefficient ("scaled"). Masses of 1e12 kg and 1 kg beside
//! the ones of the second equation look like figures of different weight, though they are not.

use super::along::along;
use crate::method::batch::floats;
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Which equation comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum TwoEquations {
    /// Momentum.
    Plain,
    /// The one with the larger coefficient of the first unknown.
    Pivoted,
    /// The same after scaling each row.
    Scaled,
}

impl Method for TwoEquations {
    fn name(&self) -> &'static str {
        match self {
            TwoEquations::Plain => "gauss-plain",
            TwoEquations::Pivoted => "gauss-pivoted",
            TwoEquations::Scaled => "gauss-scaled",
        }
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, any line of centres"
    }

    fn promises(&self) -> Promise {
        match self {
            TwoEquations::Scaled => Promise::Scaled(64.0),
            _ => Promise::Nothing("figures are lost where the masses are far from each other and from one"),
        }
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        match self {
            TwoEquations::Plain => floats(impacts, |impact| along(impact, |m, u, e| eliminate(rows(m, u, e)))),
            TwoEquations::Pivoted => floats(impacts, |impact| along(impact, |m, u, e| pivoted(rows(m, u, e)))),
            TwoEquations::Scaled => floats(impacts, |impact| along(impact, |m, u, e| pivoted(scaled(rows(m, u, e))))),
        }
    }
}

/// Coefficients of both unknowns and the right side.
type Rows = [[f64; 3]; 2];

#[inline(always)]
fn rows([m_a, m_b]: [f64; 2], [a, b]: [f64; 2], e: f64) -> Rows {
    [[m_a, m_b, m_a * a + m_b * b], [-1.0, 1.0, e * (a - b)]]
}

#[inline(always)]
fn scaled(rows: Rows) -> Rows {
    rows.map(|row| {
        let largest = row[0].abs().max(row[1].abs());
        row.map(|entry| entry / largest)
    })
}

#[inline(always)]
fn pivoted([first, second]: Rows) -> [f64; 2] {
    eliminate(if second[0].abs() > first[0].abs() { [second, first] } else { [first, second] })
}

#[inline(always)]
fn eliminate([[p, q, r], [s, t, u]]: Rows) -> [f64; 2] {
    let share = s / p;
    let second = (u - share * r) / (t - share * q);
    [(r - q * second) / p, second]
}
