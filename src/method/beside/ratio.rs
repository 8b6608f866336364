//! One quotient in doubles: `g = (1+e)(u_A - u_B)/(m_A + m_B)`, then `v_A = u_A - m_B g` and `v_B = u_B + m_A g`.
//!
//! The shortest arrangement, and the float that others are measured against.

use super::along::along;
use crate::method::batch::floats;
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// One quotient for both spheres.
pub(in crate::method) struct Ratio;

impl Method for Ratio {
    fn name(&self) -> &'static str {
        "ratio"
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
    let per_mass = (1.0 + e) * (a - b) / (m_a + m_b);
    [a - per_mass * m_b, b + per_mass * m_a]
}
