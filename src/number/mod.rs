//! Numbers: fractions, surds, letters, certified intervals and rounding; what a law can be evaluated in.

mod angle;
mod arithmetic;
mod complement;
mod coprime;
mod corners;
mod decide;
mod decimal;
mod direction;
mod division;
mod elimination;
mod enclose;
mod equation;
mod float_interval;
mod fraction;
mod inequality;
mod interval;
mod inverse_trigonometry;
mod letter;
mod operations;
mod polynomial;
mod polynomial_roots;
mod quotient;
mod residue;
mod root;
mod rounding;
mod shared_factors;
mod square;
pub(crate) mod steps;
mod supposed;
mod terms;
mod trigonometry;
mod value;
#[cfg(test)]
mod value_tests;
mod waves;

pub use angle::Angle;
pub use arithmetic::Number;
pub use decimal::{Decimal, Places, Step};
pub use direction::Direction;
pub use elimination::{discriminant_of_squares, solve_system};
pub use enclose::Assignment;
pub use equation::{NoRoots, collected};
pub(crate) use float_interval::FloatInterval;
pub use fraction::{Fraction, NotAFraction};
pub use inequality::{Demand, End, Span, solve_inequalities};
pub use interval::Interval;
pub use letter::{Letter, Range};
pub use polynomial::{Monomial, Polynomial};
pub(crate) use rounding::clear_in_doubles;
pub use rounding::{Uncertain, clear_of_tie, round, round_certified};
#[doc(hidden)]
pub use steps::taken as steps_taken;
pub use terms::Roots;
pub use value::{Compound, Root, Value};
