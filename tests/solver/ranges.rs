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
            "a wall",
            json!({
                "before": { "A": ["3", "-4"] }, "wall": ["1", "0"], "e": "e", "symbols": e, "unknowns": ["e"],
                "conditions": ["A.after.tan_to_wall > 1"]
            }),
            "3/4 < e <= 1",
        ),
    ]
}

#[test]
fn carom_knows_from_where_to_where() {
    for (name, scene, expected) in cases() {
        let solution = solve(&read(&scene), &[]).unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
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
        let solution = solve(&read(&scene), &[]).unwrap();
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
            for part in ["A", "B"] {
                put(&mut scene["masses"][part]);
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
            let happens = match solve(&read(&scene), &[quantity]) {
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
    let refusal = |condition: &str| solve(&read(&with("e", condition)), &[]).unwrap_err().to_string();
    assert_eq!(refusal("A.after.x < 10"), "the conditions hold whatever e is");
    assert_eq!(refusal("A.after.x > 10"), "the conditions hold for no value of e");
    assert!(refusal("A.after.angle_to_loc_deg > 10").contains("angle"), "{}", refusal("A.after.angle_to_loc_deg > 10"));
}
