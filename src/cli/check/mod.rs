//! `carom check`: a bank examined: every file, every reference answer, every variant.

mod cache;
mod print;
mod progress;

use std::path::PathBuf;

use clap::Args;

use self::cache::Cache;
pub use self::progress::{Progress, StyleCount, counts};
use super::bank;
use super::failure::{Failure, warn};
use super::output::{print as print_text, print_json};
use crate::bank::{Heading, Question};
use crate::diagnostic::{Diagnostic, Severity};
use crate::examine::{Report, neighbours, survey};

const AFTER: &str = "Examples:
  carom check             the bank inside carom
  carom check my-bank     a bank of your own: every fault with its line, and its variants
  carom check my-bank --census
                          and how each requirement turns numbers away

What was found sound is remembered until the file of the question, or carom, changes; --fresh forgets it.";

/// Examine a bank: every variant that it can print
///
/// Reads every question, works out its reference answers and compares them with yours, tries every set of numbers that
/// its styles allow, reads the words of every variant, sees whether each mistake that students make would show in its
/// numbers, and marks scripts of synthetic students, whose marks are known.
/// Exits with 1 if anything must be mended; a warning stops nothing.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct CheckArguments {
    /// The folder of the bank; without it the one inside carom
    #[arg(value_name = "BANK")]
    bank: Option<PathBuf>,
    /// Show how many sets of numbers each requirement turns away, and the forms of the answers
    #[arg(long)]
    census: bool,
    /// Examine every question anew, whatever is remembered of it
    #[arg(long)]
    fresh: bool,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

/// A question that could be read, with what came of it.
struct Examined<'h> {
    heading: &'h Heading,
    question: Question,
    report: Report,
}

/// Examines the bank.
pub fn run(arguments: &CheckArguments) -> Result<(), Failure> {
    let contents = bank::in_part(arguments.bank.as_deref())?;
    let mut faults: Vec<Diagnostic> = contents.unreadable.clone();
    let mut read: Vec<(&Heading, Question)> = Vec::new();
    let mut unread = contents.unreadable.len();
    for heading in &contents.headings {
        match heading.question() {
            Ok(question) => read.push((heading, question)),
            Err(found) => {
                unread += 1;
                faults.extend(found);
            }
        }
    }
    let examined = examine(read, arguments.fresh);
    for one in &examined {
        let found = one.report.findings.iter();
        faults.extend(found.map(|finding| finding.diagnostic(&one.question.id, &one.heading.source)));
    }
    faults.extend(neighbours(&contents.headings));
    let is_sound = faults.iter().all(|fault| fault.severity == Severity::Warning);
    if arguments.json {
        print_json(&print::as_json(&contents.name, &examined, &faults))?;
        return if is_sound { Ok(()) } else { Err(Failure::Found) };
    }
    print_text(&print::in_words(&examined, faults.len(), unread, arguments.census))?;
    if is_sound {
        warn(&faults);
        return Ok(());
    }
    Err(Failure::Faults(faults))
}

/// What is remembered of a question that was found sound.
pub fn remembered(heading: &Heading) -> Option<Report> {
    Cache::open()?.sound(heading)
}

/// Examines what is not remembered to be sound.
fn examine(read: Vec<(&Heading, Question)>, is_fresh: bool) -> Vec<Examined<'_>> {
    let cache = Cache::open();
    let remembered = |heading: &Heading| if is_fresh { None } else { cache.as_ref()?.sound(heading) };
    let known: Vec<Option<Report>> = read.iter().map(|(heading, _)| remembered(heading)).collect();
    let unknown: Vec<&Question> =
        read.iter().zip(&known).filter(|(_, known)| known.is_none()).map(|((_, question), _)| question).collect();
    let progress = Progress::new(unknown.iter().copied());
    let mut found = survey(&unknown, &|step| progress.advance(step)).into_iter();
    progress.finish();
    let mut examined = Vec::new();
    for ((heading, question), known) in read.into_iter().zip(known) {
        let report = known.unwrap_or_else(|| {
            let report = found.next().unwrap_or_default();
            if let Some(cache) = &cache {
                cache.remember(heading, &report);
            }
            report
        });
        examined.push(Examined { heading, question, report });
    }
    examined
}
