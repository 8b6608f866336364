//! Rules of acceptance: `exact`, `awrt 3sf`, `3sf`, `2dp`, `nearest 1`; `or exact` is implied by each.

use std::fmt;
use std::str::FromStr;

use crate::number::{Fraction, Places};

/// How near a student's answer must be.
///
/// ```
/// use carom::answer::Accept;
/// use carom::number::Places;
/// assert_eq!("awrt 3sf".parse(), Ok(Accept::RoundsTo(Places::SignificantFigures(3))));
/// assert_eq!("2dp or exact".parse(), Ok(Accept::Rounded(Places::DecimalPlaces(2))));
/// assert!("about 3".parse::<Accept>().is_err());
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Accept {
    /// Only the exact value, in any form.
    Exact,
    /// Any answer that rounds to the right figures: `awrt 3sf`.
    RoundsTo(Places),
    /// Exactly so many figures: `3sf`, `nearest 1`.
    Rounded(Places),
}

impl Accept {
    /// To which places a printed decimal is rounded, if the rule has any.
    pub fn places(&self) -> Option<&Places> {
        match self {
            Accept::Exact => None,
            Accept::RoundsTo(places) | Accept::Rounded(places) => Some(places),
        }
    }
}

/// The words are no rule of acceptance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnreadableRule;

impl FromStr for Accept {
    type Err = UnreadableRule;

    fn from_str(text: &str) -> Result<Accept, UnreadableRule> {
        let text = text.trim();
        let text = text.strip_suffix("or exact").map_or(text, str::trim_end);
        if text == "exact" {
            return Ok(Accept::Exact);
        }
        match text.strip_prefix("awrt ") {
            Some(rest) => places(rest).map(Accept::RoundsTo),
            None => places(text).map(Accept::Rounded),
        }
    }
}

fn places(text: &str) -> Result<Places, UnreadableRule> {
    let text = text.trim();
    let count = |digits: &str| digits.trim().parse::<u32>().ok().filter(|count| *count <= 12).ok_or(UnreadableRule);
    if let Some(digits) = text.strip_suffix("sf") {
        return count(digits)
            .and_then(|count| if count == 0 { Err(UnreadableRule) } else { Ok(Places::SignificantFigures(count)) });
    }
    if let Some(digits) = text.strip_suffix("dp") {
        return count(digits).map(Places::DecimalPlaces);
    }
    let step = text.strip_prefix("nearest ").and_then(|step| step.trim().parse::<Fraction>().ok());
    step.and_then(|step| Places::nearest(&step)).ok_or(UnreadableRule)
}

impl fmt::Display for Accept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let awrt = if matches!(self, Accept::RoundsTo(_)) { "awrt " } else { "" };
        match self.places() {
            None => f.write_str("exact"),
            Some(Places::SignificantFigures(count)) => write!(f, "{awrt}{count}sf"),
            Some(Places::DecimalPlaces(count)) => write!(f, "{awrt}{count}dp"),
            Some(Places::Nearest(step)) => write!(f, "{awrt}nearest {}", step.decimal()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_is_read_and_written_in_the_same_words() {
        for text in ["exact", "awrt 3sf", "3sf", "2dp", "awrt 1dp", "nearest 1", "nearest 0.5", "awrt nearest 15"] {
            assert_eq!(text.parse::<Accept>().unwrap().to_string(), text);
        }
        for text in
            ["", "awrt", "0sf", "3 s.f.", "nearest 0", "nearest -1", "nearest 1/3", "99999999999sf", "awrt exact"]
        {
            assert_eq!(text.parse::<Accept>(), Err(UnreadableRule), "{text}");
        }
    }
}
