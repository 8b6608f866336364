//! Quantities that follow from an impact, each in the arrangements that people use; one file a quantity, one list.

mod angle;
mod component;
mod deflection;
mod energy;
mod impulse;
mod line_of_centres;
mod restitution;
mod separation;
mod simulation;

use super::map::Subject;
use crate::number::Fraction;

/// Every subject whose arrangements are formulas. To add one, write its file and add its line.
pub const QUANTITIES: &[Subject] = &[
    energy::NEARLY_ELASTIC,
    energy::NEARLY_EQUAL_SPEEDS,
    impulse::NEARLY_EQUAL_SPEEDS,
    separation::NEARLY_INELASTIC,
    component::NEARLY_ACROSS,
    deflection::GRAZING,
    angle::NEARLY_PARALLEL,
    line_of_centres::UNEQUAL_MASSES,
    restitution::NEARLY_EQUAL_SPEEDS,
    restitution::NEARLY_HALF,
    simulation::STEPS,
    simulation::LOOKS,
];

/// Velocities along the line of centres after an impact, in the doubles of a class-room formula.
fn after(masses: [f64; 2], before: [f64; 2], e: f64) -> [f64; 2] {
    let [m_a, m_b] = masses;
    let [u_a, u_b] = before;
    let g = (1.0 + e) * (u_a - u_b) / (m_a + m_b);
    [u_a - m_b * g, u_b + m_a * g]
}

/// The same exactly.
fn after_exactly(masses: [&Fraction; 2], before: [&Fraction; 2], e: &Fraction) -> [Fraction; 2] {
    let [m_a, m_b] = masses;
    let [u_a, u_b] = before;
    let g = &(&(&Fraction::ONE + e) * &(u_a - u_b)) / &(m_a + m_b);
    [u_a - &(m_b * &g), u_b + &(m_a * &g)]
}

/// What a double of a dealt scene is exactly; such doubles are finite.
fn exactly(value: f64) -> Fraction {
    super::double::fraction(value).unwrap_or(Fraction::ZERO)
}
