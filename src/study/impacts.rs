//! Impacts for methods to solve: the regimes of the maps, in doubles that are taken for exact.

use super::double::{fraction, power_of_ten};
use super::map::Dealer;
use crate::method::{After, Impact};
use crate::number::{Fraction, Value};

/// A regime that grows harder with k, and in which methods differ.
#[derive(Clone, Copy)]
pub struct Regime {
    /// Its name: `stop-b-at-rest`.
    pub name: &'static str,
    /// In words, with k.
    pub words: &'static str,
    /// The values of k.
    pub exponents: (u32, u32),
    /// Deals an impact.
    pub impact: fn(k: u32, deal: &mut Dealer) -> Impact<f64>,
}

/// Every regime.
pub const REGIMES: &[Regime] = &[
    Regime {
        name: "stop-b-at-rest",
        words: "A nearly stops, B at rest: mA = e mB (1 + 10⁻ᵏ)",
        exponents: (0, 15),
        impact: |k, deal| {
            let (e, m_b) = (deal.restitution(), deal.mass());
            let m_a = e * m_b * (1.0 + power_of_ten(-(k as i32)));
            head_on([m_a, m_b], [deal.speed(), 0.0], e)
        },
    },
    Regime {
        name: "stop-b-moving",
        words: "A nearly stops, B moving: uB within 10⁻ᵏ of where A stops",
        exponents: (0, 15),
        impact: |k, deal| {
            let (e, u_a) = (deal.restitution(), deal.speed());
            let [m_a, m_b] = [deal.between(4.0, 8.0), deal.between(0.5, 2.0)];
            let stops = -(m_a - e * m_b) * u_a / ((1.0 + e) * m_b);
            head_on([m_a, m_b], [u_a, stops * (1.0 + power_of_ten(-(k as i32)))], e)
        },
    },
    Regime {
        name: "heavy-b",
        words: "mB = 10ᵏ mA",
        exponents: (1, 16),
        impact: |k, deal| {
            let m_a = deal.mass();
            let m_b = m_a * power_of_ten(k as i32) * deal.between(0.7, 1.3);
            head_on([m_a, m_b], [deal.speed(), -deal.speed()], deal.restitution())
        },
    },
    Regime {
        name: "heavy-a",
        words: "mA = 10ᵏ mB",
        exponents: (1, 16),
        impact: |k, deal| {
            let m_b = deal.mass();
            let m_a = m_b * power_of_ten(k as i32) * deal.between(0.7, 1.3);
            head_on([m_a, m_b], [deal.speed(), -deal.speed()], deal.restitution())
        },
    },
    Regime {
        name: "nearly-inelastic",
        words: "e = 10⁻ᵏ",
        exponents: (0, 15),
        impact: |k, deal| {
            head_on([deal.mass(), deal.mass()], [deal.speed(), deal.between(0.1, 0.9)], power_of_ten(-(k as i32)))
        },
    },
    Regime {
        name: "nearly-elastic",
        words: "e = 1 - 10⁻ᵏ",
        exponents: (0, 15),
        impact: |k, deal| {
            let e = 1.0 - power_of_ten(-(k as i32));
            head_on([deal.mass(), 10.0 + deal.mass()], [deal.speed(), -deal.speed()], e)
        },
    },
    Regime {
        name: "nearly-equal-speeds",
        words: "uB = uA (1 - 10⁻ᵏ)",
        exponents: (0, 15),
        impact: |k, deal| {
            let u = deal.speed();
            let u_b = u * (1.0 - power_of_ten(-(k as i32)));
            head_on([deal.mass(), deal.mass()], [u, u_b], deal.restitution())
        },
    },
    Regime {
        name: "grazing",
        words: "cot of the angle between path and line of centres = 10⁻ᵏ, B at rest",
        exponents: (0, 15),
        impact: |k, deal| {
            let [x, y] = [deal.speed(), deal.speed()];
            let slope = power_of_ten(-(k as i32));
            // A line turned from the path by a right angle less about 10^-k.
            Impact {
                masses: [deal.mass(), deal.mass()],
                before: [[x, y], [0.0, 0.0]],
                line: [slope * x - y, slope * y + x],
                restitution: deal.restitution(),
            }
        },
    },
    Regime {
        name: "large-units",
        words: "both masses times 10²⁰ᵏ",
        exponents: (0, 15),
        impact: |k, deal| {
            let unit = power_of_ten(20 * k as i32);
            let masses = [deal.mass() * unit, deal.mass() * unit];
            head_on(masses, [deal.speed(), -deal.speed()], deal.restitution())
        },
    },
    Regime {
        name: "small-units",
        words: "both masses times 10⁻²⁰ᵏ",
        exponents: (0, 15),
        impact: |k, deal| {
            let unit = power_of_ten(-20 * k as i32);
            let masses = [deal.mass() * unit, deal.mass() * unit];
            head_on(masses, [deal.speed(), -deal.speed()], deal.restitution())
        },
    },
];

