//! Kinetic energy lost along the line of centres: as a difference, or from its formula.

use super::{after, after_exactly, exactly};
use crate::number::Fraction;
use crate::study::double::{Outcome, power_of_ten};
use crate::study::map::{Arrangement, Subject};

const ARRANGEMENTS: &[Arrangement] = &[
    Arrangement { name: "difference", says: "the energy before less the energy after" },
    Arrangement { name: "factored", says: "½m(u - v)(u + v) for each sphere, added" },
    Arrangement {
        name: "one-less-e-squared", says: "½ mA mB/(mA + mB) (1 - e²) (uA - uB)², with 1 - e² as written"
    },
    Arrangement { name: "formula", says: "½ mA mB/(mA + mB) (1 - e)(1 + e) (uA - uB)²" },
];

/// Nearly everything comes back.
pub const NEARLY_ELASTIC: Subject = Subject {
    name: "energy-nearly-elastic",
    quantity: "kinetic energy lost",
    regime: "e = 1 - 10⁻ᵏ",
    exponents: (0, 15),
    arrangements: ARRANGEMENTS,
    scene: |k, deal| {
        let masses = [deal.mass(), deal.mass()];
        let before = [deal.speed(), -deal.speed()];
        outcomes(masses, before, 1.0 - power_of_ten(-(k as i32)))
    },
};

/// A runs after B and hardly catches up.
pub const NEARLY_EQUAL_SPEEDS: Subject = Subject {
    name: "energy-nearly-equal-speeds",
    quantity: "kinetic energy lost",
    regime: "uB = uA (1 - 10⁻ᵏ)",
    exponents: (0, 15),
    arrangements: ARRANGEMENTS,
    scene: |k, deal| {
        let masses = [deal.mass(), deal.mass()];
        let u_a = deal.speed();
        outcomes(masses, [u_a, u_a * (1.0 - power_of_ten(-(k as i32)))], deal.restitution())
    },
};

/// How far each arrangement is off for one scene.
fn outcomes(masses: [f64; 2], before: [f64; 2], e: f64) -> Vec<Outcome> {
    let truth = lost(masses, before, e);
    let [m_a, m_b] = masses;
    let [u_a, u_b] = before;
    let [v_a, v_b] = after(masses, before, e);
    let difference = (0.5 * m_a * u_a * u_a + 0.5 * m_b * u_b * u_b) - (0.5 * m_a * v_a * v_a + 0.5 * m_b * v_b * v_b);
    let factored = 0.5 * m_a * (u_a - v_a) * (u_a + v_a) + 0.5 * m_b * (u_b - v_b) * (u_b + v_b);
    let approach = u_a - u_b;
    let reduced = m_a * m_b / (m_a + m_b);
    let squared = 0.5 * reduced * (1.0 - e * e) * approach * approach;
    let formula = 0.5 * reduced * (1.0 - e) * (1.0 + e) * approach * approach;
    [difference, factored, squared, formula].map(|found| Outcome::relative(found, &truth)).to_vec()
}

/// The energy lost exactly, as a difference, which in fractions costs nothing.
fn lost(masses: [f64; 2], before: [f64; 2], e: f64) -> Fraction {
    let (masses, before, e) = (masses.map(exactly), before.map(exactly), exactly(e));
    let after = after_exactly(masses.each_ref(), before.each_ref(), &e);
    let energy = |velocities: &[Fraction; 2]| {
        let of = |sphere: usize| &masses[sphere] * &(&velocities[sphere] * &velocities[sphere]);
        &(&of(0) + &of(1)) * &Fraction::new(1, 2)
    };
    &energy(&before) - &energy(&after)
}
