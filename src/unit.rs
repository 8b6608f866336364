//! Units of the quantities on a paper: kg, m s^-1, N s, J, degrees.

use std::str::FromStr;

/// The unit in which a quantity is stated. Lengths only occur as radii and offsets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// A pure number, such as a coefficient of restitution or a tangent.
    None,
    /// kg
    Kilogram,
    /// m
    Metre,
    /// m s^-1
    MetrePerSecond,
    /// N s
    NewtonSecond,
    /// J
    Joule,
    /// degrees
    Degree,
}

impl Unit {
    /// Every unit, in the order in which messages list them.
    pub const ALL: [Unit; 7] =
        [Unit::None, Unit::Kilogram, Unit::Metre, Unit::MetrePerSecond, Unit::NewtonSecond, Unit::Joule, Unit::Degree];

    /// As it stands in a bank file, in `key.json` and on a terminal: `m/s`, `kg`, `N s`, `J`, `deg`.
    pub fn plain(self) -> &'static str {
        match self {
            Unit::None => "",
            Unit::Kilogram => "kg",
            Unit::Metre => "m",
            Unit::MetrePerSecond => "m/s",
            Unit::NewtonSecond => "N s",
            Unit::Joule => "J",
            Unit::Degree => "deg",
        }
    }
}

impl FromStr for Unit {
    type Err = ();
    fn from_str(text: &str) -> Result<Unit, ()> {
        Unit::ALL.into_iter().find(|unit| *unit != Unit::None && unit.plain() == text).ok_or(())
    }
}
