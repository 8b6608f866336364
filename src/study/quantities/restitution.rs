//! Where e is asked for, or an angle follows from it: two places where the data cannot be rounded.

use super::{after_exactly, exactly};
use crate::number::{Fraction, Places, round};
use crate::study::double::Outcome;
use crate::study::map::{Arrangement, Subject};

/// e from the four velocities, two of which are nearly equal.
pub const NEARLY_EQUAL_SPEEDS: Subject = Subject {
    name: "restitution-nearly-equal-speeds",
    quantity: "coefficient of restitution",
    regime: "uB = uA (1 - 10⁻ᵏ)",
    exponents: (0, 15),
    arrangements: &[
        Arrangement { name: "four-figures", says: "(vB - vA)/(uA - uB), with velocities to 4 figures" },
        Arrangement { name: "quotient", says: "(vB - vA)/(uA - uB), with velocities to 16 figures" },
        Arrangement { name: "fractions", says: "the same with exact velocities" },
    ],
    scene: |k, deal| {
        let masses = [deal.mass(), deal.mass()].map(exactly);
        let u_a = exactly(deal.speed());
        let ratio = &Fraction::ONE - &exactly_ten_to_minus(k);
        let before = [u_a.clone(), &u_a * &ratio];
        let e = exactly(deal.restitution());
        let after = after_exactly(masses.each_ref(), before.each_ref(), &e);
        let all = [&after[1], &after[0], &before[0], &before[1]];
        let [p, q, r, s] = all.map(|velocity| round(velocity, &Places::SignificantFigures(4)).to_fraction());
        let four_figures = match (&r - &s).is_zero() {
            true => f64::NAN,
            false => (&(&p - &q) / &(&r - &s)).to_f64(),
        };
        let [p, q, r, s] = all.map(Fraction::to_f64);
        let [exact_p, exact_q, exact_r, exact_s] = all;
        let exact = &(exact_p - exact_q) / &(exact_r - exact_s);
        let found = [four_figures, (p - q) / (r - s), exact.to_f64()];
        found.map(|found| Outcome::relative(found, &e)).to_vec()
    },
};

/// The angle at which the paths part in one exercise: it exists from e = 1/2 on.
pub const NEARLY_HALF: Subject = Subject {
    name: "tangent-nearly-half",
    quantity: "tan² θ = (2e - 1)/3",
    regime: "e = ½ + 10⁻ᵏ",
    exponents: (1, 17),
    arrangements: &[
        Arrangement { name: "three-decimals", says: "(2e - 1)/3, with e to 3 decimal places" },
        Arrangement { name: "double", says: "(2e - 1)/3, with e to 16 figures" },
        Arrangement { name: "fractions", says: "(2e - 1)/3 with e as a fraction" },
    ],
    scene: |k, deal| {
        // Any number of tenths from 1 to 9.9, so that no column depends on one e.
        let tenths = Fraction::from(1 + deal.between(10.0, 99.0) as i64);
        let e = &Fraction::new(1, 2) + &(&(&tenths * &Fraction::new(1, 100)) * &exactly_ten_to_minus(k));
        let tangent = |e: &Fraction| &(&(e * &Fraction::from(2)) - &Fraction::ONE) * &Fraction::new(1, 3);
        let truth = tangent(&e);
        let decimals = round(&e, &Places::DecimalPlaces(3)).to_fraction();
        let double = e.to_f64();
        let found = [tangent(&decimals).to_f64(), (2.0 * double - 1.0) / 3.0, truth.to_f64()];
        found.map(|found| Outcome::relative(found, &truth)).to_vec()
    },
};

/// 10^-k exactly, which no double is.
fn exactly_ten_to_minus(k: u32) -> Fraction {
    Fraction::from(10).power(-(k as i32)).unwrap_or(Fraction::ZERO)
}
