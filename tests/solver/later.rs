//! Impacts that come one after another, before a judge who knows three formulas and no law: what two spheres do along the
//! line of centres, that nothing happens across it, and how a wall throws a sphere back.

use std::collections::BTreeMap;

use carom::answer::Accept;
use carom::expr::{Angles, written};
use carom::mechanics::{
    Axis, Because, Derivation, Given, Meeting, Moment, Quantity, Scene, SceneText, Setting, Sphere, Then, Velocity,
};
use carom::number::{Fraction, Value};
use carom::solve::{Solution, report, solve, solve_all};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

type Vector = [Fraction; 2];

/// What strikes what, and along which line.
#[derive(Clone, Copy, Debug)]
enum Blow {
    Spheres(usize, usize),
    Wall(usize),
}

/// Bodies on the plane, each with its mass and its velocity.
#[derive(Clone)]
struct Bodies(Vec<(Fraction, Vector)>);

fn dot(a: &Vector, b: &Vector) -> Fraction {
    &(&a[0] * &b[0]) + &(&a[1] * &b[1])
}

impl Bodies {
    /// After a blow; nothing if they do not approach. The line is of length 5, so that it has whole components.
    fn struck(&mut self, blow: Blow, line: &Vector, e: &Fraction) -> Option<()> {
        let square = dot(line, line);
        let along = |velocity: &Vector| dot(velocity, line);
        let changed = |velocity: &Vector, by: Fraction| {
            let by = &by / &square;
            [&velocity[0] + &(&by * &line[0]), &velocity[1] + &(&by * &line[1])]
        };
        let grown = &Fraction::ONE + e;
        match blow {
            Blow::Wall(place) => {
                let velocity = self.0[place].1.clone();
                if along(&velocity).is_zero() {
                    return None;
                }
                let by = &grown * &along(&velocity);
                self.0[place].1 = changed(&velocity, -by);
            }
            Blow::Spheres(one, other) => {
                let [(m, u), (k, v)] = [self.0[one].clone(), self.0[other].clone()];
                let approach = &along(&u) - &along(&v);
                if approach.sign().is_le() {
                    return None;
                }
                let share = &(&grown * &approach) / &(&m + &k);
                self.0[one].1 = changed(&u, -(&share * &k));
                self.0[other].1 = changed(&v, &share * &m);
            }
        }
        Some(())
    }
}

/// A chain of impacts as it is written down, and what the judge says of each.
struct Chain {
    text: SceneText,
    blows: Vec<Blow>,
    after: Vec<Bodies>,
}

const E: [&str; 5] = ["0", "1/3", "1/2", "3/4", "1"];
const NAMES: [&str; 3] = ["A", "B", "C"];

fn fraction(text: &str) -> Fraction {
    text.parse().unwrap()
}

fn strings(vector: &Vector) -> [String; 2] {
    vector.clone().map(|component| component.to_string())
}

