//! Laws of reading: what carom prints is read as it was meant, and no text crashes or stalls the reader.

use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

use super::choices::MOST_STEPS;
use super::{Form, LONGEST, MOST_READINGS, PATIENCE, Unreadable, Vocabulary, counted, read_answer};
use crate::expr::{Expr, Function, Meaning, Turn, evaluate, print};
use crate::number::{Angle, Fraction, Letter, Range, Value};

fn vocabulary() -> Vocabulary {
    let letters = [("u", Range::Positive), ("v_A", Range::Positive), ("m", Range::Positive), ("e", Range::Unit)];
    let angles = [("alpha", Range::Acute), ("theta", Range::Acute)];
    let letters = letters.into_iter().chain(angles).map(|(name, range)| Letter::new(name, range).unwrap());
    Vocabulary { letters: letters.collect(), vectors: true }
}

fn meaning(expr: &Expr) -> Option<Meaning> {
    let letters = vocabulary().letters;
    let named = |name: &str| {
        let letter = letters.iter().find(|letter| letter.name() == name)?;
        Some(match letter.range() {
            Range::Acute => Meaning::Angle(Turn::of(Angle::of(&Value::letter(*letter), &Value::ONE)?)),
            _ => Meaning::Number(Value::letter(*letter)),
        })
    };
    evaluate(expr, &named).ok()
}

/// A formula such as answers are made of.
fn formula(chance: &mut ChaCha8Rng, depth: usize) -> Expr {
    let below = depth.saturating_sub(1);
    match chance.random_range(0..if depth == 0 { 4 } else { 13 }) {
        0 => Expr::integer(chance.random_range(1..10)),
        1 => Expr::Decimal(["0.5", "2.78", "0.07"][chance.random_range(0..3)].to_owned()),
        2 | 3 => Expr::name(["u", "v_A", "m", "e"][chance.random_range(0..4)]),
        4 => Expr::Number(Fraction::new(chance.random_range(1..9), chance.random_range(1..7))),
        5 | 6 => Expr::Sum((0..chance.random_range(2..4)).map(|_| formula(chance, below)).collect()),
        7 | 8 => Expr::Product((0..chance.random_range(2..4)).map(|_| formula(chance, below)).collect()),
        9 => Expr::Quotient(Box::new(formula(chance, below)), Box::new(formula(chance, below))),
        10 => Expr::Negative(Box::new(formula(chance, below))),
        11 => formula(chance, below).to_the(chance.random_range(2..4)),
        _ => function(chance, below),
    }
}

fn function(chance: &mut ChaCha8Rng, depth: usize) -> Expr {
    let angle = match chance.random_range(0..4) {
        0 => Expr::degrees(Expr::integer(30)),
        1 => Expr::Product(vec![Expr::integer(2), Expr::name("theta")]),
        2 => Expr::name("theta"),
        _ => Expr::name("alpha"),
    };
    match chance.random_range(0..6) {
        0 => Expr::call(Function::Sin, angle),
        1 => Expr::call(Function::Cos, angle),
        2 => Expr::call(Function::Tan, angle).to_the(2),
        3 => Expr::call(Function::Abs, formula(chance, depth)),
        _ => Expr::call(Function::Sqrt, formula(chance, depth)),
    }
}

#[test]
fn carom_reads_what_it_prints_as_what_it_meant() {
    let mut chance = ChaCha8Rng::seed_from_u64(41);
    let question = vocabulary();
    let mut compared = 0;
    for _ in 0..2_500 {
        let meant = formula(&mut chance, 3);
        let Some(Meaning::Number(value)) = meaning(&meant) else { continue };
        for printed in [print::plain(&meant), print::unicode(&meant), print::latex(&meant)] {
            let readings = read_answer(&printed, &question).unwrap_or_else(|reason| panic!("{printed}: {reason:?}"));
            let Form::Value(read) = &readings[0].statements[0].said[0].form else { panic!("{printed}: {readings:?}") };
            let Some(Meaning::Number(again)) = meaning(read) else { panic!("{printed}: {read:?}") };
            assert!(value.equals(&again), "{printed} was read as {}", readings[0].printed);
            compared += 1;
        }
    }
    assert!(compared > 4_000, "{compared}");
}

