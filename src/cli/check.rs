//! `carom check`: a bank examined: every file, every reference answer, every variant.

use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value as Json, json};

use super::bank;
use super::failure::{Failure, warn};
use super::output::{count, print, print_json};
use crate::answer::Kind;
use crate::bank::{Question, Style, StyleName};
use crate::diagnostic::{Diagnostic, Severity, render_all};
use crate::examine::{Coverage, MarkCount, coverage};
use crate::expr::{Angles, print as written};
use crate::generate::{Census, Deal, enumerate, reference};
use crate::mechanics::Scene;
use crate::paper::{KeyQuestion, compose, key_question};
use crate::solve::solve;

const AFTER: &str = "Examples:
  carom check             the bank inside carom
  carom check my-bank     a bank of your own: every fault with its line, and its variants";

/// Examine a bank: every variant that it can print
///
/// Reads every question, works out its reference answers, tries every set of numbers that its styles allow, and marks
/// scripts of synthetic students, whose marks are known.
/// Exits with 1 if anything is wrong.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct CheckArguments {
    /// The folder of the bank; without it the one inside carom
    #[arg(value_name = "BANK")]
    bank: Option<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

/// A style with what became of its sets of numbers.
pub struct StyleCount {
    /// The style.
    pub style: StyleName,
    /// The count.
    pub census: Census,
}

impl StyleCount {
    /// As `--json` has it.
    pub fn json(&self) -> Json {
        json!({"style": self.style.name(), "sets": self.census.size, "variants": self.census.fit})
    }
}

/// Every style of a question, enumerated.
pub fn counts(question: &Question, progress: &Progress) -> Vec<StyleCount> {
    let one = |style: &Style| {
        let before = progress.bar.position();
        let census = enumerate(question, style, &|_| (), &|done| progress.at(before, done));
        progress.bar.set_position(before + style.size());
        StyleCount { style: style.name, census }
    };
    question.styles.iter().map(one).collect()
}

