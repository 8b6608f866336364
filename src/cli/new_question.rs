//! `carom new-question`: a question file to begin with: a commented one, or a copy of one that the bank has.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;

use super::bank;
use super::failure::Failure;
use super::output::{print, say};
use super::write::{make_folder, remove, unwritten};
use crate::bank::Contents;

const AFTER: &str = "Examples:
  carom new-question my-bank/b-at-rest/impulse.toml
  carom new-question my-bank/backwards.toml --like 5C-11   a copy of a shipped one";

/// Start a question: a commented file that works, or a copy of a question that there is
///
/// Nothing that exists is written over; a folder that the bank does not have yet is made. Where the bank has a schema, the file names it in its first line, so that an
/// editor completes keys and underlines mistakes.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct NewQuestionArguments {
    /// The file to make, in the folder of a bank; its name is the question's
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Begin with a copy of this question of the shipped bank: its id, a part of it, or the exercise it mirrors
    #[arg(long, value_name = "QUESTION")]
    like: Option<String>,
}

/// The schema as it stands in a bank.
pub const SCHEMA_FILE: &str = "question.schema.json";

/// The question with which everybody begins.
const STARTING: &str = include_str!("starting_question.toml");

/// Makes the file.
pub fn run(arguments: &NewQuestionArguments) -> Result<(), Failure> {
    let file = arguments.file.as_path();
    well_named(file)?;
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let there = standing(folder)?;
    let steps = folder.strip_prefix(there).map_or(0, |missing| missing.components().count());
    let schema = schema_above(there).map(|(above, bank)| (steps + above, bank));
    let copied = arguments.like.as_deref().map(shipped).transpose()?;
    let text = copied.unwrap_or_else(|| STARTING.to_owned());
    let text = match &schema {
        Some((steps, _)) => format!("#:schema {}{SCHEMA_FILE}\n{text}", "../".repeat(*steps)),
        None => text,
    };
    let made = make_folder(folder)?;
    create(file, &text).inspect_err(|_| remove(&made))?;
    print(&format!("{}\n", file.display()))?;
    let bank = schema.map_or(folder.to_path_buf(), |(_, bank)| bank);
    say(&format!(
        "next: `carom preview {} --watch`, and when it is as you want it `carom check {}`",
        typed(file),
        typed(&bank)
    ));
    if arguments.like.is_none() {
        say(
            "for a wall, a direct impact or a range of values begin with a copy, as `--like walls/turned-through-a-right-angle` \
             makes one; `carom list` names all there are",
        );
    }
    Ok(())
}

/// The starting question with the schema that stands at this path from it.
pub fn start_without_example(schema: &str) -> String {
    format!("#:schema {schema}\n{STARTING}")
}

/// A path as it is typed on a command line.
pub fn typed(path: &Path) -> String {
    let shown = path.display().to_string();
    let plain = |c: char| c.is_alphanumeric() || "-_./\\:~+".contains(c);
    if shown.chars().all(plain) { shown } else { format!("\"{shown}\"") }
}

/// The name of the file becomes the name of the question, which is typed and printed.
fn well_named(file: &Path) -> Result<(), Failure> {
    let shown = file.display();
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    if name.is_empty() || file.is_dir() {
        let help = format!("name a file in it: `carom new-question {}`", typed(&file.join("my-question.toml")));
        return Err(Failure::with_help(format!("`{shown}` is a folder, and a question is a file"), help));
    }
    let stem = name.strip_suffix(".toml").unwrap_or(&name);
    let allowed = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
    let mended: String = stem.chars().map(|c| if allowed(c) { c } else { '-' }).collect();
    let mended = format!("{}.toml", mended.trim_matches('-'));
    let mended = file.with_file_name(if mended == ".toml" { "my-question.toml".to_owned() } else { mended });
    let problem = if stem.is_empty() || !stem.chars().all(allowed) {
        "the name of a question has letters, digits, `-` and `_`, since it is typed and printed"
    } else if !name.ends_with(".toml") {
        "a question is a file that ends in `.toml`"
    } else {
        return Ok(());
    };
    Err(Failure::with_help(format!("`{shown}`: {problem}"), format!("`carom new-question {}`", typed(&mended))))
}

/// The nearest folder above a file that is there: those between are topics of a bank, and are made.
fn standing(folder: &Path) -> Result<&Path, Failure> {
    let here = Path::new(".");
    let above = || folder.ancestors().filter(|above| !above.as_os_str().is_empty());
    let there = above().find(|above| above.exists()).unwrap_or(here);
    if !there.is_dir() {
        let help = format!("name a folder: `carom new-question {}`", typed(&there.with_file_name("my-question.toml")));
        return Err(Failure::with_help(format!("`{}` is a file and no folder", there.display()), help));
    }
    match above().last() {
        // Not even the bank is there.
        Some(bank) if there == here && bank != here && schema_above(here).is_none() => {
            let help = format!("`carom new-bank {}` starts a bank", typed(bank));
            Err(Failure::with_help(format!("there is no folder `{}`", folder.display()), help))
        }
        _ => Ok(there),
    }
}

/// The bank in which a folder is, by the schema that stands in it, and how many folders above.
fn schema_above(folder: &Path) -> Option<(usize, PathBuf)> {
    const DEEPEST: usize = 6;
    let mut bank = folder.to_path_buf();
    for steps in 0..DEEPEST {
        if bank.join(SCHEMA_FILE).is_file() {
            return Some((steps, bank));
        }
        bank = match bank.parent() {
            Some(above) if !above.as_os_str().is_empty() => above.to_path_buf(),
            _ => return None,
        };
    }
    None
}

/// The file of a shipped question.
fn shipped(name: &str) -> Result<String, Failure> {
    let contents = Contents::shipped();
    Ok(bank::find(&contents, name)?.source.text.to_string())
}

/// Writes a file where there is none, whole or not at all.
fn create(file: &Path, text: &str) -> Result<(), Failure> {
    let shown = file.display();
    let opened = OpenOptions::new().write(true).create_new(true).open(file);
    let mut opened = opened.map_err(|error| match error.kind() {
        io::ErrorKind::AlreadyExists => Failure::with_help(
            format!("`{shown}` is there already, and is left as it is"),
            format!("choose another name, or look at it: `carom preview {}`", typed(file)),
        ),
        _ => unwritten(file, &error),
    })?;
    opened.write_all(text.as_bytes()).map_err(|error| {
        // Half a file is worse than none.
        let _ = fs::remove_file(file);
        unwritten(file, &error)
    })
}
