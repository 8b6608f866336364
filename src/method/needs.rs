//! What a scene needs of a method, read off its values and not off the way in which they were written.
//!
//! The exercise that is written in surds and is rational after resolving needs fractions and no more. Each need is a
//! thing that some cheaper model cannot do.

use super::answer::{integers, linear_forms, matrix, polynomials, surd_field, surd_integers};
use super::{Geometry, Impact};
use crate::number::{Fraction, Value};

/// One need.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Need {
    /// B moves before the impact, or A does not.
    MovingB,
    /// A sphere has a component across the line of centres.
    Across,
    /// The line of centres lies along neither axis.
    Oblique,
    /// An exact form is asked for, and not figures alone.
    ExactForm,
    /// A component of a velocity is no fraction.
    Irrational,
    /// A component of a velocity is not `a + b√2 + c√3 + d√6`.
    OtherThings,
    /// The velocities are not sums of at most four things.
    ManyThings,
    /// e, the ratio of the masses or the direction of the line of centres is no fraction.
    Factors,
    /// Some number is not `a + b√2 + c√3 + d√6`.
    OutsideField,
    /// Masses, e or the line of centres have roots, a component has letters below the line, or there is more of them than fits
    /// into machine words.
    BeyondPolynomials,
    /// The numbers might not fit into machine integers.
    Large,
    /// A letter remains.
    Letters,
}

impl Need {
    /// Every need.
    pub const ALL: [Need; 12] = [
        Need::MovingB,
        Need::Across,
        Need::Oblique,
        Need::ExactForm,
        Need::Irrational,
        Need::OtherThings,
        Need::ManyThings,
        Need::Factors,
        Need::OutsideField,
        Need::BeyondPolynomials,
        Need::Large,
        Need::Letters,
    ];

    /// What is the case, in words that go on after "because".
    pub fn words(self) -> &'static str {
        match self {
            Need::MovingB => "both spheres move along the line of centres",
            Need::Across => "a sphere moves across the line of centres too",
            Need::Oblique => "the line of centres lies along neither axis",
            Need::ExactForm => "an exact form is asked for",
            Need::Irrational => "a component of a velocity is not rational",
            Need::OtherThings => "a component of a velocity is more than a + b√2 + c√3 + d√6",
            Need::ManyThings => "the velocities are not sums of at most four things with rational coefficients",
            Need::Factors => "e, the ratio of the masses or the direction of the line of centres is not rational",
            Need::OutsideField => "a number is more than a + b√2 + c√3 + d√6",
            Need::BeyondPolynomials => "the numbers are no short polynomials in letters",
            Need::Large => "the numbers might outgrow machine integers",
            Need::Letters => "letters remain",
        }
    }

    /// Its name in a table: `moving-b`.
    pub fn name(self) -> &'static str {
        match self {
            Need::MovingB => "moving-b",
            Need::Across => "across",
            Need::Oblique => "oblique",
            Need::ExactForm => "exact-form",
            Need::Irrational => "irrational",
            Need::OtherThings => "other-things",
            Need::ManyThings => "many-things",
            Need::Factors => "factors",
            Need::OutsideField => "outside-field",
            Need::BeyondPolynomials => "beyond-polynomials",
            Need::Large => "large",
            Need::Letters => "letters",
        }
    }
}

/// What is wanted of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// The velocities as formulas.
    ExactForm,
    /// So many figures of them.
    Figures,
}

/// The needs of a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs(u16);

impl Needs {
    /// What an impact needs.
    pub fn of(impact: &Impact<Value>, wanted: Wanted) -> Needs {
        let mut needs = Needs::but_for_polynomials(impact, wanted);
        needs.add_if(Need::BeyondPolynomials, !polynomials::accepts(impact));
        needs
    }

    /// The same without [`Need::BeyondPolynomials`]: to see that, the impact is solved.
    pub(super) fn but_for_polynomials(impact: &Impact<Value>, wanted: Wanted) -> Needs {
        let mut needs = Needs::geometry(impact);
        let rational = |value: &Value| value.as_fraction().is_some();
        let coefficients = |value: &Value| super::elements::coefficients(value);
        let velocities = || impact.before.as_flattened().iter();
        let in_field = |value: &Value| rational(value) || surd_field::Surd::of(value).is_some();
        needs.add_if(Need::ExactForm, wanted == Wanted::ExactForm);
        needs.add_if(Need::Letters, impact.numbers().any(|value| !value.is_constant()));
        needs.add_if(Need::Factors, impact.proportions().is_none());
        if !velocities().all(rational) {
            needs.add_if(Need::Irrational, true);
            let field = surd_integers::elements(impact).unwrap_or_default();
            let known = |value| {
                coefficients(value).is_some_and(|parts| parts.iter().all(|(element, _)| field.contains(element)))
            };
            needs.add_if(Need::OtherThings, !velocities().all(known));
            needs.add_if(Need::ManyThings, linear_forms::elements(impact).is_none());
        }
        needs.add_if(Need::OutsideField, !impact.numbers().all(in_field));
        needs.add_if(Need::Large, !needs.fits(impact));
        needs
    }

