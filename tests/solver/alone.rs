//! One body alone, against a wall or under an impulse, before a judge that shares nothing with the laws.

use carom::answer::Accept;
use carom::mechanics::{Axis, Contact, Known, Moment, Quantity, Scene, Setting, Sphere, Velocity};
use carom::number::Value;
use carom::solve::Solution;

use super::judge::{Outcome, by_definition};
use super::variants::{near, rounds_to};

/// What happens to the body: its mass where it has one, and its velocities.
struct Path {
    mass: Value,
    before: [Value; 2],
    after: [Value; 2],
}

fn path(scene: &Scene, known: &Known<Value>) -> Option<Path> {
    let velocity = |moment| {
        Some(match scene.velocity(Sphere::A, moment) {
            Some(Velocity::Components(x, y)) => [x.value.clone(), y.value.clone()],
            Some(Velocity::Polar { speed, cos, sin, .. }) => [&speed.value * cos, &speed.value * sin],
            None => {
                let mut known = known.clone();
                let both = [Axis::X, Axis::Y].map(|axis| Quantity::Velocity(Sphere::A, moment, axis));
                carom::mechanics::Derivation::carry_out(&mut known, &both);
                known.numbers(both)?
            }
        })
    };
    // Where no mass is given nothing that depends on it is asked.
    let mass = scene.mass(Sphere::A).map_or(Value::ONE, |given| given.value.clone());
    Some(Path { mass, before: velocity(Moment::Before)?, after: velocity(Moment::After)? })
}

