//! Each slip of each law leads to the wrong value that students with that slip hand in.
//!
//! `tests/data/slip-values.json` holds those values, found with formulas of their own. Its names are in capitals; `SLIPS`
//! says which slip of Carom each of them is, and `OTHERWISE` where it means another working, and why.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use carom::expr::Angles;
use carom::mark::reading::{Vocabulary, read_answer};
use carom::mark::slips::{self, Asked, Mistakes};
use carom::mechanics::{
    Axis, Carried, Datum, Known, MadeSlip, Moment, Quantity, Road, Scene, SceneText, Setting, Slip, Sphere, pose,
};
use carom::number::{Angle, Interval, Letter, Number, Range, Value};
use serde_json::Value as Json;

/// The name in the data and the tag.
const SLIPS: [(&str, &str); 39] = [
    ("SINCOS_SWAP", "sincos-swap"),
    ("NOT_RESOLVED", "not-resolved"),
    ("NEL_FULL_SPEEDS", "restitution-not-resolved"),
    ("E_WRONG_SIDE", "e-wrong-side"),
    ("NEL_APPROACH_SUBTRACTED", "approach-subtracted"),
    ("NEL_SEPARATION_ADDED", "separation-added"),
    ("NEL_REVERSED", "restitution-reversed"),
    ("CLM_SIGN", "momentum-sign"),
    ("NEL_IGNORES_B", "restitution-ignores-b"),
    ("CLM_IGNORES_B", "momentum-ignores-b"),
    ("E_ON_PERP_TOO", "e-on-perpendicular"),
    ("PERP_DROPPED", "perpendicular-dropped"),
    ("SPEED_N_ONLY", "perpendicular-dropped"),
    ("PERP_SHARED", "perpendicular-shared"),
    ("MASSES_SWAPPED", "masses-swapped"),
    ("MASSES_OMITTED", "masses-omitted"),
    ("E_TAKEN_AS_1", "e-taken-as-1"),
    ("COALESCE", "coalesce"),
    ("WRONG_AXIS", "wrong-axis"),
    ("SPEED_SUM_OF_COMPONENTS", "speed-sum"),
    ("SPEED_NO_SQRT", "speed-no-root"),
    ("ANGLE_COMPLEMENT", "angle-complement"),
    ("DEFLECTION_IS_BETA", "direction-for-deflection"),
    ("DEFLECTION_ADDED", "deflection-added"),
    ("DEFLECTION_DIFF", "rebound-missed"),
    ("KE_SQUARE_OF_DIFFERENCE", "energy-square-of-difference"),
    ("KE_A_ONLY", "energy-one-sphere"),
    ("KE_NO_HALF", "energy-no-half"),
    ("KE_AFTER_N_ONLY", "energy-after-along-only"),
    ("KE_COMPONENTS_ADDED", "energy-components-added"),
    ("KE_1_MINUS_E2_OF_TOTAL", "energy-by-e"),
    ("FRACTION_REMAINING", "fraction-remaining"),
    ("FRACTION_OF_N_KE", "fraction-of-energy-along"),
    ("IMPULSE_SPEED_CHANGE_N", "impulse-speed-change"),
    ("IMPULSE_RESULTANT_SPEEDS", "impulse-resultant-speeds"),
    ("IMPULSE_WRONG_MASS", "impulse-wrong-mass"),
    ("IMPULSE_MOMENTUM_AFTER_ONLY", "impulse-after-only"),
    ("IMPULSE_MOMENTA_ADDED", "impulse-both-added"),
    ("PREMATURE_ROUND_2SF", "early-rounding"),
];

/// Where the data means another working than the slip: exercise, quantity, name, reason.
const OTHERWISE: [(&str, &str, &str, &str); 2] = [
    (
        "Q7",
        "impulse",
        "SINCOS_SWAP",
        "there the momentum of B before has its true component; a student with the slip has none but the wrong one",
    ),
    (
        "Q7",
        "impulse",
        "WRONG_AXIS",
        "there nothing changes along the line of centres; a student takes the change that the slip has led to",
    ),
];

/// How many rows are reproduced, the right values among them.
const REPRODUCED: usize = 618;

