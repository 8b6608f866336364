//! Letters that stand for numbers, each with the range that its physical meaning allows.

use std::fmt;

use super::Fraction;

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

    /// Is this its name? Quicker to ask than for the name.
    pub(crate) fn is_called(&self, name: &str) -> bool {
        let (own, rest) = self.name.split_at(name.len().min(Letter::LONGEST));
        own == name.as_bytes() && rest.first().is_none_or(|byte| *byte == 0)
    }

    /// Does its name begin so? Quicker to ask than for the name.
    pub(crate) fn begins_with(&self, byte: u8) -> bool {
        self.name[0] == byte
    }

    /// The range.
    pub fn range(&self) -> Range {
        self.range
    }

    /// What it stands for at one of the fixed points at which formulas are tried, of an angle its tangent.
    ///
    /// Each letter goes through its whole range in an order of its own, so that of two letters now the one and now the other is
    /// larger: formulas that differ only there, as `k - 1` and `|k - 1|` do, are told apart. An acute angle is one
    /// whose sine and cosine are fractions.
    pub(crate) fn at(&self, point: u32) -> Fraction {
        const PARTS: u64 = 13;
        const WHOLE: i64 = 8 * PARTS as i64 + 1;
        let hash = |seed: u64| self.name().bytes().fold(seed, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(HASH));
        let own = hash(SEED) >> 16;
        let part = (own % PARTS + (1 + own / PARTS % (PARTS - 1)) * u64::from(point)) % PARTS;
        let within = (hash(SEED ^ u64::from(point + 1)) >> 32) % 8;
        let place = (8 * part + within + 1) as i64;
        match self.range {
            Range::Unit => Fraction::new(place, WHOLE),
            Range::Real => Fraction::new(2 * place - WHOLE, 29),
            Range::Acute => Fraction::new(2 * place * WHOLE, WHOLE * WHOLE - place * place),
            Range::Positive | Range::Degrees => Fraction::new(place, WHOLE - place),
        }
    }

    /// Does it stand for a known constant, the tangent of given degrees?
    pub fn is_constant(&self) -> bool {
        self.range == Range::Degrees
    }
}

/// The first state and the factor of the FNV-1a hash.
const SEED: u64 = 0xcbf2_9ce4_8422_2325;
const HASH: u64 = 0x0000_0100_0000_01b3;

impl fmt::Debug for Letter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.range {
            Range::Acute | Range::Degrees => write!(f, "tan({})", self.name()),
            _ => write!(f, "{}", self.name()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_is_called_by_its_whole_name() {
        let longest = "a".repeat(Letter::LONGEST);
        let names = ["v", "v_A", "v_AB", "θ", longest.as_str()];
        for name in names {
            let letter = Letter::new(name, Range::Real).unwrap();
            for other in names.into_iter().chain(["", "v_", "aa", &"a".repeat(Letter::LONGEST + 1)]) {
                assert_eq!(letter.is_called(other), letter.name() == other, "{name} {other}");
            }
        }
    }

    #[test]
    fn points_lie_on_both_sides_of_what_a_formula_turns_at() {
        let letter = |name: &str, range| Letter::new(name, range).unwrap();
        for name in ["u", "v", "w", "m", "k", "e", "x", "v_A", "v_B", "alpha", "beta", "theta"] {
            for (range, turn) in [
                (Range::Positive, Fraction::ONE),
                (Range::Positive, Fraction::from(3)),
                (Range::Positive, Fraction::new(1, 4)),
                (Range::Unit, Fraction::new(1, 3)),
                (Range::Unit, Fraction::new(3, 4)),
                (Range::Acute, Fraction::ONE),
                (Range::Real, Fraction::ZERO),
            ] {
                let above = (0..12).filter(|point| letter(name, range).at(*point) > turn).count();
                assert!((1..12).contains(&above), "{name} {range:?} {turn:?}: {above}");
            }
        }
        for (one, two) in [("u", "v"), ("v", "w"), ("v_A", "v_B"), ("m", "M"), ("alpha", "beta"), ("m_A", "m_B")] {
            let [one, two] = [one, two].map(|name| letter(name, Range::Positive));
            let above = (0..12).filter(|point| one.at(*point) > two.at(*point)).count();
            assert!((2..=10).contains(&above), "{one:?} {two:?}: {above}");
        }
    }
}
