//! Pythagoras: a speed from two perpendicular components, `v² = v_n² + v_t²`.

use super::{Shape, Seen, Here, Law, Line, Outcome, Rule, Show, Slip, number, rule, size, velocity, first_equation};
use crate::expr::{Expr, Function, Piece, written};
use crate::number::Value;
use crate::mechanics::Axis::{N, T, X, Y};
use crate::mechanics::{Moment, Quantity, Sphere};
use crate::number::Number;

pub const NAME: &str = "speed";

pub const SEEN: Seen = Seen::Value(
    &[Quantity::Speed(Sphere::A, Moment::After), Quantity::Speed(Sphere::B, Moment::After)],
    Shape::Pythagoras,
);

pub const ACCURACY: &str = "correct expression, unsimplified";

pub const METHOD: (&str, &str) = ("Pythagoras with their two components", "both components present");

pub const SLIPS: &[Slip] = &[
    Slip {
        place: 21,
        tag: "speed-sum",
        did: "added the two components",
        sentence: "The components are at right angles: square them, add, and take the root.",
        also: &[],
        condoned: false,
    },
    Slip {
        place: 22,
        tag: "speed-no-root",
        did: "did not take the square root",
        sentence: "That is the square of the speed: the root is still to be taken.",
        also: &[],
        condoned: false,
    },
];

pub fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    for sphere in Sphere::BOTH {
        for moment in [Moment::Before, Moment::After] {
            for (form, (first, second)) in [(N, T), (X, Y)].into_iter().enumerate() {
                let needs = [velocity(sphere, moment, first), velocity(sphere, moment, second)];
                rules.push(rule(Law::Speed, form as u8, &needs, &[Quantity::Speed(sphere, moment)], 1));
            }
        }
    }
    rules
}

pub fn evaluate<N: Number>(rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let [along, across] = known.numbers([rule.needs[0], rule.needs[1]])?;
    // The square of a root is not always seen to be one: a lone component is its own root.
    if across.is_nought() {
        return number(size(along, known));
    }
    if along.is_nought() {
        return number(across.size());
    }
    number((along.squared() + across.squared()).root()?)
}

pub fn slipped<N: Number>(slip: &str, rule: &Rule, known: &Here<N>) -> Outcome<N> {
    let [along, across] = known.numbers([rule.needs[0], rule.needs[1]])?;
    match slip {
        "speed-sum" => number(along.size() + across.size()),
        "speed-no-root" => number(along.squared() + across.squared()),
        "perpendicular-dropped" if rule.form == 0 && rule.gives[0] == after(rule.gives[0]) => number(along.size()),
        _ => None,
    }
}

/// The speed of the same sphere after the impact.
fn after(speed: Quantity) -> Quantity {
    match speed {
        Quantity::Speed(sphere, _) => Quantity::Speed(sphere, Moment::After),
        other => other,
    }
}

/// What earns the mark for accuracy.
pub fn earning(rule: &Rule, show: &Show) -> Option<Expr> {
    first_equation(&lines(rule, show))
}

pub fn lines(rule: &Rule, show: &Show) -> Vec<Line> {
    let Quantity::Speed(sphere, moment) = rule.gives[0] else { return Vec::new() };
    pythagoras(show, sphere, moment, rule.form == 1)
}

/// `√(v² + p²)` in numbers, then exact, then rounded.
fn pythagoras(show: &Show, sphere: Sphere, moment: Moment, in_i_j: bool) -> Vec<Line> {
    let (first, second) = if in_i_j { (X, Y) } else { (N, T) };
    let at = |axis| show.worked(velocity(sphere, moment, axis));
    let (along, across) = (at(first), at(second));
    let value = show.exact(Quantity::Speed(sphere, moment));
    let when = if moment == Moment::Before { "before" } else { "after" };
    let name = Expr::name(sphere.name());
    if along.is_zero() || across.is_zero() {
        let words = format!("The speed of {{A}} {when} the impact is {{v m/s}}");
        let mut text = Line::with(&words, &[("A", name), ("v", Show::stated(&value))], vec![]);
        let direction = match (in_i_j, along.is_zero(), across.is_zero()) {
            (_, true, true) => ": it is at rest.",
            (false, true, _) => ", perpendicular to the line of centres.",
            (false, _, true) => ", along the line of centres.",
            _ => ".",
        };
        text.words.0.push(Piece::Words(direction.to_string()));
        return vec![text];
    }
    let square = |value: &Value| {
        let size = if value.sign() == Some(std::cmp::Ordering::Less) { -value } else { value.clone() };
        written(&size).to_the(2)
    };
    let left = Expr::name(if sphere == Sphere::A { "s_A" } else { "s_B" });
    let root = Expr::call(Function::Sqrt, Expr::sum([square(&along), square(&across)]));
    let mut equations = Show::chain(left.clone(), [root, written(&value)]);
    equations.extend(Show::approximately(&left, &value));
    let words = format!("The speed of {{A}} {when} the impact{} is", show.in_units(&value, "metres per second"));
    vec![Line::with(&words, &[("A", name)], equations)]
}
