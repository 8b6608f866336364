//! A scene with letters in the place of what is to be found, and with what was found in the place of letters.

use std::cmp::Ordering;

use super::Sphere;
use super::scene::{Contact, Given, Scene, Velocity};
use crate::expr::{Expr, Turn, print, written, written_angle};
use crate::number::{Angle, Letter, Range, Root, Value};

/// `e`, `A.mass` and `B.mass` among the unknowns stand where the scene leaves a gap.
pub fn with_letters(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for letter in scene.unknowns.clone() {
        let given = Given {
            value: Value::letter(letter),
            shown: Expr::name(letter.name().replace(".mass", "").replace('A', "m_A").replace('B', "m_B")),
        };
        match letter.name() {
            "e" if scene.restitution.is_none() => {
                scene.restitution = Some(Given { value: given.value, shown: Expr::name("e") });
            }
            "A.mass" if scene.masses[0].is_none() => scene.masses[0] = Some(given),
            "B.mass" if scene.masses[1].is_none() => scene.masses[1] = Some(given),
            _ => {}
        }
        if !scene.letters.contains(&letter) {
            scene.letters.push(letter);
        }
    }
    let (masses, letters) = (scene.masses.clone(), scene.letters.clone());
    for then in &mut scene.then {
        then.scene.letters.clone_from(&letters);
        for (part, sphere) in Sphere::BOTH.into_iter().zip(then.meeting.of) {
            let mass = masses.get(sphere as usize).cloned().flatten();
            let own = &mut then.scene.masses[part as usize];
            // A wall has the part of a sphere, and no mass.
            let is_wall = then.meeting.with_wall && part == Sphere::B;
            *own = own.take().or(mass.filter(|_| !is_wall));
        }
    }
    scene
}

fn values_of(scene: &mut Scene) -> Vec<&mut Value> {
    let mut values = Vec::new();
    for given in scene.masses.iter_mut().flatten().chain(&mut scene.restitution) {
        values.push(&mut given.value);
    }
    for velocity in scene.before.iter_mut().chain(&mut scene.after).flatten() {
        match velocity {
            Velocity::Components(x, y) => values.extend([&mut x.value, &mut y.value]),
            Velocity::Polar { speed, cos, sin, .. } => values.extend([&mut speed.value, cos, sin]),
        }
    }
    values.extend(scene.impulse.iter_mut().flatten().map(|given| &mut given.value));
    match &mut scene.contact {
        Some(Contact::Along(x, y, _)) => values.extend([x, y]),
        Some(Contact::Offset { offset, sum, .. }) => values.extend([&mut offset.value, &mut sum.value]),
        Some(Contact::Apart(x, y, sum)) => values.extend([x, y, sum]),
        None => {}
    }
    values
}

pub(super) fn mentions(scene: &Scene, letter: Letter) -> bool {
    let in_one = values_of(&mut scene.clone()).iter().any(|value| value.has_letter(|own| *own == letter));
    in_one || scene.then.iter().any(|then| mentions(&then.scene, letter))
}

/// The scene with unknowns replaced; `None` if a value does not exist there.
pub(super) fn substituted(scene: &Scene, unknowns: &[Letter], values: &[Value]) -> Option<Scene> {
    let mut scene = scene.clone();
    for value in values_of(&mut scene) {
        for (unknown, replacement) in unknowns.iter().zip(values) {
            *value = value.substitute(*unknown, replacement)?;
        }
    }
    let shown = |given: &mut Given| {
        let names = given.shown.names().into_iter().map(|name| name.text.clone()).collect::<Vec<_>>();
        if unknowns.iter().any(|unknown| names.iter().any(|name| name == unknown.name() || name.starts_with("m_"))) {
            given.shown = written(&given.value);
        }
    };
    scene.masses.iter_mut().flatten().chain(&mut scene.restitution).for_each(shown);
    scene.impulse.iter_mut().flatten().for_each(shown);
    for velocity in scene.before.iter_mut().chain(&mut scene.after).flatten() {
        match velocity {
            Velocity::Components(x, y) => [x, y].into_iter().for_each(shown),
            Velocity::Polar { speed, cos, sin, angle } => {
                shown(speed);
                let unknown = |name: &str| unknowns.iter().any(|unknown| unknown.name() == name);
                if angle.as_ref().is_some_and(|(_, expr)| expr.names().iter().any(|name| unknown(&name.text))) {
                    *angle = Angle::of(sin, cos).map(|angle| (Turn::of(angle.clone()), written_angle(&angle)));
                }
            }
        }
    }
    if let Some(Contact::Offset { offset, sum, .. }) = &mut scene.contact {
        [offset, sum].into_iter().for_each(shown);
    }
    for then in &mut scene.then {
        then.scene = substituted(&then.scene, unknowns, values)?;
    }
    scene.letters.retain(|letter| !unknowns.contains(letter));
    scene.unknowns.clear();
    scene.conditions.clear();
    scene.maximise = None;
    Some(scene)
}

/// `e = 1/2`, or for an angle `theta = 30°`.
pub(super) fn in_words(unknowns: &[Letter], values: &[Value]) -> String {
    let one = |(letter, value): (&Letter, &Value)| {
        let shown = match (letter.range(), Angle::of(value, &Value::ONE)) {
            (Range::Acute, Some(angle)) => written_angle(&angle),
            _ => written(value),
        };
        format!("{} = {}", letter.name(), print::unicode(&shown))
    };
    unknowns.iter().zip(values).map(one).collect::<Vec<_>>().join(", ")
}

/// An unknown must lie in its range; where that depends on other letters it becomes a remark.
pub(super) fn in_range(unknown: Letter, value: &Value, remarks: &mut Vec<String>) -> Result<(), String> {
    let name = unknown.name();
    let sign = value.sign();
    for root in value.roots() {
        if let Root::Nested { radicand, .. } = root
            && radicand.sign().is_none()
            && radicand.square_root_of_square().is_none()
        {
            remarks.push(format!("this needs {} > 0", print::unicode(&written(&radicand))));
        }
    }
    match unknown.range() {
        Range::Positive if sign.is_some_and(Ordering::is_le) => Err(format!("{name} is positive")),
        Range::Acute if sign.is_some_and(Ordering::is_le) => Err(format!("{name} is an acute angle, more than 0°")),
        Range::Unit if sign == Some(Ordering::Less) => Err(format!("{name} is not negative")),
        Range::Unit if (value - &Value::ONE).sign() == Some(Ordering::Greater) => {
            Err(format!("{name} is at most 1, or the impact would create kinetic energy"))
        }
        // That a coefficient of restitution is one is looked at where the scene is solved.
        Range::Positive | Range::Acute if sign.is_none() => {
            remarks.push(format!("this needs {} > 0", print::unicode(&written(value))));
            Ok(())
        }
        _ => Ok(()),
    }
}
