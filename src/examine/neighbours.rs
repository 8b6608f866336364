//! What is amiss between the questions of a bank: one that stands there twice, and topics that differ by a slip of the pen.

use toml::Table;

use crate::bank::Heading;
use crate::diagnostic::{Diagnostic, Severity};

/// Warnings of questions that are the same but for their names, and of topics that no other question has.
pub fn neighbours(headings: &[Heading]) -> Vec<Diagnostic> {
    let bodies: Vec<Option<Table>> = headings.iter().map(body).collect();
    let mut found = Vec::new();
    for (place, heading) in headings.iter().enumerate() {
        let is_same = |other: &usize| bodies[place].is_some() && bodies[*other] == bodies[place];
        if let Some(first) = (0..place).find(is_same) {
            let message = format!("`{}` and `{}` are one question", headings[first].id, heading.id);
            let help = "take one of the two files away, or change what it asks: a paper might have both";
            found.push(warning(heading, message, &heading.title, "the same scene, words and marks", help));
        }
        if let Some(other) = other_topic(heading, headings) {
            let message = format!("`{}` is the only question on the topic `{}`", heading.id, heading.topic);
            let label = format!("others have `{other}`");
            let help = format!("write `{other}`, if that is what was meant");
            found.push(warning(heading, message, &heading.topic, &label, &help));
        }
    }
    found
}

/// What a file holds beside what it is called. None of what cannot be read, or has no scene, which is told elsewhere.
fn body(heading: &Heading) -> Option<Table> {
    let mut body: Table = toml::from_str(&heading.source.text).ok()?;
    ["title", "topic", "mirrors", "erratum"].into_iter().for_each(|name| drop(body.remove(name)));
    body.contains_key("scene").then_some(body)
}

/// A topic of other questions that differs from that of this one alone by one letter, or by capitals. One with a digit may
/// well be the next of a row.
fn other_topic<'h>(heading: &Heading, headings: &'h [Heading]) -> Option<&'h str> {
    const SHORTEST: usize = 5;
    let own = heading.topic.as_str();
    let count = |topic: &str| headings.iter().filter(|other| other.topic == topic).count();
    let has_digit = own.contains(|sign: char| sign.is_ascii_digit());
    if own.chars().count() < SHORTEST || has_digit || count(own) > 1 {
        return None;
    }
    let is_near = |topic: &str| topic != own && strsim::osa_distance(&topic.to_lowercase(), &own.to_lowercase()) <= 1;
    let others = headings.iter().map(|other| other.topic.as_str()).filter(|topic| is_near(topic));
    // Of two that both stand alone nobody knows which is meant, and one is told.
    others.max_by_key(|topic| count(topic)).filter(|topic| count(topic) > 1 || *topic < own)
}

/// A warning where a name stands in the file of a question.
fn warning(heading: &Heading, message: String, name: &str, label: &str, help: &str) -> Diagnostic {
    let start = heading.source.text.find(&format!("\"{name}\"")).unwrap_or_default();
    let fault = Diagnostic::new(message, &heading.source, start..start + name.len() + 2, label).with_help(help);
    Diagnostic { severity: Severity::Warning, ..fault }
}
