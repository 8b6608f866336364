//! An impact as a matrix of machine integers over one denominator.
//!
//! With whole masses in proportion, `e = p/q` and a whole vector l along the line of centres,
//!
//! ```text
//! along an axis   d = q (m_A + m_B)         d v_A = (q m_A - p m_B) u_A + (p+q) m_B u_B
//!                                           d v_B = (p+q) m_A u_A + (q m_B - p m_A) u_B
//! any line        d = q (m_A + m_B) l·l     d v_A = d u_A - (p+q) m_B w l,   d v_B = d u_B + (p+q) m_A w l,
//!                                           w = (u_A - u_B)·l
//! ```
//!
//! The matrix is rational, so it acts on each coefficient of the velocities by itself: on one for fractions, on four for
//! `a + b√2 + c√3 + d√6`, on those of cos α and sin α. Every operation is checked; but what is accepted has been shown not
//! to overflow, by a bound on the largest number that can occur.

use smallvec::{SmallVec, smallvec};

use crate::method::batch::batch;
use crate::method::elements::{Element, coefficients, sum};
use crate::method::{Found, Geometry, Impact, Prepared, Skip};
use crate::number::{Fraction, Value};

/// An impact in whole numbers, each velocity component by its coefficients over a common denominator.
pub(in crate::method) struct Whole<const COUNT: usize> {
    masses: [i64; 2],
    /// Numerator and denominator of e.
    e: [i64; 2],
    line: [i64; 2],
    before: [[[i64; COUNT]; 2]; 2],
    kept: Kept,
}

/// What is needed to make values of the coefficients.
struct Kept {
    elements: Vec<Element>,
    below: i64,
    /// Where the line of centres lies along an axis, its place; and the velocities before, for what stays.
    place: usize,
    before: [[Value; 2]; 2],
}

/// What is along the line of centres, of an impact along an axis.
pub(in crate::method) struct OnLine<const COUNT: usize> {
    pub masses: [i64; 2],
    /// Numerator and denominator of e.
    pub e: [i64; 2],
    pub along: [[i64; COUNT]; 2],
}

/// A whole number as the nearest double.
#[allow(clippy::cast_precision_loss)]
#[inline(always)]
pub(in crate::method) fn double(whole: i64) -> f64 {
    whole as f64
}

/// Coefficients of both components along the line of centres, and the denominator; `None` on overflow.
type Along<const COUNT: usize> = Option<([[i64; COUNT]; 2], i64)>;

/// Coefficients of all four components and the denominator; `None` on overflow.
type All<const COUNT: usize> = Option<([[[i64; COUNT]; 2]; 2], i64)>;

/// Why an impact has no whole form.
pub(in crate::method) enum Unfit {
    /// Masses, e or the line of centres are not in rational proportion.
    Proportions,
    /// The velocities are not sums of the elements.
    Velocities,
    /// Some number might not fit.
    TooLarge,
}

impl Unfit {
    /// The same in words.
    pub fn words(self, elements: &str) -> String {
        match self {
            Unfit::Proportions => "the masses, e and the line of centres are not in rational proportion".to_owned(),
            Unfit::Velocities => format!("a component of a velocity is not {elements}"),
            Unfit::TooLarge => "the numbers might not fit into machine integers".to_owned(),
        }
    }
}

/// A batch by a geometry. `elements` finds what the velocities are sums of, and `named` says it in words.
pub(super) fn prepare<const COUNT: usize>(
    impacts: &[Impact<Value>],
    geometry: Geometry,
    elements: fn(&Impact<Value>) -> Option<Vec<Element>>,
    named: &str,
) -> Result<Box<dyn Prepared>, Skip> {
    let whole = |impact: &Impact<Value>| whole::<COUNT>(impact, elements).map_err(|unfit| unfit.words(named));
    let on_line = |impact: &Impact<Value>| {
        let Whole { masses, e, before, kept, .. } = whole(impact)?;
        let along = before.map(|velocity| velocity[kept.place]);
        Ok((OnLine { masses, e, along }, kept))
    };
    match geometry {
        Geometry::AtRest => batch(impacts, on_line, at_rest::<COUNT>, head_on_found),
        Geometry::HeadOn => batch(impacts, on_line, along::<COUNT>, head_on_found),
        Geometry::Axis => batch(impacts, on_line, along::<COUNT>, axis_found),
        Geometry::AnyLine => {
            let form = |impact: &Impact<Value>| {
                let Whole { masses, e, line, before, kept } = whole(impact)?;
                Ok(((masses, e, line, before), kept))
            };
            batch(impacts, form, any_line::<COUNT>, any_found)
        }
    }
}

