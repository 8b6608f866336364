//! Lengths as they stand in a picture's source.

use std::fmt;

/// A number with no more than two places, and none that say nothing.
pub struct Short(pub f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hundredths = (self.0 * 100.0).round() as i64;
        let (sign, size) = (if hundredths < 0 { "-" } else { "" }, hundredths.abs());
        match (size / 100, size % 100) {
            (whole, 0) => write!(f, "{sign}{whole}"),
            (whole, rest) if rest % 10 == 0 => write!(f, "{sign}{whole}.{}", rest / 10),
            (whole, rest) => write!(f, "{sign}{whole}.{rest:02}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_has_two_places_at_most() {
        let cases = [(0.0, "0"), (-0.001, "0"), (2.0, "2"), (2.1, "2.1"), (-0.254, "-0.25"), (12.049, "12.05")];
        for (length, printed) in cases {
            assert_eq!(Short(length).to_string(), printed);
        }
    }
}
