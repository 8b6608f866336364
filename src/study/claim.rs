//! Claims: up to where each arrangement holds and from where it fails, in a table that is tried in both directions.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::exam_grid::{Census, Count, SMALL, WHOLE};
use super::map::{Map, Row};

/// A claim about a row of a map.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Claim {
    /// The map.
    pub map: String,
    /// The row.
    pub arrangement: String,
    /// Within this much of the truth.
    pub bound: f64,
    /// It holds for every k up to this one; none if not even for the first.
    pub holds_to: Option<u32>,
    /// It fails at this k, and at every later one before `holds_again`.
    pub fails_from: Option<u32>,
    /// From this k on it holds again.
    pub holds_again: Option<u32>,
    /// What a teacher should know.
    pub sentence: String,
}

/// A claim about what a method makes of the exam grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct CountClaim {
    /// The method; empty for the grid itself.
    pub method: String,
    /// What is counted: a column of `grid.csv`; of the grid itself its `scenes`, `noughts` and `ties`.
    pub column: String,
    /// How many on the small grid of [`SMALL`](super::SMALL), which a test goes through.
    pub small: u64,
    /// How many on the whole grid, which a study goes through.
    pub whole: u64,
}

/// The tables, as they are in the file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claims {
    /// About maps.
    pub claim: Vec<Claim>,
    /// About the exam grid.
    pub count: Vec<CountClaim>,
}

/// A claim that holds everywhere has to be as sharp as this: the worst error is above the bound divided by it.
const SHARP: f64 = 20.0;

/// Every claim, in the order in which they are printed; the reason if the table cannot be read.
pub fn claims() -> Result<Claims, String> {
    toml::from_str(include_str!("claims.toml")).map_err(|error| error.to_string())
}

impl CountClaim {
    /// The number that it is about; of the grid itself if no method is named.
    fn found(&self, census: &Census) -> Option<u64> {
        match (self.method.as_str(), self.column.as_str()) {
            ("", "scenes") => Some(census.scenes),
            ("", "noughts") => Some(census.noughts),
            ("", "ties") => Some(census.ties),
            (method, column) => {
                let count = census.counts.iter().find(|count| count.method == method)?;
                let place = Count::COLUMNS.iter().position(|name| *name == column)?;
                Some(count.numbers()[place])
            }
        }
    }

    /// What is not as it says; empty if all is.
    pub fn tried(&self, census: &Census) -> Option<String> {
        let expected = match census.bounds {
            WHOLE => self.whole,
            SMALL => self.small,
            _ => return Some("the claims are about another grid".to_owned()),
        };
        let Some(found) = self.found(census) else {
            return Some(format!("the grid has no `{}` of `{}`", self.column, self.method));
        };
        let words =
            format!("`{}` of `{}` is said to be {expected} on the grid, and is {found}", self.column, self.method);
        (found != expected).then_some(words)
    }
}

impl Claim {
    /// What is not as it says; empty if all is.
    pub fn tried(&self, map: &Map) -> Vec<String> {
        let Some(row) = map.row(&self.arrangement) else {
            return vec![format!("`{}` has no row `{}`", self.map, self.arrangement)];
        };
        let mut broken = Vec::new();
        let mut say = |words: String| broken.push(format!("`{}` of `{}` {words}", self.arrangement, self.map));
        for (k, outcome) in (map.first..).zip(&row.worst) {
            let should = self.should_hold(k, map.last());
            if should.is_some_and(|should| should != outcome.within(self.bound)) {
                let word = if should == Some(true) { "holds" } else { "fails" };
                say(format!("is said to {word} at k = {k} with {:e}, and is off by {outcome:?}", self.bound));
            }
        }
        if self.fails_from.is_none() && !self.is_sharp(row) {
            say(format!("is never off by as much as a {SHARP}th of {:e}: say less than that", self.bound));
        }
        if self.fails_from.is_none() && self.holds_to != Some(map.last()) {
            say("does not say where it fails, nor that it holds to the end".to_owned());
        }
        broken
    }

    /// Whether it should be within the bound at k; none where nothing is said.
    fn should_hold(&self, k: u32, last: u32) -> Option<bool> {
        if self.holds_to.is_some_and(|end| k <= end) || self.holds_again.is_some_and(|start| k >= start) {
            return Some(true);
        }
        let ends = self.holds_again.unwrap_or(last + 1);
        // Just before it holds again nothing is said: between failing and holding there may be a column of either.
        self.fails_from.is_some_and(|start| k >= start && (k + 1 < ends || k == start)).then_some(false)
    }

    fn is_sharp(&self, row: &Row) -> bool {
        let worst = row.worst.iter().filter_map(|outcome| outcome.error()).fold(0.0, f64::max);
        self.bound == 0.0 || worst > self.bound / SHARP
    }
}

/// Everything that is not as the claims say.
///
/// A claim that an arrangement always holds says something only beside another that fails in the same regime.
pub fn try_all(claims: &[Claim], maps: &[Map]) -> Vec<String> {
    let maps: BTreeMap<&str, &Map> = maps.iter().map(|map| (map.name.as_str(), map)).collect();
    let mut broken = Vec::new();
    for claim in claims {
        match maps.get(claim.map.as_str()) {
            Some(map) => broken.extend(claim.tried(map)),
            None => broken.push(format!("there is no map `{}`", claim.map)),
        }
        let rival = |other: &&Claim| other.map == claim.map && other.fails_from.is_some();
        if claim.fails_from.is_none() && !claims.iter().any(|other| rival(&other)) {
            broken.push(format!(
                "nothing fails in `{}`, so that `{}` holds there says little",
                claim.map, claim.arrangement
            ));
        }
    }
    broken
}

#[cfg(test)]
mod tests {
    use super::super::double::Outcome;
    use super::*;

    fn map(errors: &[f64]) -> Map {
        Map {
            name: "m".to_owned(),
            quantity: "q".to_owned(),
            regime: "r".to_owned(),
            first: 0,
            rows: vec![Row {
                arrangement: "a".to_owned(),
                says: String::new(),
                worst: errors.iter().map(|error| Outcome::Off(*error)).collect(),
            }],
        }
    }

    fn claim(holds_to: Option<u32>, fails_from: Option<u32>) -> Claim {
        Claim {
            map: "m".to_owned(),
            arrangement: "a".to_owned(),
            bound: 1e-3,
            holds_to,
            fails_from,
            holds_again: None,
            sentence: "…".to_owned(),
        }
    }

    #[test]
    fn a_claim_is_tried_in_both_directions() {
        let errors = map(&[1e-9, 1e-6, 1e-2, 1.0]);
        assert_eq!(claim(Some(1), Some(2)).tried(&errors), Vec::<String>::new());
        assert!(!claim(Some(2), Some(3)).tried(&errors).is_empty(), "it does not hold at 2");
        assert!(!claim(Some(0), Some(1)).tried(&errors).is_empty(), "it does not fail at 1");
        assert!(!claim(Some(3), None).tried(&errors).is_empty());
    }

    #[test]
    fn a_claim_that_could_not_fail_is_none() {
        assert!(!claim(Some(2), None).tried(&map(&[1e-9, 1e-9, 1e-9])).is_empty(), "the bound is far too wide");
        assert!(!claim(Some(1), None).tried(&map(&[5e-4, 5e-4, 5e-4])).is_empty(), "the end is left open");
        let lone = [Claim { bound: 1e-3, ..claim(Some(2), None) }];
        assert!(!try_all(&lone, &[map(&[5e-4, 5e-4, 5e-4])]).is_empty(), "nothing to compare with");
    }
}
