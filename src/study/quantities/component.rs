//! The component along the line of centres of a velocity nearly across it: from the angle, or from its complement.

use crate::number::Interval;
use crate::study::double::{BITS, Outcome, cos, enclosed, power_of_ten, radians_per_degree, sin};
use crate::study::map::{Arrangement, Subject};

/// The path is nearly across the line of centres.
pub const NEARLY_ACROSS: Subject = Subject {
    name: "component-nearly-across",
    quantity: "component u cos θ",
    regime: "θ = 90° - 10⁻ᵏ°",
    exponents: (0, 13),
    arrangements: &[
        Arrangement { name: "single", says: "u cos θ in single precision" },
        Arrangement { name: "cosine", says: "u cos θ, with θ turned into radians first" },
        Arrangement { name: "sine-of-complement", says: "u sin (90° - θ), with 90° - θ subtracted in degrees" },
    ],
    scene: |k, deal| {
        // A few of the last places of k differ from scene to scene.
        let degrees = 90.0 - deal.between(0.5, 1.0) * power_of_ten(-(k as i32));
        let u = deal.speed();
        let ratio = radians_per_degree();
        let truth = enclosed(u) * (enclosed(degrees) * degree()).cos();
        let single = (u as f32) * cos(f64::from(degrees as f32 * ratio as f32)) as f32;
        let cosine = u * cos(degrees * ratio);
        let complement = u * sin((90.0 - degrees) * ratio);
        [single.into(), cosine, complement].map(|found| Outcome::against(found, &truth)).to_vec()
    },
};

/// A degree in radians.
fn degree() -> Interval {
    let turn = Interval::pi(BITS).checked_div(&Interval::integer(180, BITS));
    turn.unwrap_or_else(|| Interval::integer(0, BITS))
}
