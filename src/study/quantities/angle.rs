//! The angle between two velocities that are nearly parallel.

use super::exactly;
use crate::number::Interval;
use crate::study::double::{BITS, Outcome, acos, atan2, power_of_ten};
use crate::study::map::{Arrangement, Subject};

/// Hardly any angle.
pub const NEARLY_PARALLEL: Subject = Subject {
    name: "angle-nearly-parallel",
    quantity: "angle between two velocities",
    regime: "10⁻ᵏ radians",
    exponents: (0, 15),
    arrangements: &[
        Arrangement { name: "acos", says: "cos⁻¹ of the scalar product over both sizes" },
        Arrangement { name: "atan2", says: "tan⁻¹ of the vector product over the scalar product" },
        Arrangement { name: "atan2-exact-product", says: "the same, with the vector product kept to its last figure" },
    ],
    scene: |k, deal| {
        let [x, y] = [deal.speed(), deal.speed()];
        let turn = power_of_ten(-(k as i32));
        let [p, q] = [x - turn * y, y + turn * x];
        let [exact_x, exact_y, exact_p, exact_q] = [x, y, p, q].map(exactly);
        let enclose = |value| Interval::from_fraction(&value, BITS);
        let cross = enclose(&(&exact_x * &exact_q) - &(&exact_y * &exact_p));
        let along = enclose(&(&exact_x * &exact_p) + &(&exact_y * &exact_q));
        let truth = Interval::atan2(&cross, &along).unwrap_or_else(|| Interval::integer(0, BITS));
        let dot = x * p + y * q;
        let sizes = (x * x + y * y).sqrt() * (p * p + q * q).sqrt();
        let found = [acos(dot / sizes), atan2(x * q - y * p, dot), atan2(product(x, q, y, p), dot)];
        found.map(|found| Outcome::against(found, &truth)).to_vec()
    },
};

/// a b - c d to within two roundoffs: what the product c d loses by rounding is found by a fused operation and given
/// back (the method is Kahan's).
fn product(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let rounded = c * d;
    let lost = (-c).mul_add(d, rounded);
    a.mul_add(b, -rounded) + lost
}
