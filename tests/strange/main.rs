//! Strange answers: what students have typed with something struck out, put in, exchanged or put together, the same ones every
//! time. `fuzz/run` looks for others by the branches that they take.

mod laws;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;

use carom::answer::Kind;
use rand::rngs::ChaCha8Rng;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};

/// So many answers are made, half of them on each of two threads.
const ANSWERS: u64 = 100_000;

/// Signs and commands that are put in.
const PIECES: [&str; 40] = [
    " ",
    "\n",
    ";",
    ",",
    ":",
    "=",
    "≈",
    "<",
    "≤",
    "+",
    "-",
    "−",
    "*",
    "×",
    "/",
    "÷",
    "^",
    "²",
    "(",
    ")",
    "[",
    "|",
    "√",
    "°",
    "%",
    "½",
    "0",
    "2.5",
    "1/3",
    "e",
    "u",
    "θ",
    "sin",
    "tan⁻¹",
    "\\frac{",
    "}{",
    "m/s",
    " or ",
    " so ",
    " to the line of centres",
];

/// Every answer that has been typed before.
fn typed() -> Vec<String> {
    let readings: toml::Table = include_str!("../data/readings.toml").parse().unwrap();
    let rows = readings["row"].as_array().unwrap().iter().map(|row| row["typed"].as_str().unwrap().to_owned());
    let answers = include_str!("../data/answers.jsonl").lines().map(|line| {
        let answer: serde_json::Value = serde_json::from_str(line).unwrap();
        answer["answer"].as_str().unwrap().to_owned()
    });
    rows.chain(answers).collect()
}

/// An answer with up to four changes.
fn strange(typed: &[String], chance: &mut ChaCha8Rng) -> String {
    let mut signs: Vec<char> = typed.choose(chance).unwrap().chars().collect();
    for _ in 0..chance.random_range(1..=4) {
        let at = chance.random_range(0..=signs.len());
        let end = (at + chance.random_range(1..=3)).min(signs.len());
        match chance.random_range(0..5) {
            0 => drop(signs.drain(at..end)),
            1 => drop(signs.splice(at..at, PIECES.choose(chance).unwrap().chars())),
            2 => {
                let again = signs[at..end].to_vec();
                drop(signs.splice(end..end, again));
            }
            3 => signs[at..end].reverse(),
            _ => {
                let other: Vec<char> = typed.choose(chance).unwrap().chars().collect();
                let from = chance.random_range(0..=other.len());
                drop(signs.splice(at..end, other[from..].iter().copied()));
            }
        }
    }
    signs.into_iter().collect()
}

#[test]
fn carom_keeps_its_laws_for_strange_answers() {
    let typed = typed();
    assert!(typed.len() > 1000, "{} answers", typed.len());
    let broken = |seeds: std::ops::Range<u64>| {
        let one = |seed| {
            let mut chance = ChaCha8Rng::seed_from_u64(seed);
            let (model, text) = (chance.random_range(0..=255), strange(&typed, &mut chance));
            catch_unwind(|| laws::hold(model, &text)).is_err().then(|| format!("model {model}: {text:?}"))
        };
        seeds.filter_map(one).collect::<Vec<String>>()
    };
    let found = thread::scope(|scope| {
        let other = scope.spawn(|| broken(0..ANSWERS / 2));
        [broken(ANSWERS / 2..ANSWERS), other.join().unwrap()].concat()
    });
    assert!(found.is_empty(), "{} answers break a law:\n{}", found.len(), found.join("\n"));
}

#[test]
fn a_broken_law_is_seen() {
    let is_kept = |other: &str, text: &str| {
        let pair = laws::pair("12", other, Some(Kind::Number));
        catch_unwind(AssertUnwindSafe(|| laws::hold_for(&pair, text))).is_ok()
    };
    assert!(is_kept("13", "12") && is_kept("12", "13"));
    assert!(!is_kept("12", "12"), "right for two models");
}
