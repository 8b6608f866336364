//! `carom sheet`: a question sheet, its mark scheme and its key.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use clap::Args;

use super::bank;
use super::failure::Failure;
use super::formats::FormatsAsked;
use super::output::{count, listed, print, say};
use super::write::{OutputFile, write_all};
use crate::bank::{Contents, Heading, Question, StyleName};
use crate::diagnostic::near;
use crate::generate::{Variant, reference};
use crate::mark::submissions::{empty_submissions, is_filled_in};
use crate::paper::{Dealer, Edition, Key, Paper, choose_count, choose_marks, compose, key_question};

const AFTER: &str = "Examples:
  carom sheet                                   six questions from every topic
  carom sheet 5C-2 --count 30                   one question thirty times, no two with the same numbers
  carom sheet --topic 'i and j' --style friendly
  carom sheet --marks 40 --seed 2027            40 marks; the same seed gives the same sheet again
  carom sheet --reference                       the exercises with their own numbers
  carom sheet --format html,pdf                 pages for the screen, and pages to print

PDF is made with what the machine has: pdflatex, lualatex or xelatex, else Chrome, Chromium or Edge without a window.
  CAROM_TEX          the TeX engine to take, by name or path; `none` leaves it to the browser
  CAROM_BROWSER      the browser to take, by name or path; `none` for no browser
  CAROM_PDF_SECONDS  how long one run of either may take, in place of 120 seconds";

/// Make a question sheet with its mark scheme
///
/// Writes a question sheet and a mark scheme with worked solutions, in each format, `key.json` for
/// marking, and `submissions.csv` to write down what students answer.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct SheetArguments {
    /// Questions, by id, by a part of it, or by the exercise they mirror (5C-2); without any, a choice of all
    #[arg(value_name = "QUESTION")]
    questions: Vec<String>,
    /// How many questions; past those there are they repeat, with other numbers
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    count: Option<u16>,
    /// As many questions as make up this many marks, or as nearly as can be had without going over
    #[arg(long, value_name = "M", conflicts_with = "count", value_parser = clap::value_parser!(u16).range(1..=2000))]
    marks: Option<u16>,
    /// Only questions of this topic
    #[arg(long, value_name = "TOPIC")]
    topic: Option<String>,
    /// The number that decides all choices; without it the clock does
    #[arg(long, value_name = "SEED")]
    seed: Option<u64>,
    /// The manner of the numbers; without it each question has one that the seed chooses
    #[arg(long, value_name = "STYLE", value_parser = ["friendly", "exact", "calculator"])]
    style: Option<String>,
    /// The numbers of the exercises themselves, in place of fresh ones
    #[arg(long, conflicts_with_all = ["seed", "style", "count", "marks"])]
    reference: bool,
    /// The heading of the sheet
    #[arg(long, value_name = "TITLE", default_value = "Oblique impacts of smooth spheres")]
    title: String,
    /// A date, as it is to be printed
    #[arg(long, value_name = "DATE", default_value = "")]
    date: String,
    /// The name of the school
    #[arg(long, value_name = "NAME", default_value = "")]
    school: String,
    /// Letters half as large again
    #[arg(long)]
    large_print: bool,
    /// Lines to write on below each part, by its marks
    #[arg(long)]
    answer_space: bool,
    /// No diagrams in the questions: the students are to draw them
    #[arg(long)]
    no_diagrams: bool,
    /// Formats, with commas: latex, html, folders of templates of your own, and pdf
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', default_value = "latex,html")]
    format: Vec<String>,
    /// The folder for the files
    #[arg(long, value_name = "DIR", default_value = "sheet")]
    out: PathBuf,
    /// A bank of your own
    #[arg(long, value_name = "DIR")]
    bank: Option<PathBuf>,
    /// Templates of your own, which take the place of those of the same name
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
}

/// The file to write down what students answer.
const SUBMISSIONS: &str = "submissions.csv";

/// How many questions a sheet has if nobody says.
const USUAL_COUNT: usize = 6;

