//! `carom solve`: one collision, worked.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value as Json, json};

use super::failure::Failure;
use super::output::{listed, print, print_json, say, table};
use super::{by_method, scene_input};
use crate::expr::{print as written, written as plainest, written_angle};
use crate::mechanics::{Axis, Line, Moment, Quantity, Scene, Setting, Sphere, Velocity};
use crate::number::{Angle, Letter, Range, Value};
use crate::paper::WorkingLine;
use crate::solve::{Answer, Inexact, Solution, report, solve_all};

const AFTER: &str = "Examples:
  carom solve scene.json
  carom solve scene.json --json
  carom solve scene.json --method elimination

A scene, here in the file `scene.json`:
  { \"masses\": {\"A\": \"2\", \"B\": \"4\"},
    \"before\": {\"A\": {\"speed\": \"6\", \"angle_deg\": \"10\"}, \"B\": [\"0\", \"0\"]},
    \"line_of_centres\": [\"1\", \"0\"], \"e\": \"1/2\" }

A velocity is [x, y], or a speed with its angle in degrees anticlockwise from the x-axis. Give
velocities `after` in place of `e` or of the line of centres to work backwards. Letters are
declared: \"symbols\": {\"u\": \"positive\"}.";

/// Work out one collision
///
/// Prints the worked solution with exact answers. The scene is a file in TOML or JSON, or `-` for stdin.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct SolveArguments {
    /// The scene: a file, or `-`
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// How to work it out: the least that suffices unless one is named, `float` for the same steps in floating point, or
    /// any method, such as `elimination`
    #[arg(long, value_name = "METHOD", default_value = by_method::LEAST)]
    method: String,
    /// Print every quantity as JSON
    #[arg(long)]
    json: bool,
}

/// Solves the scene.
pub fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    let method = by_method::Chosen::named(&arguments.method)?;
    let scene = scene_input::scene(&arguments.scene)?;
    let wanted = wanted(&scene);
    let asked = if arguments.json { scene.quantities() } else { wanted.clone() };
    let solutions = solve_all(&scene, &asked)?;
    // What has no exact form has its decimal all the same.
    let is_inexact = || solutions.first().is_some_and(|first| !first.without_exact_form().is_empty());
    if !(matches!(method, by_method::Chosen::Float) && is_inexact()) {
        open_ends(&solutions, &wanted)?;
    }
    let Some(first) = solutions.first() else { return Ok(()) };
    let by = match method.outcome(first)? {
        by_method::Outcome::Exact(by) => by,
        by_method::Outcome::Decimals(decimals) => return decimals.print(first, arguments.json),
    };
    if arguments.json {
        return print_json(&exact_json(&solutions, by));
    }
    print(&format!("{}\nMethod\n  {}\n", on_terminal(&solutions, &asked), by_method::in_words(first, by)))
}

/// What a person wants to know of a scene: all that is not given, impact by impact.
fn wanted(scene: &Scene) -> Vec<Quantity> {
    let mut wanted = wanted_of_one(scene);
    let axes: &[Axis] = if scene.setting == Setting::Direct { &[Axis::X] } else { &[Axis::X, Axis::Y] };
    for then in &scene.then {
        let spheres = if then.scene.setting.is_of_one() { &Sphere::BOTH[..1] } else { &Sphere::BOTH };
        let mut here = Vec::new();
        for sphere in spheres.iter().copied() {
            here.extend(axes.iter().map(|axis| Quantity::Velocity(sphere, Moment::After, *axis)));
            here.push(Quantity::Speed(sphere, Moment::After));
        }
        here.extend([Quantity::ImpulseMagnitude, Quantity::EnergyLost]);
        wanted.extend(here.into_iter().map(|quantity| then.meeting.quantity(quantity)));
    }
    wanted
}

