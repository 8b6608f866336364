//! Kinds of answer, by the names that bank files and keys use.

use std::str::FromStr;

/// What sort of thing is to be found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A number, with or without unit.
    Number,
    /// An angle in degrees.
    Angle,
    /// A vector by its components.
    Vector,
    /// A velocity by its magnitude and direction, where there is no i and j.
    Velocity,
    /// A ratio such as 2 : 3.
    Ratio,
    /// A formula in letters.
    Expression,
    /// An equation between letters.
    Equation,
    /// The values for which something holds, from one number to another: `1/3 < e <= 1`.
    Range,
    /// The direction of a line, given by any vector along it.
    Line,
    /// A result that is printed in the question and is to be shown.
    Shown,
}

impl Kind {
    /// Every kind, in the order in which messages list them.
    pub const ALL: [Kind; 10] = [
        Kind::Number,
        Kind::Angle,
        Kind::Vector,
        Kind::Velocity,
        Kind::Ratio,
        Kind::Expression,
        Kind::Equation,
        Kind::Range,
        Kind::Line,
        Kind::Shown,
    ];

    /// Those that an answer of a question file can have: a question there asks for the size and the direction of a
    /// velocity one by one.
    pub const IN_BANK: [Kind; 9] = [
        Kind::Number,
        Kind::Angle,
        Kind::Vector,
        Kind::Ratio,
        Kind::Expression,
        Kind::Equation,
        Kind::Range,
        Kind::Line,
        Kind::Shown,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Number => "number",
            Kind::Angle => "angle",
            Kind::Vector => "vector",
            Kind::Velocity => "velocity",
            Kind::Ratio => "ratio",
            Kind::Expression => "expression",
            Kind::Equation => "equation",
            Kind::Range => "range",
            Kind::Line => "line",
            Kind::Shown => "shown",
        }
    }
}

/// No kind of answer has this name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownKind;

impl FromStr for Kind {
    type Err = UnknownKind;
    fn from_str(name: &str) -> Result<Kind, UnknownKind> {
        Kind::ALL.into_iter().find(|kind| kind.name() == name).ok_or(UnknownKind)
    }
}
