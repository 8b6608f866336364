//! Doubles with a proved bound on their error: where figures are asked for and no exact form.
//!
//! Along the line of centres `g = (1+e)(a - b)/(m_A + m_B)`, `v_A = a - m_B g`, `v_B = b + m_A g`. Let u = 2^-53 and
//! S = |a| + |b|. Each of the five numbers is a double next to the true one, so off by at most 2u of itself. To first order in u:
//!
//! | what | error at most |
//! |---|---|
//! | `1 + e` | 2u of itself: u from e, since e ≤ 1, and u from rounding |
//! | `a - b` | 3uS: 2uS from a and b, u(a - b) from rounding |
//! | `m_A + m_B` | 3u of itself: 2u from the masses, u from rounding |
//! | the product, the quotient, and the product with m | u each from rounding, 2u from m |
//!
//! As `|a - b| ≤ S`, `1 + e ≤ 2` and `m/(m_A + m_B) ≤ 1`, the product `m g` is at most 2S and off by at most
//! 2S (3 + 2 + 3 + 1 + 1 + 1 + 2)u = 26uS. With 2uS from a and the rounding of the result, which is at most 3S, a
//! component is off by at most 31uS. What is claimed is 40uS: the rest is room for terms of the second order and for the
//! roundings of the bound itself. A fused multiply-add only leaves roundings out. Numbers are accepted between 2^-300 and 2^300
//! in size, or nought, so nothing overflows, and what is lost below the smallest double is far less than uS.
//!
//! A line of centres that is no axis is resolved exactly beforehand. Where the bound leaves the figures open, as it must at
//! a tie, the float is refused and an exact method takes over: see [`figures`](crate::method::figures).

use crate::method::batch::{LETTERS_ARE_NO_FLOATS, batch};
use crate::method::{After, Found, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Fraction, Interval, Value};

/// Doubles with a proved bound.
pub(in crate::method) struct Certified;

/// The bound in terms of the sum of both sizes.
const BOUND: f64 = 40.0 * (f64::EPSILON / 2.0);

/// Numbers are nought or between one over this and this in size: 2^300.
const LARGEST: f64 = f64::from_bits((1023 + 300) << 52);

/// How many binary places the ends of an enclosure have.
const BITS: usize = 128;

/// Masses, components along the line of centres, e.
type OnLine = ([f64; 2], [f64; 2], f64);

/// What is needed to put velocities together again.
struct Kept {
    /// The line of centres and, for each sphere, the component across: times the length of the line.
    line: [Value; 2],
    across: [Value; 2],
}

#[inline(always)]
fn solve(([m_a, m_b], [a, b], e): &OnLine) -> [f64; 3] {
    let per_mass = (1.0 + e) * (a - b) / (m_a + m_b);
    let radius = BOUND * (a.abs() + b.abs());
    #[cfg(target_feature = "fma")]
    return [per_mass.mul_add(-m_b, *a), per_mass.mul_add(*m_a, *b), radius];
    #[cfg(not(target_feature = "fma"))]
    [a - m_b * per_mass, b + m_a * per_mass, radius]
}

fn form(impact: &Impact<Value>) -> Result<(OnLine, Kept), String> {
    let [x, y] = &impact.line;
    let resolved = impact.before.each_ref().map(|[u, v]| [&(u * x) + &(v * y), &(v * x) - &(u * y)]);
    let [[a, across_a], [b, across_b]] = resolved;
    let float = |value: &Value| {
        let float = value.to_f64().ok_or(LETTERS_ARE_NO_FLOATS)?;
        let ordinary = value.is_zero() || (1.0 / LARGEST..=LARGEST).contains(&float.abs());
        if ordinary { Ok(float) } else { Err("a number is very large or very small") }
    };
    if impact.numbers().any(|value| !value.is_constant()) {
        return Err(LETTERS_ARE_NO_FLOATS.to_owned());
    }
    let [m_a, m_b] = &impact.masses;
    let (masses, e) = ([float(m_a)?, float(m_b)?], float(&impact.restitution)?);
    if masses.iter().any(|mass| *mass <= 0.0) || !(0.0..=1.0).contains(&e) {
        return Err("masses must be positive and e between 0 and 1 for the bound to hold".to_owned());
    }
    Ok(((masses, [float(&a)?, float(&b)?], e), Kept { line: impact.line.clone(), across: [across_a, across_b] }))
}

/// Everything within a radius of a double.
fn around(middle: f64, radius: f64) -> Option<Interval> {
    let [middle, radius] = [Fraction::from_f64(middle)?, Fraction::from_f64(radius)?];
    let end = |value: Fraction| Interval::from_fraction(&value, BITS);
    Some(end(&middle - &radius).hull(&end(&middle + &radius)))
}

fn enclosure(kept: &Kept, [a, b, radius]: &[f64; 3]) -> Option<After<Interval>> {
    let [x, y] = kept.line.each_ref().map(|component| component.enclose_constant(BITS));
    let (x, y) = (x?, y?);
    let square = x.clone() * x.clone() + y.clone() * y.clone();
    let whole = |along: f64, across: &Value| -> Option<[Interval; 2]> {
        let (along, across) = (around(along, *radius)?, across.enclose_constant(BITS)?);
        let components =
            [along.clone() * x.clone() - across.clone() * y.clone(), along * y.clone() + across * x.clone()];
        let [one, other] = components.map(|component| component.checked_div(&square));
        Some([one?, other?])
    };
    Some([whole(*a, &kept.across[0])?, whole(*b, &kept.across[1])?])
}

impl Method for Certified {
    fn name(&self) -> &'static str {
        "certified-float"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers without letters and of ordinary size, where figures are asked for and no exact form"
    }

    fn promises(&self) -> Promise {
        Promise::Enclosed
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        batch(impacts, form, solve, |kept, after| match enclosure(kept, after) {
            Some(after) => Found::Enclosed(after),
            None => Found::Missed("the line of centres may be of no length".to_owned()),
        })
    }
}
