//! One table of impacts, `tests/data/impacts.toml`, over the derivation and every method, in every kind of number.
//!
//! An engine that does not run a case needs a reason beside it; a reason that is no longer true fails too.

use std::collections::BTreeMap;

use carom::expr::{Angles, Meaning, Turn, degrees, number, read as read_expr};
use carom::mechanics::{Derivation, Quantity, SceneText, VelocityText, pose};
use carom::method::{After, Found, Impact, METHODS, Method, Promise, Role, solve_once};
use carom::number::{Angle, Fraction, Interval, Letter, Number, Range, Value};
use serde::Deserialize;

use super::agreement::turned_into;
use super::scenes::{AFTER, read};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    impact: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    name: String,
    scene: SceneText,
    /// The components of A and of B.
    after: BTreeMap<String, [String; 2]>,
    /// Any other quantities.
    #[serde(default)]
    also: BTreeMap<String, String>,
    /// Why an engine, or a kind of number, does not run it.
    #[serde(default)]
    skip: BTreeMap<String, String>,
}

fn meaning(symbols: &BTreeMap<String, String>, name: &str) -> Option<Meaning> {
    let range = symbols.get(name)?;
    let (_, range) = Range::DECLARED.into_iter().find(|(word, _)| word == range)?;
    let letter = Letter::new(name, range)?;
    Some(match range {
        Range::Acute => Meaning::Angle(Turn::of(Angle::of(&Value::letter(letter), &Value::ONE)?)),
        _ => Meaning::Number(Value::letter(letter)),
    })
}

pub fn value(text: &str, symbols: &BTreeMap<String, String>) -> Value {
    let expr = read_expr(text, Angles::Radians).unwrap_or_else(|fault| panic!("{text}: {}", fault.message));
    number(&expr, &|name| meaning(symbols, name)).unwrap_or_else(|fault| panic!("{text}: {}", fault.message))
}

pub fn turn(text: &str, symbols: &BTreeMap<String, String>) -> Turn {
    let expr = read_expr(text, Angles::Radians).unwrap_or_else(|fault| panic!("{text}: {}", fault.message));
    degrees(&expr, &|name| meaning(symbols, name)).unwrap_or_else(|fault| panic!("{text}: {}", fault.message))
}

/// What a method needs, if the case gives all of it outright.
fn impact(case: &Case) -> Option<Impact<Value>> {
    let scene = &case.scene;
    let at = |text: &String| value(text, &scene.symbols);
    let velocity = |velocity: &Option<VelocityText<String>>| {
        Some(match velocity.as_ref()? {
            VelocityText::Along(along) => [at(along), Value::ZERO],
            VelocityText::Components(both) => both.each_ref().map(at),
            VelocityText::Polar(polar) => {
                let speed = at(&polar.speed);
                match (&polar.angle_deg, &polar.cos, &polar.sin) {
                    (Some(angle), ..) => {
                        let direction = turn(angle, &scene.symbols).direction()?;
                        [&speed * &direction.cos, &speed * &direction.sin]
                    }
                    (_, Some(cos), Some(sin)) => [&speed * &at(cos), &speed * &at(sin)],
                    _ => return None,
                }
            }
        })
    };
    scene.sense?;
    Some(Impact {
        masses: [at(scene.masses.a.as_ref()?), at(scene.masses.b.as_ref()?)],
        before: [velocity(&scene.before.a)?, velocity(&scene.before.b)?],
        line: scene.line_of_centres.as_ref()?.each_ref().map(at),
        restitution: at(scene.e.as_ref()?),
    })
}

fn derivation<N: Number>(case: &Case, into: impl Fn(&Value) -> Option<N>) -> Option<After<N>> {
    let scene = read(&serde_json::to_value(&case.scene).unwrap());
    let given = pose(&scene).ok()?;
    // Planned in exact numbers, where it is known which steps exist.
    let (plan, _) = Derivation::carry_out(&mut given.clone(), &AFTER);
    let mut known = turned_into(&given, into)?;
    plan.evaluate(&mut known).ok()?;
    let [a_x, a_y, b_x, b_y] = known.numbers(AFTER)?;
    Some([[a_x, a_y], [b_x, b_y]])
}

/// What an engine says of a case.
#[derive(Debug)]
enum Verdict {
    Right,
    Wrong(String),
    /// It did not run, and gives this reason of its own, if any.
    Idle(Option<String>),
}

