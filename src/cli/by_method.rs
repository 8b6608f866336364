//! `carom solve --method`: the least method that suffices, or the one that was asked for.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json, json};

use super::failure::Failure;
use super::output::{listed, print, print_json, table};
use crate::diagnostic::near;
use crate::mechanics::{ALONG, Datum, Derivation, Known, Quantity};
use crate::method::{After, Found, Geometry, Impact, METHODS, Method, Promise, method, solve_once};
use crate::number::{Fraction, Interval, Number, Value};
use crate::solve::{Solution, report};

/// The name for what suffices.
pub const LEAST: &str = "exact";

/// The name for the derivation's own steps in floating point.
const FLOAT: &str = "float";

/// How the scene is to be worked out.
pub enum Chosen {
    /// By the least that suffices.
    Least,
    /// By the steps of the derivation in floating point.
    Float,
    /// By a method.
    By(&'static dyn Method),
}

/// What a choice comes to.
pub enum Outcome {
    /// The exact solution; the name of the method if one was asked for.
    Exact(Option<&'static str>),
    /// Decimals.
    Decimals(Decimals),
}

/// Every quantity as a decimal.
pub struct Decimals {
    method: &'static str,
    why: String,
    quantities: Quantities,
    /// How far off they are, of a method that promises nothing.
    remark: Option<String>,
}

/// Decimals by the names of quantities.
type Quantities = BTreeMap<String, Decimal>;

/// A double, how far off it may be if that is known, and a unit.
struct Decimal {
    value: f64,
    error: Option<f64>,
    unit: &'static str,
}

impl Decimal {
    /// `± 2.3e-16`: how far off the printed decimal may be, which is only the nearest to the double that prints so; and a little
    /// more, so that the error may be rounded.
    fn error(&self) -> Option<String> {
        let printed: Option<Fraction> = self.value.to_string().parse().ok();
        let gap =
            printed.zip(Fraction::from_f64(self.value)).map(|(printed, double)| (&printed - &double).abs().to_f64());
        Some(format!("{:.1e}", (self.error? + gap?) * 1.06))
    }
}

impl Chosen {
    /// The choice of a name.
    pub fn named(name: &str) -> Result<Chosen, Failure> {
        match name {
            LEAST => Ok(Chosen::Least),
            FLOAT => Ok(Chosen::Float),
            _ => method(name).map(Chosen::By).ok_or_else(|| {
                let names = || [LEAST, FLOAT].into_iter().chain(METHODS.iter().map(|method| method.name()));
                let methods = format!("the methods are {}", listed(names()));
                let help = match near(name, names()) {
                    Some(near) => format!("did you mean `{near}`? {}", capital(&methods)),
                    None => methods,
                };
                Failure::with_help(format!("unknown method `{name}`"), help)
            }),
        }
    }

