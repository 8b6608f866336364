//! The field of `a + b√2 + c√3 + d√6` in machine integers: for an e, masses or a line of centres with surds.
//!
//! Products go by the table of √2, √3 and √6. A quotient is made rational below by the factors in which √2, or √3,
//! changes its sign: their product with the divisor is a fraction. Every operation is checked, and what is accepted has been
//! solved once to see that nothing overflows.

use std::ops::{Add, Mul, Neg, Sub};

use super::matrix::gcd;
use super::surd_integers::field;
use crate::method::batch::batch;
use crate::method::elements::{coefficients, sum};
use crate::method::needs::geometry_of;
use crate::method::{After, Field, Found, Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Fraction, Value};

/// Surds in machine integers.
pub(in crate::method) struct SurdField;

/// `(a + b√2 + c√3 + d√6)/below`; nothing once a product did not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) struct Surd(Option<([i64; 4], i64)>);

impl Surd {
    /// The surd that a value is, if it is one.
    pub(in crate::method) fn of(value: &Value) -> Option<Surd> {
        let places = field();
        let (mut above, mut below) = ([Fraction::ZERO, Fraction::ZERO, Fraction::ZERO, Fraction::ZERO], 1_i64);
        for (element, coefficient) in coefficients(value)? {
            let (_, denominator) = coefficient.as_small()?;
            below = below.checked_mul(denominator / gcd(below, denominator))?;
            above[places.iter().position(|other| *other == element)?] = coefficient;
        }
        let mut whole = [0; 4];
        for (numerator, fraction) in whole.iter_mut().zip(&above) {
            let (above, denominator) = fraction.as_small()?;
            *numerator = above.checked_mul(below / denominator)?;
        }
        Some(Surd(Some((whole, below))))
    }

    fn value(self) -> Option<Value> {
        let (whole, below) = self.0?;
        let places = field();
        let terms = places.iter().zip(whole).filter(|(_, above)| *above != 0);
        Some(sum(terms.map(|(element, above)| (element, Fraction::new(above, below)))))
    }

    fn reciprocal(self) -> Surd {
        let Some((above, below)) = self.0 else { return self };
        if let [whole, 0, 0, 0] = above {
            let inverse = whole.checked_abs().filter(|size| *size != 0).zip(below.checked_mul(whole.signum()));
            return Surd(inverse.map(|(size, above)| ([above, 0, 0, 0], size)));
        }
        // (a + b√2 + c√3 + d√6)/k is one over k times the product of its conjugates over their common product.
        let whole = Surd(Some((above, 1)));
        let by_root_2 = whole.conjugate([1, -1, 1, -1]);
        let norm = whole * by_root_2;
        let by_root_3 = norm.conjugate([1, 1, -1, -1]);
        match ((by_root_2 * by_root_3).0, (norm * by_root_3).0) {
            (Some((above, _)), Some(([norm, 0, 0, 0], _))) if norm != 0 => {
                let (unit, size) = (norm.signum(), norm.checked_abs());
                let scaled = above.map(|part| part.checked_mul(below)?.checked_mul(unit));
                Surd(size.and_then(|size| Some((whole_of(scaled)?, size))).and_then(lowest))
            }
            _ => Surd(None),
        }
    }

    fn conjugate(self, signs: [i64; 4]) -> Surd {
        let changed =
            |(above, below): ([i64; 4], i64)| Some((std::array::from_fn(|place| above[place] * signs[place]), below));
        Surd(self.0.and_then(changed))
    }
}

/// The four, or nothing if one is missing.
fn whole_of(parts: [Option<i64>; 4]) -> Option<[i64; 4]> {
    let [Some(a), Some(b), Some(c), Some(d)] = parts else { return None };
    Some([a, b, c, d])
}

/// Without the factor that all parts share with the denominator.
fn lowest((above, below): ([i64; 4], i64)) -> Option<([i64; 4], i64)> {
    if below == 1 {
        return Some((above, below));
    }
    let shared = above.into_iter().fold(below, gcd).checked_abs()?;
    Some((above.map(|part| part / shared), below / shared))
}

