//! `carom man`: the pages of the manual, made from the very declarations that read the arguments.

use std::path::PathBuf;

use clap::{Args, Command, CommandFactory};
use clap_mangen::Man;

use super::failure::Failure;
use super::output::{print, say};
use super::write::{OutputFile, write_all};

const AFTER: &str = "Examples:
  carom man                            pages in the folder `man`, such as `man/carom-sheet.1`
  carom man --out ~/.local/share/man/man1    where `man carom` finds them";

/// Write the pages of the manual: one for carom and one for each command
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct ManualArguments {
    /// The folder for the pages
    #[arg(long, value_name = "DIR", default_value = "man")]
    out: PathBuf,
}

/// Writes the pages.
pub fn run(arguments: &ManualArguments) -> Result<(), Failure> {
    let pages = pages(super::Arguments::command())?;
    let written = write_all(&arguments.out, &pages)?;
    let paths: String = written.iter().map(|path| format!("{}\n", path.display())).collect();
    print(&paths)?;
    if let Some(first) = written.first() {
        say(&format!("read them: `man {}`", super::new_question::typed(first)));
    }
    Ok(())
}

fn pages(mut carom: Command) -> Result<Vec<OutputFile>, Failure> {
    carom.build();
    let commands = std::iter::once(&carom).chain(carom.get_subcommands());
    let page = |command: &Command| {
        let man = Man::new(command.clone()).manual("Carom");
        let mut contents = Vec::new();
        man.render(&mut contents)?;
        // What a command says after its help are examples, which clap_mangen calls extra.
        let contents =
            String::from_utf8_lossy(&contents).replace(".SH EXTRA\nExamples:\n", ".SH EXAMPLES\n").into_bytes();
        Ok(OutputFile { name: man.get_filename(), contents })
    };
    commands.map(page).collect()
}
