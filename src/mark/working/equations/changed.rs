//! The two laws changed as students change them, one or several mistakes at once.

use std::sync::OnceLock;

use super::departure::Departure;
use super::pair::{BOTH, Inputs};
use crate::mechanics::Quantity;

/// Every way to change the laws, a few at once, the least change first.
pub(super) fn changes() -> &'static [Change] {
    static CHANGES: OnceLock<Vec<Change>> = OnceLock::new();
    CHANGES.get_or_init(|| {
        let mut found = Vec::new();
        // Where masses are equal a line may be either; of two slips that fit, the one in restitution is likelier.
        for equation in BOTH.into_iter().rev() {
            for tolerance in [0.0, INACCURATE] {
                changes_of(equation, tolerance, &mut found);
            }
        }
        found.sort_by_key(|change| change.departures.iter().map(|departure| departure.weight()).sum::<u32>());
        found
    })
}

fn changes_of(equation: Quantity, tolerance: f64, found: &mut Vec<Change>) {
    let nothing: &[Departure] = &[];
    // Of A and of B before the impact, and then after it.
    let masses: &[([usize; 4], &[Departure])] = match equation {
        Quantity::MomentumEquation => &[
            ([0, 1, 0, 1], &[]),
            ([1, 0, 1, 0], &[Departure::MassesExchanged]),
            ([0, 1, 1, 0], &[Departure::MassesExchanged]),
            ([1, 0, 0, 1], &[Departure::MassesExchanged]),
            ([2, 2, 2, 2], &[Departure::MassesOmitted]),
            ([2, 1, 0, 1], &[Departure::MassMissing]),
            ([0, 2, 0, 1], &[Departure::MassMissing]),
            ([0, 1, 2, 1], &[Departure::MassMissing]),
            ([0, 1, 0, 2], &[Departure::MassMissing]),
        ],
        _ => &[([2, 2, 2, 2], &[])],
    };
    let factors: &[(Factor, &[Departure])] = match equation {
        Quantity::MomentumEquation => &[(Factor::One, nothing)],
        _ => &[
            (Factor::E, nothing),
            (Factor::OverE, &[Departure::RestitutionOnWrongSide]),
            (Factor::One, &[Departure::RestitutionMissing]),
            (Factor::Nought, &[Departure::Coalesced]),
        ],
    };
    let inaccurate: &[Departure] = if tolerance > 0.0 { &[Departure::Inaccurate] } else { nothing };
    for a in TERMS {
        for b in TERMS {
            for (masses, masses_wrong) in masses {
                for (factor, factor_wrong) in factors {
                    for after in AFTER {
                        let wrong = [a.2, b.2, masses_wrong, factor_wrong, after.1, inaccurate];
                        let mut departures: Vec<Departure> = wrong.concat();
                        departures.sort();
                        departures.dedup();
                        // Three different mistakes in one line could make anything of it.
                        let is_all = !departures.contains(&Departure::MassMissing) || departures.len() == 1;
                        if departures.len() <= 2 && is_all {
                            let before = [(a.0, a.1), (b.0, b.1)];
                            let (masses, factor, after) = (*masses, *factor, after.0);
                            found.push(Change { equation, before, masses, factor, after, tolerance, departures });
                        }
                    }
                }
            }
        }
    }
}

/// How far a number may be off and still be meant, in parts of itself.
const INACCURATE: f64 = 0.02;

#[derive(Clone, Copy, PartialEq)]
enum Factor {
    One,
    E,
    OverE,
    Nought,
}

/// One way to change a law.
pub(in crate::mark::working) struct Change {
    pub(super) equation: Quantity,
    before: [(Term, f64); 2],
    masses: [usize; 4],
    factor: Factor,
    after: [f64; 2],
    /// How far numbers may be off, in parts of themselves.
    pub(super) tolerance: f64,
    pub(super) departures: Vec<Departure>,
}

impl Change {
    /// The component of a sphere before the impact as it stands in the changed law; `None` if that is no change here.
    fn component(&self, at: &Inputs, place: usize) -> Option<f64> {
        let (term, sign) = self.before[place];
        let along = at.along[place];
        let size = match term {
            // A sphere at rest has no sign to mistake.
            Term::Along => return (sign > 0.0 || along != 0.0).then_some(sign * along),
            // A component that is nought is no exchange: across, a term is missing; along, none is resolved.
            Term::Across if at.across[place] == 0.0 || along == 0.0 => return None,
            // Components that are given are no sine and cosine: they keep their signs.
            Term::Across if at.in_components => return Some(sign * at.across[place]),
            Term::Across => at.across[place].abs(),
            Term::Speed => at.speed[place],
            Term::Nothing => 0.0,
        };
        let changes = (size - along.abs()).abs() > 1e-9 * at.speed[place];
        changes.then(|| sign * size.copysign(along))
    }

    /// The numbers of `p x + q y = r` at a point; `None` if that is no change there.
    pub(super) fn numbers(&self, at: &Inputs) -> Option<[f64; 3]> {
        let [p, q] = match self.equation {
            Quantity::MomentumEquation => [self.mass(at, 2), self.mass(at, 3)],
            _ => [-1.0, 1.0],
        };
        let [a, b] = self.before_of_each(at)?;
        Some([p * self.after[0], q * self.after[1], a + b])
    }

    /// What the law has of each sphere before the impact; `None` if that is no change at this point.
    pub(super) fn before_of_each(&self, at: &Inputs) -> Option<[f64; 2]> {
        self.of_each(at, [self.component(at, 0)?, self.component(at, 1)?])
    }

    /// The same if the components before the impact are as they should be.
    pub(super) fn unchanged_of_each(&self, at: &Inputs) -> Option<[f64; 2]> {
        self.of_each(at, at.along)
    }

    fn of_each(&self, at: &Inputs, [a, b]: [f64; 2]) -> Option<[f64; 2]> {
        let factor = match (self.equation, self.factor) {
            (Quantity::MomentumEquation, _) => return Some([self.mass(at, 0) * a, self.mass(at, 1) * b]),
            (_, Factor::One) => 1.0,
            (_, Factor::E) => at.e,
            (_, Factor::OverE) if at.e == 0.0 => return None,
            (_, Factor::OverE) => 1.0 / at.e,
            (_, Factor::Nought) => 0.0,
        };
        Some([factor * a, -factor * b])
    }

    fn mass(&self, at: &Inputs, place: usize) -> f64 {
        at.masses.get(self.masses[place]).copied().unwrap_or(1.0)
    }
}

/// How the component of a sphere before the impact may stand in a line: its value from the inputs, and what is wrong with it.
const TERMS: [(Term, f64, &[Departure]); 7] = [
    (Term::Along, 1.0, &[]),
    (Term::Along, -1.0, &[Departure::Sign]),
    (Term::Across, 1.0, &[Departure::SineForCosine]),
    (Term::Across, -1.0, &[Departure::SineForCosine, Departure::Sign]),
    (Term::Speed, 1.0, &[Departure::Unresolved]),
    (Term::Speed, -1.0, &[Departure::Unresolved, Departure::Sign]),
    (Term::Nothing, 1.0, &[Departure::TermMissing]),
];

#[derive(Clone, Copy, PartialEq)]
enum Term {
    Along,
    Across,
    Speed,
    Nothing,
}

/// How the terms after the impact may stand: factors of that of A and that of B.
const AFTER: [([f64; 2], &[Departure]); 4] = [
    ([1.0, 1.0], &[]),
    ([1.0, -1.0], &[Departure::Sign]),
    ([1.0, 0.0], &[Departure::TermMissing]),
    ([0.0, 1.0], &[Departure::TermMissing]),
];
