//! Variants of a small question: dealt in a fixed order, none twice, and only such as its file allows.

use std::collections::BTreeSet;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use carom::bank::{Question, StyleName, read_question};
use carom::diagnostic::{Source, render_all};
use carom::expr::print;
use carom::generate::{
    Census, Deal, End, MOST_SETS, Numbers, Sieve, Unfit, Variant, enumerate, examine, out_of, reference,
};

const HEAD_ON: &str = r#"
title = "A strikes B at rest"
topic = "B at rest"
stem = "Sphere *A* of mass {m kg} moves with velocity {u*i + w*j} and strikes *B* of mass {k kg}, at rest; {e}."
require = ["m != k", "A.after.n > 0", "denominator(A.after.n) = 1"]

[parameters]
m = "1..4"
u = "1..6"
w = "1..2"
e = ["0", "1/2", "1"]

[let]
k = "m + 1"

[style.friendly]
[style.exact]
require = ["e < 1"]

[scene]
masses = { A = "m", B = "k" }
before = { A = ["u", "w"], B = ["0", "0"] }
line_of_centres = ["1", "0"]
sense = "A_to_B"
e = "e"

[[part]]
ask = "Find the speed of *A* after the collision."
answers = [{ name = "speed of *A*", find = "A.after.speed" }]
marks = [{ code = "M1", for = "momentum" }, { code = "A1", for = "A.after.speed" }]

[reference]
m = "7"
u = "15"
w = "1"
e = "1/4"
"#;

fn question(text: &str) -> Question {
    match read_question("head-on", &Source::new("head-on.toml", text)) {
        Ok(question) => question,
        Err(faults) => panic!("{}", render_all(&faults, false)),
    }
}

/// `m`, `u`, `w` and twice `e`, for a check by hand.
fn numbers(variant: &Variant) -> Vec<String> {
    variant.parameters.iter().map(|(_, value)| print::plain(value)).collect()
}

/// By hand: A's component after is (m - e k) u / (m + k), with k = m + 1. It is above nought and whole.
fn fit_by_hand() -> BTreeSet<Vec<String>> {
    let mut fit = BTreeSet::new();
    for m in 1..=4i64 {
        for u in 1..=6i64 {
            for w in 1..=2i64 {
                for (twice_e, e) in [(0, "0"), (1, "1/2"), (2, "1")] {
                    let (above, below) = ((2 * m - twice_e * (m + 1)) * u, 2 * (2 * m + 1));
                    if above > 0 && above % below == 0 {
                        fit.insert(vec![m.to_string(), u.to_string(), w.to_string(), e.to_owned()]);
                    }
                }
            }
        }
    }
    fit
}

#[test]
fn carom_finds_exactly_the_variants_that_the_requirements_allow() {
    let question = question(HEAD_ON);
    let style = question.style(StyleName::Friendly).unwrap();
    assert_eq!(style.size(), 4 * 6 * 2 * 3);
    let found = Mutex::new(BTreeSet::new());
    let visit = |variant: Variant| {
        assert!(found.lock().unwrap().insert(numbers(&variant)));
    };
    let census = enumerate(&question, style, &visit, &|_| {});
    let found = found.into_inner().unwrap();
    assert_eq!(found, fit_by_hand());
    assert_eq!(census.fit, found.len() as u64);
    assert_eq!(census.fit + census.unfit.values().sum::<u64>(), census.size);
    assert_eq!(census.examined, census.size);
    // A comes to rest or turns back whenever m <= e (m + 1).
    let turned_back = (1..=4).flat_map(|m| [0, 1, 2].map(|e| (m, e))).filter(|(m, e)| 2 * m <= e * (m + 1)).count();
    assert_eq!(census.unfit.get(&Unfit::Results(1)), Some(&(turned_back as u64 * 12)));
    assert!(census.funnel(&question, style).contains(&("not `A.after.n > 0`".to_owned(), turned_back as u64 * 12)));
}

#[test]
fn carom_deals_every_variant_once_and_says_when_there_are_no_more() {
    let question = question(HEAD_ON);
    let style = question.style(StyleName::Friendly).unwrap();
    let mut deal = Deal::new(&question, style, 3);
    let mut dealt = BTreeSet::new();
    for variant in deal.by_ref() {
        assert!(dealt.insert(numbers(&variant)), "dealt twice");
    }
    assert_eq!(deal.end(), Some(End::Exhausted));
    assert_eq!(deal.dealt(), dealt.len() as u64);
    assert_eq!(deal.examined(), style.size());
    assert_eq!(dealt, fit_by_hand());
}

#[test]
fn carom_deals_the_same_paper_from_the_same_seed_for_ever() {
    let question = question(HEAD_ON);
    let style = question.style(StyleName::Exact).unwrap();
    let first = |seed: u64| Deal::new(&question, style, seed).take(4).map(|variant| numbers(&variant).join(" "));
    assert_eq!(first(1).collect::<Vec<_>>(), PINNED);
    assert_ne!(first(1).collect::<Vec<_>>(), first(2).collect::<Vec<_>>());
}

const PINNED: [&str; 4] = ["4 6 2 1/2", "1 6 2 0", "1 3 2 0", "1 6 1 0"];

