//! How long it takes to solve one collision, by the kind of its numbers.

use carom::expr::Angles;
use carom::mechanics::{Quantity, Scene, SceneText};
use carom::solve::{Solution, solve_all};
use divan::Bencher;
use serde_json::{Value as Json, json};

fn main() {
    divan::main();
}

fn scene(json: Json) -> Scene {
    let text: SceneText = serde_json::from_value(json).expect("a scene");
    Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|_| panic!("the scene has faults"))
}

fn solved(scene: &Scene, asked: &[Quantity]) -> Vec<Solution> {
    solve_all(scene, asked).unwrap_or_else(|refusal| panic!("{refusal}"))
}

/// The ids of the reference exercises that a pair of real spheres can do.
fn exercises() -> Vec<String> {
    cases().into_iter().map(|(id, _)| id).collect()
}

fn cases() -> Vec<(String, Json)> {
    let seed: Json = serde_json::from_str(include_str!("../tests/data/seed-cases.json")).expect("the seed's cases");
    let cases = seed["cases"].as_array().expect("a list of cases");
    let possible = cases.iter().filter(|case| case["feasible"] == true);
    possible.map(|case| (case["id"].as_str().expect("an id").to_owned(), case["scene"].clone())).collect()
}

/// Every quantity of a reference exercise.
#[divan::bench(args = exercises())]
fn every_quantity_of_exercise(bencher: Bencher, id: &str) {
    let (_, json) = cases().into_iter().find(|(other, _)| other == id).expect(id);
    let (scene, asked) = (scene(json), Quantity::all());
    bencher.bench(|| solved(&scene, &asked));
}

/// What a short question asks for.
const ASKED: [&str; 3] = ["A.after.speed", "A.after.angle_to_loc_deg", "ke.lost"];

fn asked() -> Vec<Quantity> {
    ASKED.iter().map(|name| name.parse().expect(name)).collect()
}

#[divan::bench]
fn with_fractions(bencher: Bencher) {
    let scene = scene(json!({
        "masses": { "A": "3", "B": "2" },
        "before": { "A": ["5", "7/2"], "B": ["-1/3", "2"] },
        "line_of_centres": ["1", "0"],
        "sense": "A_to_B",
        "e": "2/5",
    }));
    bencher.bench(|| solved(&scene, &asked()));
}

#[divan::bench]
fn with_surds(bencher: Bencher) {
    let scene = scene(json!({
        "masses": { "A": "3", "B": "2" },
        "before": { "A": { "speed": "6", "angle_deg": "30" }, "B": { "speed": "2*sqrt(5)", "angle_deg": "135" } },
        "line_of_centres": ["1", "0"],
        "sense": "A_to_B",
        "e": "1/2",
    }));
    bencher.bench(|| solved(&scene, &asked()));
}

#[divan::bench]
fn with_degrees(bencher: Bencher) {
    let scene = scene(json!({
        "masses": { "A": "3", "B": "2" },
        "before": { "A": { "speed": "6", "angle_deg": "37" }, "B": { "speed": "4", "angle_deg": "118" } },
        "line_of_centres": ["1", "0"],
        "sense": "A_to_B",
        "e": "0.35",
    }));
    bencher.bench(|| solved(&scene, &asked()));
}

#[divan::bench]
fn with_letters(bencher: Bencher) {
    let scene = scene(json!({
        "masses": { "A": "2*m", "B": "m" },
        "before": { "A": ["u*cos(theta)", "u*sin(theta)"], "B": ["0", "0"] },
        "line_of_centres": ["1", "0"],
        "sense": "A_to_B",
        "e": "e",
        "symbols": { "m": "positive", "u": "positive", "theta": "acute", "e": "unit" },
    }));
    let asked = ["A.after.speed", "A.tan_deflection", "ke.lost"].map(|name| name.parse().expect(name));
    bencher.bench(|| solved(&scene, &asked));
}

#[divan::bench]
fn backwards(bencher: Bencher) {
    let scene = scene(json!({
        "masses": { "A": "m", "B": "3*m" },
        "before": { "A": ["u*cos(theta)", "u*sin(theta)"], "B": ["0", "0"] },
        "line_of_centres": ["1", "0"],
        "sense": "A_to_B",
        "e": "1/2",
        "symbols": { "m": "positive", "u": "positive", "theta": "acute" },
        "unknowns": ["theta"],
        "conditions": ["A.deflection_dot = 0"],
    }));
    let asked = ["A.after.speed", "A.after.angle_to_loc_deg"].map(|name| name.parse().expect(name));
    bencher.bench(|| solved(&scene, &asked));
}
