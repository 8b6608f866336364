//! Each cheaper tier refuses the scene or is wrong on it: a witness for every pair of tiers, in `tests/data/witnesses.toml`.

use carom::method::{Found, Geometry, Impact, Need, Numbers, Selection, Wanted};
use carom::number::{Places, Value};
use serde::Deserialize;

use super::corpus::value;
use super::sufficiency::{is_right, top};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    numbers: Vec<Witness>,
    geometry: Vec<Witness>,
}

/// An impact for which a tier is chosen, and for each cheaper tier what it lacks.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Witness {
    name: String,
    tier: String,
    masses: [String; 2],
    before: [[String; 2]; 2],
    #[serde(default = "along_i")]
    line: [String; 2],
    e: String,
    /// `exact-form` or `figures`.
    wanted: String,
    /// Cheaper tiers, each with a need of the scene that it cannot meet.
    lacks: Vec<[String; 2]>,
}

fn along_i() -> [String; 2] {
    ["1", "0"].map(str::to_owned)
}

impl Witness {
    fn impact(&self) -> Impact<Value> {
        let values = |pair: &[String; 2]| pair.each_ref().map(|text| value(text));
        Impact {
            masses: values(&self.masses),
            before: self.before.each_ref().map(values),
            line: values(&self.line),
            restitution: value(&self.e),
        }
    }

    fn wanted(&self) -> Wanted {
        match self.wanted.as_str() {
            "exact-form" => Wanted::ExactForm,
            "figures" => Wanted::Figures,
            other => panic!("{other}"),
        }
    }
}

fn table() -> Table {
    toml::from_str(include_str!("../data/witnesses.toml")).unwrap()
}

fn need(name: &str) -> Need {
    Need::ALL.into_iter().find(|need| need.name() == name).unwrap_or_else(|| panic!("{name} is no need"))
}

/// Every pair of a tier and a cheaper one has a witness.
fn all_pairs<T: Copy + PartialEq>(all: &[T], name: fn(T) -> &'static str, witnesses: &[Witness]) {
    for (place, tier) in all.iter().enumerate() {
        for cheaper in &all[..place] {
            let shown = |witness: &&Witness| {
                witness.tier == name(*tier) && witness.lacks.iter().any(|[lacking, _]| lacking == name(*cheaper))
            };
            assert!(witnesses.iter().any(|w| shown(&w)), "no witness of {} against {}", name(*tier), name(*cheaper));
        }
    }
}

#[test]
fn carom_knows_a_witness_for_every_pair_of_numbers() {
    let witnesses = table().numbers;
    all_pairs(&Numbers::ALL, Numbers::name, &witnesses);
    for witness in &witnesses {
        let impact = witness.impact();
        let selection = Selection::of(&impact, witness.wanted());
        assert_eq!(selection.numbers.name(), witness.tier, "{}: {:?}", witness.name, selection.needs);
        let truth = top(&impact).unwrap();
        for [cheaper, lacking] in &witness.lacks {
            let tier = Numbers::ALL.into_iter().find(|tier| tier.name() == cheaper).unwrap();
            let lacking = need(lacking);
            assert!(tier < selection.numbers, "{}: {cheaper} is not cheaper", witness.name);
            assert!(selection.needs.has(lacking) && tier.lacks().contains(&lacking), "{}: {lacking:?}", witness.name);
            let forced = Selection { numbers: tier, ..selection }.solve(&impact);
            assert!(!is_right(&forced, &truth), "{}: {cheaper} finds the answer too", witness.name);
        }
    }
}

#[test]
fn carom_knows_a_witness_for_every_pair_of_geometries() {
    let witnesses = table().geometry;
    all_pairs(&Geometry::ALL, Geometry::name, &witnesses);
    for witness in &witnesses {
        let impact = witness.impact();
        let selection = Selection::of(&impact, witness.wanted());
        assert_eq!(selection.geometry.name(), witness.tier, "{}: {:?}", witness.name, selection.needs);
        let truth = top(&impact).unwrap();
        for [cheaper, lacking] in &witness.lacks {
            let tier = Geometry::ALL.into_iter().find(|tier| tier.name() == cheaper).unwrap();
            let lacking = need(lacking);
            assert!(selection.needs.has(lacking) && tier.lacks().contains(&lacking), "{}: {lacking:?}", witness.name);
            let forced = Selection { geometry: tier, ..selection }.solve(&impact);
            assert!(matches!(forced, Found::Exact(_)) && !is_right(&forced, &truth), "{}: {forced:?}", witness.name);
        }
    }
}

#[test]
fn carom_knows_that_a_float_which_cannot_settle_the_figures_is_refused() {
    let places = Places::SignificantFigures(3);
    // A's velocity is √2 (1 - 1/2·2)/3 = 0: a float cannot tell nought from its neighbours.
    let stopping = super::corpus::impact(["1", "2"], [["sqrt(2)", "0"], ["0", "0"]], ["1", "0"], "1/2");
    assert_eq!(Selection::of(&stopping, Wanted::Figures).numbers, Numbers::CertifiedFloat);
    let (after, tier) = carom::method::figures(&stopping, &places).unwrap();
    assert_eq!((after[0][0].to_string().as_str(), tier), ("0", Numbers::SurdIntegers));
    // With e = 1 nothing is near a tie, and the float will do.
    let going = super::corpus::impact(["1", "2"], [["sqrt(2)", "0"], ["0", "0"]], ["1", "0"], "1");
    assert_eq!(carom::method::figures(&going, &places).unwrap().1, Numbers::CertifiedFloat);
}