#[test]
fn carom_keeps_a_style_to_its_own_requirements() {
    let question = question(HEAD_ON);
    let style = question.style(StyleName::Exact).unwrap();
    let elastic = (0..style.size()).find(|index| {
        let parameters = style.parameters_at(*index);
        parameters.last().is_some_and(|(_, e)| print::plain(e) == "1")
    });
    assert_eq!(examine(&question, style, elastic.unwrap()).map(|_| ()), Err(Unfit::Givens(3)));
}

#[test]
fn carom_sets_the_reference_numbers_as_they_are() {
    let question = question(HEAD_ON);
    let variant = reference(&question).unwrap();
    assert_eq!(numbers(&variant), ["7", "15", "1", "1/4"]);
    assert_eq!(print::plain(variant.givens.shown("k").unwrap()), "8");
    // (7 - 2) 15 / 15 = 5 along the line of centres, 1 across.
    let speed = variant.solution.exact("A.after.speed".parse().unwrap()).unwrap();
    assert_eq!(print::plain(&speed), "sqrt(26)");
}

#[test]
fn carom_gives_up_on_a_style_that_nothing_fits() {
    let text = HEAD_ON.replace("u = \"1..6\"", "u = \"1..1000000000\"").replace("m != k", "u < 0");
    let question = question(&text);
    let style = question.style(StyleName::Friendly).unwrap();
    let mut deal = Deal::new(&question, style, 1);
    assert!(deal.next().is_none());
    assert_eq!(deal.end(), Some(End::GaveUp));
}

#[test]
fn carom_says_of_how_many_sets_of_numbers_it_has_examined_the_first() {
    // Turned away by what is given alone, so that half a million are soon examined.
    let text = HEAD_ON.replace("u = \"1..6\"", "u = \"1..900000\"").replace("\"m != k\"", "\"u < 0\"");
    let question = question(&text);
    let style = question.style(StyleName::Friendly).unwrap();
    let told = AtomicU64::new(0);
    let census = enumerate(&question, style, &|_| {}, &|done| {
        told.fetch_max(done, Ordering::Relaxed);
    });
    assert_eq!((census.size, census.examined), (900_000 * 24, MOST_SETS));
    assert_eq!(census.fit + census.unfit.values().sum::<u64>(), MOST_SETS);
    assert_eq!(told.into_inner(), MOST_SETS);
    assert_eq!(out_of(census.examined, census.size), "the first 500000 of 21600000");
    assert_eq!(out_of(144, 144), "144");
}

#[test]
fn carom_estimates_what_each_requirement_keeps_out_alone() {
    let text = HEAD_ON.replace("u = \"1..6\"", "u = \"1..300\"").replace("\"m != k\"", "\"m != k\", \"u > w + 100\"");
    let question = question(&text);
    let style = question.style(StyleName::Friendly).unwrap();
    let sieve = Sieve::new(&question, style);
    let count = |mut census: Census| {
        for index in 0..style.size() {
            census.examine(&sieve, &Numbers::new(&sieve, index));
        }
        census
    };
    let estimated = count(Census::asking(style.size()));
    let exact = count(Census { one_in: 1, ..Census::new(style.size()) });
    let givens = |reason: &Unfit| matches!(reason, Unfit::Givens(_));
    let untold = count(Census::new(style.size()));
    assert_eq!((estimated.one_in, style.size()), (8, 7200));
    assert!(exact.alone.keys().any(givens) && exact.alone.keys().any(|reason| !givens(reason)), "{:?}", exact.alone);
    assert_eq!((&estimated.unfit, &estimated.first), (&exact.unfit, &exact.first));
    assert_eq!((&untold.unfit, untold.alone.len()), (&exact.unfit, 0));
    for (reason, alone) in &exact.alone {
        let about = estimated.alone.get(reason).copied().unwrap_or(0);
        // what was solved already is counted
        let off = if givens(reason) { 48 + alone / 5 } else { 0 };
        assert!(about.abs_diff(*alone) <= off, "{reason:?}: about {about}, and not {alone}");
    }
    assert!(exact.alone.values().any(|alone| *alone > 400), "{:?}", exact.alone);
}

#[test]
fn carom_does_not_ask_for_the_rounding_of_a_value_near_a_tie() {
    // The component along the line of centres is u/3, that across is nought: the speed is u/3.
    let text = HEAD_ON
        .replace("\"denominator(A.after.n) = 1\"", "\"m = 1\", \"e = 0\"")
        .replace("w = \"1..2\"", "w = [\"0\"]")
        .replace("u = \"1..6\"", "u = [\"3.735\", \"3.7355\", \"3.74\", \"3.7\"]");
    let question = question(&text);
    let style = question.style(StyleName::Friendly).unwrap();
    let fit = Mutex::new(BTreeSet::new());
    let visit = |variant: Variant| {
        fit.lock().unwrap().insert(numbers(&variant).swap_remove(1));
    };
    let census = enumerate(&question, style, &visit, &|_| {});
    assert_eq!(census.unfit.get(&Unfit::Tie(0)), Some(&2));
    // 3.7 thirds are 1.2333…, 3.74 are 1.24666…; 3.735 are 1.245, 3.7355 are 1.24517.
    assert_eq!(fit.into_inner().unwrap(), BTreeSet::from(["3.7".to_owned(), "3.74".to_owned()]));
}
