//! The impulse on a sphere: from its change of momentum, or from its formula.

use super::{after, after_exactly, exactly};
use crate::study::double::{Outcome, power_of_ten};
use crate::study::map::{Arrangement, Subject};

/// A runs after B and hardly catches up.
pub const NEARLY_EQUAL_SPEEDS: Subject = Subject {
    name: "impulse-nearly-equal-speeds",
    quantity: "impulse",
    regime: "uB = uA (1 - 10⁻ᵏ)",
    exponents: (0, 15),
    arrangements: &[
        Arrangement { name: "change-of-momentum", says: "mA (uA - vA), from the velocity after the impact" },
        Arrangement { name: "formula", says: "(1 + e) mA mB/(mA + mB) (uA - uB)" },
    ],
    scene: |k, deal| {
        let masses = [deal.mass(), deal.mass()];
        let u_a = deal.speed();
        let before = [u_a, u_a * (1.0 - power_of_ten(-(k as i32)))];
        let e = deal.restitution();
        let (m, u) = (masses.map(exactly), before.map(exactly));
        let [v_a, _] = after_exactly(m.each_ref(), u.each_ref(), &exactly(e));
        let truth = &m[0] * &(&u[0] - &v_a);
        let [m_a, m_b] = masses;
        let change = m_a * (before[0] - after(masses, before, e)[0]);
        let formula = (1.0 + e) * (m_a * m_b / (m_a + m_b)) * (before[0] - before[1]);
        vec![Outcome::relative(change, &truth), Outcome::relative(formula, &truth)]
    },
};
