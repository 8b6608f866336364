//! `carom solve`: one collision, worked.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::Args;
use serde_json::{Map, Value as Json, json};

use super::failure::Failure;
use super::output::{listed, print, print_json, say, table};
use super::scene_input;
use crate::diagnostic::near;
use crate::expr::{print as written, written as plainest, written_angle};
use crate::mechanics::{Axis, Datum, Known, Line, Moment, Quantity, Scene, Sphere, Velocity, pose};
use crate::number::{Angle, Letter, Range, Value};
use crate::solve::{Answer, Solution, report, solve_all};

const AFTER: &str = "Example, in a file `scene.json`:
  { \"masses\": {\"A\": \"2\", \"B\": \"4\"},
    \"before\": {\"A\": {\"speed\": \"6\", \"angle_deg\": \"10\"}, \"B\": [\"0\", \"0\"]},
    \"line_of_centres\": [\"1\", \"0\"], \"e\": \"1/2\" }
  carom solve scene.json

A velocity is [x, y], or a speed with its angle in degrees anticlockwise from the x-axis. Give velocities `after`
in place of `e` or of the line of centres to work backwards. Letters are declared: \"symbols\": {\"u\": \"positive\"}.";

/// Work out one collision
///
/// Prints the worked solution with exact answers. The scene is a file in TOML or JSON, or `-` for stdin.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct SolveArguments {
    /// The scene: a file, or `-`
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// How to work it out: `exact`, or `float` for the same steps in floating point
    #[arg(long, value_name = "METHOD", default_value = "exact")]
    method: String,
    /// Print every quantity as JSON
    #[arg(long)]
    json: bool,
}

/// The ways to work it out.
const METHODS: [&str; 2] = ["exact", "float"];

/// Solves the scene.
pub fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    let method = arguments.method.as_str();
    if !METHODS.contains(&method) {
        let help = match near(method, METHODS) {
            Some(near) => format!("did you mean `{near}`? The methods are {}", listed(METHODS)),
            None => format!("the methods are {}", listed(METHODS)),
        };
        return Err(Failure::with_help(format!("unknown method `{method}`"), help));
    }
    let scene = scene_input::scene(&arguments.scene)?;
    let wanted = wanted(&scene);
    let asked = if arguments.json { Quantity::all() } else { wanted.clone() };
    let solutions = solve_all(&scene, &asked)?;
    open_ends(&solutions, &wanted)?;
    match (method, arguments.json) {
        ("float", json) => in_floats(&solutions, json),
        (_, true) => print_json(&exact_json(&solutions)),
        (_, false) => print(&on_terminal(&solutions, &asked)),
    }
}

/// What a person wants to know of a scene: all that is not given.
fn wanted(scene: &Scene) -> Vec<Quantity> {
    let mut wanted = Vec::new();
    for sphere in Sphere::BOTH {
        if scene.mass(sphere).is_none() {
            wanted.push(Quantity::Mass(sphere));
        }
    }
    if scene.contact.is_none() {
        wanted.extend([Quantity::Line(Axis::X), Quantity::Line(Axis::Y)]);
    }
    if scene.restitution.is_none() {
        wanted.push(Quantity::Restitution);
    }
    for moment in [Moment::Before, Moment::After] {
        for sphere in Sphere::BOTH {
            if scene.velocity(sphere, moment).is_some() {
                continue;
            }
            let given = scene.velocity(sphere, if moment == Moment::Before { Moment::After } else { Moment::Before });
            let other = scene.velocity(sphere.other(), Moment::Before);
            if [given, other].iter().flatten().any(|velocity| is_vector(velocity)) {
                wanted.extend([Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, moment, axis)));
            }
            wanted.extend([Quantity::Speed(sphere, moment), Quantity::AngleToLine(sphere, moment)]);
        }
    }
    wanted.extend([Quantity::ImpulseMagnitude, Quantity::EnergyLost]);
    wanted
}

