//! `carom explain`: the whole story of a question: what it varies and demands, asks and marks, and where students go wrong.

mod as_json;
mod mistakes;

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;

use super::check::{Progress, StyleCount, counts};
use super::failure::Failure;
use super::output::{count, print, print_json, table};
use super::preview::subject::Subject;
use super::solve::worked;
use crate::bank::{Domain, Question, Style, read_question};
use crate::expr::print as written;
use crate::generate::{Variant, out_of, reference};
use crate::mechanics::Rule;
use crate::paper::{Dealer, PrintedAnswer, PrintedQuestion, compose};
use crate::solve::solve;
use mistakes::{LawMistakes, mistakes};

const AFTER: &str = "Examples:
  carom explain 5C-2
  carom explain rest/speeds-and-directions
  carom explain 5C-2 --json                       the same for other programs
  carom explain speeds --bank my-bank             a question of your own";

/// Explain a question: its numbers, its answers, its marks, and where students go wrong
///
/// Its parameters and their values, what is required of them and how many sets of numbers each requirement turns
/// away, its reference numbers with their answers, the steps of its solution, its marks, the slips that students make and
/// the wrong value that each leads to, and an example.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct ExplainArguments {
    /// The question: its id, a part of it, the exercise it mirrors, or the path of its file (new.toml)
    #[arg(value_name = "QUESTION")]
    question: String,
    /// A bank of your own
    #[arg(long, value_name = "DIR")]
    bank: Option<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

/// A question with its reference numbers, as they are printed, and the mistakes that they invite.
struct Reference {
    variant: Variant,
    printed: PrintedQuestion,
    mistakes: Vec<LawMistakes>,
}

impl Reference {
    fn of(question: &Question) -> Option<Reference> {
        let variant = reference(question).ok()?;
        let printed = compose(question, &variant, 1);
        // What is only required has steps too, but a student need not take them.
        let asked = solve(Arc::clone(&variant.scene), &question.asked());
        let variant = Variant { solution: asked.map_or_else(|_| variant.solution.clone(), Arc::new), ..variant };
        let mistakes = mistakes(question, &variant, &printed);
        Some(Reference { variant, printed, mistakes })
    }
}

/// Explains the question.
pub fn run(arguments: &ExplainArguments) -> Result<(), Failure> {
    let subject = Subject::find(&arguments.question, arguments.bank.as_deref(), None)?;
    let question = read_question(&subject.id, &subject.read()?.source)?;
    let progress = Progress::new([&question]);
    let styles = counts(&question, &progress);
    progress.finish();

    let known = Reference::of(&question);
    if arguments.json {
        return print_json(&as_json::story(&question, &styles, known.as_ref()));
    }

    let mut text = format!("{}\n{}\n", question.title, question.id);
    if let Some(mirrors) = &question.mirrors {
        text.push_str(&format!("practises the skills of {mirrors}\n"));
    }
    text.push_str(&format!("topic: {}; {}\n", question.topic, count(question.marks(), "mark")));
    if let Some(erratum) = &question.erratum {
        text.push_str(&format!("\nErratum\n  {erratum}\n"));
    }
    for (style, counted) in question.styles.iter().zip(&styles) {
        text.push_str(&style_in_words(&question, style, counted));
    }
    if let Some(known) = &known {
        text.push_str(&reference_in_words(&question, &known.printed));
        text.push_str(&steps(&known.variant));
        text.push_str(&marks(&known.printed));
        text.push_str(&mistakes::in_words(&known.mistakes));
    }
    if let Some(variant) = Dealer::new(1, None).next(&question) {
        let printed = compose(&question, &variant, 1);
        text.push_str(&example(&printed));
    }
    print(&text)
}