/// How far from the truth an exhibit may be, as a share of the larger speed: simulations are not expected to be right.
const EXHIBITED: f64 = 0.1;

/// How far a float may be from the truth.
fn allowed(method: &dyn Method, fastest: f64) -> f64 {
    match (method.promises(), method.role()) {
        (Promise::Scaled(roundoffs), _) => roundoffs * f64::EPSILON / 2.0 * fastest,
        (_, Role::Exhibit) => EXHIBITED * fastest,
        _ => 1e-12 * fastest.max(1.0),
    }
}

/// The larger speed before.
fn fastest(impact: &Impact<Value>) -> f64 {
    let size = |[x, y]: &[Value; 2]| x.to_f64().unwrap().hypot(y.to_f64().unwrap());
    impact.before.iter().map(size).fold(0.0, f64::max)
}

/// What a method says of an impact.
fn verdict(method: &dyn Method, impact: &Impact<Value>, truth: &[Value]) -> Verdict {
    let found = match solve_once(method, impact) {
        Ok(found) => found,
        Err(skip) => return Verdict::Idle(Some(skip.why)),
    };
    let right = match &found {
        Found::Exact(after) => exact(after, truth),
        Found::Enclosed(after) => enclosed(after, truth),
        Found::Float(after) => {
            let allowed = allowed(method, fastest(impact));
            let near = |(found, truth): (&f64, &Value)| (found - truth.to_f64().unwrap()).abs() <= allowed;
            after.as_flattened().iter().zip(truth).all(near)
        }
        Found::Missed(why) => return Verdict::Idle(Some(why.clone())),
    };
    if right { Verdict::Right } else { Verdict::Wrong(format!("{found:?}")) }
}

fn exact(after: &After<Value>, truth: &[Value]) -> bool {
    after.as_flattened().iter().zip(truth).all(|(found, truth)| found.equals(truth))
}

/// Do intervals hold the truth, and are they narrow?
fn enclosed(after: &After<Interval>, truth: &[Value]) -> bool {
    let holds = |(found, truth): (&Interval, &Value)| {
        found.width() < Fraction::new(1, 1 << 40) && found.overlaps(&truth.enclose_constant(200).unwrap())
    };
    after.as_flattened().iter().zip(truth).all(holds)
}

/// What each engine says of the case, the derivation first.
fn verdicts(case: &Case) -> BTreeMap<String, Verdict> {
    let truth: Vec<Value> = ["A", "B"]
        .iter()
        .flat_map(|sphere| case.after[*sphere].each_ref().map(|c| value(c, &case.scene.symbols)))
        .collect();
    let float = |after: &After<f64>| {
        let near = |found: f64, truth: f64| (found - truth).abs() <= 1e-12 * truth.abs().max(1.0);
        after.as_flattened().iter().zip(&truth).all(|(found, truth)| near(*found, truth.to_f64().unwrap()))
    };
    let mut verdicts = BTreeMap::new();
    let mut derived = |kind: &str, right: Option<bool>| {
        let verdict = match right {
            Some(true) => Verdict::Right,
            Some(false) => Verdict::Wrong(String::new()),
            None => Verdict::Idle(None),
        };
        verdicts.insert(format!("derivation/{kind}"), verdict);
    };
    derived("exact", derivation(case, |value| Some(value.clone())).map(|after| exact(&after, &truth)));
    let certified = derivation(case, |value| value.enclose_constant(128));
    derived("interval", certified.map(|after| enclosed(&after, &truth)));
    derived("float", derivation(case, Value::to_f64).map(|after| float(&after)));
    let impact = impact(case);
    for method in METHODS {
        let verdict = match &impact {
            Some(impact) => verdict(*method, impact, &truth),
            None => Verdict::Idle(None),
        };
        verdicts.insert(method.name().to_owned(), verdict);
    }
    verdicts
}

/// The keys under which a skip of an engine may stand.
fn skip_keys(engine: &str) -> [&str; 2] {
    [engine, engine.split_once('/').map_or("methods", |(_, kind)| kind)]
}