    /// What an impact needs of geometry.
    pub fn geometry(impact: &Impact<Value>) -> Needs {
        let mut needs = Needs::default();
        let [x, y] = &impact.line;
        let place = match (x.is_written_zero(), y.is_written_zero()) {
            (false, true) => 0,
            (true, false) => 1,
            _ => {
                needs.add_if(Need::Oblique, true);
                let moves = |velocity: &[Value; 2]| !velocity.iter().all(Value::is_written_zero);
                needs.add_if(Need::MovingB, moves(&impact.before[1]));
                let across = |[u, v]: &[Value; 2]| !(&(v * x) - &(u * y)).is_zero();
                needs.add_if(Need::Across, impact.before.iter().any(across));
                return needs;
            }
        };
        needs.add_if(Need::MovingB, !impact.before[1][place].is_written_zero());
        needs.add_if(Need::Across, impact.before.iter().any(|velocity| !velocity[1 - place].is_written_zero()));
        needs
    }

    /// Would machine integers hold what the cheapest of their kernels makes of it?
    fn fits(self, impact: &Impact<Value>) -> bool {
        fn matrix_fits<const COUNT: usize>(
            impact: &Impact<Value>,
            elements: fn(&Impact<Value>) -> Option<Vec<super::elements::Element>>,
        ) -> bool {
            !matches!(matrix::whole::<COUNT>(impact, elements), Err(matrix::Unfit::TooLarge))
        }
        match (self.has(Need::Factors), self.has(Need::Irrational), self.has(Need::ManyThings)) {
            (false, false, _) if is_of_small_numbers(impact) => true,
            (false, false, _) => matrix_fits::<1>(impact, integers::elements),
            (false, true, false) => matrix_fits::<4>(impact, linear_forms::elements),
            _ => surd_field::in_surds(impact).is_none_or(|surds| surd_field::fits(&surds)),
        }
    }

    /// Is this one of them?
    pub fn has(self, need: Need) -> bool {
        self.0 & Needs::from_iter([need]).0 != 0
    }

    fn add_if(&mut self, need: Need, holds: bool) {
        if holds {
            *self = self.with(need);
        }
    }

    /// These and one more.
    #[must_use]
    pub fn with(self, need: Need) -> Needs {
        Needs(self.0 | 1 << Need::ALL.iter().position(|other| *other == need).unwrap_or(0))
    }

    /// Each of them.
    pub fn each(self) -> impl Iterator<Item = Need> {
        Need::ALL.into_iter().filter(move |need| self.has(*need))
    }
}

/// Are all numbers so small that machine integers surely hold what becomes of them, and the line of centres along an axis? With
/// nothing above or below a line beyond 2^8, both masses are at most 2^16 over one denominator, e adds up to at most 2^9, and
/// the components are at most 2^32 over one of at most 2^32: by the bound of [`matrix`] all stays below 3 * 2^58.
fn is_of_small_numbers(impact: &Impact<Value>) -> bool {
    const SMALL: u64 = 1 << 8;
    let is_small = |value: &Value| {
        let parts = value.as_fraction().and_then(Fraction::as_small);
        parts.is_some_and(|(above, below)| above.unsigned_abs() <= SMALL && below.unsigned_abs() <= SMALL)
    };
    impact.line == [Value::ONE, Value::ZERO] && impact.numbers().all(is_small)
}

impl FromIterator<Need> for Needs {
    fn from_iter<T: IntoIterator<Item = Need>>(needs: T) -> Needs {
        needs.into_iter().fold(Needs::default(), Needs::with)
    }
}

/// The least geometry that suffices for all of a batch.
pub(super) fn geometry_of(impacts: &[Impact<Value>]) -> Geometry {
    impacts.iter().map(|impact| Geometry::least(Needs::geometry(impact))).max().unwrap_or(Geometry::AtRest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_fit_into_machine_integers() {
        let large = |below: i64| Value::fraction(256, below);
        let impact = |mass: i64| Impact {
            masses: [large(mass), Value::fraction(255, 256)],
            before: [[large(251), large(241)], [large(239), large(233)]],
            line: [Value::ONE, Value::ZERO],
            restitution: Value::fraction(253, 255),
        };
        assert!(is_of_small_numbers(&impact(253)));
        assert!(matrix::whole::<1>(&impact(253), integers::elements).is_ok());
        assert!(!is_of_small_numbers(&impact(257)));
        let oblique = Impact { line: [Value::ONE, Value::ONE], ..impact(253) };
        assert!(!is_of_small_numbers(&oblique));
    }
}
