//! `carom sheet`: a question sheet, its mark scheme and its key.

mod amiss;
mod choose;
mod class;
mod earlier;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};

use clap::Args;

use choose::{checked, choose};
use earlier::{Earlier, KEY};

use super::bank;
use super::failure::Failure;
use super::formats::{FormatsAsked, Printed, Work};
use super::output::{count, print, say};
use super::write::{OutputFile, write_all};
use crate::bank::{Contents, Question, StyleName};
use crate::generate::{Variant, reference};
use crate::mark::submissions::empty_submissions;
use crate::paper::{Dealer, Edition, Key, Paper, Sheet, SheetCode};

const AFTER: &str = "Examples:
  carom sheet                                   six questions from every topic
  carom sheet 5C-2 --count 30                   one question thirty times, no two alike
  carom sheet --topic 'i and j' --style friendly
  carom sheet --marks 40 --seed 2027            40 marks; the same seed gives the same sheet again
  carom sheet --reference                       the exercises with their own numbers
  carom sheet --format html,pdf                 pages for the screen, and pages to print
  carom sheet --class class.csv --format pdf    another sheet for each student, in one file
  carom sheet --code Y2QA-8KAZ-Y                the sheet with this code again

A class is a table with a column `student`, a number or a name that nobody else in it has, and
perhaps one `name`. All get the same questions, no two the same numbers, and none an easier
sheet. `lock.json` beside the sheets records who got what; while it is there the same command
prints the same sheets again, and fresh ones for students who are new.

PDF is made with what the machine has: pdflatex, lualatex or xelatex, else Chrome, Chromium or
Edge without a window. Names in letters that TeX's own fonts lack are left to the browser first.
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
    #[arg(long, value_name = "N", value_parser = up_to::<1000>, allow_negative_numbers = true)]
    count: Option<u16>,
    /// As many questions as make up this many marks, or as nearly as can be had without going over
    #[arg(long, value_name = "M", conflicts_with = "count", value_parser = up_to::<2000>, allow_negative_numbers = true)]
    marks: Option<u16>,
    /// Only questions of this topic
    #[arg(long, value_name = "TOPIC")]
    topic: Option<String>,
    /// The number that decides all choices; without it the clock does
    #[arg(long, value_name = "SEED", value_parser = seed, allow_negative_numbers = true)]
    seed: Option<u64>,
    /// The manner of the numbers; without it each question has one that the seed chooses
    #[arg(long, value_name = "STYLE", value_parser = ["friendly", "exact", "calculator"])]
    style: Option<String>,
    /// The numbers of the exercises themselves, in place of fresh ones
    #[arg(long, conflicts_with_all = ["seed", "style", "count", "marks"])]
    reference: bool,
    /// A sheet for each student in this table, no two with the same numbers
    #[arg(long, value_name = "CLASS.csv", conflicts_with = "reference")]
    class: Option<PathBuf>,
    /// Besides the files of the whole class a folder for each student, in each format but pdf
    #[arg(long, requires = "class")]
    per_student: bool,
    /// Who got which sheet before; without it the `lock.json` in the folder for the files, if there is one
    #[arg(long, value_name = "FILE.json", requires = "class")]
    lock: Option<PathBuf>,
    /// The sheet that has this code
    #[arg(long, value_name = "CODE", conflicts_with_all = ["questions", "count", "marks", "topic", "seed", "style", "reference", "class"])]
    code: Option<String>,
    /// The heading of the sheet; without it, what the questions are about
    #[arg(long, value_name = "TITLE")]
    title: Option<String>,
    /// A date, as it is to be printed
    #[arg(long, value_name = "DATE", default_value = "", hide_default_value = true)]
    date: String,
    /// The name of the school
    #[arg(long, value_name = "NAME", default_value = "", hide_default_value = true)]
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

/// A whole number from 1 to so many, as an argument.
fn up_to<const MOST: u16>(typed: &str) -> Result<u16, String> {
    let number = typed.parse().ok().filter(|number| (1..=MOST).contains(number));
    number.ok_or_else(|| format!("expected a whole number from 1 to {MOST}, such as 6"))
}

/// A seed as an argument.
pub fn seed(typed: &str) -> Result<u64, String> {
    typed.parse().map_err(|_| format!("expected a whole number from 0 to {}, such as 2027", u64::MAX))
}

/// The file to write down what students answer.
const SUBMISSIONS: &str = "submissions.csv";

