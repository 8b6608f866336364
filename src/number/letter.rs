//! Letters that stand for numbers, each with the range that its physical meaning allows.

use std::fmt;

/// What is known of the number that a letter stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Range {
    /// Above nought: a mass, a speed, a radius.
    Positive,
    /// From nought to one: a coefficient of restitution.
    Unit,
    /// An angle between nought and a right angle. In a [`Polynomial`](super::Polynomial) the letter
    /// stands for the *tangent* of the angle, so that sines and cosines stay rational in it.
    Acute,
    /// Anything.
    Real,
    /// Not a letter to a reader: the tangent of so many degrees, for an angle without a surd, such
    /// as 10 degrees. The name is the number of degrees.
    Degrees,
}

impl Range {
    /// The ranges that a person can declare.
    pub const DECLARED: [(&'static str, Range); 4] =
        [("positive", Range::Positive), ("unit", Range::Unit), ("acute", Range::Acute), ("real", Range::Real)];
}

/// A letter: a short name and its range. Two letters are one if both agree.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Letter {
    // The name first, so that the alphabet orders letters: the order decides which of two equal
    // forms is canonical, and must not depend on the order in which letters were met.
    name: [u8; Letter::LONGEST],
    range: Range,
}

impl Letter {
    /// The longest name of a letter, in bytes.
    pub const LONGEST: usize = 23;

    /// A letter with a name of at most [`Letter::LONGEST`] bytes; `None` for a longer one.
    pub fn new(name: &str, range: Range) -> Option<Letter> {
        let mut bytes = [0; Letter::LONGEST];
        bytes.get_mut(..name.len())?.copy_from_slice(name.as_bytes());
        Some(Letter { name: bytes, range })
    }

    /// The name.
    pub fn name(&self) -> &str {
        let length = self.name.iter().position(|byte| *byte == 0).unwrap_or(Letter::LONGEST);
        std::str::from_utf8(&self.name[..length]).expect("a letter is made from a whole name")
    }

    /// Does its name begin so? Quicker to ask than for the name.
    pub(crate) fn begins_with(&self, byte: u8) -> bool {
        self.name[0] == byte
    }

    /// The range.
    pub fn range(&self) -> Range {
        self.range
    }

    /// Does it stand for a known constant, the tangent of given degrees?
    pub fn is_constant(&self) -> bool {
        self.range == Range::Degrees
    }
}

impl fmt::Debug for Letter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.range {
            Range::Acute | Range::Degrees => write!(f, "tan({})", self.name()),
            _ => write!(f, "{}", self.name()),
        }
    }
}
