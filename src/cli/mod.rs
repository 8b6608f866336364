//! The command line: the only rooms that read arguments, touch the disk or print.
//!
//! Data goes to stdout and talk to stderr; the exit code is 0 if all is well, 1 if the input is wrong, 2 if the
//! arguments are. One file a command.

mod bank;
mod by_method;
mod check;
mod compare;
mod compare_stream;
mod completions;
mod explain;
mod failure;
mod formats;
mod json_places;
mod json_scene;
mod list;
mod manual;
mod mark;
mod new_bank;
mod new_question;
mod output;
mod pdf;
mod preview;
mod scene_input;
mod schema;
mod sheet;
mod solve;
mod study;
mod template_folder;
mod text_file;
mod write;

use std::env;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::{ColorChoice, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};

use failure::Failure;
pub use template_folder::read_templates;

const LONG: &str = "Carom makes exercises on collisions in two dimensions: question sheets with fresh numbers, worked \
solutions and mark schemes. Every model answer is exact.";

const AFTER: &str = "Begin with:
  carom sheet                    six questions with their mark scheme, in the folder `sheet`
  carom list                     the questions there are
  carom explain 5C-2             what one of them varies, asks and marks
  carom mark sheet/key.json sheet/submissions.csv     what students have filled in, marked
  carom new-bank my-bank         questions of your own, begun with one that works
`carom sheet --help` shows examples of that command, and so for each.";

/// The arguments of carom.
#[derive(Parser)]
#[command(name = "carom", version, about = "Exercises on oblique collisions, with exact answers", long_about = LONG)]
#[command(after_help = AFTER, disable_help_subcommand = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Colours in messages; `auto` has them on a terminal, unless the variable NO_COLOR is set
    #[arg(long, value_name = "WHEN", global = true, default_value = "auto", alias = "colour", hide_short_help = true)]
    #[arg(display_order = 1000)]
    color: Colour,
}

/// When messages are coloured.
#[derive(Clone, Copy, Debug, ValueEnum)]
#[value(rename_all = "lower")]
enum Colour {
    Auto,
    Always,
    Never,
}

#[derive(Subcommand)]
enum Command {
    Sheet(Box<sheet::SheetArguments>),
    Solve(solve::SolveArguments),
    List(list::ListArguments),
    Explain(explain::ExplainArguments),
    Preview(Box<preview::PreviewArguments>),
    Check(check::CheckArguments),
    NewBank(new_bank::NewBankArguments),
    NewQuestion(new_question::NewQuestionArguments),
    Compare(Box<compare::CompareArguments>),
    Mark(Box<mark::MarkArguments>),
    Study(study::StudyArguments),
    Schema(schema::SchemaArguments),
    Completions(completions::CompletionsArguments),
    #[command(name = "man")]
    Manual(manual::ManualArguments),
}

/// The arguments as they were typed; `help sheet`, as other programs have it, is `sheet --help`.
fn typed() -> Vec<OsString> {
    let mut typed: Vec<OsString> = env::args_os().collect();
    if typed.get(1).is_some_and(|first| first == "help") {
        typed.remove(1);
        typed.push("--help".into());
    }
    typed
}

/// The colours that are asked for, which hold for faults in the arguments and for help too.
fn colour_of(typed: &[OsString]) -> ColorChoice {
    let said: Vec<&str> =
        typed.iter().skip(1).map_while(|word| word.to_str()).take_while(|word| *word != "--").collect();
    let when = |at: usize| match said[at].split_once('=') {
        Some(("--color" | "--colour", when)) => Some(when),
        None if matches!(said[at], "--color" | "--colour") => said.get(at + 1).copied(),
        _ => None,
    };
    match (0..said.len()).find_map(when) {
        Some("never") => ColorChoice::Never,
        Some("always") => ColorChoice::Always,
        _ => ColorChoice::Auto,
    }
}

/// Runs the command that the arguments name and reports what went wrong.
pub fn run() -> ExitCode {
    // Faults in arguments, and requests for help, are clap's: it prints them and exits with 2 or 0.
    let typed = typed();
    let command = Arguments::command().color(colour_of(&typed));
    let read = command.try_get_matches_from(typed).and_then(|matches| Arguments::from_arg_matches(&matches));
    let arguments = match read {
        Ok(arguments) => arguments,
        Err(error) => {
            let code = if error.use_stderr() { 2 } else { 0 };
            let printed = error.print().and_then(|()| io::stdout().flush());
            return ended(printed.map_err(Failure::from), ExitCode::from(code));
        }
    };
    match arguments.color {
        // What `console` finds out of the terminal and of NO_COLOR.
        Colour::Auto => {}
        decided => {
            console::set_colors_enabled(matches!(decided, Colour::Always));
            console::set_colors_enabled_stderr(matches!(decided, Colour::Always));
        }
    }
    let outcome = match arguments.command {
        Command::Sheet(arguments) => sheet::run(&arguments),
        Command::Solve(arguments) => solve::run(&arguments),
        Command::List(arguments) => list::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Preview(arguments) => preview::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::NewBank(arguments) => new_bank::run(&arguments),
        Command::NewQuestion(arguments) => new_question::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Mark(arguments) => mark::run(&arguments),
        Command::Study(arguments) => study::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::Completions(arguments) => completions::run(&arguments),
        Command::Manual(arguments) => manual::run(&arguments),
    };
    ended(outcome, ExitCode::SUCCESS)
}

/// What is left to say, and the exit code: this one where all is well. A reader that has gone away needs nothing more.
fn ended(outcome: Result<(), Failure>, code: ExitCode) -> ExitCode {
    match outcome {
        Ok(()) | Err(Failure::ReaderGone) => code,
        Err(failure) => {
            failure.print();
            ExitCode::from(1)
        }
    }
}
