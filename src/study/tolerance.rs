//! Rounding on the way: how far the last figure moves if every value on the way is written with few figures.
//!
//! A chain is the working of a question, step by step. It is carried out three times in intervals: with everything kept;
//! with every step rounded, as by a student who writes it down and types it in again; and with every step widened by
//! half a unit of its last figure to both sides. What an honest student can arrive at lies in the third, so its half
//! width is a tolerance that wrongs nobody.

use std::cmp::Ordering;

use super::map::Dealer;
use crate::number::{Fraction, Interval, Places, round};

/// Binary places: enough for thirty figures.
const BITS: usize = 128;

/// The numbers of a scene as it is printed: angles in whole degrees with the line of centres.
#[derive(Clone, Debug)]
pub struct Printed {
    masses: [Interval; 2],
    e: Interval,
    speeds: [Interval; 2],
    angles: [Interval; 2],
}

/// What is done with a value on the way.
type Keep<'k> = &'k dyn Fn(Interval) -> Option<Interval>;

/// The working of a question.
#[derive(Clone, Copy)]
pub struct Chain {
    /// What is asked for: `speed of A`.
    pub quantity: &'static str,
    /// How it is worked out.
    pub working: &'static str,
    /// Carries it out; every value that is written down on the way goes through `keep`.
    pub carry: fn(&Printed, Keep) -> Option<Interval>,
}

/// Every chain of the table.
pub const CHAINS: &[Chain] = &[
    Chain {
        quantity: "speed of A",
        working: "B at rest: components, then the root of the sum of squares",
        carry: |s, keep| {
            let along = after(s, keep)?[0].clone();
            let across = across(s, 0, keep)?;
            keep(along.clone() * along)?.plus(keep(across.clone() * across)?).sqrt()
        },
    },
    Chain {
        quantity: "direction of A",
        working: "B at rest: the tangent from both components",
        carry: |s, keep| degrees(Interval::atan2(&across(s, 0, keep)?, &after(s, keep)?[0])?),
    },
    Chain {
        quantity: "deflection of A",
        working: "B at rest: the direction after less that before",
        carry: |s, keep| {
            let direction = keep(degrees(Interval::atan2(&across(s, 0, keep)?, &after(s, keep)?[0])?)?)?;
            Some(direction - s.angles[0].clone())
        },
    },
    Chain {
        quantity: "energy lost, difference",
        working: "B at rest: all energy before less all energy after",
        carry: |s, keep| {
            let [v_a, v_b] = after(s, keep)?;
            let across = across(s, 0, keep)?;
            let before = keep(half(s.masses[0].clone() * square(&s.speeds[0])))?;
            let a = keep(half(s.masses[0].clone() * (square(&v_a) + square(&across))))?;
            let b = keep(half(s.masses[1].clone() * square(&v_b)))?;
            Some(before - (a + b))
        },
    },
    Chain {
        quantity: "energy lost along the line",
        working: "B at rest: the same with components along the line of centres alone",
        carry: |s, keep| {
            let u = along(s, 0, keep)?;
            let [v_a, v_b] = after(s, keep)?;
            let before = keep(half(s.masses[0].clone() * square(&u)))?;
            let a = keep(half(s.masses[0].clone() * square(&v_a)))?;
            let b = keep(half(s.masses[1].clone() * square(&v_b)))?;
            Some(before - (a + b))
        },
    },
    Chain {
        quantity: "energy lost, formula",
        working: "B at rest: ½ mA mB/(mA + mB) (1 - e²) u²",
        carry: |s, keep| {
            let u = along(s, 0, keep)?;
            let [m_a, m_b] = s.masses.clone();
            let reduced = keep((m_a.clone() * m_b.clone()).checked_div(&(m_a + m_b))?)?;
            let rest = keep(one() - square(&s.e))?;
            Some(half(reduced * rest * square(&u)))
        },
    },
    Chain {
        quantity: "impulse on B",
        working: "B at rest: mB vB",
        carry: |s, keep| Some(s.masses[1].clone() * after(s, keep)?[1].clone()),
    },
    Chain {
        quantity: "speed of A, both moving",
        working: "both velocities resolved, both equations solved",
        carry: |s, keep| {
            let [v_a, _] = after_both(s, keep)?;
            let across = across(s, 0, keep)?;
            keep(square(&v_a))?.plus(keep(square(&across))?).sqrt()
        },
    },
    Chain {
        quantity: "energy lost, both moving",
        working: "all energy before less all energy after",
        carry: |s, keep| {
            let after = after_both(s, keep)?;
            let mut lost = Interval::integer(0, BITS);
            for sphere in [0, 1] {
                let across = across(s, sphere, keep)?;
                let before = keep(half(s.masses[sphere].clone() * square(&s.speeds[sphere])))?;
                let rest = keep(half(s.masses[sphere].clone() * (square(&after[sphere]) + square(&across))))?;
                lost = lost + (before - rest);
            }
            Some(lost)
        },
    },
];

