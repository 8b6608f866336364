//! What a solution prints is short, and is there at once: sines and cosines of given angles, and factors that cancel.

use std::time::{Duration, Instant};

use carom::expr::print;
use carom::mechanics::{Moment, Quantity, Sphere};
use carom::solve::{report, solve_all};
use serde_json::{Value as Json, json};

use super::scenes::read;

/// Several times what the slowest takes without optimisation; each took from twelve seconds to two minutes.
const LONGEST: Duration = Duration::from_secs(5);

/// The quantities of the one solution of a scene.
fn quantities(scene: &Json) -> Vec<(String, String)> {
    let started = Instant::now();
    let read = read(scene);
    let solutions = solve_all(&read, &read.quantities()).unwrap_or_else(|refusal| panic!("{scene}: {refusal}"));
    let [solution] = solutions.as_slice() else { panic!("{scene}: {} solutions", solutions.len()) };
    let report = report(solution);
    assert!(started.elapsed() < LONGEST, "{scene} takes {:?}", started.elapsed());
    let exact = |(name, value): (&String, &Json)| (name.clone(), value["exact"].as_str().unwrap().to_owned());
    report.quantities.iter().map(exact).collect()
}

fn oblique(masses: [&str; 2], before: [Json; 2], line: [&str; 2], e: &str) -> Json {
    let [a, b] = before;
    json!({ "masses": {"A": masses[0], "B": masses[1]}, "before": {"A": a, "B": b}, "line_of_centres": line, "e": e })
}

fn at(speed: &str, degrees: &str) -> Json {
    json!({ "speed": speed, "angle_deg": degrees })
}

#[test]
fn what_two_angles_share_collapses() {
    let scene = oblique(["1", "1"], [at("2", "20"), at("3", "160")], ["1", "0"], "1/2");
    let quantities = quantities(&scene);
    let exact = |name: &str| &quantities.iter().find(|(other, _)| other == name).unwrap().1;
    for (name, expected) in [
        ("ke.lost", "75*cos(20*deg)^2/16"),
        ("B.before.x", "-3*cos(20*deg)"),
        ("A.after.x", "-7*cos(20*deg)/4"),
        ("angle_between_after_deg", "180 - atan(36*tan(20*deg)/(7 - 32*tan(20*deg)^2))/deg"),
    ] {
        assert_eq!(exact(name), expected, "{name}");
    }
    let steep = oblique(["1", "1"], [at("2", "70"), json!(["0", "0"])], ["1", "0"], "1/2");
    assert!(self::quantities(&steep).contains(&("A.before.n".to_owned(), "2*cos(70*deg)".to_owned())));
}

#[test]
fn no_form_is_longer_than_a_line_or_two_of_a_page() {
    let slow = [at("1", "18"), json!(["cos(20*deg)", "-2"])];
    for scene in [
        oblique(["1", "1"], [at("2", "20"), at("3", "130")], ["1", "1"], "1/2"),
        oblique(["1", "1"], slow.clone(), ["1", "1"], "0"),
        oblique(["1/2", "1/2"], slow, ["1", "1"], "0"),
        oblique(["1", "1"], [at("2", "18"), at("3", "100")], ["3", "4"], "1/2"),
    ] {
        for (name, exact) in quantities(&scene) {
            assert!(exact.len() < 400, "{name} of {scene}: {exact}");
        }
    }
}

#[test]
fn a_letter_that_both_components_share_does_not_hide_an_angle() {
    let mut scene =
        oblique(["m", "3*m"], [json!(["u*cos(theta)", "u*sin(theta)"]), json!(["0", "0"])], ["1", "0"], "1/2");
    scene["symbols"] = json!({ "m": "positive", "u": "positive", "theta": "acute" });
    scene["unknowns"] = json!(["theta"]);
    scene["conditions"] = json!(["A.deflection_deg = 30"]);
    let quantities = quantities(&scene);
    assert!(quantities.contains(&("A.deflection_deg".to_owned(), "30".to_owned())), "{quantities:?}");
    assert!(quantities.contains(&("A.tan_deflection".to_owned(), "sqrt(3)/3".to_owned())), "{quantities:?}");
}

/// Every equation of the working of a scene.
fn working(scene: &Json) -> Vec<String> {
    let read = read(scene);
    let solutions = solve_all(&read, &[Quantity::ImpulseMagnitude, Quantity::EnergyLost, ANGLE]).unwrap();
    let equations = solutions[0].lines().into_iter().flat_map(|line| line.equations);
    equations.map(|equation| print::plain(&equation)).collect()
}

const ANGLE: Quantity = Quantity::AngleToLine(Sphere::A, Moment::After);

#[test]
fn what_the_scene_calls_by_a_letter_is_not_called_so_again() {
    let direct = json!({
        "masses": {"A": "I", "B": "L"}, "before": {"A": "5", "B": "1"}, "e": "1/2",
        "symbols": {"I": "positive", "L": "positive"},
    });
    let working = working(&direct);
    for equation in ["J = 6*I*L/(L + I)", "D = 6*I*L/(L + I)"] {
        assert!(working.iter().any(|line| line == equation), "{equation}: {working:?}");
    }
}

#[test]
fn an_angle_has_a_tangent_of_sizes_in_lowest_terms() {
    let mut scene = oblique(["2", "m"], [json!(["5", "y"]), json!(["0", "0"])], ["1", "0"], "1/2");
    scene["symbols"] = json!({"y": "real", "m": "positive"});
    scene["sense"] = json!("A_to_B");
    let working = working(&scene);
    let is_there = |equation: &str| working.iter().any(|line| line == equation);
    assert!(is_there("tan(beta) = abs(y)/(5*abs(m - 4)/(2*(2 + m)))"), "{working:?}");
}
