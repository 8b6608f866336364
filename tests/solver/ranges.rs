//! Ranges of an unknown: inside every value makes happen what was said, outside none does.

use carom::expr::print;
use carom::mechanics::Quantity;
use carom::number::{Fraction, Value};
use carom::solve::solve;
use serde_json::{Value as Json, json};

use super::scenes::read;

/// A scene, what is asked of it, and the values for which it is so.
fn cases() -> Vec<(&'static str, Json, &'static str)> {
    let e = json!({ "e": "unit" });
    let k = json!({ "k": "positive", "m": "positive", "u": "positive" });
    let direct = |a: &str, b: &str, before: [&str; 2], e: Json, symbols: &Json, unknown: &str, condition: &str| {
        json!({
            "masses": { "A": a, "B": b }, "before": { "A": before[0], "B": before[1] }, "e": e,
            "symbols": symbols, "unknowns": [unknown], "conditions": [condition]
        })
    };
    vec![
        ("A turns back", direct("2", "3", ["5", "0"], json!("e"), &e, "e", "A.after.x < 0"), "2/3 < e <= 1"),
        ("A goes on or stops", direct("2", "3", ["5", "0"], json!("e"), &e, "e", "A.after.x >= 0"), "0 <= e <= 2/3"),
        (
            "at most half is lost",
            direct("1", "1", ["4", "0"], json!("e"), &e, "e", "ke.fraction_lost <= 1/4"),
            "1/2*sqrt(2) <= e <= 1",
        ),
        (
            "A goes on, masses km and m",
            direct("k*m", "m", ["u", "-u"], json!("1/2"), &k, "k", "A.after.x > 0"),
            "k > 2",
        ),
        ("both go A's way", direct("k*m", "m", ["u", "-u"], json!("1/2"), &k, "k", "A.after.x >= 0"), "k >= 2"),
        (
            "e is at most 1",
            json!({
                "masses": { "A": "k*m", "B": "m" }, "before": { "A": "3*u", "B": "u" }, "after": { "A": "u" },
                "symbols": k, "unknowns": ["k"], "conditions": ["e <= 1"]
            }),
            "0 < k <= 1",
        ),
        (
            "an oblique impact",
            json!({
                "masses": { "A": "1", "B": "2" }, "before": { "A": ["3", "4"], "B": ["0", "0"] },
                "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "e", "symbols": e, "unknowns": ["e"],
                "conditions": ["A.after.n < 0"]
            }),
            "1/2 < e <= 1",
        ),
        (
            "B has a mass",
            json!({
                "masses": { "A": "m", "B": null }, "before": { "A": "k*u", "B": "0" }, "after": { "A": "2*u", "B": "3*u" },
                "symbols": k, "unknowns": ["k"], "conditions": ["e <= 1"]
            }),
            "k > 2",
        ),
        ("A has a mass", direct("3-k", "1", ["2", "0"], json!("1/2"), &k, "k", "A.after.x < 0"), "5/2 < k < 3"),
        (
            "a wall",
            json!({
                "before": { "A": ["3", "-4"] }, "wall": ["1", "0"], "e": "e", "symbols": e, "unknowns": ["e"],
                "conditions": ["A.after.tan_to_wall > 1"]
            }),
            "3/4 < e <= 1",
        ),
    ]
}

/// Angles between two bounds, or with surds in the components.
fn of_angles() -> Vec<(&'static str, Json, &'static str)> {
    let sixty = json!({ "speed": "6", "angle_deg": "60" });
    let mut with_surds = oblique("3", &["0", "0"], "A.after.tan_to_loc > 2");
    with_surds["masses"]["A"] = "2".into();
    with_surds["before"] = json!({ "A": sixty, "B": { "speed": "4", "angle_deg": "150" } });
    vec![
        ("turned through more than a right angle", oblique("5", &["4", "3"], "A.deflection_deg > 90"), "7/8 < e <= 1"),
        ("an angle with the line", oblique("5", &["4", "2"], "A.after.angle_to_loc_deg < 45"), "4/5 < e <= 1"),
        (
            "an angle on either side of a right one",
            oblique("2", &["3", "1"], "60 <= A.after.angle_to_loc_deg"),
            "1/2 - sqrt(3)/6 <= e <= 1/2 + sqrt(3)/6",
        ),
        ("a tangent of surds", with_surds, "0 <= e < 5*sqrt(3)/6 - 1"),
    ]
}

