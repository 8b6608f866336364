//! `carom new-bank`: a folder for questions of one's own, with one in it that works.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;

use super::failure::Failure;
use super::new_question::{SCHEMA_FILE, start_without_example, typed};
use super::output::{print, say};
use super::schema;
use super::write::{OutputFile, write_all};

const AFTER: &str = "Examples:
  carom new-bank my-bank
  carom new-bank my-bank && carom check my-bank && carom sheet --bank my-bank";

/// Start a bank of your own: a folder with a question that works, to be changed
///
/// Writes a commented question, which `carom check` finds sound at once, and a schema, by which editors such as VS Code
/// with 'Even Better TOML' complete keys and underline mistakes while you type. A folder with things in it is left alone.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct NewBankArguments {
    /// The folder to make
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Where the first question of a new bank stands in it.
const FIRST: &str = "b-at-rest/speeds.toml";

/// Makes the folder.
pub fn run(arguments: &NewBankArguments) -> Result<(), Failure> {
    let folder = arguments.folder.as_path();
    free(folder)?;
    let question = start_without_example(&format!("../{SCHEMA_FILE}"));
    let file = |name: &str, text: String| OutputFile { name: name.to_owned(), contents: text.into_bytes() };
    let files = [file(FIRST, question), file(SCHEMA_FILE, schema::of_questions())];
    let written = write_all(folder, &files)?;
    let paths: String = written.iter().map(|path| format!("{}\n", path.display())).collect();
    print(&paths)?;
    let (bank, first) = (typed(folder), typed(&folder.join(FIRST)));
    say(&format!("next: `carom check {bank}`, then `carom sheet --bank {bank}`"));
    say(&format!("to change the question, open `{first}` in an editor, and beside it `carom preview {first} --watch`"));
    Ok(())
}

/// Can the bank be made there? Only if nothing is there that could be lost.
fn free(folder: &Path) -> Result<(), Failure> {
    let shown = folder.display();
    if folder.is_file() {
        let help = format!("choose another name: `carom new-bank {}`", typed(&folder.with_extension("bank")));
        return Err(Failure::with_help(format!("`{shown}` is a file, and a bank is a folder"), help));
    }
    match fs::read_dir(folder).map(|mut things| things.next().is_none()) {
        Ok(true) => Ok(()),
        Ok(false) => {
            let question = typed(&folder.join("my-question.toml"));
            let help = format!("choose another name, or add a question to it: `carom new-question {question}`");
            Err(Failure::with_help(format!("there are things in the folder `{shown}` already"), help))
        }
        Err(_) => {
            let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty());
            match parent.filter(|parent| !parent.is_dir()) {
                None => Ok(()),
                Some(parent) if parent.exists() => Err(Failure::with_help(
                    format!("`{}` is a file, and `{shown}` cannot be made in it", parent.display()),
                    "choose another folder for it",
                )),
                Some(parent) => Err(Failure::with_help(
                    format!("there is no folder `{}` in which to make `{shown}`", parent.display()),
                    format!("make it first: `mkdir {}`", typed(parent)),
                )),
            }
        }
    }
}
