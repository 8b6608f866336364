//! Laws that hold for every impact, on random exact scenes: fractions, surds, given degrees and letters.
//!
//! The scenes come from a loop of our own and a seed instead of a library of strategies: they are long made by one
//! generator that the agreement tests use too, and a scene is short enough to read without being shrunk.

use carom::mechanics::Quantity;
use carom::number::Value;
use carom::solve::Solution;

use super::scenes::{AFTER, Forward, Kind, generator, plain, random};

const KINDS: [(Kind, usize); 4] = [(Kind::Rational, 150), (Kind::Surd, 60), (Kind::Degrees, 40), (Kind::Letters, 60)];

/// Runs a law over random scenes of every kind; the scene stands in the message if it fails.
fn for_every_scene(seed: u64, law: impl Fn(&Forward) -> Result<(), String>) {
    for (kind, count) in KINDS {
        let mut numbers = generator(seed);
        for _ in 0..count {
            let scene = random(kind, &mut numbers);
            if let Err(complaint) = law(&scene) {
                panic!("{complaint}\n{}", scene.json());
            }
        }
    }
}

fn solved(scene: &Forward, asked: &[Quantity]) -> Solution {
    scene.solve(asked).unwrap_or_else(|refusal| panic!("{refusal}\n{}", scene.json()))
}

fn after(scene: &Forward) -> [Value; 4] {
    let solution = solved(scene, &AFTER);
    AFTER.map(|quantity| solution.number(quantity).unwrap_or_else(|| panic!("no {quantity}\n{}", scene.json())))
}

fn named(scene: &Forward, names: &[&str]) -> Vec<Value> {
    let asked: Vec<Quantity> = names.iter().map(|name| name.parse().expect(name)).collect();
    let solution = solved(scene, &asked);
    asked.iter().map(|quantity| solution.number(*quantity).unwrap_or_else(|| panic!("no {quantity}"))).collect()
}

fn same(what: &str, found: &Value, expected: &Value) -> Result<(), String> {
    if found.equals(expected) { Ok(()) } else { Err(format!("{what}: {} and not {}", plain(found), plain(expected))) }
}

fn all_same(what: &str, found: &[Value], expected: &[Value]) -> Result<(), String> {
    found.iter().zip(expected).try_for_each(|(found, expected)| same(what, found, expected))
}

#[test]
fn carom_knows_that_momentum_is_kept_as_a_vector() {
    for_every_scene(1, |scene| {
        for axis in ["x", "y"] {
            let names = ["A.mass", "B.mass"].map(str::to_string).into_iter();
            let parts = ["A.before", "B.before", "A.after", "B.after"].map(|state| format!("{state}.{axis}"));
            let names: Vec<String> = names.chain(parts).collect();
            let values = named(scene, &names.iter().map(String::as_str).collect::<Vec<_>>());
            let [m_a, m_b, a, b, x, y] = values.as_slice() else { unreachable!() };
            same("momentum", &(&(m_a * x) + &(m_b * y)), &(&(m_a * a) + &(m_b * b)))?;
        }
        Ok(())
    });
}

#[test]
fn carom_knows_what_energy_is_lost_and_that_none_is_gained() {
    for_every_scene(2, |scene| {
        let values = named(scene, &["A.mass", "B.mass", "approach", "e", "impulse.magnitude", "ke.lost"]);
        let [m_a, m_b, s, e, impulse, lost] = values.as_slice() else { unreachable!() };
        let reduced = (m_a * m_b).divided_by(&(m_a + m_b)).unwrap();
        let expected = &(&reduced * &(&Value::ONE - &(e * e))) * &(s * s);
        same("energy lost", &(lost + lost), &expected)?;
        let signed = &(&reduced * &(&Value::ONE + e)) * s;
        same("square of the impulse", &(impulse * impulse), &(&signed * &signed))?;
        // The sign is decided for numbers; in letters the formula above tells it.
        if lost.is_constant() && lost.sign().is_none_or(|sign| sign.is_lt()) {
            return Err(format!("energy gained: {}", plain(lost)));
        }
        Ok(())
    });
}

