//! `carom mark`: what students handed in, marked against the key of their sheet.

mod feedback;

mod in_order;
mod key;
mod pieces;
mod stream;
mod summary;
mod unfinished;

use std::collections::HashSet;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

use clap::Args;

use feedback::FeedbackAsked;

use super::failure::{Failure, warn};
use super::output::{count, listed, print, print_json, say};
use super::text_file;
use super::write::{OutputFile, can_be, spares, write_all};
use crate::diagnostic::near;
use crate::mark::report::{ClassReport, MARKS, MarkReport, Names, marks_csv, marks_jsonl, not_marked_csv};
use crate::mark::submissions::{
    HandedIn, Override, Rows, SetAside, Sorted, contradictions, read_overrides, read_rows, sort,
};
use crate::mark::{AnswerKey, Profile};

const AFTER: &str = "Examples:
  carom mark sheet/key.json submissions.csv               marks, and a page for each student
  carom mark sheet/key.json submissions.csv --profile edexcel
  carom mark sheet/key.json answers.jsonl --out monday --feedback html,latex
  carom mark sheet/key.json submissions.csv --overrides overrides.csv
  carom mark sheet/key.json submissions.csv --without-names   a report that can be passed on
  carom mark sheet/key.json - --json < submissions.csv
  carom mark sheet/key.json - --stream < million.csv > marks.csv
  carom mark sheet/key.json million.csv --stream --out national
  carom mark Y2QA-8KAZ-Y submissions.csv                  by the code of the sheet

SUBMISSIONS is a table, as `carom sheet` writes an empty one beside the key, saved as CSV in
UTF-8:

  student,question,part,blank,answer,working
  Ada,1,,speed of A,4.54,
  Ben,1,,speed of A,5.36 m/s,\"7cos22 = 6.49
  5 × 6.49 = 5v + 2w\"

`part` is empty where a question has none; it, `blank` and `working` may be left out. Without a blank an answer says all that its part
asks. Working has one line of it a line of the cell. Or each line is a JSON object with these
fields, or all are in one JSON array.

Written are `marks.csv`, `marks.jsonl` with every reading and reason, a page for each student in
`feedback`, and `not-marked.csv` with what has no place in the key. `report.html` says how the
class did: marks by student and by question, how hard each mark was, which mistakes were made and
by whom, what looks wrong with a question. Its figures are in `report.csv`, `report-marks.csv` and
`report-mistakes.csv`. Where you know better, say so in a table
`student,question,part,mark,given,comment`, such as `Ada,1,,M1a,1,method seen in the margin`, and
mark again with `--overrides`: it has the last word, and the marks that depend on it follow.";

/// Mark what students handed in
///
/// Reads answers and lines of working, decides on every mark of the scheme, and says why. What cannot be read is left to
/// you, by name.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct MarkArguments {
    /// The `key.json` that was written with the sheet, or the code on its pages
    #[arg(value_name = "KEY.json|CODE")]
    key: PathBuf,
    /// What was handed in, a table, JSON lines or a JSON array; `-` for stdin
    #[arg(value_name = "SUBMISSIONS")]
    submissions: PathBuf,
    /// The folder for the files; `marks` if you do not say
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// How strict to be: `carom`, `edexcel`, `ocr`, `mei`, `aqa`, or a TOML file of your own
    #[arg(long, value_name = "NAME|FILE.toml", default_value = "carom")]
    profile: String,
    /// Your own word on single marks: a table `student,question,part,mark,given,comment`
    #[arg(long, value_name = "FILE.csv")]
    overrides: Option<PathBuf>,
    /// Formats of the page for each student, with commas: html, latex, text; `none` for no pages
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', default_value = "html")]
    feedback: Vec<String>,
    /// Templates of your own, which take the place of those of the same name
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
    /// A bank of your own, if a code is of a sheet from it
    #[arg(long, value_name = "DIR")]
    bank: Option<PathBuf>,
    /// Any number of answers in little memory, the rows of each student together: print the marks, or write them into
    /// `--out DIR`, where a run that was interrupted goes on
    #[arg(long, conflicts_with_all = ["overrides", "json", "feedback", "templates"])]
    stream: bool,
    /// Leave students' names out of the report and out of what is printed; the marks and the pages have them
    #[arg(long, conflicts_with = "stream")]
    without_names: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Marks.