/// Is the velocity given by components, and not nought?
fn is_vector(velocity: &Velocity) -> bool {
    matches!(velocity, Velocity::Components(x, y) if !(x.value.is_zero() && y.value.is_zero()))
}

/// Says what the scene leaves open; a scene that determines nothing has no solution.
fn open_ends(solutions: &[Solution], wanted: &[Quantity]) -> Result<(), Failure> {
    let Some(solution) = solutions.first() else { return Ok(()) };
    let open: Vec<String> =
        wanted.iter().filter(|quantity| !solution.knows(**quantity)).map(Quantity::to_string).collect();
    if open.len() == wanted.len() && solution.found().is_empty() {
        let help = "give both masses, both velocities before, the line of centres and e, or velocities after in \
                    place of some of them";
        return Err(Failure::with_help("what is given determines nothing more", help));
    }
    if !open.is_empty() {
        say(&format!("left open by what is given: {}", listed(open.iter().map(String::as_str))));
    }
    Ok(())
}

/// The first solution's report, with all of them and a remark if there are several.
fn exact_json(solutions: &[Solution]) -> Json {
    let reports: Vec<Json> = solutions.iter().map(|solution| json!(report(solution))).collect();
    let mut whole = reports.first().cloned().unwrap_or(Json::Null);
    if let (Some(object), true) = (whole.as_object_mut(), reports.len() > 1) {
        let remark = format!("{} solutions are possible: the quantities here are those of the first", reports.len());
        let remarks = object.entry("remarks").or_insert_with(|| json!([]));
        if let Some(list) = remarks.as_array_mut() {
            list.insert(0, remark.into());
        }
        object.insert("solutions".to_owned(), reports.into());
    }
    whole
}

fn on_terminal(solutions: &[Solution], asked: &[Quantity]) -> String {
    let mut text = String::new();
    for (index, solution) in solutions.iter().enumerate() {
        if solutions.len() > 1 {
            text.push_str(&format!("{}Solution {}\n\n", if index == 0 { "" } else { "\n" }, index + 1));
        }
        let lines = solution.lines();
        // Once the unknown is found, the rest would repeat the same steps with its value.
        let finding = solution.finding();
        text.push_str(&worked(if finding.is_empty() { &lines } else { finding }));
        for remark in solution.remarks() {
            text.push_str(&format!("{remark}\n"));
        }
        text.push_str("\nAnswers\n");
        text.push_str(&answers(solution, asked));
    }
    text
}

/// The lines of working in the mathematics of a terminal.
pub fn worked(lines: &[Line]) -> String {
    const NUMBERED_AT: usize = 72;
    let mut text = String::new();
    let mut number = 0;
    for line in lines {
        if !line.words.is_empty() {
            text.push_str(&written::text_unicode(&line.words));
            text.push('\n');
        }
        for (index, equation) in line.equations.iter().enumerate() {
            let mut row = format!("    {}", written::unicode(equation));
            if line.numbered && index + 1 == line.equations.len() {
                number += 1;
                let gap = NUMBERED_AT.saturating_sub(row.chars().count()).max(2);
                row.extend(std::iter::repeat_n(' ', gap));
                row.push_str(&format!("({number})"));
            }
            text.push_str(&row);
            text.push('\n');
        }
    }
    text
}

fn answers(solution: &Solution, asked: &[Quantity]) -> String {
    let mut rows = Vec::new();
    for (letter, exact) in found(solution) {
        rows.push(vec![format!("  {letter}"), exact]);
    }
    let is_found =
        |quantity: &Quantity| solution.found().iter().any(|(letter, _)| letter.name() == quantity.to_string());
    for quantity in asked.iter().filter(|quantity| !is_found(quantity)) {
        let (Some(answer), Some(exact)) = (Answer::of(solution, *quantity), solution.exact(*quantity)) else {
            continue;
        };
        let exact = written::unicode(&exact);
        let unit = if answer.unit == "deg" { "°".to_owned() } else { format!(" {}", answer.unit) };
        let whole = solution.number(*quantity).is_some_and(|value| value.as_fraction().is_some_and(|f| f.is_integer()));
        let short = whole || solution.angle(*quantity).is_some_and(|angle| angle.whole_degrees().is_some());
        let rounded = answer.rounded.filter(|rounded| !short && *rounded != exact && format!("{rounded}°") != exact);
        let exact_has_unit = exact.ends_with('°') || answer.decimal.is_none();
        let row = match rounded {
            Some(rounded) => format!("{exact} ≈ {rounded}{}", unit.trim_end()),
            None if exact_has_unit => exact,
            None => format!("{exact}{}", unit.trim_end()),
        };
        rows.push(vec![format!("  {quantity}"), row]);
    }
    table(&rows)
}