/// How many sets of numbers have been tried, on a terminal; nothing in a pipe.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// The progress through all styles of some questions.
    pub fn new<'q>(questions: impl IntoIterator<Item = &'q Question>) -> Progress {
        let styles = questions.into_iter().flat_map(|question| &question.styles);
        // The bar draws itself on stderr, and not at all if that is no terminal.
        let bar = ProgressBar::new(styles.map(Style::size).sum());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} sets of numbers, {eta} left") {
            bar.set_style(style);
        }
        Progress { bar }
    }

    fn at(&self, before: u64, done: u64) {
        // Threads finish out of order.
        let position = before + done;
        if position > self.bar.position() {
            self.bar.set_position(position);
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Examines the bank.
pub fn run(arguments: &CheckArguments) -> Result<(), Failure> {
    let contents = bank::open(arguments.bank.as_deref())?;
    let mut questions = Vec::new();
    let mut faults: Vec<Diagnostic> = Vec::new();
    for heading in &contents.headings {
        match heading.question() {
            Ok(question) => {
                faults.extend(reference_faults(&question, heading));
                questions.push((heading, question));
            }
            Err(found) => faults.extend(found),
        }
    }
    let progress = Progress::new(questions.iter().map(|(_, question)| question));
    let mut examined = Vec::new();
    for (heading, question) in &questions {
        let styles = counts(question, &progress);
        for StyleCount { style, census } in &styles {
            if census.fit == 0 {
                let help = format!("`carom explain {}` says what turns the numbers away", question.id);
                let message = format!("style `{style}` of `{}` has no variant", question.id);
                faults.push(Diagnostic::new(message, &heading.source, 0..0, "").with_help(help));
            }
        }
        examined.push((question, styles));
    }
    progress.finish();
    let marked: Vec<Coverage> = questions.iter().map(|(_, question)| students(question)).collect();
    if arguments.json {
        print_json(&as_json(&contents.name, &examined, &marked, &faults))?;
        return if faults.is_empty() { Ok(()) } else { Err(Failure::Found) };
    }
    print(&in_words(&examined, &marked, faults.len()))?;
    let remarks = questions.iter().zip(&marked).flat_map(|((heading, question), marked)| {
        let remark = |message: String| {
            let fault = Diagnostic::new(format!("`{}`: {message}", question.id), &heading.source, 0..0, "");
            Diagnostic { severity: Severity::Warning, ..fault }
        };
        remarks(marked).into_iter().map(remark).collect::<Vec<_>>()
    });
    let remarks: Vec<Diagnostic> = remarks.collect();
    warn(&remarks);
    if faults.is_empty() { Ok(()) } else { Err(Failure::Faults(faults)) }
}

/// How many variants of each style are marked as handed in by students whose marks are known.
const MARKED: usize = 2;

/// Every mark of a question won and lost, on its reference numbers and on some variants of each style.
fn students(question: &Question) -> Coverage {
    let mut all = reference(question).map(|variant| coverage(question, &variant)).unwrap_or_default();
    for style in &question.styles {
        for variant in Deal::new(question, style, 1).take(MARKED) {
            all.add(coverage(question, &variant));
        }
    }
    all
}

/// What those students show to be amiss, each in a sentence.
fn remarks(marked: &Coverage) -> Vec<String> {
    let name = |mark: &MarkCount| match mark.part.as_str() {
        "" => format!("the mark {}", mark.id),
        part => format!("the mark {} of part ({part})", mark.id),
    };
    let idle = marked.idle().map(|mark| match mark.won {
        0 => format!("{} is never won, not even by the model solution", name(mark)),
        _ => format!("{} is never lost, not even by a student who hands in nothing", name(mark)),
    });
    idle.chain(marked.faults.iter().map(|fault| format!("a student who writes {fault}"))).collect()
}

/// Do the reference answers hold, and does the scene that the key would hold give them again?
fn reference_faults(question: &Question, heading: &crate::bank::Heading) -> Option<Diagnostic> {
    let fault =
        |message: String| Some(Diagnostic::new(format!("`{}`: {message}", question.id), &heading.source, 0..0, ""));
    let Ok(variant) = reference(question) else {
        return fault("the reference numbers make no question".to_owned());
    };
    let printed = compose(question, &variant, 1);
    let key = key_question(question, &variant, &printed);
    match again(question, &key) {
        None => None,
        Some(message) => fault(message),
    }
}

/// Solves the scene of a key by itself; what is not as in the key.
fn again(question: &Question, key: &KeyQuestion) -> Option<String> {
    let Ok(scene) = Scene::read(&key.scene, &Default::default(), Angles::Radians) else {
        return Some("the scene of its key cannot be read".to_owned());
    };
    let solution = match solve(&scene, &question.asked()) {
        Ok(solution) => solution,
        Err(refusal) => return Some(format!("the scene of its key is refused: {refusal}")),
    };
    for (part, printed) in question.parts.iter().zip(&key.parts) {
        for (answer, blank) in part.answers.iter().zip(&printed.blanks) {
            let found: Vec<String> = answer
                .find
                .quantities()
                .into_iter()
                .filter_map(|quantity| solution.exchange(quantity))
                .map(|exact| written::plain(&exact))
                .collect();
            let found = match solution.range().filter(|_| answer.kind == Kind::Range) {
                Some(values) => vec![written::plain(&values.written())],
                None => found,
            };
            let held: Vec<&str> = match &blank.exact {
                Json::Array(list) => list.iter().filter_map(Json::as_str).collect(),
                one => one.as_str().into_iter().collect(),
            };
            if !found.is_empty() && found != held {
                return Some(format!(
                    "{} is {} in the key and {} by its scene",
                    blank.name,
                    held.join(", "),
                    found.join(", ")
                ));
            }
        }
    }
    None
}

fn in_words(examined: &[(&Question, Vec<StyleCount>)], marked: &[Coverage], faults: usize) -> String {
    let mut text = String::new();
    let (mut sets, mut fit) = (0, 0);
    for (question, styles) in examined {
        text.push_str(&format!("{}\n", question.id));
        for StyleCount { style, census } in styles {
            let turned_away: Vec<String> = match question.style(*style) {
                Some(checked) => {
                    census.funnel(question, checked).into_iter().map(|(why, n)| format!("{n} {why}")).collect()
                }
                None => Vec::new(),
            };
            sets += census.size;
            fit += census.fit;
            text.push_str(&format!("  {style}: {} of {} sets of numbers\n", census.fit, census.size));
            if !turned_away.is_empty() {
                text.push_str(&format!("    turned away: {}\n", turned_away.join("; ")));
            }
        }
    }
    let scripts: usize = marked.iter().map(|coverage| coverage.scripts).sum();
    let marks: usize = marked.iter().map(|coverage| coverage.marks.len()).sum();
    let idle: usize = marked.iter().map(|coverage| coverage.idle().count()).sum();
    text.push_str(&format!(
        "{} of {marks} marks won and lost by the {scripts} scripts of synthetic students\n",
        marks - idle
    ));
    let questions = count(examined.len(), "question");
    text.push_str(&format!("{questions}, {fit} variants of {sets} sets of numbers, {}\n", count(faults, "finding")));
    text
}

fn as_json(bank: &str, examined: &[(&Question, Vec<StyleCount>)], marked: &[Coverage], faults: &[Diagnostic]) -> Json {
    let questions: Vec<Json> = examined
        .iter()
        .zip(marked)
        .map(|((question, styles), marked)| {
            let styles: Vec<Json> = styles
                .iter()
                .map(|count| {
                    let funnel = question.style(count.style).map(|style| count.census.funnel(question, style));
                    let funnel = funnel.unwrap_or_default();
                    let turned: Vec<Json> =
                        funnel.into_iter().map(|(reason, count)| json!({"reason": reason, "count": count})).collect();
                    let mut whole = count.json();
                    whole["turned_away"] = turned.into();
                    whole
                })
                .collect();
            let marks = marked.marks.iter();
            let marks =
                marks.map(|mark| json!({"part": mark.part, "mark": mark.id, "won": mark.won, "lost": mark.lost}));
            let (marks, scripts) = (marks.collect::<Vec<_>>(), marked.scripts);
            json!({"id": question.id, "styles": styles, "scripts": scripts, "marks": marks, "remarks": remarks(marked)})
        })
        .collect();
    let faults: Vec<Json> = faults
        .iter()
        .map(|fault| {
            json!({
                "message": fault.message, "file": &*fault.source.file, "line": fault.line(), "help": fault.help,
                "picture": render_all(std::slice::from_ref(fault), false),
            })
        })
        .collect();
    json!({"bank": bank, "questions": questions, "faults": faults})
}
