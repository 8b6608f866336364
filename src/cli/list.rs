//! `carom list`: the questions of a bank.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::bank;
use super::check::{Progress, StyleCount, counts};
use super::failure::Failure;
use super::output::{count, print, print_json, table};

const AFTER: &str = "Examples:
  carom list                  every question with its topic, marks, styles and numbers of variants
  carom list --bank my-bank   those of a bank of your own";

/// List the questions
///
/// One line a question: its id, the exercise it mirrors, its topic, its marks and how many different sets of numbers
/// each style has.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct ListArguments {
    /// A bank of your own
    #[arg(long, value_name = "DIR")]
    bank: Option<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

/// Lists the questions.
pub fn run(arguments: &ListArguments) -> Result<(), Failure> {
    let contents = bank::open(arguments.bank.as_deref())?;
    let mut questions = Vec::new();
    let mut faults = Vec::new();
    for heading in &contents.headings {
        match heading.question() {
            Ok(question) => questions.push(question),
            Err(found) => faults.extend(found),
        }
    }
    let progress = Progress::new(&questions);
    let mut rows = vec![["id", "mirrors", "topic", "marks", "variants"].map(str::to_owned).to_vec()];
    let mut listed = Vec::new();
    for question in &questions {
        let styles = counts(question, &progress);
        let variants: Vec<String> = styles.iter().map(in_words).collect();
        listed.push(json!({
            "id": question.id, "title": question.title, "mirrors": question.mirrors, "topic": question.topic,
            "marks": question.marks(), "styles": styles.iter().map(StyleCount::json).collect::<Vec<_>>(),
        }));
        rows.push(vec![
            question.id.clone(),
            question.mirrors.clone().unwrap_or_default(),
            question.topic.clone(),
            question.marks().to_string(),
            variants.join(", "),
        ]);
    }
    progress.finish();
    if arguments.json {
        print_json(&json!({"bank": contents.name, "questions": listed}))?;
    } else {
        print(&format!("{}{}\n", table(&rows), count(questions.len(), "question")))?;
    }
    if faults.is_empty() { Ok(()) } else { Err(Failure::Faults(faults)) }
}

/// `60 exact`; of very many sets of numbers the last are not examined.
fn in_words(StyleCount { style, census }: &StyleCount) -> String {
    let or_more = if census.examined < census.size { " or more" } else { "" };
    format!("{}{or_more} {style}", census.fit)
}
