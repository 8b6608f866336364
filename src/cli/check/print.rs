//! What was found, in words and as JSON.

use serde_json::{Value as Json, json};

use super::Examined;
use crate::cli::output::{count, table};
use crate::diagnostic::{Diagnostic, Severity, render_all};
use crate::examine::{StyleReport, Turned};
use crate::generate::out_of;

/// A line for each style, with all of its funnel if that is wanted; then how much was found, and in how many files there
/// may be more.
pub fn in_words(examined: &[Examined], findings: usize, unread: usize, with_census: bool) -> String {
    let mut text = String::new();
    for one in examined {
        text.push_str(&format!("{}\n", one.question.id));
        let rows: Vec<Vec<String>> = one.report.styles.iter().map(row).collect();
        if with_census {
            for (row, style) in rows.iter().zip(&one.report.styles) {
                text.push_str(&format!("  {}\n{}", row[..3].join(" ").trim(), census(style)));
            }
        } else {
            text.push_str(&table(&rows));
        }
    }
    let of_styles = || examined.iter().flat_map(|one| &one.report.styles);
    let sets = out_of(of_styles().map(|style| style.examined).sum(), of_styles().map(|style| style.sets).sum());
    let variants: u64 = of_styles().map(|style| style.variants).sum();
    let coverage = || examined.iter().map(|one| &one.report.coverage);
    let scripts: usize = coverage().map(|coverage| coverage.scripts).sum();
    let marks: usize = coverage().map(|coverage| coverage.marks.len()).sum();
    let idle: usize = coverage().map(|coverage| coverage.idle().count()).sum();
    text.push_str(&format!(
        "{} of {marks} marks won and lost by the {scripts} scripts of synthetic students\n",
        marks - idle
    ));
    let questions = count(examined.len(), "question");
    text.push_str(&format!(
        "{questions}, {variants} variants of {sets} sets of numbers, {}",
        count(findings, "finding")
    ));
    if unread > 0 {
        text.push_str(&format!(", {} not read", count(unread, "file")));
    }
    text.push('\n');
    text
}

/// A style on one line: its name, how many variants it has, the dearest requirement, what would give most.
fn row(style: &StyleReport) -> Vec<String> {
    let dearest = style.dearest().map(|turned| (requirement(turned), turned.count));
    let dearest = dearest.map_or_else(String::new, |(text, count)| format!("`{text}` turns away {count}"));
    vec![
        format!("  {}", style.style),
        format!("{} of {} sets", style.variants, out_of(style.examined, style.sets)),
        forms(&style.all_forms()),
        dearest,
        style.relaxation().map_or_else(String::new, relaxed),
    ]
}

fn requirement(turned: &Turned) -> &str {
    turned.requirement.as_deref().unwrap_or_default()
}

fn relaxed(turned: &Turned) -> String {
    let (about, number) = about(turned);
    format!("without `{}` {about}{}", requirement(turned), count_of(number, "more variant"))
}

/// What was counted, or that it was estimated, and then only its first two figures.
fn about(turned: &Turned) -> (&'static str, u64) {
    let number = turned.alone;
    let unit = 10_u64.pow(number.max(1).ilog10().saturating_sub(1));
    if turned.one_in > 1 { ("about ", (number + unit / 2) / unit * unit) } else { ("", number) }
}

fn count_of(number: u64, thing: &str) -> String {
    count(usize::try_from(number).unwrap_or(usize::MAX), thing)
}

/// `12 whole, 30 surd`
fn forms(forms: &[(String, u64)]) -> String {
    forms.iter().map(|(form, count)| format!("{count} {form}")).collect::<Vec<_>>().join(", ")
}

/// The whole funnel of a style: what is left after each thing that turns sets away, and how many there would be more
/// without it; then the form of each answer.
pub fn census(style: &StyleReport) -> String {
    let mut left = style.examined;
    let mut rows = vec![vec![format!("    {left}"), "sets of numbers".to_owned()]];
    for turned in &style.turned_away {
        left -= turned.count.min(left);
        let reason = turned.requirement.as_ref().map_or(turned.reason.clone(), |text| format!("`{text}`"));
        let (about, alone) = about(turned);
        let alone = if alone > 0 { format!("{about}{alone} more without it") } else { String::new() };
        rows.push(vec![format!("    {left}"), reason, format!("−{}", turned.count), alone]);
    }
    let mut text = table(&rows);
    let answers: Vec<Vec<String>> =
        style.forms.iter().map(|answer| vec![format!("    {}", answer.answer), forms(&answer.forms)]).collect();
    text.push_str(&table(&answers));
    for hidden in &style.hidden {
        text.push_str(&format!("    hides `{}` in {}\n", hidden.slip, count_of(hidden.count, "variant")));
    }
    text
}

/// All that is known, for other programs.
pub fn as_json(bank: &str, examined: &[Examined], faults: &[Diagnostic]) -> Json {
    let question = |one: &Examined| {
        let coverage = &one.report.coverage;
        json!({
            "id": one.question.id, "styles": one.report.styles, "scripts": coverage.scripts, "marks": coverage.marks,
        })
    };
    let fault = |fault: &Diagnostic| {
        json!({
            "severity": if fault.severity == Severity::Warning { "warning" } else { "error" },
            "message": fault.message, "file": &*fault.source.file, "line": fault.line(), "help": fault.help,
            "picture": render_all(std::slice::from_ref(fault), false),
        })
    };
    let questions: Vec<Json> = examined.iter().map(question).collect();
    let faults: Vec<Json> = faults.iter().map(fault).collect();
    json!({"bank": bank, "questions": questions, "faults": faults})
}