/// A of mass 1 strikes B at rest.
fn oblique(mass: &str, before: &[&str; 2], condition: &str) -> Json {
    json!({
        "masses": { "A": "1", "B": mass }, "before": { "A": before, "B": ["0", "0"] }, "line_of_centres": ["1", "0"],
        "sense": "A_to_B", "e": "e", "symbols": { "e": "unit" }, "unknowns": ["e"], "conditions": [condition]
    })
}

#[test]
fn carom_knows_from_where_to_where() {
    for (name, scene, expected) in cases().into_iter().chain(of_angles()) {
        let solution = solve(read(&scene), &[]).unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
        let values = solution.range().unwrap_or_else(|| panic!("{name}"));
        let written = print::plain(&values.written());
        assert_eq!(written.replace("sqrt(2)/2", "1/2*sqrt(2)"), expected, "{name}");
    }
}

/// Puts numbers in the place of the letter and looks: what was said happens inside the range and not outside of it.
#[test]
fn carom_knows_that_it_happens_inside_and_not_outside() {
    let mut tried = [0, 0];
    for (name, scene, _) in cases() {
        let solution = solve(read(&scene), &[]).unwrap();
        let values = solution.range().unwrap();
        let letter = scene["unknowns"][0].as_str().unwrap();
        let condition = scene["conditions"][0].as_str().unwrap();
        let (quantity, relation, right) = split(condition);
        let top = if letter == "e" { 40 } else { 160 };
        for step in 0..=top {
            let value = Fraction::new(step, 40);
            if letter != "e" && step == 0 {
                continue;
            }
            let mut scene = scene.clone();
            let text = format!("({})", print::plain(&carom::expr::written(&Value::from(value.clone()))));
            let put = |text_of: &mut Json| {
                if let Some(formula) = text_of.as_str() {
                    let parts: Vec<&str> = formula.split(letter).collect();
                    *text_of = parts.join(&text).into();
                }
            };
            for (field, part) in
                ["masses", "before", "after"].into_iter().flat_map(|field| [(field, "A"), (field, "B")])
            {
                if let Some(given) = scene.get_mut(field).and_then(|pair| pair.get_mut(part)) {
                    put(given);
                }
            }
            put(&mut scene["e"]);
            for field in ["unknowns", "conditions"] {
                scene.as_object_mut().unwrap().remove(field);
            }
            for empty in ["masses", "e"] {
                if scene[empty].is_null()
                    || scene[empty].as_object().is_some_and(|masses| masses.values().all(Json::is_null))
                {
                    scene.as_object_mut().unwrap().remove(empty);
                }
            }
            let happens = match solve(read(&scene), &[quantity]) {
                Err(_) => false,
                Ok(found) => {
                    let sign = (&found.number(quantity).unwrap() - &right).sign().unwrap();
                    match relation {
                        "<" => sign.is_lt(),
                        "<=" => sign.is_le(),
                        ">" => sign.is_gt(),
                        _ => sign.is_ge(),
                    }
                }
            };
            let at = Value::from(value.clone());
            let above = values.span.low.as_ref().is_none_or(|low| {
                let sign = (&at - &low.value).sign().unwrap();
                sign.is_gt() || (low.included && sign.is_eq())
            });
            let below = values.span.high.as_ref().is_none_or(|high| {
                let sign = (&high.value - &at).sign().unwrap();
                sign.is_gt() || (high.included && sign.is_eq())
            });
            assert_eq!(happens, above && below, "{name}: {letter} = {step}/40");
            tried[usize::from(happens)] += 1;
        }
    }
    assert!(tried[0] > 100 && tried[1] > 100, "{tried:?}");
}

fn split(condition: &str) -> (Quantity, &str, Value) {
    let parts: Vec<&str> = condition.split(' ').collect();
    let [left, relation, right] = parts[..] else { panic!("{condition}") };
    let right: Vec<i64> = right.split('/').map(|part| part.parse().unwrap()).collect();
    let right = Value::fraction(right[0], right.get(1).copied().unwrap_or(1));
    (left.parse().unwrap(), relation, right)
}