#[test]
fn carom_knows_the_wrong_value_of_every_slip() {
    let (mut reproduced, mut faults) = (0, Vec::new());
    for row in rows() {
        let given = posed(&row.exercise);
        let found = match SLIPS.iter().find(|(name, _)| *name == row.name) {
            _ if row.name == "CORRECT" => slipped(&given, &[], row.quantity),
            Some((_, "early-rounding")) => rounded(&given, row.quantity, row.value),
            Some((_, tag)) => slipped(&given, &[tag], row.quantity),
            None => panic!("{row:?}: no slip"),
        };
        let agrees = match (found, row.value) {
            (Some(found), Some(value)) => (found - value).abs() <= 1e-9 * (1.0 + value.abs()),
            (found, value) => found == value,
        };
        let other =
            OTHERWISE.iter().any(|other| (other.0, other.1, other.2) == (&*row.exercise, &*row.asked, &*row.name));
        match (agrees, other) {
            (true, false) => reproduced += 1,
            (false, true) => {}
            _ => faults.push(format!("{row:?}: {found:?}")),
        }
    }
    assert!(faults.is_empty(), "{reproduced} reproduced\n{}", faults.join("\n"));
    assert_eq!(reproduced, REPRODUCED);
}

/// A derivation carried out again, which works out only what a slip changes, comes to what the whole derivation comes to.
#[test]
fn what_is_carried_out_again_is_what_the_whole_derivation_gives() {
    let mut compared = 0;
    for row in rows().iter().filter(|row| row.name == "CORRECT") {
        let given = posed(&row.exercise);
        for road in Road::ALL {
            let mut carried = Carried::on(road, &given, &asked(row.quantity));
            let derivation = carried.derivation().clone();
            let before = carried.known().clone();
            for (law, slip) in Slip::all() {
                let mut known = given.clone();
                let whole = derivation.evaluate_slipped(&[slip.tag], &mut known).ok().map(|()| known);
                let again =
                    carried.again(&[MadeSlip::everywhere((*law, slip))], &[], |carried, _| carried.known().clone());
                let measured = |known: Option<Known<Value>>| known.and_then(|known| measured(&known, row.quantity));
                let (whole, again) = (measured(whole), measured(Some(again)));
                // The whole stops where something has no result, and what does not need that has one.
                let near = whole.is_none_or(|one| again.is_some_and(|two| (one - two).abs() < 1e-12));
                assert!(near, "{} {} on {road:?}: {whole:?}, {again:?}", row.exercise, slip.tag);
                compared += 1;
            }
            assert_eq!(*carried.known(), before, "everything is put back");
        }
    }
    assert!(compared > 4000, "{compared}");
}

/// Every slip changes an answer of some exercise: none is there in vain.
#[test]
fn every_slip_of_every_law_shows_somewhere() {
    let mut silent = Slip::all().to_vec();
    let all: Vec<Quantity> = Quantity::all().into_iter().filter(|quantity| quantity.is_in(Setting::Oblique)).collect();
    for exercise in ["1", "2", "5", "7", "8", "10", "12", "13", "14", "16", "challenge"] {
        let mut given = posed(&format!("Q{exercise}"));
        if let Some(sine) = given.number(Quantity::ContactSine) {
            // There the offset is one radius, which leaves a student who takes one for two with no triangle.
            given.0.insert(Quantity::ContactSine, Datum::Number(sine.half()));
        }
        for road in Road::ALL {
            let mut carried = Carried::on(road, &given, &all);
            silent.retain(|owned| {
                carried.again(&[MadeSlip::everywhere(*owned)], &[], |_, trace| trace.slipped.is_empty())
            });
        }
    }
    let an_impulse = r#"{ "masses": { "A": "2" }, "before": { "A": ["3", "1"] }, "impulse": ["-8", "6"] }"#;
    let two_impacts = r#"{ "masses": { "A": "4", "B": "2" }, "before": { "A": "9", "B": "0" }, "e": "1/2",
        "then": [{ "of": ["B", "C"], "mass": "4", "before": "0", "e": "2/3" }] }"#;
    for (given, asked) in [(an_impulse, "A.after.speed"), (two_impacts, "second.C.after.speed")] {
        let scene = Scene::read(&serde_json::from_str::<SceneText>(given).unwrap(), &(), Angles::Radians);
        let given = pose(&scene.unwrap()).unwrap();
        let mut carried = Carried::on(Road::Shortest, &given, &[asked.parse().unwrap()]);
        silent.retain(|owned| carried.again(&[MadeSlip::everywhere(*owned)], &[], |_, trace| trace.slipped.is_empty()));
    }
    assert_eq!(silent, []);
}

/// Wrong answers of students for which no slip is named: exercise, answer, and why.
const UNNAMED: &[(&str, &str, &str)] = &[
    ("Q5", "61v/36", "the square of the speed, but not the square of v: two slips, one of writing"),
    ("Q9", "4 + j", "no vector; judging says what is missing"),
    ("Q12", "2.5", "one component of a vector; judging asks for both"),
    ("Challenge", "3√(3/7)", "the root sign was drawn too long"),
];

/// At least so many wrong answers are looked up.
const LOOKED_UP: usize = 35;

