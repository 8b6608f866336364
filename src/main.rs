//! Parses arguments, runs a command, prints the error, chooses the exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    carom::cli::run()
}