#[test]
fn carom_knows_that_an_elastic_impact_runs_backwards() {
    for_every_scene(3, |scene| {
        let elastic = Forward { e: "1".to_string(), ..scene.clone() };
        let [a_x, a_y, b_x, b_y] = after(&elastic).map(|value| plain(&-value));
        let reversed = Forward { before: [[a_x, a_y], [b_x, b_y]], ..elastic.clone() };
        let before = named(&elastic, &["A.before.x", "A.before.y", "B.before.x", "B.before.y"]);
        let back: Vec<Value> = after(&reversed).into_iter().map(|value| -value).collect();
        all_same("the start again", &back, &before)
    });
}

#[test]
fn carom_knows_that_the_names_of_the_spheres_do_not_matter() {
    for_every_scene(4, |scene| {
        let mut swapped = scene.turned_round();
        swapped.masses.swap(0, 1);
        swapped.before.swap(0, 1);
        let [a_x, a_y, b_x, b_y] = after(scene);
        all_same("A and B exchanged", &after(&swapped), &[b_x, b_y, a_x, a_y])
    });
}

#[test]
fn carom_knows_that_a_common_velocity_is_only_added() {
    for_every_scene(5, |scene| {
        let shift = ["7/3", "-2*sqrt(2)"];
        let added = |before: &[String; 2]| [0, 1].map(|axis| format!("({}) + {}", before[axis], shift[axis]));
        let moved = Forward { before: [added(&scene.before[0]), added(&scene.before[1])], ..scene.clone() };
        let [x, y] = [Value::fraction(7, 3), -&(&Value::from(2) * &Value::from(2).square_root().unwrap())];
        let [a_x, a_y, b_x, b_y] = after(scene);
        all_same("seen from a moving table", &after(&moved), &[&a_x + &x, &a_y + &y, &b_x + &x, &b_y + &y])
    });
}

#[test]
fn carom_knows_that_a_mirror_shows_an_impact() {
    for_every_scene(6, |scene| {
        let mirrored = scene.with_vectors(|[x, y]| [x.clone(), format!("-({y})")]);
        let [a_x, a_y, b_x, b_y] = after(scene);
        all_same("in the mirror", &after(&mirrored), &[a_x, -a_y, b_x, -b_y])
    });
}

#[test]
fn carom_knows_that_the_axes_may_be_turned() {
    for_every_scene(7, |scene| {
        let turned = scene.with_vectors(|[x, y]| [format!("3/5*({x}) - 4/5*({y})"), format!("4/5*({x}) + 3/5*({y})")]);
        let turn = |x: &Value, y: &Value| {
            let (c, s) = (Value::fraction(3, 5), Value::fraction(4, 5));
            [&(&c * x) - &(&s * y), &(&s * x) + &(&c * y)]
        };
        let [a_x, a_y, b_x, b_y] = after(scene);
        all_same("axes turned", &after(&turned), &[turn(&a_x, &a_y), turn(&b_x, &b_y)].concat())
    });
}

#[test]
fn carom_knows_how_an_impact_scales() {
    for_every_scene(8, |scene| {
        let heavier = Forward { masses: scene.masses.each_ref().map(|mass| format!("5/2*({mass})")), ..scene.clone() };
        let velocities = after(scene);
        all_same("masses scaled", &after(&heavier), &velocities)?;
        let lost = |scene: &Forward| named(scene, &["ke.lost"]).remove(0);
        same("energy lost of heavier spheres", &lost(&heavier), &(&Value::fraction(5, 2) * &lost(scene)))?;
        let quicker = |v: &[String; 2]| v.each_ref().map(|component| format!("3*({component})"));
        let faster = Forward { before: [quicker(&scene.before[0]), quicker(&scene.before[1])], ..scene.clone() };
        let expected = velocities.map(|value| &Value::from(3) * &value);
        all_same("speeds scaled", &after(&faster), &expected)?;
        same("energy lost of faster spheres", &lost(&faster), &(&Value::from(9) * &lost(scene)))
    });
}
