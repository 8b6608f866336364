//! In doubles, seen from the centre of mass: there each sphere's velocity turns round and shrinks by e.
//!
//! `c = (m_A u_A + m_B u_B)/(m_A + m_B)`, then `v_A = c - e (u_A - c)` and `v_B = c - e (u_B - c)`. Along the line of
//! centres only; no impulse and no equation for restitution occur.

use super::along::along;
use crate::method::batch::floats;
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// The view from the centre of mass.
pub(in crate::method) struct CentreOfMass;

impl Method for CentreOfMass {
    fn name(&self) -> &'static str {
        "centre-of-mass"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters, any line of centres"
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(64.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        floats(impacts, |impact| along(impact, on_line))
    }
}

#[inline(always)]
fn on_line([m_a, m_b]: [f64; 2], [a, b]: [f64; 2], e: f64) -> [f64; 2] {
    let centre = (m_a * a + m_b * b) / (m_a + m_b);
    [centre - e * (a - centre), centre - e * (b - centre)]
}