/// The whole form of an impact.
pub(in crate::method) fn whole<const COUNT: usize>(
    impact: &Impact<Value>,
    elements: fn(&Impact<Value>) -> Option<Vec<Element>>,
) -> Result<Whole<COUNT>, Unfit> {
    let proportions = impact.proportions().ok_or(Unfit::Proportions)?;
    let elements = elements(impact).filter(|elements| elements.len() <= COUNT).ok_or(Unfit::Velocities)?;
    let (masses, _) = over_one_denominator(&proportions.masses).ok_or(Unfit::TooLarge)?;
    let (line, _) = over_one_denominator(&proportions.line).ok_or(Unfit::TooLarge)?;
    let (p, q) = proportions.e.as_small().ok_or(Unfit::TooLarge)?;
    let mut flat: SmallVec<[Fraction; 4]> = smallvec![Fraction::ZERO; 4 * COUNT];
    for (component, row) in impact.before.as_flattened().iter().zip(flat.chunks_mut(COUNT)) {
        for (element, coefficient) in coefficients(component).ok_or(Unfit::Velocities)? {
            let place = elements.iter().position(|other| *other == element).ok_or(Unfit::Velocities)?;
            row[place] = coefficient;
        }
    }
    let (numerators, below) = over_one_denominator(&flat).ok_or(Unfit::TooLarge)?;
    let mut rows = numerators.chunks(COUNT).map(|row| std::array::from_fn(|place| row[place]));
    let mut row = || rows.next().unwrap_or([0; COUNT]);
    let before = [[row(), row()], [row(), row()]];
    let [masses, line] = [masses, line].map(|pair| [pair[0], pair[1]]);
    let kept = Kept { elements, below, place: usize::from(line[0] == 0), before: impact.before.clone() };
    let whole = Whole { masses, e: [p, q], line, before, kept };
    if whole.fits() { Ok(whole) } else { Err(Unfit::TooLarge) }
}

/// Whole numerators over the least common denominator, common factors taken out of neither.
fn over_one_denominator(fractions: &[Fraction]) -> Option<(SmallVec<[i64; 4]>, i64)> {
    let mut below: i64 = 1;
    for fraction in fractions {
        let (_, denominator) = fraction.as_small()?;
        below = below.checked_mul(denominator / gcd(below, denominator))?;
    }
    let above = |fraction: &Fraction| {
        let (numerator, denominator) = fraction.as_small()?;
        numerator.checked_mul(below / denominator)
    };
    Some((fractions.iter().map(above).collect::<Option<_>>()?, below))
}

