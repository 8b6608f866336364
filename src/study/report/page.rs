//! The page that explains a study to a teacher, as HTML with its charts inside and as Markdown with charts beside it.
//!
//! Both say the same words, which stand in `words.toml`; the two templates hold the layout.

use serde::Deserialize;
use serde_json::{Value as Json, json};
use tera::{Context, Tera};

use super::{Study, short};
use crate::render::RenderedFile;
use crate::study::chart::{Chart, Work};
use crate::study::claim::Claim;
use crate::study::work::PLAIN;

const WORDS: &str = include_str!("words.toml");
const HTML: &str = include_str!("methods.html");
const MARKDOWN: &str = include_str!("methods.md");

#[derive(Deserialize)]
struct Words {
    title: String,
    lead: Vec<String>,
    section: Vec<Section>,
}

#[derive(Deserialize)]
struct Section {
    chart: Option<String>,
    table: Option<String>,
    title: String,
    shows: Vec<String>,
    means: Vec<String>,
}

/// One file, without a script and without the network.
pub fn html(study: &Study, charts: &[Chart]) -> Result<RenderedFile, String> {
    fill("methods.html", HTML, true, study, &|name| {
        charts.iter().find(|chart| chart.name == name).map(|chart| chart.svg.clone()).unwrap_or_default()
    })
}

/// For a folder in which the charts are `methods/NAME.svg`.
pub fn markdown(study: &Study) -> Result<RenderedFile, String> {
    fill("methods.md", MARKDOWN, false, study, &|_| String::new())
}

fn fill(
    name: &str,
    template: &str,
    escaped: bool,
    study: &Study,
    picture: &dyn Fn(&str) -> String,
) -> Result<RenderedFile, String> {
    let words: Words = toml::from_str(WORDS).map_err(|error| format!("words.toml: {error}"))?;
    let section = |section: &Section| {
        let table = section.table.as_deref().map(|table| self::table(table, study));
        json!({
            "title": section.title, "shows": section.shows, "means": section.means, "chart": section.chart,
            "picture": section.chart.as_deref().map(picture), "table": table,
        })
    };
    let sections: Vec<Json> = words.section.iter().map(section).collect();
    let page = json!({"title": words.title, "lead": words.lead, "sections": sections, "broken": study.broken});
    let mut tera = Tera::new();
    tera.autoescape_on(if escaped { vec![""] } else { vec![] });
    let said = |error: tera::Error| format!("{name}: {error}");
    tera.add_raw_template(name, template).map_err(said)?;
    let mut context = Context::new();
    context.insert("page", &page);
    let contents = tera.render(name, &context).map_err(said)?;
    Ok(RenderedFile { name: name.to_owned(), contents })
}

/// A table of the page: its head, and its rows as cells.
fn table(name: &str, study: &Study) -> Json {
    let (head, rows) = match name {
        "claims-velocities" => claims(study, &study.velocities),
        "claims-quantities" => claims(study, &study.quantities),
        "grid" => grid(study),
        "tolerance" => tolerance(study),
        _ => times(study),
    };
    json!({"head": head, "rows": rows})
}

type Table = (Vec<String>, Vec<Vec<String>>);

fn named(head: &[&str]) -> Vec<String> {
    head.iter().map(|word| (*word).to_owned()).collect()
}

fn claims(study: &Study, maps: &[crate::study::Map]) -> Table {
    let row = |claim: &Claim| {
        let map = maps.iter().find(|map| map.name == claim.map)?;
        let holds = match (claim.holds_to, claim.fails_from) {
            (Some(_), None) => "always".to_owned(),
            (None, _) => "never".to_owned(),
            (Some(k), _) => format!("up to k = {k}"),
        };
        let fails = match (claim.fails_from, claim.holds_again) {
            (None, _) => "nowhere".to_owned(),
            (Some(k), None) => format!("from k = {k}"),
            (Some(k), Some(again)) => format!("from k = {k}, holds again from {again}"),
        };
        let within = match claim.bound {
            0.0 => "exact".to_owned(),
            5e-4 => "three figures".to_owned(),
            bound => format!("{bound:e}"),
        };
        let place = format!("{}, {}", map.quantity, map.regime);
        Some(vec![place, claim.arrangement.clone(), within, holds, fails, claim.sentence.clone()])
    };
    let head = named(&["where", "how", "within", "holds", "fails", "what to know"]);
    (head, study.claims.claim.iter().filter_map(row).collect())
}

fn grid(study: &Study) -> Table {
    let census = &study.census;
    let head = named(&[
        "method",
        "something where nothing is",
        "wrong as formatted",
        "wrong as multiplied and rounded",
        "wrong by way of 15 figures",
        "left open",
    ]);
    let share = |count: u64, of: u64| format!("{count} ({:.2}%)", 100.0 * count as f64 / of.max(1) as f64);
    let values = 2 * census.scenes - census.noughts;
    let row = |count: &crate::study::Count| {
        vec![
            count.method.clone(),
            share(count.ghosts, census.noughts),
            share(count.formatted, values),
            share(count.multiplied, values),
            share(count.fifteen, values),
            count.undecided.to_string(),
        ]
    };
    (head, census.counts.iter().map(row).collect())
}

fn tolerance(study: &Study) -> Table {
    let head = named(&[
        "quantity",
        "figures kept",
        "another third figure",
        "within one unit",
        "off by, 95 in 100",
        "off by, at most",
        "honest tolerance, 95 in 100",
    ]);
    let row = |spread: &crate::study::Spread| {
        let share = |count: usize| format!("{:.1}%", 100.0 * count as f64 / spread.scenes as f64);
        vec![
            format!("{} ({})", spread.quantity, spread.working),
            spread.figures.to_string(),
            share(spread.wrong),
            share(spread.within_a_unit),
            format!("{} units", short(spread.error[1])),
            format!("{} units", short(spread.error[2])),
            format!("{:.2}%", 100.0 * spread.tolerance[1]),
        ]
    };
    (head, study.spreads.iter().map(row).collect())
}

fn times(study: &Study) -> Table {
    let head = named(&["method", "kind", "scene", "steps", "ns", &format!("times `{PLAIN}`"), "worst error"]);
    let row = |cost: &crate::study::Cost| {
        let error = match cost.error {
            Some(0.0) => "0".to_owned(),
            Some(error) => format!("{error:.0e}"),
            None if cost.work == Work::Exact => "0".to_owned(),
            None => String::new(),
        };
        vec![
            cost.name.clone(),
            cost.work.words().to_owned(),
            cost.scene.clone(),
            cost.steps.map_or(String::new(), |steps| steps.to_string()),
            short(cost.nanoseconds),
            short(cost.ratio),
            error,
        ]
    };
    (head, study.charted().map(row).collect())
}
