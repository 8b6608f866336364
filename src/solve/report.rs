//! What `solve --json` prints of a solution: every quantity that the scene determines, and the steps.

use serde::Serialize;
use serde_json::{Map, Value as Json, json};

use super::left::settled;
use super::{Inexact, Left, Solution};
use crate::expr::{Expr, in_degrees, print, ratio, written, written_angle};
use crate::mechanics::{Axis, Line, Moment, Quantity, Sphere};
use crate::number::{Angle, Decimal, Fraction, Letter, Places, Range, Value, round_certified};

/// A solution in the exchange format.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The model of the collision.
    pub model: &'static str,
    /// The numbers that sufficed.
    pub method: &'static str,
    /// The geometry that sufficed, once velocities are resolved along and across the line of centres.
    pub geometry: &'static str,
    /// Why they suffice.
    pub why: String,
    /// Quantities by name.
    pub quantities: Map<String, Json>,
    /// The worked solution.
    pub steps: Vec<StepReport>,
    /// Roots that were left out and why, and which quantities have no short exact form.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
}

/// One line of working.
#[derive(Clone, Debug, Serialize)]
pub struct StepReport {
    /// The words.
    pub words: String,
    /// The equations, in LaTeX.
    pub equations: Vec<String>,
    /// The number of the last equation, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<u32>,
}

/// An answer in every form in which it is stated.
#[derive(Clone, Debug, Serialize)]
pub struct Answer {
    /// The exchange format's expression.
    pub exact: String,
    /// The same in LaTeX.
    pub latex: String,
    /// At least 15 certified figures; null where letters remain.
    pub decimal: Option<String>,
    /// 3 significant figures; null where letters remain.
    pub rounded: Option<String>,
    /// The unit, `m/s`.
    pub unit: &'static str,
}

const FIGURES: Places = Places::SignificantFigures(15);
const ROUNDED: Places = Places::SignificantFigures(3);

impl Answer {
    /// A quantity of a solution.
    pub fn of(solution: &Solution, quantity: Quantity) -> Option<Answer> {
        let (unit, left) = (quantity.unit().plain(), solution.left());
        if let Some(value) = solution.number(quantity) {
            let carried_out = Answer::number(&value, left, unit);
            let quotient = if value.is_constant() { None } else { Answer::quotient(solution, quantity) };
            // A quotient of sums of roots with letters is readable where it is left one.
            let is_short = |quotient: &Answer| 2 * quotient.exact.len() < carried_out.exact.len();
            return Some(quotient.filter(is_short).unwrap_or(carried_out));
        }
        match solution.angle(quantity) {
            Some(angle) => Some(Answer::angle(&angle, left, unit)),
            None => Answer::quotient(solution, quantity),
        }
    }

    /// A quotient that was not carried out because its denominator holds many roots.
    fn quotient(solution: &Solution, quantity: Quantity) -> Option<Answer> {
        let of_impact = quantity.of_its_impact();
        // Of a later impact the other quantities are those of that impact too.
        let number = |other: Quantity| solution.number(other.in_impact(quantity.impact())?);
        let (above, below) = match of_impact {
            Quantity::TOverN(sphere, moment)
            | Quantity::TanToLine(sphere, moment)
            | Quantity::TanToWall(sphere, moment) => {
                let at = |axis| number(Quantity::Velocity(sphere, moment, axis));
                (at(Axis::T)?, at(Axis::N)?)
            }
            Quantity::TanDeflection(sphere) => {
                (number(Quantity::DeflectionCross(sphere))?, number(Quantity::DeflectionDot(sphere))?)
            }
            Quantity::Restitution => (number(Quantity::Separation)?, number(Quantity::Approach)?),
            Quantity::MassRatio if quantity == of_impact => {
                (number(Quantity::Mass(Sphere::B))?, number(Quantity::Mass(Sphere::A))?)
            }
            Quantity::FractionLost => (number(Quantity::EnergyLost)?, number(Quantity::TotalEnergy(Moment::Before))?),
            _ => return None,
        };
        // What is shared is seen before the signs are taken away.
        let (above, below) = Value::in_lowest_terms(&above, &below);
        let (above, below) = match of_impact {
            Quantity::TanToLine(..) => (above.absolute(), below.absolute()),
            Quantity::TanToWall(..) => (below.absolute(), above.absolute()),
            _ => (above, below),
        };
        if below.is_zero() {
            return None;
        }
        let exact = ratio(&above, &below);
        let left = solution.left();
        let enclose = |bits| left.enclose(&above, bits)?.checked_div(&left.enclose(&below, bits)?);
        let is = |tie: &Fraction| (&above - &(&below * &Value::from(tie.clone()))).is_zero();
        let constant = above.is_constant() && below.is_constant();
        let round = |places: &Places| match constant {
            true => round_certified(enclose, is, places).ok(),
            false => settled(enclose, places).ok(),
        };
        Some(Answer::from(&exact, &exact, round, quantity.unit().plain()))
    }