/// Makes the sheet.
pub fn run(arguments: &SheetArguments) -> Result<(), Failure> {
    let formats = FormatsAsked::new(&arguments.format, arguments.templates.as_deref())?;
    let contents = bank::open(arguments.bank.as_deref())?;
    let style = arguments.style.as_ref().and_then(|name| StyleName::ALL.into_iter().find(|style| style.name() == name));
    let seed = arguments.seed.unwrap_or_else(fresh_seed);
    let chosen = choose(arguments, &contents, style, seed)?;
    let questions = checked(&chosen)?;
    let in_order = chosen.iter().filter_map(|heading| questions.get(heading.id.as_str()));
    let variants = if arguments.reference { references(in_order)? } else { dealt(in_order, seed, style)? };

    let seed = (!arguments.reference).then_some(seed);
    let mut composed = Vec::with_capacity(variants.len());
    let mut keyed = Vec::with_capacity(variants.len());
    for (index, (question, variant)) in variants.iter().enumerate() {
        let printed = compose(question, variant, index + 1);
        keyed.push(key_question(question, variant, &printed));
        composed.push(printed);
    }
    let key = Key::new(contents.name.clone(), seed, keyed);
    let paper = Paper {
        title: arguments.title.clone(),
        school: arguments.school.clone(),
        date: arguments.date.clone(),
        code: key.code.clone(),
        seed,
        edition: Edition {
            large_print: arguments.large_print,
            answer_space: arguments.answer_space,
            no_diagrams: arguments.no_diagrams,
        },
        questions: composed,
    };
    let json = serde_json::to_string_pretty(&key).map_err(|error| Failure::said(error.to_string()))?;
    let mut printed = formats.print(&paper, &arguments.out)?;
    let text = |name: &str, contents: String| OutputFile { name: name.to_owned(), contents: contents.into_bytes() };
    printed.files.push(text("key.json", json + "\n"));
    let old = arguments.out.join(SUBMISSIONS);
    if fs::read(&old).is_ok_and(|old| is_filled_in(&old)) {
        say(&format!("`{}` has answers in it, and is left as it is", old.display()));
    } else {
        printed.files.push(text(SUBMISSIONS, empty_submissions(&key.questions)));
    }
    let paths = write_all(&arguments.out, &printed.files)?;

    let size = format!("{}, {}", count(paper.questions.len(), "question"), count(paper.marks(), "mark"));
    match seed {
        Some(seed) => say(&format!("{size}, seed {seed}; `--seed {seed}` makes the same sheet again")),
        None => say(&format!("{size}, with the numbers of the exercises")),
    }
    if let Some(marks) = arguments.marks.filter(|marks| usize::from(*marks) != paper.marks()) {
        say(&format!("no choice of questions makes exactly {marks} marks"));
    }
    if printed.missing.is_some() {
        for old in paths.iter().map(|path| path.with_extension("pdf")).filter(|pdf| pdf.is_file()) {
            say(&format!("`{}` is of an earlier sheet", old.display()));
        }
    }
    let paths: Vec<String> = paths.iter().map(|path| format!("{}\n", path.display())).collect();
    print(&paths.concat())?;
    printed.missing.map_or(Ok(()), Err)
}

/// A seed short enough to be typed again.
pub fn fresh_seed() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    now.as_micros() as u64 % 1_000_000
}