#[test]
fn carom_reads_the_vectors_that_it_prints() {
    let mut chance = ChaCha8Rng::seed_from_u64(43);
    let question = vocabulary();
    let mut compared = 0;
    for _ in 0..600 {
        let [x, y] = [formula(&mut chance, 2), formula(&mut chance, 2)];
        let (Some(Meaning::Number(a)), Some(Meaning::Number(b))) = (meaning(&x), meaning(&y)) else { continue };
        let meant = Expr::Vector(Box::new(x), Box::new(y));
        for printed in [print::plain(&meant), print::unicode(&meant), print::latex(&meant)] {
            let readings = read_answer(&printed, &question).unwrap_or_else(|reason| panic!("{printed}: {reason:?}"));
            let (x, y) = match &readings[0].statements[0].said[0].form {
                Form::Vector(x, y, _) => (x.clone(), y.clone()),
                // The zero vector is printed as a nought.
                Form::Value(value) if a.is_zero() && b.is_zero() => (value.clone(), value.clone()),
                other => panic!("{printed}: {other:?}"),
            };
            let (Some(Meaning::Number(x)), Some(Meaning::Number(y))) = (meaning(&x), meaning(&y)) else {
                panic!("{printed}: {readings:?}")
            };
            assert!(a.equals(&x) && b.equals(&y), "{printed} was read as {}", readings[0].printed);
            compared += 1;
        }
    }
    assert!(compared > 900, "{compared}");
}

/// Whatever the text: an answer, within bounds.
fn within_bounds(text: &str) {
    for question in [vocabulary(), Vocabulary::default()] {
        let (readings, steps) = counted(text, &question, false);
        assert!(steps <= PATIENCE + 2 * MOST_STEPS, "{steps} steps: {text}");
        match readings {
            Ok(readings) => {
                assert!(!readings.is_empty() && readings.len() <= MOST_READINGS, "{text}");
                assert!(readings.iter().all(|reading| !reading.statements.is_empty()), "{text}");
            }
            Err(Unreadable::Sign(place, reason)) => {
                assert!(place <= text.len() && text.is_char_boundary(place) && !reason.is_empty(), "{text}: {place}");
            }
            Err(Unreadable::Blank | Unreadable::TooLong) => {}
        }
    }
}

#[test]
fn carom_is_neither_crashed_nor_stalled_by_any_text() {
    let table = include_str!("../../../tests/data/readings.toml");
    let typed: Vec<&str> =
        table.lines().filter_map(|line| line.split("typed = \"").nth(1)?.split('"').next()).collect();
    let odd = [
        "(",
        ")",
        "[",
        "⟦",
        "⟧",
        "{",
        "}",
        "\\",
        "^",
        "_",
        "√",
        "²",
        "⁻¹",
        "½",
        "\u{307}",
        "\u{200b}",
        "\u{202e}",
        "e",
        "i",
        "…",
        "..",
        ",",
        "/",
        "°",
        "|",
        "\n",
        "\0",
        "🎱",
        "é",
        "９",
        "\\frac",
        "\\begin{pmatrix}",
        "arctan",
        "sin",
        "to the ",
        "0.(",
        "%",
        "'",
        "ms",
        "-1",
        "=",
        ":",
        "10^",
        "9",
        "·",
        "1 000",
        "mu",
    ];
    let mut chance = ChaCha8Rng::seed_from_u64(47);
    for round in 0..3_000 {
        let mut text: Vec<char> = typed[chance.random_range(0..typed.len())].chars().collect();
        for _ in 0..chance.random_range(0..5) {
            let at = chance.random_range(0..=text.len());
            match chance.random_range(0..4) {
                0 if at < text.len() => drop(text.remove(at)),
                1 => {
                    let other: Vec<char> = typed[chance.random_range(0..typed.len())].chars().collect();
                    let from = chance.random_range(0..=other.len());
                    text.splice(at..at, other[from..].iter().copied());
                }
                _ => drop(text.splice(at..at, odd[chance.random_range(0..odd.len())].chars())),
            }
        }
        if round % 50 == 0 {
            text = text.iter().copied().cycle().take(600).collect();
        }
        within_bounds(&text.into_iter().collect::<String>());
    }
    for piece in odd.into_iter().chain([
        "(1,",
        "((a/b",
        "1/2v",
        "u/2",
        "√(",
        "|",
        "mumu",
        "\\frac{",
        "\\sqrt",
        "arctan 3/",
        "3 ",
        "a=",
        "-",
        "e^",
        "1.2e3+",
        "2·3+",
        "in the direction of ",
        "perpendicular to ",
        "mmmm ",
        "gradient 1 ",
    ]) {
        within_bounds(&piece.repeat(LONGEST / piece.len()));
        within_bounds(&format!("{}1", piece.repeat((LONGEST - 1) / piece.len())));
    }
}

#[test]
fn carom_reads_no_answer_that_is_too_long() {
    assert_eq!(read_answer(&"1".repeat(LONGEST + 1), &vocabulary()), Err(Unreadable::TooLong));
    assert_eq!(read_answer(" \u{200b}\t", &vocabulary()), Err(Unreadable::Blank));
}