impl Mul for Surd {
    type Output = Surd;
    fn mul(self, other: Surd) -> Surd {
        let product = |([a, b, c, d], k): ([i64; 4], i64), ([p, q, r, s], l): ([i64; 4], i64)| {
            let two =
                |one: i64, of: i64, other: i64, with: i64| one.checked_mul(of)?.checked_add(other.checked_mul(with)?);
            let add = |one: i64, times: i64, other: i64| one.checked_add(other.checked_mul(times)?);
            let one = add(two(a, p, b.checked_mul(2)?, q)?, 3, two(c, r, d.checked_mul(2)?, s)?)?;
            let root_2 = add(two(a, q, b, p)?, 3, two(c, s, d, r)?)?;
            let root_3 = add(two(a, r, c, p)?, 2, two(b, s, d, q)?)?;
            let root_6 = two(a, s, d, p)?.checked_add(two(b, r, c, q)?)?;
            Some(([one, root_2, root_3, root_6], k.checked_mul(l)?))
        };
        // Masses and what is below are fractions nearly always: four products in place of sixteen.
        let multiple = |above: [i64; 4], k: i64, factor: i64, l: i64| {
            Some((whole_of(above.map(|part| part.checked_mul(factor)))?, k.checked_mul(l)?))
        };
        Surd(match self.0.zip(other.0) {
            Some(((above, k), ([factor, 0, 0, 0], l))) | Some((([factor, 0, 0, 0], k), (above, l))) => {
                multiple(above, k, factor, l)
            }
            both => both.and_then(|(one, other)| product(one, other)),
        })
    }
}

impl Add for Surd {
    type Output = Surd;
    fn add(self, other: Surd) -> Surd {
        let total = |(above, k): ([i64; 4], i64), (others, l): ([i64; 4], i64)| {
            let (left, right) = match (k, l) {
                _ if k == l => (1, 1),
                (_, 1) => (1, k),
                (1, _) => (l, 1),
                _ => (l / gcd(k, l), k / gcd(k, l)),
            };
            let one = |place: usize| above[place].checked_mul(left)?.checked_add(others[place].checked_mul(right)?);
            Some((whole_of([one(0), one(1), one(2), one(3)])?, k.checked_mul(left)?))
        };
        Surd(self.0.zip(other.0).and_then(|(one, other)| total(one, other)))
    }
}

impl Neg for Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        self.conjugate([-1; 4])
    }
}

impl Sub for Surd {
    type Output = Surd;
    fn sub(self, other: Surd) -> Surd {
        self + -other
    }
}

impl Field for Surd {
    fn one(&self) -> Surd {
        Surd(Some(([1, 0, 0, 0], 1)))
    }
    fn nought(&self) -> Surd {
        Surd(Some(([0; 4], 1)))
    }
    fn over(&self, divisor: &Surd) -> Option<Surd> {
        Some(*self * divisor.reciprocal()).filter(|quotient| quotient.0.is_some())
    }
    fn is_nought(&self) -> bool {
        self.0.is_some_and(|(above, _)| above == [0; 4])
    }
}

/// Both velocities after; nothing if a product did not fit.
fn solve(impact: &Impact<Surd>, geometry: Geometry) -> Option<After<Surd>> {
    let after = geometry.solve(impact)?;
    after.as_flattened().iter().all(|component| component.0.is_some()).then_some(after)
}

/// The impact in surds, if it is in the field.
pub(in crate::method) fn in_surds(impact: &Impact<Value>) -> Option<Impact<Surd>> {
    impact.turned_into(Surd::of)
}

/// Does an impact in surds stay within machine integers? The most general geometry has the largest products.
pub(in crate::method) fn fits(impact: &Impact<Surd>) -> bool {
    Geometry::ALL.iter().all(|geometry| solve(impact, *geometry).is_some())
}

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    let form = |impact: &Impact<Value>| {
        let surds = in_surds(impact).ok_or("a number is not a + b√2 + c√3 + d√6")?;
        if fits(&surds) { Ok((surds, ())) } else { Err("the numbers do not fit into machine integers".to_owned()) }
    };
    batch(
        impacts,
        form,
        move |impact| solve(impact, geometry),
        |(), after: &Option<After<Surd>>| {
            let values = after.and_then(|after| {
                let [[a_x, a_y], [b_x, b_y]] = after.map(|velocity| velocity.map(Surd::value));
                Some([[a_x?, a_y?], [b_x?, b_y?]])
            });
            values.map_or_else(|| Found::Missed("a product did not fit into machine integers".to_owned()), Found::Exact)
        },
    )
}

impl Method for SurdField {
    fn name(&self) -> &'static str {
        "surd-field"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "all nine numbers a + b√2 + c√3 + d√6, if they are not too large"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
