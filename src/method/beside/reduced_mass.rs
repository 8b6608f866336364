//! The impulse by the reduced mass, in doubles: no equations to solve, and no axes to turn.
//!
//! `J = μ (1+e) (u_A - u_B)·l / (l·l) l` with `1/μ = 1/m_A + 1/m_B`, for any vector l along the line of centres;
//! B receives J and A receives -J, and each changes its velocity by it over its own mass.

use crate::method::batch::floats;
use crate::method::{After, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// The impulse by the reduced mass.
pub(in crate::method) struct ReducedMass;

impl Method for ReducedMass {
    fn name(&self) -> &'static str {
        "reduced-mass"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, any line of centres; the product of the masses must not overflow"
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(64.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        floats(impacts, solve)
    }
}

#[inline(always)]
fn solve(impact: &Impact<f64>) -> After<f64> {
    let ([m_a, m_b], [a, b], [x, y]) = (impact.masses, impact.before, impact.line);
    let approach = ((a[0] - b[0]) * x + (a[1] - b[1]) * y) / (x * x + y * y);
    let impulse = (1.0 + impact.restitution) * (m_a * m_b / (m_a + m_b)) * approach;
    let (to_a, to_b) = (impulse / m_a, impulse / m_b);
    [[a[0] - to_a * x, a[1] - to_a * y], [b[0] + to_b * x, b[1] + to_b * y]]
}
