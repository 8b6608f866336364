//! What comes out can be required as what goes in can: 'the speed of A after is an integer', 'A turns through 90 degrees',
//! 'e comes out as 5/7'. Each row is one requirement on a result, and a formula in floats that must agree with it on every
//! set of numbers: kept are those for which it is true, and no others.

use std::collections::BTreeMap;
use std::sync::Mutex;

use carom::bank::{Question, read_question};
use carom::diagnostic::{Source, render_all};
use carom::generate::{Unfit, Variant, enumerate};

/// Numbers by name: the parameters, and the velocities after the impact along and across the line of centres.
type Numbers = BTreeMap<String, f64>;

/// A strikes B, in numbers: the impulse by the reduced mass, as nothing in the requirements has it.
fn collide(numbers: &mut Numbers) {
    let [ma, mb, u, w, e] = ["mA", "mB", "u", "w", "e"].map(|name| numbers[name]);
    let (sin, cos) = numbers["alpha"].to_radians().sin_cos();
    let along = u * cos;
    let impulse = ma * mb / (ma + mb) * (1.0 + e) * (along - w);
    let results = [
        ("A along before", along),
        ("across", u * sin),
        ("A along", along - impulse / ma),
        ("B along", w + impulse / mb),
        ("impulse", impulse),
    ];
    numbers.extend(results.map(|(name, value)| (name.to_owned(), value)));
}

const FORWARDS: &str = r#"
title = "A strikes B"
topic = "B moves along the line of centres"
stem = "{mA kg} {mB kg} {u m/s} {w m/s} {alpha deg} {e}"
require = ["approach > 0", "REQUIREMENT"]
[parameters]
mA = "1..3"
mB = "1..3"
u = ["2", "5", "10"]
w = "-2..1"
alpha = ["30", "60", "atan(3/4)/deg"]
e = ["0", "1/4", "1/3", "1/2", "1"]
[style.exact]
[scene]
masses = { A = "mA", B = "mB" }
before = { A = { speed = "u", angle_deg = "alpha" }, B = ["w", "0"] }
line_of_centres = ["1", "0"]
sense = "A_to_B"
e = "e"
[[part]]
ask = "Find the components of the velocities after the impact."
answers = [{ name = "of *A*", find = "A.after.n", accept = "exact" }, { name = "of *B*", find = "B.after.n", accept = "exact" }]
marks = [{ code = "M1", for = "momentum" }, { code = "A1", for = "A.after.n" }]
[reference]
mA = "2"
mB = "1"
u = "10"
w = "0"
alpha = "60"
e = "1/2"
"#;

fn question(text: &str) -> Question {
    read_question("q", &Source::new("q.toml", text)).unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)))
}

/// The parameters of all that is fit for print, in no particular order.
fn fit(question: &Question) -> Vec<String> {
    let found = Mutex::new(Vec::new());
    let visit = |variant: Variant| found.lock().unwrap().push(format!("{:?}", numbers(&variant.parameters)));
    enumerate(question, &question.styles[0], &visit, &|_| ());
    let mut found = found.into_inner().unwrap();
    found.sort();
    found
}

fn numbers(parameters: &[(String, carom::expr::Expr)]) -> Numbers {
    let value = |text: String| match text.as_str() {
        "atan(3/4)/deg" => 0.75f64.atan().to_degrees(),
        text => match text.split_once('/') {
            Some((above, below)) => above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap(),
            None => text.parse().unwrap(),
        },
    };
    parameters.iter().map(|(name, expr)| (name.clone(), value(carom::expr::print::plain(expr)))).collect()
}

fn is_integer(x: f64) -> bool {
    (x - x.round()).abs() < 1e-9
}

fn turned(n: &Numbers) -> f64 {
    let before = n["across"].atan2(n["A along before"]);
    (n["across"].atan2(n["A along"]) - before).to_degrees()
}