/// A chain in which every impact takes place, or none if these numbers make none.
fn chain(numbers: &mut ChaCha8Rng, in_a_line: bool) -> Option<Chain> {
    let mut whole = |low: i64, high: i64| numbers.random_range(low..=high);
    let lines: &[[i64; 2]] = if in_a_line { &[[5, 0]] } else { &[[5, 0], [0, 5], [3, 4], [-4, 3], [3, -4]] };
    let velocity = |x: i64, y: i64| [Fraction::from(x), Fraction::from(if in_a_line { 0 } else { y })];
    let masses: Vec<i64> = (0..3).map(|_| whole(1, 6)).collect();
    let start: Vec<Vector> = (0..3).map(|_| velocity(whole(-6, 6), whole(-6, 6))).collect();
    let mut bodies = Bodies(masses.iter().map(|mass| Fraction::from(*mass)).zip(start.iter().cloned()).collect());
    let mut table: BTreeMap<String, serde_json::Value> = BTreeMap::new();
    let mut then = Vec::new();
    let (mut blows, mut after) = (Vec::new(), Vec::new());
    let mut seen = vec![0, 1];
    for number in 0..4 {
        let first = number == 0;
        let place = if first { 0 } else { seen[whole(0, seen.len() as i64 - 1) as usize] };
        let blow = match whole(0, 2) {
            // Along one line spheres keep their order, and C begins to the right of the others.
            _ if first => Blow::Spheres(0, 1),
            0 => Blow::Wall(place),
            1 if !seen.contains(&2) => Blow::Spheres(1, 2),
            _ if seen.contains(&2) && whole(0, 1) == 0 => Blow::Spheres(1, 2),
            _ => Blow::Spheres(0, 1),
        };
        // On one line a sphere reaches a wall only if no other lies before it.
        if let (Blow::Wall(place), true) = (&blow, in_a_line) {
            let is_to_the_right = bodies.0[*place].1[0].sign().is_gt();
            if *place != if is_to_the_right { seen.len() - 1 } else { 0 } {
                return None;
            }
        }
        let line = lines[whole(0, lines.len() as i64 - 1) as usize].map(Fraction::from);
        let e = E[whole(0, 4) as usize];
        bodies.struck(blow, &line, &fraction(e))?;
        let is_new = matches!(blow, Blow::Spheres(_, 2)) && !seen.contains(&2);
        let written = |velocity: &Vector| match in_a_line {
            true => serde_json::json!(velocity[0].to_string()),
            false => serde_json::json!(strings(velocity)),
        };
        let mut here = serde_json::Map::new();
        here.insert("e".into(), e.into());
        match blow {
            Blow::Wall(_) => {
                let wall = [-line[1].clone(), line[0].clone()];
                here.insert("wall".into(), serde_json::json!(strings(&wall)));
            }
            Blow::Spheres(..) if !in_a_line => {
                here.insert("line_of_centres".into(), serde_json::json!(strings(&line)));
                here.insert("sense".into(), "A_to_B".into());
            }
            Blow::Spheres(..) => {}
        }
        if first {
            here.insert("masses".into(), serde_json::json!({"A": masses[0].to_string(), "B": masses[1].to_string()}));
            here.insert("before".into(), serde_json::json!({"A": written(&start[0]), "B": written(&start[1])}));
            table.extend(here);
        } else {
            let of: Vec<&str> = match blow {
                Blow::Wall(place) => vec![NAMES[place]],
                Blow::Spheres(one, other) => vec![NAMES[one], NAMES[other]],
            };
            here.insert("of".into(), serde_json::json!(of));
            if is_new {
                here.insert("mass".into(), masses[2].to_string().into());
                here.insert("before".into(), written(&start[2]));
                seen.push(2);
            }
            then.push(serde_json::Value::Object(here));
        }
        blows.push(blow);
        after.push(bodies.clone());
    }
    table.insert("then".into(), then.into());
    let text = serde_json::from_value(serde_json::json!(table)).unwrap();
    Some(Chain { text, blows, after })
}

/// Judges one impact, and what is asked of it.
type Judge<'j> = &'j mut dyn FnMut(&Solution, &[(Quantity, Accept)]) -> Result<(), String>;

/// Every impact of a chain as a scene by itself, which begins with the velocities that the ones before have left; each is
/// handed to a judge with what is asked of it, and what the chain found is what it finds.
pub fn each_by_itself(chain: &Solution, asked: &[(Quantity, Accept)], judge: Judge) -> Result<(), String> {
    let scene = chain.scene();
    let mut left: BTreeMap<Sphere, [Value; 2]> = BTreeMap::new();
    let first = Then { meeting: Meeting::FIRST, scene: Scene { then: Vec::new(), ..scene.clone() } };
    for then in std::iter::once(&first).chain(&scene.then) {
        let meeting = then.meeting;
        let mut alone = then.scene.clone();
        let who: Vec<Sphere> = if alone.setting.is_of_one() { vec![Sphere::A] } else { Sphere::BOTH.to_vec() };
        for part in &who {
            if alone.before[*part as usize].is_none() {
                let given = left[&meeting.sphere(*part)].clone().map(|value| Given { shown: written(&value), value });
                let [x, y] = given;
                alone.before[*part as usize] = Some(Velocity::Components(x, y));
            }
        }
        let in_law = |quantity: Quantity| match meeting.number {
            0 => Some(quantity).filter(|quantity| quantity.impact() == 0),
            _ => meeting.in_law(quantity),
        };
        let here: Vec<(Quantity, Accept)> =
            asked.iter().filter_map(|(quantity, accept)| Some((in_law(*quantity)?, accept.clone()))).collect();
        let after = |part| [Axis::X, Axis::Y].map(|axis| Quantity::Velocity(part, Moment::After, axis));
        let mut wanted: Vec<Quantity> = here.iter().map(|(quantity, _)| *quantity).collect();
        wanted.extend(who.iter().flat_map(|part| after(*part)));
        let by_itself = solve(&alone, &wanted).map_err(|refusal| format!("{meeting}: {refusal}"))?;
        judge(&by_itself, &here).map_err(|complaint| format!("{meeting}: {complaint}"))?;
        for (quantity, _) in &here {
            let found = (chain.number(meeting.quantity(*quantity)), chain.angle(meeting.quantity(*quantity)));
            let same = match (found, by_itself.number(*quantity), by_itself.angle(*quantity)) {
                ((Some(one), _), Some(other), _) => one.equals(&other),
                ((_, Some(one)), _, Some(other)) => one == other,
                _ => false,
            };
            if !same {
                return Err(format!("{meeting}: {quantity} is another by itself"));
            }
        }
        for part in who {
            let velocity = after(part).map(|quantity| by_itself.number(quantity));
            let [Some(x), Some(y)] = velocity else { return Err(format!("{meeting}: no velocity")) };
            left.insert(meeting.sphere(part), [x, y]);
        }
    }
    Ok(())
}

