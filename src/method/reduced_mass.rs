//! The impulse by the reduced mass: no equations to solve, and no axes to turn.
//!
//! `J = μ (1+e) (u_A - u_B)·l / (l·l) l` with `1/μ = 1/m_A + 1/m_B`, for any vector l along the line of centres;
//! B receives J and A receives -J. As `l` need not be a unit vector, a velocity that is rational stays so.

use super::{After, Impact, Method};
use crate::number::Number;

pub(super) const METHOD: Method = Method {
    name: "reduced-mass",
    accepts: "both masses, both velocities before, the line of centres and e; exact values, letters, intervals and floats",
    exact: Some(solve),
    certified: Some(solve),
    float: Some(solve),
};

fn solve<N: Number>(impact: &Impact<N>) -> Option<After<N>> {
    let [m_a, m_b] = impact.masses.clone();
    let [[a_x, a_y], [b_x, b_y]] = impact.before.clone();
    let [l_x, l_y] = impact.line.clone();
    let e = impact.restitution.clone();
    let approach = (a_x.clone() - b_x.clone()) * l_x.clone() + (a_y.clone() - b_y.clone()) * l_y.clone();
    let per_mass =
        (approach.clone() + e * approach).over(&((m_a.clone() + m_b.clone()) * (l_x.squared() + l_y.squared())))?;
    // A loses m_B of it and B gains m_A of it: their changes are as the masses of the others.
    let (a, b) = (m_b * per_mass.clone(), m_a * per_mass);
    let after_a = [a_x - a.clone() * l_x.clone(), a_y - a * l_y.clone()];
    let after_b = [b_x + b.clone() * l_x, b_y + b * l_y];
    Some([after_a, after_b])
}