pub fn run(arguments: &MarkArguments) -> Result<(), Failure> {
    if let Some(out) = &arguments.out {
        can_be(out)?;
    }
    if text_file::is_stdin(&arguments.key) && text_file::is_stdin(&arguments.submissions) {
        let help = "name the file of the key: `carom mark key.json - < SUBMISSIONS`";
        return Err(Failure::with_help("the key and the submissions cannot both come from stdin", help));
    }
    let profile = profile(&arguments.profile)?;
    let (key, digest) = key::read(&arguments.key, arguments.bank.as_deref())?;
    if arguments.stream {
        return stream::run(&key, digest, &profile, &arguments.submissions, arguments.out.as_deref());
    }
    let feedback = FeedbackAsked::new(&arguments.feedback, arguments.templates.as_deref())?;
    let out = arguments.out.as_deref().unwrap_or(Path::new("marks"));
    let submissions = text_file::usually(&arguments.submissions, "submissions.csv")?;
    let rows = read_rows(&submissions)?;
    warn(&rows.warnings);
    let Sorted { scripts, set_aside, unfilled } = sort(&key, Rows { warnings: Vec::new(), ..rows });
    if scripts.is_empty() {
        // Then nothing is written either, and no table says more.
        tell_of_each(&set_aside, &submissions.file, arguments.without_names);
        return Err(nothing(&set_aside, unfilled, &submissions.file));
    }
    tell(&set_aside, &submissions.file, arguments.without_names);
    tell_of_blanks(&scripts, &submissions.file);
    if key::is_code(&arguments.key) {
        tell_of_one_sheet(&scripts);
    }
    let overrides = overrides(arguments.overrides.as_deref(), &key)?;
    let file = arguments.overrides.as_deref().map(|path| path.display().to_string()).unwrap_or_default();
    tell_of_contradictions(&overrides, &file, arguments.without_names);
    let report = MarkReport::new(&scripts, &profile, overrides);
    for word in &report.idle {
        let who = if arguments.without_names { "a student" } else { word.student.as_str() };
        say(&format!(
            "warning: line {} of `{file}` is about question {} of {who}, which was not handed in, and changes nothing\n\
             help: look at the name and the number; for a paper that is not there, add a row with its student and question to `{}`",
            word.line, word.question, submissions.file
        ));
    }

    let text = |name: &str, contents: String| OutputFile { name: name.to_owned(), contents: contents.into_bytes() };
    let mut files = vec![text("marks.csv", marks_csv(&report)), text("marks.jsonl", marks_jsonl(&report))];
    if !set_aside.is_empty() {
        files.push(text("not-marked.csv", not_marked_csv(&set_aside)));
    }
    let names = if arguments.without_names { Names::LeftOut } else { Names::Shown };
    let class = ClassReport::new(&report, set_aside.len(), names);
    files.extend(feedback.report(&class)?);
    let pages = feedback.pages(&report)?;
    let page_count = pages.len();
    files.extend(pages);
    if !is_of_a_marking(out) {
        spares(out, &files, "no `marks.csv` of Carom's is beside it")?;
    }
    write_all(out, &files)?;

    let place = out.display();
    say(&format!("marks in `{place}`: `marks.csv`, `marks.jsonl`, `report.html`{}", also(page_count, set_aside.len())));
    tell_of_old(out, &files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>());
    if arguments.json { print_json(&summary::as_json(&class)) } else { print(&summary::in_words(&class)) }
}

fn also(pages: usize, set_aside: usize) -> String {
    let mut words = String::new();
    if pages > 0 {
        words.push_str(&format!(", {} in `feedback`", count(pages, "page")));
    }
    if set_aside > 0 {
        words.push_str(&format!(", and {} not marked in `not-marked.csv`", count(set_aside, "row")));
    }
    words
}

/// What a marking writes beside the pages for students.
const FILES: [&str; 7] = [
    "marks.csv",
    "marks.jsonl",
    "not-marked.csv",
    "report.html",
    "report.csv",
    "report-marks.csv",
    "report-mistakes.csv",
];

/// Has Carom marked into this folder before, so that what lies there under the names of its files is its own?
fn is_of_a_marking(out: &Path) -> bool {
    let header = MARKS.join(",");
    let table = std::fs::File::open(out.join("marks.csv"));
    let first = table.ok().and_then(|table| BufReader::new(table).lines().next()?.ok());
    first.is_some_and(|first| first.trim_start_matches('\u{feff}').trim_end() == header)
}