#[test]
fn wrong_answers_of_students_are_named_and_right_ones_are_not() {
    let (mut looked_up, mut faults) = (0, Vec::new());
    for line in file("answers.jsonl").lines() {
        let row: Json = serde_json::from_str(line).unwrap();
        let [exercise, name, answer, verdict] =
            ["question", "quantity", "answer", "verdict"].map(|key| row[key].as_str().unwrap());
        let Some(asked) = asked_by(exercise, name) else { continue };
        let known = UNNAMED.iter().any(|(in_exercise, unnamed, _)| (*in_exercise, *unnamed) == (exercise, answer));
        let Some(causes) = causes(exercise, &asked, answer) else { continue };
        match verdict {
            "correct" if !causes.is_empty() => {
                faults.push(format!("{exercise} {name} `{answer}` is right: {causes:?}"))
            }
            "wrong" if causes.is_empty() != known => {
                faults.push(format!("{exercise} {name} `{answer}` is wrong: {causes:?}"));
            }
            "wrong" => looked_up += 1,
            _ => {}
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(looked_up >= LOOKED_UP, "{looked_up}");
}

/// The quantity or vector that a row of the students' answers is about.
fn asked_by(exercise: &str, name: &str) -> Option<Vec<Quantity>> {
    use Moment::After;
    use Sphere::{A, B};
    let in_vectors = ["Q9", "Q10", "Q11", "Q12", "Q13", "Q14", "Q14R"].contains(&exercise);
    let velocity = |sphere| {
        let axes = if in_vectors { [Axis::X, Axis::Y] } else { [Axis::N, Axis::T] };
        axes.map(|axis| Quantity::Velocity(sphere, After, axis)).to_vec()
    };
    Some(match name {
        "velocity_A" => velocity(A),
        "velocity_B" => velocity(B),
        "line_of_centres" => vec![Quantity::Line(Axis::X), Quantity::Line(Axis::Y)],
        "e" => vec![Quantity::Restitution],
        "tan_theta" => vec![Quantity::TanDeflection(A)],
        "deflection" => vec![Quantity::Deflection(A)],
        "component_A_along_loc" => vec![Quantity::Velocity(A, After, Axis::N)],
        "speed_A" | "speed_B" | "angle_A" | "ke_lost" | "fraction_lost" | "impulse" => vec![quantity(name)],
        _ => return None,
    })
}

/// The tags of everything that leads to an answer, by its first reading; `None` where it says several things at once, or
/// nothing that can be read.
fn causes(exercise: &str, asked: &[Quantity], answer: &str) -> Option<Vec<Vec<&'static str>>> {
    let letters: Vec<Letter> = ["m", "u", "v"].iter().filter_map(|name| Letter::new(name, Range::Positive)).collect();
    let vocabulary = Vocabulary { letters: letters.clone(), vectors: asked.len() > 1 };
    let readings = read_answer(answer, &vocabulary).ok()?;
    let [statement] = readings[0].statements.as_slice() else { return None };
    let said = statement.said.first()?;
    let asked = Asked::Quantities(asked.to_vec());
    let mistakes = Mistakes::of(&posed(exercise), std::slice::from_ref(&asked), &letters, None);
    Some(mistakes.causes(&asked, said).into_iter().map(|cause| cause.tags).collect())
}

#[test]
fn slips_have_a_place_and_a_tag_of_their_own() {
    let all = slips::all();
    let tags: BTreeSet<&str> = all.iter().map(|slip| slip.tag).collect();
    let places: BTreeSet<u8> = Slip::all().iter().map(|(_, slip)| slip.place).collect();
    assert_eq!(tags.len(), all.len());
    assert_eq!(places.len(), Slip::all().len());
}

#[test]
fn carom_documents_every_slip() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/marking.md")).unwrap();
    let section = page.split("\n## Slips\n").nth(1).expect("a section `## Slips`");
    let section = section.split("\n## ").next().unwrap();
    let rows: Vec<&str> = section.lines().filter(|line| line.starts_with("| `")).collect();
    let listed = slips::all();
    let expected: Vec<String> = listed
        .iter()
        .map(|slip| {
            let laws: Vec<&str> = slip.laws.iter().map(|law| law.name()).collect();
            let law = laws.join(", ");
            format!("| `{}` | {law} | {} | {} |", slip.tag, slip.did, slip.sentence)
        })
        .collect();
    assert_eq!(rows, expected, "docs/marking.md lists the slips in their order:\n{}\n", expected.join("\n"));
}

#[derive(Debug)]
struct Row {
    exercise: String,
    asked: String,
    quantity: Quantity,
    name: String,
    value: Option<f64>,
}