fn wanted_of_one(scene: &Scene) -> Vec<Quantity> {
    let mut wanted = Vec::new();
    let spheres = if scene.setting.is_of_one() { &Sphere::BOTH[..1] } else { &Sphere::BOTH };
    let direction = |sphere, moment| match scene.setting {
        Setting::Oblique => vec![Quantity::AngleToLine(sphere, moment)],
        Setting::Wall => vec![Quantity::AngleToWall(sphere, moment)],
        // Along a line a speed has its sign besides; of a particle alone its components say it.
        Setting::Direct | Setting::Impulse => Vec::new(),
    };
    for sphere in spheres.iter().copied() {
        if scene.mass(sphere).is_none() {
            wanted.push(Quantity::Mass(sphere));
        }
    }
    if scene.contact.is_none() && scene.setting != Setting::Impulse {
        wanted.extend([Quantity::Line(Axis::X), Quantity::Line(Axis::Y)]);
    }
    if scene.restitution.is_none() && scene.setting != Setting::Impulse {
        wanted.push(Quantity::Restitution);
    }
    for moment in [Moment::Before, Moment::After] {
        for sphere in spheres.iter().copied() {
            if scene.velocity(sphere, moment).is_some() {
                continue;
            }
            let given = scene.velocity(sphere, if moment == Moment::Before { Moment::After } else { Moment::Before });
            let other = scene.velocity(sphere.other(), Moment::Before);
            if scene.setting == Setting::Direct {
                wanted.push(Quantity::Velocity(sphere, moment, Axis::X));
            } else if [given, other].iter().flatten().any(|velocity| is_vector(velocity)) {
                wanted.extend([Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, moment, axis)));
            }
            wanted.push(Quantity::Speed(sphere, moment));
            wanted.extend(direction(sphere, moment));
        }
    }
    wanted.extend([Quantity::ImpulseMagnitude, Quantity::EnergyLost]);
    wanted
}

/// Is the velocity given by components, and not nought?
fn is_vector(velocity: &Velocity) -> bool {
    matches!(velocity, Velocity::Components(x, y) if !(x.value.is_zero() && y.value.is_zero()))
}

/// Says what the scene leaves open, and what it determines though not exactly; a scene that determines nothing has no
/// solution.
fn open_ends(solutions: &[Solution], wanted: &[Quantity]) -> Result<(), Failure> {
    let Some(solution) = solutions.first() else { return Ok(()) };
    let missing: Vec<&Quantity> = wanted.iter().filter(|quantity| Answer::of(solution, **quantity).is_none()).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let inexact: Vec<Inexact> =
        solution.without_exact_form().into_iter().filter(|inexact| missing.contains(&&inexact.quantity)).collect();
    let named = inexact.iter().map(Inexact::to_string).collect::<Vec<_>>().join(", ");
    let is_nothing = missing.len() == wanted.len() && solution.found().is_empty();
    if is_nothing && !inexact.is_empty() {
        let message = format!("too many roots for an exact form of what the scene determines: {named}");
        return Err(Failure::with_help(
            message,
            "give numbers with fewer different roots, or a decimal for some of them",
        ));
    }
    if is_nothing {
        let help = match solution.scene().setting {
            Setting::Wall => "give the velocity before and e, or the velocity after in place of one of them",
            Setting::Impulse => {
                "give the mass, the velocity before and the impulse, or the velocity after in place of one"
            }
            _ if solution.scene().restitution.as_ref().is_some_and(|e| e.value.is_zero()) => {
                "give a velocity before: where e is 0 those after do not tell it"
            }
            _ => {
                "give both masses, both velocities before, the line of centres and e, or velocities after in place of \
                 some of them"
            }
        };
        let absent = absent(solution.scene());
        let message = match absent.is_empty() {
            true => "what is given determines nothing more".to_owned(),
            false => format!("what is given determines nothing more: there is no {}", absent.join(", no ")),
        };
        return Err(Failure::with_help(message, help));
    }
    if !inexact.is_empty() {
        say(&format!("too many roots for a short exact form: {named}"));
    }
    let is_inexact = |quantity: &Quantity| inexact.iter().any(|inexact| inexact.quantity == *quantity);
    let open: Vec<String> =
        missing.into_iter().filter(|quantity| !is_inexact(quantity)).map(Quantity::to_string).collect();
    if !open.is_empty() {
        say(&format!("left open by what is given: {}", listed(open.iter().map(String::as_str))));
    }
    Ok(())
}

