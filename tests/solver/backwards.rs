//! One table of scenes that run backwards, `tests/data/backwards.toml`: every root found, the others named, and each put
//! back into the condition.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use carom::expr::{Angles, Expr, Meaning, Relation, Turn, holds, read as read_expr};
use carom::mechanics::{Because, Quantity, Refusal, Scene, SceneText};
use carom::number::{Letter, Range, Value};
use carom::solve::{Solution, solve_all};
use serde::Deserialize;

use super::impacts::{turn, value};
use super::scenes::read;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    scene: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    name: String,
    scene: SceneText,
    /// Every solution: each unknown with its value, an angle in degrees.
    #[serde(default)]
    found: Vec<BTreeMap<String, String>>,
    /// The kind of a refusal.
    refused: Option<String>,
    /// Roots that a remark must name.
    #[serde(default)]
    left_out: Vec<String>,
}

/// Far more than any of them takes, but less than for ever.
const LONGEST: Duration = Duration::from_secs(20);

fn scene(case: &Case) -> Scene {
    read(&serde_json::to_value(&case.scene).unwrap())
}

fn conditions(case: &Case) -> Vec<(Expr, Expr)> {
    let sides = |text: &String| match read_expr(text, Angles::Radians) {
        Ok(Expr::Relation(left, Relation::Equal, right)) => (*left, *right),
        other => panic!("{text}: {other:?}"),
    };
    case.scene.conditions.iter().map(sides).collect()
}

/// The quantities that conditions speak of.
fn spoken_of(case: &Case) -> Vec<Quantity> {
    let sides = conditions(case).into_iter().flat_map(|(left, right)| [left, right]);
    sides.flat_map(|side| side.names().iter().filter_map(|name| name.text.parse().ok()).collect::<Vec<_>>()).collect()
}

fn is(case: &Case, letter: Letter, found: &Value, expected: &str) -> bool {
    match letter.range() {
        Range::Acute => turn(expected, &case.scene.symbols).tangent().is_some_and(|tangent| tangent.equals(found)),
        _ => value(expected, &case.scene.symbols).equals(found),
    }
}

fn is_expected(case: &Case, solution: &Solution, expected: &BTreeMap<String, String>) -> bool {
    solution.found().iter().all(|(letter, found)| is(case, *letter, found, &expected[letter.name()]))
}

/// Does what is derived forwards from the found scene, whose unknowns are gone, satisfy every condition?
fn satisfied(case: &Case, solution: &Solution) -> bool {
    let meaning = |name: &str| {
        let unknown = solution.found().iter().find(|(letter, _)| letter.name() == name);
        if let Some((letter, found)) = unknown {
            let angle = || carom::number::Angle::of(found, &Value::ONE).map(|angle| Meaning::Degrees(Turn::of(angle)));
            return if letter.range() == Range::Acute { angle() } else { Some(Meaning::Number(found.clone())) };
        }
        if let Some(letter) = solution.scene().letters.iter().find(|letter| letter.name() == name) {
            return Some(Meaning::Number(Value::letter(*letter)));
        }
        let quantity: Quantity = name.parse().ok()?;
        let angle = || solution.angle(quantity).map(|angle| Meaning::Degrees(Turn::of(angle)));
        solution.number(quantity).map(Meaning::Number).or_else(angle)
    };
    conditions(case).into_iter().all(|(left, right)| {
        let relation = Expr::equation(left, right);
        // Where letters remain, equality may be undecided, but it must not be denied.
        matches!(holds(&relation, &meaning), Ok(Some(true) | None))
    })
}

fn kind(refusal: &Refusal) -> &'static str {
    match refusal.because {
        Because::Impossible => "impossible",
        Because::Underdetermined => "underdetermined",
        Because::BeyondMethods => "beyond",
    }
}

fn complaint(case: &Case) -> Option<String> {
    let started = Instant::now();
    let outcome = solve_all(&scene(case), &spoken_of(case));
    if started.elapsed() > LONGEST {
        return Some(format!("takes {:?}", started.elapsed()));
    }
    let solutions = match (outcome, &case.refused) {
        (Err(refusal), Some(expected)) if kind(&refusal) == expected => return None,
        (Err(refusal), _) => return Some(format!("refused as {}: {refusal}", kind(&refusal))),
        (Ok(_), Some(expected)) => return Some(format!("is solved, though it is {expected}")),
        (Ok(solutions), None) => solutions,
    };
    if solutions.len() != case.found.len() {
        return Some(format!("{} solutions in place of {}", solutions.len(), case.found.len()));
    }
    for expected in &case.found {
        if !solutions.iter().any(|solution| is_expected(case, solution, expected)) {
            return Some(format!("{expected:?} is not found"));
        }
    }
    if let Some(solution) = solutions.iter().find(|solution| !satisfied(case, solution)) {
        return Some(format!("{:?} does not satisfy the condition", solution.found()));
    }
    let remarks: Vec<&String> = solutions.iter().flat_map(Solution::remarks).collect();
    let named = |root: &&String| !remarks.iter().any(|remark| remark.starts_with(&format!("{root} is left out")));
    case.left_out.iter().find(named).map(|root| format!("{root} is not named as left out, only {remarks:?}"))
}

#[test]
fn carom_knows_questions_that_run_backwards() {
    let table: Table = toml::from_str(include_str!("../data/backwards.toml")).unwrap();
    let complaints: Vec<String> =
        table.scene.iter().filter_map(|case| Some(format!("{}: {}", case.name, complaint(case)?))).collect();
    assert!(table.scene.len() >= 100, "a table of {}", table.scene.len());
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}