fn dot(a: &[Value; 2], b: &[Value; 2]) -> Value {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

fn change(path: &Path) -> [Value; 2] {
    [&path.after[0] - &path.before[0], &path.after[1] - &path.before[1]]
}

/// The law that is broken, exactly.
fn judge(scene: &Scene, path: &Path, known: &Known<Value>) -> Result<[Value; 2], String> {
    let change = change(path);
    match (scene.setting, &scene.contact) {
        (Setting::Wall, Some(Contact::Along(x, y, _))) => {
            let normal = [x.clone(), y.clone()];
            let e = match &scene.restitution {
                Some(given) => given.value.clone(),
                None => known.number(Quantity::Restitution).ok_or("no e")?,
            };
            if !(&(&change[0] * y) - &(&change[1] * x)).is_zero() {
                return Err("the component along the wall changes".to_owned());
            }
            let (towards, away) = (dot(&path.before, &normal), dot(&path.after, &normal));
            if towards.is_zero() || !(&away + &(&e * &towards)).is_zero() {
                return Err("restitution at the wall".to_owned());
            }
            if e.sign().is_some_and(|sign| sign.is_lt()) || (&Value::ONE - &e).sign().is_some_and(|sign| sign.is_lt()) {
                return Err("0 <= e <= 1".to_owned());
            }
            let towards_it = towards.sign().is_none_or(|sign| sign.is_gt());
            Ok(if towards_it { normal } else { normal.map(|component| -component) })
        }
        (Setting::Impulse, None) => {
            for (given, change) in scene.impulse.iter().flatten().zip(&change) {
                if !(&given.value - &(&path.mass * change)).is_zero() {
                    return Err("the impulse is not the change of momentum".to_owned());
                }
            }
            Ok(change)
        }
        _ => Err("not one body".to_owned()),
    }
}

/// All checks of one body, with what is asked of it.
pub fn check(solution: &Solution, asked: &[(Quantity, Accept)]) -> Result<(), String> {
    let scene = solution.scene();
    let path = path(scene, solution.known()).ok_or("no velocities")?;
    let line = judge(scene, &path, solution.known())?;
    let samples = [1, 2].map(|number| move |value: &Value| super::variants::in_sample(value, number));
    for float in samples {
        let pair = |pair: &[Value; 2]| Some([float(&pair[0])?, float(&pair[1])?]);
        let case = || {
            Some(Outcome {
                // What is in the place of the other sphere stands still.
                masses: [float(&path.mass)?, 1.0],
                before: [pair(&path.before)?, [0.0; 2]],
                after: [pair(&path.after)?, [0.0; 2]],
                line: pair(&line)?,
                e: 0.0,
                lost: 0.0,
            })
        };
        let case = case().ok_or("no doubles")?;
        for (quantity, accept) in asked {
            let expected = match quantity {
                // By what it is, and not by what was found.
                Quantity::Restitution => {
                    -case.after[0].iter().zip(case.line).map(|(v, n)| v * n).sum::<f64>()
                        / case.before[0].iter().zip(case.line).map(|(v, n)| v * n).sum::<f64>()
                }
                other => by_definition(*other, &case).ok_or_else(|| format!("{quantity}?"))?,
            };
            let (exact, printed) = match (solution.number(*quantity), solution.angle(*quantity)) {
                (Some(value), _) => (float(&value), accept.places().map(|places| value.rounded(places))),
                (None, Some(angle)) => {
                    let degrees = || Some(float(angle.y())?.atan2(float(angle.x())?).to_degrees());
                    (degrees(), accept.places().map(|places| angle.rounded(places)))
                }
                (None, None) => return Err(format!("no {quantity}")),
            };
            let exact = exact.ok_or("no double")?;
            if !near(exact, expected) {
                return Err(format!("{quantity}: {exact} and not {expected}"));
            }
            if let (Some(places), Some(Ok(printed))) = (accept.places(), printed)
                && !rounds_to(printed.to_fraction().to_f64(), places, expected)
            {
                return Err(format!("{quantity}, printed: {printed} and not {expected}"));
            }
        }
    }
    Ok(())
}

#[test]
fn carom_knows_that_this_judge_complains_of_a_broken_law() {
    use super::scenes::read;
    let wall = serde_json::json!({
        "masses": { "A": "2" }, "before": { "A": ["3", "-4"] }, "wall": ["1", "0"], "e": "1/2", "after": { "A": ["3", "2"] }
    });
    let scene = read(&wall);
    let mut path = path(&scene, &Known::default()).unwrap();
    assert!(judge(&scene, &path, &Known::default()).is_ok());
    path.after[1] = Value::from(3);
    assert_eq!(judge(&scene, &path, &Known::default()), Err("restitution at the wall".to_owned()));
    path.after = [Value::from(2), Value::from(2)];
    assert_eq!(judge(&scene, &path, &Known::default()), Err("the component along the wall changes".to_owned()));
}

fn refusal(scene: serde_json::Value) -> String {
    let refusal = carom::solve::solve(super::scenes::read(&scene), &[]).map(drop).unwrap_err();
    [refusal.reason, refusal.help.unwrap_or_default()].join("; ")
}

#[test]
fn carom_knows_that_an_impulse_is_the_change_of_momentum() {
    use serde_json::json;
    let along = json!({
        "masses": { "A": "2" }, "before": { "A": ["1", "0"] }, "after": { "A": ["5", "0"] }, "impulse": ["1", "0"]
    });
    assert_eq!(refusal(along), "along i the impulse is 1, but the momentum of A changes by 8; ");
    let across = json!({
        "masses": { "A": "2" }, "before": { "A": ["1", "0"] }, "after": { "A": ["5", "3"] }, "impulse": ["8", "5"]
    });
    assert_eq!(refusal(across), "along j the impulse is 5, but the momentum of A changes by 6; ");
    let by_angle = json!({
        "masses": { "A": "2" }, "before": { "A": ["0", "0"] }, "after": { "A": { "speed": "2", "angle_deg": "30" } },
        "impulse": ["2", "2"]
    });
    assert_eq!(refusal(by_angle), "along i the impulse is 2, but the momentum of A changes by 2√3; ");
    let no_mass = json!({ "before": { "A": ["1", "0"] }, "after": { "A": ["5", "3"] }, "impulse": ["8", "5"] });
    assert_eq!(refusal(no_mass), "the impulse is not parallel to the change of the velocity of A; ");
    let backwards = json!({ "before": { "A": ["1", "0"] }, "after": { "A": ["5", "3"] }, "impulse": ["-8", "-6"] });
    assert_eq!(
        refusal(backwards),
        "the impulse is opposite to the change of the velocity of A: no positive mass does that; "
    );
    let kept = json!({
        "masses": { "A": "2" }, "before": { "A": ["1", "0"] }, "after": { "A": ["5", "3"] }, "impulse": ["8", "6"]
    });
    assert!(carom::solve::solve(super::scenes::read(&kept), &[]).is_ok());
}

#[test]
fn carom_refuses_an_impact_with_a_wall_in_words_for_a_wall() {
    use serde_json::json;
    let at_wall = |before: Option<[&str; 2]>, after: Option<[&str; 2]>, e: Option<&str>| {
        let mut scene = json!({ "wall": ["1", "0"] });
        for (field, velocity) in [("before", before), ("after", after)] {
            if let Some(velocity) = velocity {
                scene[field] = json!({ "A": velocity });
            }
        }
        if let Some(e) = e {
            scene["e"] = json!(e);
        }
        refusal(scene)
    };
    let down = Some(["3", "-4"]);
    let table = [
        (at_wall(Some(["3", "0"]), None, Some("1/2")), "the sphere moves parallel to the wall: it does not strike it"),
        (at_wall(None, Some(["3", "0"]), Some("1/2")), "the sphere moves parallel to the wall: it does not strike it"),
        (at_wall(Some(["0", "0"]), None, Some("1/2")), "the sphere is at rest before, so it does not strike the wall"),
        (
            at_wall(down, Some(["3", "-2"]), None),
            "A would still be moving into the wall: the velocity of A away from the wall is −2",
        ),
        (at_wall(down, Some(["3", "-2"]), None), "the sphere would pass through the wall, though kinetic energy falls"),
        (at_wall(down, None, Some("-1/2")), "is given as −1/2, which is negative"),
        (at_wall(down, Some(["2", "2"]), None), "A's velocity parallel to the wall would change from"),
        (at_wall(down, Some(["2", "2"]), None), "but a smooth wall exerts no force that way"),
        (
            at_wall(down, Some(["3", "3"]), Some("1/2")),
            "the velocity of A away from the wall is 3, but e times its velocity towards the wall is 2",
        ),
    ];
    let one_line = json!({ "masses": { "A": "1", "B": "1" }, "before": { "A": "1", "B": "2" }, "e": "1/2" });
    assert!(refusal(one_line).contains("check the signs: a velocity is positive from A towards B"));
    for (said, expected) in table {
        assert!(said.contains(expected), "{said}");
        for of_two in ["spheres", "line of centres", "approach", "separation", "B"] {
            assert!(!said.contains(of_two), "{said}");
        }
    }
}