/// The fields of a collision that a scene has not, where the velocities after do not take their place.
fn absent(scene: &Scene) -> Vec<String> {
    let spheres = if scene.setting.is_of_one() { &Sphere::BOTH[..1] } else { &Sphere::BOTH };
    if spheres.iter().any(|sphere| scene.velocity(*sphere, Moment::After).is_some()) {
        return Vec::new();
    }
    let masses = spheres.iter().filter(|sphere| scene.setting != Setting::Wall && scene.mass(**sphere).is_none());
    let velocities = spheres.iter().filter(|sphere| scene.velocity(**sphere, Moment::Before).is_none());
    let is_impulse = scene.setting == Setting::Impulse;
    let mut absent: Vec<String> = masses.map(|sphere| format!("`masses.{}`", sphere.name())).collect();
    absent.extend(velocities.map(|sphere| format!("`before.{}`", sphere.name())));
    for (field, is_absent) in [
        ("line_of_centres", scene.contact.is_none() && !is_impulse),
        ("e", scene.restitution.is_none() && !is_impulse),
        ("impulse", scene.impulse.is_none() && is_impulse),
    ] {
        absent.extend(is_absent.then(|| format!("`{field}`")));
    }
    absent
}

/// The first solution's report, with all of them and a remark if there are several.
fn exact_json(solutions: &[Solution], by: Option<&'static str>) -> Json {
    let one = |solution: &Solution| {
        let mut report = report(solution);
        if let Some(asked_for) = by {
            (report.method, report.why) = (asked_for, "asked for".to_owned());
        }
        json!(report)
    };
    let reports: Vec<Json> = solutions.iter().map(one).collect();
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
        text.push_str(&worked(&labelled(if finding.is_empty() { &lines } else { &finding })));
        for remark in solution.remarks() {
            text.push_str(&format!("{remark}\n"));
        }
        text.push_str("\nAnswers\n");
        text.push_str(&answers(solution, asked));
    }
    text
}

/// The lines of one working, their equations numbered from (1).
fn labelled(lines: &[Line]) -> Vec<WorkingLine> {
    let mut last = 0;
    let mut label = |line: &Line| {
        last += u32::from(line.numbered);
        line.numbered.then_some(last)
    };
    let line =
        |line: &Line| WorkingLine { words: line.words.clone(), equations: line.equations.clone(), label: label(line) };
    lines.iter().map(line).collect()
}

/// The lines of working in the mathematics of a terminal.
pub fn worked(lines: &[WorkingLine]) -> String {
    const NUMBERED_AT: usize = 72;
    let mut text = String::new();
    for line in lines {
        if !line.words.is_empty() {
            text.push_str(&written::text_unicode(&line.words));
            text.push('\n');
        }
        for (index, equation) in line.equations.iter().enumerate() {
            let mut row = format!("    {}", written::unicode(equation));
            if let Some(number) = line.label.filter(|_| index + 1 == line.equations.len()) {
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
    if let Some(values) = solution.range() {
        rows.push(vec![format!("  {}", values.letter.name()), written::unicode(&values.written())]);
    }
    for (letter, exact) in found(solution) {
        rows.push(vec![format!("  {letter}"), exact]);
    }
    let letters: Vec<&Letter> = solution
        .found()
        .iter()
        .map(|(letter, _)| letter)
        .chain(solution.range().map(|values| &values.letter))
        .collect();
    let is_found = |quantity: &Quantity| letters.iter().any(|letter| letter.name() == quantity.to_string());
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