/// The headings of the questions of the sheet, in its order, with repeats.
fn choose<'c>(
    arguments: &SheetArguments,
    contents: &'c Contents,
    style: Option<StyleName>,
    seed: u64,
) -> Result<Vec<&'c Heading>, Failure> {
    let mut named = Vec::new();
    for name in &arguments.questions {
        named.push(bank::find(contents, name)?);
    }
    let has_style = |heading: &&Heading| style.is_none_or(|style| heading.styles.contains(&style));
    if let Some(heading) = named.iter().find(|heading| !has_style(heading)) {
        let styles = listed(heading.styles.iter().map(|style| style.name()));
        let style = style.map_or("", StyleName::name);
        return Err(Failure::with_help(format!("`{}` has no style `{style}`", heading.id), format!("it has {styles}")));
    }
    let mut offered: Vec<&Heading> = if named.is_empty() { contents.headings.iter().collect() } else { named.clone() };
    if let Some(topic) = &arguments.topic {
        offered = of_topic(&offered, topic)?;
    }
    offered.retain(has_style);
    if offered.is_empty() {
        return Err(Failure::said("no question has this style"));
    }
    if arguments.reference {
        return Ok(offered);
    }
    match (arguments.count.map(usize::from), arguments.marks) {
        (_, Some(marks)) => {
            let chosen = choose_marks(&offered, usize::from(marks), seed);
            if chosen.is_empty() {
                let least = offered.iter().map(|heading| heading.marks).min().unwrap_or(0);
                return Err(Failure::said(format!("no question has so few marks: the shortest has {least}")));
            }
            Ok(chosen)
        }
        (Some(wanted), None) if !named.is_empty() => Ok(offered.iter().cycle().take(wanted).copied().collect()),
        (None, None) if !named.is_empty() => Ok(offered),
        (wanted, None) => {
            let usual = if arguments.topic.is_some() { USUAL_COUNT.min(offered.len()) } else { USUAL_COUNT };
            Ok(choose_count(&offered, wanted.unwrap_or(usual), seed))
        }
    }
}

fn of_topic<'c>(offered: &[&'c Heading], topic: &str) -> Result<Vec<&'c Heading>, Failure> {
    let wanted = topic.trim().to_lowercase();
    let exact: Vec<&Heading> =
        offered.iter().filter(|heading| heading.topic.to_lowercase() == wanted).copied().collect();
    if !exact.is_empty() {
        return Ok(exact);
    }
    let within: Vec<&Heading> =
        offered.iter().filter(|heading| heading.topic.to_lowercase().contains(&wanted)).copied().collect();
    if !within.is_empty() {
        return Ok(within);
    }
    let mut topics: Vec<&str> = offered.iter().map(|heading| heading.topic.as_str()).collect();
    topics.sort_unstable();
    topics.dedup();
    let help = match near(topic, topics.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the topics are {}", listed(topics)),
    };
    Err(Failure::with_help(format!("no question of topic `{topic}`"), help))
}

/// The questions that are used, each checked once; faults of all of them together.
fn checked<'c>(chosen: &[&'c Heading]) -> Result<BTreeMap<&'c str, Question>, Failure> {
    let mut questions = BTreeMap::new();
    let mut faults = Vec::new();
    for heading in chosen {
        if questions.contains_key(heading.id.as_str()) {
            continue;
        }
        match heading.question() {
            Ok(question) => {
                questions.insert(heading.id.as_str(), question);
            }
            Err(found) => faults.extend(found),
        }
    }
    if faults.is_empty() { Ok(questions) } else { Err(Failure::Faults(faults)) }
}

fn references<'q>(questions: impl Iterator<Item = &'q Question>) -> Result<Vec<(&'q Question, Variant)>, Failure> {
    let one = |question: &'q Question| match reference(question) {
        Ok(variant) => Ok((question, variant)),
        Err(_) => Err(Failure::said(format!("the reference numbers of `{}` make no question", question.id))),
    };
    questions.map(one).collect()
}

/// Fresh numbers for each question; says so where there are none left.
fn dealt<'q>(
    questions: impl Iterator<Item = &'q Question>,
    seed: u64,
    style: Option<StyleName>,
) -> Result<Vec<(&'q Question, Variant)>, Failure> {
    let mut dealer = Dealer::new(seed, style);
    let mut variants = Vec::new();
    let mut exhausted: BTreeMap<&str, usize> = BTreeMap::new();
    for question in questions {
        match dealer.next(question) {
            Some(variant) => variants.push((question, variant)),
            None => *exhausted.entry(question.id.as_str()).or_default() += 1,
        }
    }
    for (id, missing) in &exhausted {
        let printed = variants.iter().filter(|(question, _)| question.id == *id).count();
        if printed == 0 {
            return Err(Failure::with_help(
                format!("no numbers meet the requirements of `{id}`"),
                format!("`carom explain {id}` says which requirement turns them away"),
            ));
        }
        say(&format!("`{id}` has no more than {printed} sets of numbers: {} left out", count(*missing, "question")));
    }
    Ok(variants)
}
