//! What is chosen finds what the highest tier finds, exactly; and would not, if any need were crossed out.

use carom::method::{Found, Geometry, Impact, Need, Needs, Numbers, Selection, Wanted};
use carom::number::Value;

use super::corpus::{grid, of_questions};

/// The highest tiers' answer.
pub fn top(impact: &Impact<Value>) -> Option<[[Value; 2]; 2]> {
    let needs = Needs::of(impact, Wanted::ExactForm);
    match (Selection { geometry: Geometry::AnyLine, numbers: Numbers::Letters, needs }).solve(impact) {
        Found::Exact(after) => Some(after),
        _ => None,
    }
}

/// Is an outcome the right one, in exact form?
pub fn is_right(found: &Found, truth: &[[Value; 2]; 2]) -> bool {
    let Found::Exact(after) = found else { return false };
    after.as_flattened().iter().zip(truth.as_flattened()).all(|(one, other)| one.equals(other))
}

/// All impacts with the highest tier's answers.
fn corpus() -> Vec<(Impact<Value>, [[Value; 2]; 2])> {
    let impacts = of_questions().into_iter().map(|(_, impact)| impact).chain(grid());
    impacts.filter_map(|impact| top(&impact).map(|truth| (impact, truth))).collect()
}

#[test]
fn carom_knows_that_the_model_it_chooses_suffices() {
    let mut chosen: Vec<(Geometry, Numbers)> = Vec::new();
    let corpus = corpus();
    assert!(corpus.len() > 2000, "{}", corpus.len());
    for (impact, truth) in &corpus {
        let selection = Selection::of(impact, Wanted::ExactForm);
        let found = selection.solve(impact);
        assert!(is_right(&found, truth), "{selection:?} finds {found:?} and not {truth:?} of {impact:?}");
        chosen.push((selection.geometry, selection.numbers));
    }
    for tier in Numbers::ALL {
        let count = chosen.iter().filter(|(_, numbers)| *numbers == tier).count();
        assert_eq!(count > 0, tier != Numbers::CertifiedFloat, "{tier:?} was chosen {count} times");
    }
    for tier in Geometry::ALL {
        assert!(chosen.iter().any(|(geometry, _)| *geometry == tier), "{tier:?} was never chosen");
    }
}

#[test]
fn carom_knows_that_a_tier_refuses_what_it_lacks() {
    for (impact, _) in corpus() {
        let needs = Needs::of(&impact, Wanted::ExactForm);
        for tier in Numbers::ALL {
            let prepared = tier.prepare(std::slice::from_ref(&impact), Geometry::AnyLine);
            let lacking = tier.lacks().iter().find(|need| needs.has(**need));
            match lacking {
                // These two are no matter of what can be written in its numbers.
                Some(Need::ExactForm | Need::Large) => {}
                Some(need) => assert!(prepared.is_err(), "{tier:?} lacks {need:?} and takes {impact:?}"),
                None if tier == Numbers::SurdField && !needs.has(Need::Factors) => {}
                None => {
                    assert!(prepared.is_ok(), "{tier:?} lacks nothing and refuses {impact:?}: {:?}", prepared.err())
                }
            }
        }
    }
}

/// The first tier that lacks none of the needs, if one need of one tier is crossed out.
fn weakened<T: Copy + PartialEq>(all: &[T], lacks: fn(T) -> &'static [Need], at: T, out: Need, needs: Needs) -> T {
    let meets = |tier: &T| !lacks(*tier).iter().any(|need| needs.has(*need) && !(*tier == at && *need == out));
    *all.iter().find(|tier| meets(tier)).unwrap()
}

#[test]
fn carom_knows_that_no_need_can_be_crossed_out() {
    let corpus: Vec<_> = corpus()
        .into_iter()
        .map(|(impact, truth)| (Selection::of(&impact, Wanted::ExactForm), impact, truth))
        .collect();
    let breaks = |changed: &dyn Fn(&Selection) -> Selection| {
        let differs = corpus.iter().filter(|(selection, ..)| changed(selection) != *selection);
        differs.into_iter().any(|(selection, impact, truth)| !is_right(&changed(selection).solve(impact), truth))
    };
    for tier in Numbers::ALL {
        for need in tier.lacks() {
            let change = |selection: &Selection| Selection {
                numbers: weakened(&Numbers::ALL, Numbers::lacks, tier, *need, selection.needs),
                ..*selection
            };
            let only_figures = tier == Numbers::CertifiedFloat && *need == Need::Letters;
            assert!(breaks(&change) || only_figures, "{tier:?} may well do without {need:?}");
        }
    }
    // A float is chosen for figures alone, and has none of a letter.
    let letters = corpus.iter().find(|(selection, ..)| selection.needs.has(Need::Letters)).unwrap();
    assert!(Numbers::CertifiedFloat.prepare(std::slice::from_ref(&letters.1), Geometry::AnyLine).is_err());
    for tier in Geometry::ALL {
        for need in tier.lacks() {
            let change = |selection: &Selection| Selection {
                geometry: weakened(&Geometry::ALL, Geometry::lacks, tier, *need, selection.needs),
                ..*selection
            };
            assert!(breaks(&change), "{tier:?} may well do without {need:?}");
        }
    }
}

#[test]
fn carom_knows_that_a_further_need_never_lowers_the_tier() {
    let all: Vec<Needs> = (0..1 << Need::ALL.len())
        .map(|bits: u32| {
            Need::ALL.into_iter().enumerate().filter(|(place, _)| bits >> place & 1 == 1).map(|(_, n)| n).collect()
        })
        .collect();
    for needs in all {
        for more in Need::ALL.map(|need| needs.with(need)) {
            assert!(Numbers::least(more) >= Numbers::least(needs), "{needs:?} {more:?}");
            assert!(Geometry::least(more) >= Geometry::least(needs), "{needs:?} {more:?}");
        }
    }
}