#[test]
fn carom_says_why_there_is_no_range() {
    let with = |unknown: &str, condition: &str| {
        json!({
            "masses": { "A": "2", "B": "3" }, "before": { "A": "5", "B": "0" }, "e": "e", "symbols": { "e": "unit" },
            "unknowns": [unknown], "conditions": [condition]
        })
    };
    let refusal = |condition: &str| solve(read(&with("e", condition)), &[]).unwrap_err().to_string();
    assert_eq!(refusal("A.after.x < 10"), "the conditions hold whatever e is");
    assert_eq!(refusal("A.after.x > 10"), "the conditions hold for no value of e");
    // B has 2(1 + e) after, which is at most 4.
    assert_eq!(refusal("B.after.x >= 4"), "the conditions hold for one value of e alone, 1");
    assert!(refusal("A.after.angle_from_n_deg > 10").contains("angle"), "{}", refusal("A.after.angle_from_n_deg > 10"));
    // A has 2 - 3e after.
    let mut of_k = with("e", "A.after.x > k");
    of_k["symbols"]["k"] = "positive".into();
    let refusal = solve(read(&of_k), &[]).unwrap_err();
    assert_eq!(refusal.reason, "a range of e with ends in terms of k is not found here");
    // Momentum alone makes k = 1.
    let over = |condition: &str| {
        json!({
            "masses": { "A": "k", "B": "1" }, "before": { "A": "2", "B": "0" }, "after": { "A": "1/2", "B": "3/2" },
            "symbols": { "k": "positive" }, "unknowns": ["k"], "conditions": [condition]
        })
    };
    for condition in ["ke.after > 1", "ke.after > 100", "ke.after < 2"] {
        let refusal = solve(read(&over(condition)), &[]).unwrap_err();
        assert!(refusal.reason.contains("more is given than the impact needs"), "{condition}: {refusal}");
        assert!(refusal.help.is_some_and(|help| help.contains("leave out the inequality")), "{condition}");
    }
}

/// A scene with e to be found from a condition.
fn with_e(condition: &str) -> Json {
    json!({
        "masses": { "A": "2", "B": "3" }, "before": { "A": "5", "B": "0" }, "e": "e", "symbols": { "e": "unit" },
        "unknowns": ["e"], "conditions": [condition]
    })
}

#[test]
fn carom_knows_that_a_set_may_end_where_a_square_root_does() {
    for (condition, expected) in [
        ("A.after.x < 20 + sqrt(1 - 4*e)", "0 <= e <= 1/4"),
        ("A.after.x < 20 + sqrt(4*e - 1)", "1/4 <= e <= 1"),
        ("A.after.x < 1 + sqrt(1 - 2*e)", "0 < e <= 1/2"),
    ] {
        let solution = solve(read(&with_e(condition)), &[]).unwrap_or_else(|refusal| panic!("{condition}: {refusal}"));
        assert_eq!(print::plain(&solution.range().unwrap().written()), expected, "{condition}");
    }
}

/// The working by which an unknown was found, as one text.
fn said(scene: &Json) -> String {
    let solution = solve(read(scene), &[]).unwrap_or_else(|refusal| panic!("{scene}: {refusal}"));
    let mut text = String::new();
    for line in solution.finding() {
        text.push_str(&print::text_unicode(&line.words));
        text.push('\n');
        for equation in &line.equations {
            text.push_str(&format!("    {}\n", print::unicode(equation)));
        }
    }
    text
}

#[test]
fn carom_takes_no_side_of_approach_where_the_unknown_decides_it() {
    let at_wall = |k: &str| {
        json!({
            "before": { "A": ["3", "-k"] }, "wall": ["1", "0"], "e": "1/2", "symbols": { "k": k },
            "unknowns": ["k"], "conditions": ["A.after.speed < 5"]
        })
    };
    let refusal = solve(read(&at_wall("real")), &[]).unwrap_err();
    assert_eq!(refusal.reason, "from which side the bodies approach depends on k");
    let solution = solve(read(&at_wall("positive")), &[]).unwrap();
    assert_eq!(print::plain(&solution.range().unwrap().written()), "0 < k < 8");
}