fn read(text: &SceneText) -> Scene {
    Scene::read(text, &(), Angles::Radians).unwrap_or_else(|faults| panic!("{faults:?}\n{}", json(text)))
}

fn json(text: &SceneText) -> String {
    serde_json::to_string(text).unwrap()
}

fn named(number: usize, name: &str, rest: &str) -> Quantity {
    let impact = ["", "second.", "third.", "fourth."][number];
    format!("{impact}{name}.{rest}").parse().unwrap()
}

fn everything(scene: &Scene, text: &SceneText) -> Solution {
    solve(scene, &scene.quantities().into_iter().filter(|quantity| !quantity.is_angle()).collect::<Vec<_>>())
        .or_else(|_| solve(scene, &velocities(scene)))
        .unwrap_or_else(|refusal| panic!("{refusal}\n{}", json(text)))
}

fn velocities(scene: &Scene) -> Vec<Quantity> {
    let is_velocity = |quantity: &Quantity| {
        matches!(quantity.of_its_impact(), Quantity::Velocity(_, Moment::After, Axis::X | Axis::Y))
    };
    scene.quantities().into_iter().filter(is_velocity).collect()
}

/// Every velocity after every impact is what the judge says.
fn agrees(chain: &Chain) {
    let scene = read(&chain.text);
    let solution = everything(&scene, &chain.text);
    for (number, (blow, bodies)) in chain.blows.iter().zip(&chain.after).enumerate() {
        let who: Vec<usize> = match blow {
            Blow::Wall(place) => vec![*place],
            Blow::Spheres(one, other) => vec![*one, *other],
        };
        for place in who {
            for (axis, expected) in ["x", "y"].into_iter().zip(&bodies.0[place].1) {
                let quantity = named(number, NAMES[place], &format!("after.{axis}"));
                let found = solution.number(quantity).unwrap_or_else(|| panic!("no {quantity}\n{}", json(&chain.text)));
                assert!(
                    found.equals(&Value::from(expected.clone())),
                    "{quantity} is {found:?} and not {expected}\n{}",
                    json(&chain.text)
                );
            }
        }
    }
}

#[test]
fn every_impact_of_a_chain_is_what_a_judge_with_three_formulas_says() {
    for in_a_line in [true, false] {
        let mut numbers = ChaCha8Rng::seed_from_u64(20);
        let chains: Vec<Chain> = (0..8000).filter_map(|_| chain(&mut numbers, in_a_line)).take(150).collect();
        assert_eq!(chains.len(), 150);
        // Each way of being struck comes up.
        for wanted in ["Wall", "Spheres(1, 2)", "Spheres(0, 1)"] {
            let comes = |chain: &&Chain| chain.blows[1..].iter().any(|blow| format!("{blow:?}").starts_with(wanted));
            assert!(chains.iter().filter(comes).count() > 10, "{wanted}");
        }
        chains.iter().for_each(agrees);
    }
}

/// The laws of a later impact are those of one impact: what it gives is what the same impact gives by itself.
#[test]
fn a_later_impact_is_the_impact_by_itself() {
    let mut numbers = ChaCha8Rng::seed_from_u64(21);
    let chains = (0..4000).filter_map(|_| chain(&mut numbers, false)).take(40);
    for chain in chains {
        let scene = read(&chain.text);
        let whole = everything(&scene, &chain.text);
        for (number, then) in scene.then.iter().enumerate() {
            let before = |part: Sphere| {
                let quantity = |axis| then.meeting.quantity(Quantity::Velocity(part, Moment::Before, axis));
                let mut known = whole.known().clone();
                Derivation::carry_out(&mut known, &[quantity(Axis::X), quantity(Axis::Y)]);
                [Axis::X, Axis::Y].map(|axis| known.number(quantity(axis)).unwrap())
            };
            let text = &chain.text.then[number];
            let written = |part| before(part).map(|value| value.as_fraction().unwrap().to_string());
            let mass = |part: Sphere| {
                let quantity = then.meeting.quantity(Quantity::Mass(part));
                whole.number(quantity).and_then(|value| value.as_fraction().cloned()).map(|mass| mass.to_string())
            };
            let of_one = then.scene.setting == Setting::Wall;
            let b = (!of_one).then(|| (mass(Sphere::B), written(Sphere::B)));
            let alone: SceneText = serde_json::from_value(serde_json::json!({
                "masses": {"A": mass(Sphere::A), "B": b.as_ref().and_then(|(mass, _)| mass.clone())},
                "before": {"A": written(Sphere::A), "B": b.map(|(_, velocity)| velocity)},
                "wall": text.wall, "line_of_centres": text.line_of_centres, "sense": text.sense, "e": text.e,
            }))
            .unwrap();
            let one = read(&alone);
            let asked = ["impulse.magnitude", "ke.lost", "A.ke_lost", "A.after.speed", "A.impulse.x", "approach"];
            let asked = asked.map(|name| name.parse::<Quantity>().unwrap());
            let expected = solve(&one, &asked).unwrap_or_else(|refusal| panic!("{refusal}\n{}", json(&alone)));
            for quantity in asked {
                let later = then.meeting.quantity(quantity);
                let found = solve(&scene, &[later]).unwrap().number(later).unwrap();
                assert!(found.equals(&expected.number(quantity).unwrap()), "{later}\n{}", json(&chain.text));
            }
        }
    }
}

