//! Parses arguments, runs a command, prints the error, chooses the exit code.

use std::process::ExitCode;

/// Exact numbers live on the heap: a sixth of the time of `carom check` went into the C library's allocator.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    carom::cli::run()
}