#[test]
fn carom_says_what_each_end_of_a_range_comes_from() {
    let k = json!({ "k": "positive", "m": "positive", "u": "positive" });
    let given_after = |condition: &str| {
        json!({
            "masses": { "A": "k*m", "B": "m" }, "before": { "A": "5*u", "B": "0" }, "after": { "A": "2*u" },
            "symbols": k, "unknowns": ["k"], "conditions": [condition]
        })
    };
    // The other end is that of the condition, and is not said twice.
    let text = said(&given_after("e <= 1"));
    assert!(text.contains("The coefficient of restitution is not negative:\n    (3k − 2)/5 ≥ 0\n"), "{text}");
    assert_eq!(text.matches("at most 1").count(), 1, "{text}");
    // e is derived, though no condition speaks of it.
    let text = said(&given_after("B.after.x > 3*u"));
    assert!(text.contains("The coefficient of restitution is at most 1:\n    (3k − 2)/5 ≤ 1\n"), "{text}");
    assert!(text.contains("    e = (3k − 2)/5\n"), "{text}");
    assert!(!text.contains("not negative"), "{text}");
    let text = said(&json!({
        "masses": { "A": "3-k", "B": "1" }, "before": { "A": "2", "B": "0" }, "e": "1/2", "symbols": { "k": "positive" },
        "unknowns": ["k"], "conditions": ["A.after.x < 0"]
    }));
    assert!(text.contains("The mass of A is positive:\n    3 − k > 0\n"), "{text}");
    let text = said(&json!({
        "before": { "A": ["3", "-k"] }, "wall": ["1", "0"], "e": "1/2", "symbols": { "k": "positive" },
        "unknowns": ["k"], "conditions": ["A.after.speed < 13/4"]
    }));
    assert!(!text.contains("spheres") && text.contains("0 < k < 5/2"), "{text}");
    // What a letter may be at all needs no line of its own.
    let text = said(&with_e("A.after.x < 0"));
    assert!(!text.contains("The coefficient of restitution is"), "{text}");
    assert!(text.contains("A coefficient of restitution is at most 1, so\n    2/3 < e ≤ 1\n"), "{text}");
    let text = said(&with_e("A.after.x >= 0"));
    assert!(text.contains("A coefficient of restitution is not negative, so\n    0 ≤ e ≤ 2/3\n"), "{text}");
}

#[test]
fn carom_says_that_a_quantity_is_largest_at_an_end() {
    let at_most = |e: Json, maximise: &str, masses: [&str; 2]| {
        json!({
            "masses": { "A": masses[0], "B": masses[1] }, "before": { "A": ["4", "1"], "B": ["0", "0"] },
            "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": e, "symbols": { "e": "unit" }, "unknowns": ["e"],
            "maximise": maximise
        })
    };
    // It grows with e all the way: w = 4(1 + e)/3.
    let text = said(&at_most(json!("e"), "B.after.speed", ["1", "2"]));
    assert!(text.contains("The rate of change of the speed of B after the impact with e is positive"), "{text}");
    assert!(text.contains("so it is largest at the end e = 1 of the range:\n    4/3 > 0\n"), "{text}");
    // 4(1 - 2e)/3 falls all the way.
    let text = said(&at_most(json!("e"), "A.after.n", ["1", "2"]));
    assert!(text.contains("is negative, so it is largest at the end e = 0 of the range:\n    −8/3 < 0\n"), "{text}");
    // What is left of the energy is 17/2 - 16(1 - e^2)/3; at e = 0 alone it does not grow.
    let text = said(&at_most(json!("e"), "ke.after", ["1", "2"]));
    assert!(
        text.contains("is never negative, so it is largest at the end e = 1 of the range:\n    32e/3 ≥ 0\n"),
        "{text}"
    );
    // The energy lost is largest where its rate of change is nought indeed, though that is an end as well.
    let text = said(&at_most(json!("e"), "ke.lost", ["1", "2"]));
    assert!(text.contains("Where it is largest, this is zero:\n    −32e/3 = 0\n"), "{text}");
    // The component of A, 4(2 - 3e)/5, is nought in between: its speed falls and grows again.
    let text = said(&at_most(json!("e"), "A.after.speed", ["2", "3"]));
    let words = "Where its rate of change with e is nought, and at the ends of the range, the speed of A after the impact is \
                 1 for e = 2/3, √89/5 for e = 0, √41/5 for e = 1.";
    assert!(text.contains(words), "{text}");
    // Neither is nought there.
    for maximise in ["B.after.speed", "A.after.speed", "A.after.n", "ke.after"] {
        let text = said(&at_most(json!("e"), maximise, ["2", "3"]));
        assert!(!text.contains("its rate of change is nought"), "{text}");
    }
}
