//! The formula of textbooks in doubles: `v_A = ((m_A - e m_B) u_A + (1+e) m_B u_B)/(m_A + m_B)` and v_B likewise.

use super::along::along;
use crate::method::batch::floats;
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// The formula of textbooks.
pub(in crate::method) struct Textbook;

impl Method for Textbook {
    fn name(&self) -> &'static str {
        "textbook"
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
    let total = m_a + m_b;
    [((m_a - e * m_b) * a + (1.0 + e) * m_b * b) / total, ((1.0 + e) * m_a * a + (m_b - e * m_a) * b) / total]
}