/// Makes the sheet, or one for each student.
pub fn run(arguments: &SheetArguments) -> Result<(), Failure> {
    let formats = FormatsAsked::new(&arguments.format, arguments.templates.as_deref())?;
    let contents = bank::open(arguments.bank.as_deref())?;
    if let Some(code) = &arguments.code {
        let sheet = from_code(code, &contents)?;
        return write_sheet(arguments, &formats, &contents, &sheet, None);
    }
    let style = arguments.style.as_ref().and_then(|name| StyleName::ALL.into_iter().find(|style| style.name() == name));
    if let Some(list) = &arguments.class {
        return class::run(arguments, &formats, &contents, style, list);
    }
    let seed = arguments.seed.unwrap_or_else(fresh_seed);
    let chosen = choose(arguments, &contents, style, seed)?;
    let questions = checked(&chosen)?;
    amiss::tell(arguments.bank.as_deref(), &questions, (!arguments.reference).then_some(seed), style);
    let in_order = chosen.iter().filter_map(|heading| questions.get(heading.id.as_str()));
    let variants = if arguments.reference { references(in_order)? } else { dealt(in_order, seed, style)? };
    let sheet = Sheet::new(&contents, variants.iter().map(|(question, variant)| (*question, variant)));
    write_sheet(arguments, &formats, &contents, &sheet, (!arguments.reference).then_some(seed))
}

/// The sheet that a code holds.
pub fn from_code(code: &str, contents: &Contents) -> Result<Sheet, Failure> {
    let found = SheetCode::read(code).and_then(|code| Sheet::from_code(contents, &code));
    // No more of what was pasted than one reads.
    const SHOWN: usize = 60;
    let rest = if code.chars().count() > SHOWN { "…" } else { "" };
    let begins: String = code.chars().take(SHOWN).collect();
    found.map_err(|fault| Failure::with_help(format!("`{}{rest}`: {fault}", begins.escape_debug()), fault.help()))
}

/// Writes a sheet and says what became of it.
fn write_sheet(
    arguments: &SheetArguments,
    formats: &FormatsAsked,
    contents: &Contents,
    sheet: &Sheet,
    seed: Option<u64>,
) -> Result<(), Failure> {
    let key = Key::of_sheet(contents.name.clone(), seed, sheet);
    let paper = paper(arguments, sheet, String::new(), seed);
    let printed = formats.print(Work::Sheet(&paper), &arguments.out)?;
    let (printed, paths) = write_keyed(arguments, formats, printed, &key, empty_submissions(&key.questions), None)?;

    let size = format!("{}, {}", count(paper.questions.len(), "question"), count(paper.marks(), "mark"));
    match seed {
        Some(seed) => say(&format!("{size}, seed {seed}; `--seed {seed}` makes the same sheet again")),
        None if arguments.code.is_some() => say(&format!("{size}, with the numbers that the code holds")),
        None => say(&format!("{size}, with the numbers of the exercises")),
    }
    if let Some(marks) = arguments.marks.filter(|marks| usize::from(*marks) != paper.marks()) {
        say(&format!("no choice of questions makes exactly {marks} marks"));
    }
    told(printed, &paths)
}

/// What is printed of a sheet, under the heading that the arguments give.
fn paper(arguments: &SheetArguments, sheet: &Sheet, student: String, seed: Option<u64>) -> Paper {
    Paper {
        title: arguments.title.clone().unwrap_or_else(|| sheet.heading.to_owned()),
        school: arguments.school.clone(),
        date: arguments.date.clone(),
        student,
        code: sheet.code.to_string(),
        // Where the code makes the same sheet again, one of the two is enough to read.
        seed: seed.filter(|_| !sheet.code.holds_the_sheet()),
        edition: Edition {
            large_print: arguments.large_print,
            answer_space: arguments.answer_space,
            no_diagrams: arguments.no_diagrams,
        },
        questions: sheet.printed.clone(),
    }
}

fn json(name: &str, data: &impl serde::Serialize) -> Result<OutputFile, Failure> {
    let json = serde_json::to_string_pretty(data).map_err(|error| Failure::said(error.to_string()))?;
    Ok(OutputFile { name: name.to_owned(), contents: (json + "\n").into_bytes() })
}

/// Writes pages with their key, the table to fill in unless somebody has begun to, and the lock of a class.
///
/// Nothing is written if that would cost what lies in the folder.
fn write_keyed(
    arguments: &SheetArguments,
    formats: &FormatsAsked,
    mut printed: Printed,
    key: &Key,
    empty: String,
    lock: Option<OutputFile>,
) -> Result<(Printed, Vec<PathBuf>), Failure> {
    let out = &arguments.out;
    printed.files.push(json(KEY, key)?);
    let earlier = Earlier::find(out);
    if earlier.gives_way(out, &printed.files, key)? {
        say(&format!("`{}` has answers in it, and is left as it is", out.join(SUBMISSIONS).display()));
    } else {
        printed.files.push(OutputFile { name: SUBMISSIONS.to_owned(), contents: empty.into_bytes() });
    }
    // A lock that lies there has been read before, and what it says is in the new one.
    printed.files.extend(lock);
    let paths = write_all(out, &printed.files)?;
    earlier.tell(out, &formats.pages(), &printed, key);
    Ok((printed, paths))
}

/// The paths of what was written, and why the PDF is not among it.
fn told(printed: Printed, paths: &[PathBuf]) -> Result<(), Failure> {
    let paths: Vec<String> = paths.iter().map(|path| format!("{}\n", path.display())).collect();
    print(&paths.concat())?;
    printed.missing.map_or(Ok(()), Err)
}

/// A seed short enough to be typed again.
pub fn fresh_seed() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    now.as_micros() as u64 % 1_000_000
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