/// Along **i**.
fn head_on(masses: [f64; 2], before: [f64; 2], e: f64) -> Impact<f64> {
    Impact { masses, before: before.map(|u| [u, 0.0]), line: [1.0, 0.0], restitution: e }
}

/// An impact as those of examinations are, in whole numbers and small fractions; the spheres do meet.
pub fn ordinary(deal: &mut Dealer) -> Impact<Fraction> {
    loop {
        let mut whole = |low: i64, high: i64| low + deal.below((high - low + 1) as u64) as i64;
        let masses = [whole(1, 9), whole(1, 9)].map(Fraction::from);
        let before = [[whole(-9, 9), whole(-9, 9)], [whole(-9, 9), whole(-9, 9)]];
        let line = [whole(-4, 4), whole(-4, 4)];
        let parts = whole(2, 10);
        let e = Fraction::new(whole(1, parts), parts);
        let approach = (0..2).map(|place| (before[0][place] - before[1][place]) * line[place]).sum::<i64>();
        if approach > 0 {
            let before = before.map(|velocity| velocity.map(Fraction::from));
            return Impact { masses, before, line: line.map(Fraction::from), restitution: e };
        }
    }
}

/// The numbers of an impact as the fractions that its doubles are.
pub fn exactly(impact: &Impact<f64>) -> Option<Impact<Fraction>> {
    impact.turned_into(|number| fraction(*number))
}

/// As methods take it.
pub fn in_values(impact: &Impact<Fraction>) -> Impact<Value> {
    Impact {
        masses: impact.masses.clone().map(Value::Rational),
        before: impact.before.clone().map(|velocity| velocity.map(Value::Rational)),
        line: impact.line.clone().map(Value::Rational),
        restitution: Value::Rational(impact.restitution.clone()),
    }
}

/// What comes of it, in fractions: each sphere's momentum changes by the impulse along the line of centres.
///
/// Written here once more, so that the reference of the study shares no code with any method.
pub fn truth(impact: &Impact<Fraction>) -> After<Fraction> {
    let [m_a, m_b] = &impact.masses;
    let [u_a, u_b] = &impact.before;
    let line = &impact.line;
    let dot = |one: &[Fraction; 2], other: &[Fraction; 2]| &(&one[0] * &other[0]) + &(&one[1] * &other[1]);
    let approach = &dot(u_a, line) - &dot(u_b, line);
    let impulse =
        &(&(&(&Fraction::ONE + &impact.restitution) * &approach) * &(m_a * m_b)) / &(&(m_a + m_b) * &dot(line, line));
    let moved = |u: &[Fraction; 2], per: Fraction| std::array::from_fn(|place| &u[place] + &(&per * &line[place]));
    [moved(u_a, -(&impulse / m_a)), moved(u_b, &impulse / m_b)]
}
