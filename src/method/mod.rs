//! Every way in which Carom can solve an impact, behind one trait, in one list, one file each.
//!
//! Some are on the path of printed answers; of these [`Selection`] takes the cheapest that suffices. Others stand beside
//! it to be compared with: a derivation that checks itself proves nothing, and a study of speed against
//! accuracy needs peers. The exhibits show what simulation costs. `tests/data/impacts.toml` runs over all of them and
//! over the laws of [`mechanics`](crate::mechanics), with which none but the answer path's own values share any code. To add
//! a method, write its file and add its line to [`METHODS`].
//!
//! Floats occur here and decide nothing: no method that computes in them is on the path of an exact answer.

mod answer;
mod batch;
mod beside;
mod elements;
pub mod exhibit;
mod geometry;
mod impact;
mod needs;
mod proportion;
mod select;

pub use geometry::{Field, Geometry};
pub use impact::{After, Impact};
pub use needs::{Need, Needs, Wanted};
pub use select::{Numbers, Selection, figures};

use crate::number::{Interval, Value};
use answer::{certified, fractions, integers, letters, linear_forms, polynomials, surd_field, surd_integers};
use beside::{
    centre_of_mass, columns, cramer, double_double, elimination, float_intervals, from_integers, fused, interval,
    ratio, reduced_mass, single, textbook, two_equations,
};
use exhibit::{FixedStep, Sequential, Spring};

/// What a method is here for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Its values may be printed as answers.
    AnswerPath,
    /// Correct in its own numbers, and here to be compared with.
    Beside,
    /// Shows what goes wrong, or what it costs, when an impact is simulated.
    Exhibit,
}

/// How good what a method finds is, whatever the impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Promise {
    /// It is the velocity itself.
    Exact,
    /// The velocity lies in the interval.
    Enclosed,
    /// No component is off by more than so many roundoffs (2^-53) of the larger speed before the impact, as long as no
    /// number overflows or loses figures by being tiny.
    Scaled(f64),
    /// Nothing, and why.
    Nothing(&'static str),
}

/// Why a method does not take a batch of impacts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skip {
    /// The first impact that it does not accept.
    pub place: usize,
    /// Why not.
    pub why: String,
}

/// What a method found for one impact.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    /// The velocities themselves.
    Exact(After<Value>),
    /// Intervals that hold them.
    Enclosed(After<Interval>),
    /// Floats near them.
    Float(After<f64>),
    /// Nothing: why.
    Missed(String),
}

/// A way to solve an impact.
pub trait Method: Sync {
    /// Its name, on a command line and on a chart: `reduced-mass`.
    fn name(&self) -> &'static str;

    /// What it is here for.
    fn role(&self) -> Role;

    /// What it accepts, in words.
    fn accepts(&self) -> &'static str;

    /// How good its results are.
    fn promises(&self) -> Promise;

    /// The impacts in the method's own numbers, ready to be solved any number of times.
    ///
    /// # Errors
    ///
    /// The first impact that is not accepted, and why.
    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip>;
}

/// Impacts in a method's own numbers.
pub trait Prepared {
    /// Solves them all once. This is what is timed.
    fn run(&mut self);

    /// What the last run found, in the order of the impacts.
    fn found(&self) -> Vec<Found>;
}

/// Every method, the cheaper before the dearer within each role.
///
/// ```
/// use carom::method::{Found, Impact, METHODS, Role};
/// use carom::number::Value;
/// // Equal masses and e = 1 exchange their components along the line of centres.
/// let [nought, one, two, three, four] = [0, 1, 2, 3, 4].map(Value::from);
/// let impact = Impact {
///     masses: [one.clone(), one.clone()],
///     before: [[three, four], [nought.clone(), nought.clone()]],
///     line: [two, nought],
///     restitution: one,
/// };
/// for method in METHODS.iter().filter(|method| method.role() != Role::Exhibit) {
///     let Ok(mut prepared) = method.prepare(std::slice::from_ref(&impact)) else { continue };
///     prepared.run();
///     if let Found::Float(after) = &prepared.found()[0] {
///         assert!((after[0][1] - 4.0).abs() < 1e-6, "{}", method.name());
///     }
/// }
/// ```
pub const METHODS: &[&dyn Method] = &[
    &integers::Integers,
    &certified::Certified,
    &surd_integers::SurdIntegers,
    &linear_forms::LinearForms,
    &surd_field::SurdField,
    &polynomials::Polynomials,
    &fractions::Fractions,
    &letters::Letters,
    &columns::Columns,
    &single::Single,
    &ratio::Ratio,
    &textbook::Textbook,
    &cramer::Cramer,
    &fused::FusedRatio,
    &fused::FusedTextbook,
    &centre_of_mass::CentreOfMass,
    &reduced_mass::ReducedMass,
    &from_integers::FromIntegers,
    &two_equations::TwoEquations::Plain,
    &two_equations::TwoEquations::Pivoted,
    &two_equations::TwoEquations::Scaled,
    &elimination::Elimination,
    &float_intervals::FloatIntervals,
    &double_double::DoubleDouble,
    &interval::Intervals,
    &Sequential::USUAL,
    &FixedStep::USUAL,
    &Spring::RUNGE_KUTTA,
    &Spring::VERLET,
];

/// The method of a name.
pub fn method(name: &str) -> Option<&'static dyn Method> {
    METHODS.iter().find(|method| method.name() == name).copied()
}

/// One impact solved by one method.
pub fn solve_once(method: &dyn Method, impact: &Impact<Value>) -> Result<Found, Skip> {
    let mut prepared = method.prepare(std::slice::from_ref(impact))?;
    prepared.run();
    Ok(prepared.found().swap_remove(0))
}
