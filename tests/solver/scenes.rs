//! Random impacts, from a named generator and a seed, so that a failure comes back on every machine.

use std::collections::BTreeMap;

use carom::expr::{Angles, print, written};
use carom::mechanics::{Axis, Moment, Quantity, Refusal, Scene, SceneText, Sphere};
use carom::number::Value;
use carom::solve::{Solution, solve};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use serde_json::{Value as Json, json};

pub fn generator(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// The kinds of number that a scene is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Rational,
    Surd,
    Degrees,
    Letters,
}

/// A forward scene by components, every number an expression.
#[derive(Clone, Debug)]
pub struct Forward {
    pub masses: [String; 2],
    pub before: [[String; 2]; 2],
    pub line: [String; 2],
    pub e: String,
}

const LETTERS: [(&str, &str); 5] =
    [("m", "positive"), ("u", "positive"), ("v", "positive"), ("e", "unit"), ("alpha", "acute")];

impl Forward {
    pub fn json(&self) -> Json {
        let [m_a, m_b] = &self.masses;
        let [a, b] = &self.before;
        let mut scene = json!({ "masses": {"A": m_a, "B": m_b}, "before": {"A": a, "B": b},
            "line_of_centres": self.line, "sense": "A_to_B", "e": self.e });
        let symbols: BTreeMap<&str, &str> = LETTERS.into_iter().collect();
        scene["symbols"] = json!(symbols);
        scene
    }

    pub fn solve(&self, asked: &[Quantity]) -> Result<Solution, Refusal> {
        solve(read(&self.json()), asked)
    }

    /// Every component put through a change, each with its sphere and its partner.
    pub fn with_vectors(&self, change: impl Fn(&[String; 2]) -> [String; 2]) -> Forward {
        Forward { before: [change(&self.before[0]), change(&self.before[1])], line: change(&self.line), ..self.clone() }
    }

    pub fn turned_round(&self) -> Forward {
        Forward { line: self.line.each_ref().map(|c| format!("-({c})")), ..self.clone() }
    }
}

pub fn read(json: &Json) -> Scene {
    let text: SceneText = serde_json::from_value(json.clone()).unwrap_or_else(|fault| panic!("{fault}\n{json}"));
    Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|faults| panic!("{faults:?}\n{json}"))
}

/// A scene in which the spheres approach; the line of centres is turned round where they would not.
pub fn random(kind: Kind, random: &mut ChaCha8Rng) -> Forward {
    loop {
        let scene = attempt(kind, random);
        if scene.solve(&[]).is_ok() {
            return scene;
        }
        let turned = scene.turned_round();
        if turned.solve(&[]).is_ok() {
            return turned;
        }
    }
}

fn one_of(options: &[&str], random: &mut ChaCha8Rng) -> String {
    options[random.random_range(0..options.len())].to_string()
}

fn rational(random: &mut ChaCha8Rng) -> String {
    format!("{}/{}", random.random_range(-9..=9), random.random_range(1..=3))
}

fn attempt(kind: Kind, random: &mut ChaCha8Rng) -> Forward {
    let surds = ["sqrt(2)", "2*sqrt(3)", "1+sqrt(2)", "-sqrt(5)", "sqrt(3)-1", "sqrt(6)/3"];
    let positive = |random: &mut ChaCha8Rng| format!("{}/{}", random.random_range(1..=9), random.random_range(1..=3));
    let lines = [["1", "0"], ["0", "1"], ["1", "2"], ["3", "-4"], ["1", "1"], ["-5", "12"]];
    let line = lines[random.random_range(0..lines.len())].map(str::to_string);
    let mut e = one_of(&["0", "1", "1/2", "1/3", "3/4", "2/5", "0.25"], random);
    let mut masses = [positive(random), positive(random)];
    let mut before = [[rational(random), rational(random)], [rational(random), rational(random)]];
    if random.random_range(0..6) == 0 {
        before[1] = ["0", "0"].map(str::to_string);
    }
    match kind {
        Kind::Rational => {}
        Kind::Surd => {
            before[0][0] = one_of(&surds, random);
            before[1][random.random_range(0..2)] = one_of(&surds, random);
            if random.random_range(0..3) == 0 {
                e = one_of(&["sqrt(2)/3", "sqrt(3)/2"], random);
            }
        }
        Kind::Degrees => {
            let (speed, angle) = (random.random_range(1..=9), random.random_range(-180..=180));
            before[0] = [format!("{speed}*cos({angle}*deg)"), format!("{speed}*sin({angle}*deg)")];
        }
        Kind::Letters => {
            masses = [["m", "m"], ["m", "2*m"], ["3*m", "m"]][random.random_range(0..3)].map(str::to_string);
            let paths = [["u*cos(alpha)", "u*sin(alpha)"], ["u", "2*u"], ["3*u", "-u"]];
            before[0] = paths[random.random_range(0..3)].map(str::to_string);
            let others = [["0", "0"], ["0", "0"], ["-u", "0"], ["-v", "u"]];
            before[1] = others[random.random_range(0..4)].map(str::to_string);
            e = one_of(&["e", "e", "1/2", "1"], random);
            return Forward { masses, before, line: ["1", "0"].map(str::to_string), e };
        }
    }
    Forward { masses, before, line, e }
}

/// The components after the impact of A and B along i and j.
pub const AFTER: [Quantity; 4] = [
    Quantity::Velocity(Sphere::A, Moment::After, Axis::X),
    Quantity::Velocity(Sphere::A, Moment::After, Axis::Y),
    Quantity::Velocity(Sphere::B, Moment::After, Axis::X),
    Quantity::Velocity(Sphere::B, Moment::After, Axis::Y),
];

/// A value as a scene has it.
pub fn plain(value: &Value) -> String {
    print::plain(&written(value))
}
