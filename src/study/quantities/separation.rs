//! The speed at which the spheres part: from their two velocities, or from the law of restitution.

use super::{after, after_exactly, exactly};
use crate::study::double::{Outcome, power_of_ten};
use crate::study::map::{Arrangement, Subject};

/// They hardly part at all.
pub const NEARLY_INELASTIC: Subject = Subject {
    name: "separation-nearly-inelastic",
    quantity: "speed of separation",
    regime: "e = 10⁻ᵏ",
    exponents: (0, 15),
    arrangements: &[
        Arrangement { name: "difference", says: "vB - vA, from the velocities after the impact" },
        Arrangement { name: "restitution", says: "e (uA - uB)" },
    ],
    scene: |k, deal| {
        let masses = [deal.mass(), deal.mass()];
        let before = [deal.speed(), -deal.speed()];
        let e = power_of_ten(-(k as i32));
        let (m, u) = (masses.map(exactly), before.map(exactly));
        let [v_a, v_b] = after_exactly(m.each_ref(), u.each_ref(), &exactly(e));
        let truth = &v_b - &v_a;
        let found = after(masses, before, e);
        let (difference, restitution) = (found[1] - found[0], e * (before[0] - before[1]));
        vec![Outcome::relative(difference, &truth), Outcome::relative(restitution, &truth)]
    },
};
