//! Tests of answers that are judged by what is known of the question: which way a sphere goes, who takes part in an impact,
//! which letter is to be found.

use super::*;
use crate::mark::reading::read_answer;
use crate::number::{Letter, Range};

/// The verdicts on what is typed, of a model of which more is known.
fn earn(model: &Model, rows: &[(&str, &str)]) {
    let found = |typed: &str| judge(model, &read_answer(typed, &model.vocabulary)).verdict.name();
    let faults: Vec<String> = rows
        .iter()
        .filter(|(typed, expected)| found(typed) != *expected)
        .map(|(typed, expected)| format!("{typed}: {}, expected {expected}", found(typed)))
        .collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

fn model(right: &str, quantity: &str, letters: &[(&str, Range)]) -> Model {
    let letters = letters.iter().map(|(name, range)| Letter::new(name, *range).unwrap()).collect();
    let quantity = (!quantity.is_empty()).then(|| quantity.parse().unwrap());
    Model::read(right, &ModelOptions { kind: None, accept: None, letters, quantity }).unwrap()
}

#[test]
fn a_sphere_that_is_said_to_go_another_way_is_for_a_person() {
    let speed = Model { turns_back: Some(true), rebounds: Some(true), ..model("10", "A.after.speed", &[]) };
    earn(
        &speed,
        &[
            ("10 m/s", "correct"),
            ("A rebounds at 10 m/s", "correct"),
            ("10 m/s in the opposite direction", "correct"),
            ("10 m/s away from the wall", "correct"),
            ("10 m/s in the same direction", "unreadable"),
            ("A continues at 10 m/s", "unreadable"),
            ("10 m/s towards the wall", "unreadable"),
            ("9 m/s towards the wall", "wrong"),
        ],
    );
    let goes_on = Model { turns_back: Some(false), ..speed };
    earn(
        &goes_on,
        &[
            ("A continues at 10 m/s", "correct"),
            ("A rebounds at 10 m/s", "unreadable"),
            ("A changes direction, 10 m/s", "unreadable"),
        ],
    );
    let range = Model { turns_back: Some(true), ..model("1/3 < e <= 1", "", &[("e", Range::Unit)]) };
    let range = Model { letter: Some("e".to_owned()), ..range };
    earn(
        &range,
        &[
            ("A rebounds if e > 1/3", "correct"),
            ("A continues if e > 1/3", "unreadable"),
            ("v < 0, so e > 1/3", "correct"),
            ("v = 4(1 - 3e) < 0, so e > 1/3", "correct"),
            ("angle > 90 so e > 1/3", "correct"),
            ("turned through more than 90° if e > 1/3", "correct"),
            ("turned through less than 90° if e > 1/3", "wrong"),
            ("v < 0", "wrong"),
            ("3e > 2, so e > 1/3", "wrong"),
        ],
    );
}

#[test]
fn an_impulse_is_not_on_a_sphere_that_takes_no_part() {
    let on_the_wall = Model { strangers: vec![Sphere::A, Sphere::C], ..model("42", "second.impulse.magnitude", &[]) };
    earn(
        &on_the_wall,
        &[
            ("impulse on B = 42", "correct"),
            ("42 Ns on B", "correct"),
            ("impulse on A = 42", "unreadable"),
            ("42 on A", "unreadable"),
            ("I_A = 42", "unreadable"),
        ],
    );
}

#[test]
fn a_letter_that_is_asked_has_its_own_name_and_unit() {
    let of_k = Model { letter: Some("k".to_owned()), ..model("8", "", &[("k", Range::Positive)]) };
    earn(
        &of_k,
        &[
            ("k = 8", "correct"),
            ("k = 8, m = 2", "correct"),
            ("x = 8", "correct"),
            ("m = 8", "unreadable"),
            ("speed = 8", "unreadable"),
            ("e = 8", "unreadable"),
            ("A = 8", "unreadable"),
        ],
    );
    let of_m = Model { letter: Some("m".to_owned()), ..model("2", "", &[("m", Range::Positive)]) };
    earn(&of_m, &[("2 kg", "correct"), ("m = 2", "correct"), ("2 N", "partial"), ("2 m/s", "partial")]);
    let alpha = Model { letter: Some("alpha".to_owned()), ..model("37.1*deg", "", &[("alpha", Range::Acute)]) };
    earn(
        &alpha,
        &[
            ("α = 37.1°, greatest deflection = 15.8°", "correct"),
            ("α = 37.1° and δ = 15.8°", "correct"),
            ("37.1° (deflection 15.8°)", "correct"),
            ("α = 15.8°, greatest deflection = 37.1°", "wrong"),
        ],
    );
}
