//! The direction of the line of centres from velocities before and after: from the heavy sphere or from the light one.
//!
//! Velocities are handed on as doubles, each rounded as well as can be; so it is the data that do not hold the answer.

use super::exactly;
use crate::number::{Fraction, Interval};
use crate::study::double::{BITS, Outcome, power_of_ten};
use crate::study::map::{Arrangement, Subject};

/// A is heavier than B by many powers of ten.
pub const UNEQUAL_MASSES: Subject = Subject {
    name: "line-of-centres-unequal-masses",
    quantity: "direction of the line of centres",
    regime: "mA = 10ᵏ mB",
    exponents: (0, 16),
    arrangements: &[
        Arrangement { name: "from-heavy", says: "the change of velocity of the heavy sphere" },
        Arrangement { name: "from-light", says: "the change of velocity of the light sphere" },
    ],
    scene: |k, deal| {
        let m_b = deal.mass();
        let masses = [m_b * power_of_ten(k as i32), m_b].map(exactly);
        let e = exactly(deal.restitution());
        let line = [deal.between(0.5, 1.0), deal.between(0.5, 1.0)].map(exactly);
        // A moves along the line of centres for the most part, and B against it.
        let before = [[deal.speed(), deal.speed()], [-deal.speed(), -deal.speed()]];
        let [u_a, u_b] = before.map(|velocity| velocity.map(exactly));
        let relative = [&u_a[0] - &u_b[0], &u_a[1] - &u_b[1]];
        let approach = &(&relative[0] * &line[0]) + &(&relative[1] * &line[1]);
        let size = &(&line[0] * &line[0]) + &(&line[1] * &line[1]);
        let per_mass = &(&(&Fraction::ONE + &e) * &approach) / &(&size * &(&masses[0] + &masses[1]));
        let share = |mass: &Fraction, place: usize| &(mass * &per_mass) * &line[place];
        let heavy = [0, 1].map(|place| before[0][place] - (&u_a[place] - &share(&masses[1], place)).to_f64());
        let light = [0, 1].map(|place| (&u_b[place] + &share(&masses[0], place)).to_f64() - before[1][place]);
        vec![off(heavy, &line), off(light, &line)]
    },
};

/// The angle between what was found and the line, in radians.
fn off(found: [f64; 2], line: &[Fraction; 2]) -> Outcome {
    if found == [0.0, 0.0] {
        return Outcome::NoNumber;
    }
    let [x, y] = found.map(exactly);
    let cross = &(&x * &line[1]) - &(&y * &line[0]);
    let dot = &(&x * &line[0]) + &(&y * &line[1]);
    let enclose = |value| Interval::from_fraction(&value, BITS);
    match Interval::atan2(&enclose(cross), &enclose(dot)) {
        Some(angle) => Outcome::Off(angle.to_f64().abs()),
        None => Outcome::NoNumber,
    }
}
