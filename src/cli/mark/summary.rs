//! A class at a glance, on a terminal or as JSON.

use serde_json::{Value as Json, json};

use super::super::output::{count, line_length, table};
use crate::expr::print::words_unicode;
use crate::mark::report::{Facility, Look, MarkWon, Summary};

/// How many notes, and how many things to look at, are told on a terminal.
const TOLD: usize = 10;

/// The summary as JSON; the mean is in marks, the facility of a question in per cent.
pub fn as_json(summary: &Summary, not_marked: usize) -> Json {
    let questions = summary.questions.iter().map(|facility| {
        let mut question = json!(facility);
        question["facility"] = facility.per_cent().into();
        question
    });
    let questions: Vec<Json> = questions.collect();
    let mut all = json!(summary);
    all["mean"] = (summary.mean_in_tenths() as f64 / 10.0).into();
    all["questions"] = questions.into();
    all["not_marked"] = not_marked.into();
    all
}

/// The summary in words.
pub fn in_words(summary: &Summary) -> String {
    let mean = summary.mean_in_tenths();
    let (whole, tenth) = (mean / 10, mean % 10);
    let students = count(summary.students, "student");
    let mut text = format!("{students}, {whole}.{tenth} of {} marks on average\n\n", summary.available);
    text.push_str(&questions(&summary.questions));
    if !summary.notes.is_empty() {
        text.push_str("\nMost frequent notes\n");
        let rows = summary.notes.iter().take(TOLD);
        let rows: Vec<Vec<String>> = rows.map(|note| vec![format!("  {:>4}", note.count), note.note.clone()]).collect();
        text.push_str(&table(&rows));
    }
    if !summary.look.is_empty() {
        text.push_str(&format!("\nFor you to look at: {}\n", summary.look.len()));
        for look in summary.look.iter().take(TOLD) {
            text.push_str(&looked_at(look));
        }
        if summary.look.len() > TOLD {
            text.push_str(&format!("  and {} more: `--json` lists them all\n", summary.look.len() - TOLD));
        }
    }
    text
}

/// A row for each question, and below it how many won each mark.
fn questions(all: &[Facility]) -> String {
    let mut rows = vec![["Question", "scripts", "marks", "each mark, and how many won it"].map(str::to_owned).to_vec()];
    for facility in all {
        let head = [
            format!("{:>8}", facility.number),
            format!("{:>7}", facility.scripts),
            format!("{:>4}%", facility.per_cent()),
        ];
        let mut lines = wrapped(&won(&facility.scheme)).into_iter();
        let mut row = head.to_vec();
        row.push(lines.next().unwrap_or_default());
        rows.push(row);
        rows.extend(lines.map(|line| vec![String::new(), String::new(), String::new(), line]));
    }
    table(&rows)
}

/// `(a) M1a 12`, the label before the first mark of its part.
fn won(scheme: &[MarkWon]) -> Vec<String> {
    let mut part = "";
    let each = scheme.iter().map(|mark| {
        let label = if mark.part == part { String::new() } else { format!("({}) ", mark.part) };
        part = &mark.part;
        format!("{label}{} {}", mark.id, mark.won)
    });
    each.collect()
}

/// Pieces with commas, in lines that fit beside the other columns.
fn wrapped(pieces: &[String]) -> Vec<String> {
    const BESIDE: usize = 26;
    let room = line_length().saturating_sub(BESIDE).max(20);
    let mut lines: Vec<String> = Vec::new();
    for piece in pieces {
        match lines.last_mut() {
            Some(line) if line.chars().count() + piece.chars().count() + 2 <= room => {
                line.push_str(", ");
                line.push_str(piece);
            }
            _ => lines.push(piece.clone()),
        }
    }
    lines
}

fn looked_at(look: &Look) -> String {
    let part = if look.part.is_empty() { String::new() } else { format!("({})", look.part) };
    let place = if look.place.is_empty() { String::new() } else { format!(", {}", look.place) };
    let line = format!("  {}, question {}{part}{place}: {}", short(&look.student), look.question, short(&look.typed));
    format!("{line}\n")
}

/// Harmless, and not longer than one reads.
fn short(typed: &str) -> String {
    const LONGEST: usize = 40;
    let typed = words_unicode(typed);
    match typed.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("{}…", &typed[..cut]),
        None => typed,
    }
}