/// What came of a chain over many scenes; shares are parts of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// As the chain has it.
    pub quantity: String,
    /// As the chain has it.
    pub working: String,
    /// To how many figures every step was rounded.
    pub figures: u32,
    /// How many scenes.
    pub scenes: usize,
    /// How many had another third figure than they should.
    pub wrong: usize,
    /// How many were within one unit of the third figure.
    pub within_a_unit: usize,
    /// Errors in units of the third figure: half are below the first, 95 in a hundred below the second, all up to the
    /// third.
    pub error: [f64; 3],
    /// Honest tolerances as parts of the answer, likewise.
    pub tolerance: [f64; 3],
    /// How many went beyond their tolerance.
    pub beyond: usize,
}

/// Carries a chain out over scenes with every step to so many figures.
pub fn spread(chain: &Chain, figures: u32, scenes: usize) -> Spread {
    let mut deal = Dealer::new("rounding on the way", 0);
    let (mut errors, mut tolerances) = (Vec::new(), Vec::new());
    let (mut wrong, mut beyond, mut within) = (0, 0, 0);
    while errors.len() < scenes {
        let scene = Printed::dealt(&mut deal);
        let Some(truth) = (chain.carry)(&scene, &Some).filter(|truth| truth.sign() != Some(Ordering::Equal)) else {
            continue;
        };
        let unit = unit(&truth, 3);
        let rounded = (chain.carry)(&scene, &|value| Some(rounded(&value, figures)));
        let widened = (chain.carry)(&scene, &|value| widened(value, figures));
        let Some(rounded) = rounded else { continue };
        let (middle, answer) = (truth.lower(), rounded.lower());
        let error = (&(&answer - &middle).abs() / &unit).to_f64();
        wrong += usize::from(third(&answer) != third(&middle));
        within += usize::from(error <= 1.0);
        beyond += usize::from(widened.as_ref().is_none_or(|range| !range.contains(&answer)));
        let width = widened.map_or(f64::INFINITY, |range| range.width().to_f64() / 2.0);
        errors.push(error);
        tolerances.push(width / middle.abs().to_f64());
    }
    Spread {
        quantity: chain.quantity.to_owned(),
        working: chain.working.to_owned(),
        figures,
        scenes,
        wrong,
        within_a_unit: within,
        error: marks(errors),
        tolerance: marks(tolerances),
        beyond,
    }
}

/// The middle one, the one that 95 in a hundred do not pass, and the largest.
fn marks(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let at = |hundredths: usize| values.get((values.len() * hundredths).div_ceil(100).saturating_sub(1)).copied();
    [50, 95, 100].map(|hundredths| at(hundredths).unwrap_or(f64::NAN))
}

impl Printed {
    fn dealt(deal: &mut Dealer) -> Printed {
        let whole = |value: u64| Interval::integer(value as i64, BITS);
        let mut pick = |low: u64, high: u64| low + deal.below(high - low + 1);
        let parts = pick(2, 9);
        let e = Fraction::new(pick(1, parts - 1) as i64, parts as i64);
        Printed {
            masses: [whole(pick(1, 9)), whole(pick(1, 9))],
            e: Interval::from_fraction(&e, BITS),
            speeds: [whole(pick(2, 12)), whole(pick(2, 12))],
            angles: [whole(pick(10, 80)), whole(pick(10, 80))],
        }
    }
}

/// The component along the line of centres of a velocity before; that of B is against it.
fn along(scene: &Printed, sphere: usize, keep: Keep) -> Option<Interval> {
    let size = keep(scene.speeds[sphere].clone() * radians(&scene.angles[sphere])?.cos())?;
    Some(if sphere == 0 { size } else { -size })
}

fn across(scene: &Printed, sphere: usize, keep: Keep) -> Option<Interval> {
    keep(scene.speeds[sphere].clone() * radians(&scene.angles[sphere])?.sin())
}

/// Components along the line of centres after an impact with B at rest.
fn after(scene: &Printed, keep: Keep) -> Option<[Interval; 2]> {
    solved(scene, along(scene, 0, keep)?, Interval::integer(0, BITS), keep)
}

