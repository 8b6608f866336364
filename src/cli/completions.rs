//! `carom completions`: what a shell needs to complete commands and options.

use clap::{Args, CommandFactory, ValueEnum};
use clap_complete::Shell;

use super::failure::Failure;
use super::output::print;

const AFTER: &str = "Examples:
  carom completions bash > ~/.local/share/bash-completion/completions/carom
  carom completions zsh > ~/.zfunc/_carom
  carom completions fish > ~/.config/fish/completions/carom.fish
  carom completions powershell >> $PROFILE

Open a new window of the terminal afterwards, type `carom sh` and press the Tab key.";

/// Print what your shell needs to complete commands and options by the Tab key
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: ShellName,
}

/// The shells.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum ShellName {
    /// The usual one of Linux
    Bash,
    /// The usual one of macOS
    Zsh,
    /// fish
    Fish,
    /// The usual one of Windows
    Powershell,
}

/// Prints the completions.
pub fn run(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let shell = match arguments.shell {
        ShellName::Bash => Shell::Bash,
        ShellName::Zsh => Shell::Zsh,
        ShellName::Fish => Shell::Fish,
        ShellName::Powershell => Shell::PowerShell,
    };
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut super::Arguments::command(), "carom", &mut script);
    print(&String::from_utf8_lossy(&script))
}
