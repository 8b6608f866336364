//! Slips of the calculator, which belong to no law: the mode for angles, and figures dropped on the way.
//!
//! They are other numbers for the components of the velocities, from which the derivation goes on.

use crate::mechanics::{Axis, Datum, Known, Moment, Quantity, Slip, Sphere};
use crate::number::{Letter, Range};

use super::sample::Sample;

/// The slips, in the order of their places.
pub(super) const SLIPS: [Slip; 2] = [
    Slip {
        place: 42,
        tag: "radian-mode",
        did: "resolved with the calculator set to radians",
        sentence: "Set your calculator to degrees: it took the angle for radians.",
        also: &[],
        condoned: true,
    },
    Slip {
        place: 43,
        tag: "early-rounding",
        did: "rounded the components to two figures before going on",
        sentence: "Rounded on the way: keep all the figures until the last line.",
        also: &[],
        condoned: true,
    },
];

type Entered = Vec<(Quantity, Datum<Sample>)>;

/// What each of the slips makes of the components, in as many ways as there are; none where it changes nothing.
pub(super) fn entered(slip: &Slip, known: &Known<Sample>, letters: &[Letter]) -> Vec<Entered> {
    let mut ways = match slip.tag {
        "radian-mode" => vec![in_radian_mode(known)],
        _ => {
            let all = rounded(known, letters, 2);
            // Or what was given is taken as it is, and the outcome of the equations is rounded.
            let is_after = |(quantity, _): &&(Quantity, Datum<Sample>)| {
                matches!(quantity, Quantity::Velocity(_, Moment::After, _))
            };
            let after = all.iter().filter(is_after).cloned().collect();
            vec![all, after]
        }
    };
    ways.retain(|entered| !entered.is_empty());
    ways
}

/// The components of a velocity along and across the line of centres.
fn along_and_across(sphere: Sphere, moment: Moment) -> [Quantity; 2] {
    [Axis::N, Axis::T].map(|axis| Quantity::Velocity(sphere, moment, axis))
}

/// Where a speed is given with an angle in degrees, `u cos α` and `u sin α` of as many radians.
fn in_radian_mode(known: &Known<Sample>) -> Entered {
    let mut entered = Vec::new();
    for sphere in Sphere::BOTH {
        let given = Quantity::GivenDirection(sphere, Moment::Before);
        let components = along_and_across(sphere, Moment::Before);
        let (Some(speed), Some([along, across])) =
            (known.number(Quantity::Speed(sphere, Moment::Before)), known.numbers(components))
        else {
            continue;
        };
        let angle = across.0[0].abs().atan2(along.0[0].abs()).to_degrees();
        // An angle that was given by its cosine is no number of degrees, and one in letters is not typed.
        let is_typed = |angle: f64| (angle * 2.0 - (angle * 2.0).round()).abs() < 1e-9 && angle > 1e-9 && angle < 89.99;
        if !known.0.contains_key(&given) || !is_typed(angle) {
            continue;
        }
        let of = |component: Sample, ratio: f64| component.with(speed, |own, speed| own.signum() * speed * ratio);
        entered.push((components[0], Datum::Number(of(along, angle.cos()))));
        entered.push((components[1], Datum::Number(of(across, angle.sin()))));
    }
    entered
}

/// Every component rounded to so many significant figures, where it is a number or a multiple of one letter.
pub(super) fn rounded(known: &Known<Sample>, letters: &[Letter], figures: i32) -> Entered {
    if letters.iter().any(|letter| letter.range() != Range::Positive) {
        return Vec::new();
    }
    let velocities = Sphere::BOTH
        .into_iter()
        .flat_map(|sphere| [Moment::Before, Moment::After].map(|moment| along_and_across(sphere, moment)));
    let mut entered = Vec::new();
    for quantity in velocities.flatten() {
        let Some(value) = known.number(quantity).filter(|value| value.0[0] != 0.0) else { continue };
        // At the first point a letter is one, so there the coefficient itself is seen.
        let factor = to_figures(value.0[0], figures) / value.0[0];
        entered.push((quantity, Datum::Number(value.map(|value| value * factor))));
    }
    entered
}

/// Rounded half up to so many significant figures. A tie that a float misses by a hair is one.
pub(super) fn to_figures(value: f64, figures: i32) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let places = figures - 1 - value.abs().log10().floor() as i32;
    let (above, below) = if places >= 0 { (10_f64.powi(places), 1.0) } else { (1.0, 10_f64.powi(-places)) };
    value.signum() * (value.abs() * above / below + 0.5 + 1e-9).floor() * below / above
}
