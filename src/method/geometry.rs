//! How much geometry an impact has, and the shortest way through each, for any kind of number.
//!
//! Every way is one quotient for both spheres: `g = (1+e)(u_A - u_B)·l / ((m_A + m_B) l·l)`; A loses `m_B g l` and B gains
//! `m_A g l`. As l need not be a unit vector, no root is taken, and a velocity that is rational stays so. Along an axis
//! the scalar products are components, head-on there is nothing across, and from a sphere at rest nothing is
//! subtracted.

use std::ops::{Add, Mul, Sub};

use super::{After, Impact};
use crate::number::Number;

/// What an impact needs of a kind of number.
pub trait Field: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// One of this kind.
    fn one(&self) -> Self;
    /// Nought of this kind.
    fn nought(&self) -> Self;
    /// The quotient, `None` where it does not exist.
    fn over(&self, divisor: &Self) -> Option<Self>;
    /// Is it known to be nought?
    fn is_nought(&self) -> bool;
}

impl<N: Number> Field for N {
    fn one(&self) -> N {
        Number::one(self)
    }
    fn nought(&self) -> N {
        Number::nought(self)
    }
    fn over(&self, divisor: &N) -> Option<N> {
        Number::over(self, divisor)
    }
    fn is_nought(&self) -> bool {
        Number::is_nought(self)
    }
}

/// What an impact has to be calculated with, the least first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Geometry {
    /// Along an axis, nothing across it, and B at rest.
    AtRest,
    /// Along an axis, and nothing across it.
    HeadOn,
    /// A line of centres along an axis, or velocities resolved along and across it: what is across stays.
    Axis,
    /// Any line of centres.
    AnyLine,
}

impl Geometry {
    /// Every one, the least first.
    pub const ALL: [Geometry; 4] = [Geometry::AtRest, Geometry::HeadOn, Geometry::Axis, Geometry::AnyLine];

    /// Its name: `head-on`.
    pub fn name(self) -> &'static str {
        match self {
            Geometry::AtRest => "head-on, B at rest",
            Geometry::HeadOn => "head-on",
            Geometry::Axis => "resolved along the line of centres",
            Geometry::AnyLine => "any line of centres",
        }
    }

    /// Both velocities after; `None` where the quotient does not exist.
    pub fn solve<N: Field>(self, impact: &Impact<N>) -> Option<After<N>> {
        match self {
            Geometry::AtRest => at_rest(impact),
            Geometry::HeadOn => head_on(impact),
            Geometry::Axis => axis(impact),
            Geometry::AnyLine => any_line(impact),
        }
    }
}

/// The place of the axis along which the line of centres lies: 0 for **i**, 1 for **j**.
fn place<N: Field>(impact: &Impact<N>) -> usize {
    usize::from(impact.line[0].is_nought())
}

/// Components with nothing across.
fn nothing_across<N: Field>(place: usize, along: [N; 2]) -> After<N> {
    along.map(|along| {
        let across = along.nought();
        if place == 0 { [along, across] } else { [across, along] }
    })
}

fn at_rest<N: Field>(impact: &Impact<N>) -> Option<After<N>> {
    let [m_a, m_b] = impact.masses.clone();
    let place = place(impact);
    let (a, e) = (impact.before[0][place].clone(), impact.restitution.clone());
    let per_mass = ((e.one() + e) * a.clone()).over(&(m_a.clone() + m_b.clone()))?;
    Some(nothing_across(place, [a - m_b * per_mass.clone(), m_a * per_mass]))
}

/// Both components along the line of centres.
fn on_line<N: Field>(impact: &Impact<N>, place: usize) -> Option<[N; 2]> {
    let [m_a, m_b] = impact.masses.clone();
    let [a, b] = [0, 1].map(|sphere: usize| impact.before[sphere][place].clone());
    let e = impact.restitution.clone();
    let per_mass = ((e.one() + e) * (a.clone() - b.clone())).over(&(m_a.clone() + m_b.clone()))?;
    Some([a - m_b * per_mass.clone(), b + m_a * per_mass])
}

fn head_on<N: Field>(impact: &Impact<N>) -> Option<After<N>> {
    let place = place(impact);
    Some(nothing_across(place, on_line(impact, place)?))
}

fn axis<N: Field>(impact: &Impact<N>) -> Option<After<N>> {
    let place = place(impact);
    let [along_a, along_b] = on_line(impact, place)?;
    let mut after = impact.before.clone();
    after[0][place] = along_a;
    after[1][place] = along_b;
    Some(after)
}

/// Both velocities after, whatever the line of centres.
pub(super) fn any_line<N: Field>(impact: &Impact<N>) -> Option<After<N>> {
    let [m_a, m_b] = impact.masses.clone();
    let [[a_x, a_y], [b_x, b_y]] = impact.before.clone();
    let [x, y] = impact.line.clone();
    let e = impact.restitution.clone();
    let approach = (a_x.clone() - b_x.clone()) * x.clone() + (a_y.clone() - b_y.clone()) * y.clone();
    let per_mass = ((e.one() + e) * approach)
        .over(&((m_a.clone() + m_b.clone()) * (x.clone() * x.clone() + y.clone() * y.clone())))?;
    // A loses m_B of it and B gains m_A of it: their changes are as the masses of the others.
    let (to_a, to_b) = (m_b * per_mass.clone(), m_a * per_mass);
    Some([[a_x - to_a.clone() * x.clone(), a_y - to_a * y.clone()], [b_x + to_b.clone() * x, b_y + to_b * y]])
}