/// A requirement, and the same said of floats.
type Row = (&'static str, fn(&Numbers) -> bool);

const ROWS: [Row; 13] = [
    ("A.after.n is an integer", |n| is_integer(n["A along"])),
    ("A.after.speed is an integer", |n| is_integer(n["A along"].hypot(n["across"]))),
    ("B.after.speed is a whole number", |n| is_integer(n["B along"].abs())),
    ("A.deflection_deg = 90", |n| (turned(n) - 90.0).abs() < 1e-9),
    ("A.deflection_deg = 60", |n| (turned(n) - 60.0).abs() < 1e-9),
    ("A.deflection_deg > 45", |n| turned(n) > 45.0 + 1e-9),
    ("A.deflection_dot = 0", |n| (turned(n) - 90.0).abs() < 1e-9),
    ("A.after.angle_to_loc_deg = 90", |n| n["A along"].abs() < 1e-9),
    ("A.after.angle_to_loc_deg < 60", |n| n["across"].atan2(n["A along"].abs()).to_degrees() < 60.0 - 1e-9),
    ("A.after.n < 0", |n| n["A along"] < -1e-9),
    ("separation = 2*e", |n| (n["B along"] - n["A along"] - 2.0 * n["e"]).abs() < 1e-9),
    ("ke.fraction_lost < 1/5", |n| {
        let energy = |v: f64| n["mA"] * (v * v + n["across"].powi(2));
        let before = energy(n["A along before"]) + n["mB"] * n["w"].powi(2);
        let after = energy(n["A along"]) + n["mB"] * n["B along"].powi(2);
        (before - after) / before < 0.2 - 1e-9
    }),
    ("tan(A.after.angle_to_loc_deg) = 3/2", |n| (n["across"] / n["A along"].abs() - 1.5).abs() < 1e-9),
];

#[test]
fn what_is_required_of_results_holds_for_all_that_is_kept_and_for_nothing_else() {
    let whole = question(&FORWARDS.replace("REQUIREMENT", "mA > 0"));
    let style = &whole.styles[0];
    for (requirement, holds) in ROWS {
        let question = question(&FORWARDS.replace("REQUIREMENT", requirement));
        let mut expected: Vec<String> = Vec::new();
        for index in 0..style.size() {
            let mut all = numbers(&style.parameters_at(index));
            let shown = format!("{all:?}");
            collide(&mut all);
            if all["A along before"] - all["w"] > 1e-9 && holds(&all) {
                expected.push(shown);
            }
        }
        expected.sort();
        let found = fit(&question);
        assert!(!expected.is_empty() && expected.len() < 1500, "{requirement} holds of {} sets", expected.len());
        let more = found.iter().find(|set| !expected.contains(set));
        let fewer = expected.iter().find(|set| !found.contains(set));
        assert_eq!((more, fewer), (None, None), "{requirement}: kept and should not be, or the other way round");
    }
}

const BACKWARDS: &str = r#"
title = "The velocity of A after the impact is given"
topic = "working backwards"
stem = "{m kg} {u m/s} {v m/s}"
require = ["REQUIREMENT"]
[parameters]
m = "1..6"
u = "2..12"
v = "-4..6"
[style.exact]
[scene]
masses = { A = "m", B = "4" }
before = { A = ["u", "3"], B = ["0", "0"] }
after = { A = ["v", "3"] }
line_of_centres = ["1", "0"]
[[part]]
ask = "Find the coefficient of restitution."
answers = [{ name = "e", find = "e", accept = "exact" }]
marks = [{ code = "M1", for = "restitution" }, { code = "A1", for = "e" }]
[reference]
m = "4"
u = "6"
v = "2"
"#;

#[test]
fn what_the_coefficient_of_restitution_comes_out_as_can_be_required() {
    for (requirement, wanted) in [("e = 5/7", Some((5, 7))), ("e = 1/3", Some((1, 3))), ("denominator(e) <= 3", None)] {
        let question = question(&BACKWARDS.replace("REQUIREMENT", requirement));
        let mut expected = Vec::new();
        for (m, u, v) in (1..=6).flat_map(|m| (2..=12).flat_map(move |u| (-4..=6).map(move |v| (m, u, v)))) {
            // B has m(u - v)/4 afterwards, so that 4 u e = m(u - v) - 4 v.
            let (above, below) = (m * (u - v) - 4 * v, 4 * u);
            let is_wanted = match wanted {
                Some((p, q)) => above * q == p * below,
                None => (1..=3).any(|q| above * q % below == 0),
            };
            if u > v && 0 <= above && above <= below && is_wanted {
                let named = [("m", m), ("u", u), ("v", v)].map(|(name, value)| (name.to_owned(), f64::from(value)));
                expected.push(format!("{:?}", Numbers::from(named)));
            }
        }
        expected.sort();
        assert!(!expected.is_empty(), "{requirement}");
        assert_eq!(fit(&question), expected, "{requirement}");
    }
}

const LETTERS: &str = r#"
title = "A is turned through a right angle"
topic = "working backwards"
stem = "{k} {alpha deg}"
require = ["e is rational", "denominator(e) <= 7", "e > 0"]
[parameters]
k = "2..9"
alpha = ["30", "45", "60"]
[style.exact]
[scene]
masses = { A = "m", B = "k*m" }
before = { A = { speed = "u", angle_deg = "alpha" }, B = ["0", "0"] }
line_of_centres = ["1", "0"]
sense = "A_to_B"
e = "e"
symbols = { m = "positive", u = "positive", e = "unit" }
unknowns = ["e"]
conditions = ["A.deflection_dot = 0"]
[[part]]
ask = "Find the coefficient of restitution."
answers = [{ name = "e", find = "e", kind = "number", accept = "exact" }]
marks = [{ code = "M1", for = "restitution" }, { code = "M1", for = "condition" }, { code = "A1", for = "e" }]
[reference]
k = "4"
alpha = "30"
"#;

#[test]
fn what_is_required_of_a_letter_that_is_found_holds_of_what_it_comes_out_as() {
    // A turned through 90 degrees: the part along goes from c to -s²/c, so that (k e - 1)/(k + 1) = tan² alpha.
    let question = question(LETTERS);
    let mut expected = Vec::new();
    for k in 2..=9i32 {
        for (alpha, above, below) in [(30, 1, 3), (45, 1, 1), (60, 3, 1)] {
            let (p, q) = (above * (k + 1) + below, below * k);
            if p <= q && (1..=7).any(|d| p * d % q == 0) {
                let named = [("k", k), ("alpha", alpha)].map(|(name, value)| (name.to_owned(), f64::from(value)));
                expected.push(format!("{:?}", Numbers::from(named)));
            }
        }
    }
    expected.sort();
    assert!(expected.len() > 2, "{expected:?}");
    assert_eq!(fit(&question), expected);
}

const RESTING: &str = r#"
title = "A may come to rest, and then has no direction"
topic = "A strikes B"
stem = "{m kg} {c m/s}"
require = ["REQUIREMENT"]
[parameters]
m = "1..3"
c = "0..2"
[style.exact]
[scene]
masses = { A = "1", B = "m" }
before = { A = ["4", "c"], B = ["0", "0"] }
line_of_centres = ["1", "0"]
sense = "A_to_B"
e = "1"
[[part]]
ask = "Find the direction of *A* after the impact."
answers = [{ name = "direction", find = "A.after.angle_to_loc_deg", accept = "awrt 3sf" }]
marks = [{ code = "M1", for = "direction A" }, { code = "A1", for = "A.after.angle_to_loc_deg" }]
[reference]
m = "2"
c = "1"
"#;

#[test]
fn a_requirement_on_what_is_determined_turns_away_what_leaves_the_rest_open() {
    // Of two equal spheres in an elastic impact A stops, unless it moves across the line.
    for (requirement, open, turned_away) in [("m > 0", 1, 0), ("A.after.speed > 0", 0, 1)] {
        let question = question(&RESTING.replace("REQUIREMENT", requirement));
        let census = enumerate(&question, &question.styles[0], &|_| (), &|_| ());
        let of = |reason: &Unfit| census.unfit.get(reason).copied().unwrap_or(0);
        assert_eq!((of(&Unfit::Underdetermined), of(&Unfit::Results(0))), (open, turned_away), "{requirement}");
        assert_eq!(census.fit, 8, "{requirement}");
    }
}
