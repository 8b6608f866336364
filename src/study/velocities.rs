//! Maps of the velocities after an impact, by every method, and how far off each is in ordinary scenes.

use super::double::Outcome;
use super::impacts::{REGIMES, Regime, exactly, in_values, ordinary, truth};
use super::map::{Dealer, Map, Row};
use crate::method::{After, Found, Impact, METHODS, Method, Role, solve_once};
use crate::number::{Fraction, Interval, Value};

/// The methods that the maps show: what simulates is wrong in the second or third figure wherever it is tried, and has
/// its place on the chart of cost and error.
pub fn mapped() -> impl Iterator<Item = &'static dyn Method> {
    METHODS.iter().copied().filter(|method| method.role() != Role::Exhibit)
}

/// The regime of a name.
pub fn regime(name: &str) -> Option<&'static Regime> {
    REGIMES.iter().find(|regime| regime.name == name)
}

/// The map of a regime: the larger error of the two velocities, each relative to its own size.
pub fn regime_map(regime: &Regime, scenes: usize) -> Map {
    let columns: Vec<Vec<Outcome>> =
        (regime.exponents.0..=regime.exponents.1).map(|k| column(regime, k, scenes)).collect();
    let row = |(place, method): (usize, &dyn Method)| Row {
        arrangement: method.name().to_owned(),
        says: method.accepts().to_owned(),
        worst: columns.iter().map(|column| column[place]).collect(),
    };
    Map {
        name: regime.name.to_owned(),
        quantity: "velocities".to_owned(),
        regime: regime.words.to_owned(),
        first: regime.exponents.0,
        rows: mapped().enumerate().map(row).collect(),
    }
}

fn column(regime: &Regime, k: u32, scenes: usize) -> Vec<Outcome> {
    let mut deal = Dealer::new(regime.name, k);
    let mut worst = vec![Outcome::Refused; mapped().count()];
    for _ in 0..scenes {
        let Some(impact) = exactly(&(regime.impact)(k, &mut deal)) else { continue };
        let (truth, impact) = (truth(&impact), in_values(&impact));
        for (worst, method) in worst.iter_mut().zip(mapped()) {
            *worst = worst.worse(outcome(method, &impact, &truth, Scale::Itself));
        }
    }
    worst
}

/// The worst error of one method in a regime at one k, as a part of the largest speed before.
pub fn promised(regime: &Regime, k: u32, method: &dyn Method, scenes: usize) -> Outcome {
    let mut deal = Dealer::new(regime.name, k);
    let mut worst = Outcome::Refused;
    for _ in 0..scenes {
        let Some(impact) = exactly(&(regime.impact)(k, &mut deal)) else { continue };
        worst = worst.worse(outcome(method, &in_values(&impact), &truth(&impact), Scale::Largest));
    }
    worst
}

/// The worst error of a method among ordinary scenes, as a part of the largest speed before.
pub fn ordinary_error(method: &dyn Method, scenes: usize) -> Outcome {
    let mut deal = Dealer::new("ordinary", 0);
    (0..scenes).fold(Outcome::Refused, |worst, _| {
        let impact = ordinary(&mut deal);
        worst.worse(outcome(method, &in_values(&impact), &truth(&impact), Scale::Largest))
    })
}

/// What an error is a part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// The size of the velocity in question.
    Itself,
    /// The largest speed before the impact.
    Largest,
}

/// How far a method is off for one impact.
pub fn outcome(method: &dyn Method, impact: &Impact<Value>, truth: &After<Fraction>, scale: Scale) -> Outcome {
    let Ok(found) = solve_once(method, impact) else { return Outcome::Refused };
    compare(&found, impact, truth, scale)
}

/// How far what was found is off: for an enclosure how much it leaves open.
pub fn compare(found: &Found, impact: &Impact<Value>, truth: &After<Fraction>, scale: Scale) -> Outcome {
    let gap = |sphere: usize, place: usize| -> Option<Fraction> {
        let right = &truth[sphere][place];
        match found {
            Found::Exact(after) => Some((after[sphere][place].as_fraction()? - right).abs()),
            Found::Float(after) => Some((&super::double::fraction(after[sphere][place])? - right).abs()),
            Found::Enclosed(after) => open(&after[sphere][place], right),
            Found::Missed(_) => None,
        }
    };
    let mut worst = Outcome::Off(0.0);
    for sphere in [0, 1] {
        let (Some(x), Some(y)) = (gap(sphere, 0), gap(sphere, 1)) else { return Outcome::NoNumber };
        if x.is_zero() && y.is_zero() {
            continue;
        }
        let size = match scale {
            Scale::Itself => size(&truth[sphere]),
            Scale::Largest => impact.before.iter().filter_map(speed).fold(0.0, f64::max),
        };
        let error = size_of_floats(x.to_f64(), y.to_f64()) / size;
        worst = worst.worse(if error.is_finite() { Outcome::Off(error) } else { Outcome::NoNumber });
    }
    worst
}

/// The width of an enclosure; none if the truth is not in it.
fn open(enclosure: &Interval, right: &Fraction) -> Option<Fraction> {
    enclosure.contains(right).then(|| enclosure.width())
}

fn size(velocity: &[Fraction; 2]) -> f64 {
    size_of_floats(velocity[0].to_f64(), velocity[1].to_f64())
}

fn speed(velocity: &[Value; 2]) -> Option<f64> {
    Some(size_of_floats(velocity[0].to_f64()?, velocity[1].to_f64()?))
}

/// The root of the sum of the squares, where neither overflows: errors and speeds of a study are far from the ends.
fn size_of_floats(x: f64, y: f64) -> f64 {
    let largest = x.abs().max(y.abs());
    if largest == 0.0 { 0.0 } else { largest * ((x / largest).powi(2) + (y / largest).powi(2)).sqrt() }
}
