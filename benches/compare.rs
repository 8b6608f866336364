//! How long it takes to read and judge one answer, by kind: the answers and notations of `tests/data/`.

use std::hint::black_box;
use std::time::Instant;

use carom::answer::Kind;
use carom::mark::judging::{Model, ModelOptions, judge};
use carom::mark::reading::{Vocabulary, read_answer};
use carom::number::{Letter, Range};
use divan::Bencher;
use serde_json::Value as Json;

fn main() {
    divan::main();
    worst_and_median();
}

/// A model of every kind, and the quantity of the corpus whose answers are judged by it.
const KINDS: [(&str, Kind, &str, &[&str]); 9] = [
    ("number", Kind::Number, "4*sqrt(39)/9", &["speed_A", "speed_B", "ke_lost", "impulse", "fraction_lost", "e"]),
    ("formula", Kind::Expression, "u*(1-e)*cos(theta)/2", &["tan_theta", "show_that"]),
    ("angle", Kind::Angle, "atan(3*sqrt(3)/5)", &["angle_A", "deflection"]),
    ("vector", Kind::Vector, "5/2*i + j/2", &["velocity_B", "velocity_A"]),
    ("velocity", Kind::Velocity, "[0, 6*sin(10*deg)]", &["velocity_A", "velocity_B"]),
    ("ratio", Kind::Ratio, "2/3", &["fraction_lost"]),
    ("line", Kind::Line, "i - 3*j", &["line_of_centres"]),
    ("equation", Kind::Equation, "2*v + 3*w = 4*u", &["show_that"]),
    ("shown", Kind::Shown, "tan(beta) = 2*tan(alpha)/(1-e)", &["show_that"]),
];

fn kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|(name, ..)| *name)
}

/// The model of a kind, and the answers of the corpus to such questions.
fn question(kind: &str) -> (Model, Vec<String>) {
    let (_, kind, text, quantities) = KINDS.into_iter().find(|(name, ..)| *name == kind).expect("a kind");
    let letters = [("u", Range::Positive), ("m", Range::Positive), ("e", Range::Unit), ("theta", Range::Acute)];
    let letters = letters.map(|(name, range)| Letter::new(name, range).expect("a short name")).into();
    let model = Model::read(text, &ModelOptions { kind: Some(kind), letters, ..ModelOptions::default() });
    let rows = include_str!("../tests/data/answers.jsonl")
        .lines()
        .map(|line| -> Json { serde_json::from_str(line).expect("a row") });
    let own = rows.filter(|row| quantities.iter().any(|quantity| row["quantity"] == *quantity));
    let answers = own.map(|row| row["answer"].as_str().expect("a text").to_owned());
    (model.unwrap_or_else(|fault| panic!("{text}: {fault:?}")), answers.collect())
}

/// Every notation of `readings.toml`.
fn notations() -> Vec<String> {
    let table: toml::Table = include_str!("../tests/data/readings.toml").parse().expect("a table");
    let rows = table["row"].as_array().expect("rows").iter();
    rows.map(|row| row["typed"].as_str().expect("a text").to_owned()).collect()
}

fn compare(model: &Model, answer: &str) {
    black_box(judge(model, &read_answer(black_box(answer), &model.vocabulary)));
}

/// All answers of the corpus to questions of a kind, read and judged.
#[divan::bench(args = kinds())]
fn answers(bencher: Bencher, kind: &str) {
    let (model, answers) = question(kind);
    let counter = divan::counter::ItemsCount::new(answers.len());
    bencher.counter(counter).bench(|| answers.iter().for_each(|answer| compare(&model, answer)));
}

/// Every notation, read alone.
#[divan::bench]
fn reading(bencher: Bencher) {
    let (notations, vocabulary) = (notations(), Vocabulary { vectors: true, ..question("formula").0.vocabulary });
    let counter = divan::counter::ItemsCount::new(notations.len());
    bencher
        .counter(counter)
        .bench(|| notations.iter().for_each(|typed| drop(black_box(read_answer(typed, &vocabulary)))));
}

/// The median and the worst answer of each kind, each the best of some repetitions.
fn worst_and_median() {
    println!("\nreading and judging one answer, in microseconds: median, worst");
    for kind in kinds() {
        for (of, answers) in [("answers", question(kind).1), ("notations", notations())] {
            let model = question(kind).0;
            let mut times: Vec<(f64, &String)> = answers.iter().map(|answer| (time(&model, answer), answer)).collect();
            times.sort_by(|one, two| one.0.total_cmp(&two.0));
            let (median, worst) = (times[times.len() / 2].0, times[times.len() - 1]);
            println!("{kind:9} {of:9} {median:7.1} {:7.1}  {}", worst.0, worst.1.escape_default());
        }
    }
}

fn time(model: &Model, answer: &str) -> f64 {
    let once = || {
        let start = Instant::now();
        compare(model, answer);
        start.elapsed().as_secs_f64() * 1e6
    };
    (0..9).map(|_| once()).fold(f64::MAX, f64::min)
}