fn after_both(scene: &Printed, keep: Keep) -> Option<[Interval; 2]> {
    solved(scene, along(scene, 0, keep)?, along(scene, 1, keep)?, keep)
}

/// Momentum P and separation S as numbers, and from them vA = (P - mB S)/(mA + mB) and vB = vA + S.
fn solved(scene: &Printed, u_a: Interval, u_b: Interval, keep: Keep) -> Option<[Interval; 2]> {
    let [m_a, m_b] = scene.masses.clone();
    let momentum = keep(m_a.clone() * u_a.clone() + m_b.clone() * u_b.clone())?;
    let separation = keep(scene.e.clone() * (u_a - u_b))?;
    let v_a = keep((momentum - m_b.clone() * separation.clone()).checked_div(&(m_a + m_b))?)?;
    let v_b = keep(v_a.clone() + separation)?;
    Some([v_a, v_b])
}

fn radians(degrees: &Interval) -> Option<Interval> {
    (degrees.clone() * Interval::pi(BITS)).checked_div(&Interval::integer(180, BITS))
}

fn degrees(radians: Interval) -> Option<Interval> {
    (radians * Interval::integer(180, BITS)).checked_div(&Interval::pi(BITS))
}

fn one() -> Interval {
    Interval::integer(1, BITS)
}

fn square(value: &Interval) -> Interval {
    value.clone() * value.clone()
}

fn half(value: Interval) -> Interval {
    value * Interval::from_fraction(&Fraction::new(1, 2), BITS)
}

/// Addition that reads from left to right.
trait Plus {
    fn plus(self, other: Interval) -> Interval;
}

impl Plus for Interval {
    fn plus(self, other: Interval) -> Interval {
        self + other
    }
}

/// The value as it is written down with so many figures.
fn rounded(value: &Interval, figures: u32) -> Interval {
    Interval::from_fraction(&round(&value.lower(), &Places::SignificantFigures(figures)).to_fraction(), BITS)
}

/// All that a value may be if it was written down with so many figures and meant for this one.
fn widened(value: Interval, figures: u32) -> Option<Interval> {
    let half_unit = &unit(&value, figures) * &Fraction::new(1, 2);
    let half_unit = Interval::from_fraction(&half_unit, BITS);
    Some((value.clone() - half_unit.clone()).hull(&(value + half_unit)))
}

/// One in the last of so many figures; of the largest value in an interval that is not a point.
fn unit(value: &Interval, figures: u32) -> Fraction {
    let (lower, upper) = (value.lower().abs(), value.upper().abs());
    let size = if lower > upper { lower } else { upper };
    let ten = Fraction::from(10);
    let power = |exponent: i32| ten.power(exponent).unwrap_or(Fraction::ONE);
    if size.is_zero() {
        return Fraction::ZERO;
    }
    // A first guess from the double may be one off where the value is next to a power of ten.
    let mut exponent = size.to_f64().log10().floor() as i32;
    while power(exponent) > size {
        exponent -= 1;
    }
    while power(exponent + 1) <= size {
        exponent += 1;
    }
    power(exponent - figures as i32 + 1)
}

/// Rounded to three figures.
fn third(value: &Fraction) -> Fraction {
    round(value, &Places::SignificantFigures(3)).to_fraction()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_student_who_rounds_goes_beyond_the_tolerance() {
        for chain in CHAINS {
            for figures in [3, 4] {
                let found = spread(chain, figures, 60);
                assert_eq!(found.beyond, 0, "{} with {figures} figures", chain.quantity);
            }
        }
    }

    #[test]
    fn energy_as_a_difference_needs_more_room_than_its_formula() {
        let named = |quantity: &str| CHAINS.iter().find(|chain| chain.quantity == quantity).unwrap();
        let difference = spread(named("energy lost, difference"), 3, 60);
        let formula = spread(named("energy lost, formula"), 3, 60);
        assert!(difference.within_a_unit < 20, "{difference:?}");
        assert!(formula.within_a_unit > 40, "{formula:?}");
        assert!(difference.tolerance[1] > 5.0 * formula.tolerance[1]);
    }

    #[test]
    fn a_unit_belongs_to_the_last_figure() {
        let of = |text: &str| unit(&Interval::from_fraction(&text.parse().unwrap(), BITS), 3).to_string();
        assert_eq!(of("1000"), "10");
        assert_eq!(of("999.9"), "1");
        assert_eq!(of("-0.0123"), "1/10000");
    }
}