    /// What it comes to for a solution.
    pub fn outcome(&self, solution: &Solution) -> Result<Outcome, Failure> {
        let method = match self {
            Chosen::Least => return Ok(Outcome::Exact(None)),
            Chosen::Float => {
                let why = "asked for: the derivation evaluated in floating point, good to about 15 figures";
                let quantities = floats(solution, &Known::default())?;
                return Ok(Outcome::Decimals(decimals(FLOAT, why, quantities)));
            }
            Chosen::By(method) => *method,
        };
        let refused = |why: &str| {
            let message = format!("method `{}` does not take this scene: {why}", method.name());
            Failure::with_help(message, "leave `--method` out, and the least that suffices is taken")
        };
        let impact = solution.impact().ok_or_else(|| {
            refused(
                "it starts from both masses, both velocities before, the line of centres and e, and no velocity after",
            )
        })?;
        let found = solve_once(method, &impact).map_err(|skip| refused(&skip.why))?;
        let why = format!("asked for: the components after the impact by `{}`, the rest from them", method.name());
        match found {
            Found::Exact(_) => Ok(Outcome::Exact(Some(method.name()))),
            Found::Float(after) => {
                let remark = matches!(method.promises(), Promise::Nothing(_)).then(|| off(method, &impact, &after));
                let quantities = floats(solution, &along(&after))?;
                let decimals = decimals(method.name(), &why, quantities);
                Ok(Outcome::Decimals(Decimals { remark: remark.flatten(), ..decimals }))
            }
            Found::Enclosed(after) => {
                let quantities = enclosed(solution, &along(&after))?;
                Ok(Outcome::Decimals(decimals(method.name(), &why, quantities)))
            }
            Found::Missed(why) => Err(refused(&why)),
        }
    }
}

/// The model that was taken, in a line.
pub fn in_words(solution: &Solution, by: Option<&'static str>) -> String {
    let report = report(solution);
    match by {
        Some(method) => format!("{method}, asked for"),
        None => format!("{} ({}): {}", report.method, report.geometry, report.why),
    }
}

fn capital(words: &str) -> String {
    words.chars().take(1).flat_map(char::to_uppercase).chain(words.chars().skip(1)).collect()
}

fn decimals(method: &'static str, why: &str, quantities: Quantities) -> Decimals {
    Decimals { method, why: why.to_owned(), quantities, remark: None }
}

/// An error above this part of the larger speed is none of rounding: the simulation has missed what happens.
const COARSE: f64 = 0.01;

/// How far off the velocities of a simulation are, beside those in closed form.
fn off(method: &dyn Method, impact: &Impact<Value>, after: &After<f64>) -> Option<String> {
    let impact = impact.in_floats()?;
    let exact = Geometry::AnyLine.solve(&impact)?;
    let components = after.as_flattened().iter().zip(exact.as_flattened());
    let error = components.map(|(simulated, exact)| (simulated - exact).abs()).fold(0.0, f64::max);
    let speed = impact.before.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let part = error / speed;
    let percent = match part * 100.0 {
        hardly if hardly < 0.01 => "less than 0.01".to_owned(),
        percent => format!("{percent:.2}"),
    };
    let coarse = if part > COARSE { ": too coarse for this impact" } else { "" };
    Some(format!(
        "`{}` only simulates: components are off by up to {error:.1e} m/s, {percent} % of the larger speed before{coarse}",
        method.name()
    ))
}

/// The components along the line of centres after the impact.
fn along<N: Clone>(after: &After<N>) -> Known<N> {
    let mut known = Known::default();
    for (quantity, [along, _]) in ALONG[2..].iter().zip(after) {
        known.0.insert(*quantity, Datum::Number(along.clone()));
    }
    known
}

/// The derivation in another kind of number, where some results are there already; each quantity and its unit.
fn evaluated<N: Number>(
    solution: &Solution,
    computed: &Known<N>,
    into: impl Fn(&Value) -> Option<N>,
    number: impl Fn(&N) -> (f64, Option<f64>),
    degrees: impl Fn(&N, &N) -> Option<(f64, Option<f64>)>,
) -> Result<Quantities, Failure> {
    let help = "leave `--method` out";
    let mut known = turned_into(solution.given(), into)
        .ok_or_else(|| Failure::with_help("the method needs numbers, and letters remain", help))?;
    // A step that does not exist in these numbers leaves the rest unknown.
    let _ = solution.derivation().evaluate_with(computed, &mut known);
    // What has too many roots for an exact form has none too many for these numbers.
    let inexact: Vec<Quantity> = solution.without_exact_form().into_iter().map(|inexact| inexact.quantity).collect();
    if !inexact.is_empty() {
        Derivation::carry_out(&mut known, &inexact);
    }
    let mut quantities = BTreeMap::new();
    for quantity in solution.scene().quantities() {
        let angle = || known.direction(quantity).and_then(|(y, x)| degrees(&y, &x));
        if let Some((value, error)) = known.number(quantity).map(|value| number(&value)).or_else(angle) {
            quantities.insert(quantity.to_string(), Decimal { value, error, unit: quantity.unit().plain() });
        }
    }
    Ok(quantities)
}

fn floats(solution: &Solution, computed: &Known<f64>) -> Result<Quantities, Failure> {
    let degrees = |y: &f64, x: &f64| Some((y.atan2(*x).to_degrees(), None));
    evaluated(solution, computed, |value| solution.left().to_f64(value), |value| (*value, None), degrees)
}

/// The double next to the middle of each enclosure, and how far it may be off.
fn enclosed(solution: &Solution, computed: &Known<Interval>) -> Result<Quantities, Failure> {
    const BITS: usize = 128;
    let number = |interval: &Interval| {
        let value = interval.to_f64();
        let off = Fraction::from_f64(value).map(|value| (&interval.upper() - &value).max(&value - &interval.lower()));
        (value, off.map(|off| off.to_f64()))
    };
    let half_turn = Interval::integer(180, BITS);
    let degrees = |y: &Interval, x: &Interval| {
        let degrees = (Interval::atan2(y, x)? * half_turn.clone()).checked_div(&Interval::pi(BITS))?;
        Some(number(&degrees))
    };
    evaluated(solution, computed, |value| solution.left().enclose(value, BITS), number, degrees)
}

fn turned_into<N: Number>(exact: &Known<Value>, into: impl Fn(&Value) -> Option<N>) -> Option<Known<N>> {
    let mut known = Known::default();
    for (quantity, datum) in exact.0.iter() {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(into(value)?),
            Datum::Direction { y, x } => Datum::Direction { y: into(y)?, x: into(x)? },
            Datum::Equation([p, q, r]) => Datum::Equation([into(p)?, into(q)?, into(r)?]),
        };
        known.0.insert(*quantity, datum);
    }
    Some(known)
}

impl Decimals {
    /// Prints them as a table or as JSON.
    pub fn print(&self, solution: &Solution, as_json: bool) -> Result<(), Failure> {
        if as_json {
            let each = |(name, decimal): (&String, &Decimal)| {
                let mut fields = json!({"decimal": decimal.value.to_string(), "unit": decimal.unit});
                if let Some(error) = decimal.error() {
                    fields["error"] = error.into();
                }
                (name.clone(), fields)
            };
            let all: Map<String, Json> = self.quantities.iter().map(each).collect();
            let model = report(solution).model;
            let mut whole = json!({
                "model": model, "method": self.method, "why": self.why, "quantities": all,
            });
            if let Some(remark) = &self.remark {
                whole["remarks"] = json!([remark]);
            }
            return print_json(&whole);
        }
        let row = |(name, decimal): (&String, &Decimal)| {
            let error = decimal.error().map_or(String::new(), |error| format!(" ± {error}"));
            vec![format!("  {name}"), format!("{}{error} {}", decimal.value, decimal.unit)]
        };
        let rows: Vec<Vec<String>> = self.quantities.iter().map(row).collect();
        let remark = self.remark.iter().map(|remark| format!("\n{remark}\n")).collect::<String>();
        print(&(table(&rows) + &remark))
    }
}
