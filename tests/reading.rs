//! What students type and how it is read: a table of examples, and the page that shows the ambiguous ones.

use carom::mark::reading::{Unreadable, Vocabulary, read_answer};
use carom::number::{Letter, Range};
use serde::Deserialize;

#[derive(Deserialize)]
struct Table {
    row: Vec<Row>,
}

/// One row: what is typed, the letters of the question, and every reading or why there is none.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    typed: String,
    #[serde(default)]
    letters: String,
    #[serde(default)]
    readings: Vec<String>,
    #[serde(default)]
    decided: Vec<String>,
    unreadable: Option<String>,
}

/// The letters by their names; `i j` says that they are unit vectors.
fn vocabulary(letters: &str) -> Vocabulary {
    let letter = |name: &str| {
        let range = match name {
            "e" => Range::Unit,
            "alpha" | "beta" | "theta" => Range::Acute,
            "x" => Range::Real,
            _ => Range::Positive,
        };
        Letter::new(name, range).expect(name)
    };
    let vectors = letters.contains("i j");
    let names = letters.split_whitespace().filter(|name| !vectors || !matches!(*name, "i" | "j"));
    Vocabulary { letters: names.map(letter).collect(), vectors }
}

fn reason(unreadable: Unreadable) -> String {
    match unreadable {
        Unreadable::Blank => "blank".to_owned(),
        Unreadable::TooLong => "too long".to_owned(),
        Unreadable::Sign(_, reason) => reason,
    }
}

#[test]
fn carom_reads_what_students_type() {
    let table: Table = toml::from_str(include_str!("data/readings.toml")).unwrap();
    assert!(table.row.len() >= 250, "{}", table.row.len());
    let mut complaints = Vec::new();
    for row in &table.row {
        let said = match read_answer(&row.typed, &vocabulary(&row.letters)) {
            Ok(readings) => {
                let printed: Vec<String> = readings.iter().map(|reading| reading.printed.clone()).collect();
                (printed, readings[0].decided.clone(), None)
            }
            Err(unreadable) => (Vec::new(), Vec::new(), Some(reason(unreadable))),
        };
        if said != (row.readings.clone(), row.decided.clone(), row.unreadable.clone()) {
            complaints.push(format!("{:?} with `{}`: {said:?}", row.typed, row.letters));
        }
    }
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// The rows of the table in `docs/marking.md` under the heading on ambiguous notation.
fn shown() -> Vec<Vec<String>> {
    let page = include_str!("../docs/marking.md");
    let section = page.split("## How ambiguous notation is read").nth(1).expect("the section");
    let section = section.split("\n## ").next().unwrap_or(section);
    let rows = section.lines().filter(|line| line.starts_with("| `"));
    rows.map(|line| line.trim_matches('|').split(" | ").map(|cell| cell.trim().replace('`', "")).collect()).collect()
}

#[test]
fn carom_shows_how_ambiguous_notation_is_read() {
    let rows = shown();
    assert!(rows.len() >= 15, "{}", rows.len());
    for row in rows {
        let [typed, letters, first, others] = &row[..] else { panic!("four cells: {row:?}") };
        let readings = match read_answer(typed, &vocabulary(letters)) {
            Ok(readings) => readings.into_iter().map(|reading| reading.printed).collect(),
            Err(unreadable) => vec![format!("unreadable: {}", reason(unreadable)).replace('`', "")],
        };
        assert_eq!(readings[0], *first, "{typed}");
        assert_eq!(readings[1..].join(", "), *others, "{typed}");
    }
}
