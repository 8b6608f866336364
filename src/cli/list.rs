//! `carom list`: the questions of a bank.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value as Json, json};

use super::bank;
use super::check::{Progress, StyleCount, counts, remembered};
use super::failure::Failure;
use super::output::{count, print, print_json, table};
use crate::bank::{Heading, Question};
use crate::examine::StyleReport;
use crate::generate::Census;

const AFTER: &str = "Examples:
  carom list                  every question with its topic, marks and styles
  carom list --count          and how many variants each style has
  carom list --bank my-bank   those of a bank of your own";

/// List the questions
///
/// One line a question: its id, the exercise it mirrors, its topic, its marks and its styles. How many variants a style
/// has is known of what `carom check` has examined; of the rest, `--count` finds it.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct ListArguments {
    /// A bank of your own
    #[arg(long, value_name = "DIR")]
    bank: Option<PathBuf>,
    /// Count the variants of what has not been examined yet, which takes some time
    #[arg(long)]
    count: bool,
    /// Print as JSON, all variants counted
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
            Ok(question) => questions.push((heading, question)),
            Err(found) => faults.extend(found),
        }
    }
    let known: Vec<Option<Vec<Listed>>> = questions.iter().map(|(heading, _)| already_counted(heading)).collect();
    let counts_all = arguments.count || arguments.json;
    let open = questions.iter().zip(&known).filter(|(_, known)| counts_all && known.is_none());
    let progress = Progress::new(open.map(|((_, question), _)| question));
    let mut rows = vec![["id", "mirrors", "topic", "marks", "styles and variants"].map(str::to_owned).to_vec()];
    let mut listed = Vec::new();
    let mut is_open = false;
    for ((_, question), known) in questions.iter().zip(known) {
        let styles = match known {
            Some(known) => known,
            None if counts_all => count_now(question, &progress),
            None => question.styles.iter().map(|style| Listed { style: style.name.to_string(), count: None }).collect(),
        };
        is_open |= styles.iter().any(|style| style.count.is_none());
        let variants: Vec<String> = styles.iter().map(Listed::in_words).collect();
        listed.push(json!({
            "id": question.id, "title": question.title, "mirrors": question.mirrors, "topic": question.topic,
            "marks": question.marks(), "styles": styles.iter().map(Listed::json).collect::<Vec<_>>(),
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
        if is_open {
            print("`carom list --count` says how many variants each style has\n")?;
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(Failure::Faults(faults)) }
}

/// A style, and how many variants it has, if they have been counted.
struct Listed {
    style: String,
    count: Option<Count>,
}

/// Sets of numbers, those that have been examined, and those that are fit for print.
struct Count {
    sets: u64,
    examined: u64,
    variants: u64,
}

/// What an examination has counted.
fn already_counted(heading: &Heading) -> Option<Vec<Listed>> {
    let one = |style: StyleReport| {
        let StyleReport { style, sets, examined, variants, .. } = style;
        Listed { style, count: Some(Count { sets, examined, variants }) }
    };
    Some(remembered(heading)?.styles.into_iter().map(one).collect())
}

fn count_now(question: &Question, progress: &Progress) -> Vec<Listed> {
    let one = |StyleCount { style, census }| {
        let Census { size: sets, examined, fit: variants, .. } = census;
        Listed { style: style.to_string(), count: Some(Count { sets, examined, variants }) }
    };
    counts(question, progress).into_iter().map(one).collect()
}

impl Listed {
    /// `60 exact`; of very many sets of numbers the last are not examined.
    fn in_words(&self) -> String {
        match &self.count {
            None => self.style.clone(),
            Some(Count { sets, examined, variants }) => {
                let or_more = if examined < sets { " or more" } else { "" };
                format!("{variants}{or_more} {}", self.style)
            }
        }
    }

    fn json(&self) -> Json {
        let of = |number: fn(&Count) -> u64| self.count.as_ref().map(number);
        let [sets, examined, variants] =
            [of(|count| count.sets), of(|count| count.examined), of(|count| count.variants)];
        json!({"style": self.style, "sets": sets, "examined": examined, "variants": variants})
    }
}