fn rows() -> Vec<Row> {
    let data: Json = serde_json::from_str(&file("slip-values.json")).unwrap();
    let mut rows = Vec::new();
    for (exercise, asked) in data.as_object().unwrap() {
        for (name, values) in asked.as_object().unwrap() {
            let quantity = quantity(name);
            for (slip, value) in values.as_object().unwrap() {
                rows.push(Row {
                    exercise: exercise.clone(),
                    asked: name.clone(),
                    quantity,
                    name: slip.clone(),
                    value: value.as_f64(),
                });
            }
        }
    }
    rows
}

fn quantity(name: &str) -> Quantity {
    use Moment::After;
    use Sphere::{A, B};
    match name {
        "speed_A" => Quantity::Speed(A, After),
        "speed_B" => Quantity::Speed(B, After),
        "angle_A" => Quantity::AngleToLine(A, After),
        "ke_lost" => Quantity::EnergyLost,
        "fraction_lost" => Quantity::FractionLost,
        "impulse" => Quantity::ImpulseMagnitude,
        "deflection_A" => Quantity::Deflection(A),
        "vA_n" => Quantity::Velocity(A, After, Axis::N),
        "vA_t" => Quantity::Velocity(A, After, Axis::T),
        "vB_n" => Quantity::Velocity(B, After, Axis::N),
        "vB_t" => Quantity::Velocity(B, After, Axis::T),
        other => panic!("{other}"),
    }
}

/// A quantity, and with it the velocities after the impact that a student finds on the way.
fn asked(quantity: Quantity) -> Vec<Quantity> {
    let after = |sphere| [Axis::N, Axis::T].map(|axis| Quantity::Velocity(sphere, Moment::After, axis));
    Sphere::BOTH.into_iter().flat_map(after).chain([quantity]).collect()
}

/// The value under slips, on the road by full speeds, where every slip can show.
fn slipped(given: &Known<Value>, tags: &[&str], quantity: Quantity) -> Option<f64> {
    let carried = Carried::on(Road::BySpeeds, given, &asked(quantity));
    let mut known = given.clone();
    carried.derivation().evaluate_slipped(tags, &mut known).ok()?;
    measured(&known, quantity)
}

/// The value with components rounded that the data has, which is among the mistakes unless it is the right value.
fn rounded(given: &Known<Value>, quantity: Quantity, expected: Option<f64>) -> Option<f64> {
    let letters = ["m", "u", "v", "r"].map(|name| Letter::new(name, Range::Positive).unwrap());
    let asked = [Asked::Quantities(vec![quantity])];
    let values = Mistakes::of(given, &asked, &letters, None).values(&asked[0]);
    let found = values.iter().filter(|(tags, _)| tags == &["early-rounding"]).map(|(_, values)| values[0]);
    let nearest = found.min_by(|one, two| {
        let off = |value: &f64| (value.abs() - expected.unwrap_or_default()).abs();
        off(one).total_cmp(&off(two))
    });
    let right = slipped(given, &[], quantity);
    if right.zip(expected).is_some_and(|(right, expected)| (right - expected).abs() < 1e-9) { right } else { nearest }
}

/// With one for every letter, as the data has it.
fn measured(known: &Known<Value>, quantity: Quantity) -> Option<f64> {
    let at = |_: Letter| Some(Interval::integer(1, 96));
    let (y, x) = match known.number(quantity) {
        Some(number) => return number.enclose(96, &at).map(|value| value.to_f64()),
        None => known.direction(quantity)?,
    };
    Angle::of(&y, &x)?.enclose(96, &at).map(|degrees| degrees.to_f64())
}

fn posed(exercise: &str) -> Known<Value> {
    let id = match exercise.split('@').next().unwrap() {
        "Ch" | "Challenge" => "5C-challenge".to_owned(),
        other => format!("5C-{}", other.trim_start_matches('Q').trim_end_matches('R')),
    };
    let cases: Json = serde_json::from_str(&file("seed-cases.json")).unwrap();
    let case = cases["cases"].as_array().unwrap().iter().find(|case| case["id"] == id.as_str()).expect("an exercise");
    let mut scene = case["scene"].clone();
    if exercise == "Q14R" {
        // The exercise as it must have been meant.
        scene["after"]["A"] = serde_json::json!(["4", "3"]);
    }
    let text: SceneText = serde_json::from_value(scene).unwrap();
    let scene = Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|faults| panic!("{faults:?}"));
    let mut known = pose(&scene).unwrap_or_else(|refusal| panic!("{refusal:?}"));
    if id == "5C-16" {
        // There e is a letter; the data takes a half for it.
        known.0.insert(Quantity::Restitution, Datum::Number(Value::fraction(1, 2)));
    }
    known
}

fn file(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)).unwrap()
}
