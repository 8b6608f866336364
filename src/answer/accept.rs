//! Rules of acceptance: `exact`, `awrt 3sf`, `3sf`, `2dp`, `nearest 1`; `or exact` is implied by each.
//!
//! `3sf or better` is `awrt 3sf`, and `nearest degree` is `nearest 1`. The examiners' words `oe` (or equivalent), `isw`
//! (ignore subsequent working) and `cao` (correct answer only) may follow a rule or stand alone for `exact`: any form
//! counts, what follows a right answer is ignored, and only the right answer is accepted under every rule.

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

impl Accept {
    /// The rule as a person may say it: `AWRT 3 s.f.`, `to the nearest degree`, `2 decimal places`.
    ///
    /// # Errors
    ///
    /// If it is no rule, however it is said.
    ///
    /// ```
    /// use carom::answer::Accept;
    /// assert_eq!(Accept::said("AWRT 3 s.f."), "awrt 3sf".parse());
    /// ```
    pub fn said(words: &str) -> Result<Accept, UnreadableRule> {
        const SAID: [(&str, &str); 9] = [
            ("significant figure", "sf"),
            ("decimal place", "dp"),
            ("sig fig", "sf"),
            ("s.f.", "sf"),
            ("s.f", "sf"),
            ("d.p.", "dp"),
            ("d.p", "dp"),
            ("sfs", "sf"),
            ("dps", "dp"),
        ];
        let short = SAID.iter().fold(words.to_lowercase(), |words, (long, short)| words.replace(long, short));
        let short = short.strip_prefix("to ").unwrap_or(&short).replace("the nearest", "nearest");
        short.replace("awrt to ", "awrt ").parse()
    }
}

/// The words are no rule of acceptance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnreadableRule;

impl FromStr for Accept {
    type Err = UnreadableRule;

    fn from_str(text: &str) -> Result<Accept, UnreadableRule> {
        let mut words = text.trim();
        let mut better = false;
        let mut said = false;
        loop {
            let shorter = IMPLIED.iter().find_map(|word| ends_in(words, word));
            let Some(shorter) = shorter.or_else(|| ends_in(words, "or better").filter(|_| !better)) else { break };
            better |= words.ends_with("better");
            said = true;
            words = shorter;
        }
        if (words == "exact" || (words.is_empty() && said)) && !better {
            return Ok(Accept::Exact);
        }
        match words.strip_prefix("awrt ") {
            Some(rest) => places(rest).map(Accept::RoundsTo),
            None if better => places(words).map(Accept::RoundsTo),
            None => places(words).map(Accept::Rounded),
        }
    }
}

/// Words that say what holds of every rule.
const IMPLIED: [&str; 4] = ["or exact", "oe", "isw", "cao"];

/// What stands before a last word, if that is the last.
fn ends_in<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let rest = text.strip_suffix(word)?;
    (rest.is_empty() || rest.ends_with(char::is_whitespace)).then(|| rest.trim_end())
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
    if text == "nearest degree" {
        return Places::nearest(&Fraction::ONE).ok_or(UnreadableRule);
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
    fn examiners_words_that_say_the_same_make_the_same_rule() {
        for (words, rule) in [
            ("3sf or better", "awrt 3sf"),
            ("awrt 3sf oe isw", "awrt 3sf"),
            ("2dp or exact", "2dp"),
            ("nearest degree", "nearest 1"),
            ("awrt nearest degree", "awrt nearest 1"),
            ("cao", "exact"),
            ("oe", "exact"),
            ("exact isw", "exact"),
        ] {
            assert_eq!(words.parse::<Accept>().map(|rule| rule.to_string()), Ok(rule.to_string()), "{words}");
        }
    }

    #[test]
    fn a_person_may_say_a_rule_at_length() {
        for (words, rule) in [
            ("AWRT 3 s.f.", "awrt 3sf"),
            ("3 s.f.", "3sf"),
            ("2 d.p. or better", "awrt 2dp"),
            ("to 3 significant figures", "3sf"),
            ("2 decimal places cao", "2dp"),
            ("1 decimal place", "1dp"),
            ("to the nearest degree", "nearest 1"),
            ("awrt to the nearest 0.5", "awrt nearest 0.5"),
            ("Exact", "exact"),
            ("nearest degree", "nearest 1"),
        ] {
            assert_eq!(Accept::said(words).map(|rule| rule.to_string()), Ok(rule.to_string()), "{words}");
        }
        for words in ["", "about 3", "2.8 or better", "awrt 2.78", "3"] {
            assert_eq!(Accept::said(words), Err(UnreadableRule), "{words}");
        }
    }

    #[test]
    fn every_rule_is_read_and_written_in_the_same_words() {
        for text in ["exact", "awrt 3sf", "3sf", "2dp", "awrt 1dp", "nearest 1", "nearest 0.5", "awrt nearest 15"] {
            assert_eq!(text.parse::<Accept>().unwrap().to_string(), text);
        }
        for text in [
            "",
            "awrt",
            "or better",
            "exact or better",
            "3sfoe",
            "0sf",
            "3 s.f.",
            "nearest 0",
            "nearest -1",
            "nearest 1/3",
            "99999999999sf",
            "awrt exact",
        ] {
            assert_eq!(text.parse::<Accept>(), Err(UnreadableRule), "{text}");
        }
    }
}