/// Says of each file in the folder that only an earlier marking can have written, as these are the new ones.
fn tell_of_old(out: &Path, new: &[&str]) {
    let new: HashSet<&str> = new.iter().copied().collect();
    for name in FILES.iter().filter(|name| !new.contains(**name) && out.join(name).is_file()) {
        say(&format!("`{}` is of an earlier marking", out.join(name).display()));
    }
    let there = std::fs::read_dir(out.join("feedback")).into_iter().flatten().flatten();
    let there = there.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut old: Vec<String> = there.filter(|name| !new.contains(format!("feedback/{name}").as_str())).collect();
    old.sort();
    if !old.is_empty() {
        let names = listed(old.iter().map(String::as_str));
        let feedback = out.join("feedback");
        say(&format!("{} in `{}` of an earlier marking: {names}", count(old.len(), "file"), feedback.display()));
    }
}

/// The most rows that are told of one by one.
const TOLD: usize = 10;

fn tell(set_aside: &[SetAside], file: &str, without_names: bool) {
    if without_names && !set_aside.is_empty() {
        // A reason repeats what was typed.
        say(&format!("warning: {file}: {} not marked; `not-marked.csv` says why", count(set_aside.len(), "row")));
        return;
    }
    tell_of_each(set_aside, file, without_names);
    if set_aside.len() > TOLD {
        say(&format!("warning: {} more, all in `not-marked.csv`", set_aside.len() - TOLD));
    }
}

/// The first rows and their reasons, which repeat what was typed.
fn tell_of_each(set_aside: &[SetAside], file: &str, without_names: bool) {
    for SetAside { row, reason } in set_aside.iter().take(TOLD).filter(|_| !without_names) {
        say(&format!("warning: {file}, line {}: {reason}", row.line));
    }
}

/// Says that a table which nobody filled in gives marks of nought.
fn tell_of_blanks(scripts: &[HandedIn], file: &str) {
    if !scripts.iter().any(HandedIn::says_something) {
        let students = count(students(scripts), "student");
        say(&format!(
            "warning: `{file}` has no answers: {students} and not one filled in `answer` or `working`, so all marks are 0"
        ));
    }
}

/// Says where a person gives a mark in one row and takes it away in another: a row that was forgotten, most likely.
fn tell_of_contradictions(overrides: &[Override], file: &str, without_names: bool) {
    for words in contradictions(overrides) {
        let [before @ .., last] = words.as_slice() else { continue };
        let who = if without_names { "a student" } else { last.student.as_str() };
        let before: Vec<String> = before.iter().map(|word| word.line.to_string()).collect();
        say(&format!(
            "warning: `{file}` contradicts itself on lines {} and {}, about a mark of question {} of {who}: the last counts, \
             so that the mark is {}\n\
             help: take out the row that you do not mean",
            before.join(", "),
            last.line,
            last.question,
            if last.given { "given" } else { "not given" }
        ));
    }
}

/// Says that all are marked on the numbers of one sheet: in a class each may have a sheet of another code.
fn tell_of_one_sheet(scripts: &[HandedIn]) {
    if let (several @ 2.., Some(script)) = (students(scripts), scripts.first()) {
        say(&format!(
            "warning: all {several} students are marked on the numbers of the one sheet {}; if each has another sheet, as \
             `--class` makes them, name the `key.json` of the class in place of the code",
            script.paper.code
        ));
    }
}

fn students(scripts: &[HandedIn]) -> usize {
    scripts.iter().map(HandedIn::student).collect::<HashSet<_>>().len()
}

/// There is nothing that could be marked.
fn nothing(set_aside: &[SetAside], unfilled: usize, file: &str) -> Failure {
    match (set_aside.len(), unfilled) {
        (0, 0) => Failure::with_help(format!("`{file}` has no answers"), "`carom mark --help` shows a table of some"),
        (0, unfilled) => {
            let rows = count(unfilled, "row");
            let message = format!("`{file}` has no answers: {rows} of it name a question and no student");
            Failure::with_help(message, "fill in `student` and `answer`, and repeat the rows for each student")
        }
        (rows, _) => {
            let message = format!("nothing in `{file}` could be marked: {} set aside", count(rows, "row"));
            Failure::with_help(message, "is this the key of that sheet?")
        }
    }
}

fn profile(name: &str) -> Result<Profile, Failure> {
    if let Some(profile) = Profile::named(name) {
        return Ok(profile);
    }
    let path = Path::new(name);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) || path.is_file() {
        return Ok(Profile::read(&text_file::text(path)?)?);
    }
    let help = match near(name, Profile::names()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("there are {}, or a file such as `own.toml`", listed(Profile::names())),
    };
    Err(Failure::with_help(format!("unknown profile `{name}`"), help))
}

fn overrides(path: Option<&Path>, key: &AnswerKey) -> Result<Vec<Override>, Failure> {
    match path {
        Some(path) => Ok(read_overrides(&text_file::text(path)?, key)?),
        None => Ok(Vec::new()),
    }
}
