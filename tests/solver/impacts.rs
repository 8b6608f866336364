//! One table of impacts, `tests/data/impacts.toml`, over the derivation and every method, in every kind of number.
//!
//! An engine that does not run a case needs a reason beside it; a reason that is no longer true fails too.

use std::collections::BTreeMap;

use carom::expr::{Angles, Meaning, Turn, degrees, number, read as read_expr};
use carom::mechanics::{Derivation, Quantity, SceneText, VelocityText, pose};
use carom::method::{After, Impact, METHODS, Solve};
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

fn mapped<N>(impact: &Impact<Value>, into: impl Fn(&Value) -> Option<N> + Copy) -> Option<Impact<N>> {
    let both = |pair: &[Value; 2]| -> Option<[N; 2]> { Some([into(&pair[0])?, into(&pair[1])?]) };
    Some(Impact {
        masses: both(&impact.masses)?,
        before: [both(&impact.before[0])?, both(&impact.before[1])?],
        line: both(&impact.line)?,
        restitution: into(&impact.restitution)?,
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

fn by<N>(case: &Case, solve: Option<Solve<N>>, into: impl Fn(&Value) -> Option<N> + Copy) -> Option<After<N>> {
    solve?(&mapped(&impact(case)?, into)?)
}

/// What each engine that runs the case says of it: whether it is right.
fn verdicts(case: &Case) -> BTreeMap<String, Option<bool>> {
    let truth: Vec<Value> = ["A", "B"]
        .iter()
        .flat_map(|sphere| case.after[*sphere].each_ref().map(|c| value(c, &case.scene.symbols)))
        .collect();
    let exact = |after: After<Value>| after.as_flattened().iter().zip(&truth).all(|(found, truth)| found.equals(truth));
    let enclosed = |value: &Value| value.enclose_constant(128);
    let certified = |after: After<Interval>| {
        let narrow = |interval: &Interval| interval.width() < Fraction::new(1, 1 << 60);
        let pairs = after.as_flattened().iter().zip(&truth);
        pairs.into_iter().all(|(found, truth)| narrow(found) && found.overlaps(&truth.enclose_constant(200).unwrap()))
    };
    let float = |after: After<f64>| {
        let near = |found: f64, truth: f64| (found - truth).abs() <= 1e-12 * truth.abs().max(1.0);
        after.as_flattened().iter().zip(&truth).all(|(found, truth)| near(*found, truth.to_f64().unwrap()))
    };
    let mut verdicts = BTreeMap::new();
    verdicts.insert("derivation/exact".to_string(), derivation(case, |value| Some(value.clone())).map(exact));
    verdicts.insert("derivation/interval".to_string(), derivation(case, enclosed).map(certified));
    verdicts.insert("derivation/float".to_string(), derivation(case, Value::to_f64).map(float));
    for method in METHODS {
        let name = |kind: &str| format!("{}/{kind}", method.name);
        if method.exact.is_some() {
            verdicts.insert(name("exact"), by(case, method.exact, |value| Some(value.clone())).map(exact));
        }
        if method.certified.is_some() {
            verdicts.insert(name("interval"), by(case, method.certified, enclosed).map(certified));
        }
        if method.float.is_some() {
            verdicts.insert(name("float"), by(case, method.float, Value::to_f64).map(float));
        }
    }
    verdicts
}

#[test]
fn carom_knows_the_table_of_impacts_by_every_method() {
    let table: Table = toml::from_str(include_str!("../data/impacts.toml")).unwrap();
    let mut complaints = Vec::new();
    for case in &table.impact {
        let verdicts = verdicts(case);
        let mut idle: Vec<&String> = case.skip.keys().collect();
        for (engine, verdict) in &verdicts {
            let (method, kind) = engine.split_once('/').unwrap();
            let skip = [engine.as_str(), method, kind].into_iter().find(|key| case.skip.contains_key(*key));
            idle.retain(|key| !(Some(key.as_str()) == skip && verdict.is_none()));
            match (verdict, skip) {
                (Some(true), None) | (None, Some(_)) => {}
                (Some(true), Some(_)) => complaints.push(format!("{}: {engine} can do it, though skipped", case.name)),
                (Some(false), _) => complaints.push(format!("{}: {engine} is wrong", case.name)),
                (None, None) => {
                    complaints.push(format!("{}: {engine} does not run it, and no reason is given", case.name))
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
    let solution = carom::solve::solve(&scene(["2", "-4"]), &asked).unwrap();
    // B's change of 3 i answers A's change of -3 i; separation 1 over approach 5.
    assert_eq!(solution.number(Quantity::MassRatio), Some(Value::ONE));
    assert_eq!(solution.number(Quantity::Restitution), Some(Value::fraction(1, 5)));
    for (after_b, reason) in [(["2", "-3"], "perpendicular"), (["-2", "-4"], "no positive masses")] {
        let refusal = carom::solve::solve(&scene(after_b), &asked).unwrap_err();
        assert!(refusal.reason.contains(reason), "{}", refusal.reason);
    }
}