#[test]
fn what_cannot_happen_later_is_refused_with_the_impact_at_which_it_cannot() {
    let refused = |then: &str| {
        let text = format!(
            r#"{{"masses": {{"A": "1", "B": "2"}}, "before": {{"A": "6", "B": "0"}}, "e": "1/2", "then": [{then}]}}"#
        );
        solve(read(&serde_json::from_str(&text).unwrap()), &[]).map(drop)
    };
    // A is at rest then, and B goes on with 3.
    let again = refused(r#"{"of": ["A", "B"], "e": "1/2"}"#).unwrap_err();
    assert_eq!(again.because, Because::Impossible);
    assert!(again.reason.starts_with("at the second impact: "), "{}", again.reason);
    let faster = refused(r#"{"of": ["B", "C"], "mass": "1", "before": "5", "e": "1/2"}"#).unwrap_err();
    assert!(faster.reason.starts_with("at the second impact: "), "{}", faster.reason);
    assert!(faster.reason.contains("from B to C, B moves 2 slower than C"), "{}", faster.reason);
    let wall = refused(r#"{"of": ["A"], "wall": ["0", "1"], "e": "1/2"}"#).unwrap_err();
    assert!(wall.reason.starts_with("at the second impact: "), "{}", wall.reason);
    refused(r#"{"of": ["B", "C"], "mass": "1", "before": "2", "e": "1/2"}"#).unwrap();
}

/// At a wall there is no B: whoever comes later is new, whatever the name and however the velocity is given.
#[test]
fn who_is_new_after_a_wall_comes_with_the_velocity_that_is_given() {
    let printed = |name: &str, before: &str| {
        let text = format!(
            r#"{{"masses": {{"A": "2"}}, "before": {{"A": ["3", "-4"]}}, "wall": ["1", "0"], "e": "1/2",
            "then": [{{"of": ["A", "{name}"], "mass": "1", "before": {before}, "line_of_centres": ["1", "0"], "e": "1/2"}}]}}"#
        );
        let scene = read(&serde_json::from_str(&text).unwrap());
        let report = report(&solve_all(&scene, &scene.quantities()).unwrap()[0]);
        let exact = |(quantity, answer): (&String, &serde_json::Value)| {
            let quantity = quantity.replace(&format!("{name}."), "other.");
            (quantity, answer["exact"].clone())
        };
        report.quantities.iter().map(exact).collect::<BTreeMap<_, _>>()
    };
    let expected = printed("C", r#"["-5", "0"]"#);
    assert_eq!(expected["second.other.before.x"], "-5");
    for name in ["B", "C"] {
        for before in [r#"["-5", "0"]"#, r#"{"speed": "5", "angle_deg": "180"}"#] {
            assert_eq!(printed(name, before), expected, "{name} with {before}");
        }
    }
}

#[test]
fn a_range_counts_what_must_hold_at_every_impact() {
    // A goes on with 2 and B with 4; B comes back with 4f, and they meet again whatever f is: unless B were to stay.
    let text = r#"{"masses": {"A": "1", "B": "2"}, "before": {"A": "6", "B": "0"}, "e": "1", "symbols": {"f": "unit"},
        "unknowns": ["f"], "conditions": ["second.B.after.n < A.after.n"],
        "then": [{"of": ["B"], "wall": ["0", "1"], "e": "f"}]}"#;
    let solution = solve(read(&serde_json::from_str(text).unwrap()), &[]).unwrap();
    let range = carom::expr::print::plain(&solution.range().unwrap().written());
    // After an elastic impact A has -2 and B has 4: B catches it if 4f > 2.
    assert_eq!(range, "1/2 < f <= 1");
}
