//! One table of scenes that run backwards, `tests/data/backwards.toml`: every root found, the others named, and each put
//! back into the condition.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use carom::expr::{Angles, Expr, Meaning, Relation, Turn, holds, print, read as read_expr};
use carom::mechanics::{Axis, Because, Datum, Moment, Quantity, Refusal, Scene, SceneText, Sphere};
use carom::number::{Letter, Range, Value};
use carom::solve::{Solution, solve_all};
use serde::Deserialize;
use serde_json::json;

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

/// Is a letter that was found still there, in what follows for the velocities along i and j?
fn is_left_standing(solution: &Solution) -> bool {
    let has_found =
        |value: &Value| value.letters().iter().any(|own| solution.found().iter().any(|(letter, _)| letter == own));
    solution.known().0.iter().any(|(_, datum)| match datum {
        Datum::Number(value) => has_found(value),
        Datum::Direction { y, x } => has_found(y) || has_found(x),
        Datum::Equation(coefficients) => coefficients.iter().any(has_found),
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
    let after = |axis| Quantity::Velocity(Sphere::A, Moment::After, axis);
    let asked: Vec<Quantity> = spoken_of(case).into_iter().chain([Axis::X, Axis::Y].map(after)).collect();
    let outcome = solve_all(scene(case), &asked);
    if started.elapsed() > LONGEST {
        return Some(format!("takes {:?}", started.elapsed()));
    }
    let solutions = match (outcome, &case.refused) {
        (Err(refusal), Some(expected)) if kind(&refusal) == expected => {
            let named = |root: &&String| !refusal.reason.contains(&format!("{root} is left out"));
            return case
                .left_out
                .iter()
                .find(named)
                .map(|root| format!("{root} is not left out in `{}`", refusal.reason));
        }
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
    if let Some(solution) = solutions.iter().find(|solution| is_left_standing(solution)) {
        return Some(format!("{:?} is found and not put in", solution.found()));
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

/// A name of a file, such as `A.after.ke`, where there should be words.
fn name_in(text: &str) -> Option<String> {
    let is_name = |word: &&str| {
        let parts: Vec<&str> = word.trim_end_matches(['.', ',', ':']).split('.').collect();
        parts.len() > 1 && parts.iter().all(|part| part.starts_with(|c: char| c.is_ascii_alphabetic()))
    };
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '.').find(is_name).map(str::to_owned)
}

/// Everything that a worked solution says, finding of the unknowns and all.
fn said(solution: &Solution) -> String {
    let mut text = String::new();
    for line in solution.finding().iter().chain(&solution.lines()) {
        text.push_str(&print::text_unicode(&line.words));
        for equation in &line.equations {
            text.push_str(&format!("\n{}", print::unicode(equation)));
        }
        text.push('\n');
    }
    text
}

#[test]
fn carom_speaks_of_every_quantity_in_words() {
    assert_eq!(name_in("the speed of A. Then 2.5 m/s: A.deflection dot"), Some("A.deflection".to_owned()));
    assert_eq!(name_in("the speed of A. Then 2.5 m/s"), None);
    let table: Table = toml::from_str(include_str!("../data/backwards.toml")).unwrap();
    let mut tried = 0;
    for case in &table.scene {
        for solution in solve_all(scene(case), &spoken_of(case)).unwrap_or_default() {
            let text = said(&solution);
            assert_eq!(name_in(&text), None, "{}:\n{text}", case.name);
            tried += 1;
        }
    }
    let bank = carom::bank::Bank::shipped().unwrap();
    for question in &bank.questions {
        for style in &question.styles {
            for variant in carom::generate::Deal::new(question, style, 3).take(3) {
                let text = said(&variant.solution);
                assert_eq!(name_in(&text), None, "{}:\n{text}", question.id);
                tried += 1;
            }
        }
    }
    assert!(tried > 200, "{tried}");
    // Every quantity that a condition can name, in each setting that has it.
    let direct = json!({
        "masses": { "A": "2", "B": "3" }, "before": { "A": "5", "B": "1" }, "e": "e", "symbols": { "e": "unit" }
    });
    let oblique = json!({
        "masses": { "A": "2", "B": "3" }, "before": { "A": ["5", "1"], "B": ["0", "2"] }, "line_of_centres": ["1", "0"],
        "sense": "A_to_B", "e": "e", "symbols": { "e": "unit" }
    });
    let wall = json!({
        "masses": { "A": "2" }, "before": { "A": ["5", "-3"] }, "wall": ["1", "0"], "e": "e", "symbols": { "e": "unit" }
    });
    let mut named = 0;
    for quantity in Quantity::all() {
        for scene in [&direct, &oblique, &wall] {
            for condition in
                [format!("{quantity} + e > 1/3"), format!("{quantity} > 1/3"), format!("{quantity} < 7/3*{quantity}")]
            {
                let mut scene = scene.clone();
                scene["unknowns"] = json!(["e"]);
                scene["conditions"] = json!([condition]);
                for solution in solve_all(read(&scene), &[]).unwrap_or_default() {
                    let text = said(&solution);
                    assert_eq!(name_in(&text), None, "{condition}:\n{text}");
                    assert!(!text.contains('_') || text.contains("_A") || text.contains("_B"), "{condition}:\n{text}");
                    named += 1;
                }
            }
        }
    }
    assert!(named > 40, "{named}");
}

#[test]
fn carom_says_what_the_symbols_of_a_condition_mean() {
    let scene = json!({
        "masses": { "A": "1", "B": "1" }, "before": { "A": ["4", "2"], "B": ["0", "0"] }, "line_of_centres": ["1", "0"],
        "sense": "A_to_B", "unknowns": ["e"], "conditions": ["B.after.ke = A.before.ke/2"]
    });
    let text = said(&solve_all(read(&scene), &[]).unwrap()[0]);
    let expected =
        "the kinetic energy of B after the impact is p/2, where p is the kinetic energy of A before the impact.";
    assert!(text.contains(expected), "{text}");
}