    fn number(value: &Value, left: Left, unit: &'static str) -> Answer {
        // Roots within roots may cancel unseen.
        let value = if value.is_constant() && value.is_zero() { &Value::ZERO } else { value };
        let exact = written(value);
        Answer::from(&exact, &exact, |places| left.rounded(value, places), unit)
    }

    fn angle(angle: &Angle, left: Left, unit: &'static str) -> Answer {
        let shown = written_angle(angle);
        Answer::from(&in_degrees(&shown), &shown, |places| left.rounded_angle(angle, places), unit)
    }

    fn from(exact: &Expr, shown: &Expr, round: impl Fn(&Places) -> Option<Decimal>, unit: &'static str) -> Answer {
        let [decimal, rounded] = [FIGURES, ROUNDED].map(|places| Some(round(&places)?.to_string()));
        Answer { exact: print::plain(exact), latex: print::latex(shown), decimal, rounded, unit }
    }
}

/// The value of a found letter: a number, or for an acute letter its angle.
fn found(letter: Letter, value: &Value) -> Answer {
    match (letter.range(), Angle::of(value, &Value::ONE)) {
        (Range::Acute, Some(angle)) => Answer::angle(&angle, Left(&[]), "deg"),
        _ => Answer::number(value, Left(&[]), if letter.name().ends_with(".mass") { "kg" } else { "" }),
    }
}

/// `e = 1/2`.
pub(super) fn found_in_words(letter: Letter, value: &Value) -> String {
    format!("{} = {}", letter.name(), found(letter, value).exact)
}

/// The report of a solution.
pub fn report(solution: &Solution) -> Report {
    let mut quantities = Map::new();
    for quantity in solution.scene().quantities() {
        if let Some(answer) = Answer::of(solution, quantity) {
            quantities.insert(quantity.to_string(), json!(answer));
        }
    }
    for (letter, value) in solution.found() {
        quantities.insert(letter.name().to_string(), json!(found(*letter, value)));
    }
    if let Some(values) = solution.range() {
        let answer = Answer::from(&values.written(), &values.written(), |_| None, "");
        quantities.insert(values.letter.name().to_string(), json!(answer));
    }
    let (method, geometry, why) = method(solution);
    Report {
        model: solution.scene().setting.model(),
        method,
        geometry,
        why,
        quantities,
        steps: [steps(&solution.finding()), steps(&solution.lines())].concat(),
        remarks: solution
            .remarks()
            .iter()
            .cloned()
            .chain(in_letters(solution))
            .chain(without_exact_form(solution))
            .collect(),
    }
}

/// That exact forms are in letters that were found.
fn in_letters(solution: &Solution) -> Option<String> {
    let left = solution.left();
    let said =
        || format!("the value of an unknown is too long to be put in: other exact forms are in its letter, {left}");
    (!left.is_empty()).then(said)
}

/// Which quantities are determined and not here, if there are any.
fn without_exact_form(solution: &Solution) -> Option<String> {
    let inexact = solution.without_exact_form();
    let named: Vec<String> = inexact.iter().map(Inexact::to_string).collect();
    (!named.is_empty()).then(|| format!("too many roots for a short exact form: {}", named.join(", ")))
}

fn steps(lines: &[Line]) -> Vec<StepReport> {
    let mut label = 0;
    lines
        .iter()
        .map(|line| StepReport {
            words: print::text_unicode(&line.words),
            equations: line.equations.iter().map(print::latex).collect(),
            label: line.numbered.then(|| {
                label += 1;
                label
            }),
        })
        .collect()
}

/// The model that sufficed: its numbers, its geometry and why.
fn method(solution: &Solution) -> (&'static str, &'static str, String) {
    match solution.selection() {
        Some(selection) => (selection.numbers.name(), selection.geometry.name(), selection.why()),
        None => {
            let why = match solution.scene().setting.is_of_one() {
                true => "one body moves: there is nothing to solve for but its own velocity",
                false => "not all that an impact starts from is given, so the steps of the derivation are the way",
            };
            ("derivation", "as given", why.to_owned())
        }
    }
}
