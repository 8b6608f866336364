//! Each slip of each law leads to the wrong value that students with that slip hand in.
//!
//! `tests/data/slip-values.json` holds those values, found with formulas of their own; its rules are in
//! capitals, and the table below says which slip of which law each one is.

use carom::mechanics::{Derivation, Known, Law, Moment, Quantity, Sphere, pose};
use carom::number::{Angle, Value};

use crate::seed::scene_of;

/// Rule in the data, law and slip.
const SLIPS: [(&str, &str, &str); 17] = [
    ("SINCOS_SWAP", "resolve", "sincos-swap"),
    ("NOT_RESOLVED", "resolve", "not-resolved"),
    ("E_ON_PERP_TOO", "perpendicular", "e-on-perpendicular"),
    ("PERP_DROPPED", "perpendicular", "perpendicular-dropped"),
    ("CLM_SIGN", "momentum", "momentum-sign"),
    ("CLM_IGNORES_B", "momentum", "momentum-ignores-b"),
    ("MASSES_SWAPPED", "momentum", "masses-swapped"),
    ("MASSES_OMITTED", "momentum", "masses-omitted"),
    ("E_WRONG_SIDE", "restitution", "e-wrong-side"),
    ("NEL_APPROACH_SUBTRACTED", "restitution", "approach-subtracted"),
    ("NEL_SEPARATION_ADDED", "restitution", "separation-added"),
    ("NEL_REVERSED", "restitution", "restitution-reversed"),
    ("NEL_IGNORES_B", "restitution", "restitution-ignores-b"),
    ("E_TAKEN_AS_1", "restitution", "e-taken-as-1"),
    ("COALESCE", "restitution", "coalesce"),
    ("SPEED_SUM_OF_COMPONENTS", "speed", "speed-sum"),
    ("SPEED_NO_SQRT", "speed", "speed-no-root"),
];

/// Where the data means another working than the derivation, and why.
fn skipped(exercise: &str, name: &str, rule: &str) -> Option<&'static str> {
    match (exercise, name, rule) {
        ("10" | "11" | "15", _, "SINCOS_SWAP" | "NOT_RESOLVED") => Some("components are given: nothing is resolved"),
        (_, "ke_lost", "E_ON_PERP_TOO" | "PERP_DROPPED") => Some("the derivation leaves out what does not change"),
        (_, "ke_lost", "SINCOS_SWAP") => Some("there the energy before is that of the given speeds"),
        (_, "ke_lost" | "impulse", "NOT_RESOLVED") => Some("there only the two equations take the full speeds"),
        (_, "impulse", "SINCOS_SWAP") => Some("there the change of momentum takes the true component"),
        _ => None,
    }
}

fn quantity(name: &str) -> Option<Quantity> {
    let after = Moment::After;
    Some(match name {
        "speed_A" => Quantity::Speed(Sphere::A, after),
        "speed_B" => Quantity::Speed(Sphere::B, after),
        "angle_A" => Quantity::AngleToLine(Sphere::A, after),
        "ke_lost" => Quantity::EnergyLost,
        "impulse" => Quantity::ImpulseMagnitude,
        _ => return None,
    })
}

fn value(known: &Known<Value>, quantity: Quantity) -> Option<f64> {
    if let Some(number) = known.number(quantity) {
        return number.to_f64();
    }
    let (y, x) = known.direction(quantity)?;
    Angle::of(&y, &x)?.enclose(96, &|_| None).map(|degrees| degrees.to_f64())
}

#[test]
fn carom_knows_the_wrong_value_of_every_slip() {
    let data: serde_json::Value = serde_json::from_str(include_str!("../data/slip-values.json")).unwrap();
    let (mut compared, mut differences) = (0, Vec::new());
    for exercise in ["1", "2", "3", "7", "8", "10", "11", "15"] {
        let posed = pose(&scene_of(&format!("5C-{exercise}"))).unwrap();
        for (name, rules) in data[format!("Q{exercise}")].as_object().unwrap() {
            let Some(asked) = quantity(name) else { continue };
            let (derivation, _) = Derivation::carry_out(&mut posed.clone(), &[asked]);
            for (rule, law, slip) in SLIPS {
                let Some(expected) = rules.get(rule).and_then(serde_json::Value::as_f64) else { continue };
                if skipped(exercise, name, rule).is_some() {
                    continue;
                }
                let law = Law::ALL.iter().find(|known| known.name() == law).unwrap();
                assert!(law.slips().iter().any(|known| known.tag == slip), "{slip}");
                let mut known = posed.clone();
                if derivation.evaluate_slipped(*law, slip, &mut known).is_err() {
                    continue;
                }
                let found = value(&known, asked).unwrap();
                compared += 1;
                if (found.abs() - expected.abs()).abs() > 1e-9 * (1.0 + expected.abs()) {
                    differences.push(format!("5C-{exercise} {name} {rule}: {found} for {expected}"));
                }
            }
        }
    }
    assert!(compared > 150, "{compared}");
    assert!(differences.is_empty(), "{compared} compared\n{}", differences.join("\n"));
}