/// The greatest common divisor, its sign left open.
pub(super) fn gcd(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl<const COUNT: usize> Whole<COUNT> {
    /// What is along the line of centres, the place of its axis and what is below; nothing for an oblique line.
    pub fn on_line(&self) -> Option<(OnLine<COUNT>, usize, i64)> {
        let Whole { masses, e, before, kept, .. } = self;
        let along = before.map(|velocity| velocity[kept.place]);
        self.line.contains(&0).then_some((OnLine { masses: *masses, e: *e, along }, kept.place, kept.below))
    }

    /// Is no number of any of the kernels, and no denominator with the velocities' own, beyond machine integers?
    ///
    /// With U the largest coefficient, P = |p|+|q|, M = |m_A|+|m_B| and L = |l_x|+|l_y|: no denominator is above P M L², no
    /// scalar product above 2 U L, no product of it with (p+q) m l above 2 U P M L². Three times that bounds each sum.
    fn fits(&self) -> bool {
        let size = |numbers: &[i64]| numbers.iter().fold(0_u128, |sum, n| sum + u128::from(n.unsigned_abs()));
        let speeds = self.before.as_flattened().as_flattened();
        let largest = speeds.iter().map(|n| u128::from(n.unsigned_abs())).max().unwrap_or(0).max(1);
        let line = size(&self.line);
        let factors = [3, size(&self.e), size(&self.masses), line, line, largest];
        let bound = factors.into_iter().fold(1_u128, u128::saturating_mul);
        let below = u128::from(self.kept.below.unsigned_abs()).saturating_mul(bound / largest);
        bound.max(below) <= i64::MAX as u128
    }
}

#[inline(always)]
fn at_rest<const COUNT: usize>(impact: &OnLine<COUNT>) -> Along<COUNT> {
    let ([m_a, m_b], [p, q]) = (impact.masses, impact.e);
    let own_a = q.checked_mul(m_a)?.checked_sub(p.checked_mul(m_b)?)?;
    let from_a = p.checked_add(q)?.checked_mul(m_a)?;
    let mut after = [[0; COUNT]; 2];
    let [after_a, after_b] = &mut after;
    for ((a, v_a), v_b) in impact.along[0].iter().zip(after_a).zip(after_b) {
        *v_a = own_a.checked_mul(*a)?;
        *v_b = from_a.checked_mul(*a)?;
    }
    Some((after, q.checked_mul(m_a.checked_add(m_b)?)?))
}

/// The rows of the matrix share their products: with momentum `P = m_A u_A + m_B u_B` and `s = p (u_A - u_B)`,
/// `d v_A = q P - m_B s` and `d v_B = q P + m_A s`. That is seven products in place of thirteen.
#[inline(always)]
fn along<const COUNT: usize>(impact: &OnLine<COUNT>) -> Along<COUNT> {
    let ([m_a, m_b], [p, q]) = (impact.masses, impact.e);
    let mut after = [[0; COUNT]; 2];
    let ([after_a, after_b], [before_a, before_b]) = (&mut after, &impact.along);
    for (((a, b), v_a), v_b) in before_a.iter().zip(before_b).zip(after_a).zip(after_b) {
        let momentum = q.checked_mul(m_a.checked_mul(*a)?.checked_add(m_b.checked_mul(*b)?)?)?;
        let separation = p.checked_mul(a.checked_sub(*b)?)?;
        *v_a = momentum.checked_sub(m_b.checked_mul(separation)?)?;
        *v_b = momentum.checked_add(m_a.checked_mul(separation)?)?;
    }
    Some((after, q.checked_mul(m_a.checked_add(m_b)?)?))
}

/// Masses, e, line and velocities.
type Any<const COUNT: usize> = ([i64; 2], [i64; 2], [i64; 2], [[[i64; COUNT]; 2]; 2]);

#[inline(always)]
fn any_line<const COUNT: usize>(([m_a, m_b], [p, q], [x, y], before): &Any<COUNT>) -> All<COUNT> {
    let square = x.checked_mul(*x)?.checked_add(y.checked_mul(*y)?)?;
    let below = q.checked_mul(m_a.checked_add(*m_b)?)?.checked_mul(square)?;
    let sum = p.checked_add(*q)?;
    let (to_a, to_b) = (sum.checked_mul(*m_b)?, sum.checked_mul(*m_a)?);
    let mut after = [[[0; COUNT]; 2]; 2];
    for place in 0..COUNT {
        let [[a_x, a_y], [b_x, b_y]] = before.map(|velocity| velocity.map(|component| component[place]));
        let (across_x, across_y) = (a_x.checked_sub(b_x)?.checked_mul(*x)?, a_y.checked_sub(b_y)?.checked_mul(*y)?);
        let approach = across_x.checked_add(across_y)?;
        let (lost, gained) = (to_a.checked_mul(approach)?, to_b.checked_mul(approach)?);
        after[0][0][place] = below.checked_mul(a_x)?.checked_sub(lost.checked_mul(*x)?)?;
        after[0][1][place] = below.checked_mul(a_y)?.checked_sub(lost.checked_mul(*y)?)?;
        after[1][0][place] = below.checked_mul(b_x)?.checked_add(gained.checked_mul(*x)?)?;
        after[1][1][place] = below.checked_mul(b_y)?.checked_add(gained.checked_mul(*y)?)?;
    }
    Some((after, below))
}

impl Kept {
    /// The value of coefficients over a denominator times that of the velocities.
    fn value(&self, coefficients: &[i64], below: i64) -> Value {
        let below = below.saturating_mul(self.below);
        let terms = self.elements.iter().zip(coefficients).filter(|(_, above)| **above != 0);
        sum(terms.map(|(element, above)| (element, Fraction::new(*above, below))))
    }
}

const OVERFLOW: &str = "a product did not fit into machine integers";

fn head_on_found<const COUNT: usize>(kept: &Kept, after: &Along<COUNT>) -> Found {
    let Some((after, below)) = after else { return Found::Missed(OVERFLOW.to_owned()) };
    let along = after.each_ref().map(|coefficients| kept.value(coefficients, *below));
    Found::Exact(along.map(|along| if kept.place == 0 { [along, Value::ZERO] } else { [Value::ZERO, along] }))
}

fn axis_found<const COUNT: usize>(kept: &Kept, after: &Along<COUNT>) -> Found {
    let Some((after, below)) = after else { return Found::Missed(OVERFLOW.to_owned()) };
    let mut whole = kept.before.clone();
    for (velocity, coefficients) in whole.iter_mut().zip(after) {
        velocity[kept.place] = kept.value(coefficients, *below);
    }
    Found::Exact(whole)
}

fn any_found<const COUNT: usize>(kept: &Kept, after: &All<COUNT>) -> Found {
    let Some((after, below)) = after else { return Found::Missed(OVERFLOW.to_owned()) };
    let value = |coefficients: &[i64; COUNT]| kept.value(coefficients, *below);
    Found::Exact(after.each_ref().map(|velocity| velocity.each_ref().map(value)))
}
