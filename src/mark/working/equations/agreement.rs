//! Do the terms of a line agree with those of a law, up to a factor that they have in common?

use crate::mark::working::numbers::Spread;

/// How far a term may be off that was rounded more than its figures show.
pub(super) const SLACK: f64 = 0.002;

/// Two terms could be anything's.
pub(super) const LEAST_TERMS: usize = 3;

/// How a line agrees with a law.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Agrees {
    /// In every term but for signs, once it is multiplied by something.
    ButForSignsAndFactor,
    /// In every term but for signs.
    ButForSigns,
    Fully,
}

/// The same of a law with enough terms.
pub(super) fn agreement_of_three(terms: &[Spread], law: &[f64]) -> Option<(Agrees, f64)> {
    let is_whole = law.iter().filter(|term| term.abs() > 1e-9).count() >= LEAST_TERMS;
    is_whole.then(|| agreement(terms, law)).flatten()
}

/// Do the terms agree with those of a law, up to a factor? And the factor. What is nought need not be written.
pub(super) fn agreement(terms: &[Spread], law: &[f64]) -> Option<(Agrees, f64)> {
    let size = law.iter().fold(0.0, |size: f64, term| size.max(term.abs()));
    let law: Vec<f64> = law.iter().copied().filter(|term| term.abs() > 1e-9 * size).collect();
    let largest = terms.iter().fold(0.0, |size: f64, term| size.max(term.middle().abs()));
    let terms: Vec<Spread> = terms.iter().copied().filter(|term| !term.may_be_nought(largest)).collect();
    if terms.len() != law.len() || law.is_empty() || !sizes_agree(&terms, &law) {
        return None;
    }
    let mut best: Option<(Agrees, f64)> = None;
    for one in &law {
        let scale = terms[0].middle() / one;
        let is_as_it_stands = (scale.abs() - 1.0).abs() <= SLACK;
        let but_for_signs = if is_as_it_stands { Agrees::ButForSigns } else { Agrees::ButForSignsAndFactor };
        for agrees in [Agrees::Fully, but_for_signs] {
            let is = |term: Spread, own: f64| match agrees {
                Agrees::Fully => term.may_be(own * scale),
                _ => near(term.absolute(), (own * scale).abs()),
            };
            if best.is_none_or(|(found, _)| found < agrees) && pairs_off(&terms, &law, &is) {
                best = Some((agrees, scale));
            }
        }
    }
    best
}

/// Is the largest to the smallest as it is in the law? Nearly always that tells.
fn sizes_agree(terms: &[Spread], law: &[f64]) -> bool {
    let ends = |pick: fn(f64, f64) -> f64, from: f64| {
        let sizes = terms.iter().map(|term| term.absolute());
        let (low, high) = sizes.fold((from, from), |(low, high), size| (pick(low, size.low), pick(high, size.high)));
        let own = law.iter().fold(from, |own, term| pick(own, term.abs()));
        ((1.0 - SLACK) * low / own, (1.0 + SLACK) * high / own)
    };
    let (largest, smallest) = (ends(f64::max, 0.0), ends(f64::min, f64::MAX));
    largest.0 <= smallest.1 && smallest.0 <= largest.1
}

/// Is it this number, or this number rounded more than its figures show?
pub(super) fn near(term: Spread, number: f64) -> bool {
    let slack = SLACK * number.abs();
    term.may_be(number) || (term.low - slack..=term.high + slack).contains(&number)
}

/// Has each term one of the law's for its own?
fn pairs_off(terms: &[Spread], law: &[f64], is: &dyn Fn(Spread, f64) -> bool) -> bool {
    let Some((first, rest)) = terms.split_first() else { return law.is_empty() };
    (0..law.len()).any(|place| {
        is(*first, law[place]) && {
            let mut others = law.to_vec();
            others.remove(place);
            pairs_off(rest, &others, is)
        }
    })
}
