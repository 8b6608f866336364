//! The angle through which a path turns in a grazing impact with a sphere at rest.
//!
//! Axes: x along the line of centres, y across it. The component across, t, does not change; the one along it goes from
//! c to c'.

use super::exactly;
use crate::number::{Fraction, Interval};
use crate::study::double::{BITS, Outcome, acos, atan2, power_of_ten};
use crate::study::map::{Arrangement, Subject};

/// The impact is nearly missed.
pub const GRAZING: Subject = Subject {
    name: "deflection-grazing",
    quantity: "angle of deflection",
    regime: "cot of the angle with the line of centres = 10⁻ᵏ",
    exponents: (0, 15),
    arrangements: &[
        Arrangement { name: "acos", says: "cos⁻¹ of the scalar product over both speeds" },
        Arrangement { name: "subtraction", says: "the angle after less the angle before" },
        Arrangement { name: "components", says: "tan δ = t (c - c')/(t² + c c'), with c - c' from the impulse" },
    ],
    scene: |k, deal| {
        let t = deal.speed();
        let c = t * power_of_ten(-(k as i32));
        let [m_a, m_b, e] = [deal.mass(), deal.mass(), deal.restitution()];
        let change = (1.0 + e) * m_b * c / (m_a + m_b);
        let after = c - change;
        let truth = turned([m_a, m_b, e, c, t].map(exactly));
        let sizes = (c * c + t * t).sqrt() * (after * after + t * t).sqrt();
        let found =
            [acos((c * after + t * t) / sizes), atan2(t, after) - atan2(t, c), atan2(t * change, t * t + c * after)];
        found.map(|found| Outcome::against(found, &truth)).to_vec()
    },
};

/// The angle of deflection, enclosed.
fn turned([m_a, m_b, e, c, t]: [Fraction; 5]) -> Interval {
    let change = &(&(&(&Fraction::ONE + &e) * &m_b) * &c) / &(&m_a + &m_b);
    let cross = &t * &change;
    let dot = &(&t * &t) + &(&c * &(&c - &change));
    let enclose = |value: &Fraction| Interval::from_fraction(value, BITS);
    Interval::atan2(&enclose(&cross), &enclose(&dot)).unwrap_or_else(|| Interval::integer(0, BITS))
}
