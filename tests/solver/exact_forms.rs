//! What a scene determines is there, exactly or named with its decimal: nothing is left out in silence.

use carom::expr::print;
use carom::mechanics::{Datum, Derivation, Known, Quantity};
use carom::number::{Value, steps_taken};
use carom::solve::{Solution, report, solve_all};
use serde_json::{Value as Json, json};

use super::scenes::read;

fn solved(scene: &Json) -> Solution {
    let scene = read(scene);
    solve_all(&scene, &scene.quantities()).unwrap().remove(0)
}

/// The quantities that follow in doubles from what is given.
fn determined(solution: &Solution) -> Vec<Quantity> {
    let float = |value: &Value| value.to_f64();
    let datum = |datum: &Datum<Value>| {
        Some(match datum {
            Datum::Number(value) => Datum::Number(float(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: float(y)?, x: float(x)? },
            Datum::Equation([p, q, r]) => Datum::Equation([float(p)?, float(q)?, float(r)?]),
        })
    };
    let given = carom::mechanics::pose(solution.scene()).unwrap();
    let mut known = Known(given.0.iter().map(|(quantity, known)| (*quantity, datum(known).unwrap())).collect());
    let asked = solution.scene().quantities();
    Derivation::carry_out(&mut known, &asked);
    let exists = |quantity: &Quantity| {
        let is_finite = |number: f64| number.is_finite() && number.abs() < 1e9;
        known.number(*quantity).is_some_and(is_finite) || known.direction(*quantity).is_some()
    };
    asked.into_iter().filter(exists).collect()
}

#[test]
fn carom_leaves_no_quantity_out_in_silence() {
    let wall = json!({
        "masses": { "A": "4" }, "before": { "A": ["1", "6.4"] }, "wall": ["5*sqrt(5)", "7"], "e": "sqrt(2)/2"
    });
    let later = json!({
        "masses": { "A": "2", "B": "sqrt(3)" }, "before": { "A": ["sqrt(5)", "2"], "B": ["0", "1"] },
        "line_of_centres": ["1", "sqrt(2)"], "e": "1/2",
        "then": [{ "of": ["B"], "wall": ["1", "-3"], "e": "sqrt(2)/2" }]
    });
    let many = json!({
        "masses": { "A": "sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)", "B": "3" }, "before": { "A": ["4", "1"], "B": ["0", "0"] },
        "line_of_centres": ["1", "0"], "e": "1/2"
    });
    for scene in [wall, later, many] {
        let solution = solved(&scene);
        let report = report(&solution);
        let remarks = report.remarks.join("; ");
        let all = determined(&solution);
        assert!(all.len() > 40, "{}", all.len());
        for quantity in all {
            let name = quantity.to_string();
            let is_there = report.quantities.contains_key(&name) || remarks.contains(&format!("`{name}`"));
            assert!(is_there, "{name} of {scene}: {remarks}");
        }
    }
}

#[test]
fn carom_knows_the_decimals_of_what_has_no_exact_form() {
    let scene = json!({
        "masses": { "A": "sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)", "B": "3" }, "before": { "A": ["4", "1"], "B": ["0", "0"] },
        "line_of_centres": ["1", "0"], "e": "1/2"
    });
    let inexact = solved(&scene).without_exact_form();
    let of = |name: &str| {
        let one = inexact.iter().find(|inexact| inexact.quantity.to_string() == name);
        one.map(ToString::to_string).unwrap_or_default()
    };
    // m = √2 + √3 + √5 + √7 = 8.0280; v = 4 (m - 3/2)/(m + 3), w = 4 (3/2) m/(m + 3).
    assert_eq!(of("A.after.n"), "`A.after.n` ≈ 2.37 m/s");
    assert_eq!(of("B.after.n"), "`B.after.n` ≈ 4.37 m/s");
    assert_eq!(of("A.after.angle_to_loc_deg"), "`A.after.angle_to_loc_deg` ≈ 22.9°");
    assert_eq!(of("A.before.n"), "");
}

#[test]
fn carom_follows_a_second_impact_at_general_angles_in_little_work() {
    let scene = json!({
        "masses": { "A": "2", "B": "6" }, "e": "1/2", "sense": "A_to_B",
        "before": { "A": { "speed": "3", "cos": "-7/25", "sin": "-24/25" }, "B": { "speed": "11", "angle_deg": "70.5" } },
        "line_of_centres": ["cos(275*deg)", "sin(275*deg)"], "then": [{ "of": ["B"], "wall": ["7/3", "-4"], "e": "0" }]
    });
    steps_taken();
    let report = report(&solved(&scene));
    let steps = steps_taken();
    assert!(report.quantities.contains_key("second.B.deflection_deg"), "{:?}", report.remarks);
    // Fifteen million; with Euclid's algorithm for each common factor it was two thousand eight hundred million.
    assert!(steps < 60_000_000, "{steps}");
}

#[test]
fn carom_knows_quarters_of_a_degree_and_the_degrees_beside_a_letter() {
    // Two velocities of one size: their difference lies half way between 60° and 22.5°.
    let scene = json!({
        "masses": { "A": "2", "B": "3" }, "line_of_centres": ["1", "0"], "e": "1/2",
        "before": { "A": { "speed": "4", "angle_deg": "60" }, "B": { "speed": "4", "angle_deg": "202.5" } }
    });
    let exact = |scene: &Json, name: &str| print::plain(&solved(scene).exact(name.parse().unwrap()).unwrap());
    assert_eq!(exact(&scene, "alpha_deg"), "(165/4)*deg");
    let scene = |angle: &str| {
        json!({
            "masses": { "A": "2", "B": "3" }, "line_of_centres": ["1", "0"], "e": "1/2", "symbols": { "alpha": "acute" },
            "before": { "A": ["6", "0"], "B": { "speed": "4", "angle_deg": angle } }
        })
    };
    assert_eq!(exact(&scene("180 - alpha"), "B.before.n"), "-4*cos(alpha)");
    assert_eq!(exact(&scene("180 - alpha"), "ke.lost"), exact(&scene("180 deg - alpha"), "ke.lost"));
}

#[test]
fn carom_finds_the_mass_that_an_impulse_acts_on() {
    let mass = |before: [&str; 2], after: [&str; 2], impulse: [&str; 2]| {
        let scene = json!({
            "masses": { "A": null }, "before": { "A": before }, "after": { "A": after }, "impulse": impulse
        });
        solved(&scene).number("A.mass".parse().unwrap())
    };
    assert_eq!(mass(["1", "1"], ["3", "1"], ["6", "0"]), Some(Value::from(3)));
    assert_eq!(mass(["1", "1"], ["1", "-1"], ["0", "-5"]), Some(Value::fraction(5, 2)));
    assert_eq!(mass(["1", "0"], ["5", "3"], ["8", "6"]), Some(Value::from(2)));
}

#[test]
fn carom_finds_a_mass_with_more_roots_than_the_rest_can_be_written_in() {
    let scene = json!({
        "masses": { "A": "6", "B": "x" }, "before": { "A": { "speed": "7", "angle_deg": "30" }, "B": ["-sqrt(2)", "1"] },
        "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "3/4", "symbols": { "x": "positive" },
        "unknowns": ["x"], "conditions": ["A.after.angle_to_loc_deg = 51"]
    });
    let scene = read(&scene);
    let solutions = solve_all(&scene, &scene.quantities()).unwrap();
    // v = ±(7/2)/tan 51°, w = v + (3/4)(7√3/2 + √2), x = 6 (7√3/2 - v)/(w + √2).
    let tangent = 51f64.to_radians().tan();
    let (along, two) = (3.5 * 3f64.sqrt(), 2f64.sqrt());
    let mut expected = [1.0, -1.0].map(|sign| {
        let v = sign * 3.5 / tangent;
        6.0 * (along - v) / (v + 0.75 * (along + two) + two)
    });
    expected.sort_by(f64::total_cmp);
    let mut found: Vec<f64> = solutions.iter().map(|solution| solution.found()[0].1.to_f64().unwrap()).collect();
    found.sort_by(f64::total_cmp);
    assert_eq!(found.len(), 2);
    assert!(found.iter().zip(expected).all(|(one, other)| (one / other - 1.0).abs() < 1e-12), "{found:?} {expected:?}");
    let angle: Quantity = "A.after.angle_to_loc_deg".parse().unwrap();
    for solution in &solutions {
        let inexact = solution.without_exact_form();
        let is_said = inexact.iter().any(|inexact| inexact.to_string() == format!("`{angle}` ≈ 51.0°"));
        assert!(solution.angle(angle).is_some() || is_said, "{inexact:?}");
    }
}

#[test]
fn carom_knows_that_a_fraction_of_energy_is_what_is_lost_over_what_there_was() {
    let scene = json!({
        "masses": { "A": "2", "B": "3" }, "before": { "A": ["4", "1"], "B": ["-1", "1"] },
        "line_of_centres": ["1", "0"], "e": "e", "symbols": { "e": "unit" },
        "unknowns": ["e"], "conditions": ["ke.fraction_lost = 1/5"]
    });
    // Along the line of centres (1/2)(6/5)(5²)(1 - e²) is lost, of 17 + 3.
    let steps = report(&solved(&scene)).steps;
    let quotient = steps.iter().find_map(|step| step.equations.iter().find(|equation| equation.starts_with("f=")));
    assert_eq!(quotient.unwrap(), r"f=\frac{15(1-e^{2})}{20}");
}

#[test]
fn what_approaches_has_no_bars_and_no_tangent_is_rationalised() {
    let exact =
        |scene: &Json, name: &str| report(&solved(scene)).quantities[name]["exact"].as_str().unwrap().to_owned();
    let letters = json!({ "m": "positive", "u": "positive", "w": "positive", "alpha": "acute" });
    let direct = json!({
        "masses": { "A": "2*m", "B": "m" }, "before": { "A": "u", "B": "w" }, "e": "1/2", "symbols": letters
    });
    // They meet only with u > w: B then has (2u + w + u - w)/3 = u, and was pushed by m(u - w).
    assert_eq!(exact(&direct, "impulse.magnitude"), "m*(u - w)");
    assert_eq!(exact(&direct, "B.after.speed"), "u");
    let pushed = json!({
        "masses": { "A": "m", "B": "3*m" }, "before": { "A": "u", "B": "w" }, "e": "1/2", "symbols": letters
    });
    assert_eq!(exact(&pushed, "B.after.speed"), "(5*w + 3*u)/8");
    assert_eq!(exact(&pushed, "A.after.speed"), "abs(u - 9*w)/8");
    let oblique = json!({
        "masses": { "A": "2*m", "B": "3*m" },
        "before": { "A": { "speed": "u", "angle_deg": "alpha" }, "B": ["3*u", "0"] },
        "line_of_centres": ["1", "0"], "e": "1/2", "symbols": letters
    });
    assert_eq!(exact(&oblique, "impulse.magnitude"), "9*m*u*(3 - cos(alpha))/5");
    assert_eq!(exact(&oblique, "A.after.angle_to_loc_deg"), "atan(10*sin(alpha)/(27 + cos(alpha)))/deg");
}