#[test]
fn carom_knows_the_table_of_impacts_by_every_method() {
    let table: Table = toml::from_str(include_str!("../data/impacts.toml")).unwrap();
    let mut complaints = Vec::new();
    for case in &table.impact {
        let verdicts = verdicts(case);
        let mut idle: Vec<&String> = case.skip.keys().collect();
        for (engine, verdict) in &verdicts {
            let skip = skip_keys(engine).into_iter().find(|key| case.skip.contains_key(*key));
            match (verdict, skip) {
                (Verdict::Right, None) | (Verdict::Idle(Some(_)), None) => {}
                (Verdict::Idle(None), Some(used)) => idle.retain(|key| key.as_str() != used),
                (Verdict::Right, Some(_)) => {
                    complaints.push(format!("{}: {engine} can do it, though skipped", case.name))
                }
                (Verdict::Wrong(found), _) => complaints.push(format!("{}: {engine} is wrong: {found}", case.name)),
                (Verdict::Idle(None), None) => {
                    complaints.push(format!("{}: {engine} does not run it, and no reason is given", case.name))
                }
                (Verdict::Idle(Some(why)), Some(_)) => {
                    complaints.push(format!("{}: {engine} says itself why it does not: {why}", case.name))
                }
            }
        }
        complaints.extend(idle.iter().map(|key| format!("{}: the skip of `{key}` is idle", case.name)));
        also(case, &mut complaints);
    }
    assert!(table.impact.len() >= 25, "a table of {}", table.impact.len());
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// Other quantities that the case states, exactly, from the solver.
fn also(case: &Case, complaints: &mut Vec<String>) {
    let scene = read(&serde_json::to_value(&case.scene).unwrap());
    for (name, text) in &case.also {
        let quantity: Quantity = name.parse().unwrap_or_else(|_| panic!("{name}"));
        let right = carom::solve::solve(&scene, &[quantity]).map(|solution| match solution.angle(quantity) {
            Some(angle) => angle.is_degrees(&text.parse().unwrap()),
            None => solution.number(quantity).unwrap().equals(&value(text, &case.scene.symbols)),
        });
        match right {
            Ok(true) => {}
            Ok(false) => complaints.push(format!("{}: {name} is not {text}", case.name)),
            Err(refusal) => complaints.push(format!("{}: {name}: {refusal}", case.name)),
        }
    }
}

#[test]
fn carom_knows_the_line_of_centres_and_the_ratio_of_masses_from_four_velocities() {
    use carom::mechanics::Quantity;
    use carom::number::Value;
    let scene = |after_b: [&str; 2]| {
        let json = serde_json::json!({"before": {"A": ["4", "2"], "B": ["-1", "-4"]},
            "after": {"A": ["1", "2"], "B": after_b}});
        read(&json)
    };
    let asked = [Quantity::MassRatio, Quantity::Restitution];
    let solution = carom::solve::solve(scene(["2", "-4"]), &asked).unwrap();
    // B's change of 3 i answers A's change of -3 i; separation 1 over approach 5.
    assert_eq!(solution.number(Quantity::MassRatio), Some(Value::ONE));
    assert_eq!(solution.number(Quantity::Restitution), Some(Value::fraction(1, 5)));
    for (after_b, reason) in [(["2", "-3"], "perpendicular"), (["-2", "-4"], "no positive masses")] {
        let refusal = carom::solve::solve(scene(after_b), &asked).unwrap_err();
        assert!(refusal.reason.contains(reason), "{}", refusal.reason);
    }
}

#[test]
fn carom_says_of_what_cannot_happen_what_e_would_be_and_which_masses_are_not_positive() {
    let reason = |json: serde_json::Value| carom::solve::solve(read(&json), &[]).unwrap_err().reason;
    let into_b = serde_json::json!({"masses": {"A": "2", "B": "3"}, "before": {"A": ["3", "1"], "B": ["0", "0"]},
        "after": {"A": ["2", "1"]}, "line_of_centres": ["1", "0"], "e": "0"});
    // B has 2/3 then, and the separation is -4/3 of an approach of 3.
    assert!(reason(into_b.clone()).contains("is −4/3, which is negative (e would be −4/9)"), "{}", reason(into_b));
    for (a, b) in [("k-1", "1-k"), ("1-k", "k-1"), ("k", "-k-1")] {
        let letters = serde_json::json!({"masses": {"A": a, "B": b}, "before": {"A": ["3", "1"], "B": ["0", "0"]},
            "line_of_centres": ["1", "0"], "e": "1/2", "symbols": {"k": "real"}});
        assert_eq!(reason(letters), "the masses of A and B are not both positive");
    }
}
