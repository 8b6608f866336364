//! Scenes as JSON, one a line, from stdin; one line of JSON for each to stdout: the quantities named as arguments, or
//! without arguments all that the scene determines.

use std::io::{self, BufRead, Write};
use std::time::Instant;

use carom::expr::Angles;
use carom::mechanics::{Quantity, Scene, SceneText};
use carom::solve::{report, solve_all};
use serde_json::{Value as Json, json};

fn main() -> io::Result<()> {
    let named: Vec<Quantity> = std::env::args().skip(1).filter_map(|name| name.parse().ok()).collect();
    let asked = if named.is_empty() { Quantity::all() } else { named };
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let start = Instant::now();
        let mut answer = answer(&line?, &asked);
        answer["seconds"] = json!(start.elapsed().as_secs_f64());
        writeln!(out, "{answer}")?;
    }
    Ok(())
}

fn answer(line: &str, asked: &[Quantity]) -> Json {
    let text: SceneText = match serde_json::from_str(line) {
        Ok(text) => text,
        Err(fault) => return json!({ "unreadable": fault.to_string() }),
    };
    let scene = match Scene::read(&text, &(), Angles::Radians) {
        Ok(scene) => scene,
        Err(faults) => {
            let one = |fault: &carom::mechanics::SceneFault| format!("{}: {}", fault.field, fault.fault.message);
            return json!({ "faults": faults.iter().map(one).collect::<Vec<_>>() });
        }
    };
    match solve_all(&scene, asked) {
        Ok(solutions) => json!({ "solutions": solutions.iter().map(report).collect::<Vec<_>>() }),
        Err(refusal) => json!({ "refused": refusal.reason }),
    }
}
