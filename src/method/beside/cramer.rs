//! The equations of momentum and restitution by Cramer's rule in doubles.
//!
//! `m_A v_A + m_B v_B = p` and `v_B - v_A = s` have the determinant `m_A + m_B`: `v_A = (p - m_B s)/(m_A + m_B)`, `v_B = (p + m_A s)/(m_A + m_B)`.

use super::along::along;
use crate::method::batch::floats;
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// Cramer's rule.
pub(in crate::method) struct Cramer;

impl Method for Cramer {
    fn name(&self) -> &'static str {
        "cramer"
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
    let (momentum, separation, determinant) = (m_a * a + m_b * b, e * (a - b), m_a + m_b);
    [(momentum - m_b * separation) / determinant, (momentum + m_a * separation) / determinant]
}
