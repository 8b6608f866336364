//! Impacts of every kind: the seed, the bank's reference numbers, and a grid of values that meet and miss each tier's needs.

use carom::bank::Bank;
use carom::expr::{Angles, Meaning, Turn, number, read};
use carom::generate::reference;
use carom::mechanics::{Quantity, Scene, SceneText};
use carom::method::Impact;
use carom::number::{Angle, Letter, Range, Value};
use carom::solve::solve_all;
use serde_json::Value as Json;

/// The letters that occur: `m`, `u`, `v` positive, `e` from nought to one, `alpha` acute.
fn meaning(name: &str) -> Option<Meaning> {
    let letter = |range| Letter::new(name, range);
    match name {
        "m" | "u" | "v" => Some(Meaning::Number(Value::letter(letter(Range::Positive)?))),
        "e" => Some(Meaning::Number(Value::letter(letter(Range::Unit)?))),
        "alpha" => Some(Meaning::Angle(Turn::of(Angle::of(&Value::letter(letter(Range::Acute)?), &Value::ONE)?))),
        _ => None,
    }
}

pub fn value(text: &str) -> Value {
    let expr = read(text, Angles::Radians).unwrap_or_else(|fault| panic!("{text}: {}", fault.message));
    number(&expr, &meaning).unwrap_or_else(|fault| panic!("{text}: {}", fault.message))
}

pub fn impact(masses: [&str; 2], before: [[&str; 2]; 2], line: [&str; 2], e: &str) -> Impact<Value> {
    Impact {
        masses: masses.map(value),
        before: before.map(|velocity| velocity.map(value)),
        line: line.map(value),
        restitution: value(e),
    }
}

/// The impacts that the seed and the bank come to, resolved along and across the line of centres.
pub fn of_questions() -> Vec<(String, Impact<Value>)> {
    let seed: Json = serde_json::from_str(include_str!("../data/seed-cases.json")).unwrap();
    let mut impacts = Vec::new();
    for case in seed["cases"].as_array().unwrap().iter().filter(|case| case["feasible"] == true) {
        let text: SceneText = serde_json::from_value(case["scene"].clone()).unwrap();
        let scene = Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|_| panic!("{case}"));
        let solutions = solve_all(&scene, &Quantity::all()).unwrap();
        impacts.extend(solutions.iter().filter_map(|solution| solution.impact()).map(|i| (case["id"].to_string(), i)));
    }
    let seeds = impacts.len();
    let bank = Bank::shipped().unwrap_or_else(|_| panic!("the shipped bank reads"));
    for question in &bank.questions {
        let variant = reference(question).unwrap_or_else(|_| panic!("{}", question.id));
        impacts.extend(variant.solution.impact().map(|impact| (question.id.clone(), impact)));
    }
    assert!(seeds >= 12 && impacts.len() - seeds >= bank.questions.len() / 2, "{seeds} of {}", impacts.len());
    impacts
}

const MASSES: [[&str; 2]; 6] =
    [["2", "3"], ["0.25", "0.75"], ["m", "2*m"], ["sqrt(2)", "3*sqrt(2)"], ["1", "sqrt(3)"], ["m", "1"]];
const RESTITUTIONS: [&str; 6] = ["0", "1/3", "1", "sqrt(2)/3", "sqrt(5)/3", "e"];
const LINES: [[&str; 2]; 6] =
    [["1", "0"], ["0", "-2"], ["3", "-4"], ["1/sqrt(5)", "2/sqrt(5)"], ["1", "sqrt(3)"], ["0.6", "0.8"]];
const VELOCITIES: [[[&str; 2]; 2]; 12] = [
    [["4", "0"], ["0", "0"]],
    [["0", "7/2"], ["0", "-1/3"]],
    [["5/3", "2"], ["-1", "1/4"]],
    [["2*sqrt(3)", "2"], ["0", "0"]],
    [["3*sqrt(2)/2", "1+sqrt(6)"], ["-1", "sqrt(3)"]],
    [["6*cos(10*deg)", "6*sin(10*deg)"], ["0", "0"]],
    [["u*cos(alpha)", "u*sin(alpha)"], ["-u", "0"]],
    [["cos(10*deg)", "sin(10*deg)"], ["-cos(25*deg)", "sin(25*deg)"]],
    [["1+sqrt(2)+sqrt(5)", "v"], ["sqrt(3)", "u"]],
    [["sqrt(5)", "2*sqrt(5)"], ["0", "0"]],
    [["sqrt(1+sqrt(2))", "1"], ["0", "2"]],
    [["1/(1+v)", "0"], ["-2", "0"]],
];

/// Larger than machine integers hold once multiplied.
const HUGE: &str = "123456789012345678";

/// Every combination of masses, e, line and velocities, and some that outgrow machine integers.
pub fn grid() -> Vec<Impact<Value>> {
    let mut impacts = Vec::new();
    for masses in MASSES {
        for e in RESTITUTIONS {
            for line in LINES {
                impacts.extend(VELOCITIES.map(|before| impact(masses, before, line, e)));
            }
        }
    }
    for before in VELOCITIES {
        impacts.push(impact([HUGE, "123456789012345679"], before, ["1", "0"], "1/3"));
        impacts.push(impact([HUGE, "123456789012345679*sqrt(2)"], before, ["1", "0"], "sqrt(2)/3"));
        impacts.push(impact(["1", "2"], before, ["1000000007", "998244353"], "1/3"));
    }
    impacts
}
