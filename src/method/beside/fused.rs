//! Two arrangements in doubles with fused multiply-add, which rounds a product and a sum once instead of twice.
//!
//! Where the target has no such instruction, `mul_add` is a call to a library several times as dear, with the same bits.
//! For data that *are* doubles fusing is more accurate: with B at rest the relative error never grows, however nearly A
//! stops. For data that stand for fractions it is not: 1/3 as a double is no third, and fusing faithfully shows it.

use super::along::along;
use crate::method::batch::floats;
use crate::method::{Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::Value;

/// What both accept.
const ACCEPTS: &str = "all nine numbers without letters, any line of centres";

/// One quotient, fused.
pub(in crate::method) struct FusedRatio;

impl Method for FusedRatio {
    fn name(&self) -> &'static str {
        "ratio-fused"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        ACCEPTS
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(64.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        floats(impacts, |impact| along(impact, ratio))
    }
}

#[inline(always)]
fn ratio([m_a, m_b]: [f64; 2], [a, b]: [f64; 2], e: f64) -> [f64; 2] {
    let per_mass = (1.0 + e) * (a - b) / (m_a + m_b);
    [per_mass.mul_add(-m_b, a), per_mass.mul_add(m_a, b)]
}

/// The formula of textbooks, fused.
pub(in crate::method) struct FusedTextbook;

impl Method for FusedTextbook {
    fn name(&self) -> &'static str {
        "textbook-fused"
    }

    fn role(&self) -> Role {
        Role::Beside
    }

    fn accepts(&self) -> &'static str {
        ACCEPTS
    }

    fn promises(&self) -> Promise {
        Promise::Scaled(64.0)
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        floats(impacts, |impact| along(impact, textbook))
    }
}

#[inline(always)]
fn textbook([m_a, m_b]: [f64; 2], [a, b]: [f64; 2], e: f64) -> [f64; 2] {
    let total = m_a + m_b;
    let (own_a, own_b, other) = ((-e).mul_add(m_b, m_a), (-e).mul_add(m_a, m_b), 1.0 + e);
    [own_a.mul_add(a, other * m_b * b) / total, own_b.mul_add(b, other * m_a * a) / total]
}
