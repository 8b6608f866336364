//! How a marker sees in a student's working that a law was used.

use super::Quantity;

/// What a line of working must be to show the use of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// The equation that the law gives for the components after the impact along the line of centres.
    Equation,
    /// A value for one of those components.
    Unknown,
    /// The components perpendicular to the line of centres, anywhere.
    Unchanged,
    /// An equation between vectors, with a velocity to be found.
    VectorEquation,
    /// A vector along the line of centres.
    AlongLine,
    /// Components along the line of centres, or any common multiple of them.
    Components,
    /// The value of one of these quantities, or a formula of this shape.
    Value(&'static [Quantity], Shape),
}

/// A shape by which a formula is known whatever numbers stand in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// None: the value must tell.
    Any,
    /// `v² + p²`, one component along and one across the line of centres.
    Pythagoras,
    /// `p/v` or `v/p`.
    Tangent,
    /// Squares of velocities added and subtracted.
    DifferenceOfSquares,
    /// A mass times a difference.
    ChangeOfMomentum,
}
