//! How long it takes to work out what every slip leads to in a question, and to look an answer up.

use carom::expr::Angles;
use carom::mark::reading::{Vocabulary, read_answer};
use carom::mark::slips::{Asked, Mistakes};
use carom::mechanics::{Known, Moment, Quantity, Scene, SceneText, Sphere, pose};
use carom::number::{Letter, Value};
use divan::Bencher;
use serde_json::json;

fn main() {
    divan::main();
}

/// The questions: in numbers, and in a letter.
const QUESTIONS: [&str; 2] = ["numbers", "letter"];

fn posed(question: &str) -> (Known<Value>, Vec<Letter>) {
    let u = if question == "letter" { "u" } else { "3" };
    let scene = json!({ "masses": {"A": "2", "B": "1"}, "before": {"A": {"speed": u, "angle_deg": "45"},
        "B": {"speed": "2", "angle_deg": "120"}}, "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "1/3",
        "symbols": {"u": "positive"} });
    let text: SceneText = serde_json::from_value(scene).expect("a scene");
    let scene = Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|_| panic!("the scene has faults"));
    let letters = if question == "letter" { scene.letters.clone() } else { Vec::new() };
    (pose(&scene).unwrap_or_else(|refusal| panic!("{refusal}")), letters)
}

fn answers() -> Vec<Asked> {
    let speeds = Sphere::BOTH.map(|sphere| vec![Quantity::Speed(sphere, Moment::After)]);
    speeds.into_iter().chain([vec![Quantity::EnergyLost]]).map(Asked::Quantities).collect()
}

/// Everything that can go wrong in a question with three answers.
#[divan::bench(args = QUESTIONS)]
fn mistakes_of_a_question(bencher: Bencher, question: &str) {
    let ((given, letters), answers) = (posed(question), answers());
    bencher.bench(|| Mistakes::of(&given, &answers, &letters, None));
}

/// The causes of one wrong answer.
#[divan::bench]
fn causes_of_an_answer(bencher: Bencher) {
    let ((given, letters), answers) = (posed("numbers"), answers());
    let mistakes = Mistakes::of(&given, &answers, &letters, None);
    let readings = read_answer("2.52", &Vocabulary::default()).expect("a number");
    let said = &readings[0].statements[0].said[0];
    bencher.bench(|| mistakes.causes(&answers[0], said));
}
