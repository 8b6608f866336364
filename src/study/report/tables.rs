//! The tables of a study, as CSV for spreadsheets and all together as JSON.

use serde_json::{Value as Json, json};

use super::Study;
use crate::study::double::Outcome;
use crate::study::exam_grid::Count;
use crate::study::map::Map;
use crate::study::times::write_times;

/// Names and contents.
pub fn all(study: &Study) -> Vec<(&'static str, String)> {
    vec![
        ("errors.csv", errors(study.quantities.iter().chain(&study.velocities))),
        ("grid.csv", grid(study)),
        ("tolerance.csv", tolerance(study)),
        ("times.csv", write_times(&study.costs)),
        ("study.json", format!("{:#}\n", as_json(study))),
    ]
}

/// The error as it is written: two figures, or the reason why there is none.
fn written(outcome: Outcome) -> String {
    match outcome {
        Outcome::Off(0.0) => "0".to_owned(),
        Outcome::Off(error) => format!("{error:.1e}"),
        Outcome::NoNumber => "no number".to_owned(),
        Outcome::Refused => "refused".to_owned(),
    }
}

fn errors<'m>(maps: impl Iterator<Item = &'m Map>) -> String {
    let mut text = "map,arrangement,k,error\n".to_owned();
    for map in maps {
        for row in &map.rows {
            for (k, outcome) in (map.first..).zip(&row.worst) {
                text.push_str(&format!("{},{},{k},{}\n", map.name, row.arrangement, written(*outcome)));
            }
        }
    }
    text
}

fn grid(study: &Study) -> String {
    let mut text = format!("method,{}\n", Count::COLUMNS.join(","));
    for count in &study.census.counts {
        let numbers = count.numbers().map(|number| number.to_string()).join(",");
        text.push_str(&format!("{},{numbers}\n", count.method));
    }
    text
}

fn tolerance(study: &Study) -> String {
    let mut text = "quantity,working,figures,scenes,wrong,within-a-unit,error-50,error-95,error-most,\
                    tolerance-50,tolerance-95,tolerance-most,beyond\n"
        .to_owned();
    for spread in &study.spreads {
        let numbers = spread.error.iter().chain(&spread.tolerance).map(|number| format!("{number:.3e}"));
        let row = format!(
            "\"{}\",\"{}\",{},{},{},{},{},{}\n",
            spread.quantity,
            spread.working,
            spread.figures,
            spread.scenes,
            spread.wrong,
            spread.within_a_unit,
            numbers.collect::<Vec<_>>().join(","),
            spread.beyond
        );
        text.push_str(&row);
    }
    text
}

fn as_json(study: &Study) -> Json {
    let map = |map: &Map| {
        let rows = map.rows.iter().map(|row| {
            let worst: Vec<Json> = row
                .worst
                .iter()
                .map(|outcome| match outcome.error() {
                    Some(error) => json!(error),
                    None => json!(written(*outcome)),
                })
                .collect();
            json!({"arrangement": row.arrangement, "says": row.says, "errors": worst})
        });
        let rows: Vec<Json> = rows.collect();
        json!({"map": map.name, "quantity": map.quantity, "regime": map.regime, "first_k": map.first, "rows": rows})
    };
    let maps: Vec<Json> = study.quantities.iter().chain(&study.velocities).map(map).collect();
    let count = |count: &Count| {
        let mut all = json!({"method": count.method});
        for (column, number) in Count::COLUMNS.into_iter().zip(count.numbers()) {
            all[column] = number.into();
        }
        all
    };
    let counts: Vec<Json> = study.census.counts.iter().map(count).collect();
    let spreads: Vec<Json> = study
        .spreads
        .iter()
        .map(|spread| {
            json!({
                "quantity": spread.quantity, "working": spread.working, "figures": spread.figures,
                "scenes": spread.scenes, "wrong": spread.wrong, "within_a_unit": spread.within_a_unit,
                "error": spread.error, "tolerance": spread.tolerance, "beyond": spread.beyond,
            })
        })
        .collect();
    let costs: Vec<Json> = study
        .costs
        .iter()
        .map(|cost| {
            json!({
                "name": cost.name, "kind": cost.work.name(), "scene": cost.scene, "steps": cost.steps,
                "nanoseconds": cost.nanoseconds, "ratio": cost.ratio, "error": cost.error,
            })
        })
        .collect();
    let (scenes, noughts, ties) = (study.census.scenes, study.census.noughts, study.census.ties);
    json!({
        "maps": maps, "claims": study.claims.claim, "counts": study.claims.count, "broken_claims": study.broken,
        "exam_grid": {"scenes": scenes, "noughts": noughts, "ties": ties, "methods": counts},
        "rounding_on_the_way": spreads, "times": costs,
    })
}