/// The letters that were found, each with its value as a teacher writes it.
fn found(solution: &Solution) -> Vec<(String, String)> {
    let quantities = report(solution).quantities;
    let one = |(letter, value): &(Letter, Value)| {
        let angle = Angle::of(value, &Value::ONE).filter(|_| letter.range() == Range::Acute);
        let exact = written::unicode(&angle.as_ref().map_or_else(|| plainest(value), written_angle));
        let degree = if angle.is_some() { "°" } else { "" };
        let answer = quantities.get(letter.name()).map(|answer| json!(answer));
        let rounded = answer.and_then(|answer| answer["rounded"].as_str().map(|text| format!("{text}{degree}")));
        let whole = value.as_fraction().is_some_and(|value| value.is_integer()) && angle.is_none();
        let exact = match rounded.filter(|rounded| !whole && *rounded != exact && !exact.ends_with('°')) {
            Some(rounded) => format!("{exact} ≈ {rounded}"),
            None => exact,
        };
        (letter.name().to_owned(), exact)
    };
    solution.found().iter().map(one).collect()
}

/// The same steps in floating point.
fn in_floats(solutions: &[Solution], as_json: bool) -> Result<(), Failure> {
    let Some(solution) = solutions.first() else { return Ok(()) };
    let exact = pose(solution.scene())?;
    let needs_numbers =
        || Failure::with_help("method `float` needs numbers, and letters remain", "leave `--method` out");
    let mut known = floats(&exact).ok_or_else(needs_numbers)?;
    // A step that does not exist in floating point leaves the rest unknown.
    let _ = solution.derivation().evaluate(&mut known);
    let mut quantities: BTreeMap<String, (f64, &str)> = BTreeMap::new();
    for quantity in Quantity::all() {
        let number = known.number(quantity);
        let angle = || known.direction(quantity).map(|(y, x)| y.atan2(x).to_degrees());
        if let Some(value) = number.or_else(angle) {
            quantities.insert(quantity.to_string(), (value, quantity.unit().plain()));
        }
    }
    if as_json {
        let each = |(name, (value, unit)): (&String, &(f64, &str))| {
            (name.clone(), json!({"decimal": value.to_string(), "unit": unit}))
        };
        let all: Map<String, Json> = quantities.iter().map(each).collect();
        let why = "asked for: the derivation evaluated in floating point, good to about 15 figures";
        return print_json(&json!({
            "model": report(solution).model, "method": "float", "why": why, "quantities": all,
        }));
    }
    let rows: Vec<Vec<String>> =
        quantities.iter().map(|(name, (value, unit))| vec![format!("  {name}"), format!("{value} {unit}")]).collect();
    print(&table(&rows))
}

fn floats(exact: &Known<Value>) -> Option<Known<f64>> {
    let mut known = Known::default();
    for (quantity, datum) in &exact.0 {
        let datum = match datum {
            Datum::Number(value) => Datum::Number(value.to_f64()?),
            Datum::Direction { y, x } => Datum::Direction { y: y.to_f64()?, x: x.to_f64()? },
            Datum::Equation([p, q, r]) => Datum::Equation([p.to_f64()?, q.to_f64()?, r.to_f64()?]),
        };
        known.0.insert(*quantity, datum);
    }
    Some(known)
}
