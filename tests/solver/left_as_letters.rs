//! Unknowns whose values would fill pages: the rest is found in their letters, and its decimals are right all the same.

use carom::mechanics::Because;
use carom::number::steps_taken;
use carom::solve::{report, solve, solve_all};
use serde_json::{Value as Json, json};

use super::scenes::read;

/// Masses, speeds with their degrees, degrees of the line of centres, e.
struct Case {
    masses: [f64; 2],
    before: [(f64, f64); 2],
    line: f64,
    e: f64,
}

impl Case {
    /// By the impulse along the line of centres, in doubles.
    fn impact(&self) -> [(&'static str, f64); 7] {
        let turned = |(speed, degrees): (f64, f64)| {
            let (sin, cos) = (degrees - self.line).to_radians().sin_cos();
            (speed * cos, speed * sin)
        };
        let ([m, n], [(a, s), (b, t)]) = (self.masses, self.before.map(turned));
        let shared = m * n / (m + n);
        let impulse = shared * (1.0 + self.e) * (a - b);
        let (v, w) = (a - impulse / m, b + impulse / n);
        [
            ("approach", a - b),
            ("A.after.speed", v.hypot(s)),
            ("B.after.speed", w.hypot(t)),
            ("A.after.angle_to_loc_deg", s.abs().atan2(v.abs()).to_degrees()),
            ("B.after.angle_to_loc_deg", t.abs().atan2(w.abs()).to_degrees()),
            ("impulse.magnitude", impulse),
            ("ke.lost", shared * (1.0 - self.e * self.e) * (a - b).powi(2) / 2.0),
        ]
    }

    /// The scene, with an unknown in the place of the mass of B or of the degrees of the line of centres.
    fn scene(&self, is_mass: bool, condition: &str) -> Json {
        let [a, b] = self.before.map(|(speed, degrees)| {
            let [speed, degrees] = [speed, degrees].map(|number| number.to_string());
            json!({ "speed": speed, "angle_deg": degrees })
        });
        let [m, n] = self.masses.map(|mass| mass.to_string());
        json!({
            "masses": { "A": m, "B": if is_mass { "x" } else { &n } }, "before": { "A": a, "B": b },
            "line_of_centres": if is_mass { ["1", "0"] } else { ["cos(x)", "sin(x)"] },
            "sense": "A_to_B", "e": self.e.to_string(), "unknowns": ["x"],
            "symbols": { "x": if is_mass { "positive" } else { "acute" } }, "conditions": [condition]
        })
    }
}

/// Scenes whose unknown is a sum of so many sines and roots that a quotient by it takes minutes; and how many solutions.
fn cases() -> Vec<(Case, bool, &'static str, usize)> {
    let case = |n, before, e| Case { masses: [2.0, n], before, line: 0.0, e };
    vec![
        (case(3.0, [(8.0, -71.0), (3.0, 206.0)], 0.75), false, "B.after.speed = 2", 1),
        (case(3.0, [(5.0, 6.0), (3.0, 248.0)], 0.3), false, "A.after.angle_to_loc_deg = 50", 2),
        (case(1.0, [(6.0, 15.0), (4.0, 100.0)], 1.0), true, "A.after.angle_to_loc_deg = 50", 2),
        (case(1.0, [(3.0, 79.0), (2.0, 168.0)], 0.3), true, "A.after.angle_to_loc_deg = 50", 1),
        (case(1.0, [(5.0, -48.0), (2.0, 112.0)], 1.0), true, "B.after.speed = 2", 1),
    ]
}

#[test]
fn what_follows_from_a_long_value_is_found_in_its_letter() {
    for (case, is_mass, condition, solutions) in cases() {
        let scene = read(&case.scene(is_mass, condition));
        steps_taken();
        let all = solve_all(&scene, &scene.quantities()).unwrap();
        let steps = steps_taken();
        assert!(steps < MOST_STEPS, "{condition}: {steps}");
        assert_eq!(all.len(), solutions, "{condition}");
        for solution in &all {
            let report = report(solution);
            let decimal = |name: &str| report.quantities[name]["decimal"].as_str().unwrap().parse::<f64>().unwrap();
            let x = decimal("x");
            let Case { masses: [first, _], before, e, .. } = case;
            let there = match is_mass {
                true => Case { masses: [first, x], before, e, line: 0.0 },
                false => Case { masses: case.masses, before, e, line: x },
            };
            assert!(report.remarks.iter().any(|remark| remark.contains("in its letter, x ≈")), "{:?}", report.remarks);
            assert!(report.quantities["approach"]["exact"].as_str().unwrap().contains('x') || is_mass);
            for (name, expected) in there.impact() {
                let found = decimal(name);
                assert!((found - expected).abs() < 1e-9, "{name} where x = {x}: {found}, not {expected}");
            }
        }
    }
}

#[test]
fn no_more_work_is_done_where_it_is_open_which_way_the_line_of_centres_goes() {
    for (case, is_mass, condition, solutions) in cases() {
        let mut scene = case.scene(is_mass, condition);
        scene.as_object_mut().unwrap().remove("sense");
        let scene = read(&scene);
        steps_taken();
        let all = solve_all(&scene, &scene.quantities()).unwrap();
        let steps = steps_taken();
        assert!(steps < 2 * MOST_STEPS, "{condition}: {steps}");
        assert_eq!(all.len(), solutions, "{condition}");
    }
}

/// Four times what the longest of them takes.
const MOST_STEPS: u64 = 500_000;

#[test]
fn a_question_does_not_go_on_from_a_value_that_nobody_could_print() {
    for (case, is_mass, condition, solutions) in cases() {
        let scene = read(&case.scene(is_mass, condition));
        let refusal = solve(scene, &["impulse.magnitude".parse().unwrap()]).unwrap_err();
        match solutions {
            1 => {
                assert_eq!(refusal.because, Because::BeyondMethods, "{refusal:?}");
                assert!(refusal.reason.starts_with("x ≈ "), "{}", refusal.reason);
            }
            _ => assert!(refusal.reason.starts_with("more than one value is possible"), "{}", refusal.reason),
        }
    }
}
