//! The shortest way through an impact, for any kind of number: one quotient for both spheres.
//!
//! `g = (1+e) (u_A - u_B)·l / ((m_A + m_B) l·l)`; A loses `m_B g l` and B gains `m_A g l`. As l need not be a unit
//! vector, no root is taken, and a velocity that is rational stays so.

use super::{After, Impact};
use crate::number::Number;

/// Both velocities after; `None` where the quotient does not exist.
pub(super) fn any_line<N: Number>(impact: &Impact<N>) -> Option<After<N>> {
    let [m_a, m_b] = impact.masses.clone();
    let [[a_x, a_y], [b_x, b_y]] = impact.before.clone();
    let [x, y] = impact.line.clone();
    let e = impact.restitution.clone();
    let approach = (a_x.clone() - b_x.clone()) * x.clone() + (a_y.clone() - b_y.clone()) * y.clone();
    let per_mass = ((e.one() + e) * approach).over(&((m_a.clone() + m_b.clone()) * (x.squared() + y.squared())))?;
    // A loses m_B of it and B gains m_A of it: their changes are as the masses of the others.
    let (to_a, to_b) = (m_b * per_mass.clone(), m_a * per_mass);
    Some([[a_x - to_a.clone() * x.clone(), a_y - to_a * y.clone()], [b_x + to_b.clone() * x, b_y + to_b * y]])
}