fn style_in_words(question: &Question, style: &Style, counted: &StyleCount) -> String {
    let census = &counted.census;
    let all = out_of(census.examined, census.size);
    let mut text = format!("\nStyle {}: {} of {all} sets of numbers\n", style.name, census.fit);
    let mut rows: Vec<Vec<String>> =
        style.parameters.iter().map(|(name, domain)| vec![format!("  {name}"), values(domain)]).collect();
    rows.extend(style.lets.iter().map(|(name, expr)| vec![format!("  {name}"), format!("= {}", written::plain(expr))]));
    text.push_str(&table(&rows));
    let turned: Vec<(String, u64)> = census.funnel(question, style);
    for requirement in &style.require {
        let away = turned.iter().find(|(reason, _)| *reason == format!("not `{}`", requirement.text));
        text.push_str(&format!(
            "  requires {}: turns away {}\n",
            requirement.text,
            away.map_or(0, |(_, count)| *count)
        ));
    }
    for (reason, count) in turned.iter().filter(|(reason, _)| !reason.starts_with("not `")) {
        text.push_str(&format!("  {reason}: turns away {count}\n"));
    }
    text
}

/// `1, 2, …, 6`, or the list.
fn values(domain: &Domain) -> String {
    const SHOWN: u64 = 12;
    // As it is typed in a file, for that is where the reader goes next.
    let value = |index| written::plain(&domain.value(index));
    let size = domain.size();
    if size <= SHOWN {
        return (0..size).map(value).collect::<Vec<_>>().join(", ");
    }
    format!("{}, {}, …, {} ({size} values)", value(0), value(1), value(size - 1))
}

/// The reference numbers, and what is found with them.
fn reference_in_words(question: &Question, printed: &PrintedQuestion) -> String {
    let numbers: Vec<String> =
        question.reference.iter().map(|(name, value)| format!("{name} = {}", written::plain(value))).collect();
    let mut rows = Vec::new();
    for part in &printed.parts {
        let label = if part.label.is_empty() { String::new() } else { format!("({})", part.label) };
        for answer in &part.answers {
            rows.push(vec![format!("  {label}"), written::text_unicode(&answer.name), value_in_words(answer)]);
        }
    }
    format!("\nReference numbers: {}\n{}", numbers.join(", "), table(&rows))
}

/// `4√39/9 ≈ 2.78 m s⁻¹`
fn value_in_words(answer: &PrintedAnswer) -> String {
    let values: Vec<String> = [&answer.exact, &answer.rounded].into_iter().flatten().map(written::unicode).collect();
    let unit = match answer.unit.plain() {
        // A direction in words has neither value nor unit.
        _ if values.is_empty() => String::new(),
        // A whole number of degrees says so itself.
        "deg" if values.iter().any(|value| value.ends_with('°')) => String::new(),
        "deg" => "°".to_owned(),
        unit => format!(" {unit}"),
    };
    format!("{}{} {}", values.join(" ≈ "), unit.trim_end(), written::text_unicode(&answer.phrase)).trim().to_owned()
}

fn steps(variant: &Variant) -> String {
    let row = |step: &Rule| {
        let gives: Vec<String> = step.gives.iter().map(ToString::to_string).collect();
        vec![format!("  {}", step.law.name()), gives.join(", ")]
    };
    let rows: Vec<Vec<String>> = variant.solution.steps().into_iter().map(row).collect();
    format!("\nSteps\n{}", table(&rows))
}

fn marks(printed: &PrintedQuestion) -> String {
    let mut rows = Vec::new();
    for part in &printed.parts {
        for row in &part.scheme {
            let label = if part.label.is_empty() { String::new() } else { format!("({})", part.label) };
            let mut earned = written::text_unicode(&row.in_one_line());
            if !row.note.is_empty() {
                earned.push_str(&format!(" [{}]", written::text_unicode(&row.note)));
            }
            if !row.depends.is_empty() {
                earned.push_str(&format!(" (needs {})", row.depends.join(", ")));
            }
            rows.push(vec![format!("  {label}"), row.id.clone(), row.code.clone(), earned]);
        }
    }
    format!("\nMarks\n{}", table(&rows))
}

fn example(printed: &PrintedQuestion) -> String {
    let mut text = "\nAn example\n\n".to_owned();
    for paragraph in &printed.stem {
        text.push_str(&format!("{}\n\n", written::text_unicode(paragraph)));
    }
    for part in &printed.parts {
        let label = if part.label.is_empty() { String::new() } else { format!("({}) ", part.label) };
        text.push_str(&format!("{label}{} [{}]\n\n", written::text_unicode(&part.ask), count(part.marks(), "mark")));
        text.push_str(&worked(&part.working));
        text.push('\n');
    }
    text
}
