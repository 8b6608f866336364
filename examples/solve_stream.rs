//! Reads scenes as JSON lines and writes one report for each: the solver as a filter.

use std::collections::BTreeMap;
use std::io::{BufRead, Write};

use carom::expr::Angles;
use carom::mechanics::{Quantity, Scene, SceneText};
use carom::solve::{report, solve_all};

fn main() -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let answer = match serde_json::from_str::<SceneText>(&line?) {
            Err(fault) => serde_json::json!({"fault": fault.to_string()}),
            Ok(text) => match Scene::read(&text, &BTreeMap::new(), Angles::Radians) {
                Err(faults) => serde_json::json!({"fault": format!("{faults:?}")}),
                Ok(scene) => match solve_all(&scene, &Quantity::all()) {
                    Err(refusal) => serde_json::json!({"refused": refusal.reason}),
                    Ok(solutions) => serde_json::json!(solutions.iter().map(report).collect::<Vec<_>>()),
                },
            },
        };
        writeln!(out, "{answer}")?;
    }
    Ok(())
}
